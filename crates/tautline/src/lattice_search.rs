//! `Problem::solve_on_lattice`: a search that also starts from a shortest path along a lattice.

use tautline_discretizations::Rule;
use tautline_metrics::Metric;
use tautline_optimizers::{Lattice, Options, SolveError, Starts, graph_path};

use crate::{Problem, TautLine};

impl<M: Metric<D>, const D: usize> Problem<M, D> {
    /// Solves like [`solve_with`](Problem::solve_with), and once more on the grid of `n` chords from a
    /// [shortest path along a lattice](graph_path). Returns the shorter of the two lines.
    ///
    /// Use it for a metric with many hills, such as a measured one, with the spacing of its details and
    /// with chords that are shorter than they are. Local searches from bent lines end in the valleys next
    /// to them there. The starts in `options` are those of the first search.
    ///
    /// It costs an evaluation of the metric at each node, and damped Newton steps with `n` chords.
    ///
    /// # Errors
    ///
    /// As for [`solve`](Problem::solve) if both searches fail, or [`SolveError::GraphPath`] if there is no
    /// path along the lattice.
    pub fn solve_on_lattice<R: Rule>(
        &self,
        rule: R,
        n: usize,
        lattice: &Lattice<D>,
        options: &Options<D>,
    ) -> Result<TautLine<M, R, D>, SolveError> {
        let first = self.solve_with(rule, n, options);
        // A number of chords that is no grid, or for which there is no memory, is none for the path.
        if let Err(
            SolveError::NoSubinterval
            | SolveError::TooManySubintervals { .. }
            | SolveError::OutOfMemory { .. },
        ) = first
        {
            return first;
        }
        let path = graph_path(&**self.prepared(), self.ends(), lattice, n)?;
        let along = Options { starts: Starts::OnTheGrid(vec![path]), ..options.clone() };
        match [first, self.solve_with(rule, n, &along)] {
            [Ok(first), Ok(second)] => {
                // A line whose length is NaN is not the shorter one.
                let is_shorter = second.length().value < first.length().value;
                Ok(if is_shorter || first.length().value.is_nan() { second } else { first })
            }
            [Ok(line), Err(_)] | [Err(_), Ok(line)] => Ok(line),
            [Err(error), Err(_)] => Err(error),
        }
    }
}
