//! The kit on all that the project brings itself, and on what has to be rejected.

mod composition;
mod gallery;
mod lies;
mod lying_sets;
mod newcomer;
mod rules;
mod sets;
