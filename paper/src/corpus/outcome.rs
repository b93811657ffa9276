//! `Search`: how a search for a discrete minimiser ended.

use tautline::{Curvature, Minimum, SolveError, Stop};

/// The outcome of one search.
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// Whether the search reached the goal, and if not, why.
    pub end: End,
    /// The Newton steps on all grids, from the start that led to the result. The final check on
    /// each grid counts as one step.
    pub iterations: usize,
}

/// Whether a search reached the goal.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// The sets have a point in common, so that there is nothing to search for.
    Touch,
    /// The search converged to rounding accuracy: see [`Search::new`].
    Reached,
    /// The search reports convergence, but two numbers exceed rounding: the decrement relative to
    /// the energy, and the ratio of the residual to its floor.
    Above {
        /// The relative decrement.
        decrement: f64,
        /// The residual divided by its floor.
        residual: f64,
    },
    /// The search converged to a saddle.
    Saddle {
        /// The number of negative eigenvalues of the Hessian.
        negative: usize,
    },
    /// The search reports that it did not converge.
    Stopped(Stop),
    /// The search returned an error.
    Refused(SolveError),
    /// One of the numbers of the result is NaN.
    NotANumber,
}

/// The relative decrement at which a search may stop with [`Stop::Converged`]. It is a hundredth of
/// the rounding of an energy in `f64`, so that the energy cannot distinguish the result from a
/// minimiser.
const DECREMENT: f64 = 1e-18;

/// On fine grids, rounding of the points alone leaves a larger decrement, and shows in the
/// residual.
///
/// A coordinate is rounded by at most `u/2`, where `u ≤ ε max |x|`, with the variance `u²/12`. The
/// residual `ρₙ = (N/2) ∂E/∂xₙ` is about `N² H (xₙ₋₁ − 2xₙ + xₙ₊₁)`. Three rounded coordinates give
/// it the variance `N⁴ c² u²/2`, and `D` coordinates `D` times as much, which is about the floor of
/// the residual. Twice the floor is allowed, for matrices `H` with entries above their mean `c`.
const FLOORS: f64 = 2.0;

impl Search {
    /// Judges a result. It reaches the goal if the search reports convergence, no eigenvalue of the
    /// Hessian is negative beyond rounding, and either the decrement is at most `10⁻¹⁸` times the
    /// energy or the residual is at most twice its floor.
    #[must_use]
    pub fn new<const D: usize>(minimum: &Minimum<D>) -> Self {
        Self { end: End::of(minimum), iterations: minimum.own_iterations }
    }

    /// Returns the outcome of a problem without a result.
    #[must_use]
    pub fn refused(error: SolveError) -> Self {
        Self { end: End::Refused(error), iterations: 0 }
    }

    /// Returns whether the goal was reached within this number of steps.
    #[must_use]
    pub fn reached_within(&self, iterations: usize) -> bool {
        matches!(self.end, End::Touch | End::Reached) && self.iterations <= iterations
    }
}

impl End {
    fn of<const D: usize>(minimum: &Minimum<D>) -> Self {
        let &Minimum { energy, decrement, residual, residual_floor, .. } = minimum;
        let numbers = [energy, decrement, residual, residual_floor].into_iter();
        let numbers = numbers.chain(minimum.levels.iter().map(|level| level.energy));
        let mut numbers = numbers.chain(minimum.local_minima.iter().copied());
        // The points are finite, since a sequence has no others.
        if numbers.any(f64::is_nan) {
            return Self::NotANumber;
        }
        match (minimum.stop, minimum.curvature) {
            (Stop::EndsTouch, _) => Self::Touch,
            (Stop::Converged, Curvature::Indefinite { negative }) => Self::Saddle { negative },
            (Stop::Converged, _)
                if decrement <= DECREMENT || residual <= FLOORS * residual_floor =>
            {
                Self::Reached
            }
            (Stop::Converged, _) => Self::Above { decrement, residual: residual / residual_floor },
            (stop, _) => Self::Stopped(stop),
        }
    }
}
