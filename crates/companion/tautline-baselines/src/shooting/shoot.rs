//! `shoot`: Newton's method on the initial point and velocity.

use nalgebra::{SMatrix, SVector};
use tautline::{ClosedSet, Ends, Metric};

use super::{Geodesic, Shooting, ShootingError, exponential::exponential};
use crate::{
    normal_map::{NormalMap, nearby, pseudo_inverse, turned},
    not_finite::finite,
};

/// A geodesic that was found by shooting.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Shot<const D: usize> {
    /// The geodesic.
    pub geodesic: Geodesic<D>,
    /// The distance between its end and its target, in `ℓ`. If it is zero, the end lies in the
    /// second set and the momentum there is normal to the set. The converse holds for convex sets, and
    /// for others if the momentum, over the mean of the metric at the start, is shorter than the reach
    /// of the set.
    pub residual: f64,
    /// The number of Newton steps.
    pub iterations: usize,
}

/// Returns a geodesic between two closed sets that is normal to both, by shooting.
///
/// Newton's method solves for a point `z`, in `ℓ`, which stands for the start `p = P₀(z)` and for
/// the momentum `H(p)v = σ(z − p)`; `P₀` is the nearest-point map of the first set and `σ` is `tr H
/// / D` near the start, in `m²/ℓ²`. Hence the momentum is normal to the set, and every momentum if
/// the set is a point. With the end `y = γ(1)` and its momentum `m = H(y)γ̇(1)` the equation to
/// solve is
///
/// ```text
/// F(z) = y − P₁(y − m/σ) = 0
/// ```
///
/// which says that `y` lies in the second set and `−m` is normal to it; for a point `x₁` it is
/// `y = x₁`. The derivative of `F` follows from the variational equation. A step is halved until
/// `|F|` decreases. This is the transversality condition in the form of the normal map of
/// S. M. Robinson, Normal maps induced by linear transformations, Math. Oper. Res. 17 (1992).
///
/// The start of the search is the straight line between nearby points of the sets, or the velocity
/// of the options. The result is a geodesic, but need not be minimal. Sets of several pieces are
/// searched along one branch of their nearest-point maps.
///
/// # Errors
///
/// As for [`exponential`](super::exponential()), for the first shot; and
/// [`ShootingError::NoConvergence`] with the distance by which the best shot misses.
pub fn shoot<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    options: &Shooting<D>,
) -> Result<Shot<D>, ShootingError> {
    let problem = Aim::new(metric, &**ends.first(), &**ends.second(), options)?;
    let mut unknown = problem.first_unknown(options)?;
    let mut trial = problem.shoot(&unknown)?;
    for iterations in 0..=options.iterations {
        let misses = trial.miss.norm();
        let extent = trial.geodesic.end().amax().max(trial.geodesic.start().amax());
        let speed = trial.geodesic.initial_velocity().norm();
        // The integration is no better than its tolerance, nor the coordinates than their rounding.
        if misses <= 10.0 * options.integration.tolerance * speed + 8.0 * f64::EPSILON * extent {
            return Ok(Shot { geodesic: trial.geodesic, residual: misses, iterations });
        }
        let failure = ShootingError::NoConvergence { residual: misses, iterations };
        if iterations == options.iterations {
            return Err(failure);
        }
        let inverse = pseudo_inverse(&trial.derivative).ok_or(failure.clone())?;
        let step = -(inverse * trial.miss);
        let mut damping = 1.0;
        (unknown, trial) = loop {
            let next = unknown + step * damping;
            // A shot that leaves the domain was too long.
            if let Ok(found) = problem.shoot(&next)
                && found.miss.norm() <= (1.0 - 0.25 * damping) * misses
            {
                break (next, found);
            }
            damping *= 0.5;
            if damping < 1e-6 {
                return Err(failure);
            }
        };
    }
    unreachable!("the last iteration returns")
}

/// Returns the initial velocity of a geodesic from `x` to `y` by shooting, in `ℓ`: `v` with
/// `exp_x(v) = y`. If several geodesics join the points, it is that of one of them.
///
/// # Errors
///
/// As for [`shoot`]; also [`ShootingError::NotFinite`] and [`ShootingError::Ends`] for the points.
pub fn logarithm<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
    options: &Shooting<D>,
) -> Result<SVector<f64, D>, ShootingError> {
    finite("first point", x)?;
    finite("second point", y)?;
    let ends = Ends::points(*x, *y)?;
    Ok(shoot(metric, &ends, options)?.geodesic.initial_velocity())
}

/// The equation `F(z) = 0`.
struct Aim<'a, M, const D: usize> {
    metric: &'a M,
    first: NormalMap<'a, D>,
    second: &'a dyn ClosedSet<D>,
    options: &'a Shooting<D>,
    /// Nearby points of the sets.
    near: [SVector<f64, D>; 2],
}

/// A shot with `F` and its derivative.
struct Trial<const D: usize> {
    geodesic: Geodesic<D>,
    miss: SVector<f64, D>,
    derivative: SMatrix<f64, D, D>,
}

impl<'a, M: Metric<D>, const D: usize> Aim<'a, M, D> {
    fn new(
        metric: &'a M,
        first: &'a dyn ClosedSet<D>,
        second: &'a dyn ClosedSet<D>,
        options: &'a Shooting<D>,
    ) -> Result<Self, ShootingError> {
        let near = nearby(first, second);
        finite("nearest point", &near[0])?;
        finite("nearest point", &near[1])?;
        let gram = tautline::check_gram(metric, &near[0])
            .map_err(|error| ShootingError::LeavesTheDomain { time: 0.0, source: error.into() })?;
        let scale = gram.trace() / D as f64;
        let first = NormalMap { set: first, scale };
        Ok(Self { metric, first, second, options, near })
    }

    fn first_unknown(&self, options: &Shooting<D>) -> Result<SVector<f64, D>, ShootingError> {
        let velocity = options.velocity.unwrap_or(self.near[1] - self.near[0]);
        finite("velocity", &velocity)?;
        Ok(self.first.unknown(self.metric, &self.near[0], &velocity))
    }

    fn shoot(&self, unknown: &SVector<f64, D>) -> Result<Trial<D>, ShootingError> {
        let start = self.first.at(self.metric, unknown);
        let scale = self.first.scale;
        let geodesic =
            exponential(self.metric, &start.position, &start.velocity, &self.options.integration)?;
        let last = &geodesic.last;
        let by_unknown = |by_start: &SMatrix<f64, D, D>, by_velocity: &SMatrix<f64, D, D>| {
            by_start * start.position_by + by_velocity * start.velocity_by
        };
        let end_by_unknown = by_unknown(&last.position_by_position, &last.position_by_velocity);
        let final_by_unknown = by_unknown(&last.velocity_by_position, &last.velocity_by_velocity);
        let (end, final_velocity) = (last.position, last.velocity);
        let gram = self.metric.gram(&end);
        let target = end - gram * final_velocity / scale;
        let turned = turned(self.metric, &end, &final_velocity);
        let target_by_unknown =
            end_by_unknown - (gram * final_by_unknown + turned * end_by_unknown) / scale;
        let miss = end - self.second.project(&target);
        let derivative =
            end_by_unknown - self.second.projection_derivative(&target) * target_by_unknown;
        Ok(Trial { geodesic, miss, derivative })
    }
}
