//! The ledger: what the whole suite shows about each statement.

use tautline_statements::{LIBRARY, Statement};

use super::{Failure, Kind, Scope, Tally, Trial, suite};

/// What the suite shows about one statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The statement.
    pub statement: Statement,
    /// The number of random cases on which it was evaluated.
    pub cases: u64,
    /// The number of these cases that could have failed; the others satisfy any bound.
    pub could_fail: u64,
    /// The smallest overestimation in these cases, a pure number; `∞` if none was observed.
    pub least_overestimation: f64,
    /// The smallest overestimation of its witnesses, a pure number.
    pub witness_overestimation: f64,
    /// The number of cases with proved numbers that could have failed.
    pub proved: u64,
    /// The claims of the hypotheses that were evaluated on random cases.
    pub hypotheses: Vec<&'static str>,
    /// The claims of the hypotheses that were assumed for random cases.
    pub assumed: Vec<&'static str>,
    /// The names of the checks that are about it.
    pub checks: Vec<&'static str>,
}

/// Runs the whole suite on the library, and returns an entry for each statement.
///
/// # Errors
///
/// The failure of the first check that fails, with its name.
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
