//! `Constants`: the numbers `c₁`, `c₂`, `L_H` and `M_H` that describe a metric in the theorems.

/// The constants of Theorem 1.1, for all `x, y, u, w`:
///
/// ```text
/// c₁ |u|² ≤ uᵀ H(x) u ≤ c₂ |u|²,    ‖H(x) − H(y)‖ ≤ L_H |x − y|,    |uᵀ D²H(x)[w, w] u| ≤ M_H |w|² |u|²
/// ```
///
/// with the Euclidean norm of vectors and the operator norm of matrices. `M_H` is optional and not
/// in the paper. Neither is the flag for an isotropic metric, `H = φ I`, whose geodesics bend less.
///
/// Invariant: `0 < c₁ ≤ c₂ < ∞`, `0 ≤ L_H < ∞`, `0 ≤ M_H < ∞`. Every value is made by
/// [`Constants::new`], so a function that takes `Constants` need not check again.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Data")
)]
pub struct Constants {
    c1: f64,
    c2: f64,
    l_h: f64,
    m_h: Option<f64>,
    isotropic: bool,
    local: bool,
}

impl Constants {
    /// Checks the hypotheses in the paper's order; `c₁`, `c₂` in `m²/ℓ²`, `L_H` in `m²/ℓ³`.
    ///
    /// # Errors
    ///
    /// The first violated hypothesis, with its numbers.
    pub fn new(c1: f64, c2: f64, l_h: f64) -> Result<Constants, HypothesisError> {
        if !(c1 > 0.0 && c1.is_finite()) {
            return Err(HypothesisError::NotCoercive { c1 });
        }
        if !(c1 <= c2 && c2.is_finite()) {
            return Err(HypothesisError::CrossedBounds { c1, c2 });
        }
        if !(l_h >= 0.0 && l_h.is_finite()) {
            return Err(HypothesisError::NotLipschitz { l_h });
        }
        Ok(Constants { c1, c2, l_h, m_h: None, isotropic: false, local: false })
    }

    /// Adds `M_H`, in `m²/ℓ⁴`. A Lipschitz constant of `DH` will do.
    ///
    /// # Errors
    ///
    /// [`HypothesisError::NotTwiceBounded`] if it is negative, infinite or NaN.
    pub fn with_m_h(self, m_h: f64) -> Result<Constants, HypothesisError> {
        if !(m_h >= 0.0 && m_h.is_finite()) {
            return Err(HypothesisError::NotTwiceBounded { m_h });
        }
        Ok(Constants { m_h: Some(m_h), ..self })
    }

    /// Marks the metric as isotropic: `H(x) = φ(x) I` with a number `φ(x)`. Isotropic metrics are
    /// conformal to the Euclidean metric; every metric on the line is isotropic.
    #[doc(alias = "conformal")]
    #[must_use]
    pub fn isotropic(self) -> Constants {
        Constants { isotropic: true, ..self }
    }

    /// Marks the constants as valid on a region only, not for all `x` and `y`.
    #[must_use]
    pub fn on_a_region(self) -> Constants {
        Constants { local: true, ..self }
    }

    /// Returns `c₁`, in `m²/ℓ²`.
    #[must_use]
    pub fn c1(&self) -> f64 {
        self.c1
    }

    /// Returns `c₂`, in `m²/ℓ²`.
    #[must_use]
    pub fn c2(&self) -> f64 {
        self.c2
    }

    /// Returns the Lipschitz constant `L_H` of `H`, in `m²/ℓ³`.
    #[must_use]
    pub fn l_h(&self) -> f64 {
        self.l_h
    }

    /// Returns the bound `M_H` on the second derivatives of `H`, in `m²/ℓ⁴`, if it is known.
    #[must_use]
    pub fn m_h(&self) -> Option<f64> {
        self.m_h
    }

    /// Returns whether the metric is known to be isotropic.
    #[must_use]
    pub fn is_isotropic(&self) -> bool {
        self.isotropic
    }

    /// Returns whether the constants hold on a region only.
    #[must_use]
    pub fn is_local(&self) -> bool {
        self.local
    }
}

/// Constants as they are read with the feature `serde`, before they are checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Data {
    c1: f64,
    c2: f64,
    l_h: f64,
    #[serde(default)]
    m_h: Option<f64>,
    #[serde(default)]
    isotropic: bool,
    #[serde(default)]
    local: bool,
}

#[cfg(feature = "serde")]
impl TryFrom<Data> for Constants {
    type Error = HypothesisError;

    fn try_from(data: Data) -> Result<Self, HypothesisError> {
        let Data { c1, c2, l_h, m_h, isotropic, local } = data;
        let constants = Constants::new(c1, c2, l_h)?;
        let constants = m_h.map_or(Ok(constants), |m_h| constants.with_m_h(m_h))?;
        Ok(Constants { isotropic, local, ..constants })
    }
}

/// A hypothesis of Theorem 1.1, or of the calculus of constants, that the given numbers violate.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HypothesisError {
    /// `c₁ > 0` is violated; without it the energy does not control the speed.
    #[error("c1 = {c1} must be positive and finite (Theorem 1.1)")]
    NotCoercive {
        /// The constant that was given.
        c1: f64,
    },
    /// `c₁ ≤ c₂ < ∞` is violated.
    #[error("c2 = {c2} must be finite and at least c1 = {c1} (Theorem 1.1)")]
    CrossedBounds {
        /// The lower constant that was given.
        c1: f64,
        /// The upper constant that was given.
        c2: f64,
    },
    /// `L_H` is not a finite Lipschitz constant of `H`.
    #[error("L_H = {l_h} must be nonnegative and finite (Theorem 1.1)")]
    NotLipschitz {
        /// The constant that was given.
        l_h: f64,
    },
    /// `M_H` is not a finite bound on `D²H`.
    #[error("M_H = {m_h} must be nonnegative and finite")]
    NotTwiceBounded {
        /// The constant that was given.
        m_h: f64,
    },
    /// The factor is not positive and finite; `s H` is a metric only for `s > 0`.
    #[error("the factor {factor} of a metric must be positive and finite")]
    NotAFactor {
        /// The factor that was given.
        factor: f64,
    },
    /// The bounds on the singular values violate `0 < σ_min ≤ σ_max < ∞`, where `|A u|` lies
    /// between `σ_min |u|` and `σ_max |u|`.
    #[error(
        "the singular values of a map must lie between two positive finite numbers, \
         not between {smin} and {smax}"
    )]
    NotStretches {
        /// The lower bound that was given.
        smin: f64,
        /// The upper bound that was given.
        smax: f64,
    },
}

#[cfg(test)]
mod tests {
    use super::{Constants, HypothesisError};

    const INFINITE: f64 = f64::INFINITY;

    #[test]
    fn the_first_clause_that_fails_is_named() {
        let new = Constants::new;
        let not_coercive = |c1| Err(HypothesisError::NotCoercive { c1 });
        let crossed = |c1, c2| Err(HypothesisError::CrossedBounds { c1, c2 });
        let not_lipschitz = |l_h| Err(HypothesisError::NotLipschitz { l_h });
        assert_eq!(new(0.0, -1.0, -1.0), not_coercive(0.0));
        assert_eq!(new(0.0, 1.0, 0.0), not_coercive(0.0));
        assert_eq!(new(INFINITE, INFINITE, 0.0), not_coercive(INFINITE));
        assert_eq!(new(2.0, 1.0, -1.0), crossed(2.0, 1.0));
        assert_eq!(new(1.0, INFINITE, 0.0), crossed(1.0, INFINITE));
        assert_eq!(new(1.0, 1.0, -1.0), not_lipschitz(-1.0));
        assert_eq!(new(1.0, 1.0, INFINITE), not_lipschitz(INFINITE));
        for [c1, c2, l_h] in [[f64::NAN, 1.0, 0.0], [1.0, f64::NAN, 0.0], [1.0, 1.0, f64::NAN]] {
            assert!(new(c1, c2, l_h).is_err(), "{c1} {c2} {l_h}");
        }
        let constants = new(1.0, 9.0, 5.0).expect("in order");
        for bad in [f64::NAN, -1.0] {
            assert!(constants.with_m_h(bad).is_err(), "{bad}");
        }
        let infinite = Err(HypothesisError::NotTwiceBounded { m_h: INFINITE });
        assert_eq!(constants.with_m_h(INFINITE), infinite);
        // These are the extreme numbers that are still valid.
        assert!(new(1.0, 1.0, 0.0).and_then(|c| c.with_m_h(0.0)).is_ok());
        assert!(new(f64::from_bits(1), f64::MAX, f64::MAX).is_ok());
    }

    #[test]
    fn additions_commute_and_keep_each_other() {
        let bare = Constants::new(1.0, 9.0, 5.0).expect("in order");
        let bent = |c: Constants| c.with_m_h(6.0).expect("nonnegative");
        let (round, local) = (Constants::isotropic, Constants::on_a_region);
        assert!(bare.m_h().is_none() && !bare.is_isotropic() && !bare.is_local());
        let all = local(round(bent(bare)));
        assert!(all.is_local() && all.is_isotropic());
        assert_eq!((all.c1(), all.c2(), all.l_h(), all.m_h()), (1.0, 9.0, 5.0, Some(6.0)));
        for other in [
            round(local(bent(bare))),
            local(bent(round(bare))),
            bent(local(round(bare))),
            round(bent(local(bare))),
            bent(round(local(bare))),
        ] {
            assert_eq!(other, all);
        }
        assert!(all != local(bent(bare)) && all != round(bent(bare)) && all != local(round(bare)));
    }

    #[test]
    fn the_message_names_the_number_and_the_clause() {
        let error = Constants::new(-1.5, 1.0, 0.0).expect_err("c1 < 0");
        assert_eq!(error.to_string(), "c1 = -1.5 must be positive and finite (Theorem 1.1)");
    }
}
