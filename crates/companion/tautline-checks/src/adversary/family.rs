//! `Family`: a statement on a box of cases.

use tautline_statements::{Evidence, Statement, VerifyError};

use super::Parameter;

/// Returns the evidence at the values of the parameters; `None` if there is no such case.
type AtValues<'a> = Box<dyn Fn(&[f64]) -> Result<Option<Evidence>, VerifyError> + 'a>;

/// One statement on the cases of a box of parameters.
pub struct Family<'a> {
    /// The name used in tables.
    pub name: &'static str,
    /// The statement.
    pub statement: Statement,
    /// The sides of the box.
    pub parameters: Vec<Parameter>,
    evidence: AtValues<'a>,
}

impl<'a> Family<'a> {
    /// Returns the family with this name on a box of `P` parameters. `evidence` returns the
    /// evidence at a point of the box, or `None` if there is no such case.
    pub fn new<const P: usize>(
        name: &'static str,
        statement: Statement,
        parameters: [Parameter; P],
        evidence: impl Fn([f64; P]) -> Result<Option<Evidence>, VerifyError> + 'a,
    ) -> Self {
        let evidence = move |values: &[f64]| match <[f64; P]>::try_from(values) {
            Ok(values) => evidence(values),
            Err(_) => Ok(None),
        };
        Self { name, statement, parameters: parameters.to_vec(), evidence: Box::new(evidence) }
    }

    /// Returns whether the family has this name and its statement has this number.
    #[must_use]
    pub fn is(&self, number: &str, name: &str) -> bool {
        self.statement.number() == number && self.name == name
    }

    /// Returns the evidence at the values of the parameters; `None` if there is no such case.
    ///
    /// # Errors
    ///
    /// The errors of the statement.
    pub fn evidence(&self, values: &[f64]) -> Result<Option<Evidence>, VerifyError> {
        (self.evidence)(values)
    }

    /// Pairs values with the names of their parameters.
    #[must_use]
    pub(super) fn named(&self, values: &[f64]) -> Vec<(&'static str, f64)> {
        self.parameters.iter().map(|parameter| parameter.name).zip(values.iter().copied()).collect()
    }
}

impl std::fmt::Debug for Family<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} on {}{:?}", self.statement, self.name, self.parameters)
    }
}
