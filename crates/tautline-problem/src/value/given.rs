//! `Given`: a metric whose dimension is known when the program runs.

use std::sync::Arc;

use tautline::{BlackBox, Formula, Table, Values, certify::Watch};

use super::{
    Curve, GivenError, Proofs, Region, Request, Shape,
    held::{AnyDimension, Held},
};
use crate::{
    ConstantsAnswer,
    dimension::{InDimension, in_dimension},
    known::Known,
};

/// A metric on `R^d`, where `d` is known when the program runs. Its programs are derived once, and
/// its clones share them.
#[derive(Clone, Debug)]
pub struct Given {
    metric: Arc<dyn AnyDimension>,
}

/// A curve, or why there is none.
pub type Found = Result<Arc<dyn Curve>, GivenError>;

/// A value, and the point where it is.
pub type Least = (f64, Vec<f64>);

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
    pub(super) fn held<const D: usize>(metric: Known<D>) -> Self {
        Self { metric: Arc::new(Held(Arc::new(metric.prepared()))) }
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

    /// Returns the least value of the first entry of `H` at the points of a curve and in the middles of
    /// its chords, and where it is.
    ///
    /// # Errors
    ///
    /// [`GivenError::Coordinates`].
    pub fn least_entry_along(&self, curve: &dyn Curve) -> Result<Option<Least>, GivenError> {
        let (found, dimension) = (curve.dimension(), self.dimension());
        if found != dimension {
            return Err(GivenError::Coordinates { what: "a curve", found, dimension });
        }
        self.metric.least_entry_along(&curve.points())
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
        self.solve_while(ends, request, &|| true)
    }

    /// Does the same. With a tolerance, it goes on to a finer grid only while `goes_on` says so, and returns
    /// the curve on the last grid otherwise.
    ///
    /// # Errors
    ///
    /// [`GivenError`].
    pub fn solve_while(
        &self,
        ends: [&[Shape]; 2],
        request: &Request,
        goes_on: &dyn Fn() -> bool,
    ) -> Found {
        self.metric.solve(ends, request, goes_on)
    }

    /// Solves many problems on all threads, or one after the other with a tolerance or a lattice, and
    /// returns the curves in order, bit for bit those of [`solve`](Given::solve). An error in one of them does not affect the others.
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
        Ok(Given::held(Known::Formula(formula)))
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
        Ok(Given::held(Known::BlackBox(metric)))
    }
}
