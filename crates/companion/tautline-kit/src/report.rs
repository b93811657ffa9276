//! `Report`: the outcome of every law for one metric, set or rule.

use std::fmt;

use tautline_chance::Chance;

use super::{Fault, Standing, margin::merge};

/// The result of one law.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The name of the law, which is also the name of its test.
    pub id: &'static str,
    /// What the law says, in one line.
    pub law: &'static str,
    /// The number of cases that were checked.
    pub cases: u64,
    /// The number of these cases that could have violated the law. Some cases of a statement cannot
    /// violate it: a gap that vanishes, as for a length on the line, is at most any bound, and a
    /// formula is at most itself.
    pub could_fail: u64,
    /// The smallest overestimation `bound / observed`, a pure number. It is 1 where a bound is
    /// attained, below 1 where it is violated, and `∞` if nothing beyond rounding was observed.
    pub overestimation: f64,
    /// What bounds over the whole region prove about each constant; empty for a law that samples
    /// points.
    pub standings: Vec<Standing>,
    /// The hypotheses that were assumed in some case because no number measures them. An example is
    /// that a local minimiser is the global one.
    pub assumed: Vec<&'static str>,
    /// A remark, for example why nothing was checked.
    pub note: Option<String>,
    /// The reason why the law does not hold, if it does not.
    pub failure: Option<Failure>,
}

/// The reason why a law does not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The law with its numbers.
    pub fault: Fault,
    /// The smallest random sample that was found to violate the law, if any. If an ascent found a
    /// worse point, the fault describes that point.
    pub sample: Option<String>,
    /// The seed of the samples.
    pub seed: u64,
}

/// The cases of a law that holds.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tried {
    pub(crate) cases: u64,
    /// The number of these cases that could not have violated the law.
    pub(crate) idle: u64,
    pub(crate) overestimation: f64,
    pub(crate) standings: Vec<Standing>,
    pub(crate) assumed: Vec<&'static str>,
    pub(crate) note: Option<String>,
}

impl Tried {
    /// Returns a result with this many cases, none of which came close to the bound.
    pub(crate) fn cases(cases: u64) -> Self {
        let (standings, assumed, note) = (Vec::new(), Vec::new(), None);
        Self { cases, idle: 0, overestimation: f64::INFINITY, standings, assumed, note }
    }

    /// Returns a result without cases for a law that does not apply, with the reason.
    pub(crate) fn none(why: impl Into<String>) -> Self {
        Self::cases(0).with_note(why)
    }

    pub(crate) fn with_note(self, note: impl Into<String>) -> Self {
        Self { note: Some(note.into()), ..self }
    }

    /// Combines the cases of two parts of one law.
    pub(crate) fn and(mut self, other: Tried) -> Self {
        self.standings.extend(other.standings);
        merge(&mut self.assumed, &other.assumed);
        Self {
            cases: self.cases + other.cases,
            idle: self.idle + other.idle,
            overestimation: self.overestimation.min(other.overestimation),
            note: self.note.or(other.note),
            ..self
        }
    }
}

/// The return type of a law.
pub(crate) type LawResult = Result<Tried, Failure>;

impl Outcome {
    /// Runs a law on a case.
    pub(crate) fn of<C>(
        id: &'static str,
        law: &'static str,
        case: &C,
        run: impl FnOnce(&C) -> LawResult,
    ) -> Self {
        Self::new(id, law, run(case))
    }

    fn new(id: &'static str, law: &'static str, result: LawResult) -> Self {
        let (tried, failure) = match result {
            Ok(tried) => (tried, None),
            Err(failure) => (Tried { overestimation: f64::NAN, ..Tried::cases(0) }, Some(failure)),
        };
        let Tried { cases, idle, overestimation, standings, assumed, note } = tried;
        let could_fail = cases - idle;
        Self { id, law, cases, could_fail, overestimation, standings, assumed, note, failure }
    }

    /// Returns whether the law held in every case.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.failure.is_none()
    }

    /// Does nothing if the law holds. This function is for tests.
    ///
    /// # Panics
    ///
    /// If the law does not hold, with the message of the fault.
    #[track_caller]
    pub fn assert(&self) {
        assert!(self.holds(), "{self}");
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let overestimation = match self.overestimation {
            found if found.is_nan() => String::new(),
            f64::INFINITY => "-".to_owned(),
            found if found < 1e4 => format!("{found:.4}"),
            found => format!("{found:.1e}"),
        };
        let mark = if self.holds() { "ok" } else { "FAILS" };
        let Self { id, law, cases, could_fail, .. } = self;
        write!(f, "{id:<48} {mark:<5} {cases:>7} {could_fail:>10} {overestimation:>14}  {law}")?;
        if !self.standings.is_empty() {
            let standings: Vec<String> = self.standings.iter().map(Standing::to_string).collect();
            write!(f, "; {}", standings.join(", "))?;
        }
        if !self.assumed.is_empty() {
            write!(f, "; assumed: {}", self.assumed.join(", "))?;
        }
        if let Some(note) = &self.note {
            write!(f, "; {note}")?;
        }
        match &self.failure {
            Some(failure) => write!(f, "\n    {failure}"),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.fault)?;
        if let Some(sample) = &self.sample {
            write!(f, "\n    smallest random sample that breaks it: {sample}")?;
        }
        write!(f, "\n    seed {}", self.seed)?;
        // If the environment cannot be read, the test has failed already.
        match Chance::read().map(|chance| chance.to_string()) {
            Ok(asked) if !asked.is_empty() => write!(f, "; with {}in the environment", asked),
            _ => Ok(()),
        }
    }
}

/// One [`Outcome`] per law, in a fixed order. A report prints as a table.
#[derive(Clone, Debug, PartialEq)]
#[must_use = "an unread report accepts everything"]
pub struct Report {
    /// The outcomes.
    pub outcomes: Vec<Outcome>,
}

impl Report {
    /// Returns whether all laws hold.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.outcomes.iter().all(Outcome::holds)
    }

    /// Returns the outcomes of the laws that do not hold.
    pub fn failures(&self) -> impl Iterator<Item = &Outcome> {
        self.outcomes.iter().filter(|outcome| !outcome.holds())
    }

    /// Returns the outcome of the law with this name.
    #[must_use]
    pub fn of(&self, id: &str) -> Option<&Outcome> {
        self.outcomes.iter().find(|outcome| outcome.id == id)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:<48} {:<5} {:>7} {:>10} {:>14}  says",
            "law", "", "cases", "could fail", "overestimation"
        )?;
        self.outcomes.iter().try_for_each(|outcome| writeln!(f, "{outcome}"))
    }
}

#[cfg(test)]
mod tests {
    use super::{Failure, Outcome, Report, Tried};
    use crate::{Claim, Fault, Lie, Proof, Standing};

    fn report() -> Report {
        let standing = |claim, proof| Standing { claim, proof };
        let standings = vec![
            standing(Claim::C1, Proof::Proved),
            standing(Claim::C2, Proof::RightTo { percent: 0.04 }),
            standing(Claim::LH, Proof::NotDecided),
            standing(Claim::MH, Proof::NotTried),
        ];
        let good = Tried {
            idle: 3,
            overestimation: 1.5,
            standings,
            assumed: vec!["b", "d"],
            ..Tried::cases(7)
        };
        let lie = Lie {
            constant: Claim::LH,
            claimed: 0.5,
            found: 1.0,
            point: vec![0.25, 0.0],
            direction: vec![1.0, 0.0],
            other: None,
        };
        let sample = Some("smaller".to_owned());
        let failure = Failure { fault: Fault::Lie(lie), sample, seed: 3 };
        let outcomes = vec![
            Outcome::new("good", "a ≤ b", Ok(good.with_note("and more"))),
            Outcome::new("bad", "c ≤ d", Err(failure)),
            Outcome::new("far", "e ≤ f", Ok(Tried::cases(2))),
        ];
        Report { outcomes }
    }

    #[test]
    fn a_report_is_a_table_with_the_numbers_of_each_failure() {
        let report = report();
        assert!(!report.holds());
        assert_eq!(report.failures().map(|outcome| outcome.id).collect::<Vec<_>>(), ["bad"]);
        assert!(report.of("good").is_some_and(Outcome::holds) && report.of("none").is_none());
        let text = report.to_string();
        let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
        let row = |id: &str, rest: &str| format!("{id:<48} {rest}");
        assert_eq!(lines[0], row("law", "        cases could fail overestimation  says"));
        let standings = "c1 proved, c2 right to 0.0 %, L_H not decided, M_H not tried";
        let good = format!(
            "ok          7          4         1.5000  a ≤ b; {standings}; assumed: b, d; and more"
        );
        assert_eq!(lines[1], row("good", &good));
        assert_eq!(lines[2], row("bad", "FAILS       0          0                 c ≤ d"));
        assert_eq!(
            lines[3],
            "    the metric claims L_H = 0.5, but ‖DH(x)[w]‖ = 1 at x = [0.25, 0.0] in the \
             direction w = [1.0, 0.0]"
        );
        assert_eq!(
            lines[4..6],
            ["    smallest random sample that breaks it: smaller", "    seed 3"]
        );
        assert_eq!(lines[6], row("far", "ok          2          2              -  e ≤ f"));
    }

    #[test]
    fn two_parts_of_a_law_are_added() {
        let part = |cases, idle, overestimation, assumed: &[&'static str]| Tried {
            idle,
            overestimation,
            assumed: assumed.to_vec(),
            ..Tried::cases(cases)
        };
        let all = part(7, 3, 1.5, &["a"]).and(part(5, 2, 2.5, &["b", "a"]));
        assert_eq!(all, part(12, 5, 1.5, &["a", "b"]));
        let [one, other] =
            [part(1, 0, 2.0, &[]).with_note("m"), part(1, 0, 1.0, &[]).with_note("n")];
        assert_eq!(one.and(other), part(2, 0, 1.0, &[]).with_note("m"));
    }

    #[test]
    #[should_panic(expected = "the metric claims L_H = 0.5")]
    fn a_law_that_does_not_hold_panics_in_a_test() {
        report().outcomes[1].assert();
    }
}
