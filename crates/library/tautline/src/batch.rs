//! `solve_all` and `answer_all`: many problems at once.

use std::sync::OnceLock;

use rayon::prelude::*;
use tautline_discretizations::Rule;
use tautline_formula::Prepare;
use tautline_optimizers::{Options, SolveError, Workspace};

use crate::{Grid, Problem, Request, RequestError, TautLine};

/// Solves many problems on all threads, and returns the results in order.
///
/// Each problem runs on one thread: [`Options::threads`] is ignored. The results equal those of
/// [`Problem::solve_with`] bit for bit, for any number of threads. An error in one problem does not
/// affect the others. The threads are those of the current rayon pool, by default one for each
/// processor. Problems on the same thread share memory, which is freed at the end.
///
/// Problems can share a metric by reference, or each can have its own metric of the same type:
///
/// ```
/// use tautline::{Ends, Options, Problem, Rule, gallery::Bump, solve_all};
///
/// let bump = Bump::new(4.0, 0.5)?;
/// let mut problems = Vec::new();
/// for to in [[1.5, -0.1], [0.0, 1.5], [0.0, -1.5]] {
///     problems.push(Problem::new(&bump, Ends::points([-1.5, 0.05], to)?));
/// }
/// let mut lengths = Vec::new();
/// for line in solve_all(&problems, Rule::TRAPEZOIDAL, 64, &Options::default()) {
///     lengths.push(line?.length().value);
/// }
/// assert!(lengths[0] > lengths[1]); // round the bump, not beside it
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Stack
///
/// In many dimensions there are matrices on the stack; if a formula is evaluated as compiled, they
/// are matrices of jets. Threads other than the first have a stack of 2 MB by default. A solve
/// compiled with optimisation was measured to need, in MB:
///
/// | `D` | 16 | 23 | 32 | 64 |
/// | --- | --- | --- | --- | --- |
/// | by programs | ⅛ | ¼ | ½ | 2 |
/// | as compiled: a formula with branches, or one with very many steps | 2 | 8 | 3 | 12 |
///
/// From `D = 24` on, derivatives are taken in eight directions at a time, which needs less stack.
/// For larger stacks use rayon's `ThreadPoolBuilder::stack_size`.
///
/// # Errors
///
/// Each result has its own error, as for [`Problem::solve`].
pub fn solve_all<M, const D: usize>(
    problems: &[Problem<M, D>],
    rule: Rule,
    n: usize,
    options: &Options<D>,
) -> Vec<Result<TautLine<M, D>, SolveError>>
where
    M: Prepare<D>,
    M::Prepared: Send,
{
    let options = &Options { threads: 1, ..options.clone() };
    let solved: Vec<OnceLock<_>> = problems.iter().map(|_| OnceLock::new()).collect();
    for_each(problems.len(), &|workspace, index| {
        // Each index comes once.
        let _ = solved[index].set(problems[index].solve_in(workspace, rule, n, options));
    });
    let solved = solved.into_iter().map(OnceLock::into_inner);
    solved.map(|line| line.unwrap_or(Err(SolveError::NoStart))).collect()
}

/// Answers the same [`Request`] for many problems on all threads, and returns the results in order.
///
/// As for [`solve_all`], each problem runs on one thread; the results equal those of
/// [`Problem::answer`] bit for bit, and an error in one problem does not affect the others.
///
/// # Errors
///
/// Each result has its own error, as for [`Problem::answer`].
pub fn answer_all<M, const D: usize>(
    problems: &[Problem<M, D>],
    request: &Request,
) -> Vec<Result<TautLine<M, D>, RequestError>>
where
    M: Prepare<D>,
    M::Prepared: Send,
{
    let request = &Request { threads: 1, ..request.clone() };
    let solved: Vec<OnceLock<_>> = problems.iter().map(|_| OnceLock::new()).collect();
    for_each(problems.len(), &|workspace, index| {
        let problem = &problems[index];
        let line = match (request.grid, &request.lattice) {
            (Grid::Chords(n), None) => problem.answer_in(workspace, n, request),
            _ => problem.answer(request),
        };
        // Each index comes once.
        let _ = solved[index].set(line);
    });
    let solved = solved.into_iter().map(OnceLock::into_inner);
    solved.map(|line| line.unwrap_or(Err(SolveError::NoStart.into()))).collect()
}

/// Calls `task` with each index below `count`, on all threads. Without a type for the task, the threads are
/// compiled once for each dimension, not for each metric and rule.
fn for_each(count: usize, task: &(dyn Fn(&mut Workspace, usize) + Sync)) {
    (0..count).into_par_iter().for_each_init(Workspace::default, task);
}
