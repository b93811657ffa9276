//! Problems with constants that are only claimed and need not be true.

use tautline::Constants;
use tautline_statements::{Known, WithConstants};

/// Returns the problem with these constants claimed for its metric.
pub(crate) fn claiming<M, const D: usize>(
    known: Known<M, D>,
    constants: Constants,
) -> Known<WithConstants<M>, D> {
    let Known { metric, ends, distance, distance_error } = known;
    Known { metric: WithConstants { metric, constants }, ends, distance, distance_error }
}
