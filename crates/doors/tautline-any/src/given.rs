//! `Given`: a metric whose dimension is known when the program runs.

use core::ops::ControlFlow::{Break, Continue};
use std::sync::{
    Arc,
    atomic::{AtomicBool, Ordering},
};

use tautline::{
    ANY, AnyBatches, AnySet, BlackBox, Formula, Known, Problem, Request, RequestError, SolveError,
    Table, Values, answer_all, certify::Watch, check_periods, translates,
};

use crate::{
    ConstantsAnswer, ConstantsError, Curve, GivenError, LARGEST_DIMENSION, Least, Proofs, Region,
    Shape, constants::constants, ends::ends, least_entry::least_entry, region::avoiding,
};

/// A metric on `R^d`, where `d` is known when the program runs. Its programs are derived once, and
/// its clones share them.
#[derive(Clone, Debug)]
pub struct Given {
    metric: Arc<Known>,
}

/// A curve, or why there is none.
pub type Found = Result<Arc<Curve>, GivenError>;

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
        check_dimension(dimension)?;
        Ok(Formula::parse_in(dimension, text, parameters, tables)?.into())
    }

    /// Takes a metric that is known by its values only. Derivatives that it does not give are computed
    /// from differences with this [step](tautline::BlackBox::new), in `ℓ`. Its curves have no certificates.
    ///
    /// # Errors
    ///
    /// [`GivenError::Dimension`] and [`GivenError::BlackBoxDimension`]; [`GivenError::Step`] if the step is not
    /// positive and finite.
    pub fn black_box(
        values: Arc<dyn Values>,
        dimension: usize,
        step: f64,
    ) -> Result<Self, GivenError> {
        check_dimension(dimension)?;
        if dimension > BlackBox::<ANY>::LARGEST_DIMENSION && !values.is_along() {
            return Err(GivenError::BlackBoxDimension { dimension });
        }
        let metric = BlackBox::new_in(dimension, values, step).ok_or(GivenError::Step { step })?;
        Ok(Self { metric: Arc::new(metric.into()) })
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
        Ok(avoiding(self.formula()?, regions, margin)?.into())
    }

    pub(crate) fn formula(&self) -> Result<&Formula<ANY>, GivenError> {
        self.metric.formula().map_err(|_| GivenError::NoFormula)
    }

    /// Returns the metric, undefined where one of some functions is not positive; see
    /// [`Formula::where_positive`](tautline::Formula::where_positive). `None` for a black box, and if the
    /// formula becomes too long.
    #[must_use]
    pub fn where_positive(&self, functions: &[&Given]) -> Option<Self> {
        let function = |given: &&Given| given.metric.formula().ok().cloned();
        let functions: Vec<_> = functions.iter().map(function).collect::<Option<_>>()?;
        let formula = self.metric.formula().ok()?.where_positive(&functions).ok()?;
        Some(formula.into())
    }

    /// Returns the pieces of the second set with those of their translates by multiples of the periods that
    /// come near to the first one; see [`translates`]. A period is that of a coordinate, in `ℓ`; 0 for none.
    ///
    /// # Errors
    ///
    /// [`GivenError::Set`] if a period is negative or not finite; [`GivenError::NotPeriodic`] if the metric
    /// does not have the period.
    pub fn periodic(
        &self,
        [from, to]: [&[Shape]; 2],
        periods: &[f64],
    ) -> Result<Vec<Shape>, GivenError> {
        let (found, dimension) = (periods.len(), self.dimension());
        if found != dimension {
            return Err(GivenError::Coordinates { what: "the period", found, dimension });
        }
        from.iter().chain(to).try_for_each(|shape| check_coordinates(shape, dimension))?;
        let [from, to] = [Shape::union(from.to_vec())?, Shape::union(to.to_vec())?];
        let translates = translates(&to, &from, periods)?;
        let [mut a, mut b] = [vec![0.0; dimension], vec![0.0; dimension]];
        from.project(&mut a);
        to.project(&mut b);
        check_periods(&self.metric, periods, [&a, &b])?;
        Ok(translates)
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
        self.metric.formula().ok().map(ToString::to_string)
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

    /// Returns the least value of the first entry of `H` at the points of a curve and in the middles of
    /// its chords, and where it is.
    ///
    /// # Errors
    ///
    /// [`GivenError::Coordinates`].
    pub fn least_entry_along(&self, curve: &Curve) -> Result<Option<Least>, GivenError> {
        let (found, dimension) = (curve.dimension(), self.dimension());
        if found != dimension {
            return Err(GivenError::Coordinates { what: "a curve", found, dimension });
        }
        Ok(least_entry(&*self.metric, curve.sequence()))
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
        if let Some(shape) = within {
            check_coordinates(shape, self.dimension())?;
        }
        let formula = self.metric.formula().map_err(ConstantsError::NotRecorded)?;
        Ok(constants(formula, within, proofs.accuracy(self.dimension()), watch)?)
    }

    /// Returns a curve between two sets, each the union of its pieces.
    ///
    /// # Errors
    ///
    /// [`GivenError`].
    pub fn solve(&self, ends: [&[Shape]; 2], request: &Request) -> Found {
        Ok(Arc::new(self.problem(ends)?.answer(request)?.into()))
    }

    /// Does the same, until the flag is true: then the result is the curve on the last grid that is known, or
    /// [`SolveError::Interrupted`].
    ///
    /// # Errors
    ///
    /// [`GivenError`].
    pub fn solve_until(
        &self,
        ended: &Arc<AtomicBool>,
        ends: [&[Shape]; 2],
        request: &Request,
    ) -> Found {
        let go_on = || if ended.load(Ordering::Relaxed) { Break(()) } else { Continue(()) };
        let problem = self.problem(ends)?.ended_by(Arc::clone(ended));
        let line = problem.answer_watched(request, &mut |_| go_on())?;
        Ok(Arc::new(line.into()))
    }

    /// Solves many problems on all threads, and returns the curves in order, bit for bit those of
    /// [`solve`](Given::solve). An error in one of them does not affect the others.
    #[must_use]
    pub fn solve_all(&self, ends: &[[&[Shape]; 2]], request: &Request) -> Vec<Found> {
        let problems: Vec<_> = ends.iter().map(|&ends| self.problem(ends)).collect();
        let posed: Vec<_> =
            problems.iter().filter_map(|problem| problem.as_ref().ok().cloned()).collect();
        let mut solved = answer_all(&posed, request).into_iter();
        let next = |problem: Result<_, _>| {
            problem.and_then(|_| {
                let line = solved.next().unwrap_or(Err(SolveError::NoStart.into()));
                Ok(Arc::new(Curve::from(line?)))
            })
        };
        problems.into_iter().map(next).collect()
    }

    fn problem(&self, [from, to]: [&[Shape]; 2]) -> Result<Problem<Known, ANY>, GivenError> {
        for (end, pieces) in [("first", from), ("second", to)] {
            if pieces.is_empty() {
                return Err(GivenError::NoPieces { end });
            }
            pieces.iter().try_for_each(|shape| check_coordinates(shape, self.dimension()))?;
        }
        let ends = ends(from.to_vec(), to.to_vec())?;
        let problem = Problem::with_known(Arc::clone(&self.metric), ends);
        Ok(problem.map_err(RequestError::Solve)?)
    }
}

impl From<Formula<ANY>> for Given {
    fn from(formula: Formula<ANY>) -> Self {
        Self { metric: Arc::new(formula.into()) }
    }
}

/// Refuses dimensions in which there are no metrics.
fn check_dimension(dimension: usize) -> Result<(), GivenError> {
    let is_possible = (1..=LARGEST_DIMENSION).contains(&dimension);
    if is_possible { Ok(()) } else { Err(GivenError::Dimension { dimension }) }
}

/// Refuses a shape with another number of coordinates.
pub(super) fn check_coordinates(shape: &Shape, dimension: usize) -> Result<(), GivenError> {
    let found = shape.dimension();
    let other = GivenError::Coordinates { what: shape.name(), found, dimension };
    if found == dimension { Ok(()) } else { Err(other) }
}
