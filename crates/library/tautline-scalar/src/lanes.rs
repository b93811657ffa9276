//! `Lanes`: scalars that consist of one or more `f64`.

use crate::{Pair, Scalar};

/// A scalar that consists of one or more `f64`. Every operation applies to each of them.
pub trait Lanes: Scalar {
    /// The number of lanes.
    const LANES: usize;

    /// Returns lane `lane < LANES`.
    #[must_use]
    fn lane(self, lane: usize) -> f64;

    /// Returns whether every lane is positive and finite.
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
