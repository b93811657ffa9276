//! The table of the mutants: what it says kills a mutant still does.

use tautline_verify::{
    Mutant,
    battery::{Scope, Trial, suite},
};

use super::Table;

/// As many random cases a family as the table was made with.
const CASES: u32 = 32;

#[test]
fn every_mutant_has_its_row() {
    let table = Table::read("tables/mutants.csv");
    let names: Vec<&str> = table.rows().map(|row| row.text("mutant")).collect();
    let expected: Vec<String> = Mutant::ALL.iter().map(|mutant| format!("{mutant:?}")).collect();
    assert_eq!(names, expected);
}

/// A check that was made too weak passes on the library, and on the mutant that it used to kill.
#[test]
fn the_first_check_that_kills_a_mutant_still_does() {
    let table = Table::read("tables/mutants.csv");
    let suite = suite();
    for (row, mutant) in table.rows().zip(Mutant::ALL) {
        let name = row.text("killed_by").split("; ").next().expect("one at least");
        let check = suite.iter().find(|check| check.name == name);
        let check = check.unwrap_or_else(|| panic!("no check is called {name}"));
        let trial = Trial { subject: &Some(mutant), scope: Scope::Everything, cases: CASES };
        assert!(check.run(&trial).is_err(), "{name} does not kill {mutant:?} any more");
    }
}
