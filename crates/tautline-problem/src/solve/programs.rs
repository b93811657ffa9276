//! `Programs`: what problems with the same formula share.

use core::any::Any;
use std::sync::Arc;

use tautline::Prepared;

use crate::{
    Diagnostic, Question,
    dimension::{InDimension, in_dimension},
    known::Known,
};

/// The programs of a metric, which are derived once, and which problems with the same formula share.
#[derive(Clone, Debug)]
pub struct Programs(Arc<dyn Any + Send + Sync>);

impl Programs {
    /// Returns the metric with its programs, if it has `D` coordinates.
    pub(super) fn prepared<const D: usize>(&self) -> Option<Arc<Prepared<Known<D>, D>>> {
        Arc::clone(&self.0).downcast().ok()
    }
}

struct Derive<'q> {
    question: &'q Question,
    last: Option<&'q Programs>,
}

impl InDimension for Derive<'_> {
    type Output = Result<Programs, Diagnostic>;

    fn run<const D: usize>(self) -> Self::Output {
        let formula = self.question.formula::<D>()?;
        let is_same = |last: &&Programs| {
            let prepared = last.prepared::<D>();
            prepared.is_some_and(|prepared| prepared.metric().formula() == Ok(&formula))
        };
        Ok(match self.last.filter(is_same) {
            Some(last) => last.clone(),
            None => Programs(Arc::new(Known::Formula(formula).prepared())),
        })
    }
}

impl Question {
    /// Returns the programs of the metric: those of `last` if the formula is the same, otherwise new
    /// ones, which are derived on first use.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] with the place in the file, if an expression is wrong.
    pub fn programs(&self, last: Option<&Programs>) -> Result<Programs, Diagnostic> {
        let found = in_dimension(self.dimension, Derive { question: self, last });
        found.unwrap_or_else(|| Err(Diagnostic::new("no such dimension", 0..0)))
    }
}
