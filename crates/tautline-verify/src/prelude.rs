//! What a test of a metric, a closed set or a rule of one's own needs, in one line.
//!
//! See [`kit`](crate::kit).

pub use tautline::{
    Bounded, Certified, ClosedSet, Constants, KnownDistance, LocallyBounded, LocallyCertified,
    Metric, Node, Rule, SMatrix, SVector, Scalar, certify::Accuracy,
};

pub use crate::{
    WithConstants,
    kit::{Effort, Outcome, Region, Report, verify_metric, verify_rule, verify_set},
    metric_suite, rule_suite, set_suite,
};
