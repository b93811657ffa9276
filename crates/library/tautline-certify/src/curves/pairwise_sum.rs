//! Sums of many intervals with little growth in width.

use tautline_scalar::{Enclosure, Kernel};

/// A running sum of intervals by pairwise summation.
///
/// Each addition rounds outward by up to one unit in the last place of the current sum. Sequential
/// summation of `N` terms would thus widen the total by up to `N` units. In pairwise summation each
/// term takes part in at most `2 log₂ N` additions, and only the last few are of the size of the
/// total.
#[derive(Clone, Debug)]
pub(super) struct PairwiseSum<K> {
    /// The entry at place `k` is a sum of `2ᵏ` terms, where `count` has that binary digit.
    sums: Vec<Enclosure<K>>,
    count: usize,
}

impl<K: Kernel> PairwiseSum<K> {
    pub(super) fn new() -> Self {
        Self { sums: Vec::new(), count: 0 }
    }

    pub(super) fn add(&mut self, term: Enclosure<K>) {
        // As in binary counting, each trailing one of the count produces a carry.
        let carries = self.count.trailing_ones();
        let sum = (0..carries).fold(term, |sum, _| self.sums.pop().map_or(sum, |s| s + sum));
        self.sums.push(sum);
        self.count += 1;
    }

    /// The sum; zero if there are no terms.
    pub(super) fn value(self) -> Enclosure<K> {
        let zero = Enclosure::point(0.0);
        self.sums.into_iter().rev().reduce(|sum, s| s + sum).unwrap_or(zero)
    }
}

#[cfg(test)]
mod tests {
    use tautline_scalar::{Interval, Rigorous};

    use super::PairwiseSum;

    fn sum(terms: impl Iterator<Item = Interval>) -> Interval {
        let mut sum = PairwiseSum::<Rigorous>::new();
        terms.for_each(|term| sum.add(term));
        sum.value()
    }

    /// With integers nothing is rounded, so a term that is lost or added twice would show.
    #[test]
    fn all_terms_are_added() {
        for n in 0..70_u32 {
            let total = sum((1..=n).map(|k| Interval::point(f64::from(k))));
            assert_eq!(total, Interval::point(f64::from(n * (n + 1) / 2)));
        }
    }

    #[test]
    fn the_width_grows_like_the_logarithm() {
        // Sums of 0.1 are rounded.
        let n = 10_000;
        let terms = || (0..n).map(|_| Interval::point(0.1));
        let plain = terms().reduce(|a, b| a + b).expect("terms");
        let paired = sum(terms());
        // The double 0.1 is 0.1 + 5.55e-18, so the sum is 1000 + 5.55e-14, which lies between
        // neighbours.
        assert!(paired.contains(1000.0) && paired.contains(1000.0_f64.next_up()));
        assert!(plain.width() > 1e3 * 1000.0 * f64::EPSILON);
        assert!(paired.width() <= 14.0 * 1000.0 * f64::EPSILON, "{:e}", paired.width());
    }

    #[test]
    fn an_undefined_term_makes_the_sum_undefined() {
        let terms = [Interval::point(1.0), Interval::UNDEFINED, Interval::point(2.0)];
        assert!(sum(terms.into_iter()).is_undefined());
    }
}
