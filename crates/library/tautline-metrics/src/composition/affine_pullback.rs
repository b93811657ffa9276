//! A metric in affine coordinates: `Aᵀ H(A x + b) A`.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_scalar::Scalar;

use super::CompositionError;
use crate::{
    Bounded, Constants, HypothesisError, KnownDistance, LocalError, LocallyBounded, Metric,
};

/// `Aᵀ H(A x + b) A` for an invertible matrix `A`: the metric `H` in terms of coordinates `x` of
/// the point `A x + b`. Examples are a rotation, a shift, or other units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AffinePullback<M, const D: usize> {
    metric: M,
    matrix: SMatrix<f64, D, D>,
    shift: SVector<f64, D>,
    /// Bounds on the singular values of the matrix, positive, finite and in increasing order.
    stretches: (f64, f64),
}

impl<M, const D: usize> AffinePullback<M, D> {
    /// Returns the pullback of `metric` by `x ↦ A x + b`.
    ///
    /// # Errors
    ///
    /// [`CompositionError::NotFinite`] with the entry of `A` or `b` that is not finite;
    /// [`HypothesisError::NotStretches`] if `A` is singular, or if its condition number is so large
    /// (some `10¹⁴`) that its least singular value is not certain to be positive.
    pub fn new(
        metric: M,
        matrix: SMatrix<f64, D, D>,
        shift: impl Into<SVector<f64, D>>,
    ) -> Result<Self, CompositionError> {
        let shift = shift.into();
        let finite = |name, value: f64| {
            if value.is_finite() {
                Ok(())
            } else {
                Err(CompositionError::NotFinite { name, value })
            }
        };
        matrix.iter().try_for_each(|&entry| finite("entry of the matrix", entry))?;
        shift.iter().try_for_each(|&entry| finite("entry of the shift", entry))?;
        let (smin, smax) = stretches(&matrix);
        if !(smin > 0.0 && smax.is_finite()) {
            return Err(HypothesisError::NotStretches { smin, smax }.into());
        }
        Ok(Self { metric, matrix, shift, stretches: (smin, smax) })
    }

    /// Returns `A x + b`.
    pub fn image<S: Scalar>(&self, x: &SVector<S, D>) -> SVector<S, D> {
        SVector::from_fn(|i, _| {
            (0..D).fold(S::constant(self.shift[i]), |sum, j| sum + x[j] * self.matrix[(i, j)])
        })
    }
}

/// Returns bounds on the singular values of a finite matrix. Their margin is `16 D` ulps of its
/// norm, which exceeds the errors of the bidiagonalisation and of the iteration.
fn stretches<const D: usize>(matrix: &SMatrix<f64, D, D>) -> (f64, f64) {
    // Scaling the entries to at most 1 keeps intermediate squares from overflowing.
    let scale = matrix.amax();
    if scale == 0.0 {
        return (0.0, 0.0);
    }
    let singular_values = DMatrix::from_fn(D, D, |i, j| matrix[(i, j)] / scale).singular_values();
    let (low, high) = (singular_values.min(), singular_values.max());
    let margin = 16.0 * D as f64 * f64::EPSILON * high;
    ((low - margin) * scale, (high + margin) * scale)
}

impl<M, const D: usize> AffinePullback<M, D> {
    /// Returns the upper half of `Aᵀ H A` from a diagonal on, given the entries of `H`.
    #[inline]
    fn pulled<S: Scalar>(
        &self,
        diagonal: usize,
        h: impl Fn(usize, usize) -> S,
    ) -> SMatrix<S, D, D> {
        let columns = SMatrix::<S, D, D>::from_fn(|i, j| {
            (0..D).fold(S::zero(), |sum, k| sum + h(i, k) * self.matrix[(k, j)])
        });
        let mut pulled = SMatrix::<S, D, D>::zeros();
        for j in 0..D {
            for i in 0..(j + 1).saturating_sub(diagonal) {
                for k in 0..D {
                    pulled[(i, j)] += columns[(k, j)] * self.matrix[(k, i)];
                }
            }
        }
        pulled
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for AffinePullback<M, D> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let h = self.metric.gram(&self.image(x));
        let mut pulled = self.pulled(0, |i, j| h[(i.min(j), i.max(j))]);
        // Each half comes from the same half of H. So a matrix that is not symmetric is seen to be so.
        let mirrored = self.pulled(1, |i, j| h[(i.max(j), i.min(j))]);
        for j in 0..D {
            for i in 0..j {
                pulled[(j, i)] = mirrored[(i, j)];
            }
        }
        pulled
    }
}

impl<M: Bounded<D>, const D: usize> Bounded<D> for AffinePullback<M, D> {
    /// Returns [`Constants::pulled_back`] for the singular values of `A`, moved apart by a few
    /// ulps.
    ///
    /// # Panics
    ///
    /// If a constant overflows, or if `c₁` underflows.
    fn constants(&self) -> Constants {
        let (smin, smax) = self.stretches;
        self.metric.constants().pulled_back(smin, smax).expect("stretches within the range of f64")
    }
}

impl<M: LocallyBounded<D>, const D: usize> LocallyBounded<D> for AffinePullback<M, D> {
    /// The image of the ball lies in a ball about the image of its centre, with `σ_max` times its
    /// radius.
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        let (smin, smax) = self.stretches;
        let within = self.metric.constants_within(&self.image(centre), smax * radius)?;
        Ok(within.pulled_back(smin, smax)?)
    }
}

impl<M: KnownDistance<D>, const D: usize> KnownDistance<D> for AffinePullback<M, D> {
    /// Returns the distance between the images `A x + b` and `A y + b`.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        self.metric.distance(&self.image(x), &self.image(y))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, matrix};

    use super::stretches;

    /// `[[a, b], [b, a]]` has the singular values `a + b` and `a − b`, which are exact for short
    /// `a > b`.
    #[test]
    fn stretches_are_bounds_on_both_sides() {
        for (k, l) in (2..60).flat_map(|k| (1..k).map(move |l| (k, l))) {
            let (a, b) = (1.0 + f64::from(k) / 64.0, f64::from(l) / 64.0);
            let (low, high) = stretches(&matrix![a, b; b, a]);
            assert!(low <= a - b && a + b <= high, "{a} {b}: {low} {high}");
            // The bounds are hardly wider than the margin, 16 D ulps of the norm.
            let close = 64.0 * f64::EPSILON * (a + b);
            assert!(a - b - low <= close && high - a - b <= close, "{a} {b}: {low} {high}");
        }
    }

    /// The squares of these entries overflow or underflow.
    #[test]
    fn stretches_scale_with_the_matrix() {
        let map = matrix![0.3, -1.2; 2.0, 0.4];
        let (low, high) = stretches(&map);
        assert!(low > 0.0 && high.is_finite());
        for unit in [2.0_f64.powi(-600), 2.0_f64.powi(-8), 2.0_f64.powi(600)] {
            let (scaled_low, scaled_high) = stretches(&(map * unit));
            assert!((scaled_low / unit - low).abs() <= 1e-15 * high, "{unit:e}");
            assert!((scaled_high / unit - high).abs() <= 1e-15 * high, "{unit:e}");
        }
        assert_eq!(stretches(&SMatrix::<f64, 3, 3>::zeros()), (0.0, 0.0));
    }
}
