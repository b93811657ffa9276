//! Mutants: deliberately wrong variants of the library, which the suite must detect.

mod enclosures;
mod formula;
mod mutant;
mod paper;
pub(crate) mod programs;
mod sharper;
pub(crate) mod solver;
mod theorems;

use tautline::Constants;

pub use mutant::Mutant;

use crate::replaceable::{Bounds, GENUINE};

impl Mutant {
    /// Returns the table of bounds, which contains the mistake if the mistake is in a bound.
    pub(crate) fn bounds(self) -> Bounds {
        let mut bounds = GENUINE;
        paper::replace(self, &mut bounds);
        sharper::replace(self, &mut bounds);
        theorems::replace(self, &mut bounds);
        enclosures::replace(self, &mut bounds);
        bounds
    }
}

/// Returns the constants with `L_H` multiplied by a factor.
pub(crate) fn with_l_h(constants: Constants, factor: f64) -> Constants {
    constants.times([1.0, 1.0, factor, 1.0]).expect("a multiple of a finite constant")
}
