//! `Lanes`: how many plain numbers a number stands for.

use crate::{Pair, Scalar};

/// One or more `f64` side by side, on which every operation works at once.
pub trait Lanes: Scalar {
    /// How many numbers stand side by side.
    const LANES: usize;

    /// Returns the one with the number `lane`, from 0.
    #[must_use]
    fn lane(self, lane: usize) -> f64;

    /// Returns whether each is positive and finite.
    #[must_use]
    fn are_positive(self) -> bool;
}

impl Lanes for f64 {
    const LANES: usize = 1;

    #[inline(always)]
    fn lane(self, _lane: usize) -> f64 {
        self
    }

    #[inline(always)]
    fn are_positive(self) -> bool {
        self > 0.0 && self <= f64::MAX
    }
}

impl Lanes for Pair {
    const LANES: usize = 2;

    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.both()[lane]
    }

    #[inline(always)]
    fn are_positive(self) -> bool {
        self.are_between(0.0, f64::MAX)
    }
}
