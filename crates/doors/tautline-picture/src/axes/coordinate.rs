//! Makes a stretch a coordinate of plotters.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged};

use super::{
    stretch::Stretch,
    tick_values::{TickValues, candidates},
};

impl Ranged for Stretch {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        self.place_in_units(*value, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let labelled = |set: TickValues| -> Vec<f64> {
            set.iter().filter(|(_, label)| label.is_some()).map(|(value, _)| *value).collect()
        };
        let sets = candidates(self).into_iter().map(labelled);
        sets.into_iter().find(|set| set.len() <= hint.max_num_points()).unwrap_or_default()
    }

    fn range(&self) -> Range<f64> {
        self.from..self.to
    }
}

#[cfg(test)]
mod tests {
    use super::{super::scale::Scale, Ranged, Stretch};

    #[test]
    fn key_points_respect_the_hint() {
        let stretch = Stretch::new(Scale::Decades, 1e-12, 1e2).expect("a range");
        let points = stretch.key_points(6);
        assert!(!points.is_empty() && points.len() <= 6, "{points:?}");
    }
}
