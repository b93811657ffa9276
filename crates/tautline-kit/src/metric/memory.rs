//! `Memory`: what several laws need, and is computed once.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use tautline_statements::{Reconstruction, VerifyError};

use super::{claims::Found, problems::Posed};
use crate::{Claim, Failure};

/// Values by their keys, which are few: it is searched from the front.
#[derive(Debug)]
pub(super) struct Memory<K, V>(Mutex<Vec<(K, Arc<OnceLock<V>>)>>);

impl<K, V> Default for Memory<K, V> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: PartialEq + Clone, V: Clone> Memory<K, V> {
    /// Returns the value of a key, computed if it is asked for the first time. Who asks for the
    /// same meanwhile waits.
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

/// A distance, in `m`, and how far it may be off.
pub(super) type Estimate = Result<[f64; 2], VerifyError>;

/// A problem that was solved.
#[derive(Debug)]
pub(super) struct Solution<const D: usize> {
    /// The distance, in `m`, and how far it may be off.
    pub(super) distance: [f64; 2],
    /// The minimisers of a rule, one for each `N` of the effort.
    pub(super) minimisers: Vec<Reconstruction<D>>,
}

/// The solution of a problem, or why there is none.
pub(super) type Solutions<const D: usize> = Result<Arc<Solution<D>>, VerifyError>;

/// What was computed so far of one metric: the extreme values that its constants bound, the
/// distances of its problems, and the minimisers of either rule.
#[derive(Debug)]
pub(super) struct Solved<const D: usize> {
    /// The name of a law of the formula that does not hold, for which nothing is solved.
    pub(super) broken: OnceLock<Option<&'static str>>,
    pub(super) extremes: Memory<Claim, Result<Option<Found>, Failure>>,
    pub(super) distances: Memory<Posed<D>, Estimate>,
    pub(super) trapezoidal: Memory<Posed<D>, Solutions<D>>,
    pub(super) left: Memory<Posed<D>, Solutions<D>>,
}

impl<const D: usize> Default for Solved<D> {
    fn default() -> Self {
        Self {
            broken: OnceLock::new(),
            extremes: Memory::default(),
            distances: Memory::default(),
            trapezoidal: Memory::default(),
            left: Memory::default(),
        }
    }
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
