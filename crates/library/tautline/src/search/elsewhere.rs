//! A look elsewhere: whether a path through a lattice leads to a shorter line than the starts did.

use tautline_discretizations::PointSequence;
use tautline_formula::Prepare;
use tautline_grid::path_elsewhere;
use tautline_optimizers::{Options, Starts, Workspace, are_apart, minimise_any};

use crate::{Problem, TautLine};

/// A search with fewer chords does not look: they would not resolve a path.
const LEAST_CHORDS: usize = 16;

/// A line at the end of a path counts as shorter if its length is less by this part of it. Mirror images,
/// and one line from two sides, differ by rounding.
const SHORTER: f64 = 1e-9;

/// By how much the energies of two grids may differ for one of them to be worth a look on the finer one.
const WORTH_A_LOOK: f64 = 0.02;

impl<M: Prepare<D>, const D: usize> Problem<M, D> {
    /// Returns a line that is shorter than this one, if a path through a lattice around it and its other
    /// minima leads to one; otherwise the line itself.
    pub(crate) fn or_elsewhere(
        &self,
        workspace: &mut Workspace,
        line: TautLine<M, D>,
        options: &Options<D>,
    ) -> TautLine<M, D> {
        match self.elsewhere(workspace, &line, options) {
            Some(other) => {
                let local_minima = line.minimum().local_minima.clone();
                self.with_coarser_grids(other, options).beside(&line, local_minima)
            }
            None => line,
        }
    }

    fn elsewhere(
        &self,
        workspace: &mut Workspace,
        line: &TautLine<M, D>,
        options: &Options<D>,
    ) -> Option<TautLine<M, D>> {
        let minimum = line.minimum();
        let (rule, n) = (line.rule(), minimum.sequence.n().get());
        let known = || {
            let others = minimum.others.iter().map(|other| &other.sequence);
            [&minimum.sequence].into_iter().chain(others)
        };
        if n < LEAST_CHORDS {
            return None;
        }
        let lines: Vec<&PointSequence<D>> = known().collect();
        let start =
            path_elsewhere(&**self.prepared(), self.any_ends(), &lines, n)?.into_dimension()?;
        let coarse = start.n().get();
        let mut search = |n, starts| {
            let options = Options { starts, ..options.clone() };
            let found = minimise_any(
                workspace,
                &**self.prepared(),
                self.any_ends(),
                rule,
                n,
                &options,
                None,
            );
            found.ok().filter(|found| {
                found.is_local_minimum() && known().all(|known| are_apart(&found.sequence, known))
            })
        };
        let mut found = search(coarse, Starts::OnTheGrid(vec![start]))?;
        if coarse < n {
            // On a coarse grid the line has another energy than on its own.
            let levels = minimum.levels.iter().filter(|level| level.n >= coarse);
            let bar = levels.map(|level| level.energy).fold(minimum.energy, f64::max);
            if !(found.energy < bar * (1.0 + WORTH_A_LOOK)) {
                return None;
            }
            let before = found.iterations;
            found = search(n, Starts::Only(vec![found.sequence]))?;
            found.iterations += before;
        }
        if !(found.energy < minimum.energy) {
            return None;
        }
        let found = self.line(rule, found);
        let is_shorter = found.length_at_most() < line.length_at_most() * (1.0 - SHORTER);
        (is_shorter && found.is_resolved() >= line.is_resolved()).then_some(found)
    }
}
