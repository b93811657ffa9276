//! `Proofs`: how bounds and constants are proved.

use tautline::{Constants, certify::Accuracy};

use crate::bounds::Proving;

/// The number of boxes for one constant in the plane, unless another is given: some tenths of a second.
const BOXES: usize = 100_000;

/// The relative accuracy of a constant, unless another is given.
pub const ACCURACY: f64 = 1e-3;

/// Returns the number of boxes for one constant, unless another is given. A box costs more in
/// more dimensions, so that a proof takes seconds, not minutes.
#[must_use]
pub fn default_boxes(dimension: usize) -> usize {
    // From six dimensions on formulas are short, or refused.
    let dear = dimension.saturating_sub(2).min(4) as u32;
    BOXES / 5_usize.pow(dear)
}

/// How bounds and constants are proved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Proofs {
    /// Constants that are claimed for the metric. Without them they are proved from its formula.
    pub claimed: Option<Constants>,
    /// The relative accuracy of a constant; a thousandth if absent.
    pub tolerance: Option<f64>,
    /// The largest number of boxes for one constant; 100,000 in the plane if absent, a fifth of
    /// that for each further dimension, and 160 from six dimensions on.
    pub boxes: Option<usize>,
}

impl Proofs {
    pub(crate) fn accuracy(&self, dimension: usize) -> Accuracy {
        Accuracy {
            tolerance: self.tolerance.unwrap_or(ACCURACY),
            budget: self.boxes.unwrap_or(default_boxes(dimension)),
        }
    }

    pub(crate) fn proving(&self, dimension: usize) -> Proving {
        Proving { claimed: self.claimed, is_in_a_region: false, accuracy: self.accuracy(dimension) }
    }
}
