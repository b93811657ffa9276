//! The ledger: what the whole suite shows of each statement.

use tautline_statements::{LIBRARY, Statement};

use super::{Failure, Kind, Scope, Tally, Trial, suite};

/// What the suite shows of one statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The statement.
    pub statement: Statement,
    /// How many random cases evaluated it.
    pub cases: u64,
    /// How many of these could have failed; the others hold for any bound.
    pub could_fail: u64,
    /// The least overestimation of these, a pure number; `∞` if none was seen.
    pub least_overestimation: f64,
    /// The least overestimation of its witnesses, a pure number.
    pub witness_overestimation: f64,
    /// How many cases with proved numbers could have failed.
    pub proved: u64,
    /// The claims of the hypotheses evaluated on random cases.
    pub hypotheses: Vec<&'static str>,
    /// The claims of the hypotheses assumed of random cases.
    pub assumed: Vec<&'static str>,
    /// The names of the checks about it.
    pub checks: Vec<&'static str>,
}

/// Runs the whole suite on the library, and returns an entry for each statement.
///
/// # Errors
///
/// The first check that fails, by its name.
pub fn ledger() -> Result<Vec<Entry>, Failure> {
    let trial = Trial::new(&LIBRARY, Scope::Everything, u32::MAX);
    let checks = suite();
    let (mut random, mut witnesses, mut proved) =
        (Tally::default(), Tally::default(), Tally::default());
    for check in &checks {
        let tally = check.run_by_name(&trial)?;
        match check.kind {
            Kind::Random => random.extend(&tally),
            Kind::Witness => witnesses.extend(&tally),
            Kind::Proved => proved.extend(&tally),
            _ => {}
        }
    }
    let entry = |statement: Statement| {
        let about = checks.iter().filter(|check| check.statements.contains(&statement));
        let overestimation =
            |tally: &Tally| tally.of(statement).map_or(f64::INFINITY, |count| count.overestimation);
        Entry {
            statement,
            cases: random.of(statement).map_or(0, |count| count.cases),
            could_fail: random.of(statement).map_or(0, |count| count.could_fail),
            least_overestimation: overestimation(&random),
            witness_overestimation: overestimation(&witnesses),
            proved: proved.of(statement).map_or(0, |count| count.could_fail),
            hypotheses: random.hypotheses(statement).collect(),
            assumed: random.assumed(statement).collect(),
            checks: about.map(|check| check.name).collect(),
        }
    };
    Ok(Statement::ALL.map(entry).to_vec())
}
