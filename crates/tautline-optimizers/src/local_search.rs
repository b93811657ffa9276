//! The local search on one grid: Newton's method, damped by a shift of the Hessian.

use nalgebra::SVector;
use tautline_discretizations::{PointSequence, QuadraticModel, Rule, energy_gradient};
use tautline_metrics::{Metric, MetricError, check_gram};
use tautline_sets::ClosedSet;

use crate::{
    Curvature, Stop,
    end_frame::EndFrame,
    factorization::Factorization,
    reduced_system::{ReducedSystem, Step},
};

/// Relative decrement below which Newton steps are taken without looking at the energy: the
/// promised change, `10⁻¹⁰ E`, is real, but a few steps later it drowns in rounding.
const QUADRATIC_ZONE: f64 = 1e-10;

/// Relative decrement at which the energy cannot be lowered in `f64`.
const CONVERGED: f64 = 1e-15;

/// The first shift, and the factor between shifts; beyond the last, steps are so short that
/// an energy that still does not fall will not.
const FIRST_SHIFT: f64 = 1e-2;
const SHIFT_FACTOR: f64 = 8.0;
const LAST_SHIFT: f64 = 1e12;

/// How often a search may leave a saddle at which it had come to rest.
const ESCAPES: usize = 8;

/// After this many steps in a row with an indefinite Hessian, the search tries the direction
/// of its most negative curvature: the shifted steps towards a saddle are slow, and on an
/// axis of symmetry they have no component that leads away from it.
const PATIENCE: usize = 5;

/// One problem on one grid.
#[derive(Clone, Copy)]
pub(crate) struct LocalSearch<'a, M, R, const D: usize> {
    pub(crate) metric: &'a M,
    pub(crate) rule: R,
    pub(crate) ends: [&'a dyn ClosedSet<D>; 2],
    pub(crate) iterations: usize,
}

/// Where a local search ended.
#[derive(Clone, Debug)]
pub(crate) struct Found<const D: usize> {
    pub(crate) sequence: PointSequence<D>,
    pub(crate) energy: f64,
    pub(crate) decrement: f64,
    pub(crate) residual: f64,
    pub(crate) residual_floor: f64,
    pub(crate) stop: Stop,
    pub(crate) curvature: Curvature,
    pub(crate) iterations: usize,
}

/// What a search carries from one iterate to the next.
#[derive(Default)]
struct Damping {
    /// The factor `μ` of the regulariser.
    shift: f64,
    /// Steps in a row with an indefinite Hessian.
    indefinite: usize,
    /// Saddles that were left.
    escapes: usize,
}

impl Damping {
    fn raise(&mut self) {
        self.shift = (self.shift * SHIFT_FACTOR).max(FIRST_SHIFT);
    }

    fn lower(&mut self) {
        self.shift = if self.shift <= FIRST_SHIFT { 0.0 } else { self.shift / SHIFT_FACTOR };
    }
}

/// What to do after looking at one iterate.
enum Next<const D: usize> {
    /// Go on from these points.
    Move(Vec<SVector<f64, D>>),
    /// End here.
    End { stop: Stop, curvature: Curvature, decrement: f64 },
    /// End at these points, one small Newton step away from a positive definite Hessian.
    EndAt {
        points: Vec<SVector<f64, D>>,
        energy: f64,
        gradient: Vec<SVector<f64, D>>,
        decrement: f64,
    },
}

impl<M: Metric<D>, R: Rule, const D: usize> LocalSearch<'_, M, R, D> {
    /// Searches from `start`, whose ends lie in their sets.
    ///
    /// # Errors
    ///
    /// If the Gram matrix is not finite, symmetric and positive definite at a node of the
    /// start or of the result.
    pub(crate) fn run(&self, start: PointSequence<D>) -> Result<Found<D>, MetricError> {
        self.check(&start)?;
        let mut sequence = start;
        let mut damping = Damping::default();
        for iteration in 0.. {
            let model = QuadraticModel::new(self.rule, self.metric, &sequence);
            let next = if iteration == self.iterations {
                let system = ReducedSystem::new(&model, self.ends, sequence.points(), 0.0);
                let curvature = self.curvature(&system);
                Next::End { stop: Stop::IterationLimit, curvature, decrement: f64::INFINITY }
            } else if is_rounding(&model, &sequence) {
                let curvature = Curvature::PositiveDefinite;
                Next::End { stop: Stop::EndsTouch, curvature, decrement: 0.0 }
            } else {
                self.next(&model, &sequence, &mut damping)
            };
            let scale = model.mean_gram;
            let (stop, curvature, decrement, energy, gradient) = match next {
                Next::Move(points) => {
                    sequence = PointSequence::new(points).expect("a trial is checked");
                    continue;
                }
                Next::End { stop, curvature, decrement } => {
                    (stop, curvature, decrement, model.energy, model.gradient)
                }
                Next::EndAt { points, energy, gradient, decrement } => {
                    sequence = PointSequence::new(points).expect("a trial is checked");
                    let curvature = Curvature::PositiveDefinite;
                    (Stop::Converged, curvature, decrement, energy, gradient)
                }
            };
            self.check(&sequence)?;
            let (residual, residual_floor) = self.residual(&sequence, energy, &gradient, scale);
            let decrement = if energy > 0.0 { decrement / energy } else { 0.0 };
            return Ok(Found {
                sequence,
                energy,
                decrement,
                residual,
                residual_floor,
                stop,
                curvature,
                iterations: iteration + 1,
            });
        }
        unreachable!("the loop ends at the limit of iterations")
    }

    /// Decides on the next iterate; adapts the damping.
    fn next(
        &self,
        model: &QuadraticModel<D>,
        sequence: &PointSequence<D>,
        damping: &mut Damping,
    ) -> Next<D> {
        let reduce = |shift| ReducedSystem::new(model, self.ends, sequence.points(), shift);
        let end = |stop, curvature, decrement| Next::End { stop, curvature, decrement };
        let (mut rejected, mut indefinite) = (false, false);
        loop {
            let system = reduce(damping.shift);
            let Some(factorization) = system.factorize() else {
                if damping.shift >= LAST_SHIFT {
                    return end(Stop::Stalled, self.curvature(&system), f64::INFINITY);
                }
                indefinite = true;
                damping.raise();
                continue;
            };
            if indefinite {
                damping.indefinite += 1;
                if damping.indefinite.is_multiple_of(PATIENCE)
                    && let Some(points) = self.leave_saddle(model, sequence, damping.shift)
                {
                    return Next::Move(points);
                }
                indefinite = false;
            } else if damping.shift == 0.0 {
                damping.indefinite = 0;
            }
            let Step { step, decrement } = system.newton_step(&factorization);
            if decrement <= CONVERGED * model.energy {
                if damping.shift == 0.0 {
                    return end(Stop::Converged, Curvature::PositiveDefinite, decrement);
                }
                let plain = reduce(0.0);
                let definite = plain.factorize().is_some();
                if definite && !rejected {
                    damping.shift = 0.0;
                    continue;
                }
                // Stationary, and not a minimum as far as the Hessian tells (or no step was
                // any good): leave, if it leads down anywhere.
                damping.escapes += 1;
                let down = (!definite && damping.escapes <= ESCAPES)
                    .then(|| self.leave_saddle(model, sequence, damping.shift))
                    .flatten();
                return match down {
                    Some(points) => Next::Move(points),
                    None if rejected || damping.escapes > ESCAPES => {
                        end(Stop::Stalled, self.curvature(&plain), decrement)
                    }
                    None => end(Stop::Converged, Curvature::Degenerate, decrement),
                };
            }
            let trial = self.retract(sequence, &step, 1.0);
            if decrement <= QUADRATIC_ZONE * model.energy && finite(&trial) {
                return self.polish(model, &system, &factorization, trial, damping.shift);
            }
            // A quarter of what the quadratic model sheds is enough to converge.
            let sheds = |energy| model.energy - energy >= 0.25 * decrement;
            if self.admissible_energy(&trial).is_some_and(sheds) {
                damping.lower();
                return Next::Move(trial);
            }
            rejected = true;
            if damping.shift >= LAST_SHIFT {
                return end(Stop::Stalled, self.curvature(&reduce(0.0)), decrement);
            }
            damping.raise();
        }
    }

    /// Takes a step so small that the factorisation still tells the decrement behind it, at
    /// the price of a gradient; ends there if that has converged.
    fn polish(
        &self,
        model: &QuadraticModel<D>,
        system: &ReducedSystem<'_, D>,
        factorization: &Factorization<D>,
        points: Vec<SVector<f64, D>>,
        shift: f64,
    ) -> Next<D> {
        if shift > 0.0 {
            return Next::Move(points);
        }
        let trial = PointSequence::new(points).expect("the points are finite");
        let (energy, gradient) = energy_gradient(self.rule, self.metric, &trial);
        let points = trial.into_points();
        let decrement = system.decrement_at(factorization, self.ends, &points, &gradient);
        if decrement <= CONVERGED * model.energy {
            Next::EndAt { points, energy, gradient, decrement }
        } else {
            Next::Move(points)
        }
    }

    /// Walks down from a saddle, along the direction of the most negative curvature.
    fn leave_saddle(
        &self,
        model: &QuadraticModel<D>,
        sequence: &PointSequence<D>,
        shift: f64,
    ) -> Option<Vec<SVector<f64, D>>> {
        // The smallest shift that makes the system definite, to 1 in 16: the direction which
        // is flattest there is the one of most negative curvature.
        let (mut low, mut high) = (0.0, shift);
        let factorized = |shift: f64| {
            let system = ReducedSystem::new(model, self.ends, sequence.points(), shift);
            system.factorize().map(|factorization| (system, factorization))
        };
        while factorized(high / SHIFT_FACTOR).is_some() {
            high /= SHIFT_FACTOR;
            if high < f64::MIN_POSITIVE {
                return None;
            }
        }
        for _ in 0..6 {
            let middle = 0.5 * (low + high);
            *(if factorized(middle).is_some() { &mut high } else { &mut low }) = middle;
        }
        let (system, factorization) = factorized(high)?;
        let mut direction = system.flattest_direction(&factorization);
        let size = extent(sequence.points());
        let largest = direction.iter().map(|v| v.amax()).fold(0.0, f64::max);
        direction.iter_mut().for_each(|v| *v *= size / largest);
        let mut best: Option<(f64, Vec<_>)> = None;
        // From 1e-4 of the size of the curve on, as long as it leads down on one of both sides.
        for exponent in 0..14 {
            let length = 1e-4 * f64::from(1 << exponent);
            let lower = [length, -length]
                .into_iter()
                .filter_map(|s| {
                    let trial = self.retract(sequence, &direction, s);
                    self.admissible_energy(&trial).map(|energy| (energy, trial))
                })
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let limit = best.as_ref().map_or(model.energy * (1.0 - 1e-13), |best| best.0);
            match lower {
                Some(lower) if lower.0 < limit => best = Some(lower),
                _ if best.is_some() => break,
                _ => {}
            }
        }
        best.map(|(_, points)| points)
    }

    /// Moves the inner points by `scale · step`, and the ends likewise and back to their sets.
    fn retract(
        &self,
        sequence: &PointSequence<D>,
        step: &[SVector<f64, D>],
        scale: f64,
    ) -> Vec<SVector<f64, D>> {
        let mut points: Vec<_> =
            sequence.points().iter().zip(step).map(|(x, s)| x + s * scale).collect();
        let n = points.len() - 1;
        points[0] = self.ends[0].project(&points[0]);
        points[n] = self.ends[1].project(&points[n]);
        points
    }

    /// The energy of a trial; `None` if it is not finite or a chord has a negative one, that
    /// is, if the step left the region where the metric is one.
    fn admissible_energy(&self, points: &[SVector<f64, D>]) -> Option<f64> {
        let trial = PointSequence::new(points.to_vec()).ok()?;
        // The root of a negative number is NaN.
        let length = self.rule.length(self.metric, &trial);
        let energy = self.rule.energy(self.metric, &trial);
        (length.is_finite() && energy.is_finite()).then_some(energy)
    }

    fn curvature(&self, system: &ReducedSystem<'_, D>) -> Curvature {
        match system.factorize() {
            Some(_) => Curvature::PositiveDefinite,
            None => Curvature::Indefinite { negative: system.negative_eigenvalues() },
        }
    }

    /// Checks the Gram matrix at every node.
    fn check(&self, sequence: &PointSequence<D>) -> Result<(), MetricError> {
        for (x, chord) in sequence.chords() {
            for node in R::NODES {
                check_gram(self.metric, &(x + chord * node.fraction))?;
            }
        }
        Ok(())
    }

    /// The residual and its floor: see [`Minimum`](crate::Minimum).
    fn residual(
        &self,
        sequence: &PointSequence<D>,
        energy: f64,
        gradient: &[SVector<f64, D>],
        mean_gram: f64,
    ) -> (f64, f64) {
        let points = sequence.points();
        let last = points.len() - 1;
        let n = last as f64;
        let momentum = (mean_gram * energy).sqrt();
        if !(momentum > 0.0) {
            return (0.0, 0.0);
        }
        let sum: f64 = gradient[1..last].iter().map(SVector::norm_squared).sum();
        let inner = 0.5 * n * (sum / n).sqrt();
        let tau = 1.0 / (2.0 * n * mean_gram);
        let at_end = |set: &dyn ClosedSet<D>, k: usize| {
            0.5 * EndFrame::new(set, &points[k], &gradient[k], tau).projected_gradient.norm()
        };
        let ends = at_end(self.ends[0], 0).max(at_end(self.ends[1], last));
        let floor = f64::EPSILON * n * n * extent_from_origin(points) * mean_gram;
        ((inner + ends) / momentum, floor / momentum)
    }
}

/// Whether all chords are nothing but the rounding of their ends.
fn is_rounding<const D: usize>(model: &QuadraticModel<D>, sequence: &PointSequence<D>) -> bool {
    let chord = 4.0 * f64::EPSILON * extent_from_origin(sequence.points());
    let n = sequence.n().get() as f64;
    (sequence.last() - sequence.first()).amax() <= chord
        && model.energy <= model.mean_gram * (n * chord).powi(2)
}

/// The largest coordinate of any point.
fn extent_from_origin<const D: usize>(points: &[SVector<f64, D>]) -> f64 {
    points.iter().map(|x| x.amax()).fold(0.0, f64::max)
}

/// The largest distance, by a coordinate, from the first point.
fn extent<const D: usize>(points: &[SVector<f64, D>]) -> f64 {
    points.iter().map(|x| (x - points[0]).amax()).fold(0.0, f64::max)
}

fn finite<const D: usize>(points: &[SVector<f64, D>]) -> bool {
    points.iter().all(|x| x.iter().all(|c| c.is_finite()))
}
