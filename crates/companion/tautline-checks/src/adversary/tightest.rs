//! `Tightest`: the result of a search.

use tautline_statements::{Evidence, Inequality};

use super::Edge;

/// The tightest case that a search found in a family.
#[derive(Clone, Debug, PartialEq)]
pub struct Tightest {
    /// The names of the parameters and their values.
    pub parameters: Vec<(&'static str, f64)>,
    /// The evidence in this case.
    pub evidence: Evidence,
    /// The tightest conclusion of the source that the search was run for.
    pub conclusion: Inequality,
    /// The overestimation of this conclusion, a pure number.
    pub overestimation: f64,
    /// The parameters that lie at an end of their ranges.
    pub edges: Vec<Edge>,
    /// How many cases were evaluated.
    pub evaluations: usize,
    /// How many of the evaluated cases have an overestimation: the problem makes sense, the solver
    /// converges, the hypotheses hold, and the observed number exceeds rounding.
    pub told: usize,
}

impl Tightest {
    /// Returns a parameter of the case by its name.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<f64> {
        self.parameters.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
    }
}
