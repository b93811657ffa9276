//! The factorisation of a block-tridiagonal matrix from both of its ends at once.

use nalgebra::SVector;
use tautline_metrics::{Lanes, Pair};

use crate::newton::{factorization::Pivot, ldl::Ldl};

/// The factorisation by blocks of a positive definite block-tridiagonal matrix, from both ends
/// towards the middle: block `n` from the front and block `N − n` from the back are eliminated side
/// by side, and then what is left between them. Also known as two-sided elimination, and as
/// burning at both ends.
#[derive(Clone, Debug, Default)]
pub(crate) struct TwistedFactorization<const D: usize> {
    /// Of the blocks `n` and `N − n`, from the ends on.
    pub(crate) pairs: Vec<Pivot<D, Pair>>,
    /// Of those between, each by itself, from the front to the back.
    pub(crate) middle: Vec<Pivot<D>>,
    /// Of the block that is left.
    pub(crate) last: Option<Ldl<D>>,
}

impl<const D: usize> TwistedFactorization<D> {
    /// Forgets everything but the memory, and makes room for so many.
    pub(crate) fn clear(&mut self, pairs: usize, middle: usize) {
        self.pairs.clear();
        self.pairs.reserve_exact(pairs);
        self.middle.clear();
        self.middle.reserve_exact(middle);
        self.last = None;
    }

    /// For how many blocks there is room.
    pub(crate) fn capacity(&self) -> usize {
        2 * self.pairs.capacity() + self.middle.capacity()
    }

    /// Eliminates a right hand side `b`, which it uses up; returns `½ bᵀ A⁻¹ b = ½ Σ yₙᵀ Dₙ⁻¹ yₙ`:
    /// nothing need be substituted back for it.
    pub(crate) fn half_square(&self, b: &mut [SVector<f64, D>]) -> f64 {
        let Some(end) = b.len().checked_sub(1) else { return 0.0 };
        let (front, back) = (self.pairs.len(), end - self.pairs.len());
        let mut square = 0.0;
        for (n, pivot) in self.pairs.iter().enumerate() {
            let mut change = SVector::zeros();
            let [y, z] = pivot.forward(b[n].zip_map(&b[end - n], Pair::new), &mut change);
            // One after the other: the last two may meet at the same block.
            b[n + 1] += change.map(|x| x.lane(0));
            b[end - n - 1] += change.map(|x| x.lane(1));
            let both = y.dot(&z);
            square += both.lane(0) + both.lane(1);
        }
        for (n, pivot) in self.middle.iter().enumerate() {
            let mut next = b[front + n + 1];
            let [y, z] = pivot.forward(b[front + n], &mut next);
            b[front + n + 1] = next;
            square += y.dot(&z);
        }
        if let Some(last) = &self.last {
            let [y, z] = last.forward(b[back]);
            square += y.dot(&z);
        }
        0.5 * square
    }

    /// Overwrites the `zₙ` that elimination has made of a right hand side with the solution.
    pub(crate) fn substitute_back(&self, z: &mut [SVector<f64, D>]) {
        let Some(end) = z.len().checked_sub(1) else { return };
        let (front, back) = (self.pairs.len(), end - self.pairs.len());
        if let Some(last) = &self.last {
            z[back] = last.backward(z[back]);
        }
        for (n, pivot) in self.middle.iter().enumerate().rev() {
            z[front + n] = pivot.backward(z[front + n], &z[front + n + 1]);
        }
        let mut x = z[front].zip_map(&z[back], Pair::new);
        for (n, pivot) in self.pairs.iter().enumerate().rev() {
            x = pivot.backward(z[n].zip_map(&z[end - n], Pair::new), &x);
            z[n] = x.map(|x| x.lane(0));
            z[end - n] = x.map(|x| x.lane(1));
        }
    }
}
