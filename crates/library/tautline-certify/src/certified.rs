//! `Certified`: a metric with constants proved from its formula.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::{Bounded, Constants, Metric};
use tautline_scalar::Scalar;

use crate::{Accuracy, CertifiedConstants, CertifyError, Domain};

/// A metric with constants on all of `R^D` that are proved from its formula. It serves metrics that
/// do not declare constants. A proof holds in dimension `D` only, even if the formula works in
/// others.
///
/// ```
/// use nalgebra::{SMatrix, SVector, matrix};
/// use tautline_certify::{Certified, Accuracy};
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
/// let constants = Certified::new(Egg, Accuracy::default())?.constants();
/// // H is smallest at (π, 3π/2): 1 on the diagonal and 0.3 off it.
/// assert!(constants.c1() <= 0.7 && constants.c1() > 0.699);
/// # Ok::<(), tautline_certify::CertifyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certified<M, const D: usize> {
    metric: M,
    constants: Constants,
}

impl<M: Metric<D>, const D: usize> Certified<M, D> {
    /// Proves the constants on [`Domain::space`].
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotAllOfSpace`] if the formula does not show what happens far out along some
    /// coordinate; then see [`Certified::settled`] and
    /// [`LocallyCertified`](crate::LocallyCertified). Otherwise the errors of
    /// [`CertifiedConstants::new`].
    pub fn new(metric: M, accuracy: Accuracy) -> Result<Self, CertifyError> {
        Formula::record(&metric)
            .and_then(|formula| formula.symmetric().map(|_| ()))
            .map_err(CertifyError::NotRecorded)?;
        let space = Domain::space(&metric);
        if !space.is_all_of_space() {
            return Err(CertifyError::NotAllOfSpace);
        }
        let constants = CertifiedConstants::new(&metric, &space, accuracy)?.constants()?;
        Ok(Self { metric, constants })
    }

    /// Proves the constants on [`Domain::settled_space`]. By calling this, you declare that the
    /// metric settles.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotSettled`] if the check fails; otherwise the errors of
    /// [`CertifiedConstants::new`].
    pub fn settled(metric: M, accuracy: Accuracy) -> Result<Self, CertifyError> {
        let space = Domain::settled_space(&metric)?;
        let constants = CertifiedConstants::new(&metric, &space, accuracy)?.constants()?;
        Ok(Self { metric, constants })
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        &self.metric
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for Certified<M, D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(x)
    }
}

impl<M: Metric<D>, const D: usize> Bounded<D> for Certified<M, D> {
    fn constants(&self) -> Constants {
        self.constants
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use tautline_metrics::{
        Bounded, Metric,
        gallery::{GaussianFisher, Valleys},
    };

    use tautline_scalar::Scalar;

    use super::Certified;
    use tautline_formula::RecordError;

    use crate::{
        Accuracy, CertifyError, Domain, Quantity, certify,
        testing::{Branch, parsed},
    };

    #[test]
    fn a_periodic_metric_needs_no_declaration() {
        let proved = Certified::<_, 2>::new(Valleys, Accuracy::default()).expect("constants");
        let (proved, stated) =
            (Bounded::<2>::constants(&proved), Bounded::<2>::constants(&Valleys));
        assert!(proved.c1() <= stated.c1() && proved.c2() >= stated.c2());
        assert!(proved.l_h() >= stated.l_h() && proved.m_h() >= stated.m_h());
        assert!(!proved.is_local() && proved.is_isotropic());
    }

    /// The formula works in every dimension; a proof in one says nothing about another.
    #[test]
    fn a_proof_belongs_to_its_dimension() {
        struct Growing;
        impl<const D: usize> Metric<D> for Growing {
            fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
                SMatrix::from_fn(
                    |i, j| {
                        if i == j { x[0].cos() + (2 + i) as f64 } else { S::zero() }
                    },
                )
            }
        }
        let line = Certified::<_, 1>::new(Growing, Accuracy::default()).expect("constants");
        let plane = Certified::<_, 2>::new(Growing, Accuracy::default()).expect("constants");
        assert!((3.0..3.01).contains(&line.constants().c2()));
        assert!((4.0..4.01).contains(&plane.constants().c2()));
        assert!(line.constants().is_isotropic() && !plane.constants().is_isotropic());
    }

    /// Intervals would follow only one branch.
    #[test]
    fn nothing_is_proved_of_a_formula_with_branches() {
        let why = CertifyError::NotRecorded(RecordError::Compares);
        let accuracy = Accuracy::default();
        let refused = [Certified::new(Branch, accuracy), Certified::settled(Branch, accuracy)];
        for refused in refused {
            assert_eq!(refused.map(|_| ()), Err(why.clone()));
        }
        let space = Domain::space(&Branch);
        assert!(!space.is_all_of_space() && space.bounding_cell().sides()[0].width() > 1.0);
        assert_eq!(certify(&Branch, Quantity::C2, &space, accuracy), Err(why));
    }

    #[test]
    fn a_metric_with_rational_parts_must_be_declared_to_settle() {
        let bump = || parsed::<2>("1 + 1/(1 + sqr(x1) + sqr(x2)) I");
        let refused = Certified::<_, 2>::new(bump(), Accuracy::default());
        assert_eq!(refused, Err(CertifyError::NotAllOfSpace));
        let settled = Certified::<_, 2>::settled(bump(), Accuracy::default()).expect("constants");
        let constants = Bounded::<2>::constants(&settled);
        assert!(!constants.is_local() && constants.c2() >= 2.0 && constants.c2() < 2.01);
        let error = Certified::settled(GaussianFisher, Accuracy::default()).expect_err("it grows");
        assert!(matches!(error, CertifyError::NotSettled { .. }), "{error}");
    }
}
