//! `PaperRule`: the two rules of the paper, as a value.

/// The two rules of the paper, as a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum PaperRule {
    /// The trapezoidal rule evaluates `H` at the midpoint of each chord.
    #[doc(alias = "midpoint")]
    Trapezoidal,
    /// The left-endpoint rule evaluates `H` at the first point of each chord.
    LeftEndpoint,
}

impl PaperRule {
    /// Both rules, in the paper's order.
    pub const BOTH: [PaperRule; 2] = [PaperRule::Trapezoidal, PaperRule::LeftEndpoint];

    /// Returns the name that data files use for the rule.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            PaperRule::Trapezoidal => "trapezoidal",
            PaperRule::LeftEndpoint => "left_endpoint",
        }
    }

    /// Returns the mean distance between the points of a chord and the point where the rule
    /// evaluates `H`, in chord lengths: `k = ¼` for the midpoint, `k = ½` for an endpoint.
    #[must_use]
    pub fn mean_distance(self) -> f64 {
        match self {
            PaperRule::Trapezoidal => 0.25,
            PaperRule::LeftEndpoint => 0.5,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::PaperRule;

    /// Data files use these names, so they must not change.
    #[test]
    fn the_names_are_those_of_data_files() {
        assert_eq!(PaperRule::BOTH.map(PaperRule::name), ["trapezoidal", "left_endpoint"]);
    }
}
