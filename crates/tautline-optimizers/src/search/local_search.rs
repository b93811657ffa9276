//! The local search on one grid: Newton's method, damped by a shift of the Hessian.

use nalgebra::SVector;
use tautline_discretizations::{LinearModel, PointSequence, QuadraticModel};
use tautline_metrics::MetricError;
use tautline_sets::ClosedSet;

use crate::{
    Curvature, Stop,
    newton::{
        discrete_energy::DiscreteEnergy,
        factorization::Factorization,
        magnitude::Magnitude,
        reduced_system::{ReducedSystem, Step},
        residual::Residual,
        rounding::{is_rounding, margin, negligible},
    },
    search::damping::{Damping, LAST_SHIFT},
};

/// Relative decrement below which Newton steps are taken without checking the energy: the promised
/// change, `10⁻¹⁰ E`, is real, but a few steps later it drowns in rounding.
const QUADRATIC_ZONE: f64 = 1e-10;

/// Relative decrement below which the Hessian before a step also serves after it: the points move
/// by its root, `10⁻⁸`, and the Hessian with them.
const SAME_HESSIAN: f64 = 1e-16;

/// Steps that promise less than this multiple of the [`negligible`] decrement are not checked
/// either: rounding of the coordinates changes the energy as much.
const NOISE: f64 = 16.0;

/// How often a search may leave a saddle at which it came to rest.
const ESCAPES: usize = 8;

/// After this many steps in a row with an indefinite Hessian, the search tries the direction of
/// most negative curvature: shifted steps near a saddle are slow, and on an axis of symmetry no
/// component of them leads away from it.
const PATIENCE: usize = 5;

/// One problem on one grid.
#[derive(Clone, Copy)]
pub(crate) struct LocalSearch<'a, const D: usize> {
    pub(crate) energy: &'a DiscreteEnergy<'a, D>,
    pub(crate) ends: [&'a dyn ClosedSet<D>; 2],
    pub(crate) iterations: usize,
    pub(crate) threads: usize,
}

/// Where a local search ended.
#[derive(Clone, Debug)]
pub(crate) struct Found<const D: usize> {
    pub(crate) sequence: PointSequence<D>,
    pub(crate) energy: f64,
    /// The mean of `tr H / D` over the nodes, in `m²/ℓ²`.
    pub(crate) mean_gram: f64,
    pub(crate) decrement: f64,
    pub(crate) residual: f64,
    pub(crate) residual_floor: f64,
    pub(crate) stop: Stop,
    pub(crate) curvature: Curvature,
    pub(crate) iterations: usize,
    /// The relative decrement at the start.
    pub(crate) from: f64,
}

impl<const D: usize> Found<D> {
    pub(crate) fn magnitude(&self) -> Magnitude {
        Magnitude { energy: self.energy, mean_gram: self.mean_gram }
    }
}

/// What to do after an iterate.
enum Next<const D: usize> {
    /// Go on from these points.
    Move(Vec<SVector<f64, D>>),
    /// End here.
    End { stop: Stop, curvature: Curvature, decrement: f64 },
    /// End at these points, one small Newton step after a positive definite Hessian.
    EndAt {
        points: Vec<SVector<f64, D>>,
        energy: f64,
        gradient: Vec<SVector<f64, D>>,
        decrement: f64,
    },
}

impl<const D: usize> LocalSearch<'_, D> {
    /// Searches from `start`, a sequence with its ends in their sets.
    ///
    /// # Errors
    ///
    /// If the metric is not finite, symmetric and positive definite at a node or an end of the
    /// result.
    pub(crate) fn run(&self, start: PointSequence<D>) -> Result<Found<D>, MetricError> {
        let mut sequence = start;
        let mut damping = Damping::default();
        let mut model = QuadraticModel::default();
        for iteration in 0.. {
            self.energy.expand(&sequence, &mut model);
            let next = if iteration == self.iterations {
                self.give_up(&model, &sequence)
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
                    (stop, curvature, decrement, model.energy, std::mem::take(&mut model.gradient))
                }
                Next::EndAt { points, energy, gradient, decrement } => {
                    sequence = PointSequence::new(points).expect("a trial is checked");
                    let curvature = Curvature::PositiveDefinite;
                    (Stop::Converged, curvature, decrement, energy, gradient)
                }
            };
            self.check(&sequence)?;
            let magnitude = Magnitude { energy, mean_gram: scale };
            let mut residual = Residual::new(sequence.n().get(), magnitude);
            residual.push_all(&gradient);
            let (residual, residual_floor) = residual.value(self.ends, &sequence, magnitude);
            let decrement = magnitude.relative(decrement);
            return Ok(Found {
                sequence,
                energy,
                mean_gram: scale,
                decrement,
                residual,
                residual_floor,
                stop,
                curvature,
                iterations: iteration + 1,
                from: f64::INFINITY,
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
        let end = |stop, decrement| {
            let curvature = self.curvature(model, sequence);
            Next::End { stop, curvature, decrement }
        };
        let negligible = negligible(Magnitude::of(model), sequence);
        let (mut rejected, mut indefinite) = (false, false);
        loop {
            let system = reduce(damping.shift);
            let Some(factorization) = system.factorize() else {
                if damping.shift >= LAST_SHIFT {
                    return end(Stop::Stalled, f64::INFINITY);
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
            let newton = system.newton_step(&factorization);
            let decrement = newton.decrement;
            // A shift divides the decrement by as much as it multiplies the Hessian.
            if decrement * (1.0 + damping.shift) <= negligible {
                if damping.shift == 0.0 {
                    return self.converge(&system, &factorization, sequence, newton, negligible);
                }
                let definite = reduce(0.0).factorize().is_some();
                if definite && !rejected {
                    damping.shift = 0.0;
                    continue;
                }
                // Stationary, but the Hessian shows no minimum, or no step was accepted: leave, if
                // there is a way down.
                damping.escapes += 1;
                let down = (!definite && damping.escapes <= ESCAPES)
                    .then(|| self.leave_saddle(model, sequence, damping.shift))
                    .flatten();
                return match down {
                    Some(points) => Next::Move(points),
                    None if rejected || damping.escapes > ESCAPES => end(Stop::Stalled, decrement),
                    None => end(Stop::Converged, decrement),
                };
            }
            let step = newton.step;
            let trial = self.retract(sequence, &step, 1.0);
            let zone = (QUADRATIC_ZONE * model.energy).max(NOISE * negligible);
            if decrement <= zone && finite(&trial) {
                if damping.shift == 0.0 {
                    if damping.stagnates(decrement) {
                        return end(Stop::Converged, decrement);
                    }
                    return if decrement <= SAME_HESSIAN * model.energy {
                        self.polish(&system, &factorization, trial, negligible)
                    } else {
                        Next::Move(trial)
                    };
                }
                damping.lower();
                return Next::Move(trial);
            }
            // A quarter of what the quadratic model sheds suffices for convergence.
            let sheds = |energy: &f64| model.energy - energy >= 0.25 * decrement;
            if let Some(reached) = self.energy.admissible(&trial).filter(sheds) {
                let longer = (damping.shift > 0.0)
                    .then(|| self.lengthen(sequence, &step, [model.energy, reached], decrement));
                damping.lower();
                return Next::Move(longer.flatten().unwrap_or(trial));
            }
            rejected = true;
            if damping.shift >= LAST_SHIFT {
                return end(Stop::Stalled, decrement);
            }
            damping.raise();
        }
    }

    /// Ends after a negligible step with a positive definite Hessian. The step is taken nevertheless, if
    /// it leads to finite points: one more gradient removes what is left of the residual.
    fn converge(
        &self,
        system: &ReducedSystem<'_, D>,
        factorization: &Factorization<D>,
        sequence: &PointSequence<D>,
        Step { step, decrement }: Step<D>,
        negligible: f64,
    ) -> Next<D> {
        let trial = self.retract(sequence, &step, 1.0);
        if finite(&trial)
            && let last @ Next::EndAt { .. } = self.polish(system, factorization, trial, negligible)
        {
            return last;
        }
        Next::End { stop: Stop::Converged, curvature: Curvature::PositiveDefinite, decrement }
    }

    /// Takes a step so small that the factorisation from before it still yields the decrement after
    /// it, for one gradient; ends there if that decrement is negligible.
    fn polish(
        &self,
        system: &ReducedSystem<'_, D>,
        factorization: &Factorization<D>,
        points: Vec<SVector<f64, D>>,
        negligible: f64,
    ) -> Next<D> {
        let trial = PointSequence::new(points).expect("the points are finite");
        let LinearModel { energy, gradient, .. } = self.energy.linear_model(&trial);
        let points = trial.into_points();
        let decrement = system.decrement_at(factorization, self.ends, &points, &gradient);
        if decrement <= negligible {
            Next::EndAt { points, energy, gradient, decrement }
        } else {
            Next::Move(points)
        }
    }

    /// Moves all points by `scale · step`, and projects the ends back to their sets.
    pub(crate) fn retract(
        &self,
        sequence: &PointSequence<D>,
        step: &[SVector<f64, D>],
        scale: f64,
    ) -> Vec<SVector<f64, D>> {
        let mut points: Vec<_> =
            sequence.points().iter().zip(step).map(|(x, s)| x + s * scale).collect();
        self.project_ends(&mut points);
        points
    }

    /// Moves both ends to their nearest points in their sets.
    pub(crate) fn project_ends(&self, points: &mut [SVector<f64, D>]) {
        let n = points.len() - 1;
        points[0] = self.ends[0].project(&points[0]);
        points[n] = self.ends[1].project(&points[n]);
    }

    /// The end of a search that has used up its steps.
    fn give_up(&self, model: &QuadraticModel<D>, sequence: &PointSequence<D>) -> Next<D> {
        let system = ReducedSystem::new(model, self.ends, sequence.points(), 0.0);
        let decrement = system
            .factorize()
            .map_or(f64::INFINITY, |factorization| system.newton_step(&factorization).decrement);
        let curvature = self.curvature(model, sequence);
        Next::End { stop: Stop::IterationLimit, curvature, decrement }
    }

    /// The signature of the Hessian; eigenvalues within its rounding count as zero.
    fn curvature(&self, model: &QuadraticModel<D>, sequence: &PointSequence<D>) -> Curvature {
        let reduce = |shift| ReducedSystem::new(model, self.ends, sequence.points(), shift);
        if reduce(0.0).factorize().is_some() {
            return Curvature::PositiveDefinite;
        }
        match reduce(2.0 * margin(sequence.n().get())).negative_eigenvalues() {
            0 => Curvature::Degenerate,
            negative => Curvature::Indefinite { negative },
        }
    }

    /// Checks the metric at every node, and at both ends, which need not be nodes.
    pub(crate) fn check(&self, sequence: &PointSequence<D>) -> Result<(), MetricError> {
        for x in [sequence.first(), sequence.last()] {
            self.energy.check_at(x)?;
        }
        self.energy.check_nodes(sequence)
    }
}

fn finite<const D: usize>(points: &[SVector<f64, D>]) -> bool {
    points.iter().all(|x| x.iter().all(|c| c.is_finite()))
}
