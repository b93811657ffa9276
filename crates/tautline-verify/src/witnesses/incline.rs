//! `Incline`: a metric on the line that grows linearly along `[0, 1]`.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

/// `H = c + s x` on `[0, 1]`, smooth: the left-endpoint rule reads it where it is farthest from
/// its mean, so that Propositions 8.1 and 8.2 lose nothing on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incline {
    foot: f64,
    slope: f64,
    constants: Constants,
}

impl Incline {
    /// Returns the incline with `H(0) = foot` and `H′ = slope`, in `m²/ℓ²` and `m²/ℓ³`; `None`
    /// unless it is positive on `[0, 1]`.
    #[must_use]
    pub fn new(foot: f64, slope: f64) -> Option<Self> {
        let top = foot + slope;
        let constants = Constants::new(foot.min(top), foot.max(top), slope.abs()).ok()?;
        Some(Self { foot, slope, constants })
    }
}

impl Metric<1> for Incline {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element(x[0] * self.slope + self.foot)
    }
}

impl Bounded<1> for Incline {
    /// Those on `[0, 1]`: `H` between its ends, `L_H = |slope|`.
    fn constants(&self) -> Constants {
        self.constants
    }
}
