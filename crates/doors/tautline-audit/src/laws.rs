//! The laws of the kit as values, so that an audit can stop between two of them.

use tautline_kit::{Fault, Outcome, metric};

use crate::{
    answer::{Law, Status},
    typed::Case,
};

/// A law of the kit.
#[derive(Clone, Copy)]
pub(crate) struct KitLaw<const D: usize> {
    pub(crate) id: &'static str,
    pub(crate) says: &'static str,
    pub(crate) check: fn(&Case<D>) -> Outcome,
}

macro_rules! table {
    ({} $($id:ident, $says:literal, $run:expr;)*) => {
        /// Returns all laws, in the order of the kit.
        pub(crate) fn laws<const D: usize>() -> Vec<KitLaw<D>> {
            vec![$(KitLaw { id: stringify!($id), says: $says, check: metric::$id }),*]
        }
    };
}

tautline_kit::__metric_laws! { [table] {} }

/// The laws that are about the formula alone.
pub(crate) const OF_THE_FORMULA: [&str; 3] =
    ["is_finite_and_symmetric", "is_positive_definite", "jets_agree_with_differences"];

/// The last law that is about the formula and its constants alone. Those after it pose problems.
pub(crate) const LAST_OF_THE_CLAIMS: &str = "no_constant_is_refuted";

impl Law {
    /// Returns a law that is not tried.
    pub(crate) fn not_tried<const D: usize>(law: &KitLaw<D>, why: &str) -> Self {
        Self {
            law: law.id,
            says: law.says,
            status: Status::NotTried,
            cases: 0,
            could_fail: 0,
            overestimation: None,
            assumed: Vec::new(),
            reason: Some(why.to_owned()),
            sample: None,
        }
    }

    /// Returns the law with its outcome.
    pub(crate) fn tried(outcome: Outcome) -> Self {
        let Outcome { id, law, cases, could_fail, overestimation, assumed, note, failure, .. } =
            outcome;
        let found = Self {
            law: id,
            says: law,
            status: Status::Holds,
            cases,
            could_fail,
            overestimation: overestimation.is_finite().then_some(overestimation),
            assumed,
            reason: note,
            sample: None,
        };
        match failure {
            None if cases == 0 && found.reason.is_some() => {
                Self { status: Status::DoesNotApply, ..found }
            }
            None => found,
            Some(failure) => {
                let status = match failure.fault {
                    Fault::NotTried { .. } => Status::NotTried,
                    Fault::Statement { hypothesis: true, .. } => Status::FalseHypothesis,
                    _ => Status::Fails,
                };
                let reason = failure.fault.to_string();
                let reason = reason.strip_prefix("not tried: ").unwrap_or(&reason).to_owned();
                Self { status, reason: Some(reason), sample: failure.sample, ..found }
            }
        }
    }
}
