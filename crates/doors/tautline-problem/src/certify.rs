//! A certificate of the distance of a file.

use core::ops::ControlFlow;
use std::sync::Arc;

use tautline::{
    CertificateError, Known, Rule,
    check::LARGEST_DIMENSION,
    distance::{Progress, Wanted},
};
use tautline_any::{CertifiedAnswer, Request};

use crate::{Answer, Diagnostic, Failure, Question};

impl Question {
    /// Searches for a certificate of the distance. The search goes on until the gap is as small as
    /// `wanted`, no longer falls, or `observe` stops it.
    ///
    /// # Errors
    ///
    /// [`Failure::BadInput`] with the place in the file; [`Failure::NotComputed`] if there is no curve
    /// or nothing is proved.
    pub fn certify(
        &self,
        wanted: Wanted,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<CertifiedAnswer, Failure> {
        if self.dimension > LARGEST_DIMENSION {
            return Err(Failure::NotComputed(format!(
                "certificates are made in up to {LARGEST_DIMENSION} dimensions, not {}",
                self.dimension
            )));
        }
        let metric = Arc::new(Known::from(self.any_formula()?));
        let request = Request { rule: Rule::TRAPEZOIDAL, ..self.request() };
        let line = self.line(metric, &request, &mut |_: &Answer| ())?;
        let found = CertifiedAnswer::of(&line, wanted, observe);
        let mut found = found.map_err(|error| self.refused(error))?;
        // The cubes of the first level hold those of all others.
        if let Some(first) = found.corridor.first() {
            found.note = self.negative_in(first)?;
        }
        Ok(found)
    }

    fn refused(&self, error: CertificateError) -> Failure {
        match error {
            CertificateError::NoShape { end } => {
                let set = if end == "first" { &self.problem.from } else { &self.problem.to };
                let place = set.as_ref().map(|set| set.span()).unwrap_or_default();
                Failure::BadInput(Diagnostic::new(error.to_string(), place))
            }
            error => Failure::NotComputed(error.to_string()),
        }
    }
}
