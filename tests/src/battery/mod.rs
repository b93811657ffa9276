//! Every check of the project's own suite as a test of its own name.

mod coverage;
mod dropped;
mod examination;
mod existence;
mod global_minima;
mod golden;
mod gradients;
mod leading_constants;
mod orders;
mod point_sequences;
mod proved_numbers;
mod section_1;
mod section_3;
mod section_4;
mod section_5;
mod section_6;
mod section_7_algebra;
mod section_7_apriori;
mod section_7_morrey;
mod section_7_sampling;
mod section_9;
mod sharper;
mod theorem_witnesses;

use std::collections::BTreeSet;

use tautline_kit::Chance;
use tautline_statements::LIBRARY;
use tautline_suite::battery::{Scope, Trial, suite};

/// Names the checks of one section; each becomes a test.
macro_rules! checks {
    ($($name:ident)*) => {
        pub(super) const NAMES: &[&str] = &[$(stringify!($name)),*];

        $(
            #[test]
            fn $name() {
                super::passes(stringify!($name));
            }
        )*
    };
}
use checks;

/// Runs the check of this name on the library.
#[track_caller]
fn passes(name: &str) {
    let check = suite().into_iter().find(|check| check.name == name);
    let check = check.unwrap_or_else(|| panic!("no check is called {name}"));
    let chance = Chance::asked();
    let trial = Trial { chance, ..Trial::new(&LIBRARY, Scope::Everything, u32::MAX) };
    if let Err(failure) = check.run(&trial) {
        panic!("{}", failure.of_check(name, chance));
    }
}

#[test]
fn every_check_is_a_test() {
    let checks: BTreeSet<&str> = suite().iter().map(|check| check.name).collect();
    assert_eq!(checks.len(), suite().len(), "two checks of one name");
    let sections = [
        section_1::NAMES,
        theorem_witnesses::NAMES,
        orders::NAMES,
        leading_constants::NAMES,
        golden::NAMES,
        gradients::NAMES,
        section_3::NAMES,
        section_4::NAMES,
        section_5::NAMES,
        global_minima::NAMES,
        section_6::NAMES,
        existence::NAMES,
        section_7_morrey::NAMES,
        section_7_algebra::NAMES,
        section_7_sampling::NAMES,
        section_7_apriori::NAMES,
        point_sequences::NAMES,
        proved_numbers::NAMES,
        section_9::NAMES,
        dropped::NAMES,
        sharper::NAMES,
    ];
    let tests: BTreeSet<&str> = sections.concat().into_iter().collect();
    assert_eq!(checks, tests);
}
