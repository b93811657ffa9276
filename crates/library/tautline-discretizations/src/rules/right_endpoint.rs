//! The right-endpoint rule.

use crate::{Node, Rule};

impl Rule {
    /// The rule that evaluates `H` at the last point of the chord.
    ///
    /// It is the [left-endpoint rule](Rule::LEFT_ENDPOINT) of the reversed sequence, so that every
    /// statement about that rule holds for this one with both ends exchanged. The mean of both is the
    /// [`Rule::TRUE_TRAPEZOID`].
    pub const RIGHT_ENDPOINT: Rule =
        Rule::new("right_endpoint", &[Node { fraction: 1.0, weight: 1.0 }], 1);
}
