//! `Memory`: results that several laws share and that are computed only once.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use tautline_statements::{PaperRule, Reconstruction, VerifyError};

use super::{claims::Found, problems::Posed, proved_distances::ProvedDistance};
use crate::{Claim, Failure};

/// A map from keys to values. There are only a few keys, so the search is linear.
#[derive(Debug)]
pub(super) struct Memory<K, V>(Mutex<Vec<(K, Arc<OnceLock<V>>)>>);

impl<K, V> Default for Memory<K, V> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: PartialEq + Clone, V: Clone> Memory<K, V> {
    /// Returns the value for a key, which the first call computes; concurrent calls wait for it.
    pub(super) fn recall(&self, key: &K, compute: impl FnOnce() -> V) -> V {
        self.place(key).get_or_init(compute).clone()
    }

    fn place(&self, key: &K) -> Arc<OnceLock<V>> {
        // Nothing panics while the list is locked.
        let mut entries = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, place)) = entries.iter().find(|(other, _)| other == key) {
            return Arc::clone(place);
        }
        let place = Arc::default();
        entries.push((key.clone(), Arc::clone(&place)));
        place
    }
}

/// A distance and its error bound, in `m`.
pub(super) type Estimate = Result<[f64; 2], VerifyError>;

/// A solved problem.
#[derive(Debug)]
pub(super) struct Solution<const D: usize> {
    /// The distance and its error bound, in `m`.
    pub(super) distance: [f64; 2],
    /// The minimisers of one rule, one for each `N` of the effort.
    pub(super) minimisers: Vec<Reconstruction<D>>,
}

/// The solution of a problem, or the reason why it has none.
pub(super) type Solutions<const D: usize> = Result<Arc<Solution<D>>, VerifyError>;

/// The results computed so far for one metric: the extreme values that its constants bound, the
/// distances of its problems, and the minimisers for both rules.
#[derive(Debug, Default)]
pub(super) struct Solved<const D: usize> {
    /// The law of the formula that fails, if there is one; in this case nothing is solved.
    pub(super) broken: OnceLock<Option<&'static str>>,
    pub(super) extremes: Memory<Claim, Result<Option<Found>, Failure>>,
    pub(super) distances: Memory<Posed<D>, Estimate>,
    pub(super) minimisers: Memory<(PaperRule, Posed<D>), Solutions<D>>,
    /// A distance with its proof, for a metric that knows none.
    pub(super) proved: OnceLock<Option<ProvedDistance<D>>>,
}

#[cfg(test)]
mod tests {
    use super::Memory;

    #[test]
    fn a_value_is_computed_once() {
        let memory = Memory::default();
        assert_eq!(memory.recall(&1, || "one"), "one");
        assert_eq!(memory.recall(&2, || "two"), "two");
        assert_eq!(memory.recall(&1, || panic!("computed again")), "one");
    }
}
