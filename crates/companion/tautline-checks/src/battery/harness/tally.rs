//! `Tally`: how often each statement was evaluated, and how close it came to equality.

use std::collections::{BTreeMap, BTreeSet};

use tautline_statements::{Evidence, Source, Statement};

use super::Fingerprint;

/// For each statement, the number of evaluated cases, the number of those that could have failed,
/// the smallest overestimation, and the hypotheses evaluated and assumed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    counts: BTreeMap<Statement, Count>,
    hypotheses: BTreeMap<Statement, BTreeSet<&'static str>>,
    assumed: BTreeMap<Statement, BTreeSet<&'static str>>,
    compared: Fingerprint,
}

/// The cases of one statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Count {
    /// The number of cases.
    pub cases: u64,
    /// The number of cases that [could have failed](Evidence::could_fail).
    pub could_fail: u64,
    /// The smallest overestimation of the stated conclusions, a pure number; `∞` if none was
    /// observed.
    pub overestimation: f64,
}

impl Tally {
    /// Adds the evidence of one case. It counts as a case of its statement if it contains a stated
    /// conclusion or an identity.
    pub fn count(&mut self, evidence: &Evidence) {
        let stated = evidence.conclusions.iter().any(|claim| claim.source != Source::Sharper);
        let one = Count {
            cases: u64::from(stated),
            could_fail: u64::from(evidence.could_fail()),
            overestimation: evidence.overestimation(),
        };
        self.add(evidence.statement, one);
        let claims = evidence.hypotheses.iter().map(|clause| clause.claim);
        self.hypotheses.entry(evidence.statement).or_default().extend(claims);
        self.assumed.entry(evidence.statement).or_default().extend(&evidence.assumed);
        self.compared.see(evidence);
    }

    /// Adds all the cases of another tally.
    pub fn extend(&mut self, other: &Tally) {
        for (&statement, &count) in &other.counts {
            self.add(statement, count);
        }
        for (&statement, claims) in &other.hypotheses {
            self.hypotheses.entry(statement).or_default().extend(claims);
        }
        for (&statement, claims) in &other.assumed {
            self.assumed.entry(statement).or_default().extend(claims);
        }
        self.compared.extend(other.compared);
    }

    /// Returns the fingerprint of the numbers that the paper's bounds compared.
    pub(crate) fn compared(&self) -> Fingerprint {
        self.compared
    }

    /// Returns the count of a statement, if it was evaluated at all.
    #[must_use]
    pub fn of(&self, statement: Statement) -> Option<Count> {
        self.counts.get(&statement).copied()
    }

    /// Returns the claims of the hypotheses of a statement that were evaluated.
    pub fn hypotheses(&self, statement: Statement) -> impl Iterator<Item = &'static str> {
        self.hypotheses.get(&statement).into_iter().flatten().copied()
    }

    /// Returns the claims of the hypotheses of a statement that were assumed.
    pub fn assumed(&self, statement: Statement) -> impl Iterator<Item = &'static str> {
        self.assumed.get(&statement).into_iter().flatten().copied()
    }

    fn add(&mut self, statement: Statement, more: Count) {
        let none = Count { cases: 0, could_fail: 0, overestimation: f64::INFINITY };
        let count = self.counts.entry(statement).or_insert(none);
        count.cases += more.cases;
        count.could_fail += more.could_fail;
        count.overestimation = count.overestimation.min(more.overestimation);
    }
}

#[cfg(test)]
mod tests {
    use tautline::{
        SMatrix,
        gallery::{Constant, Ramp, Shear},
    };
    use tautline_statements::{
        Evidence, Known, LIBRARY, PaperRule, Reconstruction, Statement, Subject, Unit, theorem_1_1,
        theorem_1_2, theorem_1_3, theorem_1_4,
    };

    use super::Tally;

    /// Returns, for Theorems 1.1 to 1.4 on the minimisers of both rules with `N = 4`, the number of
    /// cases and the number of those that could fail.
    fn of_minimisers<M: tautline::Bounded<D>, const D: usize>(
        known: &Known<M, D>,
    ) -> [[u64; 2]; 4] {
        let mut tally = Tally::default();
        for rule in PaperRule::BOTH {
            let seen = Reconstruction::observe(&LIBRARY, known, rule, 4).expect("a minimum");
            let theorems: [fn(&Subject, &_) -> Evidence; 2] = match rule {
                PaperRule::Trapezoidal => [theorem_1_1, theorem_1_2],
                PaperRule::LeftEndpoint => [theorem_1_3, theorem_1_4],
            };
            theorems.into_iter().for_each(|theorem| tally.count(&theorem(&LIBRARY, &seen)));
        }
        [Statement::Theorem1_1, Statement::Theorem1_2, Statement::Theorem1_3, Statement::Theorem1_4]
            .map(|statement| {
                let count = tally.of(statement).expect("counted");
                [count.cases, count.could_fail]
            })
    }

    /// On the line every curve that does not turn back has length `d`, but its energy depends on
    /// the clock. Under a constant metric the minimisers are straight lines, for which both the
    /// length and the energy are exact.
    #[test]
    fn a_gap_that_vanishes_identically_is_a_case_that_could_not_fail() {
        let ramp = Ramp::new(0.5, 1.0).expect("an amplitude");
        let known = Known::between(ramp, [0.0], [2.0]).expect("finite").expect("known");
        assert_eq!(of_minimisers(&known), [[1, 1], [1, 0], [1, 1], [1, 0]]);
        let flat = Constant::<2>::new(SMatrix::identity()).expect("positive definite");
        let known = Known::between(flat, [0.0, 0.0], [3.0, 4.0]).expect("finite").expect("known");
        assert_eq!(of_minimisers(&known), [[1, 0]; 4]);
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        let known = Known::between(shear, [0.0, 0.0], [2.0, 3.0]).expect("finite").expect("known");
        assert_eq!(of_minimisers(&known), [[1, 1]; 4]);
    }

    #[test]
    fn sums_of_tallies_keep_both_counts_and_what_is_assumed() {
        let evidence = |observed, assumed| {
            let begun = Evidence::of(Statement::Theorem1_1).assumed(assumed);
            begun.stated("a", Unit::NONE, [observed, 2.0], 1e-9)
        };
        let (mut one, mut other) = (Tally::default(), Tally::default());
        one.count(&evidence(1.0, "b"));
        other.count(&evidence(0.0, "c"));
        one.extend(&other);
        let count = one.of(Statement::Theorem1_1).expect("counted");
        assert_eq!((count.cases, count.could_fail, count.overestimation), (2, 1, 2.0));
        assert_eq!(one.assumed(Statement::Theorem1_1).collect::<Vec<_>>(), ["b", "c"]);
    }

    #[test]
    fn an_identity_is_a_case_that_could_not_fail() {
        let mut tally = Tally::default();
        let begun = Evidence::of(Statement::ConstantCTra);
        tally.count(&begun.identity(["a ≤ b", "b ≤ a"], Unit::NONE, [1.0, 1.0], 0.0));
        let count = tally.of(Statement::ConstantCTra).expect("counted");
        assert_eq!((count.cases, count.could_fail, count.overestimation), (1, 0, f64::INFINITY));
    }
}
