//! Everything that a test of your own metric, closed set or rule needs, imported in one line.
//!
//! See the documentation of the [kit](crate).

pub use tautline::{
    Bounded, Certified, ClosedSet, Constants, KnownDistance, LocallyBounded, LocallyCertified,
    Metric, Node, Rule, SMatrix, SVector, Scalar, certify::Accuracy,
};
pub use tautline_statements::WithConstants;

pub use crate::{
    Effort, Outcome, Region, Report, metric_suite, rule_suite, set_suite, verify_metric,
    verify_rule, verify_set,
};
