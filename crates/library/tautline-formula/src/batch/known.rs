//! `Known`: a metric in a dimension that is a value, by its formula or by its values.

use std::sync::Arc;

use tautline_scalar::{ANY, Interval, Table};

use crate::{
    BlackBox, BlackBoxBatches, Formula, RecordError,
    batch::{AnyBatches, Kind, Layout, PreparedFormula},
    program::{InstructionSet, Registers},
};

/// A metric in a dimension that is a value, by its formula or by its values, ready to be evaluated at
/// many points at once.
#[derive(Debug)]
pub enum Known {
    /// By its formula.
    Formula(PreparedFormula),
    /// By its values, of which nothing is proved.
    BlackBox(BlackBoxBatches),
}

impl From<Formula<ANY>> for Known {
    fn from(formula: Formula<ANY>) -> Self {
        Self::Formula(PreparedFormula::new(formula))
    }
}

impl From<BlackBox<ANY>> for Known {
    fn from(values: BlackBox<ANY>) -> Self {
        Self::BlackBox(BlackBoxBatches::new(values))
    }
}

impl Known {
    /// Returns the formula.
    ///
    /// # Errors
    ///
    /// [`RecordError::BlackBox`] if there is none.
    pub fn formula(&self) -> Result<&Formula<ANY>, RecordError> {
        match self {
            Self::Formula(prepared) => Ok(prepared.formula()),
            Self::BlackBox(_) => Err(RecordError::BlackBox),
        }
    }

    /// Returns the tables that the formula calls, in the order of their numbers.
    #[must_use]
    pub fn tables(&self) -> &[Arc<dyn Table>] {
        self.formula().map_or(&[], Formula::tables)
    }

    /// Returns `H(x)`, as `D²` numbers column by column.
    ///
    /// # Panics
    ///
    /// If `x` has another number of coordinates than the space.
    #[must_use]
    pub fn gram(&self, x: &[f64]) -> Vec<f64> {
        let mut gram = vec![0.0; x.len() * x.len()];
        self.gram_into(x, &mut gram);
        gram
    }

    /// Returns whether interval arithmetic shows that the first entry of `H` is positive everywhere. It
    /// may be so where this is `false`.
    #[must_use]
    pub fn is_positive_everywhere(&self) -> bool {
        // An undefined entry has no positive bound.
        self.formula().is_ok_and(|formula| {
            let everywhere = vec![Interval::REALS; formula.dimension()];
            formula.gram_at(&everywhere)[0].lo() > 0.0
        })
    }

    fn batches(&self) -> &dyn AnyBatches {
        match self {
            Self::Formula(prepared) => prepared,
            Self::BlackBox(values) => values,
        }
    }
}

impl AnyBatches for Known {
    fn dimension(&self) -> usize {
        self.batches().dimension()
    }

    fn quadrature_tolerance(&self) -> f64 {
        self.batches().quadrature_tolerance()
    }

    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        self.batches().gram_into(x, gram);
    }

    fn layout(&self, kind: Kind) -> &Layout {
        self.batches().layout(kind)
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        self.batches().registers(kind, unit, units)
    }

    fn instruction_set(&self) -> InstructionSet {
        self.batches().instruction_set()
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        self.batches().evaluate(kind, registers);
    }
}
