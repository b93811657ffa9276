//! Tests of the project's own suite as a whole. The target `suite` runs each of its checks as a
//! test.

mod coverage;
mod examination;

use std::collections::BTreeSet;

use tautline_checks::battery::suite;

#[test]
fn no_two_checks_have_one_name() {
    let names: BTreeSet<&str> = suite().iter().map(|check| check.name).collect();
    assert_eq!(names.len(), suite().len());
}
