//! The kit on all that the project brings itself, and on what has to be rejected.

mod gallery;
mod newcomer;
