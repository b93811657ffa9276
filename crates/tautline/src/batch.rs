//! `solve_all`: many problems at once.

use rayon::prelude::*;
use tautline_discretizations::Rule;
use tautline_metrics::Metric;
use tautline_optimizers::{Options, SolveError, Workspace};

use crate::{Problem, TautLine};

/// Solves each of the problems on all threads, in the order in which they were given.
///
/// Each problem is solved on one thread: [`Options::threads`] is ignored. The results are those of
/// [`Problem::solve_with`] bit by bit, whatever the number of threads; one without a result leaves the
/// others as they are. The threads are those of the rayon pool in which this is called: as many as
/// processors, unless you say otherwise. Problems that one thread takes in one go share their memory,
/// and none is kept.
///
/// Problems that share a metric can be posed by reference to it, and problems with metrics of one
/// type can have each its own:
///
/// ```
/// use tautline::{Ends, Options, Problem, Trapezoidal, gallery::Bump, solve_all};
///
/// let bump = Bump::new(4.0, 0.5)?;
/// let mut problems = Vec::new();
/// for to in [[1.5, -0.1], [0.0, 1.5], [0.0, -1.5]] {
///     problems.push(Problem::new(&bump, Ends::points([-1.5, 0.05], to)?));
/// }
/// let mut lengths = Vec::new();
/// for line in solve_all(&problems, Trapezoidal, 64, &Options::default()) {
///     lengths.push(line?.length().value);
/// }
/// assert!(lengths[0] > lengths[1]); // round the bump, not beside it
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Stack
///
/// In many dimensions matrices are on the stack, of jets where a formula is evaluated as it is compiled, and
/// threads other than the first have less of it: 2 MB by default. What is needed, in MB, as measured with
/// optimisation:
///
/// | `D` | 16 | 23 | 32 | 64 |
/// | --- | --- | --- | --- | --- |
/// | by programs | ⅛ | ¼ | ½ | 2 |
/// | as compiled: a formula with branches, or one of very many steps | 2 | 8 | 3 | 12 |
///
/// From `D = 24` on derivatives are taken by eight directions at a time, which need less. Where it is not
/// enough, give the threads more: rayon's `ThreadPoolBuilder::stack_size`.
///
/// # Errors
///
/// Each result has its own, as [`Problem::solve`].
pub fn solve_all<M, R, const D: usize>(
    problems: &[Problem<M, D>],
    rule: R,
    n: usize,
    options: &Options<D>,
) -> Vec<Result<TautLine<M, R, D>, SolveError>>
where
    M: Metric<D> + Send,
    R: Rule,
{
    let options = &Options { threads: 1, ..options.clone() };
    let solve =
        |workspace: &mut _, problem: &Problem<M, D>| problem.solve_in(workspace, rule, n, options);
    problems.par_iter().map_init(Workspace::default, solve).collect()
}
