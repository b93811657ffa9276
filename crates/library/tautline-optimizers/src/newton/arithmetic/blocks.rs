//! `Blocks`: the arithmetic of one block of an elimination, in a fixed dimension or in any.

use nalgebra::{SMatrix, SVector};
use smallvec::SmallVec;

use crate::newton::{
    arithmetic::{dense, ldl::Ldl},
    factorization::Pivot,
};

/// Runs an expression with [`Blocks`] for a dimension. Up to three dimensions the blocks are of a fixed
/// size: their loops are unrolled, and they stay in registers.
macro_rules! with_blocks {
    (@ $($fixed:literal)*, $dimension:expr, $blocks:ident => $run:expr) => {
        match $dimension {
            $($fixed => {
                let $blocks = $crate::newton::arithmetic::blocks::Fixed::<$fixed>;
                $run
            })*
            dimension => {
                let $blocks = $crate::newton::arithmetic::blocks::Any(dimension);
                $run
            }
        }
    };
    ($dimension:expr, $blocks:ident => $run:expr) => {
        $crate::newton::arithmetic::blocks::with_blocks!(
            @ 1 2 3 4 5 6 7 8 9 10 11 12, $dimension, $blocks => $run
        )
    };
}
pub(crate) use with_blocks;

/// Does the same for what is done at the ends of a curve only, where larger blocks do not matter.
macro_rules! with_small_blocks {
    ($dimension:expr, $blocks:ident => $run:expr) => {
        $crate::newton::arithmetic::blocks::with_blocks!(@ 1 2 3 4 5 6, $dimension, $blocks => $run)
    };
}
pub(crate) use with_small_blocks;

/// The arithmetic of blocks of `D × D` numbers, column by column. Symmetric blocks are given by their
/// lower triangles `i ≥ j`; what is above is arbitrary.
pub(crate) trait Blocks: Copy + Send + Sync {
    /// Memory for a vector, and for a block.
    type Vector: AsRef<[f64]> + AsMut<[f64]> + Send;
    type Block: AsRef<[f64]> + AsMut<[f64]> + Send;

    /// Returns `D`.
    fn dimension(self) -> usize;

    /// Returns the vector 0.
    fn vector(self) -> Self::Vector;

    /// Returns the block 0.
    fn block(self) -> Self::Block;

    /// Factorises `A = L D Lᵀ` into `factors`, with `L` below the diagonal and the reciprocals of `D`
    /// on it. Returns whether `A` is positive definite and finite.
    fn factorize(self, a: &[f64], factors: &mut [f64]) -> bool;

    /// Eliminates a block `Sₙ` with `lower = Uₙᵀ`: writes its factors and `Wₙ Dₙ⁻¹` to the pivot, where
    /// `Wₙ = Uₙᵀ Lₙ⁻ᵀ`, and updates the next diagonal block from `Aₙ₊₁` to `Sₙ₊₁`. Returns whether `Sₙ`
    /// is positive definite and finite.
    fn eliminate(
        self,
        schur: &[f64],
        lower: &[f64],
        next: &mut [f64],
        pivot: PivotMut<'_>,
        scratch: &mut Vec<f64>,
    ) -> bool;

    /// Replaces `b` by `y = L⁻¹ b`, and writes `z = D⁻¹ y`.
    fn forward(self, factors: &[f64], y: &mut [f64], z: &mut [f64]);

    /// Replaces `z` by `L⁻ᵀ z`.
    fn backward(self, factors: &[f64], z: &mut [f64]);

    /// Subtracts `A y` from `next`.
    fn subtract(self, a: &[f64], y: &[f64], next: &mut [f64]);

    /// Subtracts `Aᵀ x` from `z`.
    fn subtract_transposed(self, a: &[f64], x: &[f64], z: &mut [f64]);

    /// Returns `y · z`.
    fn dot(self, y: &[f64], z: &[f64]) -> f64;
}

/// The two blocks of a pivot of an elimination.
pub(crate) struct PivotMut<'p> {
    /// The factors of the Schur complement `Sₙ`.
    pub(crate) factors: &'p mut [f64],
    /// `Wₙ Dₙ⁻¹`.
    pub(crate) lower: &'p mut [f64],
}

/// Blocks of a size that is known at compile time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fixed<const D: usize>;

#[inline(always)]
fn matrix<const D: usize>(a: &[f64]) -> &SMatrix<f64, D, D> {
    &bytemuck::cast_slice::<f64, SMatrix<f64, D, D>>(a)[0]
}

#[inline(always)]
fn vector<const D: usize>(x: &[f64]) -> SVector<f64, D> {
    SVector::from_column_slice(&x[..D])
}

/// A block of numbers whose size the compiler knows.
pub(crate) struct FixedBlock<const D: usize>([[f64; D]; D]);

impl<const D: usize> AsRef<[f64]> for FixedBlock<D> {
    #[inline(always)]
    fn as_ref(&self) -> &[f64] {
        self.0.as_flattened()
    }
}

impl<const D: usize> AsMut<[f64]> for FixedBlock<D> {
    #[inline(always)]
    fn as_mut(&mut self) -> &mut [f64] {
        self.0.as_flattened_mut()
    }
}

impl<const D: usize> Blocks for Fixed<D> {
    type Vector = [f64; D];
    type Block = FixedBlock<D>;

    #[inline(always)]
    fn dimension(self) -> usize {
        D
    }

    #[inline(always)]
    fn vector(self) -> [f64; D] {
        [0.0; D]
    }

    #[inline(always)]
    fn block(self) -> FixedBlock<D> {
        FixedBlock([[0.0; D]; D])
    }

    #[inline(always)]
    fn factorize(self, a: &[f64], factors: &mut [f64]) -> bool {
        let ldl = Ldl::<D>::new(matrix(a));
        ldl.map(|ldl| factors.copy_from_slice(ldl.factors.as_slice())).is_some()
    }

    #[inline(always)]
    fn eliminate(
        self,
        schur: &[f64],
        lower: &[f64],
        next: &mut [f64],
        pivot: PivotMut<'_>,
        _scratch: &mut Vec<f64>,
    ) -> bool {
        let mut ahead = *matrix::<D>(next);
        let Some(found) = Pivot::<D>::new(matrix(schur), matrix(lower), &mut ahead) else {
            return false;
        };
        next.copy_from_slice(ahead.as_slice());
        pivot.factors.copy_from_slice(found.diagonal.factors.as_slice());
        pivot.lower.copy_from_slice(found.lower.as_slice());
        true
    }

    #[inline(always)]
    fn forward(self, factors: &[f64], y: &mut [f64], z: &mut [f64]) {
        let ldl = Ldl::<D> { factors: *matrix(factors) };
        let [below, scaled] = ldl.forward(vector(y));
        y.copy_from_slice(below.as_slice());
        z.copy_from_slice(scaled.as_slice());
    }

    #[inline(always)]
    fn backward(self, factors: &[f64], z: &mut [f64]) {
        let ldl = Ldl::<D> { factors: *matrix(factors) };
        z.copy_from_slice(ldl.backward(vector(z)).as_slice());
    }

    #[inline(always)]
    fn subtract(self, a: &[f64], y: &[f64], next: &mut [f64]) {
        let rest = vector::<D>(next) - matrix::<D>(a) * vector::<D>(y);
        next.copy_from_slice(rest.as_slice());
    }

    #[inline(always)]
    fn subtract_transposed(self, a: &[f64], x: &[f64], z: &mut [f64]) {
        let rest = vector::<D>(z) - matrix::<D>(a).tr_mul(&vector::<D>(x));
        z.copy_from_slice(rest.as_slice());
    }

    #[inline(always)]
    fn dot(self, y: &[f64], z: &[f64]) -> f64 {
        vector::<D>(y).dot(&vector::<D>(z))
    }
}

/// Blocks of a size that is known when the program runs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Any(pub(crate) usize);

impl Blocks for Any {
    type Vector = SmallVec<[f64; 16]>;
    type Block = Vec<f64>;

    fn dimension(self) -> usize {
        self.0
    }

    fn vector(self) -> Self::Vector {
        SmallVec::from_elem(0.0, self.0)
    }

    fn block(self) -> Vec<f64> {
        vec![0.0; self.0 * self.0]
    }

    fn factorize(self, a: &[f64], factors: &mut [f64]) -> bool {
        factors.copy_from_slice(a);
        dense::factorize(self.0, factors)
    }

    fn eliminate(
        self,
        schur: &[f64],
        lower: &[f64],
        next: &mut [f64],
        PivotMut { factors, lower: scaled }: PivotMut<'_>,
        scratch: &mut Vec<f64>,
    ) -> bool {
        scratch.resize(lower.len(), 0.0);
        dense::eliminate(self.0, schur, lower, next, [factors, scaled, scratch])
    }

    fn forward(self, factors: &[f64], y: &mut [f64], z: &mut [f64]) {
        let d = self.0;
        for j in 0..d {
            let (head, tail) = y.split_at_mut(j + 1);
            let column = &factors[j * d + j + 1..(j + 1) * d];
            tail.iter_mut().zip(column).for_each(|(y, l)| *y -= l * head[j]);
            z[j] = head[j] * factors[j * d + j];
        }
    }

    fn backward(self, factors: &[f64], z: &mut [f64]) {
        let d = self.0;
        for j in (0..d).rev() {
            let (head, tail) = z.split_at_mut(j + 1);
            head[j] -= dense::dot(&factors[j * d + j + 1..(j + 1) * d], tail);
        }
    }

    fn subtract(self, a: &[f64], y: &[f64], next: &mut [f64]) {
        for (column, y) in a.chunks_exact(self.0).zip(y) {
            next.iter_mut().zip(column).for_each(|(next, a)| *next -= a * y);
        }
    }

    fn subtract_transposed(self, a: &[f64], x: &[f64], z: &mut [f64]) {
        for (column, z) in a.chunks_exact(self.0).zip(z) {
            *z -= dense::dot(column, x);
        }
    }

    fn dot(self, y: &[f64], z: &[f64]) -> f64 {
        dense::dot(y, z)
    }
}

#[cfg(test)]
mod tests {
    use super::{Any, Blocks, Fixed, PivotMut};

    /// All blocks of one step of an elimination, one after the other.
    fn step(blocks: impl Blocks, definite: bool) -> Option<Vec<f64>> {
        let d = blocks.dimension();
        let wave = |i: usize, j: usize| ((3 * i + 7 * j + i * j) as f64).sin();
        let symmetric = |diagonal: f64| -> Vec<f64> {
            let entry = |place: usize| {
                let (i, j) = (place % d, place / d);
                wave(i.max(j), i.min(j)) + if i == j { diagonal } else { 0.0 }
            };
            (0..d * d).map(entry).collect()
        };
        let schur = symmetric(if definite { 2.0 * d as f64 } else { -1.5 });
        let lower: Vec<f64> = (0..d * d).map(|place| wave(place % d, 1 + place / d)).collect();
        let mut next = symmetric(4.0 * d as f64);
        let [mut factors, mut scaled] = [(); 2].map(|()| vec![f64::NAN; d * d]);
        let pivot = PivotMut { factors: &mut factors, lower: &mut scaled };
        if !blocks.eliminate(&schur, &lower, &mut next, pivot, &mut Vec::new()) {
            return None;
        }
        let mut y: Vec<f64> = (0..d).map(|i| wave(i, i)).collect();
        let (mut z, mut ahead) = (vec![f64::NAN; d], vec![0.5; d]);
        blocks.forward(&factors, &mut y, &mut z);
        blocks.subtract(&scaled, &y, &mut ahead);
        let mut x = z.clone();
        blocks.subtract_transposed(&scaled, &ahead, &mut x);
        blocks.backward(&factors, &mut x);
        let lower = |a: &[f64]| -> Vec<f64> {
            (0..d * d).filter(|place| place % d >= place / d).map(|place| a[place]).collect()
        };
        let square = blocks.dot(&y, &z);
        Some([lower(&factors), scaled, lower(&next), y, z, ahead, x, vec![square]].concat())
    }

    fn compare<const D: usize>() {
        let [fixed, any] =
            [step(Fixed::<D>, true), step(Any(D), true)].map(|x| x.expect("definite"));
        // Diagonally dominant blocks: at most D³ operations on numbers below 10.
        let small = 1e-15 * (D * D * D).max(10) as f64;
        for (k, (one, other)) in fixed.iter().zip(&any).enumerate() {
            assert!((one - other).abs() <= small, "D = {D}, number {k}: {one} {other}");
        }
        assert_eq!(fixed.len(), any.len());
        assert!(step(Fixed::<D>, false).is_none() && step(Any(D), false).is_none(), "{D}");
    }

    /// Sizes below, at and beyond those of the panels in which columns are taken together.
    #[test]
    fn blocks_of_any_size_do_what_fixed_ones_do() {
        compare::<1>();
        compare::<2>();
        compare::<3>();
        compare::<4>();
        compare::<5>();
        compare::<6>();
        compare::<7>();
        compare::<8>();
        compare::<9>();
        compare::<11>();
        compare::<12>();
        compare::<13>();
        compare::<16>();
        compare::<19>();
        compare::<33>();
    }
}
