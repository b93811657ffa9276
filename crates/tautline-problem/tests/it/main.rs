//! Problem files: what they mean, and what is said of wrong ones.

mod gallery;
mod other_minima;
mod schema;
mod tolerance;
mod twins;
mod wrong;
