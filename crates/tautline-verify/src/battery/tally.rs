//! `Tally`: how often each statement was evaluated, and how near it came to equality.

use std::collections::BTreeMap;

use crate::{Evidence, Statement};

/// For each statement, the number of cases on which it was evaluated and the least slack.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    counts: BTreeMap<Statement, Count>,
}

/// The cases of one statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Count {
    /// How many cases.
    pub cases: u64,
    /// The least slack of the paper's own conclusions, a pure number; `∞` if none was seen.
    pub slack: f64,
}

impl Tally {
    /// Counts one case.
    pub fn count(&mut self, evidence: &Evidence) {
        let one = Count { cases: 1, slack: evidence.slack() };
        self.add(evidence.statement, one);
    }

    /// Adds all the cases of another tally.
    pub fn extend(&mut self, other: &Tally) {
        for (&statement, &count) in &other.counts {
            self.add(statement, count);
        }
    }

    /// Returns the count of a statement, if it was evaluated at all.
    #[must_use]
    pub fn of(&self, statement: Statement) -> Option<Count> {
        self.counts.get(&statement).copied()
    }

    fn add(&mut self, statement: Statement, more: Count) {
        let none = Count { cases: 0, slack: f64::INFINITY };
        let count = self.counts.entry(statement).or_insert(none);
        count.cases += more.cases;
        count.slack = count.slack.min(more.slack);
    }
}
