//! Finer grids where the rule does not see the metric.

use std::ops::ControlFlow;

use tautline_discretizations::Rule;
use tautline_formula::Prepare;
use tautline_optimizers::{Options, Scope};

use crate::{Problem, TautLine, search::tolerance::also};

/// How much finer the finest grid may be than the one that was asked for.
const FINEST: usize = 4;

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
    /// A search of [`Scope::Local`] stays with its line. `coarser` is told of the line on each grid before the
    /// last, and may end this.
    pub(crate) fn resolved(
        &self,
        line: TautLine<M, D>,
        options: &Options<D>,
        coarser: &mut dyn FnMut(&TautLine<M, D>) -> ControlFlow<()>,
    ) -> TautLine<M, D> {
        if options.scope == Scope::Local {
            return line;
        }
        // Where to look was decided on the first grid.
        let options = Options { scope: Scope::Local, ..options.clone() };
        let (asked, mut starts) = (line.sequence().n().get(), options.starts.clone());
        let (mut shortest, mut line, mut failures) = (None, line, 0);
        loop {
            let n = line.sequence().n().get();
            failures += usize::from(!line.minimum().is_local_minimum());
            let shorter = line.shorter_minimum();
            if line.is_resolved() && shorter.is_none() {
                return shorter_of(shortest, line);
            }
            let mut found = vec![line.sequence().clone()];
            found.extend(shorter.as_ref().map(|other| other.sequence().clone()));
            starts = also(starts, found);
            let shorter = shorter.map(|other| self.in_place_of(&line, &other, &options));
            shortest = Some(shorter_of(shortest, shorter.unwrap_or_else(|| line.clone())));
            // A search that fails twice fails on finer grids.
            let is_last = failures >= 2 || n >= asked.saturating_mul(FINEST);
            if is_last || coarser(&line).is_break() {
                break;
            }
            let options = Options { starts: starts.clone(), ..options.clone() };
            let Ok(finer) = self.solve_with(line.rule(), 2 * n, &options) else { break };
            line = finer;
        }
        let line = shorter_of(shortest, line);
        match self.solve_with(Rule::SIMPSON, asked, &options) {
            Ok(simpson) => match simpson.shorter_minimum() {
                Some(other) => shorter_of(Some(line), self.in_place_of(&simpson, &other, &options)),
                None if simpson.is_shorter_than(&line) => simpson,
                None => line,
            },
            Err(_) => line,
        }
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
/// [tie](crate::TIE), which is on the finer grid.
fn shorter_of<M: Prepare<D>, const D: usize>(
    first: Option<TautLine<M, D>>,
    second: TautLine<M, D>,
) -> TautLine<M, D> {
    match first {
        Some(first) if first.is_shorter_than(&second) || second.length().value.is_nan() => first,
        _ => second,
    }
}
