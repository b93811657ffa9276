//! The section `[solve]`, with its numbers evaluated.

// The type alone: from `core`, which has no clock.
use core::{ops::Range, time::Duration};

use tautline::LARGEST_N;
use tautline_any::{CHORDS, Grid, LEAST_TOLERANCE, Nodes};

use crate::{
    Diagnostic,
    file::{
        expression::Text,
        placed::Placed,
        request::{LatticeFile, SolveFile},
        set::Vector,
    },
    reading::numbers::{Numbers, counted},
};

/// The numbers of the section `[solve]`.
#[derive(Clone, Debug)]
pub(crate) struct Solve {
    pub(crate) grid: Grid,
    pub(crate) starts: Vec<Vec<Vec<f64>>>,
    pub(crate) lattice: Option<Placed<Nodes>>,
    pub(crate) steps: Option<usize>,
    pub(crate) time_limit: Option<Duration>,
}

impl Solve {
    pub(crate) fn new(
        solve: &SolveFile,
        numbers: &Numbers<'_>,
        dimension: usize,
    ) -> Result<Self, Diagnostic> {
        let grid = match (&solve.n, &solve.tolerance) {
            (Some(_), Some(tolerance)) => {
                return Err(Diagnostic::new("a tolerance besides n", tolerance.span())
                    .label("expected n or tolerance, not both"));
            }
            (Some(n), None) => Grid::Chords(chords(n)?),
            (None, Some(text)) => Grid::Tolerance(numbers.between(text, LEAST_TOLERANCE, 1.0)?),
            (None, None) => Grid::Chords(CHORDS),
        };
        let start = |start: &Placed<Vec<Vector>>| {
            if start.get_ref().len() < 2 {
                let found = counted(start.get_ref().len(), "point");
                return Err(Diagnostic::new(format!("a start of {found}"), start.span())
                    .label("expected 2 points or more"));
            }
            start.get_ref().iter().map(|x| numbers.vector(x, dimension)).collect()
        };
        let starts = solve.starts.iter().map(start).collect::<Result<Vec<_>, _>>()?;
        // Beyond that, `Duration` overflows.
        let limit = |text: &Text| numbers.between(text, 0.0, 1e15).map(Duration::from_secs_f64);
        let time_limit = solve.time_limit.as_ref().map(limit).transpose()?;
        let lattice = solve.lattice.as_ref().map(|lattice| {
            check_grid(grid, Some(lattice.span()))?;
            let LatticeFile { lower, upper, spacing, classes } = lattice.get_ref();
            let [lower, upper] =
                [numbers.vector(lower, dimension)?, numbers.vector(upper, dimension)?];
            let classes = match classes {
                Some(classes) if *classes.get_ref() == 0 => {
                    return Err(Diagnostic::new("no homotopy class", classes.span())
                        .label("expected 1 class or more"));
                }
                classes => classes.as_ref().map_or(1, |classes| *classes.get_ref()),
            };
            let spacing = vec![numbers.number(spacing)?];
            let nodes = Nodes { lower, upper, spacing, classes };
            Ok(Placed::at(lattice.span(), nodes))
        });
        let lattice = lattice.transpose()?;
        let steps = solve.steps.as_ref().map(|steps| *steps.get_ref());
        Ok(Self { grid, starts, lattice, steps, time_limit })
    }
}

/// Refuses a tolerance besides a lattice, given the place of the lattice if there is one.
pub(crate) fn check_grid(grid: Grid, lattice: Option<Range<usize>>) -> Result<(), Diagnostic> {
    match (grid, lattice) {
        (Grid::Tolerance(_), Some(place)) => {
            Err(Diagnostic::new("a lattice besides a tolerance", place)
                .label("a search along a lattice has one grid")
                .help("choose n, the number of chords, instead of a tolerance"))
        }
        _ => Ok(()),
    }
}

fn chords(n: &Placed<usize>) -> Result<usize, Diagnostic> {
    match *n.get_ref() {
        0 => Err(Diagnostic::new("no chord", n.span()).label("expected n of at least 1")),
        n_chords if n_chords > LARGEST_N => {
            let label = format!("expected n of at most {LARGEST_N}");
            Err(Diagnostic::new(format!("{n_chords} chords"), n.span()).label(label))
        }
        n => Ok(n),
    }
}
