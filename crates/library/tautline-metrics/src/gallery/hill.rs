//! A Gaussian hill: the graph of `f(x) = h e^{−|x|²/2s²}`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{finite, squarable},
    radial::{along_ray, gaussian},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = I + ∇f ∇fᵀ` with `f = h e^{−|x|²/2s²}`, in any dimension. This is the metric of the
/// graph of `f` in `R^{D+1}`.
///
/// Minimal geodesics go around a high hill and over a low one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hill {
    height: f64,
    width: f64,
    constants: Constants,
}

impl Hill {
    /// Returns the hill of height `h` (a hollow if it is negative) and width `s > 0`, both in `ℓ`,
    /// the unit of the coordinates, which is the same as `m` here.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(height: f64, width: f64) -> Result<Self, GalleryError> {
        let (h, s) = (finite("height", height)?, squarable("width", width)?);
        let steepness = (h / s).powi(2);
        let l_h = 2.0 * steepness / s * lipschitz();
        // With h = s = 1, y = |x|², E = e^y and a = c² for the radial part c of a unit vector w,
        // ½ E D²H[w, w] acts on the radial and the tangential direction of w as [[A, B], [B, C]]
        // with
        //     A = (2y² − 4y + 1) a − y,    B² = (1 − 2y)² a (1 − a),    C = 1 − a.
        // At the centre its norm is 1. It never exceeds E: since C ≤ 1 ≤ E, this means
        //     (E − A)(E − C) − B² = 2y² a² + (1 − 2y + (4 − 2y) E) y a + (E + y)(E − 1) ≥ 0,
        //     (E + A)(E + C) − B² = 2y² a² + (1 − 2y − (4 − 2y) E) y a + (E − y)(E + 1) ≥ 0.
        // With 2a − 1 ≤ a² in place of a² both become linear in a, and they are positive at either
        // end. At a = 1 they are E (E ∓ (2y² − 5y + 1)), where E ≥ 1 + y + y²/2 + y³/6 leaves
        // y (6 − 3y/2 + y²/6) and E ≥ 1 + y + y²/2 leaves 2 − 4y + 5y²/2, neither of which has a
        // positive root. At a = 0 they are at least (1 + 2y) y − 2y² and (1 + y²/2)(2 + y) − 2y².
        let m_h = 2.0 * steepness / s / s;
        let c2 = 1.0 + steepness * (-1.0_f64).exp();
        let constants = Constants::new(1.0, c2, l_h)?.with_m_h(m_h)?;
        Ok(Self { height, width, constants })
    }
}

/// Returns `√y (1 − y) e^{−y}` at `y = (5 − √17)/4`, which is `L_H` for `2 h²/s³ = 1`.
fn lipschitz() -> f64 {
    // Let p = |∇f|, and let m and t be the absolute values of the second derivatives of f along the
    // ray and across it. DH[w] = q ∇fᵀ + ∇f qᵀ with q = D²f w. For the radial part c of a unit
    // vector w, its norm |q·∇f| + |q||∇f| is p (m c + √(t² + (m² − t²) c²)). If t² ≤ 2m², this is
    // largest over 0 ≤ c ≤ 1 at c = 1, with the value 2pm; otherwise it is largest inside, with
    // p t²/√(t² − m²).
    //
    // With y = (r/s)²: p = (h/s) √y e^{−y/2}, t = (h/s²) e^{−y/2}, m = t |1 − y|. Hence the second
    // case is |y − 1| < 1/√2, with the value (h²/s³) e^{−y}/√(2 − y). It falls to its least value
    // at y = 3/2 and then grows, so it is below its value at one of the ends of that interval,
    // where both cases agree. The value of the first case, (2h²/s³) √y |1 − y| e^{−y}, is
    // stationary where 2y² − 5y + 1 = 0; the smaller root gives 0.2936…, the larger 0.1977….
    let y = 0.25 * (5.0 - 17_f64.sqrt());
    y.sqrt() * (1.0 - y) * (-y).exp()
}

impl<const D: usize> Metric<D> for Hill {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        // ∇f = −(f/s²) x.
        let weight = (gaussian(x, self.width) * (self.height / self.width / self.width)).sqr();
        let scaled = x.map(|xi| xi * weight);
        let mut h = SMatrix::<S, D, D>::identity();
        for j in 0..D {
            for i in 0..=j {
                h[(i, j)] += scaled[i] * x[j];
            }
        }
        h.fill_lower_triangle_with_upper_triangle();
        h
    }
}

impl<const D: usize> Bounded<D> for Hill {
    /// All constants are attained: `c₁ = 1`, `c₂ = 1 + (h/s)²/e` at `|x| = s`,
    /// `L_H = (2h²/s³) √y (1 − y) e^{−y}` at `y = |x|²/s² = (5 − √17)/4`, and `M_H = 2h²/s⁴` at the
    /// centre.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<const D: usize> KnownDistance<D> for Hill {
    /// Returns the length `∫ √(1 + f′²)` of the profile for two points on one ray from the centre,
    /// and `None` for other pairs.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let speed = |r: f64| {
            let rho = r / self.width;
            (self.height / self.width * rho * (-0.5 * rho * rho).exp()).hypot(1.0)
        };
        along_ray(x, y, self.width, speed)
    }
}
