//! Searches that also start from shortest paths along a lattice.

use std::sync::Arc;

use tautline_discretizations::{PointSequence, Rule};
use tautline_formula::{Batches, Prepare};
use tautline_grid::{GraphPathError, Lattice, LatticeGraph, Punctures, class_paths, graph_path};
use tautline_metrics::Metric;
use tautline_optimizers::{
    Level, Minimum, Options, Other, Scope, SolveError, Starts, Workspace, are_apart,
    lowest_different,
};
use tautline_sets::Ends;

use crate::{Problem, TautLine};

/// How many times as long as the shortest path the way around a peak may be.
const SLACK: f64 = 2.0;

/// Why a search along a lattice has no line.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LatticeSearchError {
    /// There is no path along the lattice to start from.
    #[error(transparent)]
    Path(#[from] GraphPathError),
    /// There is no minimiser.
    #[error(transparent)]
    Solve(#[from] SolveError),
}

impl<M: Metric<D>, const D: usize> Problem<M, D> {
    /// Solves like [`solve_with`](Problem::solve_with), and once more on the grid of `n` chords from a
    /// [shortest path along a lattice](graph_path). Returns the shorter of the two lines; the other one is
    /// among its [other minima](TautLine::other_minima), if it is a local minimum elsewhere.
    ///
    /// Use it for a metric with many hills, such as a measured one, with the spacing of its details and
    /// with chords that are shorter than they are. Local searches from bent lines end in the valleys next
    /// to them there. The starts in `options` are those of the first search.
    ///
    /// It costs an evaluation of the metric at each node, and damped Newton steps with `n` chords. A line
    /// from the path is then followed back to `n/2` and `n/4` chords, for the
    /// [extrapolation](TautLine::distance_squared_estimate).
    ///
    /// # Errors
    ///
    /// [`LatticeSearchError::Solve`], with the error of [`solve`](Problem::solve), if both searches fail, or
    /// [`LatticeSearchError::Path`] if there is no path along the lattice.
    pub fn solve_on_lattice(
        &self,
        rule: Rule,
        n: usize,
        lattice: &Lattice<D>,
        options: &Options<D>,
    ) -> Result<TautLine<M, D>, LatticeSearchError> {
        self.solve_from(rule, n, options, || {
            lattice_starts(&**self.prepared(), self.ends(), lattice, n, None)
        })
    }

    /// Solves like [`solve_on_lattice`](Problem::solve_on_lattice), from the shortest lattice paths of
    /// `classes` homotopy classes: ways around the peaks and holes of the metric, shortest first. Each may
    /// lead to a local minimum; the shortest is the line, and up to eight others are its
    /// [other minima](TautLine::other_minima).
    ///
    /// Use it where there are obstacles. The peaks are the [prominent](Punctures::prominent) ones, and the
    /// [paths](class_paths) at most twice as long as the shortest. In space the sides are those in the first
    /// two coordinates, of peaks in the middle of the others. For 0 classes it takes one. The search for paths
    /// stores up to four million pairs of a node and a class, of about 100 bytes.
    ///
    /// ```
    /// use tautline::{Ends, Lattice, Options, Problem, Rule, gallery::{Obstacle, SoftObstacles}};
    ///
    /// // Three hills in a row across the way: there are four ways past them.
    /// let hill = |y: f64| Obstacle { centre: [0.0, y].into(), height: 20.0, width: 0.2 };
    /// let hills = SoftObstacles::new([-1.0, 0.1, 1.3].map(hill).to_vec())?;
    /// let problem = Problem::new(hills, Ends::points([-2.0, 0.0], [2.0, 0.1])?);
    /// let lattice = Lattice::new([-2.2, -2.0], [2.2, 2.2], 0.1)?;
    /// let options = Options::default();
    /// let line = problem.solve_by_classes(Rule::TRAPEZOIDAL, 64, &lattice, 4, &options)?;
    /// assert_eq!(line.other_minima().len(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`solve_on_lattice`](Problem::solve_on_lattice); also if a node of the lattice overflows, and
    /// [`SolveError::OutOfMemory`] if there is no memory for the points of all starts.
    pub fn solve_by_classes(
        &self,
        rule: Rule,
        n: usize,
        lattice: &Lattice<D>,
        classes: usize,
        options: &Options<D>,
    ) -> Result<TautLine<M, D>, LatticeSearchError> {
        self.solve_from(rule, n, options, || {
            lattice_starts(&**self.prepared(), self.ends(), lattice, n, Some(classes))
        })
    }
}

/// Returns the starts of a search along a lattice: the shortest path as `n` chords, or the shortest paths of
/// so many homotopy classes.
///
/// # Errors
///
/// As for [`solve_by_classes`](Problem::solve_by_classes).
pub fn lattice_starts<const D: usize>(
    metric: &dyn Batches<D>,
    ends: &Ends<D>,
    lattice: &Lattice<D>,
    n: usize,
    classes: Option<usize>,
) -> Result<Vec<PointSequence<D>>, LatticeSearchError> {
    let Some(classes) = classes else { return Ok(vec![graph_path(metric, ends, lattice, n)?]) };
    let peaks = Punctures::prominent(metric, lattice)?;
    let graph = LatticeGraph::usual(metric, lattice.clone());
    let paths = class_paths(&graph, ends, &peaks, classes.max(1), SLACK)?;
    Workspace::check_points(D, n, paths.len())?;
    Ok(paths.iter().map(|path| path.path().sequence(n)).collect::<Result<_, _>>()?)
}

impl<M: Prepare<D>, const D: usize> Problem<M, D> {
    /// Solves, and once more on the grid of `n` chords from other starts.
    ///
    /// The starts are bent lines along a coarse path, such as one along a lattice. Returns the shorter of the
    /// two lines; the other one is among its [other minima](TautLine::other_minima), if it is a local minimum
    /// elsewhere.
    ///
    /// # Errors
    ///
    /// As for [`solve_on_lattice`](Problem::solve_on_lattice).
    pub fn solve_from(
        &self,
        rule: Rule,
        n: usize,
        options: &Options<D>,
        starts: impl FnOnce() -> Result<Vec<PointSequence<D>>, LatticeSearchError>,
    ) -> Result<TautLine<M, D>, LatticeSearchError> {
        let options = &Options { scope: Scope::Local, ..options.clone() };
        let first = self.solve_with(rule, n, options);
        if first.as_ref().is_err_and(SolveError::is_due_to_n) {
            return Ok(first?);
        }
        match [first, self.solve_on_the_grid(rule, n, starts()?, options)] {
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
