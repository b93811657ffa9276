//! `Question`: a problem file that was read and evaluated, but for its formula.

// The type alone: from `core`, which has no clock.
use core::time::Duration;
use std::sync::Arc;

use tautline::{Constants, Formula};

use crate::{
    Diagnostic, LARGEST_DIMENSION,
    file::{
        ProblemFile,
        placed::Placed,
        request::{ConstantsFile, RuleName},
        set::SetFile,
    },
    formula::formula,
    reading::{
        numbers::{Numbers, counted},
        parse::parse,
        pieces::{pieces, region, sampled},
        shape::Piece,
        solve::Solve,
        tables::{Open, Tables, no_file, tables},
        view::{View, view},
    },
    value::Nodes,
};

/// How fine the grid is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grid {
    /// The number of chords.
    Chords(usize),
    /// The relative error of the length.
    Tolerance(f64),
}

/// A problem file that was read and evaluated, but for its formula.
#[derive(Clone, Debug)]
pub struct Question {
    /// The text of the file.
    pub(crate) file: Arc<str>,
    pub(crate) problem: Arc<ProblemFile>,
    pub(crate) dimension: usize,
    pub(crate) parameters: Vec<(String, f64)>,
    pub(crate) tables: Tables,
    /// The pieces of the two sets, if the file has them.
    pub(crate) ends: Option<[Vec<Piece>; 2]>,
    pub(crate) rule: RuleName,
    pub(crate) grid: Grid,
    pub(crate) starts: Vec<Vec<Vec<f64>>>,
    pub(crate) only_these_starts: bool,
    pub(crate) lattice: Option<Placed<Nodes>>,
    pub(crate) steps: Option<usize>,
    pub(crate) time_limit: Option<Duration>,
    pub(crate) bound: bool,
    pub(crate) claimed: Option<Constants>,
    /// The region on which constants are proved, with its place.
    pub(crate) within: Option<Piece>,
    pub(crate) boxes: usize,
    pub(crate) accuracy: f64,
    /// The corners of the box in which an audit draws samples.
    pub(crate) region: Option<[Vec<f64>; 2]>,
    pub(crate) cases: Option<u32>,
    pub(crate) seed: Option<u64>,
    pub(crate) view: View,
}

/// The number of chords that is used unless the file has another.
pub(crate) const CHORDS: usize = 256;

/// The relative error of a length that rounding leaves, so that no grid reaches less.
pub const LEAST_TOLERANCE: f64 = 1e-13;

/// The number of boxes for one constant in the plane, unless the file has another: some tenths of a
/// second.
const BOXES: usize = 100_000;

/// The relative accuracy of a constant, unless the file has another.
pub(crate) const ACCURACY: f64 = 1e-3;

/// Returns the number of boxes for one constant, unless the file has another. A box costs more in
/// more dimensions, so that a proof takes seconds, not minutes.
pub(crate) fn default_boxes(dimension: usize) -> usize {
    BOXES / 5_usize.pow(dimension.saturating_sub(2) as u32)
}

impl Question {
    /// Reads a problem file whose tables stand in it.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] with the place in the file.
    pub fn read(file: &str) -> Result<Self, Diagnostic> {
        Self::read_with(file, &mut no_file)
    }

    /// Reads a problem file. `open` returns the bytes of a file with numbers, or why it cannot be read;
    /// it is called once for each such table, in their order.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] with the place in the file.
    pub fn read_with(file: &str, open: &mut Open<'_>) -> Result<Self, Diagnostic> {
        let problem = Arc::new(parse(file)?);
        let tables = tables(&problem, &Numbers::new(file, &problem, &[])?, open)?;
        let question = Self::evaluated(file.into(), problem, tables, &[])?;
        // A wrong section is an error even where it has no effect.
        question.sweep()?;
        Ok(question)
    }

    /// Evaluates a file, with other values of some of its parameters.
    pub(crate) fn evaluated(
        file: Arc<str>,
        problem: Arc<ProblemFile>,
        tables: Tables,
        replaced: &[(&str, f64)],
    ) -> Result<Self, Diagnostic> {
        let numbers = Numbers::new(&file, &problem, replaced)?;
        let dimension = dimension(&problem)?;
        let ends = match (&problem.from, &problem.to) {
            (Some(from), Some(to)) => Some([
                pieces(from.get_ref(), &numbers, dimension)?,
                pieces(to.get_ref(), &numbers, dimension)?,
            ]),
            (None, None) => None,
            (Some(one), None) => return Err(lonely(one, "to")),
            (None, Some(one)) => return Err(lonely(one, "from")),
        };
        let solve = Solve::new(&problem.solve, &numbers, dimension)?;
        let certify = &problem.certify;
        let claimed =
            certify.constants.as_ref().map(|claimed| constants(claimed, &numbers)).transpose()?;
        let within = region(certify, &numbers, dimension)?;
        let boxes = certify
            .boxes
            .as_ref()
            .map_or_else(|| default_boxes(dimension), |boxes| *boxes.get_ref());
        let accuracy = certify
            .tolerance
            .as_ref()
            .map_or(Ok(ACCURACY), |text| numbers.between(text, 0.0, 1.0))?;
        let audit = &problem.audit;
        let region =
            audit.region.as_ref().map(|it| sampled(it, &numbers, dimension)).transpose()?;
        if let Some(none) = audit.cases.as_ref().filter(|cases| *cases.get_ref() == 0) {
            return Err(Diagnostic::new("no samples", none.span()).label("expected 1 or more"));
        }
        let bound = certify.bound.unwrap_or(true);
        let cases = audit.cases.as_ref().map(|cases| *cases.get_ref());
        let seed = audit.seed;
        let view = view(&problem, &numbers, dimension)?;
        let parameters = numbers.parameters;
        let Solve { grid, starts, lattice, steps, time_limit } = solve;
        let (rule, only_these_starts) = (problem.solve.rule, problem.solve.only_these_starts);
        Ok(Self {
            file,
            problem,
            dimension,
            parameters,
            tables,
            ends,
            rule,
            grid,
            starts,
            only_these_starts,
            lattice,
            steps,
            time_limit,
            bound,
            claimed,
            within,
            boxes,
            accuracy,
            region,
            cases,
            seed,
            view,
        })
    }

    /// Returns the number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns the formula of the metric.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] with the place in the file, if an expression is wrong or if `D` is not the
    /// number of coordinates.
    pub fn formula<const D: usize>(&self) -> Result<Formula<D>, Diagnostic> {
        if D != self.dimension {
            let message =
                format!("the metric has {}, not {D}", counted(self.dimension, "coordinate"));
            return Err(Diagnostic::new(message, self.problem.metric.span()));
        }
        formula(&self.problem, &self.numbers(), &self.tables)
    }

    /// Returns the corners of the box in which an audit draws samples, if the file has one.
    #[must_use]
    pub fn audit_region(&self) -> Option<&[Vec<f64>; 2]> {
        self.region.as_ref()
    }

    /// Returns the number of random samples for each law of an audit, if the file has one.
    #[must_use]
    pub fn audit_cases(&self) -> Option<u32> {
        self.cases
    }

    /// Returns the seed of the samples of an audit, if the file has one.
    #[must_use]
    pub fn audit_seed(&self) -> Option<u64> {
        self.seed
    }

    /// Returns the constants that the file claims for the metric.
    #[must_use]
    pub fn claimed_constants(&self) -> Option<Constants> {
        self.claimed
    }

    /// Returns the time after which everything stops.
    #[must_use]
    pub fn time_limit(&self) -> Option<Duration> {
        self.time_limit
    }

    /// Replaces the number of chords or the tolerance.
    pub fn set_grid(&mut self, grid: Grid) {
        self.grid = grid;
    }

    /// Asks for no bounds.
    pub fn without_bounds(&mut self) {
        self.bound = false;
    }

    /// Returns whether the file has the two sets between which a curve runs.
    #[must_use]
    pub fn has_ends(&self) -> bool {
        self.ends.is_some()
    }

    pub(crate) fn numbers(&self) -> Numbers<'_> {
        Numbers { file: &self.file, parameters: self.parameters.clone() }
    }
}

/// Finds out the number of coordinates.
fn dimension(problem: &ProblemFile) -> Result<usize, Diagnostic> {
    let sets = [&problem.from, &problem.to].into_iter().flatten();
    let mut vectors = sets.flat_map(|set| set.get_ref().vectors());
    let (dimension, at) = match (&problem.dimension, vectors.next()) {
        (Some(given), _) => (*given.get_ref(), given.span()),
        (None, Some(vector)) => (vector.get_ref().len(), vector.span()),
        (None, None) => {
            let message = "the number of coordinates is not given";
            return Err(Diagnostic::new(message, problem.metric.span())
                .help("write dimension = 2, say, as the first line, or [from] and [to]"));
        }
    };
    if (1..=LARGEST_DIMENSION).contains(&dimension) {
        return Ok(dimension);
    }
    Err(Diagnostic::new(format!("dimension {dimension}"), at)
        .label(format!("expected 1 to {LARGEST_DIMENSION}"))
        .help("the library solves in any dimension, from a program in Rust"))
}

fn lonely(set: &Placed<SetFile>, other: &str) -> Diagnostic {
    Diagnostic::new(format!("[{other}] is missing"), set.span())
        .label("a curve runs between two sets")
}

fn constants(claimed: &ConstantsFile, numbers: &Numbers<'_>) -> Result<Constants, Diagnostic> {
    let ConstantsFile { c1, c2, l_h, m_h } = claimed;
    let value = |text| numbers.number(text);
    let [c1_value, c2_value, l_h_value] = [value(c1)?, value(c2)?, value(l_h)?];
    let refuse = |error: tautline::HypothesisError| Diagnostic::new(error.to_string(), c1.span());
    let constants = Constants::new(c1_value, c2_value, l_h_value).map_err(refuse)?;
    match m_h {
        Some(m_h) => constants.with_m_h(value(m_h)?).map_err(refuse),
        None => Ok(constants),
    }
}
