//! `Approximation`: a number to about twice the precision of a double, with a bound of its error.

use super::directed::{add_down, add_up};

/// The real numbers `y` with `|y − head − tail| ≤ error`.
///
/// The sum of head and tail is not evaluated before the end, so that the one rounding that
/// remains is that of the result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approximation {
    pub(super) head: f64,
    pub(super) tail: f64,
    pub(super) error: f64,
}

impl Approximation {
    /// Bounds of all these numbers: `tail ∓ error` is rounded to nearest, hence the step to the
    /// neighbour, and the sum with the head in the direction of the bound.
    #[inline]
    pub(super) fn bounds(self) -> (f64, f64) {
        (
            add_down(self.head, (self.tail - self.error).next_down()),
            add_up(self.head, (self.tail + self.error).next_up()),
        )
    }
}

impl std::ops::Neg for Approximation {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { head: -self.head, tail: -self.tail, error: self.error }
    }
}
