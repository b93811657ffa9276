//! The search on a fine grid, from a start that is so near the minimiser that Newton steps need no
//! damping.

use tautline_discretizations::{ANY, PointSequence};

use crate::{
    Curvature, Iterate, Stop, Workspace,
    newton::{
        newton_pass::NewtonPass,
        rounding::margin,
        stationarity::Stationarity,
        sweep::sweep,
        two_threads::{goes_in_lanes, share},
    },
    search::local_search::{Found, LocalSearch},
};

/// The largest number of steps that quadratic convergence needs.
const STEPS: usize = 4;

/// The relative decrement above which a start is too far from the minimiser.
const NEAR: f64 = 1e-4;

/// The factor by which the decrement has to fall from one step to the next.
const FALL: f64 = 0.01;

/// If the chords of a grid have at least `LARGE` second derivatives, and the start on the coarser
/// grid had a relative decrement of at most `FORESEEN`, the start is likely a minimiser to
/// rounding. It is then checked first without storing a factorisation, since storing takes half as
/// long again as the arithmetic.
const LARGE: usize = 32768;
const FORESEEN: f64 = 1e-12;

impl LocalSearch<'_> {
    /// Takes undamped Newton steps from `start`, each in one pass over the chords. The search ends
    /// when the decrement is negligible and the residual is rounding; on the finest grids this is
    /// so at the start itself. After a step that predicted almost no decrease, a negligible
    /// decrement is enough.
    ///
    /// The result is `None` if this fails: the Hessian is not positive definite, a step predicts
    /// too large a decrease or one that is not far smaller than the one before, the metric is
    /// undefined at the result, there is no memory for a step, or the watcher has ended the solve.
    ///
    /// `coarser` is the result on the next coarser grid. `passes` is set to the number of passes
    /// that were begun.
    pub(crate) fn refine(
        &self,
        start: PointSequence<ANY>,
        coarser: &Found,
        workspace: &mut Workspace,
        passes: &mut usize,
    ) -> Option<Found> {
        let (energy, ends) = (self.energy, self.ends);
        let (n, d) = (start.n().get(), start.dimension());
        let at_once = share(d, self.threads, n);
        let mut about = coarser.magnitude();
        let reached =
            |at: Stationarity, x: &_| at.is_reached(x) && at.residual <= at.residual_floor;
        if n * d * d >= LARGE && coarser.from <= FORESEEN {
            let at = sweep(energy, ends, &start, about, at_once, None)?.stationarity;
            if reached(at, &start) {
                self.tell(0, at, &start)?;
                return self.found(start, at, 1, at.decrement);
            }
        }
        workspace.check_undamped(d, n).ok()?;
        let (mut here, mut allowed, mut from) = (start, NEAR, None);
        for iteration in 1..=STEPS {
            *passes = iteration;
            let mut pass = NewtonPass::new(energy, ends, &here, about, at_once, workspace)?;
            let at = pass.stationarity();
            let from = *from.get_or_insert(at.decrement);
            self.tell(iteration - 1, at, &here)?;
            if reached(at, &here) {
                pass.leave();
                return self.found(here, at, iteration, from);
            }
            about = at.magnitude;
            // The comparison is written so that NaN fails.
            if !(at.decrement <= allowed * about.energy) {
                return None;
            }
            allowed = FALL * at.decrement / about.energy;
            let mut points = pass.take_step();
            points.iter_mut().zip(here.coordinates()).for_each(|(step, x)| *step += x);
            self.project_ends(&mut points);
            let trial = PointSequence::from_coordinates(d, points).ok()?;
            // The points, and the Hessian with them, move by the root of the decrement. This is
            // less than the margin by which the Hessian is definite, so the factorisation from here
            // still serves. In lanes, with two chords at a time, a sweep does not cost more than a
            // gradient.
            if at.decrement <= margin(n).powi(2) * about.energy {
                let there = if goes_in_lanes(d) {
                    sweep(energy, ends, &trial, about, false, None)?.stationarity
                } else {
                    pass.stationarity_at(energy, ends, &trial)
                };
                if there.is_reached(&trial) {
                    self.tell(iteration, there, &trial)?;
                    return self.found(trial, there, iteration, from);
                }
            }
            workspace.spare.give(std::mem::replace(&mut here, trial).into_coordinates());
        }
        None
    }

    /// Tells the watcher of an iterate; `None` if it ends the search.
    fn tell(
        &self,
        iteration: usize,
        at: Stationarity,
        sequence: &PointSequence<ANY>,
    ) -> Option<()> {
        let Stationarity { residual, residual_floor, magnitude, .. } = at;
        let energy = magnitude.energy;
        let seen = || Iterate { iteration, energy, residual, residual_floor, sequence };
        self.watch.goes_on(&seen).then_some(())
    }

    /// Returns the result at a sequence with a positive definite Hessian, if the metric is defined
    /// there.
    fn found(
        &self,
        sequence: PointSequence<ANY>,
        at: Stationarity,
        iterations: usize,
        from: f64,
    ) -> Option<Found> {
        let ends = [sequence.row(0), sequence.row(sequence.n().get())];
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
