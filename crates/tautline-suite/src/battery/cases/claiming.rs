//! Problems with constants that are only claimed.

use tautline::Constants;
use tautline_statements::{Known, WithConstants};

/// Returns the problem with other constants of the metric.
pub(crate) fn claiming<M, const D: usize>(
    known: Known<M, D>,
    constants: Constants,
) -> Known<WithConstants<M>, D> {
    let Known { metric, ends, distance, distance_error } = known;
    Known { metric: WithConstants { metric, constants }, ends, distance, distance_error }
}
