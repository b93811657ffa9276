//! The factorisation and the inertia of a block-tridiagonal matrix.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_discretizations::QuadraticModel;
use tautline_metrics::Lanes;

use crate::newton::{
    arithmetic::blocks::{Any, Blocks, PivotMut, with_blocks, with_small_blocks},
    arithmetic::ldl::Ldl,
    arithmetic::small::Matrix,
};

/// A symmetric block-tridiagonal matrix `A + μ R`. The regulariser `R` is `s (N Λ + I/N)` with the
/// path Laplacian `Λ`: the discrete `∫ s (|δ̇|² + |δ|²) dt`.
///
/// Both parts of `R` scale with `N` in the same way as `A`, so that a given `μ` damps equally on
/// every grid. For large `μ` the sum is positive definite whatever `A` is.
///
/// The blocks at the ends, which are the first and last diagonal and upper blocks, can be replaced
/// to confine the ends to their sets.
#[derive(Clone, Debug)]
pub(crate) struct Shifted<'a> {
    /// The matrix `A`, as the diagonal and upper blocks of a model.
    model: &'a QuadraticModel,
    /// The number of upper blocks.
    n: usize,
    regulariser: Regulariser,
    /// The first and the last diagonal block, including the shift.
    pub(crate) end_diagonal: [Matrix; 2],
    /// The first and the last upper block, including the shift. For `N = 1` the first one is both.
    pub(crate) end_upper: [Matrix; 2],
}

/// The matrix `μ R`, given by `N` and the product `μ s`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Regulariser {
    pub(crate) n: f64,
    pub(crate) weight: f64,
}

impl Regulariser {
    /// Returns the diagonal entries at a point with one neighbour or two.
    pub(crate) fn diagonal(self, neighbours: f64) -> f64 {
        self.weight * (neighbours * self.n + 1.0 / self.n)
    }

    /// Returns what a chord contributes to the diagonal entries at each of its points. An inner
    /// point has two chords; an end has one chord, and the remainder [`of_end`](Self::of_end).
    pub(crate) fn of_chord(self) -> f64 {
        self.weight * (self.n + 0.5 / self.n)
    }

    /// Returns the diagonal entries at an end, less the contribution of its only chord.
    pub(crate) fn of_end(self) -> f64 {
        self.weight * (0.5 / self.n)
    }

    /// Returns the entries that couple a point with the next one.
    pub(crate) fn upper(self) -> f64 {
        -self.weight * self.n
    }
}

impl<'a> Shifted<'a> {
    pub(crate) fn new(model: &'a QuadraticModel, regulariser: Regulariser) -> Self {
        with_small_blocks!(model.dimension, blocks => Self::by(blocks, model, regulariser))
    }

    #[inline(always)]
    fn by(blocks: impl Blocks, model: &'a QuadraticModel, regulariser: Regulariser) -> Self {
        let d = blocks.dimension();
        let shifted = |list: &[f64], k: usize, shift: f64| {
            let mut shifted = Matrix::from_slice(block(list, d, k));
            for i in 0..d {
                shifted[i * d + i] += shift;
            }
            shifted
        };
        let n = model.upper.len() / (d * d);
        let (end, upper) = (regulariser.diagonal(1.0), regulariser.upper());
        Self {
            model,
            n,
            regulariser,
            end_diagonal: [0, n].map(|k| shifted(&model.diagonal, k, end)),
            end_upper: [0, n - 1].map(|k| shifted(&model.upper, k, upper)),
        }
    }

    pub(crate) fn n(&self) -> usize {
        self.n
    }

    pub(crate) fn dimension(&self) -> usize {
        self.model.dimension
    }

    /// Writes diagonal block `k` to `to`, where `block` is that of the model.
    #[inline(always)]
    fn diagonal(&self, blocks: impl Blocks, k: usize, block: &[f64], to: &mut [f64]) {
        let d = blocks.dimension();
        if k == 0 {
            to.copy_from_slice(&self.end_diagonal[0][..d * d]);
        } else if k == self.n {
            to.copy_from_slice(&self.end_diagonal[1][..d * d]);
        } else {
            to.copy_from_slice(block);
            let shift = self.regulariser.diagonal(2.0);
            for i in 0..d {
                to[i * d + i] += shift;
            }
        }
    }

    /// Writes the transpose of upper block `k` to `to`, where `block` is that of the model.
    #[inline(always)]
    fn lower(&self, blocks: impl Blocks, k: usize, block: &[f64], to: &mut [f64]) {
        let d = blocks.dimension();
        let (upper, shift) = if k == 0 {
            (&self.end_upper[0][..d * d], 0.0)
        } else if k + 1 == self.n {
            (&self.end_upper[1][..d * d], 0.0)
        } else {
            (block, self.regulariser.upper())
        };
        for j in 0..d {
            for i in 0..d {
                to[j * d + i] = upper[i * d + j];
            }
            to[j * d + j] += shift;
        }
    }

    /// Returns the number of negative eigenvalues, summed over the pivots of block elimination
    /// (Sylvester's law). This is slow, and is used for matrices that are not positive definite.
    pub(crate) fn negative_eigenvalues(&self) -> usize {
        let d = self.model.dimension;
        let blocks = Any(d);
        let mut negative = 0;
        let mut schur = DMatrix::zeros(d, d);
        self.diagonal(blocks, 0, block(&self.model.diagonal, d, 0), schur.as_mut_slice());
        for k in 0..=self.n() {
            let eigen =
                DMatrix::from_fn(d, d, |i, j| schur[(i.min(j), i.max(j))]).symmetric_eigen();
            negative += eigen.eigenvalues.iter().filter(|&&value| value < 0.0).count();
            if k == self.n() {
                break;
            }
            let mut lower = DMatrix::zeros(d, d);
            self.lower(blocks, k, block(&self.model.upper, d, k), lower.as_mut_slice());
            let rotated = eigen.eigenvectors.transpose() * lower.transpose();
            // A pivot that is exactly zero is replaced by one within rounding.
            let smallest = f64::EPSILON * eigen.eigenvalues.amax().max(f64::MIN_POSITIVE);
            let weight = eigen
                .eigenvalues
                .map(|value| 1.0 / if value.abs() < smallest { smallest } else { value });
            let update = rotated.transpose() * DMatrix::from_diagonal(&weight) * rotated;
            let next = block(&self.model.diagonal, d, k + 1);
            self.diagonal(blocks, k + 1, next, schur.as_mut_slice());
            schur -= update;
        }
        negative
    }
}

/// Returns block `k` of some blocks.
#[inline(always)]
pub(crate) fn block(blocks: &[f64], d: usize, k: usize) -> &[f64] {
    &blocks[k * d * d..][..d * d]
}

/// One step of the elimination by blocks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pivot<const D: usize, T = f64> {
    /// The Schur complement `Sₙ = Lₙ Dₙ Lₙᵀ`.
    pub(crate) diagonal: Ldl<D, T>,
    /// `Wₙ Dₙ⁻¹`, where `Wₙ = Uₙᵀ Lₙ⁻ᵀ`.
    pub(crate) lower: SMatrix<T, D, D>,
}

impl<T: Lanes, const D: usize> Pivot<D, T> {
    /// Returns a placeholder, every entry of which is overwritten later.
    pub(crate) fn zero() -> Self {
        Self { diagonal: Ldl::zero(), lower: SMatrix::zeros() }
    }

    /// Eliminates `Sₙ`, and updates the next diagonal block from `Aₙ₊₁` to `Sₙ₊₁`. The argument
    /// `lower` is `Uₙᵀ`. The result is `None` if `Sₙ` is not positive definite. Symmetric blocks
    /// are stored in their lower triangles, `i ≥ j`.
    #[inline(always)]
    pub(crate) fn new(
        schur: &SMatrix<T, D, D>,
        lower: &SMatrix<T, D, D>,
        next: &mut SMatrix<T, D, D>,
    ) -> Option<Self> {
        let diagonal = Ldl::new(schur)?;
        let [w, scaled] = diagonal.divide(lower);
        for k in 0..D {
            for j in 0..D {
                for i in j..D {
                    let eliminated = w[(i, k)] * scaled[(j, k)];
                    next[(i, j)] -= eliminated;
                }
            }
        }
        Some(Self { diagonal, lower: scaled })
    }

    /// Eliminates the right hand side `rₙ`: subtracts `Wₙ Dₙ⁻¹ yₙ` from `next`, and returns both
    /// `yₙ = Lₙ⁻¹ rₙ` and `zₙ = Dₙ⁻¹ yₙ`.
    #[inline(always)]
    pub(crate) fn forward(
        &self,
        right: SVector<T, D>,
        next: &mut SVector<T, D>,
    ) -> [SVector<T, D>; 2] {
        let [y, z] = self.diagonal.forward(right);
        *next -= self.lower * y;
        [y, z]
    }

    /// Returns `xₙ = Lₙ⁻ᵀ (zₙ − Dₙ⁻¹ Wₙᵀ xₙ₊₁)`, where `next` is `xₙ₊₁`.
    #[inline(always)]
    pub(crate) fn backward(&self, z: SVector<T, D>, next: &SVector<T, D>) -> SVector<T, D> {
        self.diagonal.backward(z - self.lower.tr_mul(next))
    }
}

/// The block factorisation of a positive definite block-tridiagonal matrix, from the first block to
/// the last, in `O(N D³)`.
///
/// The Schur complements are `S₀ = A₀` and `Sₙ₊₁ = Aₙ₊₁ − Uₙᵀ Sₙ⁻¹ Uₙ`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Factorization {
    dimension: usize,
    /// The factors of the Schur complements.
    factors: Vec<f64>,
    /// The blocks `Wₙ Dₙ⁻¹` of all Schur complements but the last.
    lower: Vec<f64>,
}

impl Factorization {
    /// Factorises the matrix; `None` if it is not positive definite, or not finite.
    pub(crate) fn new(system: &Shifted<'_>) -> Option<Self> {
        let mut factorization = Self::default();
        factorization.factorize(system).then_some(factorization)
    }

    /// Does the same in the memory of this factorisation, and returns whether the matrix is positive
    /// definite.
    pub(crate) fn factorize(&mut self, system: &Shifted<'_>) -> bool {
        with_blocks!(system.dimension(), blocks => self.factorize_by(blocks, system))
    }

    #[inline(always)]
    fn factorize_by(&mut self, blocks: impl Blocks, system: &Shifted<'_>) -> bool {
        let (d, n) = (blocks.dimension(), system.n());
        let size = d * d;
        let Self { dimension, factors, lower } = self;
        *dimension = d;
        factors.resize((n + 1) * size, 0.0);
        lower.resize(n * size, 0.0);
        let mut scratch = Vec::new();
        let (mut schur, mut next, mut below) = (blocks.block(), blocks.block(), blocks.block());
        let model = system.model;
        system.diagonal(blocks, 0, &model.diagonal[..size], schur.as_mut());
        let (before_last, last) = factors.split_at_mut(n * size);
        let pivots = before_last.chunks_exact_mut(size).zip(lower.chunks_exact_mut(size));
        let ahead = model.diagonal[size..].chunks_exact(size).zip(model.upper.chunks_exact(size));
        for (k, ((factors, lower), (diagonal, upper))) in pivots.zip(ahead).enumerate() {
            system.diagonal(blocks, k + 1, diagonal, next.as_mut());
            system.lower(blocks, k, upper, below.as_mut());
            let pivot = PivotMut { factors, lower };
            if !blocks.eliminate(schur.as_ref(), below.as_ref(), next.as_mut(), pivot, &mut scratch)
            {
                return false;
            }
            std::mem::swap(&mut schur, &mut next);
        }
        blocks.factorize(schur.as_ref(), last)
    }

    /// Overwrites `b` with the solution of `A x = b`.
    pub(crate) fn solve(&self, b: &mut [f64]) {
        with_blocks!(self.dimension, blocks => self.solve_by(blocks, b));
    }

    #[inline(always)]
    fn solve_by(&self, blocks: impl Blocks, b: &mut [f64]) {
        let (d, size) = (blocks.dimension(), blocks.dimension() * blocks.dimension());
        // Both vectors stay in registers if they are short.
        let (mut here, mut behind) = (blocks.vector(), blocks.vector());
        let (first, later) = b.split_at_mut(d);
        here.as_mut().copy_from_slice(first);
        blocks.forward(&self.factors[..size], here.as_mut(), first);
        let pivots = self.factors[size..].chunks_exact(size).zip(self.lower.chunks_exact(size));
        for (z, (factors, lower)) in later.chunks_exact_mut(d).zip(pivots) {
            std::mem::swap(&mut here, &mut behind);
            here.as_mut().copy_from_slice(z);
            blocks.subtract(lower, behind.as_ref(), here.as_mut());
            blocks.forward(factors, here.as_mut(), z);
        }
        let (earlier, last) = b.split_at_mut(b.len() - d);
        let (factors, last_factors) = self.factors.split_at(self.factors.len() - size);
        here.as_mut().copy_from_slice(last);
        blocks.backward(last_factors, here.as_mut());
        last.copy_from_slice(here.as_ref());
        let pivots = factors.chunks_exact(size).zip(self.lower.chunks_exact(size));
        for (z, (factors, lower)) in earlier.chunks_exact_mut(d).zip(pivots).rev() {
            std::mem::swap(&mut here, &mut behind);
            here.as_mut().copy_from_slice(z);
            blocks.subtract_transposed(lower, behind.as_ref(), here.as_mut());
            blocks.backward(factors, here.as_mut());
            z.copy_from_slice(here.as_ref());
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector, SMatrix};
    use proptest::prelude::*;
    use tautline_discretizations::QuadraticModel;

    use super::{Factorization, Regulariser, Shifted};

    const N: usize = 4;

    /// Returns a random block-tridiagonal matrix, and the same matrix in full.
    fn matrix(entries: &[f64], diagonal: f64) -> (QuadraticModel, DMatrix<f64>) {
        let mut next = entries.iter().copied();
        let mut draw = || SMatrix::<f64, 2, 2>::from_fn(|_, _| next.next().expect("enough"));
        let symmetric = |a: SMatrix<f64, 2, 2>| a + a.transpose() + SMatrix::identity() * diagonal;
        let diagonal: Vec<_> = (0..=N).map(|_| symmetric(draw())).collect();
        let upper: Vec<_> = (0..N).map(|_| draw()).collect();
        let full = DMatrix::from_fn(2 * N + 2, 2 * N + 2, |i, j| match (i / 2, j / 2) {
            (n, m) if n == m => diagonal[n][(i % 2, j % 2)],
            (n, m) if n + 1 == m => upper[n][(i % 2, j % 2)],
            (n, m) if m + 1 == n => upper[m][(j % 2, i % 2)],
            _ => 0.0,
        });
        let blocks = QuadraticModel {
            dimension: 2,
            diagonal: bytemuck::cast_vec(diagonal),
            upper: bytemuck::cast_vec(upper),
            ..QuadraticModel::default()
        };
        (blocks, full)
    }

    /// Returns `μ R` as a full matrix, from its definition as a quadratic form.
    fn regulariser(weight: f64) -> DMatrix<f64> {
        let n = N as f64;
        let mut r = DMatrix::identity(2 * N + 2, 2 * N + 2) / n;
        for k in 0..N {
            for i in 0..2 {
                let (a, b) = (2 * k + i, 2 * k + 2 + i);
                r[(a, a)] += n;
                r[(b, b)] += n;
                r[(a, b)] -= n;
                r[(b, a)] -= n;
            }
        }
        r * weight
    }

    proptest! {
        #![proptest_config(tautline_chance::config(3, 256))]

        #[test]
        fn solving_agrees_with_dense_algebra(
            entries in proptest::collection::vec(-1.0..1.0_f64, 36),
            right in proptest::collection::vec(-1.0..1.0_f64, 10),
            shift in 0.0..2.0_f64,
        ) {
            // The absolute values of a row sum to at most 8, so that 10 on the diagonal is enough.
            let (blocks, full) = matrix(&entries, 10.0);
            let shifted = Regulariser { n: N as f64, weight: shift };
            let system = Shifted::new(&blocks, shifted);
            let dense = full + regulariser(shift);
            let mut x = right.clone();
            let factorization = Factorization::new(&system).expect("diagonally dominant");
            factorization.solve(&mut x);
            let x = DVector::from_vec(x);
            // The condition number is at most 30, and entries are of size 30.
            let residual = dense * x - DVector::from_vec(right);
            prop_assert!(residual.amax() < 1e-13, "{}", residual.amax());
        }

        #[test]
        fn inertia_agrees_with_the_eigenvalues(
            entries in proptest::collection::vec(-1.0..1.0_f64, 36),
            diagonal in -3.0..5.0_f64,
        ) {
            let (blocks, full) = matrix(&entries, diagonal);
            let none = Regulariser { n: N as f64, weight: 0.0 };
            let system = Shifted::new(&blocks, none);
            let values = full.symmetric_eigenvalues();
            // A value within 1e-9 of zero may fall on either side.
            prop_assume!(values.iter().all(|value| value.abs() > 1e-9));
            let negative = values.iter().filter(|&&value| value < 0.0).count();
            prop_assert_eq!(system.negative_eigenvalues(), negative);
            prop_assert_eq!(Factorization::new(&system).is_some(), negative == 0);
        }
    }
}
