//! The project's own suite as a whole; each of its checks is a test of the target `suite`.

mod coverage;
mod examination;

use std::collections::BTreeSet;

use tautline_suite::battery::suite;

#[test]
fn no_two_checks_have_one_name() {
    let names: BTreeSet<&str> = suite().iter().map(|check| check.name).collect();
    assert_eq!(names.len(), suite().len());
}
