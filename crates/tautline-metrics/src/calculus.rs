//! The calculus of constants: what is known of a metric that is built from others.
//!
//! Each rule bounds `H`, `DH` and `D²H` of the new metric by the product and the chain rule. The
//! results are rounded to the nearest `f64`, as closed forms are elsewhere: a bound may be
//! too small by a few ulp.

use crate::{Constants, HypothesisError};

impl Constants {
    /// Returns the constants of `s H`: all of them times `s`. It is isotropic if `H` is.
    ///
    /// Overestimation: none.
    ///
    /// # Errors
    ///
    /// [`HypothesisError::NotAFactor`] unless `s` is positive and finite; the clause that
    /// fails if a constant overflows, or `c₁` underflows.
    pub fn scaled(self, s: f64) -> Result<Constants, HypothesisError> {
        if !(s > 0.0 && s.is_finite()) {
            return Err(HypothesisError::NotAFactor { factor: s });
        }
        let m_h = self.m_h().map(|m_h| m_h * s);
        let scaled = Constants::new(self.c1() * s, self.c2() * s, self.l_h() * s)?;
        scaled.with_known(m_h, self.is_isotropic(), self.is_local())
    }

    /// Returns the constants of `H + H′`, both on the same `R^D`: the sums.
    ///
    /// `M_H` is known if both are; the sum is isotropic if both are.
    ///
    /// Overestimation: none where both metrics attain a constant at the same point in the same
    /// directions, as `H` and `s H` do; else as much as they miss that.
    ///
    /// # Errors
    ///
    /// The clause that fails if a sum overflows.
    pub fn plus(self, other: Constants) -> Result<Constants, HypothesisError> {
        let m_h = self.m_h().zip(other.m_h()).map(|(a, b)| a + b);
        Constants::new(self.c1() + other.c1(), self.c2() + other.c2(), self.l_h() + other.l_h())?
            .with_known(
                m_h,
                self.is_isotropic() && other.is_isotropic(),
                self.is_local() || other.is_local(),
            )
    }

    /// Returns the constants of the product, `diag(H(x), H′(y))` on pairs `(x, y)`: the lesser
    /// `c₁`, and the greater of each of the others.
    ///
    /// `M_H` is known if both are; isotropic it is not. The norm of a block-diagonal matrix is that
    /// of its larger block, and `DH[w]` and `D²H[w, w]` are largest for a `w` that moves one point
    /// alone.
    ///
    /// Overestimation: none.
    #[doc(alias = "product")]
    #[must_use]
    pub fn beside(self, other: Constants) -> Constants {
        let m_h = self.m_h().zip(other.m_h()).map(|(a, b)| a.max(b));
        let (c1, c2) = (self.c1().min(other.c1()), self.c2().max(other.c2()));
        Constants::new(c1, c2, self.l_h().max(other.l_h()))
            .and_then(|constants| {
                constants.with_known(m_h, false, self.is_local() || other.is_local())
            })
            .expect("either is in order, so the lesser c1 is below the greater c2")
    }

    /// Returns the constants of `φ H` for a function `φ`, where `factor` are the constants of
    /// `φ I`:
    ///
    /// ```text
    /// φ_min c₁,    φ_max c₂,    φ_max L_H + Lip(φ) c₂,    φ_max M_H + 2 Lip(φ) L_H + Lip(Dφ) c₂
    /// ```
    ///
    /// - `factor`: with `c₁ = φ_min`, `c₂ = φ_max`, `L_H = Lip(φ)` in `1/ℓ` and `M_H = Lip(Dφ)`
    ///   in `1/ℓ²`, for a `φ` without unit. `M_H` is known if both are. `φ H` is isotropic if `H`
    ///   is.
    ///
    /// Overestimation: none if `φ` or `H` is constant. Otherwise `L_H` is not attained by a smooth
    /// `φ`, which has no slope where it has its maximum; two tents with one tip come as near as one
    /// likes.
    ///
    /// # Errors
    ///
    /// The clause that fails if a constant overflows, or `c₁` underflows.
    pub fn conformal(self, factor: Constants) -> Result<Constants, HypothesisError> {
        let l_h = factor.c2() * self.l_h() + factor.l_h() * self.c2();
        // D²(φH)[w, w] = φ D²H[w, w] + 2 Dφ[w] DH[w] + D²φ[w, w] H.
        let m_h = self.m_h().zip(factor.m_h()).map(|(m_h, lip2)| {
            factor.c2() * m_h + 2.0 * factor.l_h() * self.l_h() + lip2 * self.c2()
        });
        Constants::new(factor.c1() * self.c1(), factor.c2() * self.c2(), l_h)?.with_known(
            m_h,
            self.is_isotropic(),
            self.is_local() || factor.is_local(),
        )
    }

    /// Returns the constants of the pullback `x ↦ Aᵀ H(A x + b) A` by an affine map:
    ///
    /// ```text
    /// c₁ σ_min²,    c₂ σ_max²,    L_H σ_max³,    M_H σ_max⁴
    /// ```
    ///
    /// - `smin`, `smax`: bounds of the singular values of `A`, in units of the old coordinates
    ///   per new one. `A` need not be square, but `σ_min` must bound `|A u| / |u|` for every `u`.
    ///   If they are the same, the pullback is isotropic where `H` is.
    ///
    /// Overestimation: none if `A` is a multiple of an isometry; for other `A`, none if the
    /// direction that `A` stretches most (for `c₁`: least) is mapped to one where `H` attains its
    /// constants.
    ///
    /// # Errors
    ///
    /// [`HypothesisError::NotStretches`] unless `0 < σ_min ≤ σ_max < ∞`; the clause that fails
    /// if a constant overflows, or `c₁` underflows.
    pub fn pulled_back(self, smin: f64, smax: f64) -> Result<Constants, HypothesisError> {
        if !(smin > 0.0 && smin <= smax && smax.is_finite()) {
            return Err(HypothesisError::NotStretches { smin, smax });
        }
        // From the left, so that a constant that is 0 stays 0 where a power of σ_max alone
        // would overflow.
        let power = |constant: f64, s: f64, n: usize| (0..n).fold(constant, |y, _| y * s);
        let m_h = self.m_h().map(|m_h| power(m_h, smax, 4));
        Constants::new(
            power(self.c1(), smin, 2),
            power(self.c2(), smax, 2),
            power(self.l_h(), smax, 3),
        )?
        .with_known(m_h, self.is_isotropic() && smin == smax, self.is_local())
    }

    /// Returns the constants times these factors, in the order `c₁`, `c₂`, `L_H`, `M_H`; what else
    /// is known stays: in other units, or for a claim that is put to the test.
    ///
    /// # Errors
    ///
    /// The clause that fails.
    pub fn times(self, [c1, c2, l_h, m_h]: [f64; 4]) -> Result<Constants, HypothesisError> {
        Constants::new(self.c1() * c1, self.c2() * c2, self.l_h() * l_h)?.with_known(
            self.m_h().map(|known| known * m_h),
            self.is_isotropic(),
            self.is_local(),
        )
    }

    /// Adds `M_H` if there is one, and that the metric is isotropic, or its constants are local, if
    /// so it is.
    fn with_known(
        self,
        m_h: Option<f64>,
        isotropic: bool,
        local: bool,
    ) -> Result<Constants, HypothesisError> {
        let known = m_h.map_or(Ok(self), |m_h| self.with_m_h(m_h))?;
        let known = if isotropic { known.isotropic() } else { known };
        Ok(if local { known.on_a_region() } else { known })
    }
}

#[cfg(test)]
mod tests {
    use super::{Constants, HypothesisError};

    /// Small integers: every product below is exact.
    fn constants(c1: f64, c2: f64, l_h: f64, m_h: f64) -> Constants {
        Constants::new(c1, c2, l_h).and_then(|c| c.with_m_h(m_h)).expect("in order")
    }

    #[test]
    fn each_rule_has_its_formula() {
        let (h, g) = (constants(2.0, 5.0, 3.0, 7.0), constants(1.0, 11.0, 13.0, 4.0));
        assert_eq!(h.scaled(3.0), Ok(constants(6.0, 15.0, 9.0, 21.0)));
        assert_eq!(h.plus(g), Ok(constants(3.0, 16.0, 16.0, 11.0)));
        assert_eq!(h.beside(g), constants(1.0, 11.0, 13.0, 7.0));
        assert_eq!(h.beside(g), g.beside(h));
        // 11 · 3 + 13 · 5 and 11 · 7 + 2 · 13 · 3 + 4 · 5.
        assert_eq!(h.conformal(g), Ok(constants(2.0, 55.0, 98.0, 175.0)));
        assert_eq!(h.pulled_back(2.0, 3.0), Ok(constants(8.0, 45.0, 81.0, 567.0)));
        assert_eq!(h.times([0.5, 2.0, 3.0, 4.0]), Ok(constants(1.0, 10.0, 9.0, 28.0)));
    }

    /// `φ I = I · φ`, and `s H` is `φ H` for a constant `φ` and the pullback by `√s`.
    #[test]
    fn the_rules_agree_where_they_meet() {
        let (h, g) = (constants(2.0, 5.0, 3.0, 7.0), constants(1.0, 11.0, 13.0, 4.0));
        let flat = |s: f64| constants(s, s, 0.0, 0.0);
        assert_eq!(h.conformal(g), g.conformal(h));
        assert_eq!(flat(1.0).conformal(h), Ok(h));
        assert_eq!(h.conformal(flat(4.0)), h.scaled(4.0));
        assert_eq!(flat(3.0).pulled_back(2.0, 2.0), flat(3.0).scaled(4.0));
        assert_eq!(h.plus(h), h.scaled(2.0));
        assert_eq!(h.beside(h), h);
        let twice = h.pulled_back(2.0, 3.0).and_then(|c| c.pulled_back(0.5, 4.0));
        assert_eq!(twice, h.pulled_back(1.0, 12.0));
    }

    #[test]
    fn m_h_is_known_if_every_part_knows_it() {
        let known = constants(2.0, 5.0, 3.0, 7.0);
        let unknown = Constants::new(1.0, 2.0, 3.0).expect("in order");
        assert_eq!(unknown.scaled(2.0).expect("finite").m_h(), None);
        assert_eq!(unknown.times([1.0; 4]), Ok(unknown));
        assert_eq!(unknown.pulled_back(1.0, 2.0).expect("finite").m_h(), None);
        for (a, b) in [(known, unknown), (unknown, known)] {
            assert_eq!(a.plus(b).expect("finite").m_h(), None);
            assert_eq!(a.beside(b).m_h(), None);
            assert_eq!(a.conformal(b).expect("finite").m_h(), None);
        }
    }

    #[test]
    fn what_is_built_from_isotropic_metrics_is_isotropic_where_it_stays_so() {
        let general = constants(2.0, 5.0, 3.0, 7.0);
        let isotropic = general.isotropic();
        assert!(isotropic.scaled(2.0).expect("finite").is_isotropic());
        assert!(isotropic.times([1.0, 2.0, 0.0, 1.0]).expect("finite").is_isotropic());
        assert!(isotropic.plus(isotropic).expect("finite").is_isotropic());
        assert!(isotropic.conformal(general).expect("finite").is_isotropic());
        assert!(isotropic.pulled_back(2.0, 2.0).expect("finite").is_isotropic());
        assert!(!isotropic.pulled_back(1.0, 2.0).expect("finite").is_isotropic());
        assert!(!isotropic.beside(isotropic).is_isotropic());
        assert!(!general.scaled(2.0).expect("finite").is_isotropic());
        assert!(!general.conformal(isotropic).expect("finite").is_isotropic());
        assert!(!general.pulled_back(2.0, 2.0).expect("finite").is_isotropic());
        for (a, b) in [(general, isotropic), (isotropic, general)] {
            assert!(!a.plus(b).expect("finite").is_isotropic());
        }
    }

    #[test]
    fn what_is_built_from_local_constants_is_local() {
        let global = constants(2.0, 5.0, 3.0, 7.0);
        let local = global.on_a_region();
        assert!(local.scaled(2.0).expect("finite").is_local());
        assert!(local.pulled_back(1.0, 2.0).expect("finite").is_local());
        assert!(local.times([1.0; 4]).expect("finite").is_local());
        for (a, b) in [(global, local), (local, global)] {
            assert!(a.plus(b).expect("finite").is_local());
            assert!(a.beside(b).is_local());
            assert!(a.conformal(b).expect("finite").is_local());
        }
        assert!(!global.plus(global).expect("finite").is_local());
        assert!(!global.beside(global).is_local());
    }

    #[test]
    fn nonsense_is_refused_with_its_numbers() {
        let h = constants(2.0, 5.0, 3.0, 7.0);
        for s in [0.0, -1.0, f64::INFINITY] {
            assert_eq!(h.scaled(s), Err(HypothesisError::NotAFactor { factor: s }));
        }
        assert!(matches!(h.scaled(f64::NAN), Err(HypothesisError::NotAFactor { .. })));
        for (smin, smax) in [(0.0, 1.0), (-1.0, 1.0), (2.0, 1.0), (1.0, f64::INFINITY)] {
            assert_eq!(
                h.pulled_back(smin, smax),
                Err(HypothesisError::NotStretches { smin, smax })
            );
        }
        for (smin, smax) in [(f64::NAN, 1.0), (1.0, f64::NAN)] {
            let error = h.pulled_back(smin, smax).expect_err("NaN");
            assert!(matches!(error, HypothesisError::NotStretches { .. }), "{error}");
        }
    }

    /// Each overflow on its own, and the underflow of `c₁`; but `L_H = M_H = 0` stay 0.
    #[test]
    fn what_overflows_is_named() {
        let huge = 1e200;
        let crossed = |outcome: Result<Constants, HypothesisError>| {
            assert!(matches!(outcome, Err(HypothesisError::CrossedBounds { .. })), "{outcome:?}");
        };
        let steep = |outcome: Result<Constants, HypothesisError>| {
            assert!(matches!(outcome, Err(HypothesisError::NotLipschitz { .. })), "{outcome:?}");
        };
        let curved = |outcome: Result<Constants, HypothesisError>| {
            assert!(matches!(outcome, Err(HypothesisError::NotTwiceBounded { .. })), "{outcome:?}");
        };
        let flat = constants(1.0, 1.0, 0.0, 0.0);
        crossed(constants(1.0, huge, 0.0, 0.0).scaled(huge));
        crossed(constants(1.0, huge, 0.0, 0.0).pulled_back(1.0, huge));
        crossed(constants(1.0, huge, 0.0, 0.0).conformal(constants(1.0, huge, 0.0, 0.0)));
        crossed(constants(1.0, f64::MAX, 0.0, 0.0).plus(constants(1.0, f64::MAX, 0.0, 0.0)));
        steep(constants(1.0, 1.0, huge, 0.0).scaled(huge));
        steep(constants(1.0, 1.0, 1.0, 0.0).pulled_back(1.0, 1e110));
        steep(constants(1.0, huge, 0.0, 0.0).conformal(constants(1.0, 1.0, huge, 0.0)));
        steep(constants(1.0, 1.0, f64::MAX, 0.0).plus(constants(1.0, 1.0, f64::MAX, 0.0)));
        curved(constants(1.0, 1.0, 0.0, huge).scaled(huge));
        curved(constants(1.0, 1.0, 0.0, 1.0).pulled_back(1.0, 1e80));
        curved(constants(1.0, 1.0, huge, 0.0).conformal(constants(1.0, 1.0, huge, 0.0)));
        curved(constants(1.0, 1.0, 0.0, f64::MAX).plus(constants(1.0, 1.0, 0.0, f64::MAX)));
        let tiny = constants(1e-200, 1.0, 0.0, 0.0);
        assert_eq!(tiny.scaled(1e-200), Err(HypothesisError::NotCoercive { c1: 0.0 }));
        assert_eq!(flat.pulled_back(1e-200, 1.0), Err(HypothesisError::NotCoercive { c1: 0.0 }));
        assert_eq!(tiny.conformal(tiny), Err(HypothesisError::NotCoercive { c1: 0.0 }));
        assert_eq!(flat.pulled_back(1.0, 1e120), Ok(constants(1.0, 1e240, 0.0, 0.0)));
    }
}
