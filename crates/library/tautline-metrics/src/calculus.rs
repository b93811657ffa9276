//! The calculus of constants: how the constants of a composed metric follow from those of its
//! parts.
//!
//! Each rule bounds `H`, `DH` and `D²H` by the product rule and the chain rule. Results are rounded
//! to nearest, like the closed forms of the gallery, so a bound may be too small by a few ulps.

use crate::{Constants, HypothesisError};

impl Constants {
    /// Returns the constants of `s H`, which are those of `H` multiplied by `s`. The result is
    /// isotropic if `H` is.
    ///
    /// The rule is tight.
    ///
    /// # Errors
    ///
    /// [`HypothesisError::NotAFactor`] unless `s` is positive and finite; the violated hypothesis
    /// if a constant overflows or `c₁` underflows.
    pub fn scaled(self, s: f64) -> Result<Constants, HypothesisError> {
        if !(s > 0.0 && s.is_finite()) {
            return Err(HypothesisError::NotAFactor { factor: s });
        }
        let m_h = self.m_h().map(|m_h| m_h * s);
        let scaled = Constants::new(self.c1() * s, self.c2() * s, self.l_h() * s)?;
        scaled.with_known(m_h, self.is_isotropic(), self.is_local())
    }

    /// Returns the constants of `H + H′`, both on the same `R^D`, which are the sums of the
    /// constants.
    ///
    /// `M_H` is known if both are; the sum is isotropic if both are.
    ///
    /// The rule is tight if both metrics attain a constant at the same point in the same
    /// directions, as `H` and `s H` do.
    ///
    /// # Errors
    ///
    /// The violated hypothesis if a sum overflows.
    pub fn plus(self, other: Constants) -> Result<Constants, HypothesisError> {
        let m_h = self.m_h().zip(other.m_h()).map(|(a, b)| a + b);
        Constants::new(self.c1() + other.c1(), self.c2() + other.c2(), self.l_h() + other.l_h())?
            .with_known(
                m_h,
                self.is_isotropic() && other.is_isotropic(),
                self.is_local() || other.is_local(),
            )
    }

    /// Returns the constants of the product, `diag(H(x), H′(y))` on pairs `(x, y)`: the smaller
    /// `c₁`, and the larger of each of the other constants.
    ///
    /// `M_H` is known if both are; the product is not isotropic. The norm of a block-diagonal
    /// matrix is the larger of the norms of its blocks, and `DH[w]` and `D²H[w, w]` are largest for
    /// a `w` that moves only one of the two points.
    ///
    /// The rule is tight.
    #[doc(alias = "product")]
    #[must_use]
    pub fn beside(self, other: Constants) -> Constants {
        let m_h = self.m_h().zip(other.m_h()).map(|(a, b)| a.max(b));
        let (c1, c2) = (self.c1().min(other.c1()), self.c2().max(other.c2()));
        Constants::new(c1, c2, self.l_h().max(other.l_h()))
            .and_then(|constants| {
                constants.with_known(m_h, false, self.is_local() || other.is_local())
            })
            .expect("both are in order, so the lesser c1 is below the greater c2")
    }

    /// Returns the constants of `φ H` for a function `φ`, given the constants `factor` of `φ I`:
    ///
    /// ```text
    /// φ_min c₁,    φ_max c₂,    φ_max L_H + Lip(φ) c₂,    φ_max M_H + 2 Lip(φ) L_H + Lip(Dφ) c₂
    /// ```
    ///
    /// - `factor`: `c₁ = φ_min`, `c₂ = φ_max`, `L_H = Lip(φ)` in `1/ℓ` and `M_H = Lip(Dφ)` in
    ///   `1/ℓ²`, for a dimensionless `φ`.
    ///
    /// `M_H` is known if both are; `φ H` is isotropic if `H` is.
    ///
    /// The rule is tight if `φ` or `H` is constant. Otherwise a smooth `φ` does not attain `L_H`,
    /// since its slope vanishes at its maximum; two tents with a common tip come arbitrarily close.
    ///
    /// # Errors
    ///
    /// The violated hypothesis if a constant overflows or `c₁` underflows.
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
    /// - `smin`, `smax`: bounds on the singular values of `A`, in old coordinates per new one. `A`
    ///   need not be square, but `σ_min` must bound `|A u| / |u|` from below for every `u`. If the
    ///   two are equal, the pullback is isotropic if `H` is.
    ///
    /// The rule is tight if `A` is a multiple of an isometry, or if `A` maps the direction that it
    /// stretches most (for `c₁`: least) to a direction in which `H` attains its constants.
    ///
    /// # Errors
    ///
    /// [`HypothesisError::NotStretches`] unless `0 < σ_min ≤ σ_max < ∞`; the violated hypothesis if
    /// a constant overflows or `c₁` underflows.
    pub fn pulled_back(self, smin: f64, smax: f64) -> Result<Constants, HypothesisError> {
        if !(smin > 0.0 && smin <= smax && smax.is_finite()) {
            return Err(HypothesisError::NotStretches { smin, smax });
        }
        // The product starts from the constant, so that a constant equal to 0 stays 0 even where a
        // power of σ_max alone would overflow.
        let power = |constant: f64, s: f64, n: usize| (0..n).fold(constant, |y, _| y * s);
        let m_h = self.m_h().map(|m_h| power(m_h, smax, 4));
        Constants::new(
            power(self.c1(), smin, 2),
            power(self.c2(), smax, 2),
            power(self.l_h(), smax, 3),
        )?
        .with_known(m_h, self.is_isotropic() && smin == smax, self.is_local())
    }

    /// Returns `c₁`, `c₂`, `L_H` and `M_H` multiplied by these factors: a change of units, or a
    /// false claim for a test. The flags do not change.
    ///
    /// # Errors
    ///
    /// The violated hypothesis.
    pub fn times(self, [c1, c2, l_h, m_h]: [f64; 4]) -> Result<Constants, HypothesisError> {
        Constants::new(self.c1() * c1, self.c2() * c2, self.l_h() * l_h)?.with_known(
            self.m_h().map(|known| known * m_h),
            self.is_isotropic(),
            self.is_local(),
        )
    }

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

    /// The constants are small integers, so every product below is exact.
    fn constants(c1: f64, c2: f64, l_h: f64, m_h: f64) -> Constants {
        Constants::new(c1, c2, l_h).and_then(|c| c.with_m_h(m_h)).expect("in order")
    }

    #[test]
    fn each_rule_has_its_formula() {
        let (h, g) = (constants(2.0, 5.0, 3.0, 7.0), constants(1.0, 11.0, 13.0, 4.0));
        assert_eq!(h.scaled(3.0), Ok(constants(6.0, 15.0, 9.0, 21.0)));
        assert_eq!(h.plus(g), Ok(constants(3.0, 16.0, 16.0, 11.0)));
        assert_eq!(h.beside(g), constants(1.0, 11.0, 13.0, 7.0));
        assert_eq!(h.beside(h), h);
        // 11 · 3 + 13 · 5 = 98 and 11 · 7 + 2 · 13 · 3 + 4 · 5 = 175.
        assert_eq!(h.conformal(g), Ok(constants(2.0, 55.0, 98.0, 175.0)));
        assert_eq!(h.pulled_back(2.0, 3.0), Ok(constants(8.0, 45.0, 81.0, 567.0)));
        assert_eq!(h.times([0.5, 2.0, 3.0, 4.0]), Ok(constants(1.0, 10.0, 9.0, 28.0)));
    }

    /// `φ I` and `I · φ` have the same constants. For a constant `φ = s`, so do `φ H`, `s H` and
    /// the pullback by `√s`.
    #[test]
    fn the_rules_agree_where_they_meet() {
        let (h, g) = (constants(2.0, 5.0, 3.0, 7.0), constants(1.0, 11.0, 13.0, 4.0));
        let flat = |s: f64| constants(s, s, 0.0, 0.0);
        assert_eq!(h.beside(g), g.beside(h));
        assert_eq!(h.conformal(g), g.conformal(h));
        assert_eq!(flat(1.0).conformal(h), Ok(h));
        assert_eq!(h.conformal(flat(4.0)), h.scaled(4.0));
        assert_eq!(flat(3.0).pulled_back(2.0, 2.0), flat(3.0).scaled(4.0));
        assert_eq!(h.plus(h), h.scaled(2.0));
        let twice = h.pulled_back(2.0, 3.0).and_then(|c| c.pulled_back(0.5, 4.0));
        assert_eq!(twice, h.pulled_back(1.0, 12.0));
    }

    /// Applies each rule for one metric: scaling, pulling back by a similarity or another map, and
    /// a change of units.
    fn alone(h: Constants) -> [Constants; 4] {
        [h.scaled(2.0), h.pulled_back(2.0, 2.0), h.pulled_back(1.0, 2.0), h.times([1.0; 4])]
            .map(|outcome| outcome.expect("finite"))
    }

    /// Applies each rule for two metrics.
    fn together(a: Constants, b: Constants) -> [Constants; 3] {
        [a.plus(b).expect("finite"), a.beside(b), a.conformal(b).expect("finite")]
    }

    #[test]
    fn m_h_is_known_if_every_part_knows_it() {
        let known = constants(2.0, 5.0, 3.0, 7.0);
        let unknown = Constants::new(1.0, 2.0, 3.0).expect("in order");
        assert_eq!(alone(known).map(|c| c.m_h().is_some()), [true; 4]);
        assert_eq!(alone(unknown).map(|c| c.m_h().is_some()), [false; 4]);
        assert_eq!(unknown.times([1.0; 4]), Ok(unknown));
        assert_eq!(together(known, known).map(|c| c.m_h().is_some()), [true; 3]);
        for (a, b) in [(known, unknown), (unknown, known)] {
            assert_eq!(together(a, b).map(|c| c.m_h().is_some()), [false; 3]);
        }
    }

    #[test]
    fn isotropy_passes_through_all_rules_but_slanted_maps_and_products() {
        let general = constants(2.0, 5.0, 3.0, 7.0);
        let isotropic = general.isotropic();
        let flags = |found: [Constants; 4]| found.map(|c| c.is_isotropic());
        assert_eq!(flags(alone(isotropic)), [true, true, false, true]);
        assert_eq!(flags(alone(general)), [false; 4]);
        // A conformal factor is always isotropic, whether or not it is marked.
        for (a, b, expected) in [
            (isotropic, isotropic, [true, false, true]),
            (isotropic, general, [false, false, true]),
            (general, isotropic, [false; 3]),
        ] {
            assert_eq!(together(a, b).map(|c| c.is_isotropic()), expected);
        }
    }

    #[test]
    fn constants_are_local_if_those_of_any_part_are() {
        let global = constants(2.0, 5.0, 3.0, 7.0);
        let local = global.on_a_region();
        assert_eq!(alone(local).map(|c| c.is_local()), [true; 4]);
        assert_eq!(alone(global).map(|c| c.is_local()), [false; 4]);
        for (a, b) in [(global, local), (local, global)] {
            assert_eq!(together(a, b).map(|c| c.is_local()), [true; 3]);
        }
        assert_eq!(together(global, global).map(|c| c.is_local()), [false; 3]);
    }

    #[test]
    fn bad_factors_and_stretches_are_refused_with_their_numbers() {
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

    /// Each constant overflows on its own, and `c₁` underflows; but `L_H = M_H = 0` stay 0.
    #[test]
    fn the_constant_that_overflows_is_named() {
        let huge = 1e200;
        let flat = constants(1.0, 1.0, 0.0, 0.0);
        let c2 = |c2| constants(1.0, c2, 0.0, 0.0);
        let l_h = |l_h| constants(1.0, 1.0, l_h, 0.0);
        let m_h = |m_h| constants(1.0, 1.0, 0.0, m_h);
        for outcome in [
            c2(huge).scaled(huge),
            c2(huge).pulled_back(1.0, huge),
            c2(huge).conformal(c2(huge)),
            c2(f64::MAX).plus(c2(f64::MAX)),
        ] {
            assert!(matches!(outcome, Err(HypothesisError::CrossedBounds { .. })), "{outcome:?}");
        }
        for outcome in [
            l_h(huge).scaled(huge),
            l_h(1.0).pulled_back(1.0, 1e110),
            c2(huge).conformal(l_h(huge)),
            l_h(f64::MAX).plus(l_h(f64::MAX)),
        ] {
            assert!(matches!(outcome, Err(HypothesisError::NotLipschitz { .. })), "{outcome:?}");
        }
        for outcome in [
            m_h(huge).scaled(huge),
            m_h(1.0).pulled_back(1.0, 1e80),
            l_h(huge).conformal(l_h(huge)),
            m_h(f64::MAX).plus(m_h(f64::MAX)),
        ] {
            assert!(matches!(outcome, Err(HypothesisError::NotTwiceBounded { .. })), "{outcome:?}");
        }
        let tiny = constants(1e-200, 1.0, 0.0, 0.0);
        for outcome in [tiny.scaled(1e-200), flat.pulled_back(1e-200, 1.0), tiny.conformal(tiny)] {
            assert_eq!(outcome, Err(HypothesisError::NotCoercive { c1: 0.0 }));
        }
        assert_eq!(flat.pulled_back(1.0, 1e120), Ok(constants(1.0, 1e240, 0.0, 0.0)));
    }
}
