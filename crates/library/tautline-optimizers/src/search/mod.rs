//! The parts of the search for a minimiser: starts, grids and local searches.

pub(crate) mod candidate;
pub(crate) mod damped_step;
pub(crate) mod damping;
pub(crate) mod grids;
pub(crate) mod lengthening;
pub(crate) mod line_minimum;
pub(crate) mod local_search;
pub(crate) mod minimum;
pub(crate) mod others;
pub(crate) mod prolongation;
pub(crate) mod refinement;
pub(crate) mod saddle;
pub(crate) mod scope;
pub(crate) mod solve_error;
pub(crate) mod starts;
