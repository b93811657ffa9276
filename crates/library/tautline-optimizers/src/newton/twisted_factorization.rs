//! `TwistedFactorization`: the factorisation of a block-tridiagonal matrix from both ends.

use nalgebra::SVector;
use tautline_metrics::{Lanes, Pair, Scalar};

use crate::newton::{
    arithmetic::blocks::{Blocks, PivotMut, with_blocks},
    arithmetic::small::Vector,
    factorization::Pivot,
};

/// The block factorisation of a positive definite block-tridiagonal matrix, from both ends towards
/// the middle. It eliminates block `n` from the front and block `N − n` from the back for
/// `n < ⌊N/2⌋`, and then the one or two blocks between them. It is also known as two-sided
/// elimination, or burning at both ends.
///
/// The two sides are eliminated either in the lanes of a register, as `pairs`, or separately, as
/// `sides`.
#[derive(Clone, Debug, Default)]
pub(crate) struct TwistedFactorization {
    dimension: usize,
    /// The number of blocks that are eliminated from each end, before those in the middle.
    half: usize,
    /// The pivots of the blocks `n` and `N − n`, from the ends on.
    pub(crate) pairs: Pairs,
    /// The pivots of the blocks from the front, and of those from the back.
    pub(crate) sides: [Pivots; 2],
    /// The pivot of the first of two blocks in the middle, if there are two.
    pub(crate) middle: Pivots,
    /// The factors of the last block.
    pub(crate) last: Vec<f64>,
}

/// The pivots of some blocks, one after the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pivots {
    /// The factors of the Schur complements.
    factors: Vec<f64>,
    /// The blocks `Wₙ Dₙ⁻¹`.
    lower: Vec<f64>,
}

impl Pivots {
    /// Provides memory for this number of blocks of some size, which are to be overwritten.
    pub(crate) fn resize(&mut self, blocks: usize, size: usize) {
        for list in [&mut self.factors, &mut self.lower] {
            list.reserve_exact((blocks * size).saturating_sub(list.len()));
            list.resize(blocks * size, 0.0);
        }
    }

    /// Returns pivot `k` for writing.
    #[inline(always)]
    pub(crate) fn get_mut(&mut self, k: usize, size: usize) -> PivotMut<'_> {
        PivotMut {
            factors: &mut self.factors[k * size..][..size],
            lower: &mut self.lower[k * size..][..size],
        }
    }

    /// Returns the two blocks of pivot `k`.
    #[inline(always)]
    fn get(&self, k: usize, size: usize) -> [&[f64]; 2] {
        [&self.factors[k * size..][..size], &self.lower[k * size..][..size]]
    }

    fn capacity(&self) -> usize {
        self.factors.capacity() + self.lower.capacity()
    }
}

/// The pivots of pairs of blocks, in each of the dimensions in which both sides share the lanes of a
/// register. Only the pivots of one dimension are in use.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pairs {
    one: Vec<Pivot<1, Pair>>,
    two: Vec<Pivot<2, Pair>>,
    three: Vec<Pivot<3, Pair>>,
}

/// A list of pivots of pairs in `R^D`.
pub(crate) trait InLanes<const D: usize> {
    fn pivots(&self) -> &[Pivot<D, Pair>];
    fn pivots_mut(&mut self) -> &mut Vec<Pivot<D, Pair>>;
}

macro_rules! in_lanes {
    ($($dimension:literal $list:ident),*) => {$(
        impl InLanes<$dimension> for Pairs {
            fn pivots(&self) -> &[Pivot<$dimension, Pair>] {
                &self.$list
            }

            fn pivots_mut(&mut self) -> &mut Vec<Pivot<$dimension, Pair>> {
                &mut self.$list
            }
        }
    )*};
}
in_lanes!(1 one, 2 two, 3 three);

impl Pairs {
    fn bytes(&self) -> usize {
        self.one.capacity() * size_of::<Pivot<1, Pair>>()
            + self.two.capacity() * size_of::<Pivot<2, Pair>>()
            + self.three.capacity() * size_of::<Pivot<3, Pair>>()
    }
}

impl TwistedFactorization {
    /// Provides memory for a factorisation in lanes, with so many pairs of blocks.
    pub(crate) fn clear_pairs<const D: usize>(&mut self, pairs: usize)
    where
        Pairs: InLanes<D>,
    {
        self.clear(D, pairs);
        let list = self.pairs.pivots_mut();
        list.reserve_exact(pairs.saturating_sub(list.len()));
        list.resize(pairs, Pivot::zero());
    }

    /// Provides memory for a factorisation from one end after the other, with so many blocks on each
    /// side.
    pub(crate) fn clear_sides(&mut self, dimension: usize, on_each_side: usize) {
        self.clear(dimension, on_each_side);
        self.sides.iter_mut().for_each(|side| side.resize(on_each_side, dimension * dimension));
    }

    fn clear(&mut self, dimension: usize, half: usize) {
        (self.dimension, self.half) = (dimension, half);
        self.middle.resize(0, 0);
        self.last.clear();
        self.last.resize(dimension * dimension, 0.0);
    }

    /// Returns the allocated memory, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let sides: usize = self.sides.iter().map(Pivots::capacity).sum();
        self.pairs.bytes() + sides * size_of::<f64>()
    }

    fn size(&self) -> usize {
        self.dimension * self.dimension
    }

    fn has_middle(&self) -> bool {
        !self.middle.factors.is_empty()
    }

    /// Returns `½ bᵀ A⁻¹ b = ½ Σ yₙᵀ Dₙ⁻¹ yₙ`, which needs no back substitution.
    pub(crate) fn half_square(&self, b: &[f64]) -> f64 {
        match self.dimension {
            1 => self.half_square_of(self.by_pairs::<1>(b), b),
            2 => self.half_square_of(self.by_pairs::<2>(b), b),
            3 => self.half_square_of(self.by_pairs::<3>(b), b),
            d => {
                let end = b.len() / d - 1;
                let [front, back] = &self.sides;
                let sides = with_blocks!(d, blocks => [
                    self.by_side(blocks, front, |n| &b[n * d..][..d]),
                    self.by_side(blocks, back, |n| &b[(end - n) * d..][..d]),
                ]);
                self.half_square_of(sides, b)
            }
        }
    }

    /// Eliminates the right hand sides of all pairs. Returns, for both sides, `Σ yₙᵀ Dₙ⁻¹ yₙ` and the
    /// contribution to the right hand side of the block behind them.
    fn by_pairs<const D: usize>(&self, b: &[f64]) -> [(f64, Vector); 2]
    where
        Pairs: InLanes<D>,
    {
        let b: &[SVector<f64, D>] = bytemuck::cast_slice(b);
        let end = b.len() - 1;
        let (mut square, mut carried) = (Pair::constant(0.0), SVector::<Pair, D>::zeros());
        for (n, pivot) in self.pairs.pivots().iter().enumerate() {
            let here = b[n].zip_map(&b[end - n], Pair::new) + carried;
            carried = SVector::zeros();
            let [y, z] = pivot.forward(here, &mut carried);
            square += y.dot(&z);
        }
        [0, 1].map(|lane| (square.lane(lane), carried.iter().map(|x| x.lane(lane)).collect()))
    }

    /// Eliminates the right hand sides of one side.
    fn by_side<'b>(
        &self,
        blocks: impl Blocks,
        pivots: &Pivots,
        right: impl Fn(usize) -> &'b [f64],
    ) -> (f64, Vector) {
        let d = blocks.dimension();
        let [mut y, mut z, mut carried] = [(); 3].map(|()| blocks.vector());
        let (y, z, carried) = (y.as_mut(), z.as_mut(), carried.as_mut());
        let mut square = 0.0;
        for n in 0..self.half {
            let [factors, lower] = pivots.get(n, d * d);
            let right = right(n);
            for i in 0..d {
                y[i] = right[i] + carried[i];
                carried[i] = 0.0;
            }
            blocks.forward(factors, y, z);
            blocks.subtract(lower, y, carried);
            square += blocks.dot(y, z);
        }
        (square, Vector::from_slice(carried))
    }

    /// Adds the blocks in the middle.
    fn half_square_of(&self, [(front, left), (back, right)]: [(f64, Vector); 2], b: &[f64]) -> f64 {
        with_blocks!(self.dimension, blocks => {
            let (d, half) = (self.dimension, self.half);
            let end = b.len() / d - 1;
            let add = |x: &[f64], y: &[f64]| -> Vector { x.iter().zip(y).map(|(x, y)| x + y).collect() };
            let mut square = front + back;
            let mut next = add(&b[half * d..][..d], &left);
            let mut z = Vector::from_elem(0.0, d);
            if self.has_middle() {
                let [factors, lower] = self.middle.get(0, self.size());
                let mut y = std::mem::replace(&mut next, Vector::from_slice(&b[(end - half) * d..][..d]));
                blocks.forward(factors, &mut y, &mut z);
                blocks.subtract(lower, &y, &mut next);
                square += blocks.dot(&y, &z);
            }
            let mut y = add(&next, &right);
            blocks.forward(&self.last, &mut y, &mut z);
            square += blocks.dot(&y, &z);
            0.5 * square
        })
    }

    /// Overwrites `zₙ`, the right hand side after elimination, with the solution.
    pub(crate) fn substitute_back(&self, z: &mut [f64]) {
        with_blocks!(self.dimension, blocks => self.substitute_middle(blocks, z));
        match self.dimension {
            1 => self.substitute_pairs::<1>(z),
            2 => self.substitute_pairs::<2>(z),
            3 => self.substitute_pairs::<3>(z),
            dimension => with_blocks!(dimension, blocks => self.substitute_sides(blocks, z)),
        }
    }

    fn substitute_middle(&self, blocks: impl Blocks, z: &mut [f64]) {
        let (d, half) = (self.dimension, self.half);
        let end = z.len() / d - 1;
        let (first, last) = z.split_at_mut((end - half) * d);
        blocks.backward(&self.last, &mut last[..d]);
        if self.has_middle() {
            let [factors, lower] = self.middle.get(0, self.size());
            let here = &mut first[half * d..][..d];
            blocks.subtract_transposed(lower, &last[..d], here);
            blocks.backward(factors, here);
        }
    }

    fn substitute_pairs<const D: usize>(&self, z: &mut [f64])
    where
        Pairs: InLanes<D>,
    {
        let z: &mut [SVector<f64, D>] = bytemuck::cast_slice_mut(z);
        let (half, end) = (self.half, z.len() - 1);
        let mut x = z[half].zip_map(&z[end - half], Pair::new);
        for (n, pivot) in self.pairs.pivots().iter().enumerate().rev() {
            x = pivot.backward(z[n].zip_map(&z[end - n], Pair::new), &x);
            z[n] = x.map(|x| x.lane(0));
            z[end - n] = x.map(|x| x.lane(1));
        }
    }

    fn substitute_sides(&self, blocks: impl Blocks, z: &mut [f64]) {
        let d = blocks.dimension();
        let end = z.len() / d - 1;
        let [front, back] = &self.sides;
        for n in (0..self.half).rev() {
            let [factors, lower] = front.get(n, d * d);
            let (here, behind) = z[n * d..].split_at_mut(d);
            blocks.subtract_transposed(lower, &behind[..d], here);
            blocks.backward(factors, here);
            let [factors, lower] = back.get(n, d * d);
            let (behind, here) = z[(end - n - 1) * d..].split_at_mut(d);
            blocks.subtract_transposed(lower, behind, &mut here[..d]);
            blocks.backward(factors, &mut here[..d]);
        }
    }

    /// Keeps the pivot of the first of two blocks in the middle.
    pub(crate) fn keep_middle<const D: usize>(&mut self, pivot: &Pivot<D>) {
        self.middle.resize(1, D * D);
        self.middle.factors.copy_from_slice(pivot.diagonal.factors.as_slice());
        self.middle.lower.copy_from_slice(pivot.lower.as_slice());
    }
}

#[cfg(test)]
mod tests {
    use super::TwistedFactorization;

    #[test]
    fn a_pair_takes_as_much_memory_as_two_blocks() {
        let (mut pairs, mut sides) =
            (TwistedFactorization::default(), TwistedFactorization::default());
        pairs.clear_pairs::<2>(10);
        sides.clear_sides(2, 10);
        assert_eq!((pairs.bytes(), sides.bytes()), (20 * 2 * 4 * 8, 20 * 2 * 4 * 8));
        assert_eq!(TwistedFactorization::default().bytes(), 0);
    }
}
