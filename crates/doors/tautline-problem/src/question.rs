//! `Question`: a problem file that was read and evaluated, but for its formula.

// The type alone: from `core`, which has no clock.
use core::time::Duration;
use std::sync::Arc;

use tautline::{ANY, Constants, Formula, Rule, certify::Accuracy};
use tautline_any::{ACCURACY, Grid, LARGEST_DIMENSION, Nodes, Proving, Request, default_boxes};

use crate::{
    Diagnostic,
    file::{ProblemFile, placed::Placed, request::ConstantsFile, set::SetFile},
    formula::formula,
    reading::{
        numbers::{Numbers, counted},
        parse::parse,
        period::{periods, with_translates},
        pieces::{pieces, region, sampled},
        shape::Piece,
        solve::{Solve, check_grid},
        tables::{Open, Tables, no_file, tables},
        view::{View, view},
    },
};

/// A problem file that was read and evaluated, but for its formula.
#[derive(Clone, Debug)]
pub struct Question {
    /// The text of the file.
    pub(crate) file: Arc<str>,
    pub(crate) problem: Arc<ProblemFile>,
    pub(crate) dimension: usize,
    pub(crate) parameters: Vec<(String, f64)>,
    pub(crate) tables: Tables,
    /// The pieces of the two sets, if the file has them; those of the second with their translates.
    pub(crate) ends: Option<[Vec<Piece>; 2]>,
    /// The period of each coordinate, with its place; 0 if it has none.
    pub(crate) periods: Option<Placed<Vec<f64>>>,
    pub(crate) rule: Rule,
    pub(crate) grid: Grid,
    /// The grid that [`set_grid`](Question::set_grid) asked for. It replaces the grid of the file.
    pub(crate) asked_grid: Option<Grid>,
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
        let mut ends = match (&problem.from, &problem.to) {
            (Some(from), Some(to)) => Some([
                pieces(from.get_ref(), &numbers, dimension)?,
                pieces(to.get_ref(), &numbers, dimension)?,
            ]),
            (None, None) => None,
            (Some(one), None) => return Err(lonely(one, "to")),
            (None, Some(one)) => return Err(lonely(one, "from")),
        };
        let periods = problem.period.as_ref().map(|period| periods(period, &numbers, dimension));
        let periods = periods.transpose()?;
        if let (Some(periods), Some(_)) = (&periods, &problem.obstacles) {
            return Err(Diagnostic::new("a period besides [obstacles]", periods.span())
                .help("the regions have no translates; write a cost that is high in them, and has the period"));
        }
        if let (Some(periods), Some(ends)) = (&periods, &mut ends) {
            ends[1] = with_translates(ends, periods)?;
        }
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
            periods,
            rule,
            grid,
            asked_grid: None,
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
        let known = || counted(self.dimension, "coordinate");
        let other = || {
            let message = format!("the metric has {}, not {D}", known());
            Diagnostic::new(message, self.problem.metric.span())
        };
        if D != self.dimension {
            return Err(other());
        }
        self.any_formula()?.into_dimension().ok_or_else(other)
    }

    /// Returns the formula of the metric, in a dimension that is a value.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] with the place in the file, if an expression is wrong.
    pub fn any_formula(&self) -> Result<Formula<ANY>, Diagnostic> {
        formula(&self.problem, &self.numbers(), &self.tables, self.dimension)
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

    /// Replaces the number of chords or the tolerance, also for other values of parameters.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] with the place of the lattice, if the file has one and this is a tolerance: a search
    /// along a lattice has one grid.
    pub fn set_grid(&mut self, grid: Grid) -> Result<(), Diagnostic> {
        check_grid(grid, self.lattice.as_ref().map(Placed::span))?;
        self.grid = grid;
        self.asked_grid = Some(grid);
        Ok(())
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

    /// Returns what bounds rest on.
    pub(crate) fn proving(&self) -> Proving {
        let is_in_a_region = self.within.is_some();
        Proving { claimed: self.claimed, is_in_a_region, accuracy: self.accuracy() }
    }

    /// Returns how closely constants are proved, and at what cost.
    pub(crate) fn accuracy(&self) -> Accuracy {
        Accuracy { tolerance: self.accuracy, budget: self.boxes }
    }

    /// Returns how the problem is to be solved.
    pub(crate) fn request(&self) -> Request {
        let default = Request::default();
        Request {
            rule: self.rule,
            grid: self.grid,
            starts: self.starts.clone(),
            only_these_starts: self.only_these_starts,
            scope: self.problem.solve.scope,
            lattice: self.lattice.as_ref().map(|nodes| nodes.get_ref().clone()),
            steps: self.steps.unwrap_or(default.steps),
            ..default
        }
    }

    pub(crate) fn numbers(&self) -> Numbers<'_> {
        Numbers::evaluated(&self.file, self.parameters.clone())
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

#[cfg(test)]
mod tests {
    use tautline::{
        ANY, AffineSubspace, AxisBox, Ball, FiniteSet, HalfSpace, Point, Scope, Segment, Shape,
        Sphere,
    };
    use tautline_picture::portrait::Field;

    use tautline_any::{Grid, default_boxes};

    use super::Question;
    use crate::reading::view::View;

    fn question(lines: &str) -> Question {
        let file = format!("dimension = 2\n[metric]\nphi = 1\n{lines}");
        Question::read(&file).unwrap_or_else(|error| panic!("{file}: {error}"))
    }

    /// A fifth for each dimension beyond the plane, as [`Proofs`](tautline_any::Proofs) says.
    #[test]
    fn a_constant_has_fewer_boxes_in_more_dimensions() {
        let boxes = [1, 2, 3, 4, 5, 6, 12].map(default_boxes);
        assert_eq!(boxes, [100_000, 100_000, 20_000, 4000, 800, 160, 160]);
        let accuracy = question("").accuracy();
        assert_eq!((accuracy.budget, accuracy.tolerance), (100_000, 1e-3));
        let accuracy = question("[certify]\nboxes = 77\ntolerance = \"1/8\"\n").accuracy();
        assert_eq!((accuracy.budget, accuracy.tolerance), (77, 0.125));
    }

    #[test]
    fn each_claimed_constant_is_the_one_of_its_name() {
        let claimed = |m_h: &str| {
            let lines = format!("[certify]\nconstants = {{ c1 = 1, c2 = 9, l_h = 5{m_h} }}\n");
            question(&lines).claimed_constants().expect("constants")
        };
        let found = claimed(", m_h = 7");
        assert_eq!((found.c1(), found.c2(), found.l_h(), found.m_h()), (1.0, 9.0, 5.0, Some(7.0)));
        assert_eq!((claimed("").m_h(), question("").claimed_constants()), (None, None));
        assert!(!found.is_isotropic() && !found.is_local());
    }

    /// In a file coordinates are counted from 1, and a window has its corners.
    #[test]
    fn what_is_drawn_is_what_the_file_says() {
        let file = "dimension = 3\n[metric]\nphi = 1\n[output]\ncoordinates = [3, 1]\n\
                    field = \"ellipses\"\nwindow = { lower = [-1, 2], upper = [5, 3] }\n";
        let view = Question::read(file).expect("a file").view;
        let window = Some([[-1.0, 5.0], [2.0, 3.0]]);
        assert_eq!(view, View { coordinates: Some([2, 0]), field: Field::Ellipses, window });
    }

    #[test]
    fn the_numbers_of_the_sections_are_read_as_they_stand() {
        let found = question(
            "[solve]\nn = 33\nsteps = 4\nscope = \"local\"\ntime_limit = 1.5\nonly_these_starts = true\n\
             starts = [[[0, 1], [2, 3]], [[4, 5], [6, 7], [8, 9]]]\n[audit]\ncases = 12\nseed = 34\n\
             region = { lower = [-1, -2], upper = [3, 4] }\n[certify]\nbound = false\n",
        );
        assert_eq!((found.grid, found.steps, found.bound), (Grid::Chords(33), Some(4), false));
        assert_eq!(found.time_limit().map(|limit| limit.as_millis()), Some(1500));
        assert_eq!(found.starts[0], [[0.0, 1.0], [2.0, 3.0]]);
        assert_eq!(found.starts[1], [[4.0, 5.0], [6.0, 7.0], [8.0, 9.0]]);
        assert!(found.only_these_starts);
        assert_eq!(found.request().scope, Scope::Local);
        assert_eq!((found.audit_cases(), found.audit_seed()), (Some(12), Some(34)));
        assert_eq!(found.audit_region(), Some(&[vec![-1.0, -2.0], vec![3.0, 4.0]]));
        let tolerance = question("[solve]\ntolerance = 1e-6\n");
        assert_eq!((tolerance.grid, tolerance.bound), (Grid::Tolerance(1e-6), true));
    }

    /// Each set is the shape of its name, on its own side, and unions of unions are flat.
    #[test]
    fn each_set_is_its_shape() {
        let found = question(
            "[from]\npoint = [7, 8]\n[to]\nunion = [\
             { points = [[3, 4], [5, 6]] }, \
             { ball = { centre = [1, 0], radius = 2 } }, \
             { union = [{ sphere = { centre = [0, 1], radius = 3 } }, \
             { box = { lower = [0, 1], upper = [2, 3] } }] }, \
             { half_space = { normal = [1, -2], at_least = 3 } }, \
             { half_space = { normal = [1, -2], at_most = 3 } }, \
             { segment = { from = [0, 1], to = [2, 3] } }, \
             { affine = { through = [1, 1], directions = [[0, 2]] } }]\n",
        );
        let [from, to] = found.ends.expect("two sets");
        let shapes = |pieces: Vec<crate::reading::shape::Piece>| -> Vec<Shape<ANY>> {
            pieces.into_iter().map(|piece| piece.shape).collect()
        };
        let point = Point::from_slice(&[7.0, 8.0]).expect("finite");
        assert_eq!(shapes(from), [Shape::Point(point)]);
        let expected = [
            FiniteSet::from_slices([[3.0, 4.0], [5.0, 6.0]]).map(Shape::FiniteSet),
            Ball::from_slice(&[1.0, 0.0], 2.0).map(Shape::Ball),
            Sphere::from_slice(&[0.0, 1.0], 3.0).map(Shape::Sphere),
            AxisBox::from_slices(&[0.0, 1.0], &[2.0, 3.0]).map(Shape::AxisBox),
            HalfSpace::from_slice(&[-1.0, 2.0], -3.0).map(Shape::HalfSpace),
            HalfSpace::from_slice(&[1.0, -2.0], 3.0).map(Shape::HalfSpace),
            Segment::from_slices(&[0.0, 1.0], &[2.0, 3.0]).map(Shape::Segment),
            AffineSubspace::from_slices(&[1.0, 1.0], [[0.0, 2.0]]).map(Shape::AffineSubspace),
        ]
        .map(|shape| shape.expect("a set"));
        assert_eq!(shapes(to), expected);
    }
}
