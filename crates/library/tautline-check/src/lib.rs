//! Checks a certificate of the distance between two closed sets.
//!
//! A [`Certificate`] holds a metric, two sets, a curve between them, and values of two functions on
//! cubes. [`Certificate::check`] proves two numbers from it: the curve has at most the one length,
//! and *every* curve between the sets has at least the other. Curves stay where the metric is defined
//! and positive definite. Nothing is assumed of the values: they are proposals, made by whatever
//! program, and wrong ones only prove less.
//!
//! A file may come from anywhere: the work of a check is limited by the size of the certificate, and
//! [`Certificate::check_while`] can be stopped.
//!
//! # The proof
//!
//! Let `φ` be continuous and piecewise quadratic on cubes. From bounds on its gradient one makes a
//! function `f` of its values, such that `f(φ)` grows along every curve by at most the length of the
//! curve (`level_sets.rs`); the bounds come from values of `H` at the corners of cubes
//! (`vertex_test.rs`). If `f(φ)` is 0 on the first set, the distance is at least its infimum on the
//! second set. If another such function `g(ψ)` is 0 on the second set, a curve through `x` has at
//! least the length `f(φ(x)) + g(ψ(x))`. So curves shorter than `hi` miss all simplices on which this
//! is at least `hi` (`sweep.rs`). The next level uses smaller cubes on what is left
//! (`certificate.rs`). That curves do not leave the first cubes is proved by a [`Region`].
//!
//! # Trust base
//!
//! * the theorems, whose proofs are in the comments and in `paper/CERTIFICATE.md`, and this crate;
//! * [`Interval`](tautline_scalar::Interval)s and jets, and the formula, evaluated as written;
//! * the compiler and the processor.
//!
//! # Features
//!
//! `serde`, off by default: a [`Verdict`] is written. It is not read, since nothing proves what is read:
//! keep the certificate, and check it again.

mod certificate;
mod error;
mod kuhn;
mod lattice;
mod level;
mod level_sets;
mod polygon;
mod quadratic;
mod reader;
mod region;
mod rounding;
mod set;
mod steps;
mod sweep;
mod verdict;
mod vertex_test;
mod work;
mod writer;

pub use certificate::{Certificate, Chain, Proved};
pub use error::CheckError;
pub use kuhn::LARGEST_DIMENSION;
pub use lattice::{Cubes, Place};
pub use level::Level;
pub use polygon::length_above;
pub use reader::AnyCertificate;
pub use region::Region;
pub use sweep::in_parallel;
pub use verdict::Verdict;
