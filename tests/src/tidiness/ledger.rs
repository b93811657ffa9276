//! The ledger of statements: every label has its row, and what a row names exists.

use std::collections::BTreeSet;

use tautline_verify::{Statement, Verdict};

use super::{files, read, root};

/// The rows of `paper/tables/statements.csv`, as label, number, verdict and tests.
fn rows() -> Vec<[String; 4]> {
    let text = read(&root().join("paper/tables/statements.csv"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let heads = reader.headers().expect("a header").clone();
    let column = |name: &str| heads.iter().position(|head| head == name).expect("the column");
    let columns = ["label", "number", "verdict", "tests"].map(column);
    let records = reader.records().map(|record| record.expect("a row"));
    records.map(|record| columns.map(|column| record[column].to_owned())).collect()
}

/// All sources below a folder, in one text.
fn sources(folder: &str) -> String {
    files(&root().join(folder), "rs").iter().map(|path| read(path)).collect()
}

#[test]
fn every_statement_has_its_row() {
    let rows = rows();
    assert_eq!(rows.len(), Statement::ALL.len());
    for (row, statement) in rows.iter().zip(Statement::ALL) {
        let expected = [statement.label(), statement.number(), statement.verdict().name()];
        assert_eq!([&row[0], &row[1], &row[2]], expected);
    }
}

#[test]
fn every_function_that_the_ledger_names_exists() {
    let statements = sources("crates/tautline-verify/src/statements");
    let page = read(&root().join("paper/STATEMENTS.md"));
    for statement in Statement::ALL {
        let (name, head) = (statement.function(), format!("\n## {}\n", statement.number()));
        let defined =
            ["<", "("].iter().any(|next| statements.contains(&format!("fn {name}{next}")));
        assert!(defined, "{statement} names {name}");
        assert!(page.contains(&head), "STATEMENTS.md has no section on {statement}");
        assert!(page.contains(&format!("::{name}`")), "STATEMENTS.md does not name {name}");
    }
}

#[test]
fn every_test_that_the_ledger_names_exists() {
    let battery = sources("tests/src/battery");
    let tests: BTreeSet<&str> = battery.split_whitespace().collect();
    for [label, _, _, names] in rows() {
        assert!(!names.is_empty(), "{label} has no test");
        for name in names.split("; ") {
            assert!(tests.contains(name), "{label} names {name}");
        }
    }
}

#[test]
fn every_refuted_statement_is_among_the_errata() {
    let page = read(&root().join("paper/ERRATA.md"));
    for statement in Statement::ALL {
        let head = format!("\n## {}\n", statement.number());
        let refuted = matches!(statement.verdict(), Verdict::RefutedRepairedAs(_));
        assert_eq!(page.contains(&head), refuted, "{statement}");
    }
}
