//! Discrete energies and lengths of point sequences, and the curves that join their points.
//!
//! A [`PointSequence`] `x₀, …, x_N` samples a curve at the times `tₙ = n/N`; its finite differences
//! `βₙ = N (xₙ₊₁ − xₙ)` approximate the velocity. A [`Rule`] fixes where on each chord the metric
//! is evaluated:
//!
//! ```text
//! E_N = (1/N) Σₙ Σᵢ wᵢ βₙᵀ H(xₙ + θᵢ (xₙ₊₁ − xₙ)) βₙ,     L_N the same with a square root
//! ```
//!
//! The rules of this library are the constants of [`Rule`], such as [`Rule::TRAPEZOIDAL`], as the
//! paper calls it (the midpoint rule elsewhere), and [`Rule::SIMPSON`]; [`Rule::ALL`] lists them.
//!
//! [`PeanoConstants`] bound how far the discrete energy of any rule is from that of the reconstructed
//! curve.
//!
//! No energy has a factor `½`. The [`Interpolation`] `γᵖˡ` joins the points by straight lines, and
//! quadrature computes its continuous energy and length.
//!
//! ```
//! use tautline_discretizations::{Interpolation, PointSequence, Rule};
//! use tautline_metrics::gallery::Valleys;
//!
//! let line = PointSequence::straight([0.0, 0.0], [12.566370614359172, 0.0], 1)?;
//! // One chord from valley to valley, with its midpoint in a valley: 16 π²; the curve has 72 π².
//! let discrete = Rule::TRAPEZOIDAL.energy(&Valleys, &line);
//! assert!((discrete / 157.91367041742973 - 1.0).abs() < 1e-14);
//! let continuous = Interpolation::new(&line).energy(&Valleys);
//! assert!((continuous.value / 710.6115168784338 - 1.0).abs() < 1e-14);
//! # Ok::<(), tautline_discretizations::SequenceError>(())
//! ```
//!
//! # Features
//!
//! `serde`, off by default: a [`PointSequence`] is written as a list of points, and checked when it is
//! read.

mod admissible_energy;
mod block_tridiagonal;
mod check;
mod chord_batch;
mod chord_model;
mod chord_models;
mod compensated_sum;
mod contractions;
mod gram_square;
mod interpolation;
mod linear_model;
mod momenta;
mod peano;
mod point_sequence;
mod quadratic_model;
mod resampling;
mod rule;
mod rules;

pub use admissible_energy::admissible_energy;
pub use block_tridiagonal::BlockTridiagonal;
pub use chord_batch::ChordBatch;
pub use chord_model::ChordModel;
pub use chord_models::ChordModels;
pub use compensated_sum::CompensatedSum;
pub use contractions::{Contractions, Entry};
pub use interpolation::Interpolation;
pub use linear_model::{LinearModel, energy_gradient};
pub use momenta::{Energies, Momenta};
pub use peano::PeanoConstants;
pub use point_sequence::{LARGEST_N, PointSequence, SequenceError, coordinates};
pub use quadratic_model::QuadraticModel;
pub use rule::{Node, Rule};
pub use tautline_metrics::quadrature::Integral;
pub use tautline_scalar::ANY;
