//! Chords between sets that touch up to rounding.

use nalgebra::SVector;
use tautline_check::{CheckError, length_above};
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::DistanceError;

/// Returns a chord from a member of the first set to one of the second next to these two points, and its
/// proved length.
pub(crate) fn chord_between_members<const D: usize>(
    formula: &Formula<D>,
    [first, second]: &[Shape<D>; 2],
    ends: [SVector<f64, D>; 2],
) -> Result<([SVector<f64, D>; 2], f64), DistanceError> {
    let pairs = ends.iter().flat_map(|x| {
        let (a, b) = (first.proved_member(x), second.proved_member(x));
        let there = a.and_then(|a| Some([a, second.proved_member(&a)?]));
        let back = b.and_then(|b| Some([first.proved_member(&b)?, b]));
        [there, back, a.zip(b).map(|(a, b)| [a, b])]
    });
    let (mut chords, mut reason) = (Vec::new(), CheckError::CurveEnd { end: "first" });
    for pair in pairs.flatten() {
        match length_above(formula, [first, second], &pair) {
            Ok(length) => chords.push((pair, length)),
            Err(error) => reason = error,
        }
    }
    // An infinite length is no bound.
    let finite = chords.into_iter().filter(|(_, length)| length.is_finite());
    let shortest = finite.min_by(|(_, a), (_, b)| a.total_cmp(b));
    shortest.ok_or(DistanceError::Curve(reason))
}
