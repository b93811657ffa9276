//! The trapezoidal rule of the textbooks.

use crate::{Node, Rule};

impl Rule {
    /// The rule that takes the mean of `H` at both ends of the chord: the trapezoidal rule outside the
    /// paper.
    ///
    /// It is not the paper's [`Rule::TRAPEZOIDAL`], and no statement of the paper
    /// concerns it.
    pub const TRUE_TRAPEZOID: Rule = Rule::new(
        "true_trapezoid",
        &[Node { fraction: 0.0, weight: 0.5 }, Node { fraction: 1.0, weight: 0.5 }],
        2,
    );
}
