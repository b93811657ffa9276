//! Vectors and square matrices at the ends of a curve, in any dimension. Matrices are stored column by
//! column.

use smallvec::SmallVec;

use crate::newton::arithmetic::blocks::Blocks;

/// A vector, which needs no allocation up to six dimensions.
pub(crate) type Vector = SmallVec<[f64; 6]>;

/// A square matrix, column by column, which needs no allocation up to four dimensions.
pub(crate) type Matrix = SmallVec<[f64; 16]>;

/// Returns the number `c` if the matrix is `c I`, for `c = 0` and `c = 1`.
#[inline(always)]
pub(crate) fn multiple_of_identity(blocks: impl Blocks, a: &[f64]) -> Option<f64> {
    let d = blocks.dimension();
    let c = a[0];
    let mut is_multiple = c == 0.0 || c == 1.0;
    for j in 0..d {
        for i in 0..d {
            is_multiple &= a[j * d + i] == if i == j { c } else { 0.0 };
        }
    }
    is_multiple.then_some(c)
}

/// Replaces `x` by `A x`.
#[inline(always)]
pub(crate) fn apply<B: Blocks>(blocks: B, a: &[f64], x: &mut [f64]) {
    let d = blocks.dimension();
    let mut product = blocks.vector();
    let sums = product.as_mut();
    for j in 0..d {
        for i in 0..d {
            sums[i] += a[j * d + i] * x[j];
        }
    }
    x[..d].copy_from_slice(sums);
}

/// Replaces `x` by `Aᵀ x`.
#[inline(always)]
pub(crate) fn apply_transposed<B: Blocks>(blocks: B, a: &[f64], x: &mut [f64]) {
    let d = blocks.dimension();
    let mut product = blocks.vector();
    let sums = product.as_mut();
    for j in 0..d {
        for i in 0..d {
            sums[j] += a[j * d + i] * x[i];
        }
    }
    x[..d].copy_from_slice(sums);
}

/// Replaces `B` by `B A`.
#[inline(always)]
pub(crate) fn multiply<B: Blocks>(blocks: B, b: &mut [f64], a: &[f64]) {
    let d = blocks.dimension();
    let mut product = blocks.block();
    let sums = product.as_mut();
    for k in 0..d {
        for j in 0..d {
            for i in 0..d {
                sums[k * d + i] += b[j * d + i] * a[k * d + j];
            }
        }
    }
    b[..d * d].copy_from_slice(sums);
}

/// Replaces a square matrix by its transpose.
#[inline(always)]
pub(crate) fn transpose(d: usize, a: &mut [f64]) {
    for j in 0..d {
        for i in j + 1..d {
            a.swap(j * d + i, i * d + j);
        }
    }
}

/// Returns `x · y`.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// Returns the largest entry in absolute value.
pub(crate) fn amax(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}
