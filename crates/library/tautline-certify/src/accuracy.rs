//! `Accuracy`: how close bounds should be, and at what cost.

use crate::CertifyError;

/// How close the two bounds on a constant should be, and how many boxes may be spent to get there.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
pub struct Accuracy {
    /// The relative distance between the bounds; it must lie between 0 and 1.
    pub tolerance: f64,
    /// The largest number of boxes.
    pub budget: usize,
}

impl Default for Accuracy {
    /// Returns a tolerance of `10⁻³` and a budget of a million boxes. Evaluating that many takes
    /// from a second to about a minute.
    fn default() -> Self {
        Self { tolerance: 1e-3, budget: 1_000_000 }
    }
}

impl Accuracy {
    /// Checks the tolerance.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotATolerance`] if the tolerance is not between 0 and 1.
    pub fn checked(self) -> Result<Self, CertifyError> {
        if self.tolerance > 0.0 && self.tolerance < 1.0 {
            Ok(self)
        } else {
            Err(CertifyError::NotATolerance { tolerance: self.tolerance })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Accuracy;

    #[test]
    fn a_tolerance_lies_between_0_and_1() {
        assert!(Accuracy::default().checked().is_ok());
        for tolerance in [0.0, -1e-3, 1.0, f64::INFINITY, f64::NAN] {
            assert!(
                Accuracy { tolerance, ..Accuracy::default() }.checked().is_err(),
                "{tolerance}"
            );
        }
    }
}
