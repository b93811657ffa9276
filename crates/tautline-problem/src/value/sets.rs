//! Points and sets in the dimension of a metric.

use std::sync::Arc;

use tautline::{AnySet, ClosedSet, SVector};

use super::{GivenError, Shape};
use crate::reading::shape::{union, vector};

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
    match shape.dimension() {
        found if found != D => {
            Err(GivenError::Coordinates { what: shape.name(), found, dimension: D })
        }
        _ => Ok(()),
    }
}

/// Returns the union of the pieces, or the only one.
pub(super) fn set<const D: usize>(
    end: &'static str,
    pieces: &[Shape],
) -> Result<Arc<dyn ClosedSet<D>>, GivenError> {
    if pieces.is_empty() {
        return Err(GivenError::NoPieces { end });
    }
    pieces.iter().try_for_each(check_coordinates::<D>)?;
    Ok(union(pieces.iter())?)
}
