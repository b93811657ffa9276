//! `Request`: how a problem is to be solved.

use tautline::{
    Constants, Lattice, LatticeSearchError, Options, PointSequence, Problem, Rule, SVector, Starts,
    TautLine, certify::Accuracy,
};

use super::GivenError;
use crate::{
    Grid,
    bounds::Proving,
    known::Known,
    question::{ACCURACY, CHORDS, default_boxes},
    reading::shape::vector,
};

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
        let Options { iterations, threads, .. } = Options::<1>::default();
        Self {
            rule: Rule::default(),
            grid: Grid::Chords(CHORDS),
            starts: Vec::new(),
            only_these_starts: false,
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
    pub(crate) fn lattice<const D: usize>(&self) -> Result<Lattice<D>, GivenError> {
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

    /// Solves a problem from the shortest path along a lattice of these nodes, or from those of the classes.
    pub(crate) fn solve<const D: usize>(
        &self,
        problem: &Problem<Known<D>, D>,
        rule: Rule,
        n: usize,
        lattice: &Lattice<D>,
        options: &Options<D>,
    ) -> Result<TautLine<Known<D>, D>, LatticeSearchError> {
        if self.classes <= 1 {
            problem.solve_on_lattice(rule, n, lattice, options)
        } else {
            problem.solve_by_classes(rule, n, lattice, self.classes, options)
        }
    }
}

impl Request {
    /// Returns the options of a search in `D` dimensions.
    pub(super) fn options<const D: usize>(&self) -> Result<Options<D>, GivenError> {
        let mut starts = Vec::new();
        for start in &self.starts {
            if let Some(x) = start.iter().find(|x| x.len() != D) {
                let (what, found) = ("a point of a start", x.len());
                return Err(GivenError::Coordinates { what, found, dimension: D });
            }
            starts.push(PointSequence::new(start.iter().map(|x| vector::<D>(x)).collect())?);
        }
        let starts = match (starts.is_empty(), self.only_these_starts) {
            (_, true) => Starts::Only(starts),
            (true, false) => Starts::Automatic,
            (false, false) => Starts::Also(starts),
        };
        Ok(Options { starts, iterations: self.steps, threads: self.threads })
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
    pub(super) fn accuracy(&self, dimension: usize) -> Accuracy {
        Accuracy {
            tolerance: self.tolerance.unwrap_or(ACCURACY),
            budget: self.boxes.unwrap_or(default_boxes(dimension)),
        }
    }

    pub(super) fn proving(&self, dimension: usize) -> Proving {
        Proving { claimed: self.claimed, is_in_a_region: false, accuracy: self.accuracy(dimension) }
    }
}
