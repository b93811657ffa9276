//! `CertifiedConstants`: enclosures of the four constants of a metric.

use tautline_formula::Formula;
use tautline_metrics::{Constants, Metric};
use tautline_scalar::ANY;

use super::{CertifiedConstant, Quantity, certify_by_formula, enclose, recorded};
use crate::{Accuracy, CertifyError, Domain, Watch, formula::is_isotropic, progress::unwatched};

/// Enclosures of the four constants of a metric on a domain, proved from its formula.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CertifiedConstants {
    c1: CertifiedConstant,
    c2: CertifiedConstant,
    l_h: CertifiedConstant,
    m_h: Option<CertifiedConstant>,
    all_of_space: bool,
    isotropic: bool,
}

/// What becomes of constants without `M_H`.
#[derive(Clone, Copy)]
enum MH {
    /// They are refused.
    Required,
    /// They serve.
    Welcome,
    /// They serve, and `M_H` is not searched for.
    Useless,
}

impl CertifiedConstants {
    /// Encloses the four constants of `metric` on `domain`.
    ///
    /// ```
    /// use tautline_certify::{CertifiedConstants, Domain, Accuracy};
    /// use tautline_metrics::gallery::Valleys;
    ///
    /// let space = Domain::space::<2>(&Valleys);
    /// let proved = CertifiedConstants::new::<2>(&Valleys, &space, Accuracy::default())?.constants()?;
    /// assert!(proved.c1() <= 1.0 && proved.c1() > 0.999);
    /// assert!(proved.l_h() >= 4.40366947504161167615 && proved.l_h() < 4.41);
    /// assert!(!proved.is_local());
    /// # Ok::<(), tautline_certify::CertifyError>(())
    /// ```
    ///
    /// The constants hold on all of `R^D` only if the domain represents all of space for this
    /// metric. It does not matter for which metric the domain was made.
    ///
    /// # Errors
    ///
    /// The error of [`certify`](super::certify) for the first constant that fails.
    pub fn new<const D: usize>(
        metric: &impl Metric<D>,
        domain: &Domain,
        accuracy: Accuracy,
    ) -> Result<Self, CertifyError> {
        let formula = &recorded(metric)?;
        let of = |quantity| certify_by_formula(formula, quantity, domain, accuracy, &unwatched);
        Self::enclosed(formula, domain, of, MH::Required)
    }

    /// Encloses the constants like [`new`](Self::new), but accepts bounds that are wider than the
    /// tolerance once the budget is spent. They are constants all the same.
    ///
    /// ```
    /// use tautline_certify::{CertifiedConstants, Domain, Accuracy};
    /// use tautline_metrics::gallery::Sphere;
    ///
    /// let ball = Domain::ball([0.3, 0.0], 0.5)?;
    /// let few = Accuracy { tolerance: 1e-9, budget: 500 };
    /// assert!(CertifiedConstants::new::<2>(&Sphere, &ball, few).is_err());
    /// let proved = CertifiedConstants::within_budget::<2>(&Sphere, &ball, few)?.constants()?;
    /// let c1 = 4.0 / 1.64_f64.powi(2); // 4 / (1 + |x|²)² at the rim
    /// assert!(proved.c1() <= c1 && proved.c1() > 0.98 * c1);
    /// # Ok::<(), tautline_certify::CertifyError>(())
    /// ```
    ///
    /// Without an upper bound on `M_H` there are constants all the same, without `M_H`. Theorems that
    /// need it then do not apply.
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new), but [`CertifyError::BudgetSpent`] only if `c₁` is not known to be
    /// positive, or if `c₂` or `L_H` has no upper bound.
    pub fn within_budget<const D: usize>(
        metric: &impl Metric<D>,
        domain: &Domain,
        accuracy: Accuracy,
    ) -> Result<Self, CertifyError> {
        Self::within_budget_by_formula(&recorded(metric)?, domain, accuracy, &unwatched)
    }

    /// Encloses the constants like [`within_budget`](Self::within_budget), given the formula in a
    /// dimension that is a value, and tells `watch` of the progress. A search that `watch` ends counts as
    /// one that spent its budget.
    ///
    /// # Errors
    ///
    /// Those of [`within_budget`](Self::within_budget).
    pub fn within_budget_by_formula(
        formula: &Formula<ANY>,
        domain: &Domain,
        accuracy: Accuracy,
        watch: &dyn Watch,
    ) -> Result<Self, CertifyError> {
        let of = |quantity| {
            let (constant, _) = enclose(formula, quantity, domain, accuracy, watch)?;
            let is_enough = match quantity {
                Quantity::C1 => constant.lower > 0.0,
                Quantity::C2 | Quantity::LH | Quantity::MH => constant.upper.is_finite(),
            };
            if is_enough { Ok(constant) } else { Err(constant.spent(quantity)) }
        };
        let m_h = if watch.needs_m_h() { MH::Welcome } else { MH::Useless };
        Self::enclosed(formula, domain, of, m_h)
    }

    fn enclosed(
        formula: &Formula<ANY>,
        domain: &Domain,
        of: impl Fn(Quantity) -> Result<CertifiedConstant, CertifyError>,
        m_h: MH,
    ) -> Result<Self, CertifyError> {
        Ok(Self {
            c1: of(Quantity::C1)?,
            c2: of(Quantity::C2)?,
            l_h: of(Quantity::LH)?,
            m_h: match m_h {
                MH::Required => Some(of(Quantity::MH)?),
                MH::Welcome => of(Quantity::MH).ok(),
                MH::Useless => None,
            },
            all_of_space: domain.represents_space_for(formula),
            isotropic: is_isotropic(formula),
        })
    }

    /// Returns `c₁`, in `m²/ℓ²`.
    #[must_use]
    pub fn c1(&self) -> &CertifiedConstant {
        &self.c1
    }

    /// Returns `c₂`, in `m²/ℓ²`.
    #[must_use]
    pub fn c2(&self) -> &CertifiedConstant {
        &self.c2
    }

    /// Returns `L_H`, in `m²/ℓ³`.
    #[must_use]
    pub fn l_h(&self) -> &CertifiedConstant {
        &self.l_h
    }

    /// Returns `M_H`, in `m²/ℓ⁴`, or `None` if it has no upper bound
    /// [within the budget](Self::within_budget) or was [not needed](Watch::needs_m_h).
    #[must_use]
    pub fn m_h(&self) -> Option<&CertifiedConstant> {
        self.m_h.as_ref()
    }

    /// Returns the safe bounds as constants of the metric. They [hold on a
    /// region](Constants::is_local) unless the domain represents all of space, and they are
    /// [isotropic](Constants::is_isotropic) if the formula shows `H` to be a multiple of the
    /// identity.
    ///
    /// # Errors
    ///
    /// [`CertifyError::Hypothesis`] if a bound cannot serve as a constant; for example, `c₁` is not
    /// positive.
    pub fn constants(&self) -> Result<Constants, CertifyError> {
        let constants = Constants::new(self.c1.lower, self.c2.upper, self.l_h.upper)?;
        let constants = match &self.m_h {
            Some(m_h) => constants.with_m_h(m_h.upper)?,
            None => constants,
        };
        let constants = if self.isotropic { constants.isotropic() } else { constants };
        Ok(if self.all_of_space { constants } else { constants.on_a_region() })
    }
}
