//! `BoundError`: the reasons why there is no bound for the given numbers.

use crate::PaperRule;

/// A hypothesis that the given numbers violate.
///
/// Violated hypotheses on `c₁`, `c₂` and `L_H` are in
/// [`HypothesisError`](tautline_metrics::HypothesisError).
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BoundError {
    /// The distance between the ends is negative, infinite or NaN.
    #[error("d = {distance} must be nonnegative and finite: it is a distance (Theorem 1.1)")]
    NotADistance {
        /// The given number.
        distance: f64,
    },
    /// A bound on a derivative is negative, infinite or NaN.
    #[error("{name} = {value} must be nonnegative and finite: it bounds a derivative (S.11)")]
    NotABound {
        /// The name of the bound.
        name: &'static str,
        /// The given number.
        value: f64,
    },
    /// A computed energy or squared length is negative, infinite or NaN.
    #[error("the energy {energy} must be nonnegative and finite (Proposition S.6)")]
    NotAnEnergy {
        /// The given number.
        energy: f64,
    },
    /// The constants hold on a region only, and nothing excludes competitors that leave it.
    #[error(
        "the constants hold on a region only: Proposition S.8 has to exclude competitors that leave \
         it"
    )]
    LocalConstants,
    /// The lower bound on the discrete minimum implies a distance greater than the length of a
    /// curve.
    #[error(
        "d² is at least {lower} and at most {upper}: the constants or the lower bound on the \
         minimum are wrong (Proposition S.6)"
    )]
    Contradiction {
        /// The lower bound, in `m²`.
        lower: f64,
        /// The upper bound, in `m²`.
        upper: f64,
    },
    /// Competitors may leave the ball in which the constants hold.
    #[error(
        "a competitor could be {reach} from the centre of a ball of radius {radius}, where the \
         constants need not hold (Proposition S.8)"
    )]
    LeavesTheBall {
        /// The greatest distance of a competitor from the centre of the ball, in `ℓ`.
        reach: f64,
        /// The radius of the ball, in `ℓ`.
        radius: f64,
    },
    /// The paper has no theorem for the rule.
    #[error(
        "no theorem is about the rule {rule}: the theorems are about {} and {} alone",
        PaperRule::Trapezoidal.name(), PaperRule::LeftEndpoint.name()
    )]
    OtherRule {
        /// The name of the rule.
        rule: &'static str,
    },
    /// The dimension is 0.
    #[error("D = 0 must be at least 1: it is the dimension of the space (Theorem 1.1)")]
    NoDimension,
}

impl BoundError {
    /// Checks that a computed energy is nonnegative and finite.
    pub(crate) fn check_energy(energy: f64) -> Result<(), BoundError> {
        if energy >= 0.0 && energy.is_finite() {
            Ok(())
        } else {
            Err(BoundError::NotAnEnergy { energy })
        }
    }
}
