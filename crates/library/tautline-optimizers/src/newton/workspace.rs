//! `Workspace`: memory that is reused from search to search.

use std::{
    fmt,
    sync::{Arc, atomic::AtomicBool},
};

use crate::newton::twisted_factorization::TwistedFactorization;

/// Memory for searches, in any dimension. It grows to the size that the largest of them needs, and the next one
/// reuses it.
///
/// A search on a fine grid writes `2D² + 2D` doubles per point and reads them once or twice. In
/// fresh memory, which the system has to find and clear first, this takes longer than computing
/// them.
#[derive(Clone, Default)]
pub struct Workspace {
    pub(crate) factorization: TwistedFactorization,
    pub(crate) spare: Spare,
    pub(crate) ended: Option<Arc<AtomicBool>>,
}

impl Workspace {
    /// Ends searches in this memory, with [`SolveError::Interrupted`](crate::SolveError::Interrupted), once the
    /// flag is true. A search without a watcher looks at it before each step.
    #[must_use]
    pub fn ended_by(self, flag: Arc<AtomicBool>) -> Self {
        Self { ended: Some(flag), ..self }
    }
}

impl fmt::Debug for Workspace {
    /// Shows the size of the memory for factorisations; its contents mean nothing.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bytes = self.factorization.bytes();
        f.debug_struct("Workspace").field("bytes", &bytes).finish_non_exhaustive()
    }
}

/// Lists of coordinates that are no longer needed.
#[derive(Clone, Default)]
pub(crate) struct Spare(Vec<Vec<f64>>);

/// The number of lists that are kept, for a grid and the next coarser ones.
const KEPT: usize = 8;

impl Spare {
    /// Returns an empty list with room for `count` coordinates. It is a kept list, unless that is so
    /// large that a finer grid needs it more.
    pub(crate) fn take(&mut self, count: usize) -> Vec<f64> {
        let fits = |list: &Vec<_>| (count..=2 * count).contains(&list.capacity());
        match self.0.iter().position(fits) {
            Some(place) => self.0.swap_remove(place),
            None => Vec::with_capacity(count),
        }
    }

    /// Empties a list and keeps it.
    pub(crate) fn give(&mut self, mut list: Vec<f64>) {
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
        let mut spare = Workspace::default().spare;
        spare.give(Vec::with_capacity(100));
        assert!(spare.take(49).capacity() < 100);
        assert_eq!(spare.take(51).capacity(), 100);
        for _ in 0..2 * KEPT {
            spare.give(Vec::with_capacity(10));
        }
        assert_eq!(spare.0.len(), KEPT);
    }
}
