//! `Fingerprint`: whether two runs compared the same numbers.

use tautline_statements::{Evidence, Source};

/// A hash (FNV-1a, 64 bits) of the numbers that the paper's bounds compare, in the order of the
/// cases: what is observed, and the bound. What is granted to rounding is ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Fingerprint(u64);

impl Default for Fingerprint {
    /// That of no number at all.
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fingerprint {
    /// Adds the stated conclusions of a statement that is a bound; of any other, nothing.
    pub(super) fn see(&mut self, evidence: &Evidence) {
        if evidence.statement.is_a_bound() {
            for claim in evidence.conclusions.iter().filter(|claim| claim.source == Source::Stated)
            {
                for number in [claim.observed, claim.bound] {
                    self.add(number.to_bits());
                }
            }
        }
    }

    /// Adds all that another one has seen.
    pub(super) fn extend(&mut self, other: Self) {
        self.add(other.0);
    }

    fn add(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

#[cfg(test)]
mod tests {
    use tautline_statements::{Evidence, Statement, Unit};

    use super::Fingerprint;

    fn of(statement: Statement, stated: f64, ours: f64) -> Fingerprint {
        let mut seen = Fingerprint::default();
        seen.see(
            &Evidence::of(statement)
                .given("a hypothesis", Unit::NONE, [ours, 1.0], 0.0)
                .stated("a bound", Unit::ENERGY, [0.5, stated], ours)
                .sharper("a companion", Unit::ENERGY, [0.5, ours], 0.0),
        );
        seen
    }

    /// The last bit of a stated bound is seen; a companion, a hypothesis, what is granted, and a
    /// statement that is no bound of the paper are not.
    #[test]
    fn the_paper_s_bounds_are_seen_and_nothing_else() {
        let bound = Statement::Theorem1_1;
        assert_ne!(of(bound, 1.0, 2.0), of(bound, 1.0_f64.next_up(), 2.0));
        assert_eq!(of(bound, 1.0, 2.0), of(bound, 1.0, 3.0));
        let other = Statement::ALL.into_iter().find(|statement| !statement.is_a_bound());
        let other = other.expect("one at least");
        assert_eq!(of(other, 1.0, 2.0), Fingerprint::default());
    }

    #[test]
    fn the_order_of_two_runs_matters_as_that_of_two_cases_does() {
        let [first, second] = [1.0, 2.0].map(|bound| of(Statement::Theorem1_1, bound, 1.0));
        let both = |[first, second]: [Fingerprint; 2]| {
            let mut sum = first;
            sum.extend(second);
            sum
        };
        assert_ne!(both([first, second]), both([second, first]));
    }
}
