//! The metric induced by a neural network with one hidden layer: `JᵀJ + μ I`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    eigenvalues::eigenvalue_bounds,
    error::{finite, positive},
};
use crate::{Bounded, Constants, HypothesisError, Metric};

/// `H(x) = J(x)ᵀ J(x) + μ I`, where `J = W₂ diag(1/cosh²(W₁ x)) W₁` is the Jacobian of the decoder
/// `f(x) = W₂ tanh(W₁ x)`, from `R^D` through `HIDDEN` neurons to `R^OUT`. It measures the length
/// of the image of a curve, with a floor `μ` that keeps `H` positive definite where the neurons are
/// saturated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "latent space")]
pub struct TanhDecoder<const D: usize, const HIDDEN: usize, const OUT: usize> {
    inner: SMatrix<f64, HIDDEN, D>,
    outer: SMatrix<f64, OUT, HIDDEN>,
    floor: f64,
    constants: Constants,
}

impl<const D: usize, const HIDDEN: usize, const OUT: usize> TanhDecoder<D, HIDDEN, OUT> {
    /// Returns the metric of the decoder with weights `W₁` in `1/ℓ` and `W₂` in `m`, and with the
    /// floor `μ > 0` in `m²/ℓ²`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the entry that is not finite, with the floor if it is not positive, or
    /// with the constant that overflows.
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
        // Let aₖ = wₖ·x with the rows wₖ of W₁, σ = 1/cosh²(a) and τ = tanh² a. Then σ = 1 − τ,
        // σ′² = 4τ(1 − τ)² and σ″ = (1 − τ)(6τ − 2). For a unit vector u put v = W₁u and K = W₂ᵀW₂,
        // so that uᵀJᵀJu = (σv)ᵀ K (σv) with entrywise products; |v|² ≤ |W₁|², |K| = |W₂|².
        //
        // Since σ ≤ 1, the form is at most |W₂|² |W₁|².
        let most = inner_square * outer_square;
        // Along a unit vector w the derivative of each entry has a factor wₖ·w, which is at most
        // `longest`. The first derivative is 2 (σv)ᵀ K (σ′v). It is at most |K| times the sum of
        // λ σ² + σ′²/λ times v², for any λ. With λ = 2/√5 this factor is (1 − τ)² (2/√5)(1 + 5τ),
        // which is largest at τ = 1/5, where it is 64/(25√5).
        let l_h = most * longest * (64.0 / (25.0 * 5_f64.sqrt()));
        // The second derivative is 2 (σv)ᵀ K (σ″v) + 2 (σ′v)ᵀ K (σ′v). It is at most |K| times the
        // sum of 2σ² + σ″²/2 + 2σ′² = (1 − τ)² (4 − 4τ + 18τ²) times v². This factor is at most
        // (1 − τ)(4 − 4τ + 18τ²) = 4 − 2τ (4 − 11τ + 9τ²) ≤ 4, since the last bracket has no real
        // root.
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

    /// Returns `W₁ x`.
    fn activations<S: Scalar>(&self, x: &SVector<S, D>) -> SVector<S, HIDDEN> {
        SVector::from_fn(|k, _| (0..D).fold(S::zero(), |sum, i| sum + x[i] * self.inner[(k, i)]))
    }

    /// Returns `1/cosh²(W₁ x)`, computed as `1 − tanh²`, since `cosh` overflows.
    fn slopes<S: Scalar>(&self, x: &SVector<S, D>) -> SVector<S, HIDDEN> {
        self.activations(x).map(|a| -a.tanh().sqr() + 1.0)
    }
}

/// Returns an upper bound on the squared operator norm of a finite matrix.
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
    /// `c₁ = μ` holds in the limit. With the operator norms `|W₁|`, `|W₂|` and the longest row `w`
    /// of `W₁`, the other constants are the upper bounds
    ///
    /// ```text
    /// c₂ = μ + |W₁|² |W₂|²,    L_H = (64/25√5) |W₁|² |W₂|² |w|,    M_H = 4 |W₁|² |W₂|² |w|²
    /// ```
    ///
    /// They are attained for a single neuron; for several, they are looser the less the neurons are
    /// aligned. For a dozen decoders with random weights and 3 to 16 neurons, a scan found `c₂` 1
    /// to 6 times, `L_H` 1 to 9 times and `M_H` 1 to 10 times too large.
    fn constants(&self) -> Constants {
        self.constants
    }
}
