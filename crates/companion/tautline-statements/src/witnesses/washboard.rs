//! `Washboard`: two routes on the line, one even and one corrugated.

use std::f64::consts::{PI, TAU};

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

/// The metric is `1 + η` near `[0, 1]` and `1 + (L/2πN)(1 + cos 2πN(x − 100))` near `[100, 101]`,
/// with `N` valleys at the midpoints of the chords between `100 + n/N`.
///
/// On the second route, the trapezoidal rule with `N` subintervals sees only valleys and therefore
/// prefers this route: `E_tra,N = 1`, but `E(γᵖˡ) = 1 + L/2πN`. The metric is smooth. It differs
/// from one `N` to another, but its constants are the same up to the switch between the routes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Washboard {
    valleys: f64,
    slope: f64,
    lift: f64,
}

impl Washboard {
    /// The steepness `k` of the switch `½ (1 + tanh k(x − 50))` in `1/ℓ`. At the distance 49 from
    /// the middle, the switch is 0 or 1 to the last bit.
    const SWITCH: f64 = 0.42;

    /// Returns the metric with this number of valleys of slope `L`, in `m²/ℓ³`, and the lift `η` of
    /// the even route, in `m²/ℓ²`; `None` unless all are positive.
    #[must_use]
    pub fn new(valleys: u32, slope: f64, lift: f64) -> Option<Self> {
        let valid = valleys > 0 && slope > 0.0 && lift > 0.0 && (slope + lift).is_finite();
        valid.then_some(Self { valleys: f64::from(valleys), slope, lift })
    }

    /// Returns half the height of the corrugation, `L/2πN`, in `m²/ℓ²`. The mean of `H` is larger
    /// by 1.
    #[must_use]
    pub fn half_height(&self) -> f64 {
        self.slope / (TAU * self.valleys)
    }
}

impl Metric<1> for Washboard {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        let second = (((x[0] - 50.0) * Self::SWITCH).tanh() + 1.0) * 0.5;
        let wave = (((x[0] - 100.0) * (TAU * self.valleys)).cos() + 1.0) * self.half_height();
        SMatrix::from_diagonal_element(second * wave + (-second + 1.0) * self.lift + 1.0)
    }
}

impl Bounded<1> for Washboard {
    /// The constants are `c₁ = 1`, `c₂ = 1 + m` and `L_H = L + ½ k m` with `m = max(η, L/πN)`. The
    /// switch adds `½ k m`.
    fn constants(&self) -> Constants {
        let top = self.lift.max(self.slope / (PI * self.valleys));
        Constants::new(1.0, 1.0 + top, self.slope + 0.5 * Self::SWITCH * top).expect("positive")
    }
}
