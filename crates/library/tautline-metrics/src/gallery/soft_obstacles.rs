//! Soft obstacles: `H(x) = (1 + Σ aᵢ e^{−|x − oᵢ|²/2sᵢ²}) I`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{finite, nonnegative, squarable},
    radial::gaussian,
};
use crate::{Bounded, Constants, Metric};

/// One Gaussian of [`SoftObstacles`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obstacle<const D: usize> {
    /// The centre `o`, in `ℓ`.
    pub centre: SVector<f64, D>,
    /// The height `a ≥ 0`, in `m²/ℓ²`.
    pub height: f64,
    /// The width `s > 0`, in `ℓ`.
    pub width: f64,
}

/// `H(x) = φ I` with `φ = 1 + Σᵢ aᵢ e^{−|x − oᵢ|²/2sᵢ²}`: any number of obstacles that are
/// expensive, but not forbidden, to cross. Without obstacles the metric is Euclidean.
#[derive(Clone, Debug, PartialEq)]
pub struct SoftObstacles<const D: usize> {
    obstacles: Vec<Obstacle<D>>,
    constants: Constants,
}

impl<const D: usize> SoftObstacles<D> {
    /// Returns the metric with the given obstacles.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(obstacles: Vec<Obstacle<D>>) -> Result<Self, GalleryError> {
        // The bounds are sums of the exact constants of single lenses, c₂ = 1 + a,
        // L_H = (a/s) e^{−1/2} and M_H = a/s².
        let (mut c2, mut l_h, mut m_h) = (1.0, 0.0, 0.0);
        for obstacle in &obstacles {
            for &coordinate in &obstacle.centre {
                finite("coordinate of a centre", coordinate)?;
            }
            let (a, s) =
                (nonnegative("height", obstacle.height)?, squarable("width", obstacle.width)?);
            c2 += a;
            l_h += a / s * (-0.5_f64).exp();
            m_h += a / s / s;
        }
        let constants = Constants::new(1.0, c2, l_h)?.with_m_h(m_h)?.isotropic();
        Ok(Self { obstacles, constants })
    }
}

impl<const D: usize> Metric<D> for SoftObstacles<D> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let phi = self.obstacles.iter().fold(S::one(), |phi, obstacle| {
            let offset = SVector::<S, D>::from_fn(|i, _| x[i] - obstacle.centre[i]);
            phi + gaussian(&offset, obstacle.width) * obstacle.height
        });
        SMatrix::from_diagonal_element(phi)
    }
}

impl<const D: usize> Bounded<D> for SoftObstacles<D> {
    /// `c₁ = 1` holds in the limit. `c₂ = 1 + Σ aᵢ`, `L_H = Σ (aᵢ/sᵢ) e^{−1/2}` and
    /// `M_H = Σ aᵢ/sᵢ²` are attained for a single obstacle. Otherwise they are upper bounds, which
    /// are looser the farther apart the obstacles are.
    fn constants(&self) -> Constants {
        self.constants
    }
}
