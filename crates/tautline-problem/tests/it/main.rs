//! Problem files: what they mean, and what is said of wrong ones.

mod gallery;
mod schema;
mod twins;
mod wrong;
