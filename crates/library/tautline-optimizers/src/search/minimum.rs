//! `Minimum`: a computed local minimiser, and how far it can be trusted.

use tautline_discretizations::{ANY, PointSequence};

/// A computed discrete minimiser: the lowest local minimiser that was found.
///
/// `curvature` and `residual` show to what extent it is a local minimiser. Nothing proves that no
/// other sequence has less energy.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Minimum<const D: usize> {
    /// The point sequence. Its ends lie in their sets up to rounding.
    pub sequence: PointSequence<D>,
    /// The discrete energy of the sequence, in `m²`.
    pub energy: f64,
    /// The decrease of the energy that another Newton step predicts, relative to the energy. It is
    /// half the square of the Newton decrement. If the Hessian is not positive definite, it is
    /// infinite after a search that gave up; after one that converged, it is computed with the last
    /// shift of the Hessian.
    pub decrement: f64,
    /// The residual of the discrete geodesic equation: `((1/N) Σ |ρₙ|²)^{1/2}` over the inner
    /// points, where `ρₙ = (N/2) ∂E/∂xₙ`, plus the larger of the projected momenta `½ |∂E/∂x|` at
    /// the two ends. It is relative to the momentum `(c E)^{1/2}`, where `c` is the mean of
    /// `tr H / D`. It is infinite if the metric has no derivative at a node.
    pub residual: f64,
    /// The residual that rounding alone is predicted to cause: `ε N² max |x| c / (c E)^{1/2}`,
    /// times `(D/2)^{1/2}` from three dimensions on. A residual of a few times this number cannot
    /// be lowered in `f64`.
    pub residual_floor: f64,
    /// How the search ended.
    pub stop: Stop,
    /// The signature of the Hessian at the last iterate.
    pub curvature: Curvature,
    /// The number of Newton steps of all searches, from every start and over all grids. The last
    /// evaluation on each grid counts as one step. A look [elsewhere](crate::Scope::Automatic) counts if it
    /// finds a shorter line.
    pub iterations: usize,
    /// The number of those steps that led to this result: from one start, over all grids.
    pub own_iterations: usize,
    /// The energies on all grids on the way to this result, from coarse to fine. The last is the
    /// energy of this result. For a line from a path along a lattice they are those of minima next to it,
    /// which are sought afterwards.
    pub levels: Vec<Level>,
    /// The energies, in `m²`, of the local minimisers found on the coarsest grid, lowest first.
    /// Energies that agree to a relative `10⁻⁹`, such as those of mirror images, count once. The
    /// list is empty if no search converged on that grid.
    pub local_minima: Vec<f64>,
    /// The other local minimisers that were met, lowest first, up to seven, each along another curve; after
    /// a search along a lattice, or elsewhere, up to eight.
    /// They stay on a coarser grid if they have the energy of one that is followed, as mirror
    /// images do, and beyond 512 chords, where only the result is followed unless one of them is
    /// lower on the finest grid.
    pub others: Vec<Other<D>>,
}

/// A local minimiser besides the result.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Other<const D: usize> {
    /// The point sequence, perhaps on a coarser grid than that of the result.
    pub sequence: PointSequence<D>,
    /// Its discrete energy, in `m²`.
    pub energy: f64,
}

/// The minimum on one grid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Level {
    /// The number of subintervals `N`.
    pub n: usize,
    /// The discrete energy, in `m²`.
    pub energy: f64,
}

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Stop {
    /// The decrement is at most `10⁻¹⁸` times the energy, or at most the effect of rounding the
    /// points, `2 tr H (ε N max |x|)²`; the latter is larger only on huge grids or far from the
    /// origin. Or the decrement is less than `10⁻¹⁰` times the energy and has stopped falling. The
    /// residual may still be large and the Hessian indefinite: see [`Minimum::is_local_minimum`].
    Converged,
    /// The sets have a point in common, up to rounding. Either all points are the same and the
    /// energy is 0, or all chords are within rounding of zero.
    EndsTouch,
    /// No step lowered the energy, although the decrement predicted a decrease.
    Stalled,
    /// The search took the allowed number of Newton steps.
    IterationLimit,
}

/// The signature of the Hessian, confined to the active faces of the end sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Curvature {
    /// The Hessian is positive definite: a strict local minimum. Up to `N = 5·10⁵` the margin
    /// exceeds the rounding of the Hessian; from there on it is `10⁻³` of the regulariser
    /// `∫ |δ̇|² + |δ|²`.
    ///
    /// The Hessian is usually evaluated at the result. It is evaluated one Newton step before the
    /// result if the relative decrement there was below `10⁻¹⁶` or, on finer grids from four
    /// dimensions on, below the square of the margin.
    PositiveDefinite,
    /// The Hessian is not positive definite, but no eigenvalue is negative beyond rounding. The
    /// minimum is degenerate, or one of a continuum.
    Degenerate,
    /// Some eigenvalues are negative: the result is a saddle, or the search ended far from a
    /// minimum.
    Indefinite {
        /// The number of negative eigenvalues.
        negative: usize,
    },
}

impl<const D: usize> Minimum<D> {
    /// Returns whether the search converged to a strict local minimum, or to ends that touch.
    #[must_use]
    pub fn is_local_minimum(&self) -> bool {
        match self.stop {
            Stop::EndsTouch => true,
            Stop::Converged => self.curvature == Curvature::PositiveDefinite,
            _ => false,
        }
    }
}

impl Minimum<ANY> {
    /// Returns the result for sets that have the point `x` in common.
    pub(crate) fn at_common_point(x: &[f64], n: usize) -> Self {
        Self {
            sequence: PointSequence::from_coordinates(x.len(), x.repeat(n + 1))
                .expect("a common point is finite"),
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
            others: Vec::new(),
        }
    }

    /// Returns the same minimiser as one in `R^E`; `None` if it lies in another dimension.
    #[must_use]
    pub fn into_dimension<const E: usize>(self) -> Option<Minimum<E>> {
        let others = self.others.into_iter().map(Other::into_dimension).collect::<Option<_>>()?;
        Some(Minimum {
            sequence: self.sequence.into_dimension()?,
            energy: self.energy,
            decrement: self.decrement,
            residual: self.residual,
            residual_floor: self.residual_floor,
            stop: self.stop,
            curvature: self.curvature,
            iterations: self.iterations,
            own_iterations: self.own_iterations,
            levels: self.levels,
            local_minima: self.local_minima,
            others,
        })
    }
}

impl Other<ANY> {
    /// Returns the same minimiser as one in `R^E`; `None` if it lies in another dimension.
    #[must_use]
    pub fn into_dimension<const E: usize>(self) -> Option<Other<E>> {
        Some(Other { sequence: self.sequence.into_dimension()?, energy: self.energy })
    }
}
