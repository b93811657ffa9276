//! A gallery of metrics: one a file, each with its formula, its constants in closed form
//! and, where known, its exact distance.

mod sphere;
mod valleys;

pub use sphere::Sphere;
pub use valleys::Valleys;
