//! `Problem`: a metric and the two sets to join.

use std::sync::{Arc, Mutex};

use tautline_discretizations::Rule;
use tautline_formula::Prepared;
use tautline_metrics::Metric;
use tautline_optimizers::{Options, SolveError, Workspace, minimise_by_batches};
use tautline_sets::Ends;

use crate::TautLine;

/// The problem of joining two closed sets by a shortest curve.
///
/// A problem keeps the memory of its largest solve for the next one, and shares it with its clones.
/// Separate problems keep separate memory, unless they are solved by
/// [`solve_all`](crate::solve_all) or [`minimise_in`](crate::minimise_in), which share it.
#[derive(Clone, Debug)]
pub struct Problem<M, const D: usize> {
    metric: Arc<Prepared<M, D>>,
    ends: Ends<D>,
    workspace: Arc<Mutex<Workspace>>,
}

impl<M: Metric<D>, const D: usize> Problem<M, D> {
    /// Poses the problem.
    ///
    /// The constructor records the formula of the metric and computes nothing else. A formula that
    /// compares numbers, or is very long, is evaluated as compiled, which is slower and gives the
    /// same results up to rounding.
    pub fn new(metric: M, ends: Ends<D>) -> Self {
        Self::with_prepared(Arc::new(Prepared::new(metric)), ends)
    }

    /// Poses the problem with a metric whose programs other problems share. They are derived once, on
    /// first use.
    pub fn with_prepared(metric: Arc<Prepared<M, D>>, ends: Ends<D>) -> Self {
        Self { metric, ends, workspace: Arc::default() }
    }

    /// Returns the metric.
    pub fn metric(&self) -> &M {
        self.metric.metric()
    }

    /// Returns the metric with its programs.
    pub(crate) fn prepared(&self) -> &Arc<Prepared<M, D>> {
        &self.metric
    }

    /// Returns the sets.
    pub fn ends(&self) -> &Ends<D> {
        &self.ends
    }

    /// Minimises the discrete energy of `rule` over sequences of `n + 1` points.
    ///
    /// # Errors
    ///
    /// As for [`minimise`](crate::minimise): [`SolveError`] if `n` is 0, or larger than rounding or
    /// memory allows; if the metric is not finite, symmetric and positive definite at a point of
    /// any of the curves, which the error reports; or if numbers leave the range of `f64`. Along
    /// the result the Gram matrix is also [checked](crate::Interpolation::check) between the nodes
    /// of the rule. A search that does not converge is not an error: the result reports how it
    /// stopped.
    pub fn solve(&self, rule: Rule, n: usize) -> Result<TautLine<M, D>, SolveError> {
        self.solve_with(rule, n, &Options::default())
    }

    /// Solves like [`solve`](Problem::solve), with starts or limits of your own.
    ///
    /// # Errors
    ///
    /// As for [`solve`](Problem::solve).
    pub fn solve_with(
        &self,
        rule: Rule,
        n: usize,
        options: &Options<D>,
    ) -> Result<TautLine<M, D>, SolveError> {
        // Separate memory is used while another thread solves, and after a panic.
        let mut own = Workspace::default();
        let mut kept = self.workspace.try_lock();
        let workspace = kept.as_deref_mut().unwrap_or(&mut own);
        self.solve_in(workspace, rule, n, options)
    }

    /// Solves like [`solve_with`](Problem::solve_with), in the given memory.
    pub(crate) fn solve_in(
        &self,
        workspace: &mut Workspace,
        rule: Rule,
        n: usize,
        options: &Options<D>,
    ) -> Result<TautLine<M, D>, SolveError> {
        let minimum = minimise_by_batches(workspace, &*self.metric, &self.ends, rule, n, options)?;
        Ok(TautLine::new(Arc::clone(&self.metric), rule, self.ends.clone(), minimum))
    }
}
