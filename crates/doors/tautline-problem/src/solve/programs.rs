//! `Programs`: what problems with the same formula share.

use std::sync::Arc;

use tautline::Known;

use crate::{Diagnostic, Question};

/// The programs of a metric, which are derived once, and which problems with the same formula share.
#[derive(Clone, Debug)]
pub struct Programs(Arc<Known>);

impl Programs {
    pub(super) fn metric(&self) -> &Arc<Known> {
        &self.0
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
        let formula = self.any_formula()?;
        Ok(match last.filter(|last| last.0.formula() == Ok(&formula)) {
            Some(last) => last.clone(),
            None => Programs(Arc::new(Known::from(formula))),
        })
    }
}
