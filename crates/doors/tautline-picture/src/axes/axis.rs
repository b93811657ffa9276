//! An axis: its scale, its range, an optional break, and its label.

use super::{scale::Scale, stretch::Stretch};
use crate::error::DrawingError;

/// One axis of a panel.
///
/// Invariant: there is one stretch, or there are two with a gap between them. Each is finite and
/// increasing, and positive on a logarithmic scale. Names are at `1, 2, …` on one linear stretch.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Axis {
    /// The stretches, the lowest first.
    pub(crate) stretches: Vec<Stretch>,
    /// The names along the axis; empty if it has numbers.
    pub(crate) names: Vec<String>,
    /// The label; empty if there is none.
    pub(crate) label: String,
    /// Whether ticks carry numbers.
    pub(crate) numbered: bool,
}

impl Axis {
    /// Returns an axis from `from` to `to`.
    ///
    /// # Errors
    ///
    /// If the range is not finite and increasing, or not positive on a logarithmic scale.
    pub fn new(scale: Scale, from: f64, to: f64) -> Result<Axis, DrawingError> {
        let stretches = vec![Stretch::new(scale, from, to)?];
        Ok(Axis { stretches, names: Vec::new(), label: String::new(), numbered: true })
    }

    /// Returns an axis with names in place of numbers. The first name is at 1, the next at 2, and
    /// so on; the axis runs from ½ to half a unit beyond the last. The syntax of a name is that of
    /// [`typeset`](crate::math_text::typeset).
    ///
    /// # Errors
    ///
    /// If there are no names.
    pub fn of_names(
        names: impl IntoIterator<Item = impl Into<String>>,
    ) -> Result<Axis, DrawingError> {
        let names: Vec<String> = names.into_iter().map(Into::into).collect();
        let axis = Axis::new(Scale::Linear, 0.5, names.len() as f64 + 0.5)?;
        Ok(Axis { names, ..axis })
    }

    /// Returns a logarithmic axis that spans whole decades and covers all positive finite values.
    ///
    /// If the widest gap between two values exceeds `break_over` decades, the axis omits the gap;
    /// with `f64::INFINITY` it never breaks. Zero and negative values cannot be shown and are
    /// skipped.
    ///
    /// # Errors
    ///
    /// If no value is positive and finite.
    pub fn decades_covering(
        values: impl IntoIterator<Item = f64>,
        break_over: f64,
    ) -> Result<Axis, DrawingError> {
        let mut exponents: Vec<f64> =
            values.into_iter().map(f64::log10).filter(|e| e.is_finite()).collect();
        exponents.sort_by(f64::total_cmp);
        let (Some(low), Some(high)) = (exponents.first(), exponents.last()) else {
            let want = "no positive value was given";
            return Err(DrawingError::BadRange { from: f64::NAN, to: f64::NAN, want });
        };
        // The margin is a billionth of a decade, since log10 of a power of ten may miss the whole
        // number.
        let floor = |e: f64| (e + 1e-9).floor();
        let ceil = |e: f64| (e - 1e-9).ceil();
        let (from, to) = (floor(*low), ceil(*high).max(floor(*low) + 1.0));
        let axis = Axis::new(Scale::Decades, power(from), power(to))?;
        let widest = exponents.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        match widest {
            Some(gap) if gap[1] - gap[0] > break_over => {
                // A stretch needs some length, even if all its values are the same power of ten.
                let below = ceil(gap[0]).max(from + 1.0);
                let above = floor(gap[1]).min(to - 1.0);
                axis.broken(power(below), power(above))
            }
            _ => Ok(axis),
        }
    }

    /// Omits the part between `below` and `above`.
    ///
    /// Both stretches keep the same scale, so that slopes can be compared across the break.
    ///
    /// # Errors
    ///
    /// Unless `from < below < above < to`.
    pub fn broken(mut self, below: f64, above: f64) -> Result<Axis, DrawingError> {
        let (scale, from, to) = (self.scale(), self.from(), self.to());
        if !(below < above) {
            let want = "a break must leave something out";
            return Err(DrawingError::BadRange { from: below, to: above, want });
        }
        self.stretches = vec![Stretch::new(scale, from, below)?, Stretch::new(scale, above, to)?];
        Ok(self)
    }

    /// Sets the label, in the syntax of [`typeset`](crate::math_text::typeset).
    pub fn labelled(mut self, label: impl Into<String>) -> Axis {
        self.label = label.into();
        self
    }

    /// Omits the numbers, for a panel that shares them with its neighbour.
    pub fn unnumbered(mut self) -> Axis {
        self.numbered = false;
        self
    }

    /// Sets the label if the panel carries it. Otherwise omits the numbers, since a neighbouring
    /// panel carries both.
    pub fn labelled_if(self, carries: bool, label: &str) -> Axis {
        if carries { self.labelled(label) } else { self.unnumbered() }
    }

    pub(crate) fn scale(&self) -> Scale {
        self.stretches[0].scale
    }

    pub(crate) fn from(&self) -> f64 {
        self.stretches[0].from
    }

    pub(crate) fn to(&self) -> f64 {
        self.stretches[self.stretches.len() - 1].to
    }
}

/// Returns ten to a whole power, using `powi`, since `powf` may miss powers of ten on some
/// machines.
fn power(exponent: f64) -> f64 {
    10.0_f64.powi(exponent as i32)
}

#[cfg(test)]
mod tests {
    use super::{Axis, Scale};

    #[test]
    fn ranges_without_meaning_are_refused() {
        for (scale, from, to) in [
            (Scale::Linear, 1.0, 1.0),
            (Scale::Linear, 2.0, 1.0),
            (Scale::Linear, f64::NAN, 1.0),
            (Scale::Linear, 0.0, f64::INFINITY),
            (Scale::Decades, 0.0, 1.0),
            (Scale::Octaves, -1.0, 1.0),
        ] {
            assert!(Axis::new(scale, from, to).is_err(), "{scale:?} {from} {to}");
        }
        assert!(Axis::decades_covering([0.0, -1.0], 6.0).is_err());
        let axis = Axis::new(Scale::Decades, 1.0, 1e6).expect("a range");
        assert!(axis.clone().broken(1e4, 1e2).is_err() && axis.broken(1e2, 1e4).is_ok());
    }

    #[test]
    fn names_have_a_unit_each() {
        let axis = Axis::of_names(["first", "second"]).expect("two names");
        assert_eq!((axis.from(), axis.to(), axis.names.len()), (0.5, 2.5, 2));
        assert!(Axis::of_names(Vec::<String>::new()).is_err());
    }

    #[test]
    fn whole_decades_cover_the_values() {
        let axis = Axis::decades_covering([3e-5, 0.0, 2.0], f64::INFINITY).expect("positive");
        assert_eq!((axis.from(), axis.to()), (1e-5, 10.0));
        assert_eq!(axis.stretches.len(), 1);
    }

    #[test]
    fn a_wide_gap_breaks_the_axis() {
        let values = [2e-8, 3e-3, 4e12, 5e14];
        let axis = Axis::decades_covering(values, 6.0).expect("positive");
        let ends: Vec<_> = axis.stretches.iter().map(|s| (s.from, s.to)).collect();
        assert_eq!(ends, [(1e-8, 1e-2), (1e12, 1e15)]);
    }
}
