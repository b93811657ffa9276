//! What the minimisers of finer and finer grids tend to.

pub(crate) mod asymptotics_error;
pub(crate) mod extrapolation;
pub(crate) mod geodesic_means;
pub(crate) mod leading_constants;
