//! Proposes certificates of distances.
//!
//! What is proposed here is proved by `tautline-check`, which trusts none of it.

mod calibration;
mod error;
mod fan;
mod first_level;
mod geodesic;
mod hamiltonian;
mod marching;
mod reduction;
mod search;
mod seed;
mod tubes;

pub use error::DistanceError;
pub use search::{Ended, Found, Progress, Wanted, search};
