//! `TwistedFactorization`: the factorisation of a block-tridiagonal matrix from both ends.

use nalgebra::SVector;
use tautline_metrics::{Lanes, Pair};

use crate::newton::{factorization::Pivot, ldl::Ldl};

/// The block factorisation of a positive definite block-tridiagonal matrix, from both ends towards
/// the middle. It eliminates block `n` from the front and block `N − n` from the back for
/// `n < ⌊N/2⌋`, and then the one or two blocks between them. It is also known as two-sided
/// elimination, or burning at both ends.
///
/// The two sides are eliminated either in the lanes of a register, as `pairs`, or separately, as
/// `sides`.
#[derive(Clone, Debug, Default)]
pub(crate) struct TwistedFactorization<const D: usize> {
    /// The pivots of the blocks `n` and `N − n`, from the ends on.
    pub(crate) pairs: Vec<Pivot<D, Pair>>,
    /// The pivots of the blocks from the front, and of those from the back.
    pub(crate) sides: [Vec<Pivot<D>>; 2],
    /// The pivot of the first of two blocks in the middle.
    pub(crate) middle: Option<Pivot<D>>,
    /// The factorisation of the last block.
    pub(crate) last: Option<Ldl<D>>,
}

impl<const D: usize> TwistedFactorization<D> {
    /// Provides `pairs`, which are to be overwritten, and empty `sides` with room for
    /// `on_each_side` pivots.
    pub(crate) fn clear(&mut self, pairs: usize, on_each_side: usize) {
        self.pairs.reserve_exact(pairs.saturating_sub(self.pairs.len()));
        self.pairs.resize(pairs, Pivot::zero());
        for side in &mut self.sides {
            side.clear();
            side.reserve_exact(on_each_side);
        }
        (self.middle, self.last) = (None, None);
    }

    /// Returns the allocated memory, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let sides: usize = self.sides.iter().map(Vec::capacity).sum();
        self.pairs.capacity() * size_of::<Pivot<D, Pair>>() + sides * size_of::<Pivot<D>>()
    }

    /// Returns the number of blocks for which there is memory.
    pub(crate) fn capacity(&self) -> usize {
        2 * self.pairs.capacity() + self.sides.iter().map(Vec::capacity).sum::<usize>()
    }

    /// Returns the number of blocks that are eliminated from each end, before those in the middle.
    fn half(&self) -> usize {
        self.pairs.len() + self.sides[0].len()
    }

    /// Returns `½ bᵀ A⁻¹ b = ½ Σ yₙᵀ Dₙ⁻¹ yₙ`, which needs no back substitution.
    pub(crate) fn half_square(&self, b: &[SVector<f64, D>]) -> f64 {
        let (half, end) = (self.half(), b.len() - 1);
        let [(front, left), (back, right)] = if self.sides[0].is_empty() {
            let both = |n: usize| b[n].zip_map(&b[end - n], Pair::new);
            let (square, carried) = eliminate(&self.pairs, both);
            [0, 1].map(|lane| (square.lane(lane), carried.map(|x| x.lane(lane))))
        } else {
            let [front, back] = &self.sides;
            [eliminate(front, |n| b[n]), eliminate(back, |n| b[end - n])]
        };
        let mut square = front + back;
        let mut next = b[half] + left;
        if let Some(middle) = &self.middle {
            let here = std::mem::replace(&mut next, b[end - half]);
            let [y, z] = middle.forward(here, &mut next);
            square += y.dot(&z);
        }
        if let Some(last) = &self.last {
            let [y, z] = last.forward(next + right);
            square += y.dot(&z);
        }
        0.5 * square
    }

    /// Overwrites `zₙ`, the right hand side after elimination, with the solution.
    pub(crate) fn substitute_back(&self, z: &mut [SVector<f64, D>]) {
        let (half, end) = (self.half(), z.len() - 1);
        if let Some(last) = &self.last {
            z[end - half] = last.backward(z[end - half]);
        }
        if let Some(middle) = &self.middle {
            z[half] = middle.backward(z[half], &z[end - half]);
        }
        let behind = [z[half], z[end - half]];
        let mut x = behind[0].zip_map(&behind[1], Pair::new);
        for (n, pivot) in self.pairs.iter().enumerate().rev() {
            x = pivot.backward(z[n].zip_map(&z[end - n], Pair::new), &x);
            z[n] = x.map(|x| x.lane(0));
            z[end - n] = x.map(|x| x.lane(1));
        }
        let [front, back] = &self.sides;
        let (first, second) = z.split_at_mut(end + 1 - half);
        substitute(front, first.iter_mut().take(half).rev(), behind[0]);
        substitute(back, second.iter_mut(), behind[1]);
    }
}

/// Eliminates the right hand sides of some blocks. Returns `Σ yₙᵀ Dₙ⁻¹ yₙ` and the contribution to
/// the right hand side of the block behind them.
fn eliminate<T: Lanes, const D: usize>(
    pivots: &[Pivot<D, T>],
    right: impl Fn(usize) -> SVector<T, D>,
) -> (T, SVector<T, D>) {
    let (mut square, mut carried) = (T::zero(), SVector::zeros());
    for (n, pivot) in pivots.iter().enumerate() {
        let here = right(n) + carried;
        carried = SVector::zeros();
        let [y, z] = pivot.forward(here, &mut carried);
        square += y.dot(&z);
    }
    (square, carried)
}

/// Substitutes `behind`, the solution at the block behind the last one, back to the first. `z` runs
/// over the blocks from the last to the first.
fn substitute<'a, const D: usize>(
    pivots: &[Pivot<D>],
    z: impl Iterator<Item = &'a mut SVector<f64, D>>,
    behind: SVector<f64, D>,
) {
    let mut x = behind;
    for (pivot, z) in pivots.iter().rev().zip(z) {
        x = pivot.backward(*z, &x);
        *z = x;
    }
}

#[cfg(test)]
mod tests {
    use super::TwistedFactorization;

    #[test]
    fn a_pair_takes_as_much_memory_as_two_blocks() {
        let memory = |pairs, on_each_side| {
            let mut factorization = TwistedFactorization::<2>::default();
            factorization.clear(pairs, on_each_side);
            (factorization.bytes(), factorization.capacity())
        };
        let (bytes, capacity) = memory(10, 0);
        assert_eq!(memory(0, 10), (bytes, capacity));
        assert_eq!(memory(20, 0), (2 * bytes, 2 * capacity));
        assert_eq!((capacity, memory(0, 0)), (20, (0, 0)));
    }
}
