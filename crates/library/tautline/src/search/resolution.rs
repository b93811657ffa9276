//! Finer grids where the rule does not see the metric.

use std::ops::ControlFlow;

use tautline_discretizations::Rule;
use tautline_formula::Prepare;
use tautline_optimizers::{Options, Scope};

use crate::{Problem, TautLine, search::tolerance::also};

/// How much finer the finest grid may be than the one that was asked for, and how fine at most: on a grid
/// of thousands of chords the metric is not hidden between them, but vanishes or is infinite somewhere.
const FINER: usize = 4;
const FINEST: usize = 4096;

/// By how much shorter a line is that counts although its search came to no local minimum.
const MUCH: f64 = 0.01;

impl<M: Prepare<D>, const D: usize> Problem<M, D> {
    /// Returns the shortest line that is met, by the length of its curve, on the way from this line to a
    /// grid that [resolves](TautLine::is_resolved) the metric and on which no other minimum is shorter.
    ///
    /// The rule does not see what lies between its points: by its energy a longer curve may be the
    /// lower minimum. On a finer grid the shorter curve should have less energy too. Under a metric
    /// that vanishes somewhere no grid is fine enough for the rules of the paper, since a chord whose only
    /// node is there has no energy, however long it is. Simpson's rule also sees the ends of such a chord.
    /// If the finest grid does not resolve the metric, the line is the shortest one of both rules.
    ///
    /// A search of [`Scope::Local`] stays with its line. Where the metric is not resolved, `coarser` is
    /// told of the shortest line so far before each further search, and may end this.
    pub(crate) fn resolved(
        &self,
        line: TautLine<M, D>,
        options: &Options<D>,
        coarser: &mut dyn FnMut(&TautLine<M, D>) -> ControlFlow<()>,
    ) -> TautLine<M, D> {
        if options.scope == Scope::Local || line.is_resolved() && line.minimum().others.is_empty() {
            return line;
        }
        // Where to look was decided on the first grid.
        let options = Options { scope: Scope::Local, ..options.clone() };
        let (asked, mut starts) = (line.sequence().n().get(), options.starts.clone());
        let finest = asked.max(FINEST.min(asked.saturating_mul(FINER)));
        let (mut best, mut line, mut failures) = (line.clone(), line, 0);
        loop {
            if !line.is_resolved() && coarser(&best).is_break() {
                return best;
            }
            let n = line.sequence().n().get();
            failures += usize::from(!line.minimum().is_local_minimum());
            let shorter = line.shorter_minimum();
            if line.is_resolved() && shorter.is_none() {
                return better_of(best, line);
            }
            let mut found = vec![line.sequence().clone()];
            if let Some(other) = shorter {
                found.push(other.sequence().clone());
                best = better_of(best, self.in_place_of(&line, &other, &options));
            }
            best = better_of(best, line.clone());
            starts = also(starts, found);
            // A search that fails twice fails on finer grids.
            if failures >= 2 || 2 * n > finest {
                break;
            }
            let options = Options { starts: starts.clone(), ..options.clone() };
            let Ok(finer) = self.solve_with(line.rule(), 2 * n, &options) else { break };
            line = finer;
        }
        if coarser(&best).is_break() {
            return best;
        }
        let Ok(simpson) = self.solve_with(Rule::SIMPSON, asked, &options) else { return best };
        let simpson = match simpson.shorter_minimum() {
            Some(other) => self.in_place_of(&simpson, &other, &options),
            None => simpson,
        };
        // The rule that was asked for, if both are as good.
        if simpson.is_shorter_than(&best) { better_of(best, simpson) } else { best }
    }

    /// Returns another minimum of a line as a line of its own, and that line among its other minima.
    fn in_place_of(
        &self,
        line: &TautLine<M, D>,
        other: &TautLine<M, D>,
        options: &Options<D>,
    ) -> TautLine<M, D> {
        let local_minima = line.minimum().local_minima.clone();
        let other = self.line(line.rule(), other.minimum().clone());
        self.with_coarser_grids(other, options).beside(line, local_minima)
    }
}

/// Returns the shorter one of two lines, by the lengths of their curves, and the second one of lines that
/// [tie](crate::TIE), which is on the finer grid. A line whose search came to no local minimum is better
/// than one whose search did only if it is much shorter.
fn better_of<M: Prepare<D>, const D: usize>(
    first: TautLine<M, D>,
    second: TautLine<M, D>,
) -> TautLine<M, D> {
    let is_minimum = [&first, &second].map(|line| line.minimum().is_local_minimum());
    let [one, other] = [&first, &second].map(TautLine::length_at_most);
    let is_second_better = match is_minimum {
        // Written so that NaN is not better.
        [true, false] => other < one * (1.0 - MUCH),
        [false, true] => !(one < other * (1.0 - MUCH)),
        _ => !first.is_shorter_than(&second) && !other.is_nan(),
    };
    if is_second_better { second } else { first }
}
