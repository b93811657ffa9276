//! `Given`: a metric whose dimension is known when the program runs.

use std::{fmt::Debug, sync::Arc};

use tautline::{
    BlackBox, Ends, Formula, Lattice, LeftEndpoint, Options, Prepared, Problem, SolveError, Table,
    TautLine, Trapezoidal, TrueTrapezoid, Values, certify::Watch, solve_all,
};
use tautline_portrait::Shape;

use super::{
    Curve, GivenError, Nodes, Proofs, Region, Request,
    avoiding::avoiding,
    curve::NamedRule,
    known::Known,
    sets::{check_coordinates, point, set},
};
use crate::{
    ConstantsAnswer,
    dimension::{InDimension, in_dimension},
    file::request::RuleName,
    reading::shape::vector,
};

/// A metric on `R^d`, where `d` is known when the program runs. Its programs are derived once, and
/// its clones share them.
#[derive(Clone, Debug)]
pub struct Given {
    metric: Arc<dyn AnyDimension>,
}

/// A curve, or why there is none.
pub type Found = Result<Arc<dyn Curve>, GivenError>;

impl Given {
    /// Parses a metric, given values for named parameters, and tables that it may call by their names:
    /// the texts of [`Formula::parse_with`](tautline::Formula::parse_with).
    ///
    /// # Errors
    ///
    /// [`GivenError::Dimension`], or [`GivenError::Text`] with the offending bytes.
    pub fn parse(
        text: &str,
        dimension: usize,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
    ) -> Result<Self, GivenError> {
        let parse = Parse { text, parameters, tables };
        in_dimension(dimension, parse).unwrap_or(Err(GivenError::Dimension { dimension }))
    }

    /// Takes a metric that is known by its values only. Derivatives that it does not give are computed
    /// from differences with this [step](tautline::BlackBox::new), in `ℓ`. Its curves have no certificates.
    ///
    /// # Errors
    ///
    /// [`GivenError::Dimension`]; [`GivenError::Step`] if the step is not positive and finite.
    pub fn black_box(
        values: Arc<dyn Values>,
        dimension: usize,
        step: f64,
    ) -> Result<Self, GivenError> {
        let task = InBlackBox { values, step };
        in_dimension(dimension, task).unwrap_or(Err(GivenError::Dimension { dimension }))
    }

    /// Takes a metric in its dimension.
    pub(super) fn held<M: Known<D>, const D: usize>(metric: Held<M, D>) -> Self {
        Self { metric: Arc::new(metric) }
    }

    /// Returns the metric with obstacles: with the distances `δₖ(x)` from the regions and the margin `m`,
    /// in `ℓ`, it is `(1 + Σₖ (m/δₖ(x))²) H(x)`, and undefined in the regions. No curve enters them; it runs
    /// the closer to them, the smaller the margin is.
    ///
    /// # Errors
    ///
    /// [`GivenError::Margin`], [`GivenError::NoInside`], [`GivenError::Coordinates`],
    /// [`GivenError::Text`]; [`GivenError::NoFormula`] for a black box.
    pub fn avoiding(&self, regions: &[Region], margin: f64) -> Result<Self, GivenError> {
        self.metric.avoiding(regions, margin)
    }

    /// Returns the dimension.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.metric.dimension()
    }

    /// Returns the steps of the formula, one on each line, which [`parse`](Given::parse) reads. Two
    /// metrics are the same program if these texts are equal. A black box has none.
    #[must_use]
    pub fn text(&self) -> Option<String> {
        self.metric.text()
    }

    /// Returns the tables that the text calls `table1`, `table2`, ….
    #[must_use]
    pub fn tables(&self) -> &[Arc<dyn Table>] {
        self.metric.tables()
    }

    /// Returns `H(x)`, column by column.
    ///
    /// # Errors
    ///
    /// [`GivenError::Coordinates`].
    pub fn gram(&self, x: &[f64]) -> Result<Vec<f64>, GivenError> {
        let (found, dimension) = (x.len(), self.dimension());
        if found != dimension {
            return Err(GivenError::Coordinates { what: "a point", found, dimension });
        }
        Ok(self.metric.gram(x))
    }

    /// Returns whether interval arithmetic shows that the first entry of `H` is positive everywhere. It
    /// may be so where this is `false`.
    #[must_use]
    pub fn is_positive_everywhere(&self) -> bool {
        self.metric.is_positive_everywhere()
    }

    /// Proves the constants of the metric from its formula, in a ball or a box, or on all of space if
    /// the formula shows what happens far out. `watch` is told of the progress, and may end the search
    /// for a constant; the bounds found so far are then the answer.
    ///
    /// # Errors
    ///
    /// [`GivenError::Constants`], [`GivenError::Coordinates`]. A constant that is not proved is no
    /// error: it has its reason.
    pub fn constants(
        &self,
        within: Option<&Shape>,
        proofs: &Proofs,
        watch: &dyn Watch,
    ) -> Result<ConstantsAnswer, GivenError> {
        self.metric.constants(within, proofs, watch)
    }

    /// Returns a curve between two sets, each the union of its pieces.
    ///
    /// # Errors
    ///
    /// [`GivenError`].
    pub fn solve(&self, ends: [&[Shape]; 2], request: &Request) -> Found {
        self.metric.solve(ends, request)
    }

    /// Solves many problems on all threads, and returns the curves in order, bit for bit those of
    /// [`solve`](Given::solve). An error in one of them does not affect the others.
    #[must_use]
    pub fn solve_all(&self, ends: &[[&[Shape]; 2]], request: &Request) -> Vec<Found> {
        self.metric.solve_all(ends, request)
    }
}

struct Parse<'t> {
    text: &'t str,
    parameters: &'t [(&'t str, f64)],
    tables: &'t [(&'t str, Arc<dyn Table>)],
}

impl InDimension for Parse<'_> {
    type Output = Result<Given, GivenError>;

    fn run<const D: usize>(self) -> Self::Output {
        let formula = Formula::<D>::parse_with(self.text, self.parameters, self.tables)?;
        Ok(Given { metric: Arc::new(Held(Arc::new(Prepared::new(formula)))) })
    }
}

struct InBlackBox {
    values: Arc<dyn Values>,
    step: f64,
}

impl InDimension for InBlackBox {
    type Output = Result<Given, GivenError>;

    fn run<const D: usize>(self) -> Self::Output {
        let Self { values, step } = self;
        let metric = BlackBox::<D>::new(values, step).ok_or(GivenError::Step { step })?;
        let prepared = Prepared::of_black_box(metric.clone(), metric);
        Ok(Given { metric: Arc::new(Held(Arc::new(prepared))) })
    }
}

/// What can be done with a metric without knowing its dimension.
trait AnyDimension: Debug + Send + Sync {
    fn dimension(&self) -> usize;
    fn text(&self) -> Option<String>;
    fn tables(&self) -> &[Arc<dyn Table>];
    fn gram(&self, x: &[f64]) -> Vec<f64>;
    fn is_positive_everywhere(&self) -> bool;
    fn avoiding(&self, regions: &[Region], margin: f64) -> Result<Given, GivenError>;
    fn constants(
        &self,
        within: Option<&Shape>,
        proofs: &Proofs,
        watch: &dyn Watch,
    ) -> Result<ConstantsAnswer, GivenError>;
    fn solve(&self, ends: [&[Shape]; 2], request: &Request) -> Found;
    fn solve_all(&self, ends: &[[&[Shape]; 2]], request: &Request) -> Vec<Found>;
}

/// A metric in `D` dimensions.
#[derive(Debug)]
pub(super) struct Held<M, const D: usize>(pub(super) Arc<Prepared<M, D>>);

impl<M: Known<D>, const D: usize> Held<M, D> {
    fn problem(&self, pieces: [&[Shape]; 2]) -> Result<Problem<M, D>, GivenError> {
        let ends = match pieces {
            // Of two points more is proved.
            [[Shape::Point(a)], [Shape::Point(b)]] => Ends::points(point::<D>(a)?, point::<D>(b)?)?,
            [from, to] => Ends::new(set("first", from)?, set("second", to)?)?,
        };
        Ok(Problem::with_prepared(Arc::clone(&self.0), ends))
    }

    fn by<R: NamedRule>(
        problem: &Problem<M, D>,
        rule: R,
        n: usize,
        options: &Options<D>,
        lattice: Option<&Lattice<D>>,
    ) -> Found {
        held(match lattice {
            Some(lattice) => problem.solve_on_lattice(rule, n, lattice, options),
            None => problem.solve_with(rule, n, options),
        })
    }

    fn all_by<R: NamedRule>(
        problems: Vec<Result<Problem<M, D>, GivenError>>,
        rule: R,
        n: usize,
        options: &Options<D>,
    ) -> Vec<Found> {
        let posed: Vec<_> = problems.iter().filter_map(|problem| problem.as_ref().ok()).collect();
        let posed: Vec<Problem<M, D>> = posed.into_iter().cloned().collect();
        let mut solved = solve_all(&posed, rule, n, options).into_iter();
        let next = |problem: Result<_, _>| {
            problem.and_then(|_| held(solved.next().unwrap_or(Err(SolveError::NoStart))))
        };
        problems.into_iter().map(next).collect()
    }
}

fn held<M: Known<D>, R: NamedRule, const D: usize>(
    line: Result<TautLine<M, R, D>, SolveError>,
) -> Found {
    Ok(Arc::new(line?))
}

impl<M: Known<D>, const D: usize> AnyDimension for Held<M, D> {
    fn dimension(&self) -> usize {
        D
    }

    fn text(&self) -> Option<String> {
        self.0.metric().text()
    }

    fn tables(&self) -> &[Arc<dyn Table>] {
        self.0.metric().tables()
    }

    fn gram(&self, x: &[f64]) -> Vec<f64> {
        self.0.metric().gram(&vector::<D>(x)).as_slice().to_vec()
    }

    fn is_positive_everywhere(&self) -> bool {
        self.0.metric().is_positive_everywhere()
    }

    fn avoiding(&self, regions: &[Region], margin: f64) -> Result<Given, GivenError> {
        let formula = self.0.metric().formula().ok_or(GivenError::NoFormula)?;
        avoiding(formula, regions, margin)
    }

    fn constants(
        &self,
        within: Option<&Shape>,
        proofs: &Proofs,
        watch: &dyn Watch,
    ) -> Result<ConstantsAnswer, GivenError> {
        if let Some(shape) = within {
            check_coordinates::<D>(shape)?;
        }
        self.0.metric().constants(within, proofs.accuracy(D), watch)
    }

    fn solve(&self, ends: [&[Shape]; 2], request: &Request) -> Found {
        let (problem, options, n) = (self.problem(ends)?, request.options::<D>()?, request.n);
        let lattice = request.lattice.as_ref().map(Nodes::lattice::<D>).transpose()?;
        let lattice = lattice.as_ref();
        match request.rule {
            RuleName::Trapezoidal => Self::by(&problem, Trapezoidal, n, &options, lattice),
            RuleName::LeftEndpoint => Self::by(&problem, LeftEndpoint, n, &options, lattice),
            RuleName::TrueTrapezoid => Self::by(&problem, TrueTrapezoid, n, &options, lattice),
        }
    }

    fn solve_all(&self, ends: &[[&[Shape]; 2]], request: &Request) -> Vec<Found> {
        if request.lattice.is_some() {
            return ends.iter().map(|&ends| self.solve(ends, request)).collect();
        }
        let n = request.n;
        let options = match request.options::<D>() {
            Ok(options) => options,
            Err(error) => return vec![Err(error); ends.len()],
        };
        let problems = ends.iter().map(|&ends| self.problem(ends)).collect();
        match request.rule {
            RuleName::Trapezoidal => Self::all_by(problems, Trapezoidal, n, &options),
            RuleName::LeftEndpoint => Self::all_by(problems, LeftEndpoint, n, &options),
            RuleName::TrueTrapezoid => Self::all_by(problems, TrueTrapezoid, n, &options),
        }
    }
}
