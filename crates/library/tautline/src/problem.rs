//! `Problem`: a metric and the two sets to join.

use std::sync::{Arc, Mutex, atomic::AtomicBool};

use tautline_discretizations::Rule;
use tautline_formula::{AnyBatches, Known, Prepare, Prepared};
use tautline_metrics::Metric;
use tautline_optimizers::{Minimum, Options, Scope, SolveError, Starts, Workspace, minimise_any};
use tautline_scalar::ANY;
use tautline_sets::{AnyEnds, Ends};

use crate::{TautLine, both_ends::BothEnds};

/// The problem of joining two closed sets by a shortest curve.
///
/// A problem keeps the memory of its largest solve for the next one, and shares it with its clones.
/// Separate problems keep separate memory, unless they are solved by
/// [`solve_all`](crate::solve_all) or [`minimise_in`](crate::minimise_in), which share it.
///
/// The dimension is known at compile time, or is a value if `D` is [`ANY`]:
///
/// ```
/// use tautline::{ANY, AnyEnds, Formula, Problem, Rule};
///
/// let valleys = Formula::parse_in(20, "cost(2 - cos(x1))", &[], &[])?;
/// let mut far = [0.0; 20];
/// far[0] = 3.0;
/// let problem = Problem::in_any(valleys, AnyEnds::points(&[0.0; 20], &far)?)?;
/// let length = problem.solve(Rule::TRAPEZOIDAL, 64)?.length().value;
/// assert!((length - (6.0 - 3.0_f64.sin())).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Problem<M: Prepare<D>, const D: usize> {
    metric: Arc<M::Prepared>,
    ends: BothEnds<D>,
    workspace: Arc<Mutex<Workspace>>,
    ended: Option<Arc<AtomicBool>>,
}

impl<M: Prepare<D>, const D: usize> Clone for Problem<M, D> {
    fn clone(&self) -> Self {
        let Self { metric, ends, workspace, ended } = self;
        let (metric, workspace) = (Arc::clone(metric), Arc::clone(workspace));
        Self { metric, ends: ends.clone(), workspace, ended: ended.clone() }
    }
}

impl<M: Metric<D>, const D: usize> Problem<M, D> {
    /// Poses the problem.
    ///
    /// The constructor records the formula of the metric and computes nothing else. A formula that
    /// compares numbers, or is very long, is evaluated as compiled, which is slower and gives the
    /// same results up to rounding.
    pub fn new(metric: M, ends: Ends<D>) -> Self {
        Self::with_prepared(Arc::new(metric.prepare()), ends)
    }

    /// Poses the problem with a metric whose programs other problems share. They are derived once, on
    /// first use.
    pub fn with_prepared(metric: Arc<Prepared<M, D>>, ends: Ends<D>) -> Self {
        Self { metric, ends: ends.into(), workspace: Arc::default(), ended: None }
    }

    /// Returns the sets.
    pub fn ends(&self) -> &Ends<D> {
        self.ends.typed()
    }
}

impl Problem<Known, ANY> {
    /// Poses the problem in a dimension that is a value.
    ///
    /// # Errors
    ///
    /// [`SolveError::Dimension`] if the sets lie in another dimension than the metric.
    pub fn in_any(metric: impl Into<Known>, ends: AnyEnds) -> Result<Self, SolveError> {
        Self::with_known(Arc::new(metric.into()), ends)
    }

    /// Poses the problem with a metric whose programs other problems share.
    ///
    /// # Errors
    ///
    /// As for [`in_any`](Problem::in_any).
    pub fn with_known(metric: Arc<Known>, ends: AnyEnds) -> Result<Self, SolveError> {
        let (dimension, found) = (metric.dimension(), ends.dimension());
        if found != dimension {
            return Err(SolveError::Dimension { metric: dimension, found });
        }
        Ok(Self { metric, ends: ends.into(), workspace: Arc::default(), ended: None })
    }
}

impl<M: Prepare<D>, const D: usize> Problem<M, D> {
    /// Returns the metric.
    pub fn metric(&self) -> &M {
        M::metric(&self.metric)
    }

    /// Returns the metric with its programs.
    pub fn prepared(&self) -> &Arc<M::Prepared> {
        &self.metric
    }

    /// Returns the same problem, whose searches end with [`SolveError::Interrupted`] before their next step once
    /// the flag is true. What a line computes of itself afterwards, such as its other minima, goes on.
    #[must_use]
    pub fn ended_by(self, flag: Arc<AtomicBool>) -> Self {
        let workspace = Workspace::default().ended_by(Arc::clone(&flag));
        Self { workspace: Arc::new(Mutex::new(workspace)), ended: Some(flag), ..self }
    }

    /// Returns the sets, in a dimension that is a value.
    pub fn any_ends(&self) -> &AnyEnds {
        self.ends.any()
    }

    /// Minimises the discrete energy of `rule` over sequences of `n + 1` points.
    ///
    /// In two and three dimensions, with sixteen chords or more and a metric that has a formula, the search
    /// also looks [elsewhere](Scope::Automatic). Where the path runs along what was found, that costs some
    /// thousand evaluations of the metric and a search through up to 3000 nodes: in the plane about half as
    /// much as a solve with 64 chords of a short formula, in space up to twice as much, and no more for finer
    /// grids. Where it does not, it costs a search with 64 chords more, and solves on three grids if that
    /// finds a shorter line.
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
        let mut own = self
            .ended
            .clone()
            .map_or_else(Workspace::default, |flag| Workspace::default().ended_by(flag));
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
        let (metric, ends) = (&*self.metric, self.ends.any());
        let minimum = minimise_any(workspace, metric, ends, rule, n, options, None)?;
        let line = self.line(rule, minimum);
        let is_free = matches!(options.starts, Starts::Automatic | Starts::Also(_));
        // A black box may have no values beyond the ends, and says so to its owner.
        let has_formula = M::formula(&self.metric).is_ok();
        if options.scope == Scope::Local || !is_free || !has_formula {
            return Ok(line);
        }
        Ok(self.or_elsewhere(workspace, line, options))
    }

    /// Returns the line of a minimum of this problem.
    pub(crate) fn line(&self, rule: Rule, minimum: Minimum<D>) -> TautLine<M, D> {
        TautLine::new(Arc::clone(&self.metric), rule, self.ends.clone(), minimum)
    }
}
