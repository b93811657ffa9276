//! Runs the kit on everything that the project provides, and on what the kit must refuse.

/// Declares a metric with this formula.
macro_rules! formula {
    ($name:ident, $d:literal, |$x:ident| $h:expr) => {
        struct $name;
        impl Metric<$d> for $name {
            fn gram<S: Scalar>(&self, $x: &SVector<S, $d>) -> SMatrix<S, $d, $d> {
                $h
            }
        }
    };
}

mod composition;
mod gallery;
mod inventory;
mod newcomer;
mod proofs;
mod proved;
mod rules;
mod sets;
mod without_constants;
mod wrong_constants;
mod wrong_hypotheses;
mod wrong_sets;

use tautline::{Bounded, Constants};
use tautline_kit::{Claim, Fault, Outcome};
use tautline_statements::WithConstants;

/// Returns the fault of a law; panics if the law holds.
#[track_caller]
fn fault(outcome: Outcome) -> Fault {
    outcome.failure.unwrap_or_else(|| panic!("{} holds", outcome.id)).fault
}

/// Returns the inequality that is violated; panics if the law holds.
#[track_caller]
fn broken(outcome: Outcome) -> &'static str {
    match fault(outcome) {
        Fault::Broken { law, .. } => law,
        fault => panic!("{fault}"),
    }
}

/// Returns the metric with these constants claimed for it.
fn claiming<M>(metric: M, [c1, c2, l_h]: [f64; 3]) -> WithConstants<M> {
    WithConstants { metric, constants: Constants::new(c1, c2, l_h).expect("in order") }
}

/// Returns the metric with one of its constants multiplied by a factor.
fn with_wrong<M: Bounded<D>, const D: usize>(
    metric: M,
    constant: Claim,
    factor: f64,
) -> WithConstants<M> {
    let by = Claim::ALL.map(|claim| if claim == constant { factor } else { 1.0 });
    let constants = metric.constants().times(by).expect("in order");
    WithConstants { metric, constants }
}
