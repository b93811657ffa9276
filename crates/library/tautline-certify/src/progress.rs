//! `Progress` of a search, and `Watch`, which is told of it and may end it.

use crate::Quantity;

/// How far the search for one constant has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The constant in question.
    pub quantity: Quantity,
    /// The number of boxes evaluated so far.
    pub boxes: usize,
    /// A bound on the constant that is proved so far: from below for `c₁`, from above for the
    /// others; infinite if there is none.
    pub bound: f64,
    /// The value at the best point found so far, up to rounding; infinite if there is none. The
    /// constant lies between the two.
    pub value: f64,
}

/// Is told of the progress of searches, and may end them. It holds no clock: a time limit is kept
/// by a flag that someone else sets.
///
/// ```
/// use std::sync::atomic::{AtomicBool, Ordering};
/// use tautline_certify::{Accuracy, CertifyError, Domain, Progress, Quantity, certify_by_formula};
/// use tautline_formula::Formula;
/// use tautline_metrics::gallery::Valleys;
///
/// let stop = AtomicBool::new(true);
/// let watch = |_: Progress| !stop.load(Ordering::Relaxed);
/// let valleys = Formula::<2>::record(&Valleys)?.into_any();
/// let space = Domain::space_by_formula(&valleys);
/// let accuracy = Accuracy::default();
/// let found = certify_by_formula(&valleys, Quantity::LH, &space, accuracy, &watch);
/// // What is known when the search ends is valid.
/// let Err(CertifyError::BudgetSpent { upper, .. }) = found else { panic!("{found:?}") };
/// assert!(upper >= 4.40);
/// # Ok::<(), tautline_formula::RecordError>(())
/// ```
pub trait Watch: Sync {
    /// Is called after every round of boxes. The search goes on if it returns true; otherwise it
    /// ends as if the budget was spent.
    fn goes_on(&self, progress: Progress) -> bool;

    /// Returns whether `M_H`, the most expensive constant, is worth a search where constants [within
    /// the budget](crate::CertifiedConstants::within_budget) are enough.
    fn needs_m_h(&self) -> bool {
        true
    }
}

impl<F: Fn(Progress) -> bool + Sync> Watch for F {
    fn goes_on(&self, progress: Progress) -> bool {
        self(progress)
    }
}

/// Never ends a search.
pub(crate) fn unwatched(_: Progress) -> bool {
    true
}
