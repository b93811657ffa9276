//! The kit on all that the project brings itself, and on what has to be rejected.

mod composition;
mod gallery;
mod inventory;
mod lies;
mod lying_sets;
mod newcomer;
mod proofs;
mod proved;
mod rules;
mod sets;
mod statement_lies;
mod without_constants;
