//! Sums of many terms with the rounding error of one.

/// A running sum and the part of it that did not fit (Knuth's two-sum).
///
/// `N` energies of chords, added plainly, would lose up to `N ε`; this keeps `2 ε`, and the
/// differences `E_N − d²` of the asymptotic range are themselves as small as `10⁻¹⁰ d²`.
#[derive(Clone, Copy, Debug, Default)]
pub struct CompensatedSum {
    sum: f64,
    lost: f64,
}

impl CompensatedSum {
    /// Adds a term.
    #[inline]
    pub fn add(&mut self, term: f64) {
        let sum = self.sum + term;
        // The exact error of the addition: sum = s + t − error with these four roundings exact.
        let kept = sum - self.sum;
        self.lost += (self.sum - (sum - kept)) + (term - kept);
        self.sum = sum;
    }

    /// Returns the sum of the terms, rounded once or twice; infinite if it overflowed.
    #[must_use]
    pub fn value(self) -> f64 {
        let value = self.sum + self.lost;
        // An infinite sum has lost ∞ − ∞; the sum itself says what happened.
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
    use super::CompensatedSum;

    #[test]
    fn small_terms_are_not_lost_beside_a_large_one() {
        let terms = std::iter::once(1.0).chain(std::iter::repeat_n(1e-17, 1000));
        // Plainly, every addition of 1e-17 to 1 is lost.
        assert_eq!(terms.collect::<CompensatedSum>().value(), 1.0 + 1e-14);
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
