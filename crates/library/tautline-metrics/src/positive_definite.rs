//! Symmetric positive definite matrices: the check that `H(x)` is one, and the Cholesky factor.

use nalgebra::{DMatrix, SMatrix, SVector};
use smallvec::SmallVec;
use tautline_scalar::Lanes;

use crate::Metric;

/// The reason why the Gram matrix at a point is not that of a metric.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MetricError {
    /// An entry of `H` is NaN or infinite.
    #[error(
        "H({point:?}) has the entry {entry} in row {}, column {}: it must be finite",
        row + 1, column + 1
    )]
    NotFinite {
        /// The point at which `H` was evaluated.
        point: Vec<f64>,
        /// The row of the entry, from 0.
        row: usize,
        /// The column of the entry, from 0.
        column: usize,
        /// The entry.
        entry: f64,
    },
    /// The two halves of `H` differ.
    #[error(
        "H({point:?}) is not symmetric: the entry in row {}, column {} is {above}, its mirror {below}",
        row + 1, column + 1
    )]
    NotSymmetric {
        /// The point at which `H` was evaluated.
        point: Vec<f64>,
        /// The row of the entry, from 0.
        row: usize,
        /// The column of the entry, from 0.
        column: usize,
        /// The entry above the diagonal.
        above: f64,
        /// The entry below the diagonal.
        below: f64,
    },
    /// `H` has an eigenvalue that is not positive.
    #[error("H({point:?}) is not positive definite: its least eigenvalue is {eigenvalue}")]
    NotPositiveDefinite {
        /// The point at which `H` was evaluated.
        point: Vec<f64>,
        /// The least eigenvalue of `H`, up to rounding.
        eigenvalue: f64,
    },
}

/// Returns whether a matrix is finite, symmetric up to rounding, and positive definite, in every
/// lane of its entries.
///
/// If the entries `(i, j)` and `(j, i)` are computed by the same formula in a different order, they
/// differ by a few roundings of its terms. For a positive definite `H` the terms are at most of
/// size `√(Hᵢᵢ Hⱼⱼ)`. The tolerance is `10⁻¹²` times this number, or times `|Hᵢⱼ|` if that is larger,
/// which no positive definite `H` has.
#[must_use]
#[inline]
pub fn is_gram<T: Lanes, const D: usize>(h: &SMatrix<T, D, D>) -> bool {
    is_definite(*h)
        && (0..D).all(|i| (i + 1..D).all(|j| h[(i, j)] == h[(j, i)] || is_symmetric(h, i, j)))
}

/// Returns whether the upper triangle is finite and positive definite. The pivots are computed as
/// in [`cholesky`], but without square roots.
#[inline]
fn is_definite<T: Lanes, const D: usize>(mut a: SMatrix<T, D, D>) -> bool {
    for k in 0..D {
        let pivot = a[(k, k)];
        // NaN and +∞ fail this check too.
        if !pivot.are_positive() {
            return false;
        }
        if k + 1 < D {
            let reciprocal = pivot.recip();
            for i in k + 1..D {
                let factor = a[(k, i)] * reciprocal;
                for j in i..D {
                    let eliminated = factor * a[(k, j)];
                    a[(i, j)] -= eliminated;
                }
            }
        }
    }
    true
}

/// Returns whether a matrix is a Gram matrix, like [`is_gram`]. Its `d²` entries are given column by
/// column.
#[must_use]
pub fn are_gram(h: &[f64], d: usize) -> bool {
    let at = |i: usize, j: usize| h[j * d + i];
    let is_mirrored = |i: usize, j: usize| {
        at(i, j) == at(j, i) || are_mirrored([at(i, j), at(j, i)], [at(i, i), at(j, j)])
    };
    factorize(d, h, &mut Factor::from_elem(0.0, d * d))
        && (0..d).all(|i| (i + 1..d).all(|j| is_mirrored(i, j)))
}

/// A triangular factor, column by column, which needs no allocation up to three dimensions.
type Factor = SmallVec<[f64; 9]>;

/// Returns whether the entries `(i, j)` and `(j, i)` are the same up to rounding.
fn is_symmetric<T: Lanes, const D: usize>(h: &SMatrix<T, D, D>, i: usize, j: usize) -> bool {
    (0..T::LANES).all(|lane| {
        let entry = |i, j| h[(i, j)].lane(lane);
        are_mirrored([entry(i, j), entry(j, i)], [entry(i, i), entry(j, j)])
    })
}

/// Returns whether two mirrored entries are the same up to rounding, given their diagonal entries.
fn are_mirrored([above, below]: [f64; 2], [one, other]: [f64; 2]) -> bool {
    // We take the roots first: the product of the entries may overflow, which would allow any
    // difference.
    let scale = one.abs().sqrt() * other.abs().sqrt();
    (above - below).abs() <= 1e-12 * scale.max(above.abs())
}

/// Returns `H(x)` if it is finite, symmetric and positive definite.
///
/// # Errors
///
/// [`MetricError`] with the point and the offending number.
pub fn check_gram<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
) -> Result<SMatrix<f64, D, D>, MetricError> {
    check_matrix(metric.gram(x), x)
}

/// Returns the matrix `h = H(x)` if it is finite, symmetric and positive definite.
///
/// # Errors
///
/// [`MetricError`] with the point and the offending number.
pub fn check_matrix<const D: usize>(
    h: SMatrix<f64, D, D>,
    x: &SVector<f64, D>,
) -> Result<SMatrix<f64, D, D>, MetricError> {
    check_numbers(h.as_slice(), x.as_slice())?;
    Ok(h)
}

/// Checks that the matrix `H(x)` is finite, symmetric and positive definite. Its `D²` entries are given
/// column by column, where `D` is the number of coordinates of `x`.
///
/// # Errors
///
/// [`MetricError`] with the point and the offending number.
pub fn check_numbers(h: &[f64], x: &[f64]) -> Result<(), MetricError> {
    let d = x.len();
    let (point, at) = (|| x.to_vec(), |i: usize, j: usize| h[j * d + i]);
    for (row, column) in (0..d).flat_map(|i| (0..d).map(move |j| (i, j))) {
        let entry = at(row, column);
        if !entry.is_finite() {
            return Err(MetricError::NotFinite { point: point(), row, column, entry });
        }
    }
    for (row, column) in (0..d).flat_map(|i| (i + 1..d).map(move |j| (i, j))) {
        let (above, below) = (at(row, column), at(column, row));
        if !are_mirrored([above, below], [at(row, row), at(column, column)]) {
            return Err(MetricError::NotSymmetric { point: point(), row, column, above, below });
        }
    }
    if !factorize(d, h, &mut Factor::from_elem(0.0, d * d)) {
        let upper = DMatrix::from_fn(d, d, |i, j| at(i.min(j), i.max(j)));
        let eigenvalue = upper.symmetric_eigenvalues().min();
        return Err(MetricError::NotPositiveDefinite { point: point(), eigenvalue });
    }
    Ok(())
}

/// Returns the lower triangular `L` with `L Lᵀ = A`, reading the entries `i ≤ j` of `A`. Returns
/// `None` if `A` is not positive definite (or not finite).
#[must_use]
pub fn cholesky<const D: usize>(a: &SMatrix<f64, D, D>) -> Option<SMatrix<f64, D, D>> {
    let mut l = SMatrix::<f64, D, D>::zeros();
    factorize(D, a.as_slice(), l.as_mut_slice()).then_some(l)
}

/// Writes `L` with `L Lᵀ = A` to `l`, which is zero before; both are given column by column. Returns
/// whether `A` is positive definite and finite.
#[inline]
fn factorize(d: usize, a: &[f64], l: &mut [f64]) -> bool {
    let (a, l) = (&a[..d * d], &mut l[..d * d]);
    for j in 0..d {
        let mut pivot = a[j * d + j];
        for k in 0..j {
            pivot -= l[k * d + j] * l[k * d + j];
        }
        // NaN and +∞ fail this check too.
        if !(pivot > 0.0 && pivot <= f64::MAX) {
            return false;
        }
        let pivot = pivot.sqrt();
        l[j * d + j] = pivot;
        let inverse = 1.0 / pivot;
        for i in j + 1..d {
            let mut entry = a[i * d + j];
            for k in 0..j {
                entry -= l[k * d + i] * l[k * d + j];
            }
            l[j * d + i] = entry * inverse;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, matrix, vector};
    use tautline_scalar::{Pair, Scalar};

    use super::{MetricError, check_gram, cholesky, is_gram};
    use crate::Metric;

    /// A matrix that does not depend on the point, valid or not.
    struct Matrix<const D: usize>([[f64; D]; D]);

    impl<const D: usize> Metric<D> for Matrix<D> {
        fn gram<S: Scalar>(&self, _: &SVector<S, D>) -> SMatrix<S, D, D> {
            SMatrix::from_fn(|i, j| S::constant(self.0[i][j]))
        }
    }

    /// In an indefinite matrix the tolerance is relative to the entry if the entry exceeds the
    /// diagonal.
    #[test]
    fn a_rounding_of_a_large_entry_is_no_asymmetry() {
        let error = |below| check_gram(&Matrix([[1e-20, 1.0], [below, 1e-20]]), &vector![0.0, 0.0]);
        assert!(matches!(error(1.0 + 1e-14), Err(MetricError::NotPositiveDefinite { .. })));
        assert!(matches!(error(1.0 + 1e-11), Err(MetricError::NotSymmetric { .. })));
    }

    #[test]
    fn each_defect_is_named_with_its_number() {
        let x = vector![1.0, 2.0];
        let error = |h| check_gram(&Matrix(h), &x).expect_err("a defect");
        assert!(matches!(
            error([[1.0, f64::NAN], [0.0, 1.0]]),
            MetricError::NotFinite { row: 0, column: 1, .. }
        ));
        assert!(matches!(
            error([[1.0, 0.5], [0.25, 1.0]]),
            MetricError::NotSymmetric { above: 0.5, below: 0.25, .. }
        ));
        let MetricError::NotPositiveDefinite { point, eigenvalue } =
            error([[1.0, 2.0], [2.0, 1.0]])
        else {
            panic!("eigenvalues 3 and -1");
        };
        assert_eq!(point, [1.0, 2.0]);
        approx::assert_relative_eq!(eigenvalue, -1.0, max_relative = 1e-14);
        assert!(check_gram(&Matrix([[2.0, 1.0], [1.0, 2.0]]), &x).is_ok());
    }

    #[test]
    fn the_cholesky_factor_multiplies_back() {
        let a = matrix![4.0, 2.0, -1.0; 2.0, 5.0, 0.5; -1.0, 0.5, 3.0];
        let l = cholesky(&a).expect("diagonally dominant");
        // The entries are of size 5 with three products each, so the rounding is about 1e-15.
        assert!((l * l.transpose() - a).amax() < 1e-14);
        assert!(cholesky(&matrix![1.0, 2.0; 2.0, 1.0]).is_none());
    }

    /// Cancelling terms of size 10⁶ leave an entry of size 1, with the rounding error of the terms.
    #[test]
    fn the_halves_may_differ_by_the_rounding_of_the_diagonal() {
        let off = |by: f64| check_gram(&Matrix([[2.0, 1.0], [1.0 + by, 2.0]]), &vector![0.0, 0.0]);
        assert!(off(4.0 * f64::EPSILON).is_ok());
        assert!(matches!(off(1e-11), Err(MetricError::NotSymmetric { .. })));
        let off = |by: f64| {
            check_gram(&Matrix([[1e6, 1.0], [1.0 + by, 4e6]]), &vector![0.0, 0.0]).map(|_| ())
        };
        assert_eq!(off(1e-6), Ok(()));
        assert!(matches!(off(4e-6), Err(MetricError::NotSymmetric { .. })));
    }

    /// This holds in any unit of length, although the squares of these entries overflow or
    /// underflow.
    #[test]
    fn the_halves_may_differ_by_as_much_in_every_unit() {
        for unit in [1e-300, 1e-200, 1.0, 1e200, 1e300] {
            let off = |by: f64| {
                let h = matrix![1e4, 1.0; 1.0 + by, 4e4] * unit;
                let checked = check_gram(&Matrix(h.transpose().into()), &vector![0.0, 0.0]);
                assert_eq!(checked.is_ok(), is_gram(&h), "{by} in {unit:e}");
                is_gram(&h)
            };
            // The tolerance is 10⁻¹² of √(10⁴ · 4 · 10⁴) = 2 · 10⁴.
            assert!(off(1e-8) && off(-1e-8) && !off(4e-8) && !off(-4e-8) && !off(-1.0), "{unit:e}");
            // The tolerance is relative to the entry where that is larger, but then the matrix is
            // not definite.
            assert!(!is_gram(&(matrix![1.0, 2.0; 2.0, 1.0] * unit)));
        }
    }

    /// There is one defect at a time, in each entry, and in each of two lanes.
    #[test]
    fn every_entry_of_every_lane_is_checked() {
        let good = matrix![4.0, 2.0, -1.0; 2.0, 5.0, 0.5; -1.0, 0.5, 3.0];
        let both =
            |a: &SMatrix<f64, 3, 3>, b: &SMatrix<f64, 3, 3>| is_gram(&a.zip_map(b, Pair::new));
        assert!(is_gram(&good) && both(&good, &good));
        for (place, bad) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).flat_map(|place| {
            [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -7.0, 0.25].map(|bad| (place, bad))
        }) {
            let mut spoilt = good;
            spoilt[place] = bad;
            assert!(!is_gram(&spoilt), "{bad} at {place:?}");
            assert!(!both(&spoilt, &good) && !both(&good, &spoilt), "{bad} at {place:?}");
            let rows = Matrix(spoilt.transpose().into());
            let checked = check_gram(&rows, &vector![0.0, 0.0, 0.0]);
            assert!(checked.is_err(), "{bad} at {place:?}");
            if !bad.is_finite() {
                let Err(MetricError::NotFinite { row, column, .. }) = checked else {
                    panic!("{checked:?}");
                };
                assert_eq!((row, column), place);
            }
        }
        // The matrix is singular: its last pivot is zero.
        let singular = matrix![1.0, 1.0; 1.0, 1.0];
        assert!(!is_gram(&singular) && cholesky(&singular).is_none());
        assert!(!is_gram(&matrix![0.0]) && is_gram(&matrix![f64::MIN_POSITIVE]));
    }

    /// `is_gram`, which uses pivots, and `cholesky` agree on random matrices, definite or not. Both
    /// read only the upper half.
    #[test]
    fn the_pivots_and_the_factor_agree() {
        let mut definite = 0;
        for case in 0..2000 {
            let wave = |k: usize| (f64::from(case) * (0.7 + 1.3 * k as f64).sqrt()).sin();
            let a = SMatrix::<f64, 4, 4>::from_fn(|i, j| {
                0.5 * wave(i.min(j) + 5 * i.max(j)) + if i == j { 0.8 } else { 0.0 }
            });
            let least = a.symmetric_eigenvalues().min();
            let factor = cholesky(&a);
            // This is far beyond the rounding of entries up to 1.3.
            if least.abs() > 1e-12 {
                assert_eq!((factor.is_some(), is_gram(&a)), (least > 0.0, least > 0.0), "{a}");
            }
            let upper = SMatrix::<f64, 4, 4>::from_fn(|i, j| if i <= j { a[(i, j)] } else { 9.0 });
            assert_eq!(cholesky(&upper), factor);
            definite += usize::from(factor.is_some());
        }
        assert!((200..1800).contains(&definite), "{definite}");
    }

    #[test]
    fn zero_and_infinity_are_not_positive_definite() {
        let zero = check_gram(&Matrix([[0.0; 2]; 2]), &vector![0.0, 0.0]).expect_err("zero");
        assert!(matches!(zero, MetricError::NotPositiveDefinite { eigenvalue: 0.0, .. }));
        assert!(cholesky(&matrix![f64::INFINITY, 0.0; 0.0, 1.0]).is_none());
    }
}
