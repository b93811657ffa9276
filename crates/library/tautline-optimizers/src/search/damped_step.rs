//! One damped step of a [`LocalSearch`]: Newton's method with a shift of the Hessian.

use tautline_discretizations::{ANY, LinearModel, PointSequence, QuadraticModel};

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

/// The relative decrement below which Newton steps are taken without checking the energy. The
/// predicted change of `10⁻¹⁰ E` can still be observed, but a few steps later it drowns in
/// rounding.
const QUADRATIC_ZONE: f64 = 1e-10;

/// The relative decrement below which the Hessian from before a step also serves after it. The
/// points, and the Hessian with them, move by the root of the decrement, `10⁻⁸`.
const SAME_HESSIAN: f64 = 1e-16;

/// Steps that predict a decrease of less than this multiple of the [`negligible`] decrement are not
/// checked either, since rounding the coordinates changes the energy by as much.
const NOISE: f64 = 16.0;

/// The number of times that a search may leave a saddle at which it has come to rest.
const ESCAPES: usize = 8;

/// The number of steps in a row with an indefinite Hessian after which the search tries the
/// direction of most negative curvature. Near a saddle, shifted steps are slow, and on an axis of
/// symmetry no component of them leads away from it.
const PATIENCE: usize = 5;

impl LocalSearch<'_> {
    /// Returns the next iterate, and adapts the damping.
    ///
    /// The shift of the Hessian grows until the system is positive definite and a step is accepted,
    /// and falls after each accepted step. Near the minimum steps are not checked, since rounding
    /// hides the changes of the energy. `factorization` lends its memory.
    pub(crate) fn damped_step(
        &self,
        model: &QuadraticModel,
        sequence: &PointSequence<ANY>,
        damping: &mut Damping,
        factorization: &mut Factorization,
    ) -> Next {
        let reduce = |shift| ReducedSystem::new(model, self.ends, sequence.coordinates(), shift);
        let end = |stop, decrement| {
            let curvature = self.curvature(model, sequence);
            Next::End { stop, curvature, decrement }
        };
        let negligible = negligible(Magnitude::of(model), sequence);
        let (mut rejected, mut indefinite) = (false, false);
        loop {
            // Shift the Hessian until it is positive definite.
            let system = reduce(damping.shift);
            if !system.factorize_in(factorization) {
                if damping.shift >= LAST_SHIFT {
                    return end(Stop::Stalled, f64::INFINITY);
                }
                indefinite = true;
                damping.raise();
                continue;
            }
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
            let newton = system.newton_step(factorization);
            let decrement = newton.decrement;
            // Is the sequence stationary? A shift divides the decrement by as much as it multiplies
            // the Hessian.
            if decrement * (1.0 + damping.shift) <= negligible {
                if damping.shift == 0.0 {
                    return self.converge(&system, factorization, sequence, newton, negligible);
                }
                let definite = reduce(0.0).factorize().is_some();
                if definite && !rejected {
                    damping.shift = 0.0;
                    continue;
                }
                // The Hessian shows no minimum, or no step was accepted. Leave the saddle if there
                // is a way down.
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
                        self.polish(&system, factorization, trial, negligible)
                    } else {
                        Next::Move(trial)
                    };
                }
                damping.lower();
                return Next::Move(trial);
            }
            let reached = self.energy.admissible(&trial);
            if let Some(reached) = reached.filter(|&e| falls_enough(model.energy, e, decrement)) {
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

    /// Ends after a negligible step with a positive definite Hessian. The step is still taken if it
    /// leads to finite points: it costs one more gradient and removes what is left of the residual.
    fn converge(
        &self,
        system: &ReducedSystem<'_>,
        factorization: &Factorization,
        sequence: &PointSequence<ANY>,
        Step { step, decrement }: Step,
        negligible: f64,
    ) -> Next {
        let trial = self.retract(sequence, &step, 1.0);
        if finite(&trial)
            && let last @ Next::EndAt { .. } = self.polish(system, factorization, trial, negligible)
        {
            return last;
        }
        Next::End { stop: Stop::Converged, curvature: Curvature::PositiveDefinite, decrement }
    }

    /// Takes a step that is so small that the factorisation from before it, together with one new
    /// gradient, still yields the decrement after it. The search ends there if that decrement is
    /// negligible.
    fn polish(
        &self,
        system: &ReducedSystem<'_>,
        factorization: &Factorization,
        points: Vec<f64>,
        negligible: f64,
    ) -> Next {
        let trial = PointSequence::from_coordinates(self.energy.dimension(), points)
            .expect("the points are finite");
        let LinearModel { energy, slopes, .. } = self.energy.linear_model(&trial);
        let points = trial.into_coordinates();
        let decrement = system.decrement_at(factorization, self.ends, &points, &slopes);
        if decrement <= negligible {
            Next::EndAt { points, energy, slopes, decrement }
        } else {
            Next::Move(points)
        }
    }
}

fn finite(points: &[f64]) -> bool {
    points.iter().all(|x| x.is_finite())
}

/// Returns whether a step lowers the energy by a quarter of what the quadratic model predicts, which
/// suffices for convergence. Any decrease would not: steps could come to rest where the energy still falls.
fn falls_enough(before: f64, after: f64, decrement: f64) -> bool {
    before - after >= 0.25 * decrement
}

#[cfg(test)]
mod tests {
    use super::falls_enough;

    #[test]
    fn a_step_has_to_lower_the_energy_by_a_quarter_of_its_decrement() {
        // Exact in binary.
        for (after, is_enough) in
            [(7.0, true), (7.75, true), (7.875, false), (8.0, false), (8.5, false)]
        {
            assert_eq!(falls_enough(8.0, after, 1.0), is_enough, "{after}");
        }
        assert!(!falls_enough(8.0, f64::NAN, 1.0));
    }
}
