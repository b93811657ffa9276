//! The trapezoidal rule of the textbooks.

use crate::{Node, Rule};

/// The rule that takes the mean of `H` at both ends of the chord: the trapezoidal rule outside the
/// paper.
///
/// It is not the paper's [`Trapezoidal`](crate::Trapezoidal), and no statement of the paper
/// concerns it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrueTrapezoid;

impl Rule for TrueTrapezoid {
    const NODES: &'static [Node] =
        &[Node { fraction: 0.0, weight: 0.5 }, Node { fraction: 1.0, weight: 0.5 }];
    const ERROR_EXPONENT: i32 = 2;
}
