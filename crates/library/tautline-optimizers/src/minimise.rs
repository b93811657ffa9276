//! `minimise`: the entry point of the solver, and its options.

use tautline_discretizations::{ANY, PointSequence, Rule};
use tautline_formula::{AnyBatches, Batches, Prepared};
use tautline_metrics::Metric;
use tautline_sets::{AnyEnds, AnySet, Ends};

use crate::{
    Iterate, Minimum, Scope, SolveError, Starts, Watcher, Workspace,
    newton::discrete_energy::DiscreteEnergy,
    solver::solve,
    watch::{Flagged, Unwatched, Watched},
};

/// Options of a search.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Options<const D: usize> {
    /// The sequences from which the search starts.
    #[cfg_attr(feature = "serde", serde(default))]
    pub starts: Starts<D>,
    /// How far the search looks.
    #[cfg_attr(feature = "serde", serde(default))]
    pub scope: Scope,
    /// The largest number of Newton steps of a local search on one grid.
    #[cfg_attr(feature = "serde", serde(default = "default_iterations"))]
    pub iterations: usize,
    /// The number of threads for one problem: 0 counts as 1, and more than 2 as 2.
    ///
    /// A second thread is used in four dimensions or more, for undamped Newton steps on grids of at
    /// least `65 536/D²` chords: it eliminates from the other end. Up to three dimensions, one
    /// thread eliminates from both ends at once, which is faster. The result is the same bit for
    /// bit, provided that the values of the metric depend on `x` alone. The second thread has a
    /// stack of 32 MB. Use 1 if a formula needs a larger stack, or if many problems are solved in
    /// parallel anyway.
    #[cfg_attr(feature = "serde", serde(default = "default_threads"))]
    pub threads: usize,
}

impl<const D: usize> Default for Options<D> {
    /// Returns automatic starts and scope, two threads, and 200 steps, which is five times what a successful
    /// search takes on one grid.
    fn default() -> Self {
        Self { starts: Starts::Automatic, scope: Scope::Automatic, iterations: 200, threads: 2 }
    }
}

impl<const D: usize> Options<D> {
    /// Returns the same options for a dimension that is a value.
    fn in_any(&self) -> Options<ANY> {
        let &Self { ref starts, scope, iterations, threads } = self;
        Options { starts: starts.in_any(), scope, iterations, threads }
    }
}

#[cfg(feature = "serde")]
fn default_iterations() -> usize {
    Options::<1>::default().iterations
}

#[cfg(feature = "serde")]
fn default_threads() -> usize {
    Options::<1>::default().threads
}

/// Returns the lowest discrete minimiser of `rule` that was found between the sets `ends`.
///
/// On the coarsest grid every pair of pieces of the sets is searched from every start. For
/// `n ≤ 32`, and with [`Starts::Only`] for `n ≤ 64`, this is the only grid. The best minimisers are
/// followed to `n` chords over grids that refine by a factor of 2 up to `n = 64`, and by factors of
/// 4 to 16 beyond. Each grid takes two or three Newton steps. On smooth data with `n D² ≥ 32 768`
/// the finest grid takes none, since its start is a minimiser to rounding. If the energy rises by
/// half from one coarse grid to the next, all starts are tried again. A rule without nodes does not
/// compile.
///
/// # Memory
///
/// The finest grid takes at most `16D² + 24D` bytes per point with undamped Newton steps, and four
/// times as much if they have to be damped. Coarser grids take about a tenth of that. If the finest
/// grid has at least `32 768/D²` chords and needs no step, only its points are stored. As measured
/// on smooth metrics for `D = 2`, the total is less than 30 bytes per point at `N = 10⁵` and less
/// than 20 at `N = 10⁷`. The thread also keeps about 1 kB for each
/// [register](tautline_formula::Prepared::size) of a program.
///
/// # Errors
///
/// - [`SolveError::NoSubinterval`] if `n` is 0, and [`SolveError::TooManySubintervals`] if it
///   exceeds [`LARGEST_N`](tautline_discretizations::LARGEST_N).
/// - [`SolveError::OutOfMemory`] if the system refuses memory for the points or a Newton step. (A
///   system may promise more memory than it has.)
/// - [`SolveError::Metric`] if there is no start with a metric that is finite, symmetric and
///   positive definite at its nodes and ends, or no result with such a metric there and
///   [between](tautline_discretizations::Interpolation::check) its nodes. The lowest result that
///   passes is returned; for `n > 512` there is only one.
/// - [`SolveError::NoStart`] if there is nothing to start from, [`SolveError::Sequence`] if points
///   become infinite on the way, and [`SolveError::Energy`] if every energy found overflows.
pub fn minimise<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
    options: &Options<D>,
) -> Result<Minimum<D>, SolveError> {
    minimise_in(&mut Workspace::default(), metric, ends, rule, n, options)
}

/// Minimises like [`minimise`], in memory that is reused from problem to problem.
///
/// The result does not depend on earlier uses of the workspace.
///
/// # Errors
///
/// As for [`minimise`].
pub fn minimise_in<const D: usize>(
    workspace: &mut Workspace,
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
    options: &Options<D>,
) -> Result<Minimum<D>, SolveError> {
    minimise_by_batches(workspace, &Prepared::new(metric), ends, rule, n, options)
}

/// Minimises like [`minimise_in`], for a metric that is evaluated in batches.
///
/// # Errors
///
/// As for [`minimise`].
pub fn minimise_by_batches<const D: usize>(
    workspace: &mut Workspace,
    metric: &dyn Batches<D>,
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
    options: &Options<D>,
) -> Result<Minimum<D>, SolveError> {
    minimise_any(workspace, metric, &ends.in_any(), rule, n, options, None)
}

/// Minimises like [`minimise_by_batches`], and tells `watcher` of each iterate of each local search,
/// from every start and on every grid. The watcher may end the solve, for example at a time limit;
/// [`Trace`](crate::Trace) does, and keeps what was reached.
///
/// The last iterate of a search on a coarse grid may not be told of: it is one small Newton step
/// beyond the one that is. The result is the same as without a watcher.
///
/// # Errors
///
/// As for [`minimise`]; also [`SolveError::Interrupted`].
pub fn minimise_watched<'w, const D: usize>(
    workspace: &mut Workspace,
    metric: &dyn Batches<D>,
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
    options: &Options<D>,
    watcher: &'w mut Watcher<'w, D>,
) -> Result<Minimum<D>, SolveError> {
    minimise_any(workspace, metric, &ends.in_any(), rule, n, options, Some(watcher))
}

/// Minimises like [`minimise_watched`] in a dimension that may be a value. `watcher`, if there is one,
/// sees each iterate.
///
/// # Errors
///
/// As for [`minimise_watched`]; also [`SolveError::Dimension`] if the sets, a start or the result lie in
/// another dimension than the metric.
pub fn minimise_any<'w, const D: usize>(
    workspace: &mut Workspace,
    metric: &dyn AnyBatches,
    ends: &AnyEnds,
    rule: Rule,
    n: usize,
    options: &Options<D>,
    watcher: Option<&'w mut Watcher<'w, D>>,
) -> Result<Minimum<D>, SolveError> {
    let dimension = metric.dimension();
    let starts = options.starts.given().iter().map(PointSequence::dimension);
    let result = if D == ANY { dimension } else { D };
    let mut all = [ends.dimension(), result].into_iter().chain(starts);
    if let Some(found) = all.find(|&found| found != dimension) {
        return Err(SolveError::Dimension { metric: dimension, found });
    }
    let pairs = ends.pairs();
    let pieces: Vec<[&dyn AnySet; 2]> = pairs.iter().map(|[a, b]| [&**a, &**b]).collect();
    let energy = DiscreteEnergy::new(rule, metric);
    let options = options.in_any();
    let minimum = match watcher {
        Some(watcher) => {
            let mut seen = |iterate: &Iterate<'_, ANY>| {
                let sequence = iterate.sequence.clone().into_dimension();
                let sequence = &sequence.expect("the dimension of the metric");
                let Iterate { iteration, energy, residual, residual_floor, .. } = *iterate;
                watcher(&Iterate { iteration, energy, residual, residual_floor, sequence })
            };
            solve(workspace, &energy, &pieces, n, &options, &Watched::by(&mut seen))
        }
        None => match workspace.ended.clone() {
            Some(flag) => solve(workspace, &energy, &pieces, n, &options, &Flagged(&flag)),
            None => solve(workspace, &energy, &pieces, n, &options, &Unwatched),
        },
    }?;
    Ok(minimum.into_dimension().expect("the dimension of the metric"))
}

#[cfg(test)]
mod tests {
    use nalgebra::SMatrix;
    use tautline_discretizations::Rule;
    use tautline_metrics::gallery::Constant;
    use tautline_sets::Ends;

    use super::{Options, minimise};
    use crate::SolveError;

    #[test]
    fn an_energy_beyond_the_range_of_f64_is_an_error() {
        let euclidean = Constant::new(SMatrix::identity()).expect("positive definite");
        let options = Options::default();
        let between = |far: f64, n: usize| {
            let ends = Ends::points([-far, 0.0], [far, far]).expect("finite");
            minimise(&euclidean, &ends, Rule::TRAPEZOIDAL, n, &options)
        };
        for n in [1, 8, 100] {
            assert!(between(1e150, n).expect("5e300").is_local_minimum());
            let error = between(1e155, n).expect_err("5e310");
            assert!(matches!(error, SolveError::Energy { .. }), "{error:?}");
        }
    }
}
