//! The search on a fine grid, from a start so near that no Newton step needs damping.

use tautline_discretizations::PointSequence;

use crate::{
    Curvature, Stop, Workspace,
    newton::{
        chain::goes_in_lanes, newton_pass::NewtonPass, rounding::margin,
        stationarity::Stationarity, two_threads::share,
    },
    search::local_search::{Found, LocalSearch},
};

/// So many steps are enough where each squares the decrement; a search that needs more is no such
/// one.
const STEPS: usize = 4;

/// Relative decrement above which a start is not near.
const NEAR: f64 = 1e-4;

/// By this factor at least the decrement has to fall from one step to the next.
const FALL: f64 = 0.01;

/// On a grid whose chords have so many second derivatives, a start is only looked at first, if that
/// on the coarser grid had at most this relative decrement: it will be a minimiser to rounding, and
/// for that nothing need be written down, which takes about half as long again as the arithmetic.
const LARGE: usize = 32768;
const FORESEEN: f64 = 1e-12;

impl<const D: usize> LocalSearch<'_, D> {
    /// Takes undamped Newton steps from `start`, each in one pass, until the decrement is negligible
    /// and the residual is rounding, or the decrement alone is after a step that promised next to
    /// nothing. On the finest grids both are so at the start.
    ///
    /// `None` where that does not do: the Hessian is not positive definite, a step promises too
    /// much, or not far less than the one before, or the metric is none at the result, or there is no
    /// memory for a step.
    ///
    /// `coarser` is the result on the next coarser grid; `passes` is set to how many were begun.
    pub(crate) fn refine(
        &self,
        start: PointSequence<D>,
        coarser: &Found<D>,
        workspace: &mut Workspace<D>,
        passes: &mut usize,
    ) -> Option<Found<D>> {
        let (energy, ends) = (self.energy, self.ends);
        let n = start.n().get();
        let at_once = share::<D>(self.threads, n);
        let mut about = coarser.magnitude();
        let reached =
            |at: Stationarity, x: &_| at.is_reached(x) && at.residual <= at.residual_floor;
        if n * D * D >= LARGE && coarser.from <= FORESEEN {
            let at = energy.sweep(ends, &start, about, at_once, None)?.stationarity;
            if reached(at, &start) {
                return self.found(start, at, 1, at.decrement);
            }
        }
        workspace.check_undamped(n).ok()?;
        let (mut here, mut allowed, mut from) = (start, NEAR, None);
        for iteration in 1..=STEPS {
            *passes = iteration;
            let mut pass = NewtonPass::new(energy, ends, &here, about, at_once, workspace)?;
            let at = pass.stationarity();
            let from = *from.get_or_insert(at.decrement);
            if reached(at, &here) {
                pass.leave();
                return self.found(here, at, iteration, from);
            }
            about = at.magnitude;
            // Written so that NaN fails.
            if !(at.decrement <= allowed * about.energy) {
                return None;
            }
            allowed = FALL * at.decrement / about.energy;
            let mut points = pass.take_step();
            points.iter_mut().zip(here.points()).for_each(|(step, x)| *step += x);
            self.project_ends(&mut points);
            let trial = PointSequence::new(points).ok()?;
            // The points move by the root of what is promised, and with them the Hessian: by less
            // than the margin by which it is definite, so that the factorisation from here still
            // tells. Two chords at a time, a sweep costs no more than a gradient does.
            if at.decrement <= margin(n).powi(2) * about.energy {
                let there = if const { goes_in_lanes(D) } {
                    energy.sweep(ends, &trial, about, false, None)?.stationarity
                } else {
                    pass.stationarity_at(energy, ends, &trial)
                };
                if there.is_reached(&trial) {
                    return self.found(trial, there, iteration, from);
                }
            }
            workspace.spare.give(std::mem::replace(&mut here, trial).into_points());
        }
        None
    }

    /// The result at a sequence with a positive definite Hessian, if the metric is one there.
    fn found(
        &self,
        sequence: PointSequence<D>,
        at: Stationarity,
        iterations: usize,
        from: f64,
    ) -> Option<Found<D>> {
        let ends = [sequence.first(), sequence.last()];
        let is_metric = at.is_metric && ends.iter().all(|x| self.energy.check_at(x).is_ok());
        is_metric.then_some(Found {
            sequence,
            energy: at.magnitude.energy,
            mean_gram: at.magnitude.mean_gram,
            decrement: at.magnitude.relative(at.decrement),
            residual: at.residual,
            residual_floor: at.residual_floor,
            stop: Stop::Converged,
            curvature: Curvature::PositiveDefinite,
            iterations,
            from: at.magnitude.relative(from),
        })
    }
}
