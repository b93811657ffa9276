//! Dynamic programming with equality constraints, by an augmented Lagrangian.

use nalgebra::SVector;
use tautline::{Batches, ChordModel, Jet2, LinearModel, PointSequence, Rule, Scalar, Watcher};

use crate::descent::{
    Descended, DescentError, Ended, Limits,
    chord_models::chord_models,
    dynamic_programming::Policy,
    search::{Here, Search},
};

/// An equality `c(x) = 0` that every point of a curve has to satisfy: a surface on which it runs.
///
/// ```
/// use nalgebra::SVector;
/// use tautline::Scalar;
/// use tautline_baselines::descent::Equality;
///
/// struct UnitSphere;
/// impl Equality<3> for UnitSphere {
///     fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
///         x[0].sqr() + x[1].sqr() + x[2].sqr() - 1.0
///     }
/// }
/// ```
pub trait Equality<const D: usize> {
    /// Returns `c(x)`, in whatever unit. Its derivatives follow from the formula.
    fn value<S: Scalar>(&self, x: &SVector<S, D>) -> S;
}

/// Where a constrained descent ended: a sequence that is called stationary or not, and not more.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Constrained<const D: usize> {
    /// The sequence, its energy, and how the descent ended. The residual is that of the Lagrangian
    /// `E_N + Σ λₙ c(xₙ)`.
    pub descended: Descended<D>,
    /// The largest `|c(xₙ)|`.
    pub violation: f64,
    /// The multipliers `λₙ` of the inner points.
    pub multipliers: Vec<f64>,
}

/// Why there is no constrained descent.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConstrainedError {
    /// The start has no metric or no energy, or the tolerance is no number.
    #[error(transparent)]
    Descent(#[from] DescentError),
    /// An end of the start, which stays where it is, does not satisfy the constraint.
    #[error("the constraint is {violation} at the {end} end, and not 0 up to {feasibility}")]
    End {
        /// "first" or "last".
        end: &'static str,
        /// The value of the constraint there.
        violation: f64,
        /// The largest violation that is accepted.
        feasibility: f64,
    },
}

/// The first shift of the control Hessian, the factor from one to the next, and the last.
const SHIFTS: [f64; 3] = [1e-3, 8.0, 1e12];

/// The shortest step along the policy.
const SHORTEST: f64 = 1e-6;

/// The factor by which the penalty parameter `μ` falls where a violation does not, and the least of
/// them relative to the first.
const LESS: f64 = 0.1;
const LEAST: f64 = 1e-10;

/// The first tolerances of the inner problem and of the violation, relative to what it was.
const FIRST_TOLERANCE: f64 = 1e-2;
const FIRST_VIOLATION: f64 = 0.1;

/// Minimises a discrete energy between the ends of `start` among the sequences whose points satisfy
/// `constraint`, by differential dynamic programming on an augmented Lagrangian,
///
/// ```text
/// E_N(x) + Σₙ (λₙ c(xₙ) + c(xₙ)²/2μ)
/// ```
///
/// A backward pass with second derivatives, a shift of the Hessian of the controls (the proximal
/// term) and a forward pass, as in [`dynamic_programming`](crate::descent::dynamic_programming),
/// minimise it for given multipliers. Where the violation has fallen enough, the multipliers become
/// `λₙ + c(xₙ)/μ`; otherwise `μ` falls. The descent ends when the residual of the Lagrangian is at
/// most the tolerance of `limits`, and no violation exceeds `feasibility`.
///
/// `watcher` sees each iterate, with the residual of the Lagrangian, and can end the descent.
///
/// # Errors
///
/// [`ConstrainedError`].
///
/// # Source
///
/// W. Jallet, A. Bambade, N. Mansard, J. Carpentier, Constrained differential dynamic programming: a
/// primal-dual augmented Lagrangian approach, IROS 2022; the rule for `μ` and the multipliers is
/// that of A. R. Conn, N. I. M. Gould, P. L. Toint, SIAM J. Numer. Anal. 28 (1991).
pub fn constrained_dynamic_programming<'a, const D: usize, R: Rule>(
    metric: &'a dyn Batches<D>,
    rule: R,
    start: PointSequence<D>,
    constraint: &impl Equality<D>,
    feasibility: f64,
    limits: &Limits,
    watcher: &'a mut Watcher<'a, D>,
) -> Result<Constrained<D>, ConstrainedError> {
    for (end, x) in [("first", start.first()), ("last", start.last())] {
        let violation = constraint.value(x);
        if !(violation.abs() <= feasibility) {
            return Err(ConstrainedError::End { end, violation, feasibility });
        }
    }
    let (mut search, here) = Search::begin(metric, rule, start, limits, watcher)?;
    let mut penalty = Penalty {
        multipliers: vec![0.0; here.sequence.n().get() - 1],
        parameter: 1.0 / here.stiffness(),
    };
    let least = LEAST * penalty.parameter;
    let (mut sequence, mut shift) = (here.sequence, 0.0);
    let [first, factor, last] = SHIFTS;
    let mut tolerance = FIRST_TOLERANCE.max(limits.tolerance);
    let mut allowed = None;
    for iteration in 0.. {
        search.evaluations += 1;
        let (here, chords, violation) = penalty.expand(&search, constraint, sequence);
        let allow = *allowed.get_or_insert(FIRST_VIOLATION * violation);
        let finish = |search: &Search<'_, R, D>, here, penalty: &Penalty, ended| {
            let multipliers = penalty.estimates(constraint, &here);
            let descended = search.descended(here, ended, iteration);
            Ok(Constrained { descended, violation, multipliers })
        };
        if let Some(ended) = search.end_if(&here, iteration, violation <= feasibility) {
            return finish(&search, here, &penalty, ended);
        }
        let mut there = None;
        if search.residual(&here) > tolerance {
            there = loop {
                let policy = Policy::new(&chords, shift * here.stiffness());
                let found = policy
                    .and_then(|policy| penalty.follow(&mut search, constraint, &here, &policy));
                if found.is_some() || shift > last {
                    break found;
                }
                shift = (factor * shift).max(first);
            };
            shift = if shift <= first { 0.0 } else { shift / factor };
        }
        // The inner problem is solved as far as it can be: on to another.
        let Some(there) = there else {
            if violation <= allow.max(feasibility) {
                penalty.multipliers = penalty.estimates(constraint, &here);
                allowed = Some(FIRST_VIOLATION * violation);
            } else if penalty.parameter > least {
                penalty.parameter *= LESS;
            } else {
                return finish(&search, here, &penalty, Ended::Stalled);
            }
            tolerance = (LESS * tolerance).max(limits.tolerance);
            sequence = here.sequence;
            continue;
        };
        sequence = there;
    }
    unreachable!("a descent ends at its limit of steps")
}

/// The multipliers `λₙ` of the inner points and the parameter `μ`.
struct Penalty {
    multipliers: Vec<f64>,
    parameter: f64,
}

impl Penalty {
    /// Returns the estimates `λₙ + c(xₙ)/μ` of the multipliers.
    fn estimates<const D: usize>(&self, constraint: &impl Equality<D>, here: &Here<D>) -> Vec<f64> {
        let inner = here.sequence.points()[1..].iter();
        let both = inner.zip(&self.multipliers);
        both.map(|(x, multiplier)| multiplier + constraint.value(x) / self.parameter).collect()
    }

    /// Returns the energy with the gradient of the augmented Lagrangian, which is that of the
    /// Lagrangian with the estimates of the multipliers; the models of the chords with what the
    /// constraint adds at the points where they end; and the largest violation.
    fn expand<R: Rule, const D: usize>(
        &self,
        search: &Search<'_, R, D>,
        constraint: &impl Equality<D>,
        sequence: PointSequence<D>,
    ) -> (Here<D>, Vec<ChordModel<D>>, f64) {
        let mut chords = chord_models(search.metric, R::NODES, &sequence);
        let energy = chords.iter().map(|chord| chord.energy).sum();
        let mut gradient = vec![SVector::zeros(); chords.len() + 1];
        let mut violation = 0.0_f64;
        for (k, multiplier) in self.multipliers.iter().enumerate() {
            let x = &sequence.points()[k + 1];
            let jet = constraint.value(&SVector::from(Jet2::variables(&(*x).into())));
            let value = jet.value();
            violation = if value.is_nan() { f64::INFINITY } else { violation.max(value.abs()) };
            let estimate = multiplier + value / self.parameter;
            let slope = SVector::<f64, D>::from_fn(|i, _| jet.first(i));
            chords[k].gradient[1] += slope * estimate;
            for i in 0..D {
                for j in 0..D {
                    let bend = estimate * jet.second(i, j) + slope[i] * slope[j] / self.parameter;
                    chords[k].hessian[1][(i, j)] += bend;
                }
            }
        }
        for (k, chord) in chords.iter().enumerate() {
            gradient[k] += chord.gradient[0];
            gradient[k + 1] += chord.gradient[1];
        }
        let model = LinearModel { energy, gradient, is_metric: true };
        (Here { sequence, model }, chords, violation)
    }

    /// Returns what the constraint adds to the energy.
    fn at<const D: usize>(&self, constraint: &impl Equality<D>, points: &[SVector<f64, D>]) -> f64 {
        let both = points[1..].iter().zip(&self.multipliers);
        both.map(|(x, multiplier)| {
            let value = constraint.value(x);
            multiplier * value + value * value / (2.0 * self.parameter)
        })
        .sum()
    }

    /// Follows a policy, all the way or less, until the augmented Lagrangian falls enough.
    fn follow<R: Rule, const D: usize>(
        &self,
        search: &mut Search<'_, R, D>,
        constraint: &impl Equality<D>,
        here: &Here<D>,
        policy: &Policy<D>,
    ) -> Option<PointSequence<D>> {
        let added = self.at(constraint, here.sequence.points());
        let mut scale = 1.0;
        while scale >= SHORTEST {
            let points = policy.roll_out(here.sequence.points(), scale);
            let promised = (2.0 * scale - scale * scale) * policy.decrease;
            if let Some(energy) = search.energy(&points)
                && here.falls_enough(energy + self.at(constraint, &points) - added, promised)
                && let Ok(sequence) = PointSequence::new(points)
            {
                return Some(sequence);
            }
            scale *= 0.5;
        }
        None
    }
}
