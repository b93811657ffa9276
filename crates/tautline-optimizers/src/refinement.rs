//! The search on a fine grid, from a start so near that no Newton step needs damping.

use tautline_discretizations::{LinearModel, PointSequence, Rule};
use tautline_metrics::{Metric, check_gram};

use crate::{
    Curvature, Stop, Workspace,
    local_search::{Found, LocalSearch, QUADRATIC_ZONE},
    newton_pass::NewtonPass,
    residual::Residual,
    rounding::{margin, negligible},
};

/// So many steps are enough where each squares the decrement, which begins below
/// [`QUADRATIC_ZONE`]; a search that needs more is no such one.
const STEPS: usize = 4;

impl<M: Metric<D>, R: Rule, const D: usize> LocalSearch<'_, M, R, D> {
    /// Takes undamped Newton steps from `start`, each in one pass, as the [search](Self::run)
    /// does at the end. `None` where that does not do: the Hessian is not positive definite, a
    /// step promises too much to be trusted, or the metric is none at the result.
    ///
    /// `mean_gram` is that of a coarser grid.
    pub(crate) fn refine(
        &self,
        start: &PointSequence<D>,
        mean_gram: f64,
        workspace: &mut Workspace<D>,
    ) -> Option<Found<D>> {
        let mut sequence = None;
        let mut mean_gram = mean_gram;
        for iteration in 1..=STEPS {
            let here = sequence.as_ref().unwrap_or(start);
            let memory = &mut workspace.factorization;
            let (rule, metric, ends) = (self.rule, self.metric, self.ends);
            let mut pass = NewtonPass::new(rule, metric, ends, here, mean_gram, memory)?;
            mean_gram = pass.mean_gram;
            // Written so that NaN fails.
            if !(pass.decrement <= QUADRATIC_ZONE * pass.energy) {
                return None;
            }
            let (promised, at) = (pass.decrement, pass.energy);
            let mut points = std::mem::take(&mut pass.step);
            points.iter_mut().zip(here.points()).for_each(|(step, x)| *step += x);
            self.project_ends(&mut points);
            let trial = PointSequence::new(points).ok()?;
            // The points move by the root of what is promised, and with them the Hessian: by less
            // than the margin by which it is definite.
            if promised > margin(here.n().get()).powi(2) * at {
                sequence = Some(trial);
                continue;
            }
            let mut decrement = pass.decrement_at(ends, trial.points());
            let mut residual = Residual::new(trial.n().get(), at, mean_gram);
            let (energy, is_metric) = LinearModel::for_each(rule, metric, &trial, |k, gradient| {
                decrement.push(k, &gradient);
                residual.push(k, &gradient);
            });
            let is_metric = is_metric
                && [trial.first(), trial.last()].iter().all(|x| check_gram(metric, x).is_ok());
            if !is_metric {
                return None;
            }
            let decrement = decrement.value();
            if decrement <= negligible(energy, mean_gram, &trial) {
                let (residual, residual_floor) = residual.value(ends, &trial, energy, mean_gram);
                return Some(Found {
                    sequence: trial,
                    energy,
                    mean_gram,
                    decrement: decrement / energy,
                    residual,
                    residual_floor,
                    stop: Stop::Converged,
                    curvature: Curvature::PositiveDefinite,
                    iterations: iteration,
                });
            }
            sequence = Some(trial);
        }
        None
    }
}
