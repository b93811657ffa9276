//! One damped step of a [`LocalSearch`]: Newton's method with a shift of the Hessian.

use nalgebra::SVector;
use tautline_discretizations::{LinearModel, PointSequence, QuadraticModel};

use crate::{
    Curvature, Stop,
    newton::{
        factorization::Factorization,
        magnitude::Magnitude,
        reduced_system::{ReducedSystem, Step},
        rounding::negligible,
    },
    search::{
        damping::{Damping, LAST_SHIFT},
        local_search::{LocalSearch, Next},
    },
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

impl<const D: usize> LocalSearch<'_, D> {
    /// Returns the next iterate, and adapts the damping.
    ///
    /// The shift of the Hessian grows until the system is positive definite and a step is accepted,
    /// and falls after each accepted step. Near the minimum steps are not checked, since the energy
    /// cannot resolve them.
    pub(crate) fn damped_step(
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
            // Shift the Hessian until it is positive definite.
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
            // Stationary? A shift divides the decrement by as much as it multiplies the Hessian.
            if decrement * (1.0 + damping.shift) <= negligible {
                if damping.shift == 0.0 {
                    return self.converge(&system, &factorization, sequence, newton, negligible);
                }
                let definite = reduce(0.0).factorize().is_some();
                if definite && !rejected {
                    damping.shift = 0.0;
                    continue;
                }
                // The Hessian shows no minimum, or no step was accepted: leave, if there is a way
                // down.
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
            // Near the minimum, take the step unchecked.
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
            // Elsewhere it has to shed a quarter of what the quadratic model promises, which
            // suffices for convergence.
            let sheds = |energy: &f64| model.energy - energy >= 0.25 * decrement;
            if let Some(reached) = self.energy.admissible(&trial).filter(sheds) {
                let longer = (damping.shift > 0.0)
                    .then(|| self.lengthen(sequence, &step, [model.energy, reached], decrement));
                damping.lower();
                return Next::Move(longer.flatten().unwrap_or(trial));
            }
            // Otherwise damp more.
            rejected = true;
            if damping.shift >= LAST_SHIFT {
                return end(Stop::Stalled, decrement);
            }
            damping.raise();
        }
    }

    /// Ends after a negligible step with a positive definite Hessian. The step is taken
    /// nevertheless, if it leads to finite points: one more gradient removes what is left of the
    /// residual.
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
}

fn finite<const D: usize>(points: &[SVector<f64, D>]) -> bool {
    points.iter().all(|x| x.iter().all(|c| c.is_finite()))
}
