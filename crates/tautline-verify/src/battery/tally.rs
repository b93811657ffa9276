//! `Tally`: how often each statement was evaluated, and how near it came to equality.

use std::collections::{BTreeMap, BTreeSet};

use super::fingerprint::Fingerprint;
use crate::{Evidence, Source, Statement};

/// For each statement, the number of cases on which it was evaluated, the least slack, and the
/// hypotheses that were looked at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    counts: BTreeMap<Statement, Count>,
    hypotheses: BTreeMap<Statement, BTreeSet<&'static str>>,
    compared: Fingerprint,
}

/// The cases of one statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Count {
    /// How many cases.
    pub cases: u64,
    /// The least slack of the stated conclusions, a pure number; `∞` if none was seen.
    pub slack: f64,
}

impl Tally {
    /// Counts one case, of the statement if a stated conclusion was put to it.
    pub fn count(&mut self, evidence: &Evidence) {
        let stated = evidence.conclusions.iter().any(|claim| claim.source == Source::Stated);
        let one = Count { cases: u64::from(stated), slack: evidence.slack() };
        self.add(evidence.statement, one);
        let claims = evidence.hypotheses.iter().map(|clause| clause.claim);
        self.hypotheses.entry(evidence.statement).or_default().extend(claims);
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
        self.compared.extend(other.compared);
    }

    /// Returns what the paper's bounds compared.
    pub(super) fn compared(&self) -> Fingerprint {
        self.compared
    }

    /// Returns the count of a statement, if it was evaluated at all.
    #[must_use]
    pub fn of(&self, statement: Statement) -> Option<Count> {
        self.counts.get(&statement).copied()
    }

    /// Returns the hypotheses of a statement that were evaluated, by their claims.
    pub fn hypotheses(&self, statement: Statement) -> impl Iterator<Item = &'static str> {
        self.hypotheses.get(&statement).into_iter().flatten().copied()
    }

    fn add(&mut self, statement: Statement, more: Count) {
        let none = Count { cases: 0, slack: f64::INFINITY };
        let count = self.counts.entry(statement).or_insert(none);
        count.cases += more.cases;
        count.slack = count.slack.min(more.slack);
    }
}
