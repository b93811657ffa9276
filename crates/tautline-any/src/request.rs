//! `Request`: how a problem is to be solved.

use core::ops::ControlFlow;

use tautline::{
    ANY, BatchesIn, Constants, GraphPathError, Known, Lattice, Options, PointSequence, Problem,
    Rule, SVector, Scope, SolveError, Starts, certify::Accuracy, lattice_starts,
};

use crate::{
    GivenError, Line,
    bounds::Proving,
    dimension::{InDimension, in_small_dimension},
    ends::vector,
    tolerance::{FIRST_GRID, refined},
};

/// How fine the grid is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grid {
    /// The number of chords.
    Chords(usize),
    /// The relative error of the length.
    Tolerance(f64),
}

/// The number of chords unless another is given.
pub const CHORDS: usize = 256;

/// The relative error of a length that rounding leaves, so that no grid reaches less.
pub const LEAST_TOLERANCE: f64 = 1e-13;

/// The number of boxes for one constant in the plane, unless another is given: some tenths of a second.
const BOXES: usize = 100_000;

/// The relative accuracy of a constant, unless another is given.
pub const ACCURACY: f64 = 1e-3;

/// Returns the number of boxes for one constant, unless another is given. A box costs more in
/// more dimensions, so that a proof takes seconds, not minutes.
#[must_use]
pub fn default_boxes(dimension: usize) -> usize {
    // From nine dimensions on, one is left.
    let dear = dimension.saturating_sub(2).min(7) as u32;
    BOXES / 5_usize.pow(dear)
}

/// How a problem is to be solved.
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
    /// Nodes; a search also starts from shortest paths along them, with all of the chords. It needs their
    /// number. See [`solve_on_lattice`](Problem::solve_on_lattice).
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

/// The nodes of a [lattice](Lattice) in a box.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// The first node, in `ℓ`.
    pub lower: Vec<f64>,
    /// The corner at which the nodes end, in `ℓ`.
    pub upper: Vec<f64>,
    /// The distance of neighbouring nodes, in `ℓ`: one number, or one for each axis.
    pub spacing: Vec<f64>,
    /// The most homotopy classes whose shortest paths are starts, see
    /// [`solve_by_classes`](Problem::solve_by_classes). With 1, or 0, it is the shortest path of all.
    pub classes: usize,
}

impl Nodes {
    /// Returns the lattice in `D` dimensions.
    fn lattice<const D: usize>(&self) -> Result<Lattice<D>, GivenError> {
        for corner in [&self.lower, &self.upper] {
            if corner.len() != D {
                let (what, found) = ("a corner of a lattice", corner.len());
                return Err(GivenError::Coordinates { what, found, dimension: D });
            }
        }
        let spacing = match self.spacing[..] {
            [spacing] => SVector::from_element(spacing),
            ref each if each.len() == D => vector::<D>(each),
            ref each => {
                let (what, found) = ("the spacing of a lattice", each.len());
                return Err(GivenError::Coordinates { what, found, dimension: D });
            }
        };
        let [lower, upper] = [&self.lower, &self.upper].map(|corner| vector::<D>(corner));
        Ok(Lattice::with_spacings(lower, upper, spacing)?)
    }

    /// Solves a problem from the shortest paths along the lattice too.
    ///
    /// # Errors
    ///
    /// [`GivenError::Coordinates`], [`GivenError::Lattice`], [`GivenError::Solve`].
    pub(crate) fn solve(
        &self,
        problem: &Problem<Known, ANY>,
        rule: Rule,
        n: usize,
        options: &Options<ANY>,
    ) -> Result<Line, GivenError> {
        let dimension = problem.any_ends().dimension();
        let search = AlongLattice { nodes: self, problem, rule, n, options };
        let too_many = GraphPathError::Dimension { dimension };
        in_small_dimension(dimension, search).unwrap_or(Err(too_many.into()))
    }
}

/// A search along a lattice.
struct AlongLattice<'r> {
    nodes: &'r Nodes,
    problem: &'r Problem<Known, ANY>,
    rule: Rule,
    n: usize,
    options: &'r Options<ANY>,
}

impl InDimension for AlongLattice<'_> {
    type Output = Result<Line, GivenError>;

    fn run<const D: usize>(self) -> Self::Output {
        let Self { nodes, problem, rule, n, options } = self;
        let lattice = nodes.lattice::<D>()?;
        let classes = (nodes.classes > 1).then_some(nodes.classes);
        let starts = || {
            let dimension = problem.any_ends().dimension();
            let other = SolveError::Dimension { metric: dimension, found: D };
            let metric = BatchesIn::<D>::new(problem.metric());
            let (metric, ends) = metric.zip(problem.any_ends().in_dimension()).ok_or(other)?;
            let starts = lattice_starts(&metric, &ends, &lattice, n, classes)?;
            Ok(starts.into_iter().map(PointSequence::into_any).collect())
        };
        Ok(problem.solve_from(rule, n, options, starts)?)
    }
}

impl Request {
    /// Returns the line of a problem. With a tolerance, `coarser` is told of the line on each coarser grid,
    /// and may end the search for finer ones.
    ///
    /// # Errors
    ///
    /// [`GivenError`].
    pub fn line(
        &self,
        problem: &Problem<Known, ANY>,
        coarser: &mut dyn FnMut(&Line) -> ControlFlow<()>,
    ) -> Result<Line, GivenError> {
        let (rule, options) = (self.rule, self.options(problem.any_ends().dimension())?);
        Ok(match (self.grid, &self.lattice) {
            (Grid::Chords(n), None) => problem.solve_with(rule, n, &options)?,
            (Grid::Chords(n), Some(nodes)) => nodes.solve(problem, rule, n, &options)?,
            (Grid::Tolerance(_), Some(_)) => return Err(GivenError::LatticeAndTolerance),
            (Grid::Tolerance(tolerance), None) => {
                if !(LEAST_TOLERANCE..1.0).contains(&tolerance) {
                    return Err(GivenError::Tolerance { tolerance });
                }
                let line = problem.solve_with(rule, FIRST_GRID, &options)?;
                refined(problem, rule, line, tolerance, &options, coarser)
            }
        })
    }

    /// Returns the options of a search in this dimension.
    pub(crate) fn options(&self, dimension: usize) -> Result<Options<ANY>, GivenError> {
        let mut starts = Vec::new();
        for start in &self.starts {
            if let Some(x) = start.iter().find(|x| x.len() != dimension) {
                let (what, found) = ("a point of a start", x.len());
                return Err(GivenError::Coordinates { what, found, dimension });
            }
            starts.push(PointSequence::from_coordinates(dimension, start.concat())?);
        }
        let starts = match (starts.is_empty(), self.only_these_starts) {
            (_, true) => Starts::Only(starts),
            (true, false) => Starts::Automatic,
            (false, false) => Starts::Also(starts),
        };
        Ok(Options { starts, scope: self.scope, iterations: self.steps, threads: self.threads })
    }
}

/// How bounds and constants are proved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Proofs {
    /// Constants that are claimed for the metric. Without them they are proved from its formula.
    pub claimed: Option<Constants>,
    /// The relative accuracy of a constant; a thousandth if absent.
    pub tolerance: Option<f64>,
    /// The largest number of boxes for one constant; 100,000 in the plane if absent, and a fifth of
    /// that for each further dimension.
    pub boxes: Option<usize>,
}

impl Proofs {
    pub(crate) fn accuracy(&self, dimension: usize) -> Accuracy {
        Accuracy {
            tolerance: self.tolerance.unwrap_or(ACCURACY),
            budget: self.boxes.unwrap_or(default_boxes(dimension)),
        }
    }

    pub(crate) fn proving(&self, dimension: usize) -> Proving {
        Proving { claimed: self.claimed, is_in_a_region: false, accuracy: self.accuracy(dimension) }
    }
}
