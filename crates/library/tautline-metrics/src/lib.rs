//! Riemannian metrics on `R^D`, each given by its Gram matrix `H(x)`.
//!
//! A metric is a field of symmetric positive definite matrices, `g_x(u, v) = uᵀ H(x) v`. You write
//! it once, as a formula over [`Scalar`]; values, derivatives and Christoffel symbols follow from
//! this one function.
//!
//! ```
//! use nalgebra::{SMatrix, SVector, vector};
//! use tautline_metrics::{Metric, Scalar, christoffel, norm_squared};
//!
//! /// `H(x) = e^{x₁} I`, a metric of our own.
//! struct Slope;
//! impl Metric<2> for Slope {
//!     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
//!         SMatrix::from_diagonal_element(x[0].exp())
//!     }
//! }
//!
//! let origin = vector![0.0, 0.0];
//! assert_eq!(norm_squared(&Slope, &origin, &vector![3.0, 4.0]), 25.0);
//! // Γ¹₁₁ = ½ ∂₁ log φ = ½
//! assert_eq!(christoffel(&Slope, &origin).unwrap()[0][(0, 0)], 0.5);
//! ```
//!
//! # The rungs
//!
//! | trait | promises | needed for |
//! | --- | --- | --- |
//! | [`Metric`] | `H(x)` and nothing else | minimising |
//! | [`Bounded`] | the constants `c₁`, `c₂`, `L_H` on all of `R^D` | proven bounds |
//! | [`LocallyBounded`] | such constants on balls | proven bounds near the ends |
//! | [`KnownDistance`] | the exact distance of (some) pairs of points | measuring an error |
//!
//! The [`gallery`] contains metrics of each kind. [`composition`] builds new metrics from them, and
//! the methods of [`Constants`] derive the constants of the result.
//!
//! # Units
//!
//! Coordinates are in `ℓ`, Riemannian length in `m`, and `t ∈ [0, 1]` is a pure number. Hence
//! `H`, `c₁` and `c₂` are in `m²/ℓ²`, `L_H` in `m²/ℓ³`, `M_H` in `m²/ℓ⁴`, energies in `m²`.
//!
//! # Features
//!
//! `serde`, off by default: [`Constants`] and integrals are written and read by the names of their
//! fields. Constants are checked when they are read.

mod calculus;
mod christoffel;
pub mod composition;
mod constants;
pub mod gallery;
mod locally_bounded;
mod metric;
mod positive_definite;
pub mod quadrature;
mod rayleigh_quotient;

pub use christoffel::christoffel;
pub use constants::{Constants, HypothesisError};
pub use locally_bounded::{LocalError, LocallyBounded};
pub use metric::{Bounded, KnownDistance, Metric, norm_squared, square_of};
pub use positive_definite::{
    MetricError, are_gram, check_gram, check_matrix, check_numbers, cholesky, is_gram,
};
pub use rayleigh_quotient::RayleighQuotient;
pub use tautline_scalar::{Jet1, Jet2, Lanes, Pair, Scalar, Short};
