//! The paper's trapezoidal rule, which is called the midpoint rule elsewhere.

use tautline_bounds::PaperRule;

use crate::{Node, Rule};

impl Rule {
    /// The paper's trapezoidal rule `E_tra,N`, which evaluates `H` at the midpoint of the chord.
    ///
    /// Most books call this the midpoint rule. They call the mean of `H` at both ends
    /// ([`Rule::TRUE_TRAPEZOID`]) the trapezoidal rule. The name here follows the paper.
    #[doc(alias = "midpoint")]
    pub const TRAPEZOIDAL: Rule =
        Rule::new("trapezoidal", &[Node { fraction: 0.5, weight: 1.0 }], 2)
            .of_the_paper(PaperRule::Trapezoidal);
}
