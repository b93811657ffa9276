//! `paper/tables/tightness.csv`: if a search stopped at an edge of its box, the table says why.

use tautline_checks::adversary::{Beyond, Family, families};
use tautline_statements::LIBRARY;

use super::{Row, Table};

/// Returns the names and printed values of the parameters of a row.
fn parameters<'a>(row: Row<'a>) -> impl Iterator<Item = (&'a str, f64)> {
    let others = row.text("parameters").split("; ").filter_map(|cell| cell.split_once(" = "));
    let n = (!row.text("n").is_empty()).then(|| ("N", row.text("n")));
    others.chain(n).map(|(name, value)| (name, value.parse().expect("a number")))
}

fn family<'a, 'f>(families: &'a [Family<'f>], row: Row<'_>) -> &'a Family<'f> {
    let found = families.iter().find(|family| family.is(row.text("statement"), row.text("family")));
    found.unwrap_or_else(|| panic!("no family {} of {}", row.text("family"), row.text("statement")))
}

/// The test finds the edges from the printed values, so that the column `edges` cannot omit one.
#[test]
fn a_case_at_an_edge_of_its_search_says_why() {
    let table = Table::read("tables/tightness.csv");
    let families = families(&LIBRARY);
    let mut seen = 0;
    for row in table.rows().filter(|row| !row.text("overestimation").is_empty()) {
        let place = format!("{} on {}", row.text("statement"), row.text("family"));
        let family = family(&families, row);
        let reasons: Vec<&str> = row.text("edges").split("; ").collect();
        for (name, value) in parameters(row) {
            let parameter = family.parameters.iter().find(|parameter| parameter.name == name);
            let parameter = parameter.unwrap_or_else(|| panic!("{place}: no parameter {name}"));
            let Some(end) = parameter.end(value) else { continue };
            let beyond = parameter.beyond(end);
            let beyond = beyond.unwrap_or_else(|| panic!("{place}: {name} = {value} is cut off"));
            let (Beyond::Nothing(reason) | Beyond::Limit(reason)) = beyond;
            assert!(reasons.contains(&reason), "{place}: {name} = {value} without its reason");
            seen += 1;
        }
    }
    assert!(seen > 0, "no case is at an edge");
}

/// The program that makes the table measures how far the end of a range is from the limit.
#[test]
fn no_search_is_cut_off() {
    let table = Table::read("tables/tightness.csv");
    for row in table.rows() {
        let [statement, family, edges] =
            ["statement", "family", "edges"].map(|name| row.text(name));
        assert!(!edges.contains("cut off"), "{statement} on {family}: {edges}");
    }
}
