//! `Tent`: a metric on the line with a straight-sided valley or ridge at the middle of `[0, 1]`.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

/// `H = c + s |x − ½|` on `[0, 1]`: a valley for `s > 0`, a ridge for `s < 0`.
///
/// Not differentiable at `½`, so it is for reading values, not derivatives; the limit of smooth
/// metrics with the same `L_H = |s|`. Between `0` and `1` the trapezoidal rule reads it at its tip:
/// all that Proposition 7.9 gives away for an arbitrary metric is lost on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tent {
    tip: f64,
    slope: f64,
    constants: Constants,
}

impl Tent {
    /// Returns the tent with `H(½) = tip` and the slopes `∓slope`, in `m²/ℓ²` and `m²/ℓ³`; `None`
    /// unless it is positive on `[0, 1]`.
    #[must_use]
    pub fn new(tip: f64, slope: f64) -> Option<Self> {
        let foot = tip + 0.5 * slope;
        let constants = Constants::new(tip.min(foot), tip.max(foot), slope.abs()).ok()?;
        Some(Self { tip, slope, constants })
    }
}

impl Metric<1> for Tent {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        // √((x − ½)²) is the modulus, to the last bit.
        SMatrix::from_diagonal_element((x[0] - 0.5).sqr().sqrt() * self.slope + self.tip)
    }
}

impl Bounded<1> for Tent {
    /// Those on `[0, 1]`: `H` between its tip and its feet, `L_H = |slope|`.
    fn constants(&self) -> Constants {
        self.constants
    }
}
