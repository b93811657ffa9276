//! The left-endpoint rule.

use tautline_bounds::PaperRule;

use crate::{Node, Rule};

impl Rule {
    /// The left-endpoint rule `E_l,N`, which evaluates `H` at the first point of the chord.
    pub const LEFT_ENDPOINT: Rule =
        Rule::new("left_endpoint", &[Node { fraction: 0.0, weight: 1.0 }], 1)
            .of_the_paper(PaperRule::LeftEndpoint);
}
