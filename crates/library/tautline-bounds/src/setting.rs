//! `Setting`: the numbers that Theorems 1.1 to 1.4 need.

use tautline_metrics::Constants;

use crate::{BoundError, number::Number, product::product};

/// The setting of Theorem 1.1: the constants of the metric, the distance `d = d^g(X⁽⁰⁾, X⁽¹⁾)`
/// between the ends, in `m`, and the dimension `D`.
///
/// Invariant: `0 ≤ d < ∞` and `D ≥ 1`, in addition to the invariants of [`Constants`].
///
/// Every bound increases with `d`, `c₂`, `L_H` and `M_H` and decreases with `c₁`. An upper bound on
/// the distance, for example the length of an admissible curve, may therefore replace `d`.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    constants: Constants,
    distance: f64,
    dimension: usize,
}

impl Setting {
    /// Checks `distance`, in `m`, then `dimension`. `distance = 0` is allowed and means that the
    /// ends touch.
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
        // This avoids printing −0.
        Ok(Setting { constants, distance: distance.abs(), dimension })
    }

    /// Returns the constants `c₁`, `c₂` and `L_H` of the metric.
    #[must_use]
    pub fn constants(&self) -> Constants {
        self.constants
    }

    /// Returns the distance `d` between the ends, in `m`.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// Returns the dimension `D`.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns the factor `ω` in `|γ̈| ≤ ω (L_H/c₁) |γ̇|²` for geodesics, a pure number. It is ½
    /// for an isotropic metric and on the line, and 3/2 otherwise.
    #[must_use]
    pub fn omega(&self) -> f64 {
        if self.dimension == 1 || self.constants.is_isotropic() { 0.5 } else { 1.5 }
    }

    /// Returns `δ = L_H d / c₁^{3/2}`, a pure number that bounds the relative change of `H` along a
    /// minimal geodesic.
    #[must_use]
    pub fn delta(&self) -> f64 {
        self.delta_in()
    }

    pub(crate) fn delta_in<T: Number>(&self) -> T {
        let root = self.root();
        let [l_h, d] = [self.constants.l_h(), self.distance].map(T::constant);
        T::product([l_h, d, root, root, root])
    }

    /// Returns `μ = M_H d² / c₁²`, a pure number, or `None` if `M_H` is unknown.
    #[must_use]
    pub fn mu(&self) -> Option<f64> {
        self.mu_in()
    }

    pub(crate) fn mu_in<T: Number>(&self) -> Option<T> {
        let (root, d) = (self.root(), T::constant(self.distance));
        let m_h = T::constant(self.constants.m_h()?);
        Some(T::product([m_h, d, d, root, root, root, root]))
    }

    /// Returns `1/√c₁`.
    fn root<T: Number>(&self) -> T {
        T::constant(self.constants.c1()).sqrt().recip()
    }

    /// Returns `G`, a pure number, for which `γ̈ᵀ H(γ) γ̈ ≤ G² d²` for every minimal geodesic
    /// (Lemma S.1).
    ///
    /// ```text
    /// G  =  ωδ,    and for an isotropic metric with M_H
    /// G² =  (δ²/4) (1 + δ²/2μ)⁻³  if δ² ≤ μ,      2μ/27  otherwise
    /// ```
    ///
    /// For `H = φ I` with `φ ≥ c₁` everywhere, `|∇φ|² ≤ 2M_H (φ − c₁)` (Glaeser), and the force is
    /// `d²|∇φ|/2φ^{3/2}`. The form with `M_H` needs constants that hold everywhere, not only [on a
    /// region](Constants::on_a_region).
    #[must_use]
    pub fn bend(&self) -> f64 {
        self.bend_in()
    }

    pub(crate) fn bend_in<T: Number>(&self) -> T {
        let (delta, constants): (T, _) = (self.delta_in(), self.constants);
        let coarse = T::product([T::constant(self.omega()), delta]);
        let isotropic = self.dimension == 1 || constants.is_isotropic();
        match (constants.m_h(), self.mu_in::<T>()) {
            (Some(m_h), Some(mu)) if isotropic && !constants.is_local() && delta.is_positive() => {
                let l_h = T::constant(constants.l_h());
                // δ²/μ; the distance cancels.
                let ratio = l_h / m_h * (l_h / constants.c1());
                let fine = if ratio.is_at_most(1.0) {
                    T::product([T::constant(0.5), delta])
                        * (ratio * 0.5 + 1.0).to_minus_three_halves()
                } else {
                    // This holds for every ratio: it is the bound where |∇φ| ≤ L_H is not used.
                    (mu * (T::constant(2.0) / 27.0)).sqrt()
                };
                fine.least(coarse)
            }
            _ => coarse,
        }
    }

    /// Returns whether [`bend`](Setting::bend) uses `M_H`.
    #[must_use]
    pub fn bend_needs_m_h(&self) -> bool {
        self.bend() < product([self.omega(), self.delta()])
    }

    /// Returns `κ − 1` for `κ = c₂/c₁`, a pure number.
    pub(crate) fn kappa_above_one<T: Number>(&self) -> T {
        let [c1, c2] = [self.constants.c1(), self.constants.c2()].map(T::constant);
        (c2 - c1) / c1
    }

    /// Returns the setting with the distance replaced by `distance`, in `m`.
    ///
    /// # Errors
    ///
    /// [`BoundError::NotADistance`] if `distance` is negative, infinite or NaN.
    pub fn with_distance(self, distance: f64) -> Result<Setting, BoundError> {
        Setting::new(self.constants, distance, self.dimension)
    }
}

#[cfg(test)]
mod tests {
    use super::{BoundError, Setting};
    use crate::by_hand::{constants, with_m_h};

    #[test]
    fn invalid_numbers_are_errors_that_name_number_and_hypothesis() {
        let new = |distance, dimension| {
            Setting::new(constants(1.0, 9.0, 5.0), distance, dimension).expect_err("invalid")
        };
        for distance in [-1.0, -5e-324, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(new(distance, 2), BoundError::NotADistance { distance });
        }
        assert!(
            matches!(new(f64::NAN, 2), BoundError::NotADistance { distance } if distance.is_nan())
        );
        assert_eq!(new(1.0, 0), BoundError::NoDimension);
        // If several hypotheses are violated, the first one is reported.
        assert_eq!(new(-1.0, 0), BoundError::NotADistance { distance: -1.0 });
        assert_eq!(
            new(-1.5, 2).to_string(),
            "d = -1.5 must be nonnegative and finite: it is a distance (Theorem 1.1)"
        );
        assert_eq!(
            new(1.0, 0).to_string(),
            "D = 0 must be at least 1: it is the dimension of the space (Theorem 1.1)"
        );
    }

    /// `c₁ = 4`, `c₂ = 10`, `L_H = 8`, `M_H = 6`, `d = 3`: `δ = 24/8` and `μ = 54/16`.
    #[test]
    fn pure_numbers_by_hand() {
        let (constants, known) = (constants(4.0, 10.0, 8.0), with_m_h(4.0, 10.0, 8.0, 6.0));
        let setting =
            |constants, dimension| Setting::new(constants, 3.0, dimension).expect("valid");
        assert_eq!(setting(known, 2).delta(), 3.0);
        assert_eq!(setting(known, 2).mu(), Some(3.375));
        assert_eq!(setting(constants, 2).mu(), None);
        assert_eq!(setting(constants, 2).kappa_above_one::<f64>(), 1.5);
        assert_eq!(setting(constants, 2).omega(), 1.5);
        assert_eq!(setting(constants, 1).omega(), 0.5);
        assert_eq!(setting(constants.isotropic(), 2).omega(), 0.5);
        assert_eq!(setting(known, 2).bend(), 4.5);
        assert_eq!(setting(constants, 1).bend(), 1.5);
        // δ² = 9 is above μ = 27/8, so G² = 1/4. With M_H = 96, δ² is below μ = 54, so
        // G² = (9/4)(13/12)⁻³.
        assert_eq!(setting(known, 1).bend(), 0.5);
        assert_eq!(setting(known.isotropic(), 5).bend(), 0.5);
        assert_eq!(setting(known.on_a_region(), 1).bend(), 1.5);
        assert!(setting(known, 1).bend_needs_m_h() && !setting(known, 2).bend_needs_m_h());
        let curved = with_m_h(4.0, 10.0, 8.0, 96.0);
        let expected = 1.5 * (13.0_f64 / 12.0).powf(-1.5);
        assert!((setting(curved, 1).bend() / expected - 1.0).abs() < 1e-15);
        assert_eq!(setting(with_m_h(4.0, 10.0, 0.0, 0.0), 1).bend(), 0.0);
        let nearer = setting(known, 2).with_distance(1.0).expect("a distance");
        assert_eq!((nearer.delta(), nearer.dimension()), (1.0, 2));
        assert!(nearer.with_distance(-1.0).is_err());
    }

    /// The difference `c₂ − c₁` is exact, whereas `κ` would be rounded.
    #[test]
    fn a_kappa_near_one_keeps_its_digits() {
        let constants = constants(3.0, 3.0_f64.next_up(), 1.0);
        let setting = Setting::new(constants, 1.0, 2).expect("valid");
        // The doubles next to 3 are 2ε apart, where ε is the machine epsilon.
        assert_eq!(setting.kappa_above_one::<f64>(), 2.0 * f64::EPSILON / 3.0);
    }

    #[test]
    fn the_bend_is_proportional_to_the_distance() {
        for (l_h, m_h) in [(8.0, 6.0), (8.0, 96.0), (1e-3, 5.0), (3.0, 1e-6)] {
            let constants = with_m_h(4.0, 10.0, l_h, m_h);
            for constants in [constants, constants.isotropic(), constants.on_a_region()] {
                for dimension in [1, 3] {
                    let bend = |d| Setting::new(constants, d, dimension).expect("valid").bend();
                    for power in [-480, -30, 1, 60] {
                        // Scaling by powers of two is exact as long as μ does not underflow.
                        let ratio = bend(2.0_f64.powi(power)) / 2.0_f64.powi(power) / bend(1.0);
                        assert!((ratio - 1.0).abs() < 1e-15, "{constants:?} 2^{power}: {ratio}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_setting_returns_its_numbers() {
        let constants = constants(1.0, 9.0, 5.0);
        let setting = Setting::new(constants, 2.5, 3).expect("valid");
        assert_eq!(setting.constants(), constants);
        assert_eq!(setting.distance(), 2.5);
        assert_eq!(setting.dimension(), 3);
        let touching = Setting::new(constants, -0.0, 1).expect("zero is a distance");
        assert!(touching.distance().is_sign_positive());
    }
}
