//! `Problem`: a metric and the two sets to join.

use std::sync::{Arc, Mutex};

use tautline_discretizations::Rule;
use tautline_formula::Prepared;
use tautline_metrics::Metric;
use tautline_optimizers::{Options, SolveError, Workspace, minimise_by_batches};
use tautline_sets::Ends;

use crate::TautLine;

/// The problem to join two closed sets by a shortest curve.
///
/// It keeps the memory of its largest solve for the next one, and its clones share it. Of many problems
/// that are solved one by one each keeps its own; [`solve_all`](crate::solve_all) and
/// [`minimise_in`](crate::minimise_in) share it instead.
#[derive(Clone, Debug)]
pub struct Problem<M, const D: usize> {
    metric: Arc<Prepared<M, D>>,
    ends: Ends<D>,
    workspace: Arc<Mutex<Workspace<D>>>,
}

impl<M: Metric<D>, const D: usize> Problem<M, D> {
    /// Poses the problem.
    ///
    /// The formula of the metric is recorded; nothing else is computed yet. A formula that compares numbers,
    /// or is very long, is taken as it is compiled: with the same results to rounding, and slower.
    pub fn new(metric: M, ends: Ends<D>) -> Self {
        Self { metric: Arc::new(Prepared::new(metric)), ends, workspace: Arc::default() }
    }

    /// Returns the metric.
    pub fn metric(&self) -> &M {
        self.metric.metric()
    }

    /// Returns the sets.
    pub fn ends(&self) -> &Ends<D> {
        &self.ends
    }

    /// Minimises the discrete energy of `rule` over sequences of `n + 1` points.
    ///
    /// # Errors
    ///
    /// [`SolveError`] for `n = 0` and for more subintervals than rounding or memory allows; where the
    /// metric is not finite, symmetric and positive definite along all curves that were tried, with the
    /// point; and where numbers leave the range of `f64`, all as [`minimise`](crate::minimise) says. Along
    /// the result the Gram matrix is checked between the nodes of the rule too, at the points at which a
    /// quadrature of the length would read it, up to some 131 072 of them and for `N > 512` on some 512 of
    /// the chords: see
    /// [`Interpolation::check`](crate::Interpolation::check). A search that does not converge is no error: the result
    /// says how it stopped.
    pub fn solve<R: Rule>(&self, rule: R, n: usize) -> Result<TautLine<M, R, D>, SolveError> {
        self.solve_with(rule, n, &Options::default())
    }

    /// As [`solve`](Problem::solve), with starts or limits of your own.
    ///
    /// # Errors
    ///
    /// As [`solve`](Problem::solve).
    pub fn solve_with<R: Rule>(
        &self,
        rule: R,
        n: usize,
        options: &Options<D>,
    ) -> Result<TautLine<M, R, D>, SolveError> {
        // While another thread solves, and after a panic, in memory of its own.
        let mut own = Workspace::default();
        let mut kept = self.workspace.try_lock();
        let workspace = kept.as_deref_mut().unwrap_or(&mut own);
        self.solve_in(workspace, rule, n, options)
    }

    /// As [`solve_with`](Problem::solve_with), in the memory of another.
    pub(crate) fn solve_in<R: Rule>(
        &self,
        workspace: &mut Workspace<D>,
        rule: R,
        n: usize,
        options: &Options<D>,
    ) -> Result<TautLine<M, R, D>, SolveError> {
        let minimum = minimise_by_batches(workspace, &*self.metric, &self.ends, rule, n, options)?;
        Ok(TautLine::new(Arc::clone(&self.metric), rule, self.ends.clone(), minimum))
    }
}
