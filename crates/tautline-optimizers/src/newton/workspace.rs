//! `Workspace`: memory that is reused from search to search.

use std::fmt;

use nalgebra::SVector;

use crate::newton::twisted_factorization::TwistedFactorization;

/// Memory for searches. It grows to the size that the largest of them needs, and the next one
/// reuses it.
///
/// A search on a fine grid writes `2D² + 2D` doubles per point and reads them once or twice. In
/// fresh memory, which the system has to find and clear first, this takes longer than computing
/// them.
#[derive(Clone)]
pub struct Workspace<const D: usize> {
    pub(crate) factorization: TwistedFactorization<D>,
    pub(crate) spare: Spare<D>,
}

impl<const D: usize> Default for Workspace<D> {
    /// Returns a workspace without memory.
    fn default() -> Self {
        Self { factorization: TwistedFactorization::default(), spare: Spare(Vec::new()) }
    }
}

impl<const D: usize> fmt::Debug for Workspace<D> {
    /// Shows the number of points for which there is memory; the contents of the memory mean
    /// nothing.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points = self.factorization.capacity();
        f.debug_struct("Workspace").field("points", &points).finish_non_exhaustive()
    }
}

/// Lists of points that are no longer needed.
#[derive(Clone)]
pub(crate) struct Spare<const D: usize>(Vec<Vec<SVector<f64, D>>>);

/// The number of lists that are kept, for a grid and the next coarser ones.
const KEPT: usize = 8;

impl<const D: usize> Spare<D> {
    /// Returns an empty list with room for `count` points. It is a kept list, unless that is so
    /// large that a finer grid needs it more.
    pub(crate) fn take(&mut self, count: usize) -> Vec<SVector<f64, D>> {
        let fits = |list: &Vec<_>| (count..=2 * count).contains(&list.capacity());
        match self.0.iter().position(fits) {
            Some(place) => self.0.swap_remove(place),
            None => Vec::with_capacity(count),
        }
    }

    /// Empties a list and keeps it.
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
    fn a_list_is_reused_unless_it_is_much_too_large() {
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
