//! An unbroken piece of an axis.

use plotters::coord::{
    combinators::{IntoLogRange, LogCoord},
    ranged1d::Ranged,
    types::RangedCoordf64,
};

use super::scale::Scale;
use crate::{
    error::DrawingError,
    picture::{UNITS, units},
};

/// A range on a scale, which plotters maps to px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stretch {
    pub(crate) scale: Scale,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

impl Stretch {
    /// Checks the range, and reports the first condition that fails.
    pub(crate) fn new(scale: Scale, from: f64, to: f64) -> Result<Stretch, DrawingError> {
        let bad = |want| DrawingError::BadRange { from, to, want };
        if !(from.is_finite() && to.is_finite()) {
            return Err(bad("both ends must be finite"));
        }
        if !(from < to) {
            return Err(bad("the first end must be the smaller one"));
        }
        if scale.is_logarithmic() && !(from > 0.0) {
            return Err(bad("a logarithmic scale needs positive ends"));
        }
        Ok(Stretch { scale, from, to })
    }

    /// Returns the length on the scale: a difference, or a number of decades.
    pub(crate) fn length(&self) -> f64 {
        if self.scale.is_logarithmic() {
            (self.to / self.from).log10()
        } else {
            self.to - self.from
        }
    }

    /// Returns whether the range contains a value, with a margin for rounding at its ends.
    pub(crate) fn holds(&self, value: f64) -> bool {
        let margin = 1e-9 * (self.to - self.from);
        let low =
            if self.scale.is_logarithmic() { self.from * (1.0 - 1e-9) } else { self.from - margin };
        low <= value && value <= self.to + margin
    }

    /// Returns whether the scale can show a value, inside or outside the range.
    pub(crate) fn can_place(&self, value: f64) -> bool {
        value.is_finite() && (value > 0.0 || !self.scale.is_logarithmic())
    }

    /// Returns the place of a value, in px, if the range extends from `start` to `end`.
    pub(crate) fn place(&self, value: f64, (start, end): (f64, f64)) -> f64 {
        f64::from(self.place_in_units(value, (units(start), units(end)))) / UNITS
    }

    /// Does the same in the canvas units of plotters.
    pub(super) fn place_in_units(&self, value: f64, limit: (i32, i32)) -> i32 {
        let place = if self.scale.is_logarithmic() {
            LogCoord::from((self.from..self.to).log_scale()).map(&value, limit)
        } else {
            RangedCoordf64::from(self.from..self.to).map(&value, limit)
        };
        // The limit is ten thousand px outside: plotters adds to places, which must not overflow.
        place.clamp(-1_000_000, 1_000_000)
    }
}

#[cfg(test)]
mod tests {
    use super::{Scale, Stretch};

    #[test]
    fn decades_have_equal_lengths() {
        let stretch = Stretch::new(Scale::Decades, 1e-2, 1e2).expect("a range");
        for (k, value) in [1e-2, 1e-1, 1.0, 10.0, 100.0].into_iter().enumerate() {
            let place = stretch.place(value, (0.0, 400.0));
            assert!((place - 100.0 * k as f64).abs() <= 0.02, "{value} at {place}");
        }
        // A vertical axis runs from the bottom, where y is larger, to the top.
        assert!((stretch.place(10.0, (400.0, 0.0)) - 100.0).abs() <= 0.02);
        assert_eq!(stretch.length(), 4.0);
    }

    #[test]
    fn values_far_outside_do_not_overflow() {
        let stretch = Stretch::new(Scale::Linear, 0.0, 1e-300).expect("a range");
        assert_eq!(stretch.place_in_units(1e300, (0, 1000)), 1000);
        assert_eq!(stretch.place_in_units(1.0, (0, 1000)), 1_000_000);
    }
}
