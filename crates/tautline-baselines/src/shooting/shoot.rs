//! `shoot`: Newton's method on the initial point and velocity.

use nalgebra::{DMatrix, DVector, SMatrix, SVD, SVector};
use tautline::{ClosedSet, Ends, Jet1, Metric};

use super::{Geodesic, Shooting, ShootingError, exponential::exponential, shooting_error::finite};

/// A geodesic that was found by shooting.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Shot<const D: usize> {
    /// The geodesic.
    pub geodesic: Geodesic<D>,
    /// The distance between its end and its target, in `ℓ`. It is zero if and only if the end lies
    /// in the second set and the momentum there is normal to the set.
    pub residual: f64,
    /// The number of Newton steps.
    pub iterations: usize,
}

/// Returns a geodesic between two closed sets that is normal to both, by shooting.
///
/// Newton's method solves for a point `z`, in `ℓ`, which stands for the start `p = P₀(z)` and for
/// the momentum `H(p)v = σ(z − p)`; `P₀` is the nearest-point map of the first set and `σ` is
/// `tr H / D` near the start, in `m²/ℓ²`. Hence the momentum is normal to the set, and every momentum if the set is
/// a point. With the end `y = γ(1)` and its momentum `m = H(y)γ̇(1)` the equation to solve is
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
        let step = trial.newton_step().ok_or(failure.clone())?;
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
/// As for [`shoot`]; also [`ShootingError::NotFinite`] for the points.
pub fn logarithm<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
    options: &Shooting<D>,
) -> Result<SVector<f64, D>, ShootingError> {
    finite("first point", x)?;
    finite("second point", y)?;
    let ends = Ends::points(*x, *y).expect("finite points");
    Ok(shoot(metric, &ends, options)?.geodesic.initial_velocity())
}

/// The equation `F(z) = 0`.
struct Aim<'a, M, const D: usize> {
    metric: &'a M,
    sets: [&'a dyn ClosedSet<D>; 2],
    options: &'a Shooting<D>,
    /// Nearby points of the sets.
    near: [SVector<f64, D>; 2],
    /// `σ`, in `m²/ℓ²`.
    scale: f64,
}

/// A shot with `F` and its derivative.
struct Trial<const D: usize> {
    geodesic: Geodesic<D>,
    miss: SVector<f64, D>,
    derivative: SMatrix<f64, D, D>,
}

impl<const D: usize> Trial<D> {
    /// Returns the shortest solution of the linearised equation, in the sense of least squares.
    ///
    /// Between two circles about the centre of a symmetric metric there is a shot in every direction.
    /// The derivative is singular along such a family, and the step does not move along it.
    fn newton_step(&self) -> Option<SVector<f64, D>> {
        let matrix = DMatrix::from_fn(D, D, |i, j| self.derivative[(i, j)]);
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let svd = SVD::try_new(matrix, true, true, f64::EPSILON, 1000)?;
        let right = DVector::from_fn(D, |i, _| -self.miss[i]);
        let cut = 1e-9 * svd.singular_values.max();
        let step = svd.solve(&right, cut).ok()?;
        Some(SVector::from_fn(|i, _| step[i]))
    }
}

impl<'a, M: Metric<D>, const D: usize> Aim<'a, M, D> {
    fn new(
        metric: &'a M,
        first: &'a dyn ClosedSet<D>,
        second: &'a dyn ClosedSet<D>,
        options: &'a Shooting<D>,
    ) -> Result<Self, ShootingError> {
        // Alternating projections approach a nearest pair of convex sets.
        let mut near = [first.project(&SVector::zeros()); 2];
        for _ in 0..64 {
            near[1] = second.project(&near[0]);
            near[0] = first.project(&near[1]);
        }
        finite("nearest point", &near[0])?;
        finite("nearest point", &near[1])?;
        let gram = tautline::check_gram(metric, &near[0])
            .map_err(|error| ShootingError::LeavesTheDomain { time: 0.0, source: error.into() })?;
        let scale = gram.trace() / D as f64;
        Ok(Self { metric, sets: [first, second], options, near, scale })
    }

    fn first_unknown(&self, options: &Shooting<D>) -> Result<SVector<f64, D>, ShootingError> {
        let velocity = options.velocity.unwrap_or(self.near[1] - self.near[0]);
        finite("velocity", &velocity)?;
        Ok(self.near[0] + self.metric.gram(&self.near[0]) * velocity / self.scale)
    }

    fn shoot(&self, unknown: &SVector<f64, D>) -> Result<Trial<D>, ShootingError> {
        let [first, second] = self.sets;
        let start = first.project(unknown);
        let start_by_unknown = first.projection_derivative(unknown);
        let inverse = self.metric.gram(&start).try_inverse().unwrap_or_else(SMatrix::zeros);
        let velocity = inverse * (unknown - start) * self.scale;
        let momentum_by_unknown = (SMatrix::identity() - start_by_unknown) * self.scale;
        let geodesic = exponential(self.metric, &start, &velocity, &self.options.integration)?;
        let turned = turned(self.metric, &start, &velocity);
        let velocity_by_unknown = inverse * (momentum_by_unknown - turned * start_by_unknown);

        let last = &geodesic.last;
        let by_unknown = |by_start: &SMatrix<f64, D, D>, by_velocity: &SMatrix<f64, D, D>| {
            by_start * start_by_unknown + by_velocity * velocity_by_unknown
        };
        let end_by_unknown = by_unknown(&last.position_by_position, &last.position_by_velocity);
        let final_by_unknown = by_unknown(&last.velocity_by_position, &last.velocity_by_velocity);
        let (end, final_velocity) = (last.position, last.velocity);
        let gram = self.metric.gram(&end);
        let target = end - gram * final_velocity / self.scale;
        let turned = self::turned(self.metric, &end, &final_velocity);
        let target_by_unknown =
            end_by_unknown - (gram * final_by_unknown + turned * end_by_unknown) / self.scale;
        let miss = end - second.project(&target);
        let derivative = end_by_unknown - second.projection_derivative(&target) * target_by_unknown;
        Ok(Trial { geodesic, miss, derivative })
    }
}

/// Returns the derivative of `H(x)v` by `x`, for a `v` that does not depend on `x`.
fn turned<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    v: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let jets = metric.gram(&SVector::from(Jet1::variables(&(*x).into())));
    SMatrix::from_fn(|i, m| (0..D).map(|j| jets[(i.min(j), i.max(j))].first(m) * v[j]).sum())
}
