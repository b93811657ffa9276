//! `NotFinite`: a coordinate that is NaN or infinite.

use nalgebra::SVector;

/// A coordinate that the errors of this crate report.
pub(crate) struct NotFinite {
    /// What the coordinate belongs to.
    pub(crate) what: &'static str,
    /// The index of the coordinate, from 0.
    pub(crate) coordinate: usize,
    pub(crate) value: f64,
}

/// Refuses coordinates that are not finite.
pub(crate) fn finite<const D: usize>(
    what: &'static str,
    x: &SVector<f64, D>,
) -> Result<(), NotFinite> {
    match x.iter().position(|value| !value.is_finite()) {
        Some(coordinate) => Err(NotFinite { what, coordinate, value: x[coordinate] }),
        None => Ok(()),
    }
}
