//! `CertifiedConstants`: enclosures of the four constants of a metric.

use tautline_formula::AnyMetric;
use tautline_metrics::{Constants, Metric};

use super::{CertifiedConstant, Quantity, enclose};
use crate::{Accuracy, CertifyError, Domain, formula::is_isotropic};

/// Enclosures of the four constants of a metric on a domain, proved from its formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertifiedConstants<const D: usize> {
    c1: CertifiedConstant<D>,
    c2: CertifiedConstant<D>,
    l_h: CertifiedConstant<D>,
    m_h: CertifiedConstant<D>,
    all_of_space: bool,
    isotropic: bool,
}

impl<const D: usize> CertifiedConstants<D> {
    /// Encloses the four constants of `metric` on `domain`.
    ///
    /// ```
    /// use tautline_certify::{CertifiedConstants, Domain, Accuracy};
    /// use tautline_metrics::gallery::Valleys;
    ///
    /// let space = Domain::<2>::space(&Valleys);
    /// let proved = CertifiedConstants::new(&Valleys, &space, Accuracy::default())?.constants()?;
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
    pub fn new(
        metric: &impl Metric<D>,
        domain: &Domain<D>,
        accuracy: Accuracy,
    ) -> Result<Self, CertifyError> {
        Self::enclosed(metric, domain, accuracy, |_, _, reached| reached)
    }

    /// Encloses the constants like [`new`](Self::new), but accepts bounds that are wider than the
    /// tolerance once the budget is spent. They are constants all the same.
    ///
    /// ```
    /// use tautline_certify::{CertifiedConstants, Domain, Accuracy};
    /// use tautline_metrics::gallery::Sphere;
    ///
    /// let ball = Domain::<2>::ball([0.3, 0.0], 0.5)?;
    /// let few = Accuracy { tolerance: 1e-9, budget: 500 };
    /// assert!(CertifiedConstants::new(&Sphere, &ball, few).is_err());
    /// let proved = CertifiedConstants::within_budget(&Sphere, &ball, few)?.constants()?;
    /// let c1 = 4.0 / 1.64_f64.powi(2); // 4 / (1 + |x|²)² at the rim
    /// assert!(proved.c1() <= c1 && proved.c1() > 0.98 * c1);
    /// # Ok::<(), tautline_certify::CertifyError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new), but [`CertifyError::BudgetSpent`] only if `c₁` is not known to be
    /// positive, or if another constant has no upper bound.
    pub fn within_budget(
        metric: &impl Metric<D>,
        domain: &Domain<D>,
        accuracy: Accuracy,
    ) -> Result<Self, CertifyError> {
        Self::enclosed(metric, domain, accuracy, |quantity, constant, _| match quantity {
            Quantity::C1 => constant.lower > 0.0,
            Quantity::C2 | Quantity::LH | Quantity::MH => constant.upper.is_finite(),
        })
    }

    fn enclosed(
        metric: &impl Metric<D>,
        domain: &Domain<D>,
        accuracy: Accuracy,
        is_enough: fn(Quantity, &CertifiedConstant<D>, bool) -> bool,
    ) -> Result<Self, CertifyError> {
        let metric = &AnyMetric::new(metric);
        let of = |quantity| {
            let (constant, reached) = enclose(metric, quantity, domain, accuracy)?;
            let is_enough = is_enough(quantity, &constant, reached);
            if is_enough { Ok(constant) } else { Err(constant.spent(quantity)) }
        };
        Ok(Self {
            c1: of(Quantity::C1)?,
            c2: of(Quantity::C2)?,
            l_h: of(Quantity::LH)?,
            m_h: of(Quantity::MH)?,
            all_of_space: domain.represents_space_for(metric),
            isotropic: metric.formula().is_ok_and(is_isotropic),
        })
    }

    /// Returns `c₁`, in `m²/ℓ²`.
    #[must_use]
    pub fn c1(&self) -> CertifiedConstant<D> {
        self.c1
    }

    /// Returns `c₂`, in `m²/ℓ²`.
    #[must_use]
    pub fn c2(&self) -> CertifiedConstant<D> {
        self.c2
    }

    /// Returns `L_H`, in `m²/ℓ³`.
    #[must_use]
    pub fn l_h(&self) -> CertifiedConstant<D> {
        self.l_h
    }

    /// Returns `M_H`, in `m²/ℓ⁴`.
    #[must_use]
    pub fn m_h(&self) -> CertifiedConstant<D> {
        self.m_h
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
        let constants = Constants::new(self.c1.lower, self.c2.upper, self.l_h.upper)?
            .with_m_h(self.m_h.upper)?;
        let constants = if self.isotropic { constants.isotropic() } else { constants };
        Ok(if self.all_of_space { constants } else { constants.on_a_region() })
    }
}
