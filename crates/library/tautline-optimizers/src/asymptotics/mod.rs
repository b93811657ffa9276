//! The limit of the minimisers on finer and finer grids.

pub(crate) mod asymptotics_error;
pub(crate) mod extrapolation;
pub(crate) mod geodesic_means;
pub(crate) mod leading_constants;
