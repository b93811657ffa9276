//! `Minimum`: a computed local minimiser, and how far it may be trusted.

use nalgebra::SVector;
use tautline_discretizations::PointSequence;

/// A computed discrete minimiser: the lowest of the local minimisers that were found.
///
/// It is a local minimiser as far as `curvature` and `residual` show. That no other sequence
/// has less energy is not proven.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Minimum<const D: usize> {
    /// The point sequence, with its ends in their sets to rounding.
    pub sequence: PointSequence<D>,
    /// Its discrete energy, in `m²`.
    pub energy: f64,
    /// The energy that a Newton step still promises to shed, relative to the energy: half
    /// the square of the Newton decrement. Infinite if the Hessian is not positive definite
    /// where a search gave up; where one converged and it is not, that of the Hessian with the last
    /// shift.
    pub decrement: f64,
    /// The residual of the discrete geodesic equation: `((1/N) Σ |ρₙ|²)^{1/2}` over the inner
    /// points with `ρₙ = (N/2) ∂E/∂xₙ`, plus the larger projected momentum `½ |∂E/∂x|` at the
    /// ends, relative to the momentum `(c E)^{1/2}` with the mean `c` of
    /// `tr H / D`. Infinite if the metric has no derivative at a node.
    pub residual: f64,
    /// What rounding alone does to the residual, predicted: `ε N² max |x| c / (c E)^{1/2}`, and from
    /// three dimensions on `(D/2)^{1/2}` times that. A residual of a few times this cannot be lowered
    /// in `f64`.
    pub residual_floor: f64,
    /// How the search ended.
    pub stop: Stop,
    /// What the Hessian says at the last iterate.
    pub curvature: Curvature,
    /// Newton steps of all searches, from every start, over all grids; the last look at each grid
    /// counts as one.
    pub iterations: usize,
    /// Of these, the steps of the search that led here: from its one start, over all grids.
    pub own_iterations: usize,
    /// The grids on the way here, from coarse to fine, the last being this result.
    pub levels: Vec<Level>,
    /// The energies, different by more than `10⁻⁹` relatively, of the local minimisers that
    /// were met on the coarsest grid, lowest first, in `m²`. Mirror images count once; empty if
    /// no search converged there.
    pub local_minima: Vec<f64>,
}

/// The minimum that was found on one grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// The number of subintervals `N`.
    pub n: usize,
    /// The discrete energy, in `m²`.
    pub energy: f64,
}

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stop {
    /// The decrement is at most `10⁻¹⁸`, or `2 tr H (ε N max |x|)²` relative to the energy, the
    /// rounding of the points: larger only on huge grids or far from the origin. Or it is
    /// below `10⁻¹⁰` and does not fall any more. It says nothing of the residual, and the Hessian may
    /// be indefinite: see [`Minimum::is_local_minimum`].
    Converged,
    /// The sets have a point in common, up to rounding: all points are the same and the energy is
    /// 0, or all chords are rounding.
    EndsTouch,
    /// No step lowered the energy any more, though the decrement promised it.
    Stalled,
    /// The allowed number of Newton steps was taken.
    IterationLimit,
}

/// What the Hessian, confined to the active faces of the end sets, says about a stationary
/// sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Curvature {
    /// Positive definite, beyond the rounding of the Hessian (up to `N = 5·10⁵`; from there on
    /// beyond `10⁻³` of the regulariser `∫ |δ̇|² + |δ|²`): a strict local minimum.
    ///
    /// The Hessian is that of the result, or of one Newton step before it whose relative decrement
    /// was below `10⁻¹⁶`, or on finer grids, from four dimensions on, below the square of the margin
    /// of definiteness.
    PositiveDefinite,
    /// Not positive definite, but no eigenvalue is negative beyond rounding: one of a continuum
    /// of minimisers, or a degenerate minimum.
    Degenerate,
    /// This many eigenvalues are negative: a saddle, or the search ended far from a minimum.
    Indefinite {
        /// The number of negative eigenvalues.
        negative: usize,
    },
}

impl<const D: usize> Minimum<D> {
    /// Returns whether the search converged to a strict local minimum (or to ends that touch).
    #[must_use]
    pub fn is_local_minimum(&self) -> bool {
        match self.stop {
            Stop::EndsTouch => true,
            Stop::Converged => self.curvature == Curvature::PositiveDefinite,
            _ => false,
        }
    }

    /// The result for sets with the common point `x`: everything is 0.
    pub(crate) fn at_common_point(x: SVector<f64, D>, n: usize) -> Self {
        Self {
            sequence: PointSequence::new(vec![x; n + 1]).expect("a common point is finite"),
            energy: 0.0,
            decrement: 0.0,
            residual: 0.0,
            residual_floor: 0.0,
            stop: Stop::EndsTouch,
            curvature: Curvature::PositiveDefinite,
            iterations: 0,
            own_iterations: 0,
            levels: vec![Level { n, energy: 0.0 }],
            local_minima: vec![0.0],
        }
    }
}
