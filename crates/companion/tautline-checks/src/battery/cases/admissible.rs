//! Makes random sequences admissible.

use tautline::{Ends, PointSequence};
use tautline_statements::{Subject, VerifyError};

/// Returns the sequence with its first and last points projected to their sets.
pub(crate) fn admissible<const D: usize>(
    subject: &Subject,
    ends: &Ends<D>,
    sequence: PointSequence<D>,
) -> Result<PointSequence<D>, VerifyError> {
    let mut points = sequence.into_points();
    let last = points.len() - 1;
    points[0] = subject.project(&**ends.first(), &points[0]);
    points[last] = subject.project(&**ends.second(), &points[last]);
    Ok(PointSequence::new(points)?)
}
