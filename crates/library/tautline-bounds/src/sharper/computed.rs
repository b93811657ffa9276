//! `Computed`: one computed point sequence, and what is known about the discrete minimum.

use std::num::NonZeroUsize;

use crate::PaperRule;

/// What is known about the minimum of a discrete energy over all admissible sequences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DiscreteMinimum {
    /// The minimum is assumed to be the computed energy. A solver only finds a local minimum.
    Assumed,
    /// A lower bound on the minimum, in `m²`, for example from
    /// [`strict_convexity`](crate::strict_convexity).
    AtLeast(f64),
    /// Nothing is known.
    Unknown,
}

/// Computed quantities of one admissible sequence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Computed {
    /// The rule of the discrete energy.
    pub rule: PaperRule,
    /// The number of subintervals.
    pub n: NonZeroUsize,
    /// `E_N`, in `m²`.
    pub discrete_energy: f64,
    /// `E(γᵖˡ)`, in `m²`.
    pub energy: f64,
    /// `L(γᵖˡ)²`, in `m²`.
    pub length_squared: f64,
    /// What is known about the minimum of `E_N`.
    pub minimum: DiscreteMinimum,
    /// The Euclidean distance between the two sets, in `ℓ`; 0 if unknown.
    pub gap: f64,
}
