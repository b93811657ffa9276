//! The factorisation and the inertia of a block-tridiagonal matrix.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_discretizations::BlockTridiagonal;
use tautline_metrics::Lanes;

use crate::newton::ldl::Ldl;

/// A symmetric block-tridiagonal matrix `A + μ R`. The regulariser `R` is `s (N Λ + I/N)` with the
/// path Laplacian `Λ`: the discrete `∫ s (|δ̇|² + |δ|²) dt`.
///
/// Both parts of `R` scale with `N` in the same way as `A`, so that a given `μ` damps equally on
/// every grid. For large `μ` the sum is positive definite whatever `A` is.
///
/// The blocks at the ends, which are the first and last diagonal and upper blocks, can be replaced
/// to confine the ends to their sets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shifted<'a, const D: usize> {
    matrix: &'a BlockTridiagonal<D>,
    regulariser: Regulariser,
    /// The first and the last diagonal block, including the shift.
    pub(crate) end_diagonal: [SMatrix<f64, D, D>; 2],
    /// The first and the last upper block, including the shift. For `N = 1` the first one is both.
    pub(crate) end_upper: [SMatrix<f64, D, D>; 2],
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

impl<'a, const D: usize> Shifted<'a, D> {
    pub(crate) fn new(matrix: &'a BlockTridiagonal<D>, regulariser: Regulariser) -> Self {
        let n = matrix.upper.len();
        let diagonal = SMatrix::from_diagonal_element(regulariser.diagonal(1.0));
        let upper = SMatrix::from_diagonal_element(regulariser.upper());
        Self {
            matrix,
            regulariser,
            end_diagonal: [matrix.diagonal[0] + diagonal, matrix.diagonal[n] + diagonal],
            end_upper: [matrix.upper[0] + upper, matrix.upper[n - 1] + upper],
        }
    }

    pub(crate) fn n(&self) -> usize {
        self.matrix.upper.len()
    }

    fn diagonal(&self, k: usize) -> SMatrix<f64, D, D> {
        if k == 0 {
            self.end_diagonal[0]
        } else if k == self.n() {
            self.end_diagonal[1]
        } else {
            let shift = self.regulariser.diagonal(2.0);
            self.matrix.diagonal[k] + SMatrix::from_diagonal_element(shift)
        }
    }

    fn upper(&self, k: usize) -> SMatrix<f64, D, D> {
        if k == 0 {
            self.end_upper[0]
        } else if k + 1 == self.n() {
            self.end_upper[1]
        } else {
            self.matrix.upper[k] + SMatrix::from_diagonal_element(self.regulariser.upper())
        }
    }

    /// Returns the number of negative eigenvalues, summed over the pivots of block elimination
    /// (Sylvester's law). This is slow, and is used for matrices that are not positive definite.
    pub(crate) fn negative_eigenvalues(&self) -> usize {
        let mut negative = 0;
        let mut schur = self.diagonal(0);
        for k in 0..=self.n() {
            let eigen =
                DMatrix::from_fn(D, D, |i, j| schur[(i.min(j), i.max(j))]).symmetric_eigen();
            negative += eigen.eigenvalues.iter().filter(|&&value| value < 0.0).count();
            if k == self.n() {
                break;
            }
            let upper = self.upper(k);
            let upper = DMatrix::from_fn(D, D, |i, j| upper[(i, j)]);
            let rotated = eigen.eigenvectors.transpose() * upper;
            // A pivot that is exactly zero is replaced by one within rounding.
            let smallest = f64::EPSILON * eigen.eigenvalues.amax().max(f64::MIN_POSITIVE);
            let weight = eigen
                .eigenvalues
                .map(|value| 1.0 / if value.abs() < smallest { smallest } else { value });
            let update = rotated.transpose() * DMatrix::from_diagonal(&weight) * rotated;
            schur = self.diagonal(k + 1) - SMatrix::from_fn(|i, j| update[(i, j)]);
        }
        negative
    }
}

/// One step of the elimination by blocks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pivot<const D: usize, T = f64> {
    /// The Schur complement `Sₙ = Lₙ Dₙ Lₙᵀ`.
    diagonal: Ldl<D, T>,
    /// `Wₙ Dₙ⁻¹`, where `Wₙ = Uₙᵀ Lₙ⁻ᵀ`.
    lower: SMatrix<T, D, D>,
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
/// The Schur complements are `S₀ = A₀` and `Sₙ₊₁ = Aₙ₊₁ − Uₙᵀ Sₙ⁻¹ Uₙ`. Each of them except the
/// last is a [`Pivot`].
#[derive(Clone, Debug)]
pub(crate) struct Factorization<const D: usize> {
    pivots: Vec<Pivot<D>>,
    last: Ldl<D>,
}

impl<const D: usize> Factorization<D> {
    /// Factorises the matrix; `None` if it is not positive definite, or not finite.
    pub(crate) fn new(system: &Shifted<'_, D>) -> Option<Self> {
        let mut schur = system.diagonal(0);
        let mut pivots = Vec::with_capacity(system.n());
        for k in 0..system.n() {
            let mut next = system.diagonal(k + 1);
            pivots.push(Pivot::new(&schur, &system.upper(k).transpose(), &mut next)?);
            schur = next;
        }
        Some(Self { pivots, last: Ldl::new(&schur)? })
    }

    /// Overwrites `b` with the solution of `A x = b`.
    pub(crate) fn solve(&self, b: &mut [SVector<f64, D>]) {
        for (n, pivot) in self.pivots.iter().enumerate() {
            let mut next = b[n + 1];
            [_, b[n]] = pivot.forward(b[n], &mut next);
            b[n + 1] = next;
        }
        let Some(last) = b.last_mut() else { return };
        let [_, z] = self.last.forward(*last);
        *last = self.last.backward(z);
        for (n, pivot) in self.pivots.iter().enumerate().rev() {
            b[n] = pivot.backward(b[n], &b[n + 1]);
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector, SMatrix, SVector};
    use proptest::prelude::*;
    use tautline_discretizations::BlockTridiagonal;

    use super::{Factorization, Regulariser, Shifted};

    const N: usize = 4;

    /// Returns a random block-tridiagonal matrix, and the same matrix in full.
    fn matrix(entries: &[f64], diagonal: f64) -> (BlockTridiagonal<2>, DMatrix<f64>) {
        let mut blocks = BlockTridiagonal::<2>::zeros(N);
        let mut next = entries.iter().copied();
        let mut draw = || SMatrix::<f64, 2, 2>::from_fn(|_, _| next.next().expect("enough"));
        for k in 0..=N {
            let a = draw();
            blocks.diagonal[k] = a + a.transpose() + SMatrix::identity() * diagonal;
        }
        for k in 0..N {
            blocks.upper[k] = draw();
        }
        let full = DMatrix::from_fn(2 * N + 2, 2 * N + 2, |i, j| match (i / 2, j / 2) {
            (n, m) if n == m => blocks.diagonal[n][(i % 2, j % 2)],
            (n, m) if n + 1 == m => blocks.upper[n][(i % 2, j % 2)],
            (n, m) if m + 1 == n => blocks.upper[m][(j % 2, i % 2)],
            _ => 0.0,
        });
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
            let mut x: Vec<_> = (0..=N).map(|k| SVector::from([right[2 * k], right[2 * k + 1]])).collect();
            let factorization = Factorization::new(&system).expect("diagonally dominant");
            factorization.solve(&mut x);
            let x = DVector::from_iterator(10, x.iter().flat_map(|v| [v[0], v[1]]));
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
