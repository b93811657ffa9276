//! `RayleighQuotient`: `wᵀ H(x) w / |w|²`, enclosed.

use nalgebra::{DMatrix, SVector};
use tautline_scalar::{Interval, Scalar};

use crate::Metric;

/// The quotient `wᵀ H(x) w / |w|²` of one direction. The least eigenvalue of `H(x)` is no larger, and the
/// greatest no smaller.
#[derive(Clone, Debug, PartialEq)]
pub struct RayleighQuotient {
    /// The direction `w`; its largest entry is 1.
    pub direction: Vec<f64>,
    /// Rigorous bounds on the quotient; undefined for a metric that is known by its values in `f64`.
    pub value: Interval,
}

impl RayleighQuotient {
    /// Returns quotients near the least and the greatest eigenvalue of `H(x)`: in the directions that
    /// are eigenvectors in `f64`. `None` if an entry of `H(x)` is not finite.
    ///
    /// The quotients are enclosed, so that they prove what is wrong with a claim about the eigenvalues
    /// where `f64` alone shows rounding.
    ///
    /// ```
    /// use tautline_metrics::{RayleighQuotient, gallery::Ramp};
    ///
    /// let [least, greatest] = RayleighQuotient::extreme(&Ramp::new(0.5, 1.0)?, &[0.0].into()).ok_or("finite")?;
    /// assert_eq!([least.value.lo(), greatest.value.hi()], [1.0, 1.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn extreme<const D: usize>(
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
    ) -> Option<[Self; 2]> {
        let enclosed = metric.gram(&x.map(Interval::point));
        Self::extreme_of(metric.gram(x).as_slice(), enclosed.as_slice(), D)
    }

    /// Does the same, given the `d²` numbers of `H(x)` and their enclosures, column by column.
    ///
    /// # Panics
    ///
    /// If there are fewer numbers.
    #[must_use]
    pub fn extreme_of(h: &[f64], enclosed: &[Interval], d: usize) -> Option<[Self; 2]> {
        // On other matrices nalgebra would iterate forever.
        if !h.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let half = |i: usize, j: usize| 0.5 * h[j * d + i];
        let eigen = DMatrix::from_fn(d, d, |i, j| half(i, j) + half(j, i)).symmetric_eigen();
        let quotient = |k: usize| {
            let column = eigen.eigenvectors.column(k);
            let largest = column[column.icamax()];
            // So scaled, the direction in which a singular matrix of short numbers vanishes is exact.
            let direction: Vec<f64> = column.iter().map(|entry| entry / largest).collect();
            let mut form = Interval::constant(0.0);
            let mut square = Interval::constant(0.0);
            for (i, &wi) in direction.iter().enumerate() {
                square += Interval::point(wi).sqr();
                for (j, &wj) in direction.iter().enumerate() {
                    form += enclosed[j * d + i] * wi * wj;
                }
            }
            Self { direction, value: form / square }
        };
        Some([quotient(eigen.eigenvalues.imin()), quotient(eigen.eigenvalues.imax())])
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use tautline_scalar::Scalar;

    use super::RayleighQuotient;
    use crate::{Metric, gallery::Constant};

    /// In `f64` the first entry is 0 at `x₁ = 1/4`, and in truth it is 1/4.
    struct Cancelled;

    impl Metric<2> for Cancelled {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let entry = (x[0] + 1e17) - 1e17;
            SMatrix::from_diagonal(&SVector::from([entry, S::constant(1.0)]))
        }
    }

    #[test]
    fn a_quotient_contains_the_eigenvalue_that_rounding_loses() {
        let [least, greatest] =
            RayleighQuotient::extreme(&Cancelled, &[0.25, 0.0].into()).expect("finite");
        assert!(least.value.lo() <= 0.25 && 0.25 <= least.value.hi(), "{least:?}");
        assert_eq!((greatest.value.lo(), greatest.value.hi()), (1.0, 1.0));
        assert_eq!(greatest.direction, [0.0, 1.0]);
    }

    /// Both halves count: the symmetric part of `(2 0; 2 2)` is `(2 1; 1 2)`.
    #[test]
    fn both_halves_of_a_matrix_count() {
        struct Torn;
        impl Metric<2> for Torn {
            fn gram<S: Scalar>(&self, _: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
                SMatrix::<f64, 2, 2>::new(2.0, 0.0, 2.0, 2.0).map(S::constant)
            }
        }
        let [least, greatest] =
            RayleighQuotient::extreme(&Torn, &[0.0, 0.0].into()).expect("finite");
        for (quotient, eigenvalue) in [(least, 1.0), (greatest, 3.0)] {
            assert!((quotient.value.midpoint() - eigenvalue).abs() < 4e-15, "{quotient:?}");
        }
    }

    /// `(2 1; 1 2)` has the eigenvalues 1 and 3.
    #[test]
    fn the_quotients_of_eigenvectors_are_the_eigenvalues() {
        let metric = Constant::<2>::new([[2.0, 1.0], [1.0, 2.0]].into()).expect("definite");
        let found = RayleighQuotient::extreme(&metric, &[0.0, 0.0].into()).expect("finite");
        for (quotient, eigenvalue) in found.iter().zip([1.0, 3.0]) {
            // Four products and their sum, of numbers up to 6.
            assert!((quotient.value.midpoint() - eigenvalue).abs() < 4e-15, "{quotient:?}");
            assert!(quotient.value.lo() <= eigenvalue + 1e-15 && quotient.value.width() < 1e-14);
        }
    }
}
