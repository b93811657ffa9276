//! `Minimum`: a computed local minimiser, and how far to trust it.

use nalgebra::SVector;
use tautline_discretizations::PointSequence;

/// A computed discrete minimiser: the lowest local minimiser that was found.
///
/// `curvature` and `residual` show how far it is a local minimiser. Nothing proves that no other
/// sequence has less energy.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Minimum<const D: usize> {
    /// The point sequence, with its ends in their sets to rounding.
    pub sequence: PointSequence<D>,
    /// Its discrete energy, in `m²`.
    pub energy: f64,
    /// The energy that another Newton step promises to shed, relative to the energy: half the
    /// square of the Newton decrement. If the Hessian is not positive definite, it is infinite
    /// after a search that gave up, and computed with the last shift of the Hessian after one that
    /// converged.
    pub decrement: f64,
    /// The residual of the discrete geodesic equation: `((1/N) Σ |ρₙ|²)^{1/2}` over the inner
    /// points with `ρₙ = (N/2) ∂E/∂xₙ`, plus the larger projected momentum `½ |∂E/∂x|` at the ends,
    /// relative to the momentum `(c E)^{1/2}` with the mean `c` of `tr H / D`. Infinite if the
    /// metric has no derivative at a node.
    pub residual: f64,
    /// The predicted residual from rounding alone: `ε N² max |x| c / (c E)^{1/2}`, times
    /// `(D/2)^{1/2}` from three dimensions on. A residual of a few times this cannot be lowered in
    /// `f64`.
    pub residual_floor: f64,
    /// How the search ended.
    pub stop: Stop,
    /// The signature of the Hessian at the last iterate.
    pub curvature: Curvature,
    /// Newton steps of all searches, from every start, over all grids; the last evaluation on each
    /// grid counts as one.
    pub iterations: usize,
    /// The steps among them that led here: from one start, over all grids.
    pub own_iterations: usize,
    /// The energies on all grids on the way here, from coarse to fine; the last is this result.
    pub levels: Vec<Level>,
    /// The energies, in `m²`, of the local minimisers found on the coarsest grid, lowest first.
    /// Those that agree to a relative `10⁻⁹`, such as mirror images, count once. Empty if no search
    /// converged there.
    pub local_minima: Vec<f64>,
}

/// The minimum on one grid.
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
    /// The decrement, relative to the energy, is at most `10⁻¹⁸` or the rounding of the points,
    /// `2 tr H (ε N max |x|)²`, which is larger only on huge grids or far from the origin. Or it is
    /// below `10⁻¹⁰` and has stopped falling. The residual may still be large and the Hessian
    /// indefinite: see [`Minimum::is_local_minimum`].
    Converged,
    /// The sets have a point in common, up to rounding: all points are the same and the energy is
    /// 0, or all chords are rounding.
    EndsTouch,
    /// No step lowered the energy, although the decrement promised it.
    Stalled,
    /// The search took the allowed number of Newton steps.
    IterationLimit,
}

/// The signature of the Hessian, confined to the active faces of the end sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Curvature {
    /// Positive definite: a strict local minimum. The margin exceeds the rounding of the Hessian up
    /// to `N = 5·10⁵`; from there on it is `10⁻³` of the regulariser `∫ |δ̇|² + |δ|²`.
    ///
    /// The Hessian is evaluated at the result, or one Newton step before it if the relative
    /// decrement there was below `10⁻¹⁶` or, on finer grids from four dimensions on, below the
    /// square of the margin.
    PositiveDefinite,
    /// Not positive definite, but no eigenvalue is negative beyond rounding: a degenerate minimum,
    /// or one of a continuum.
    Degenerate,
    /// Some eigenvalues are negative: a saddle, or the search ended far from a minimum.
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

    /// The result for sets with the common point `x`.
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
