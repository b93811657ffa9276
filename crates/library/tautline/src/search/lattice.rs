//! Searches that also start from shortest paths along a lattice.

use std::sync::Arc;

use tautline_discretizations::{PointSequence, Rule};
use tautline_formula::Prepare;
use tautline_grid::Nodes;
use tautline_optimizers::{
    Level, Minimum, Options, Other, Scope, SolveError, Starts, Workspace, are_apart,
    lowest_different,
};

use crate::{Problem, RequestError, TautLine};

impl<M: Prepare<D>, const D: usize> Problem<M, D> {
    /// Solves, and once more on the grid of `n` chords from shortest paths along a lattice.
    ///
    /// Returns the shorter of the two lines; the other one is among its
    /// [other minima](TautLine::other_minima), if it is a local minimum elsewhere.
    ///
    /// # Errors
    ///
    /// [`RequestError::Solve`], with the error of [`solve`](Problem::solve), if both searches fail, or if there
    /// is no memory for the points of all starts, or [`RequestError::Lattice`] if there is no path along the
    /// lattice.
    pub(crate) fn solve_along(
        &self,
        rule: Rule,
        n: usize,
        nodes: &Nodes,
        options: &Options<D>,
    ) -> Result<TautLine<M, D>, RequestError> {
        let options = &Options { scope: Scope::Local, ..options.clone() };
        let first = self.solve_with(rule, n, options);
        if first.as_ref().is_err_and(SolveError::is_due_to_n) {
            return Ok(first?);
        }
        let starts = self.lattice_starts(n, nodes)?;
        match [first, self.solve_on_the_grid(rule, n, starts, options)] {
            [Ok(first), Ok(second)] => {
                // A line whose length is NaN is not the shorter one.
                let is_shorter = second.length().value < first.length().value;
                // The path has no coarsest grid of its own.
                let local_minima = first.minimum().local_minima.clone();
                Ok(if is_shorter || first.length().value.is_nan() {
                    self.with_coarser_grids(second, options).beside(&first, local_minima)
                } else {
                    first.beside(&second, local_minima)
                })
            }
            [Ok(line), Err(_)] => Ok(line),
            [Err(_), Ok(line)] => Ok(self.with_coarser_grids(line, options)),
            [Err(error), Err(_)] => Err(error.into()),
        }
    }

    fn lattice_starts(
        &self,
        n: usize,
        nodes: &Nodes,
    ) -> Result<Vec<PointSequence<D>>, RequestError> {
        let (metric, ends) = (&**self.prepared(), self.any_ends());
        let mut memory = Ok(());
        let is_room = &mut |paths| {
            memory = Workspace::check_points(ends.dimension(), n, paths);
            memory.is_ok()
        };
        let starts = nodes.starts(metric, ends, n, is_room)?;
        memory?;
        Ok(starts.into_iter().flatten().filter_map(PointSequence::into_dimension).collect())
    }

    fn solve_on_the_grid(
        &self,
        rule: Rule,
        n: usize,
        starts: Vec<PointSequence<D>>,
        options: &Options<D>,
    ) -> Result<TautLine<M, D>, SolveError> {
        let starts = Starts::OnTheGrid(starts);
        self.solve_with(rule, n, &Options { starts, ..options.clone() })
    }

    /// Adds the energies on the grids of half and a quarter of the chords, as far as they resolve the
    /// metric and have a minimum next to the line.
    pub(crate) fn with_coarser_grids(
        &self,
        line: TautLine<M, D>,
        options: &Options<D>,
    ) -> TautLine<M, D> {
        let n = line.sequence().n().get();
        let mut minimum = line.minimum().clone();
        for coarser in [n.div_ceil(2), n.div_ceil(4)] {
            if coarser >= minimum.levels[0].n {
                break;
            }
            let start = vec![line.sequence().clone()];
            let found = self.solve_on_the_grid(line.rule(), coarser, start, options);
            let Ok(found) = found else { break };
            minimum.iterations += found.minimum().iterations;
            let is_there = found.minimum().is_local_minimum() && found.is_resolved();
            if !is_there || are_apart(found.sequence(), line.sequence()) {
                break;
            }
            minimum.levels.insert(0, Level { n: coarser, energy: found.discrete_energy() });
        }
        line.with_minimum(minimum)
    }
}

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Adds another line to the other minima, and the lowest of what was met on the way to it.
    pub(crate) fn beside(self, line: &Self, local_minima: Vec<f64>) -> Self {
        let (mut minimum, found) = (self.minimum().clone(), line.minimum());
        minimum.iterations += found.iterations;
        minimum.local_minima = local_minima;
        let own = Other { sequence: found.sequence.clone(), energy: found.energy };
        let is_other = found.is_local_minimum() && are_apart(&found.sequence, self.sequence());
        let own = is_other.then_some(own);
        let is_new = |other: &Other<D>| {
            own.as_ref().is_none_or(|own| are_apart(&other.sequence, &own.sequence))
        };
        let met = [&minimum.others[..], &found.others].concat();
        minimum.others = lowest_different(met, self.sequence(), &is_new);
        if let Some(own) = own {
            let place = minimum.others.partition_point(|other| other.energy <= own.energy);
            minimum.others.insert(place, own);
        }
        self.with_minimum(minimum)
    }

    fn with_minimum(self, minimum: Minimum<D>) -> Self {
        Self::new(Arc::clone(self.prepared()), self.rule(), self.both_ends().clone(), minimum)
    }
}
