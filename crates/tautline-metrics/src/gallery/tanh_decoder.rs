//! The metric induced by a neural network with one hidden layer: `JᵀJ + μ I`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    eigenvalues::eigenvalue_bounds,
    error::{finite, positive},
};
use crate::{Bounded, Constants, HypothesisError, Metric};

/// `H(x) = J(x)ᵀ J(x) + μ I` with the Jacobian `J = W₂ diag(1/cosh²(W₁ x)) W₁` of the decoder
/// `f(x) = W₂ tanh(W₁ x)`, from `R^D` through `HIDDEN` neurons to `R^OUT`: the length of the image of
/// a curve, with a floor `μ` that keeps `H` positive definite where the neurons are saturated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "latent space")]
pub struct TanhDecoder<const D: usize, const HIDDEN: usize, const OUT: usize> {
    inner: SMatrix<f64, HIDDEN, D>,
    outer: SMatrix<f64, OUT, HIDDEN>,
    floor: f64,
    constants: Constants,
}

impl<const D: usize, const HIDDEN: usize, const OUT: usize> TanhDecoder<D, HIDDEN, OUT> {
    /// Returns the metric of the decoder with the weights `W₁` in `1/ℓ` and `W₂` in `m`, and the
    /// floor `μ > 0` in `m²/ℓ²`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the entry that is not finite or the floor that is not positive, or
    /// the constant that overflows.
    pub fn new(
        inner: SMatrix<f64, HIDDEN, D>,
        outer: SMatrix<f64, OUT, HIDDEN>,
        floor: f64,
    ) -> Result<Self, GalleryError> {
        inner.iter().try_for_each(|&entry| finite("entry of W1", entry).map(drop))?;
        outer.iter().try_for_each(|&entry| finite("entry of W2", entry).map(drop))?;
        positive("floor", floor)?;
        let (inner_square, outer_square) = (norm_squared(&inner)?, norm_squared(&outer)?);
        let longest = inner.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
        // Let aₖ = wₖ·x with the rows wₖ of W₁, σ = 1/cosh²(a) and τ = tanh² a: σ = 1 − τ,
        // σ′² = 4τ(1 − τ)² and σ″ = (1 − τ)(6τ − 2). For a unit vector u put v = W₁u and K = W₂ᵀW₂,
        // so that uᵀJᵀJu = (σv)ᵀ K (σv) with entrywise products; |v|² ≤ |W₁|², |K| = |W₂|².
        //
        // With σ ≤ 1 this is at most |W₂|² |W₁|².
        let most = inner_square * outer_square;
        // Along a unit vector w each entry's derivative has a factor wₖ·w, at most `longest`. The
        // first derivative is 2 (σv)ᵀ K (σ′v), at most |K| times the sum over λ σ² + σ′²/λ for any
        // λ, times v². With λ = 2/√5 that is (1 − τ)² (2/√5)(1 + 5τ), largest at τ = 1/5: there
        // 64/(25√5).
        let l_h = most * longest * (64.0 / (25.0 * 5_f64.sqrt()));
        // The second is 2 (σv)ᵀ K (σ″v) + 2 (σ′v)ᵀ K (σ′v), at most |K| times the sum over
        // 2σ² + σ″²/2 + 2σ′² = (1 − τ)² (4 − 4τ + 18τ²). That is at most (1 − τ)(4 − 4τ + 18τ²) =
        // 4 − 2τ (4 − 11τ + 9τ²) ≤ 4, since the last bracket has no real root.
        let m_h = most * longest * longest * 4.0;
        let constants = Constants::new(floor, floor + most, l_h)?.with_m_h(m_h)?;
        Ok(Self { inner, outer, floor, constants })
    }

    /// Returns `f(x) = W₂ tanh(W₁ x)`, in `m`.
    pub fn decode<S: Scalar>(&self, x: &SVector<S, D>) -> SVector<S, OUT> {
        let hidden = self.activations(x).map(Scalar::tanh);
        SVector::from_fn(|o, _| {
            (0..HIDDEN).fold(S::zero(), |sum, k| sum + hidden[k] * self.outer[(o, k)])
        })
    }

    /// `W₁ x`.
    fn activations<S: Scalar>(&self, x: &SVector<S, D>) -> SVector<S, HIDDEN> {
        SVector::from_fn(|k, _| (0..D).fold(S::zero(), |sum, i| sum + x[i] * self.inner[(k, i)]))
    }

    /// `1/cosh²(W₁ x)` as `1 − tanh²`, since `cosh` overflows.
    fn slopes<S: Scalar>(&self, x: &SVector<S, D>) -> SVector<S, HIDDEN> {
        self.activations(x).map(|a| -a.tanh().sqr() + 1.0)
    }
}

/// An upper bound on the squared operator norm of a finite matrix.
fn norm_squared<const R: usize, const C: usize>(
    matrix: &SMatrix<f64, R, C>,
) -> Result<f64, GalleryError> {
    let square = matrix.transpose() * matrix;
    let most = square.trace();
    if most.is_finite() {
        Ok(eigenvalue_bounds(&square).1)
    } else {
        // The eigenvalues of a matrix that is not finite are unspecified.
        Err(HypothesisError::CrossedBounds { c1: 0.0, c2: most }.into())
    }
}

impl<const D: usize, const HIDDEN: usize, const OUT: usize> Metric<D>
    for TanhDecoder<D, HIDDEN, OUT>
{
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let slopes = self.slopes(x);
        let jacobian = SMatrix::<S, OUT, D>::from_fn(|o, i| {
            (0..HIDDEN).fold(S::zero(), |sum, k| {
                sum + slopes[k] * (self.outer[(o, k)] * self.inner[(k, i)])
            })
        });
        let mut h = SMatrix::<S, D, D>::from_diagonal_element(S::constant(self.floor));
        for j in 0..D {
            for i in 0..=j {
                for o in 0..OUT {
                    h[(i, j)] += jacobian[(o, i)] * jacobian[(o, j)];
                }
            }
        }
        h.fill_lower_triangle_with_upper_triangle();
        h
    }
}

impl<const D: usize, const HIDDEN: usize, const OUT: usize> Bounded<D>
    for TanhDecoder<D, HIDDEN, OUT>
{
    /// `c₁ = μ` in the limit. With the operator norms `|W₁|`, `|W₂|` and the longest row `w` of
    /// `W₁`, the upper bounds
    ///
    /// ```text
    /// c₂ = μ + |W₁|² |W₂|²,    L_H = (64/25√5) |W₁|² |W₂|² |w|,    M_H = 4 |W₁|² |W₂|² |w|²
    /// ```
    ///
    /// Attained for one neuron; for several, looser the less they are aligned. For a dozen decoders
    /// of random weights, with 3 to 16 neurons, a scan found `c₂` 1 to 6 times, `L_H` 1 to 9 times and
    /// `M_H` 1 to 10 times too large.
    fn constants(&self) -> Constants {
        self.constants
    }
}
