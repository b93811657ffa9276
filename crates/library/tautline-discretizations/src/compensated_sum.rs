//! `CompensatedSum`: a sum of many terms with a rounding error as small as for one term.

use std::ops::AddAssign;

use tautline_metrics::{Lanes, Pair, Scalar};

/// A running sum and the sum of its rounding errors (Knuth's two-sum).
///
/// A plain sum of the energies of `N` chords has a relative error of up to `N ε`, this sum one of
/// `2 ε`. The differences `E_N − d²` in the asymptotic range are as small as `10⁻¹⁰ d²`.
#[derive(Clone, Copy, Debug)]
pub struct CompensatedSum<T = f64> {
    sum: T,
    lost: T,
}

impl<T: Scalar> Default for CompensatedSum<T> {
    /// Returns the empty sum.
    fn default() -> Self {
        Self { sum: T::zero(), lost: T::zero() }
    }
}

impl<T: Scalar> CompensatedSum<T> {
    /// Adds a term.
    #[inline]
    pub fn add(&mut self, term: T) {
        let sum = self.sum + term;
        // The exact error of the addition: sum = s + t − error. The four operations that compute
        // the error are exact.
        let kept = sum - self.sum;
        self.lost += (self.sum - (sum - kept)) + (term - kept);
        self.sum = sum;
    }
}

impl<T: Scalar> AddAssign for CompensatedSum<T> {
    /// Adds all terms of another sum.
    fn add_assign(&mut self, other: Self) {
        self.add(other.sum);
        self.lost += other.lost;
    }
}

impl CompensatedSum<Pair> {
    /// Returns the sums of the two lanes separately.
    #[must_use]
    pub fn apart(self) -> [CompensatedSum; 2] {
        [0, 1].map(|lane| CompensatedSum { sum: self.sum.lane(lane), lost: self.lost.lane(lane) })
    }
}

impl CompensatedSum {
    /// Returns the sum of the terms, rounded once or twice. The result is infinite if the sum
    /// overflowed.
    #[must_use]
    pub fn value(self) -> f64 {
        let value = self.sum + self.lost;
        // If the sum is infinite, the lost part is ∞ − ∞; then return the sum itself.
        if value.is_nan() { self.sum } else { value }
    }
}

impl FromIterator<f64> for CompensatedSum {
    fn from_iter<I: IntoIterator<Item = f64>>(terms: I) -> CompensatedSum {
        let mut sum = CompensatedSum::default();
        for term in terms {
            sum.add(term);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use tautline_metrics::Pair;

    use super::CompensatedSum;

    #[test]
    fn small_terms_are_not_lost_beside_a_large_one() {
        let terms = std::iter::once(1.0).chain(std::iter::repeat_n(1e-17, 1000));
        // A plain sum would lose each term of 1e-17.
        assert_eq!(terms.collect::<CompensatedSum>().value(), 1.0 + 1e-14);
    }

    #[test]
    fn two_sums_side_by_side_add_up_to_the_sum_of_all_terms() {
        let mut both = CompensatedSum::default();
        both.add(Pair::new(1.0, -1.0));
        for _ in 0..1000 {
            both.add(Pair::new(1e-17, 2e-17));
        }
        let [mut one, other] = both.apart();
        // Each sum is rounded once: it is within 2 ε of a sum of 1.
        assert_eq!((one.value(), other.value()), (1.0 + 1e-14, -1.0 + 2e-14));
        one += other;
        approx::assert_relative_eq!(one.value(), 3e-14, max_relative = 1e-12);
    }

    /// The two-sum recovers the rounding error whichever operand is larger.
    #[test]
    fn nothing_is_lost_in_any_order_of_large_and_small() {
        let orders = [
            [1.0, 1e100, 1.0, -1e100],
            [1e100, 1.0, 1.0, -1e100],
            [1.0, 1.0, 1e100, -1e100],
            [1.0, -1e100, 1e100, 1.0],
        ];
        for order in orders {
            assert_eq!(order.into_iter().collect::<CompensatedSum>().value(), 2.0, "{order:?}");
        }
    }

    /// Either sum may be the larger one, and each may have lost something.
    #[test]
    fn sums_of_sums_lose_nothing() {
        let sum = |terms: &[f64]| terms.iter().copied().collect::<CompensatedSum>();
        let small = sum(&[1e-17]);
        let mut whole = sum(&[1.0]);
        for _ in 0..1000 {
            whole += small;
        }
        assert_eq!(whole.value(), 1.0 + 1e-14);
        let mut other = small;
        other += sum(&[1.0, 1e-17]);
        for _ in 2..1000 {
            other += small;
        }
        assert_eq!(other.value(), 1.0 + 1e-14);
    }

    #[test]
    fn overflow_is_infinite_and_nan_is_nan() {
        assert_eq!(
            [f64::MAX, f64::MAX].into_iter().collect::<CompensatedSum>().value(),
            f64::INFINITY
        );
        assert!([1.0, f64::NAN].into_iter().collect::<CompensatedSum>().value().is_nan());
    }
}
