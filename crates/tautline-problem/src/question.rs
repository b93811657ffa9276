//! `Question`: a problem file that was read and evaluated, but for its formula.

use std::{ops::Range, time::Duration};

use tautline::{Constants, Formula};
use tautline_portrait::{Field, Shape};

use crate::{
    Diagnostic, LARGEST_DIMENSION,
    file::{
        ProblemFile,
        expression::Text,
        placed::Placed,
        request::{CertifyFile, ConstantsFile, FieldFile, RuleFile, SolveFile},
        set::{AffineFile, Corners, HalfSpaceFile, Round, SegmentFile, SetFile, Vector},
    },
    formula::formula,
    numbers::{Numbers, counted},
    parse::parse,
    shape::Piece,
};

/// How fine the grid is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grid {
    /// The number of chords.
    Chords(usize),
    /// The relative error of the length.
    Tolerance(f64),
}

/// What a file asks to be drawn.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct View {
    /// The two coordinates, from 0; `None` to choose them by the curve.
    pub(crate) coordinates: Option<[usize; 2]>,
    pub(crate) field: Field,
    /// The range of each drawn coordinate; `None` to choose it by the curve.
    pub(crate) window: Option<[[f64; 2]; 2]>,
}

/// A problem file that was read and evaluated, but for its formula.
#[derive(Clone, Debug)]
pub struct Question {
    /// The text of the file.
    pub(crate) file: String,
    pub(crate) problem: ProblemFile,
    pub(crate) dimension: usize,
    pub(crate) parameters: Vec<(String, f64)>,
    /// The pieces of the two sets, if the file has them.
    pub(crate) ends: Option<[Vec<Piece>; 2]>,
    pub(crate) rule: RuleFile,
    pub(crate) grid: Grid,
    pub(crate) starts: Vec<Vec<Vec<f64>>>,
    pub(crate) only_these_starts: bool,
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
const CHORDS: usize = 256;

/// The number of boxes for one constant that is used unless the file has another: some tenths of a
/// second in the plane.
const BOXES: usize = 100_000;

impl Question {
    /// Reads a problem file.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] with the place in the file.
    pub fn read(file: &str) -> Result<Self, Diagnostic> {
        let problem = parse(file)?;
        let numbers = Numbers::new(file, &problem)?;
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
        let boxes = certify.boxes.as_ref().map_or(BOXES, |boxes| *boxes.get_ref());
        let accuracy =
            certify.tolerance.as_ref().map_or(Ok(1e-3), |text| numbers.between(text, 0.0, 1.0))?;
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
        let Solve { grid, starts, steps, time_limit } = solve;
        let (rule, only_these_starts) = (problem.solve.rule, problem.solve.only_these_starts);
        let file = file.to_owned();
        Ok(Self {
            file,
            problem,
            dimension,
            parameters,
            ends,
            rule,
            grid,
            starts,
            only_these_starts,
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
        formula(&self.problem, &self.numbers())
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

/// Returns the pieces of a set. Unions of unions are flattened.
fn pieces(
    set: &SetFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Vec<Piece>, Diagnostic> {
    let vector = |vector: &Vector| numbers.vector(vector, dimension);
    let list = |vectors: &[Vector]| vectors.iter().map(vector).collect::<Result<Vec<_>, _>>();
    let (shape, places): (Shape, Vec<Range<usize>>) = match set {
        SetFile::Point(x) => (Shape::Point(vector(x)?), vec![x.span()]),
        SetFile::Points(points) => (Shape::Points(list(points.get_ref())?), vec![points.span()]),
        SetFile::Ball(Round { centre, radius }) | SetFile::Sphere(Round { centre, radius }) => {
            let places = vec![centre.span(), radius.span()];
            let (centre, radius) = (vector(centre)?, numbers.number(radius)?);
            if matches!(set, SetFile::Ball(_)) {
                (Shape::Ball { centre, radius }, places)
            } else {
                (Shape::Sphere { centre, radius }, places)
            }
        }
        SetFile::Box(corners @ Corners { lower, upper }) => {
            let places = vec![lower.span(), upper.span()];
            let [low, high] = self::corners(corners, numbers, dimension)?;
            (Shape::AxisBox { low, high }, places)
        }
        SetFile::HalfSpace(HalfSpaceFile { normal, at_least, at_most }) => {
            let places = vec![normal.span()];
            let (span, normal) = (normal.span(), vector(normal)?);
            match (at_least, at_most) {
                (Some(at_least), None) => {
                    let normal = normal.iter().map(|x| -x).collect();
                    (Shape::HalfSpace { normal, offset: -numbers.number(at_least)? }, places)
                }
                (None, Some(at_most)) => {
                    (Shape::HalfSpace { normal, offset: numbers.number(at_most)? }, places)
                }
                (Some(_), Some(other)) => {
                    return Err(Diagnostic::new("a half-space has one side", other.span())
                        .label("expected at_least or at_most, not both"));
                }
                (None, None) => {
                    return Err(Diagnostic::new("a half-space needs at_least or at_most", span)
                        .label("the side of this normal is not given"));
                }
            }
        }
        SetFile::Segment(SegmentFile { from, to }) => {
            let places = vec![from.span(), to.span()];
            (Shape::Segment { from: vector(from)?, to: vector(to)? }, places)
        }
        SetFile::Affine(AffineFile { through, directions }) => {
            let spans = directions.get_ref().iter().map(Placed::span);
            let places = std::iter::once(through.span()).chain(spans).collect();
            let (point, directions) = (vector(through)?, list(directions.get_ref())?);
            (Shape::AffineSubspace { point, directions }, places)
        }
        SetFile::Union(sets) => {
            let sets_of = |set| pieces(set, numbers, dimension);
            let all: Vec<Vec<Piece>> =
                sets.get_ref().iter().map(sets_of).collect::<Result<_, _>>()?;
            if all.is_empty() {
                return Err(Diagnostic::new("a union of no sets", sets.span()));
            }
            return Ok(all.into_iter().flatten().collect());
        }
    };
    Ok(vec![Piece { shape, places }])
}

fn corners(
    Corners { lower, upper }: &Corners,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<[Vec<f64>; 2], Diagnostic> {
    Ok([numbers.vector(lower, dimension)?, numbers.vector(upper, dimension)?])
}

/// Returns the corners of the box in which samples are drawn.
fn sampled(
    region: &Corners,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<[Vec<f64>; 2], Diagnostic> {
    let [lower, upper] = corners(region, numbers, dimension)?;
    if lower.iter().zip(&upper).all(|(low, high)| high - low > 0.0 && (high - low).is_finite()) {
        return Ok([lower, upper]);
    }
    Err(Diagnostic::new("an empty region", region.upper.span())
        .label("expected larger coordinates than those of lower"))
}

/// The numbers of the section `[solve]`.
struct Solve {
    grid: Grid,
    starts: Vec<Vec<Vec<f64>>>,
    steps: Option<usize>,
    time_limit: Option<Duration>,
}

impl Solve {
    fn new(solve: &SolveFile, numbers: &Numbers<'_>, dimension: usize) -> Result<Self, Diagnostic> {
        let grid = match (&solve.n, &solve.tolerance) {
            (Some(_), Some(tolerance)) => {
                return Err(Diagnostic::new("a tolerance besides n", tolerance.span())
                    .label("expected n or tolerance, not both"));
            }
            (Some(n), None) => Grid::Chords(chords(n)?),
            (None, Some(text)) => Grid::Tolerance(numbers.between(text, 0.0, 1.0)?),
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
        let steps = solve.steps.as_ref().map(|steps| *steps.get_ref());
        Ok(Self { grid, starts, steps, time_limit })
    }
}

fn chords(n: &Placed<usize>) -> Result<usize, Diagnostic> {
    match *n.get_ref() {
        0 => Err(Diagnostic::new("no chord", n.span()).label("expected n of at least 1")),
        n => Ok(n),
    }
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

fn region(
    certify: &CertifyFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Option<Piece>, Diagnostic> {
    let Some(within) = &certify.within else { return Ok(None) };
    match within.get_ref() {
        set @ (SetFile::Ball(_) | SetFile::Box(_)) => {
            Ok(pieces(set, numbers, dimension)?.into_iter().next())
        }
        _ => Err(Diagnostic::new("constants are proved in a ball or in a box", within.span())
            .label("expected ball or box")),
    }
}

fn view(
    problem: &ProblemFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<View, Diagnostic> {
    let output = &problem.output;
    let coordinates = match &output.coordinates {
        None => None,
        Some(chosen) => {
            let [a, b] = *chosen.get_ref();
            let all = 1..=dimension;
            if !all.contains(&a) || !all.contains(&b) || (a == b && dimension > 1) {
                let label = format!("expected two of the coordinates 1 to {dimension}");
                return Err(Diagnostic::new("no such plane", chosen.span()).label(label));
            }
            Some([a - 1, b - 1])
        }
    };
    let field = match output.field {
        FieldFile::Determinant => Field::Determinant,
        FieldFile::Ellipses => Field::Ellipses,
        FieldFile::Plain => Field::Plain,
    };
    let window = match &output.window {
        None => None,
        Some(window) => {
            let [lower, upper] = corners(window, numbers, 2)?;
            if !(lower[0] < upper[0] && lower[1] < upper[1]) {
                return Err(Diagnostic::new("an empty window", window.upper.span())
                    .label("expected larger coordinates than those of lower"));
            }
            Some([[lower[0], upper[0]], [lower[1], upper[1]]])
        }
    };
    Ok(View { coordinates, field, window })
}
