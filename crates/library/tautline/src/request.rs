//! `Request`: how a problem is to be solved.

use std::ops::ControlFlow;

use tautline_discretizations::{ANY, PointSequence, Rule, SequenceError};
use tautline_formula::Prepare;
use tautline_grid::{GraphPathError, Nodes};
use tautline_optimizers::{Options, Scope, SolveError, Starts, Workspace};

use crate::{
    Problem, TautLine,
    search::tolerance::{FIRST_GRID, LEAST_TOLERANCE, refined},
};

/// How fine the grid is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grid {
    /// The number of chords. Where the rule does not [see the metric](TautLine::is_resolved), or another
    /// minimum is shorter by the length of its curve, they are doubled, up to four times as many; if that
    /// does not help, Simpson's rule is tried too. Where every line runs into a region without a metric, a
    /// [path round it](crate::grid::path_round) is a start, with up to 256 times as many chords. A search
    /// of [`Scope::Local`] does none of this.
    Chords(usize),
    /// The relative error of the length that extrapolation expects.
    Tolerance(f64),
}

/// The number of chords unless another is given.
pub const CHORDS: usize = FIRST_GRID;

/// How a problem is to be solved: all that a file, the command or Python can say of a search, as data in a
/// dimension that is a value.
///
/// ```
/// use tautline::{Ends, Nodes, Problem, Request, gallery::{Obstacle, SoftObstacles}};
///
/// // Three hills in a row across the way: there are four ways past them.
/// let hill = |y: f64| Obstacle { centre: [0.0, y].into(), height: 20.0, width: 0.2 };
/// let hills = SoftObstacles::new([-1.0, 0.1, 1.3].map(hill).to_vec())?;
/// let problem = Problem::new(hills, Ends::points([-2.0, 0.0], [2.0, 0.1])?);
/// let nodes = Nodes { classes: 4, ..Nodes::new([-2.2, -2.0], [2.2, 2.2], 0.1) };
/// let line = problem.answer(&Request { lattice: Some(nodes), ..Request::chords(64) })?;
/// assert_eq!(line.other_minima().len(), 3);
/// // The length of the shortest of them, to eight digits.
/// let exact = problem.answer(&Request::tolerance(1e-8))?;
/// assert!(exact.is_within(1e-8) && line.length().value < 1.01 * exact.length().value);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The rule of numerical integration.
    pub rule: Rule,
    /// The number of chords, or the relative error of the length.
    pub grid: Grid,
    /// Polygons from which a search starts, in addition to the automatic starts.
    pub starts: Vec<Vec<Vec<f64>>>,
    /// Whether they replace the automatic starts.
    pub only_these_starts: bool,
    /// How far a search looks, unless it has nodes, or starts that replace the automatic ones.
    pub scope: Scope,
    /// Nodes of a lattice; a second search starts from shortest paths along them, with all of the chords, so
    /// that their number is needed. The shorter of both lines is the result. The other one is among its
    /// [other minima](TautLine::other_minima), if it is a local minimum elsewhere.
    ///
    /// It costs an evaluation of the metric at each node, and damped Newton steps with `n` chords. A line
    /// from a path is then followed back to `n/2` and `n/4` chords, for the
    /// [extrapolation](TautLine::distance_squared_estimate).
    pub lattice: Option<Nodes>,
    /// The largest number of Newton steps of a local search on one grid.
    pub steps: usize,
    /// The number of threads for one problem, 1 or 2.
    pub threads: usize,
}

impl Default for Request {
    /// Returns the trapezoidal rule with 256 chords, automatic starts, and the options of a search.
    fn default() -> Self {
        let Options { scope, iterations, threads, .. } = Options::<1>::default();
        Self {
            rule: Rule::default(),
            grid: Grid::Chords(CHORDS),
            starts: Vec::new(),
            only_these_starts: false,
            scope,
            lattice: None,
            steps: iterations,
            threads,
        }
    }
}

/// Why a request has no line.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RequestError {
    /// A point of a start does not have one coordinate for each dimension.
    #[error("a point of a start has {found} coordinates in {dimension} dimensions")]
    Coordinates {
        /// The number of coordinates.
        found: usize,
        /// The dimension.
        dimension: usize,
    },
    /// A start is no sequence of points.
    #[error("a start: {0}")]
    Start(#[from] SequenceError),
    /// The tolerance is less than [`LEAST_TOLERANCE`], or not less than 1.
    #[error(
        "the tolerance is {tolerance}; it must be at least {LEAST_TOLERANCE:e} and less than 1"
    )]
    Tolerance {
        /// The relative error of the length that was wanted.
        tolerance: f64,
    },
    /// A lattice was given besides a tolerance.
    #[error("a lattice besides a tolerance: a search along a lattice has a number of chords")]
    LatticeAndTolerance,
    /// A lattice, or a path along it, is not there.
    #[error(transparent)]
    Lattice(#[from] GraphPathError),
    /// Nothing was found.
    #[error(transparent)]
    Solve(#[from] SolveError),
}

impl Request {
    /// Returns the default request with so many chords.
    #[must_use]
    pub fn chords(n: usize) -> Self {
        Self { grid: Grid::Chords(n), ..Self::default() }
    }

    /// Returns the default request with this relative error of the length.
    #[must_use]
    pub fn tolerance(tolerance: f64) -> Self {
        Self { grid: Grid::Tolerance(tolerance), ..Self::default() }
    }

    /// Returns the options of a search in this dimension.
    ///
    /// # Errors
    ///
    /// [`RequestError::Coordinates`] and [`RequestError::Start`].
    pub fn options<const D: usize>(&self, dimension: usize) -> Result<Options<D>, RequestError> {
        let mut starts = Vec::new();
        for start in &self.starts {
            if let Some(x) = start.iter().find(|x| x.len() != dimension) {
                return Err(RequestError::Coordinates { found: x.len(), dimension });
            }
            let start = PointSequence::<ANY>::from_coordinates(dimension, start.concat())?;
            let found = start.dimension();
            let start = start.into_dimension();
            starts.push(start.ok_or(RequestError::Coordinates { found, dimension: D })?);
        }
        let starts = match (starts.is_empty(), self.only_these_starts) {
            (_, true) => Starts::Only(starts),
            (true, false) => Starts::Automatic,
            (false, false) => Starts::Also(starts),
        };
        Ok(Options { starts, scope: self.scope, iterations: self.steps, threads: self.threads })
    }
}

impl<M: Prepare<D>, const D: usize> Problem<M, D> {
    /// Returns the line that a request asks for.
    ///
    /// # Errors
    ///
    /// [`RequestError`].
    pub fn answer(&self, request: &Request) -> Result<TautLine<M, D>, RequestError> {
        self.answer_watched(request, &mut |_| ControlFlow::Continue(()))
    }

    /// Does the same. `coarser` is told of the line on each coarser grid, and may end the search for finer
    /// ones; the result is then one of the lines that are known.
    ///
    /// # Errors
    ///
    /// [`RequestError`].
    pub fn answer_watched(
        &self,
        request: &Request,
        coarser: &mut dyn FnMut(&TautLine<M, D>) -> ControlFlow<()>,
    ) -> Result<TautLine<M, D>, RequestError> {
        let options = request.options(self.any_ends().dimension())?;
        Ok(match (request.grid, &request.lattice) {
            (Grid::Chords(n), None) => {
                let line = self.solve_with(request.rule, n, &options);
                let line = self.or_round(line, request.rule, n, &options)?;
                self.resolved(line, &options, coarser)
            }
            (Grid::Chords(n), Some(nodes)) => {
                let line = self.solve_along(request.rule, n, nodes, &options)?;
                self.resolved(line, &options, coarser)
            }
            (Grid::Tolerance(_), Some(_)) => return Err(RequestError::LatticeAndTolerance),
            (Grid::Tolerance(tolerance), None) => {
                if !(LEAST_TOLERANCE..1.0).contains(&tolerance) {
                    return Err(RequestError::Tolerance { tolerance });
                }
                let line = self.solve_with(request.rule, FIRST_GRID, &options);
                let line = self.or_round(line, request.rule, FIRST_GRID, &options)?;
                let line = self.resolved(line, &options, coarser);
                refined(self, line, tolerance, &options, coarser)
            }
        })
    }

    /// Returns the line with `n` chords that a request asks for, found in the given memory.
    pub(crate) fn answer_in(
        &self,
        workspace: &mut Workspace,
        n: usize,
        request: &Request,
    ) -> Result<TautLine<M, D>, RequestError> {
        let options = request.options(self.any_ends().dimension())?;
        let line = self.solve_in(workspace, request.rule, n, &options);
        let line = self.or_round(line, request.rule, n, &options)?;
        Ok(self.resolved(line, &options, &mut |_| ControlFlow::Continue(())))
    }
}
