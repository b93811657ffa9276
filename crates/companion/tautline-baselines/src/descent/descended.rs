//! `Descended`: where a descent ended, and how.

use tautline::{MetricError, PointSequence};

/// When a descent ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The [residual](tautline::Iterate::residual) that is small enough. A residual below
    /// [what rounding causes](tautline::Iterate::residual_floor) is small enough in any case.
    ///
    /// Near a minimum the relative excess of the energy is about the square of the residual, or less.
    /// All descents compare energies, whose rounding hides residuals below about `N · 10⁻⁸`:
    /// beyond a hundred chords, choose no smaller tolerance than that. A soft direction makes the
    /// excess larger.
    pub tolerance: f64,
    /// The largest number of steps.
    pub iterations: usize,
}

impl Default for Limits {
    /// Returns a tolerance of `10⁻⁶` and 10 000 steps.
    fn default() -> Self {
        Self { tolerance: 1e-6, iterations: 10_000 }
    }
}

/// Where a descent ended: a point sequence that is called stationary or not, and not more.
///
/// It has a metric at the nodes of the rule. Between them nothing is checked.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Descended<const D: usize> {
    /// The point sequence, with the ends of the start.
    pub sequence: PointSequence<D>,
    /// Its discrete energy, in `m²`.
    pub energy: f64,
    /// Its [residual](tautline::Iterate::residual).
    pub residual: f64,
    /// The [residual that rounding causes](tautline::Iterate::residual_floor).
    pub residual_floor: f64,
    /// How the descent ended.
    pub ended: Ended,
    /// The number of steps.
    pub iterations: usize,
    /// The number of times that the energy of a sequence was computed, with or without derivatives.
    pub evaluations: usize,
}

/// How a descent ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ended {
    /// The residual is small enough.
    Stationary,
    /// No step lowered the energy, or rounding hid for several steps whether one did: see
    /// [`residual`](Descended::residual) for what is left.
    Stalled,
    /// The allowed number of steps was taken.
    IterationLimit,
    /// The watcher ended it.
    Interrupted,
    /// The violation of a constraint is stationary, but not zero.
    Infeasible,
    /// The residual is small enough and the points satisfy the constraint, but a chord leaps from
    /// one part of its surface to another: no points of the surface were found that join its ends.
    Leaping {
        /// The number of the chord.
        chord: usize,
    },
}

/// Why there is no descent.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DescentError {
    /// The metric is not finite, symmetric and positive definite at a node of the start.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The energy of the start is beyond the range of `f64`.
    #[error("the energy of the start is {energy}: too large or too small for f64")]
    Energy {
        /// The energy, in `m²`.
        energy: f64,
    },
    /// The tolerance is negative or not a number.
    #[error("the tolerance of a residual is {tolerance}; expected a number from 0 on")]
    Tolerance {
        /// The tolerance.
        tolerance: f64,
    },
}
