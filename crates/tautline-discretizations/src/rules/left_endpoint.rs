//! The left-endpoint rule.

use crate::{Node, Rule};

/// The left-endpoint rule `E_l,N`, which evaluates `H` at the first point of the chord.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LeftEndpoint;

impl Rule for LeftEndpoint {
    const NODES: &'static [Node] = &[Node { fraction: 0.0, weight: 1.0 }];
    const ERROR_EXPONENT: i32 = 1;
}
