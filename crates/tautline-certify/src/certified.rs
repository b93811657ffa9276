//! `Certified`: a metric with the constants that its formula proves.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Bounded, Constants, Metric};
use tautline_scalar::Scalar;

use crate::{CertifiedConstants, CertifyError, Domain, Effort};

/// A metric with the constants that its formula proves on all of `R^D`: for a metric whose author does not
/// state any.
///
/// ```
/// use nalgebra::{SMatrix, SVector, matrix};
/// use tautline_certify::{Certified, Effort};
/// use tautline_metrics::{Bounded, Metric};
/// use tautline_scalar::Scalar;
///
/// struct Egg;
/// impl Metric<2> for Egg {
///     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
///         let off = (x[0] + x[1]).sin() * 0.3;
///         matrix![x[0].cos() + 2.0, off; off, x[1].sin() * 0.5 + 1.5]
///     }
/// }
///
/// let constants = Certified::new(Egg, Effort::default())?.constants();
/// // H is least at (π, 3π/2): 1 on the diagonal and 0.3 beside it.
/// assert!(constants.c1() <= 0.7 && constants.c1() > 0.699);
/// # Ok::<(), tautline_certify::CertifyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certified<M> {
    metric: M,
    constants: Constants,
}

impl<M> Certified<M> {
    /// Proves the constants on [`Domain::space`].
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotAllOfSpace`] for a formula that is neither constant nor periodic along each
    /// coordinate: see [`Certified::settled`] and [`LocallyCertified`](crate::LocallyCertified). Else as
    /// [`CertifiedConstants::new`].
    pub fn new<const D: usize>(metric: M, effort: Effort) -> Result<Self, CertifyError>
    where
        M: Metric<D> + Sync,
    {
        let space = Domain::space(&metric);
        if !space.is_all_of_space() {
            return Err(CertifyError::NotAllOfSpace);
        }
        let constants = CertifiedConstants::new(&metric, &space, effort)?.constants()?;
        Ok(Self { metric, constants })
    }

    /// Proves the constants on [`Domain::settled_space`]: the caller declares that the metric settles.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotSettled`]; else as [`CertifiedConstants::new`].
    pub fn settled<const D: usize>(metric: M, effort: Effort) -> Result<Self, CertifyError>
    where
        M: Metric<D> + Sync,
    {
        let space = Domain::settled_space(&metric)?;
        let constants = CertifiedConstants::new(&metric, &space, effort)?.constants()?;
        Ok(Self { metric, constants })
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        &self.metric
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for Certified<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(x)
    }

    fn norm_squared<S: Scalar>(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> S {
        self.metric.norm_squared(x, u)
    }
}

impl<M: Metric<D>, const D: usize> Bounded<D> for Certified<M> {
    fn constants(&self) -> Constants {
        self.constants
    }
}

#[cfg(test)]
mod tests {
    use tautline_metrics::{
        Bounded,
        gallery::{GaussianFisher, Lens, Valleys},
    };

    use super::Certified;
    use crate::{CertifyError, Effort};

    #[test]
    fn a_periodic_metric_needs_no_word_of_its_author() {
        let proved = Certified::new::<2>(Valleys, Effort::default()).expect("constants");
        let (proved, stated) =
            (Bounded::<2>::constants(&proved), Bounded::<2>::constants(&Valleys));
        assert!(proved.c1() <= stated.c1() && proved.c2() >= stated.c2());
        assert!(proved.l_h() >= stated.l_h() && proved.m_h() >= stated.m_h());
        assert!(!proved.is_local() && proved.is_isotropic());
    }

    #[test]
    fn what_is_not_periodic_is_declared_to_settle_or_refused() {
        let lens = Lens::new(1.0, 1.0).expect("a width");
        let refused = Certified::new::<2>(lens, Effort::default());
        assert_eq!(refused, Err(CertifyError::NotAllOfSpace));
        let settled = Certified::settled::<2>(lens, Effort::default()).expect("constants");
        let constants = Bounded::<2>::constants(&settled);
        assert!(!constants.is_local() && constants.c2() >= 2.0 && constants.c2() < 2.01);
        let error = Certified::settled(GaussianFisher, Effort::default()).expect_err("it grows");
        assert!(matches!(error, CertifyError::NotSettled { .. }), "{error}");
    }
}
