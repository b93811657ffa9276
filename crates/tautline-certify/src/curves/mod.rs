//! Curves: rigorous bounds of energies and lengths, and what they prove of a distance.

mod chord;
mod pairwise_sum;
mod polygon;
mod taylor;

pub use polygon::Polygon;
