//! Computed minimisers of either rule.

use tautline::{Ends, LeftEndpoint, Metric, Minimum, Trapezoidal};
use tautline_statements::{PaperRule, Subject, VerifyError};

/// Returns the minimiser that the subject computes for a rule.
pub(crate) fn minimum<const D: usize>(
    subject: &Subject,
    rule: PaperRule,
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    n: usize,
) -> Result<Minimum<D>, VerifyError> {
    Ok(match rule {
        PaperRule::Trapezoidal => subject.minimise(Trapezoidal, metric, ends, n)?,
        PaperRule::LeftEndpoint => subject.minimise(LeftEndpoint, metric, ends, n)?,
    })
}
