//! Dynamic programming with equality constraints.

use tautline::{Batches, PointSequence, Rule, Watcher};

use crate::descent::{
    Descended, Ended, Limits,
    constrained::{
        ConstrainedError, Equality,
        augmented::{At, Augmented},
        equality::Contact,
        leap::leaps,
    },
    search::Search,
};

/// Where a constrained descent ended: a sequence that may be stationary, as it says, and nothing else.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Constrained<const D: usize> {
    /// The sequence, its energy, and how the descent ended. The residual is that of the Lagrangian
    /// `E_N + Σ λₙ c(xₙ)`.
    pub descended: Descended<D>,
    /// The largest `|c(xₙ)|`, in the unit of the constraint.
    pub violation: f64,
    /// The multipliers `λₙ` of the inner points, in `m²` per unit of the constraint: if the constraint
    /// at the point `n` were `c(x) = δ`, the least energy would be `E_N − λₙ δ` to first order.
    pub multipliers: Vec<f64>,
}

/// The first shift of the Hessian relative to that of the energy for a bend of the whole curve, the
/// factor from one to the next, and the last.
const SHIFTS: [f64; 3] = [1.0, 8.0, 1e18];

/// The factor by which the penalty parameter `μ` falls where the violation does not, and the least
/// `μ`, relative to the one whose penalty is as stiff as the energy between neighbours. With so small
/// a `μ` multipliers converge by themselves, in all directions.
const LESS: f64 = 0.1;
const LEAST: f64 = 1e-9;

/// The fraction of the violation that may be left once multipliers are updated, and the first
/// violation that may be left, relative to that at the distance of a whole curve.
const REDUCTION: f64 = 0.1;

/// The first tolerance of the inner problem.
const FIRST_TOLERANCE: f64 = 1e-2;

/// A violation is stationary where the surface is this number of lengths of the curve away, to
/// first order.
const FAR: f64 = 1e4;

/// Minimises a discrete energy between the ends of `start` among the sequences whose points satisfy
/// `constraint`, by differential dynamic programming on a primal-dual augmented Lagrangian,
///
/// ```text
/// E_N(x) + Σₙ (λₙᵉ c(xₙ) + c(xₙ)²/2μ + μ (λₙᵉ + c(xₙ)/μ − λₙ)²/2)
/// ```
///
/// A backward pass with the second derivatives of the Lagrangian at `λ`, a shift of the Hessian (the
/// proximal term) and a forward pass, as in
/// [`dynamic_programming`](crate::descent::dynamic_programming), minimise it over points and
/// multipliers `λ` for given estimates `λᵉ`. Where that is done and the violation has fallen enough,
/// the estimates become `λ`; otherwise `μ` falls. The descent ends when the residual of the
/// Lagrangian is at most the tolerance of `limits`, and no violation exceeds `feasibility`, in the
/// unit of the constraint, or what the rounding of its point causes.
///
/// Between two points of a surface there is always a sequence whose points are on it, even if no
/// curve is: [`Ended::Leaping`] tells that a chord crosses a gap, and [`Ended::Infeasible`] that
/// points are caught where the violation has a minimum.
///
/// `watcher` sees each iterate, with the residual of the Lagrangian, and can end the descent.
///
/// ```
/// # use std::ops::ControlFlow;
/// # use nalgebra::{SMatrix, SVector};
/// # use tautline::{Iterate, PointSequence, Prepared, Rule, Scalar, gallery::Constant};
/// # use tautline_baselines::descent::{Equality, Limits, constrained_dynamic_programming};
/// struct UnitSphere;
/// impl Equality<3> for UnitSphere {
///     fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
///         x[0].sqr() + x[1].sqr() + x[2].sqr() - 1.0
///     }
/// }
/// // A quarter of a great circle, from the chord below it.
/// let flat = Prepared::new(Constant::new(SMatrix::<f64, 3, 3>::identity())?);
/// let start = PointSequence::straight([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], 100)?;
/// let watch = &mut |_: &Iterate<'_, 3>| ControlFlow::Continue(());
/// let limits = Limits::default();
/// let found = constrained_dynamic_programming(
///     &flat, Rule::TRAPEZOIDAL, start, &UnitSphere, 1e-10, &limits, watch,
/// )?;
/// let length = found.descended.energy.sqrt();
/// assert!((length - std::f64::consts::FRAC_PI_2).abs() < 1e-4);
/// assert!(found.violation <= 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`ConstrainedError`].
///
/// # Source
///
/// W. Jallet, A. Bambade, N. Mansard, J. Carpentier, Constrained differential dynamic programming: a
/// primal-dual augmented Lagrangian approach, IROS 2022; the function is that of P. E. Gill,
/// D. P. Robinson, Comput. Optim. Appl. 51 (2012), and the rule for `μ` and the multipliers is
/// after that of A. R. Conn, N. I. M. Gould, P. L. Toint, SIAM J. Numer. Anal. 28 (1991), with a tenth
/// of the last violation in place of a power of `μ`.
pub fn constrained_dynamic_programming<'a, const D: usize>(
    metric: &'a dyn Batches<D>,
    rule: Rule,
    start: PointSequence<D>,
    constraint: &impl Equality<D>,
    feasibility: f64,
    limits: &Limits,
    watcher: &'a mut Watcher<'a, D>,
) -> Result<Constrained<D>, ConstrainedError> {
    let scale = check(&start, constraint, feasibility)?;
    let (mut search, here) = Search::begin(metric, rule, start, limits, watcher)?;
    let zeros = vec![0.0; here.sequence.n().get() - 1];
    // The penalty is about `E_N` where all points are as far off as the curve is long. It would be
    // as stiff as the energy between neighbours if it were `N²` times as large.
    let stiff = scale.powi(2) / here.stiffness();
    let parameter = (here.sequence.n().get() as f64).powi(2) * stiff;
    let mut problem = Inner {
        least: LEAST * stiff,
        augmented: Augmented { centre: zeros.clone(), parameter },
        allowed: REDUCTION * scale * size(&here.sequence),
        tolerance: FIRST_TOLERANCE.max(limits.tolerance),
        rounded: f64::INFINITY,
    };
    let mut at = At::new(constraint, here, zeros);
    let (mut shift, mut is_rounded) = (0.0, false);
    for iteration in 0.. {
        let is_feasible = at.contacts.iter().all(|contact| contact.holds(feasibility));
        let mut ended = search.end_if(&at.here, iteration, is_feasible);
        if ended == Some(Ended::Stationary)
            && let Some(chord) = leaps(constraint, &at.here.sequence)
        {
            ended = Some(Ended::Leaping { chord });
        }
        // Each inner problem has a step of its own.
        if ended.is_none() && iteration > 0 {
            let residuals = problem.augmented.residuals(&search, &at);
            if is_rounded || residuals[0].max(residuals[1]) <= problem.tolerance {
                ended =
                    problem.solved(&at, feasibility, limits, is_rounded.then_some(residuals[0]));
            }
        }
        let there = match ended {
            Some(_) => None,
            None => newton(&mut search, constraint, &problem.augmented, &at, &mut shift),
        };
        let Some((there, was_rounded)) = there else {
            let violation = at.violation();
            let At { here, multipliers, .. } = at;
            let descended = search.descended(here, ended.unwrap_or(Ended::Stalled), iteration);
            return Ok(Constrained { descended, violation, multipliers });
        };
        (at, is_rounded) = (there, was_rounded);
    }
    unreachable!("a descent ends at its limit of steps")
}

/// Takes a step that lowers `M`, with a shift that starts at `shift`. Returns the next iterate, and
/// whether rounding hides the decrease of `M`; `None` if no step lowers it.
fn newton<const D: usize>(
    search: &mut Search<'_, D>,
    constraint: &impl Equality<D>,
    augmented: &Augmented,
    at: &At<D>,
    shift: &mut f64,
) -> Option<(At<D>, bool)> {
    let [first, factor, last] = SHIFTS;
    // On the edge of positive definite, two programs may round to either side.
    let chords = augmented.chords(search, at)?;
    let rounding = augmented.rounding(at);
    // The bend of the energy along the whole curve, of which indefinite directions have a multiple.
    let unit = at.here.stiffness() / (chords.len() as f64).powi(2);
    let mut is_refused = false;
    while *shift <= last {
        if let Some(step) = augmented.step(at, &chords, *shift * unit) {
            let is_rounded = step.decrease <= rounding;
            // A shift that makes the step negligible is no remedy for one that does not descend.
            if is_refused && is_rounded {
                return None;
            }
            if let Some(there) = augmented.follow(search, constraint, at, &step) {
                *shift = if *shift <= first { 0.0 } else { *shift / factor };
                return Some((there, is_rounded));
            }
            is_refused = true;
        }
        *shift = (factor * *shift).max(first);
    }
    None
}

/// The inner problem: the function `M` to minimise, and how well.
struct Inner {
    augmented: Augmented,
    /// The least `μ`.
    least: f64,
    /// The violation at the minimum up to which the multipliers are updated.
    allowed: f64,
    /// The residual at which it is solved.
    tolerance: f64,
    /// The residual of the last feasible iterate where rounding hid the decrease of `M`.
    rounded: f64,
}

impl Inner {
    /// Replaces the problem, solved at `at`, by the next one, or returns how the descent ends.
    /// `rounded` is the residual if rounding hides the decrease of `M`.
    fn solved<const D: usize>(
        &mut self,
        at: &At<D>,
        feasibility: f64,
        limits: &Limits,
        rounded: Option<f64>,
    ) -> Option<Ended> {
        let far = FAR * size(&at.here.sequence);
        let mut off = at.contacts.iter().filter(|contact| !contact.holds(feasibility)).peekable();
        let is_feasible = off.peek().is_none();
        let violation = at.violation();
        if let Some(residual) = rounded.filter(|_| is_feasible) {
            // Newton's method would square it: what is left is rounding too.
            if residual > 0.5 * self.rounded {
                return Some(Ended::Stalled);
            }
            self.rounded = residual;
        }
        if is_feasible || violation <= self.allowed {
            self.augmented.centre.clone_from(&at.multipliers);
            self.allowed = REDUCTION * violation;
            self.tolerance = (REDUCTION * self.tolerance).max(limits.tolerance);
        } else if off.all(|contact| contact.value.abs() > far * contact.slope.norm()) {
            return Some(Ended::Infeasible);
        } else if self.augmented.parameter <= self.least {
            return Some(Ended::Stalled);
        } else {
            self.augmented.parameter *= LESS;
        }
        None
    }
}

/// Checks the constraint along a start, and returns the root mean square of its slopes, or 1 if it has
/// none, so that every unit is as good.
fn check<const D: usize>(
    start: &PointSequence<D>,
    constraint: &impl Equality<D>,
    feasibility: f64,
) -> Result<f64, ConstrainedError> {
    if !(feasibility >= 0.0) {
        return Err(ConstrainedError::Feasibility { feasibility });
    }
    let mut sum = 0.0;
    for (point, x) in start.points().iter().enumerate() {
        let Contact { value, slope, .. } = Contact::at(constraint, x);
        let slope = slope.norm();
        if !(value.is_finite() && slope.powi(2).is_finite()) {
            return Err(ConstrainedError::NotFinite { point, value, slope });
        }
        sum += slope.powi(2);
    }
    for (end, x) in [("first", start.first()), ("last", start.last())] {
        let contact = Contact::at(constraint, x);
        if !contact.holds(feasibility) {
            return Err(ConstrainedError::End { end, value: contact.value, feasibility });
        }
    }
    let scale = (sum / start.points().len() as f64).sqrt();
    Ok(if scale > 0.0 { scale } else { 1.0 })
}

/// Returns the distance of the farthest point from the first.
fn size<const D: usize>(sequence: &PointSequence<D>) -> f64 {
    let first = sequence.first();
    sequence.points().iter().map(|x| (x - first).norm()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use nalgebra::{SVector, vector};
    use tautline::{Iterate, PointSequence, Prepared, Rule, gallery::Bump};

    use super::{constrained_dynamic_programming, size};
    use crate::descent::{Ended, Limits, constrained::equality::tests::Circle};

    #[test]
    fn a_curve_is_as_large_as_its_farthest_point_is_away() {
        let points =
            vec![vector![1.0, 1.0], vector![4.0, 5.0], vector![2.0, 1.0], vector![1.0, 1.0]];
        assert_eq!(size(&PointSequence::new(points).expect("finite")), 5.0);
    }

    /// A curve that begins and ends at one point of the unit circle and runs once around a bump in its centre,
    /// over which it does not contract. By symmetry all chords have the angle `2π/N`, and their middles are at
    /// the radius `cos(π/N)`.
    #[test]
    fn a_closed_curve_on_a_circle_runs_around_it() {
        let bump = Prepared::new(Bump::new(4.0, 0.5).expect("a bump"));
        let n = 24;
        let at = |k: usize| {
            let angle = std::f64::consts::TAU * (k % n) as f64 / n as f64;
            SVector::from([angle.cos(), 1.2 * angle.sin()])
        };
        let start = PointSequence::new((0..=n).map(at).collect()).expect("finite");
        let watch = &mut |_: &Iterate<'_, 2>| ControlFlow::Continue(());
        let limits = Limits { tolerance: 1e-7, iterations: 500 };
        let found = constrained_dynamic_programming(
            &bump,
            Rule::TRAPEZOIDAL,
            start,
            &Circle,
            1e-11,
            &limits,
            watch,
        )
        .expect("a metric");
        let ended = found.descended.ended;
        assert_eq!(ended, Ended::Stationary, "{} {:e}", found.descended.energy, found.violation);
        let (chords, half) = (n as f64, std::f64::consts::PI / n as f64);
        let cost = 1.0 + 4.0 * (-2.0 * half.cos().powi(2)).exp();
        let expected = (cost * chords * 2.0 * half.sin()).powi(2);
        // The square of the residual, and the feasibility times the forces of all points.
        assert!(
            (found.descended.energy / expected - 1.0).abs() < 1e-8,
            "{}",
            found.descended.energy
        );
    }
}
