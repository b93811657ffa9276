//! `Derivatives`: the derivatives of one step.

use std::collections::BTreeMap;

use crate::operation::Step;

/// The coordinates with respect to which a derivative is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum By {
    /// `∂ₖ`.
    One(usize),
    /// `∂ₖ∂ₗ` with `k ≤ l`.
    Two(usize, usize),
}

/// The first and second derivatives, without those that are 0.
#[derive(Clone, Debug, Default)]
pub(crate) struct Derivatives(pub(super) BTreeMap<By, Step>);

impl Derivatives {
    /// Returns `∂ₖ`; `None` is 0.
    pub(crate) fn first(&self, k: usize) -> Option<Step> {
        self.0.get(&By::One(k)).copied()
    }

    /// Returns `∂ₖ∂ₗ` with `k ≤ l`; `None` is 0.
    pub(crate) fn second(&self, (k, l): (usize, usize)) -> Option<Step> {
        self.0.get(&By::Two(k, l)).copied()
    }

    pub(super) fn firsts(&self) -> impl Iterator<Item = (usize, Step)> {
        self.0.iter().map_while(|(&by, &step)| match by {
            By::One(k) => Some((k, step)),
            By::Two(..) => None,
        })
    }

    pub(super) fn seconds(&self) -> impl Iterator<Item = (By, Step)> {
        self.0.iter().filter(|(by, _)| matches!(by, By::Two(..))).map(|(&by, &step)| (by, step))
    }
}
