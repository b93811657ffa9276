//! A way round, where every search runs into a region without a metric.

use tautline_discretizations::{PointSequence, Rule};
use tautline_formula::Prepare;
use tautline_grid::path_round;
use tautline_optimizers::{Options, Scope, SolveError, Starts};

use crate::{Problem, TautLine};

/// How much finer the grid may be than the one that was asked for, and how fine at most: chords must be
/// shorter than a region is thick, or the curve leaps over it.
const FINER: [usize; 5] = [1, 4, 16, 64, 256];
const FINEST: usize = 1 << 16;

/// The number of chords of the path, more than a coarse lattice has edges along it.
const PATH: usize = 4096;

impl<M: Prepare<D>, const D: usize> Problem<M, D> {
    /// Returns what a search from automatic starts found. If the metric is undefined somewhere on each of its
    /// lines, the result is a line from a [path round](path_round) there, with up to 256 times as many
    /// chords, at most 65 536 unless more were asked for, if there is one. A search of [`Scope::Local`] and one of a black box, which may have no values
    /// beyond the ends, do not look.
    pub(crate) fn or_round(
        &self,
        found: Result<TautLine<M, D>, SolveError>,
        rule: Rule,
        n: usize,
        options: &Options<D>,
    ) -> Result<TautLine<M, D>, SolveError> {
        let is_free = matches!(options.starts, Starts::Automatic | Starts::Also(_));
        let looks = is_free && options.scope != Scope::Local && M::formula(self.prepared()).is_ok();
        match found {
            Err(error @ SolveError::Metric(_)) if looks => {
                self.round(rule, n, options)?.ok_or(error)
            }
            found => found,
        }
    }

    fn round(
        &self,
        rule: Rule,
        n: usize,
        options: &Options<D>,
    ) -> Result<Option<TautLine<M, D>>, SolveError> {
        let path = path_round(&**self.prepared(), self.any_ends(), PATH);
        let Some(start) = path.and_then(PointSequence::into_dimension) else { return Ok(None) };
        for finer in FINER.into_iter().map(|times| n.saturating_mul(times)) {
            if finer > n.max(FINEST) {
                break;
            }
            let starts = Starts::OnTheGrid(vec![start.clone()]);
            let on_the_grid = Options { starts, ..options.clone() };
            let line = match self.solve_with(rule, finer, &on_the_grid) {
                Ok(line) => line,
                Err(error @ SolveError::Interrupted { .. }) => return Err(error),
                Err(_) => continue,
            };
            // Of a chord that cuts a corner of a region the check may miss the corner.
            if line.length().value.is_finite() {
                return Ok(Some(self.with_coarser_grids(line, options)));
            }
        }
        Ok(None)
    }
}
