//! `Setting`: all that Theorems 1.1 to 1.4 ask about a problem.

use tautline_metrics::Constants;

use crate::product::product;

/// The setting of Theorem 1.1 in numbers: the constants of the metric, the distance
/// `d = d^g(X⁽⁰⁾, X⁽¹⁾)` of the ends, in `m`, and the dimension `D`.
///
/// Invariant: `0 ≤ d < ∞` and `D ≥ 1`, besides those of [`Constants`]. [`Setting::new`] is the
/// only way in, so a function which takes a `Setting` need not check again.
///
/// Every bound grows with `d`, `c₂`, `L_H` and `M_H` and falls with `c₁`: where only an upper bound of
/// the distance is known (the length of any admissible curve is one), it may stand for `d`, and
/// the results are still bounds.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    constants: Constants,
    distance: f64,
    dimension: usize,
}

impl Setting {
    /// Checks `distance`, in `m`, then `dimension`.
    ///
    /// `distance = 0` (ends that touch) is a setting: every bound is then 0.
    ///
    /// # Errors
    ///
    /// [`BoundError::NotADistance`] if `distance` is negative, infinite or NaN;
    /// [`BoundError::NoDimension`] if `dimension` is 0.
    pub fn new(
        constants: Constants,
        distance: f64,
        dimension: usize,
    ) -> Result<Setting, BoundError> {
        if !(distance >= 0.0 && distance.is_finite()) {
            return Err(BoundError::NotADistance { distance });
        }
        if dimension == 0 {
            return Err(BoundError::NoDimension);
        }
        // −0 is a distance too, but must not be printed as one.
        Ok(Setting { constants, distance: distance.abs(), dimension })
    }

    /// Returns the constants `c₁`, `c₂` and `L_H` of the metric.
    #[must_use]
    pub fn constants(&self) -> Constants {
        self.constants
    }

    /// Returns the distance `d` of the ends, in `m`.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// Returns the dimension `D`.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns the factor `ω` in `|γ̈| ≤ ω (L_H/c₁) |γ̇|²` for geodesics, a pure number: ½ for an
    /// isotropic metric, which on the line every metric is, and 3/2 otherwise.
    #[must_use]
    pub fn omega(&self) -> f64 {
        if self.dimension == 1 || self.constants.is_isotropic() { 0.5 } else { 1.5 }
    }

    /// Returns `δ = L_H d / c₁^{3/2}`, a pure number: by how much `H` can change along a minimal
    /// geodesic, relative to its least value; `+∞` on overflow.
    #[must_use]
    pub fn delta(&self) -> f64 {
        let root = 1.0 / self.constants.c1().sqrt();
        product([self.constants.l_h(), self.distance, root, root, root])
    }

    /// Returns `μ = M_H d² / c₁²`, a pure number; `None` if `M_H` is not known, `+∞` on overflow.
    #[must_use]
    pub fn mu(&self) -> Option<f64> {
        let root = 1.0 / self.constants.c1().sqrt();
        let d = self.distance;
        self.constants.m_h().map(|m_h| product([m_h, d, d, root, root, root, root]))
    }

    /// Returns `G` with `γ̈ᵀ H(γ) γ̈ ≤ G² d²` for every minimal geodesic, a pure number (Lemma S.1);
    /// `+∞` on overflow.
    ///
    /// ```text
    /// G  =  ωδ,    and for an isotropic metric with M_H
    /// G² =  (δ²/4) (1 + δ²/2μ)⁻³  if δ² ≤ μ,      2μ/27  otherwise
    /// ```
    ///
    /// Where `H = φ I`, `φ` is smallest where its gradient is: `φ ≥ c₁` everywhere makes
    /// `|∇φ|² ≤ 2M_H (φ − c₁)` (Glaeser), and the force is `d²|∇φ|/2φ^{3/2}`. This needs constants
    /// that hold everywhere, not [on a region](Constants::on_a_region).
    #[must_use]
    pub fn bend(&self) -> f64 {
        let (delta, constants) = (self.delta(), self.constants);
        let coarse = product([self.omega(), delta]);
        let isotropic = self.dimension == 1 || constants.is_isotropic();
        match (constants.m_h(), self.mu()) {
            (Some(m_h), Some(mu)) if isotropic && !constants.is_local() && delta > 0.0 => {
                // δ²/μ, without the distance: nothing underflows unless L_H or M_H does.
                let ratio = constants.l_h() / m_h * (constants.l_h() / constants.c1());
                let fine = if ratio <= 1.0 {
                    product([0.5, delta]) * (1.0 + 0.5 * ratio).powf(-1.5)
                } else {
                    (mu * (2.0 / 27.0)).sqrt()
                };
                fine.min(coarse)
            }
            _ => coarse,
        }
    }

    /// Returns whether [`bend`](Setting::bend) rests on `M_H`.
    #[must_use]
    pub fn bend_needs_m_h(&self) -> bool {
        self.bend() < product([self.omega(), self.delta()])
    }

    /// Returns `κ − 1` for `κ = c₂/c₁`, a pure number; `+∞` on overflow.
    pub(crate) fn kappa_above_one(&self) -> f64 {
        (self.constants.c2() - self.constants.c1()) / self.constants.c1()
    }

    /// Returns the same setting with another distance in place of `d`, in `m`.
    ///
    /// # Errors
    ///
    /// [`BoundError::NotADistance`] if it is negative, infinite or NaN.
    pub fn with_distance(self, distance: f64) -> Result<Setting, BoundError> {
        Setting::new(self.constants, distance, self.dimension)
    }
}

/// A clause of the setting of Theorem 1.1 which the given numbers do not meet.
///
/// The clauses on `c₁`, `c₂` and `L_H` are those of
/// [`HypothesisError`](tautline_metrics::HypothesisError).
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BoundError {
    /// `d` is the distance of two nonempty sets.
    #[error("d = {distance} must be nonnegative and finite: it is a distance (Theorem 1.1)")]
    NotADistance {
        /// The number that was given.
        distance: f64,
    },
    /// An energy, or a squared length, that was computed.
    #[error("the energy {energy} must be nonnegative and finite (Proposition S.6)")]
    NotAnEnergy {
        /// The number that was given.
        energy: f64,
    },
    /// Constants that hold on a region only say nothing of competitors that leave it.
    #[error(
        "the constants hold on a region only: competitors may leave it, which Proposition S.8 has to \
         exclude"
    )]
    LocalConstants,
    /// A lower bound of the discrete minimum puts the distance above the length of a curve.
    #[error(
        "d² is at least {lower} and at most {upper}: the constants or the lower bound of the \
         minimum do not hold (Proposition S.6)"
    )]
    Contradiction {
        /// What follows from below, in `m²`.
        lower: f64,
        /// What follows from above, in `m²`.
        upper: f64,
    },
    /// Competitors may leave the ball in which the constants hold.
    #[error(
        "a competitor could be {reach} from the centre of a ball of radius {radius}: the constants \
         need not hold there (Proposition S.8)"
    )]
    LeavesTheBall {
        /// How far from the centre a competitor could be, in `ℓ`.
        reach: f64,
        /// The radius of the ball, in `ℓ`.
        radius: f64,
    },
    /// The metric lives on `R^D` with `D ≥ 1`.
    #[error("D = 0 must be at least 1: it is the dimension of the space (Theorem 1.1)")]
    NoDimension,
}

impl BoundError {
    /// Checks that a computed energy is one.
    pub(crate) fn check_energy(energy: f64) -> Result<(), BoundError> {
        if energy >= 0.0 && energy.is_finite() {
            Ok(())
        } else {
            Err(BoundError::NotAnEnergy { energy })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BoundError, Setting};
    use tautline_metrics::Constants;

    fn constants() -> Constants {
        Constants::new(1.0, 9.0, 5.0).expect("in order")
    }

    #[test]
    fn a_number_that_is_no_distance_is_refused() {
        for distance in [-1.0, -5e-324, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(
                Setting::new(constants(), distance, 2),
                Err(BoundError::NotADistance { distance })
            );
        }
        // NaN is not equal to itself, so the number is looked at by hand.
        let error = Setting::new(constants(), f64::NAN, 2).expect_err("NaN");
        assert!(matches!(error, BoundError::NotADistance { distance } if distance.is_nan()));
    }

    #[test]
    fn dimension_zero_is_refused() {
        assert_eq!(Setting::new(constants(), 1.0, 0), Err(BoundError::NoDimension));
        // Of two clauses that fail, the first is named.
        assert_eq!(
            Setting::new(constants(), -1.0, 0),
            Err(BoundError::NotADistance { distance: -1.0 })
        );
    }

    #[test]
    fn the_message_names_the_number_and_the_clause() {
        let error = Setting::new(constants(), -1.5, 2).expect_err("negative");
        assert_eq!(
            error.to_string(),
            "d = -1.5 must be nonnegative and finite: it is a distance (Theorem 1.1)"
        );
        assert_eq!(
            BoundError::NoDimension.to_string(),
            "D = 0 must be at least 1: it is the dimension of the space (Theorem 1.1)"
        );
    }

    /// `c₁ = 4`, `c₂ = 10`, `L_H = 8`, `M_H = 6`, `d = 3`: `δ = 24/8` and `μ = 54/16`.
    #[test]
    fn pure_numbers_by_hand() {
        let constants = Constants::new(4.0, 10.0, 8.0).expect("in order");
        let setting =
            |constants, dimension| Setting::new(constants, 3.0, dimension).expect("valid");
        let known = constants.with_m_h(6.0).expect("nonnegative");
        assert_eq!(setting(known, 2).delta(), 3.0);
        assert_eq!(setting(known, 2).mu(), Some(3.375));
        assert_eq!(setting(constants, 2).mu(), None);
        assert_eq!(setting(constants, 2).kappa_above_one(), 1.5);
        assert_eq!(setting(constants, 2).omega(), 1.5);
        assert_eq!(setting(constants, 1).omega(), 0.5);
        assert_eq!(setting(constants.isotropic(), 2).omega(), 0.5);
        assert_eq!(setting(known, 2).bend(), 4.5);
        assert_eq!(setting(constants, 1).bend(), 1.5);
        // δ² = 9 is more than μ = 27/8, and less than 54 with M_H = 96: G² = 1/4, and
        // (9/4)(13/12)⁻³.
        assert_eq!(setting(known, 1).bend(), 0.5);
        assert_eq!(setting(known.isotropic(), 5).bend(), 0.5);
        assert_eq!(setting(known.on_a_region(), 1).bend(), 1.5);
        assert!(setting(known, 1).bend_needs_m_h() && !setting(known, 2).bend_needs_m_h());
        let curved = constants.with_m_h(96.0).expect("nonnegative");
        let expected = 1.5 * (13.0_f64 / 12.0).powf(-1.5);
        assert!((setting(curved, 1).bend() / expected - 1.0).abs() < 1e-15);
        let flat = Constants::new(4.0, 10.0, 0.0).and_then(|c| c.with_m_h(0.0)).expect("in order");
        assert_eq!(setting(flat, 1).bend(), 0.0);
        let nearer = setting(known, 2).with_distance(1.0).expect("a distance");
        assert_eq!((nearer.delta(), nearer.dimension()), (1.0, 2));
        assert!(nearer.with_distance(-1.0).is_err());
    }

    /// `κ − 1` of a metric that is nearly constant is a difference of doubles, which is exact; the
    /// quotient `κ` is rounded first.
    #[test]
    fn a_kappa_near_one_keeps_its_digits() {
        let constants = Constants::new(3.0, 3.0_f64.next_up(), 1.0).expect("in order");
        let setting = Setting::new(constants, 1.0, 2).expect("valid");
        // The doubles beside 3 are 2ε apart.
        assert_eq!(setting.kappa_above_one(), 2.0 * f64::EPSILON / 3.0);
    }

    /// `G/d` is a number of the metric, however near or far the ends are.
    #[test]
    fn the_bend_is_proportional_to_the_distance() {
        for (l_h, m_h) in [(8.0, 6.0), (8.0, 96.0), (1e-3, 5.0), (3.0, 1e-6)] {
            let constants = Constants::new(4.0, 10.0, l_h).and_then(|c| c.with_m_h(m_h));
            let constants = constants.expect("in order");
            for constants in [constants, constants.isotropic(), constants.on_a_region()] {
                for dimension in [1, 3] {
                    let bend = |d| Setting::new(constants, d, dimension).expect("valid").bend();
                    for power in [-480, -30, 1, 60] {
                        // Powers of two round nothing, but that the root of μ needs its square.
                        let ratio = bend(2.0_f64.powi(power)) / 2.0_f64.powi(power) / bend(1.0);
                        assert!((ratio - 1.0).abs() < 1e-15, "{constants:?} 2^{power}: {ratio}");
                    }
                }
            }
        }
    }

    #[test]
    fn what_was_put_in_comes_out() {
        let setting = Setting::new(constants(), 2.5, 3).expect("valid");
        assert_eq!(setting.constants(), constants());
        assert_eq!(setting.distance(), 2.5);
        assert_eq!(setting.dimension(), 3);
        let touching = Setting::new(constants(), -0.0, 1).expect("zero is a distance");
        assert!(touching.distance().is_sign_positive());
    }
}
