//! Problem files: what they mean, and what is said of wrong ones.

mod answers;
mod array;
mod certified;
mod constants;
mod corridor;
mod gallery;
mod lattice;
mod meaning;
mod obstacles;
mod random_certificates;
mod regions;
mod schema;
mod signs;
mod sweep;
mod tables;
mod tolerance;
mod touching;
mod twins;
mod value;
mod wrong;
