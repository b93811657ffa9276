//! `Fingerprint`: whether two runs compared the same numbers.

use tautline_statements::{Evidence, Source};

/// A hash (FNV-1a, 64 bits) of the numbers that the paper's bounds compare, observed and bound, in
/// the order of the cases. The errors granted for rounding are ours and are not hashed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fingerprint(u64);

impl Default for Fingerprint {
    /// Returns the hash of no numbers.
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fingerprint {
    /// Adds the stated conclusions, if the statement is a bound.
    pub(crate) fn see(&mut self, evidence: &Evidence) {
        if evidence.statement.is_a_bound() {
            for claim in evidence.conclusions.iter().filter(|claim| claim.source == Source::Stated)
            {
                for number in [claim.observed, claim.bound] {
                    self.add(number.to_bits());
                }
            }
        }
    }

    /// Adds another run.
    pub(crate) fn extend(&mut self, other: Self) {
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

    /// The last bit of a stated bound changes the hash. Companions, hypotheses, granted errors, and
    /// statements that are not bounds of the paper do not.
    #[test]
    fn only_the_bounds_of_the_paper_are_hashed() {
        let bound = Statement::Theorem1_1;
        assert_ne!(of(bound, 1.0, 2.0), of(bound, 1.0_f64.next_up(), 2.0));
        assert_eq!(of(bound, 1.0, 2.0), of(bound, 1.0, 3.0));
        let other = Statement::ALL.into_iter().find(|statement| !statement.is_a_bound());
        let other = other.expect("one at least");
        assert_eq!(of(other, 1.0, 2.0), Fingerprint::default());
    }

    #[test]
    fn the_order_of_two_runs_matters() {
        let [first, second] = [1.0, 2.0].map(|bound| of(Statement::Theorem1_1, bound, 1.0));
        let both = |[first, second]: [Fingerprint; 2]| {
            let mut sum = first;
            sum.extend(second);
            sum
        };
        assert_ne!(both([first, second]), both([second, first]));
    }
}
