//! `paper/tables/mutants.csv`: the named checks still kill the mutants.

use tautline_checks::battery::{Scope, Trial, suite};
use tautline_statements::Mutant;

use super::{Row, Table};
use crate::tidiness::{read, root};

/// The number of random cases per family for which the table was made.
const CASES: u32 = 32;

#[test]
fn every_mutant_has_its_row() {
    let table = Table::read("tables/mutants.csv");
    let names: Vec<&str> = table.rows().map(|row| row.text("mutant")).collect();
    let expected: Vec<String> = Mutant::ALL.iter().map(|mutant| format!("{mutant:?}")).collect();
    assert_eq!(names, expected);
}

/// If a mutant changes no number in the paper's bounds, these bounds cannot detect it. The claims
/// therefore count only the other mutants.
#[test]
fn the_paper_s_bounds_are_judged_by_what_they_could_see() {
    let table = Table::read("tables/mutants.csv");
    let count = |seen: &str, killed: &str| {
        let is = |row: &Row<'_>| {
            row.text("seen_by_paper_bounds_alone") == seen
                && row.text("killed_by_paper_bounds_alone") == killed
        };
        table.rows().filter(is).count()
    };
    let all = Mutant::ALL.len();
    let (killed, pass, unseen) = (count("yes", "yes"), count("yes", "no"), count("no", "no"));
    let seen = killed + pass;
    // No mutant is killed without being seen, and every mutant is either seen or unseen.
    assert_eq!(seen + unseen, all);
    assert!(killed > 0 && pass > 0 && unseen > 0, "{killed}, {pass}, {unseen}");
    for (file, claims) in [
        (
            "README.md",
            vec![
                format!("lists {all} deliberate mistakes"),
                format!("could detect {seen} of them at most, and detects {killed}."),
            ],
        ),
        (
            "docs/mutation-testing.md",
            vec![
                format!("Only {seen} of the {all} mutants change a number"),
                format!("The inequalities alone kill {killed} of these; {pass} survive."),
                format!("The other {unseen} are invisible to them."),
            ],
        ),
        (
            "paper/tables/mutants.md",
            vec![
                format!("Only {seen} of the {all} change a number"),
                format!("{killed} of them are killed and {pass} pass"),
            ],
        ),
    ] {
        let text = read(&root().join(file));
        for claim in claims {
            assert!(text.contains(&claim), "{file} does not say {claim:?}");
        }
    }
}

/// A check that has become too weak would pass both on the library and on the mutant that it used
/// to kill.
#[test]
fn the_first_check_that_kills_a_mutant_still_does() {
    let table = Table::read("tables/mutants.csv");
    let suite = suite();
    for (row, mutant) in table.rows().zip(Mutant::ALL) {
        let name = row.text("killed_by").split("; ").next().expect("one at least");
        let check = suite.iter().find(|check| check.name == name);
        let check = check.unwrap_or_else(|| panic!("no check is called {name}"));
        let subject = mutant.into();
        let trial = Trial::new(&subject, Scope::Everything, CASES);
        assert!(check.run(&trial).is_err(), "{name} does not kill {mutant:?} any more");
    }
}
