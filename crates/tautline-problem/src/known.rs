//! `Known`: a metric by its formula or by its values.

use std::sync::Arc;

use tautline::{
    BlackBox, Formula, Interval, Metric, Prepared, RecordError, SMatrix, SVector, Scalar, Table,
};

/// A metric by its formula, or by its values. One type for both, so that a search is compiled once.
#[derive(Clone, Debug)]
pub(crate) enum Known<const D: usize> {
    /// By its formula.
    Formula(Formula<D>),
    /// By its values, of which nothing is proved.
    BlackBox(BlackBox<D>),
}

impl<const D: usize> Metric<D> for Known<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        match self {
            Self::Formula(formula) => formula.gram(x),
            Self::BlackBox(values) => values.gram(x),
        }
    }
}

impl<const D: usize> Known<D> {
    /// Derives programs from the formula, or takes the values of a black box.
    pub(crate) fn prepared(self) -> Prepared<Self, D> {
        match self {
            Self::Formula(_) => Prepared::new(self),
            Self::BlackBox(ref values) => {
                let values = values.clone();
                Prepared::of_black_box(self, values)
            }
        }
    }

    /// Returns the formula.
    ///
    /// # Errors
    ///
    /// [`RecordError::BlackBox`] if there is none.
    pub(crate) fn formula(&self) -> Result<&Formula<D>, RecordError> {
        match self {
            Self::Formula(formula) => Ok(formula),
            Self::BlackBox(_) => Err(RecordError::BlackBox),
        }
    }

    /// Returns whether interval arithmetic shows that the first entry of `H` is positive everywhere.
    pub(crate) fn is_positive_everywhere(&self) -> bool {
        // An undefined entry has no positive bound.
        let first = |formula: &Formula<D>| formula.gram(&SVector::from_element(Interval::REALS));
        self.formula().is_ok_and(|formula| first(formula)[(0, 0)].lo() > 0.0)
    }

    /// Returns the tables that the text calls, in the order of their numbers.
    pub(crate) fn tables(&self) -> &[Arc<dyn Table>] {
        self.formula().map_or(&[], Formula::tables)
    }
}
