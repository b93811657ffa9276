//! A right triangle that shows a power law in a log–log panel.

/// A slope triangle. The numbers at its legs show the slope as a ratio.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct SlopeTriangle {
    pub(crate) slope: f64,
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) y: f64,
    pub(crate) above: bool,
}

impl SlopeTriangle {
    /// Returns a triangle for `y ∝ x^slope` whose hypotenuse starts at `(from, y)` and ends at
    /// `to`. Its right angle lies below the hypotenuse, so that it fits below a curve.
    ///
    /// # Panics
    ///
    /// Unless `0 < from < to`, `y > 0` and the slope is finite and not zero.
    pub fn below(slope: f64, from: f64, to: f64, y: f64) -> SlopeTriangle {
        assert!(0.0 < from && from < to && to.is_finite(), "no power law from {from} to {to}");
        assert!(y > 0.0 && y.is_finite(), "no power law through {y}");
        assert!(slope.is_finite() && slope != 0.0, "no triangle has the slope {slope}");
        SlopeTriangle { slope, from, to, y, above: false }
    }

    /// Returns the same triangle with its right angle above the hypotenuse, so that it fits above a
    /// curve.
    ///
    /// # Panics
    ///
    /// The same as [`below`](SlopeTriangle::below).
    pub fn above(slope: f64, from: f64, to: f64, y: f64) -> SlopeTriangle {
        SlopeTriangle { above: true, ..SlopeTriangle::below(slope, from, to, y) }
    }

    /// Returns the start of the hypotenuse, its end, and the corner with the right angle.
    pub(crate) fn corners(&self) -> [(f64, f64); 3] {
        let end = self.y * (self.to / self.from).powf(self.slope);
        let falls = self.slope < 0.0;
        // If the right angle is below, it is at the start of a falling line and at the end of a
        // rising one.
        let corner = if falls != self.above { (self.from, end) } else { (self.to, self.y) };
        [(self.from, self.y), (self.to, end), corner]
    }

    /// Returns the numbers on the horizontal and on the vertical leg.
    pub(crate) fn numbers(&self) -> (String, String) {
        let rise = self.slope.abs();
        if rise.fract() == 0.0 {
            ("1".to_owned(), format!("{rise}"))
        } else if (2.0 * rise).fract() == 0.0 {
            // Legs of 2 and 1 are used instead of 1 and 1/2.
            ("2".to_owned(), format!("{}", 2.0 * rise))
        } else {
            ("1".to_owned(), format!("{rise:.2}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::SlopeTriangle;

    #[test]
    fn the_right_angle_lies_on_the_asked_side() {
        let below = SlopeTriangle::below(-2.0, 10.0, 100.0, 1.0);
        let [_, end, corner] = below.corners();
        assert!((end.1 - 0.01).abs() < 1e-15);
        assert_eq!(corner, (10.0, end.1));
        assert_eq!(SlopeTriangle::above(-2.0, 10.0, 100.0, 1.0).corners()[2], (100.0, 1.0));
        assert_eq!(SlopeTriangle::below(1.0, 10.0, 100.0, 1.0).corners()[2], (100.0, 1.0));
    }

    #[test]
    fn half_orders_have_whole_legs() {
        let numbers = |slope| SlopeTriangle::below(slope, 1.0, 2.0, 1.0).numbers();
        assert_eq!(numbers(-2.0), ("1".to_owned(), "2".to_owned()));
        assert_eq!(numbers(-0.5), ("2".to_owned(), "1".to_owned()));
        assert_eq!(numbers(-1.5), ("2".to_owned(), "3".to_owned()));
    }
}
