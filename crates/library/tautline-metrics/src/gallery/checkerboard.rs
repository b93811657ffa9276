//! A smoothed checkerboard: `H(x) = (1 + a sin²(πx₁/e) sin²(πx₂/e)) I`.

use std::f64::consts::PI;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{nonnegative, positive},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = φ I` with `φ = 1 + a sin²(πx₁/e) sin²(πx₂/e)`, in the plane: cells of side `e` with
/// expensive centres and cheap lanes between them.
///
/// This is a composite material for homogenisation: as `e → 0` its distances converge, while `L_H`,
/// and with it every bound on a discretization error, grows without limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checkerboard {
    height: f64,
    cell: f64,
    constants: Constants,
}

impl Checkerboard {
    /// Returns the checkerboard of height `a ≥ 0` in `m²/ℓ²` with cells of side `e > 0` in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(height: f64, cell: f64) -> Result<Self, GalleryError> {
        let (a, k) = (nonnegative("height", height)?, PI / positive("cell", cell)?);
        // With X = kx₁, Y = kx₂, p = −cos 2X and q = −cos 2Y,
        // |∇φ|² = a²k² · 4 sin² X sin² Y (cos² X sin² Y + sin² X cos² Y)
        //       = a²k² · ½ (1 + p)(1 + q)(1 − pq) ≤ a²k² (1 + pq)(1 − pq) ≤ a²k²
        // since p + q ≤ 1 + pq. The bound is attained at p = 0, q = 1.
        let l_h = a * k;
        // φ = 1 + a/4 (1 − cos 2X − cos 2Y + ½ cos 2(X + Y) + ½ cos 2(X − Y)), so D²φ[w, w] is at
        // most ak² (w₁² + w₂² + ½ (w₁ + w₂)² + ½ (w₁ − w₂)²) = 2ak² |w|². This is attained at the
        // centres.
        let constants = Constants::new(1.0, 1.0 + a, l_h)?.with_m_h(2.0 * a * k * k)?.isotropic();
        Ok(Self { height, cell, constants })
    }
}

impl Metric<2> for Checkerboard {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let k = PI / self.cell;
        let product = (x[0] * k).sin() * (x[1] * k).sin();
        SMatrix::from_diagonal_element(product.sqr() * self.height + 1.0)
    }
}

impl Bounded<2> for Checkerboard {
    /// All constants are attained: `c₁ = 1` on the grid lines, `c₂ = 1 + a` and `M_H = 2aπ²/e²` at
    /// the centres of the cells, and `L_H = aπ/e` half-way from a centre to a grid line.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<2> for Checkerboard {
    /// Returns `|x − y|` for two points on one grid line, `{x₁ = ne}` or `{x₂ = ne}`, since `H = I`
    /// there and `H ≥ I` elsewhere. Returns `None` for other pairs.
    fn distance(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> Option<f64> {
        // The line is known up to the rounding of n e. This is enough, since d is √c₂-Lipschitz.
        let on_line = |i: usize| {
            let line = (x[i] / self.cell).round() * self.cell;
            let on = |u: f64| (u - line).abs() <= 2.0 * f64::EPSILON * line.abs();
            on(x[i]) && on(y[i])
        };
        (x == y || on_line(0) || on_line(1)).then(|| (x - y).norm())
    }
}
