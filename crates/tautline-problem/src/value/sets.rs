//! Points and sets in the dimension of a metric.

use std::sync::Arc;

use tautline::{ClosedSet, SVector, Union};
use tautline_picture::portrait::Shape;

use super::GivenError;
use crate::reading::shape::{set_of, vector};

/// Returns a point with as many coordinates as there are.
pub(super) fn point<const D: usize>(x: &[f64]) -> Result<SVector<f64, D>, GivenError> {
    match x.len() {
        found if found != D => {
            Err(GivenError::Coordinates { what: "a point", found, dimension: D })
        }
        _ => Ok(vector::<D>(x)),
    }
}

/// Refuses a shape with another number of coordinates.
pub(super) fn check_coordinates<const D: usize>(shape: &Shape) -> Result<(), GivenError> {
    let other = shape.coordinates().find(|&found| found != D);
    let refused = |found| GivenError::Coordinates { what: shape.name(), found, dimension: D };
    other.map_or(Ok(()), |found| Err(refused(found)))
}

/// Returns the union of the pieces, or the only one.
pub(super) fn set<const D: usize>(
    end: &'static str,
    pieces: &[Shape],
) -> Result<Arc<dyn ClosedSet<D>>, GivenError> {
    let mut sets = Vec::new();
    for piece in pieces {
        check_coordinates::<D>(piece)?;
        sets.push(set_of::<D>(piece)?);
    }
    match sets.len() {
        0 => Err(GivenError::NoPieces { end }),
        1 => Ok(sets.remove(0)),
        _ => Ok(Arc::new(Union::new(sets)?)),
    }
}
