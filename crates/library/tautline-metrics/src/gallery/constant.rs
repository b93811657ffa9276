//! A constant metric: `H(x) = A`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{GalleryError, eigenvalues::eigenvalue_bounds};
use crate::{Bounded, Constants, KnownDistance, LocalError, LocallyBounded, Metric, check_gram};

/// `H(x) = A`, a symmetric positive definite matrix in `m²/ℓ²`: Euclidean geometry in oblique
/// coordinates.
///
/// `L_H = M_H = 0`, so every bound on a discretization error is exactly `0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant<const D: usize> {
    matrix: SMatrix<f64, D, D>,
    constants: Constants,
}

/// The metric of a matrix that has not been checked yet.
struct Unchecked<'a, const D: usize>(&'a SMatrix<f64, D, D>);

impl<const D: usize> Metric<D> for Unchecked<'_, D> {
    #[inline]
    fn gram<S: Scalar>(&self, _: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.0.map(S::constant)
    }
}

impl<const D: usize> Constant<D> {
    /// Returns the metric `H = A`. After the check only the upper triangle of `A` is read.
    ///
    /// # Errors
    ///
    /// [`GalleryError::Matrix`] if `A` is not finite, symmetric and positive definite;
    /// [`GalleryError::Constants`] if its condition number is so large (some `10¹⁴`) that rounding
    /// leaves no certain `c₁ > 0`.
    pub fn new(matrix: SMatrix<f64, D, D>) -> Result<Self, GalleryError> {
        check_gram(&Unchecked(&matrix), &SVector::zeros())?;
        let matrix = SMatrix::from_fn(|i, j| matrix[(i.min(j), i.max(j))]);
        let (low, high) = eigenvalue_bounds(&matrix);
        let constants = Constants::new(low, high, 0.0)?.with_m_h(0.0)?;
        Ok(Self { matrix, constants })
    }
}

impl<const D: usize> Metric<D> for Constant<D> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        Unchecked(&self.matrix).gram(x)
    }
}

impl<const D: usize> Bounded<D> for Constant<D> {
    /// `c₁` and `c₂` are the least and the greatest eigenvalue of `A`, moved apart by a few ulps of
    /// the norm to cover rounding; `L_H = M_H = 0`.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<const D: usize> LocallyBounded<D> for Constant<D> {
    /// Returns the constants on all of `R^D`.
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        LocalError::check_ball(centre.as_slice(), radius)?;
        Ok(self.constants().on_a_region())
    }
}

impl<const D: usize> KnownDistance<D> for Constant<D> {
    /// Returns `|A^{1/2} (x − y)|`.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let chord = x - y;
        Some(chord.dot(&(self.matrix * chord)).sqrt())
    }
}
