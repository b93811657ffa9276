//! The right-endpoint rule.

use crate::{Node, Rule};

/// The rule that evaluates `H` at the last point of the chord.
///
/// It is the [left-endpoint rule](crate::LeftEndpoint) of the reversed sequence, so that every
/// statement about that rule holds for this one with both ends exchanged. The mean of both is the
/// [`TrueTrapezoid`](crate::TrueTrapezoid).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RightEndpoint;

impl Rule for RightEndpoint {
    const NODES: &'static [Node] = &[Node { fraction: 1.0, weight: 1.0 }];
    const ERROR_EXPONENT: i32 = 1;
}
