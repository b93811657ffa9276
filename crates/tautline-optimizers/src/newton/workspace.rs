//! `Workspace`: memory that one search leaves to the next.

use std::fmt;

use nalgebra::SVector;

use crate::newton::twisted_factorization::TwistedFactorization;

/// Memory for searches, which grows with the largest of them and is kept for the next.
///
/// What a search on a fine grid writes down, `2D² + 2D` numbers a point, is written and read
/// once or twice: on fresh memory, which the system has to find and to clear first, that takes
/// longer than to compute it.
#[derive(Clone)]
pub struct Workspace<const D: usize> {
    pub(crate) factorization: TwistedFactorization<D>,
    pub(crate) spare: Spare<D>,
}

impl<const D: usize> Default for Workspace<D> {
    /// Returns a workspace without any memory yet.
    fn default() -> Self {
        Self { factorization: TwistedFactorization::default(), spare: Spare(Vec::new()) }
    }
}

impl<const D: usize> fmt::Debug for Workspace<D> {
    /// For how many points there is room; what is in it means nothing.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points = self.factorization.capacity();
        f.debug_struct("Workspace").field("points", &points).finish_non_exhaustive()
    }
}

/// Lists of points that are not needed any more.
#[derive(Clone)]
pub(crate) struct Spare<const D: usize>(Vec<Vec<SVector<f64, D>>>);

/// So many are kept: those of a grid, and those of the next coarser ones.
const KEPT: usize = 8;

impl<const D: usize> Spare<D> {
    /// Returns an empty list with room for `count` points: one that is there, unless it is so large
    /// that it had better be kept for a finer grid.
    pub(crate) fn take(&mut self, count: usize) -> Vec<SVector<f64, D>> {
        let fits = |list: &Vec<_>| (count..=2 * count).contains(&list.capacity());
        match self.0.iter().position(fits) {
            Some(place) => self.0.swap_remove(place),
            None => Vec::with_capacity(count),
        }
    }

    /// Keeps a list, without its points.
    pub(crate) fn give(&mut self, mut list: Vec<SVector<f64, D>>) {
        list.clear();
        self.0.push(list);
        if self.0.len() > KEPT {
            self.0.remove(0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{KEPT, Workspace};

    #[test]
    fn a_list_comes_back_for_as_many_points_and_not_for_few() {
        let mut spare = Workspace::<2>::default().spare;
        spare.give(Vec::with_capacity(100));
        assert!(spare.take(49).capacity() < 100);
        assert_eq!(spare.take(51).capacity(), 100);
        for _ in 0..2 * KEPT {
            spare.give(Vec::with_capacity(10));
        }
        assert_eq!(spare.0.len(), KEPT);
    }
}
