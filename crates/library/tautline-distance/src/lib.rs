//! Proposes certificates of distances.
//!
//! What is proposed here is proved by `tautline-check`, which trusts none of it.
//!
//! # Features
//!
//! `serde`, off by default: [`Wanted`] and [`Ended`] are written and read by the names of their fields
//! and variants. A certificate has a format of its own.

mod any;
mod calibration;
mod contact;
mod error;
mod fan;
mod first_level;
mod flat;
mod found;
mod geodesic;
mod hamiltonian;
mod inside;
mod marching;
mod neighbourhood;
mod pace;
mod proposal;
mod search;
mod seed;
mod tubes;

pub use any::{AnyCubes, AnyFound, search_any, shortest_chord};
pub use error::DistanceError;
pub use found::{Ended, Found, Progress, Wanted};
pub use search::search;
