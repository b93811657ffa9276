//! `Tightest`: what a search found.

use tautline_statements::{Evidence, Inequality};

use super::Edge;

/// The case of a family with the least overestimation that a search found.
#[derive(Clone, Debug, PartialEq)]
pub struct Tightest {
    /// The case: the names of the parameters, and their values.
    pub parameters: Vec<(&'static str, f64)>,
    /// The evidence in this case.
    pub evidence: Evidence,
    /// The tightest of the conclusions that were looked at.
    pub conclusion: Inequality,
    /// Its overestimation, a pure number.
    pub overestimation: f64,
    /// The parameters that are at an end of their ranges.
    pub edges: Vec<Edge>,
    /// How many cases were evaluated.
    pub evaluations: usize,
    /// In how many of them an overestimation could be told: the problem makes sense, the solver
    /// converged, the hypotheses hold, and what is observed is more than rounding.
    pub told: usize,
}

impl Tightest {
    /// Returns a parameter of the case by its name.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<f64> {
        self.parameters.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
    }
}
