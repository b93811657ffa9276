//! The paper's trapezoidal rule, which is called the midpoint rule elsewhere.

use crate::{Node, Rule};

/// The paper's trapezoidal rule `E_tra,N`, which evaluates `H` at the midpoint of the chord.
///
/// Most books call this the midpoint rule. They call the mean of `H` at both ends
/// ([`TrueTrapezoid`](crate::TrueTrapezoid)) the trapezoidal rule. The name here follows the paper.
#[doc(alias = "midpoint")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trapezoidal;

impl Rule for Trapezoidal {
    const NODES: &'static [Node] = &[Node { fraction: 0.5, weight: 1.0 }];
    const ERROR_EXPONENT: i32 = 2;
}
