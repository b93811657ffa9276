//! The ledger of statements: every label has its row, and everything that a row names exists.

use std::collections::BTreeSet;

use tautline_checks::battery::suite;
use tautline_statements::{Statement, Verdict};

use super::{files, read, root};

/// The labels of the paper's numbered statements, of both claims of Section 5, and of its displayed
/// constants, in the paper's order. They are copied from the paper, not from the program. The
/// labels of our own statements begin with `sharper:`.
const LABELS: [&str; 40] = [
    "theo:approx_numerical_integral_trapezoidal",
    "theo:approx_numerical_integral_trapezoidal_length",
    "theo:approx_numerical_integral_left",
    "theo:approx_numerical_integral_left_length",
    "prop:metric_geodesic_constant",
    "prop:Hopf-Rinow-theorem",
    "prop:bounded_g_completeness",
    "prop:geodesic_min_loc_path_min",
    "prop:geodesic_min_path_min",
    "prop:uniformal_normal_radius",
    "lem:minimal_constant_speed_geodesic",
    "eq:length-left-point-min",
    "eq:length-tra-point-min",
    "prop:geodesic_len_and_energy",
    "prop:bounded_2sets_min",
    "prop:geodesic_len_and_energy_2",
    "prop:existence_discrete_minimizers",
    "prop:morrey_ineq",
    "prop:morrey_ineq_cor",
    "prop:approx_numerical_integral_beta-gamma",
    "prop:functional_lipschitz_estimate",
    "prop:approx_numerical_integral",
    "C_tra(N)",
    "C_tra^sharp",
    "prop:approx_numerical_integral_set",
    "prop:ineq_cube_3/2",
    "prop:approx_numerical_integral_pts",
    "prop:estimate_derivation_g",
    "prop:Christoffel_symbol_estimate",
    "K_{1,g}",
    "K_{2,g}",
    "prop:apriori_estuimate_geodesic",
    "overline K_{3,g}",
    "C (Theorem 1.1)",
    "prop:left_trapezoidal_fomula",
    "prop:approx_numerical_integral_pts_left",
    "overline K_{4,g}",
    "C (Theorem 1.3)",
    "prop:length_energy_estimation",
    "Remark 9.2",
];

/// Returns the label, number, verdict and tests of each row of `paper/tables/statements.csv`.
fn rows() -> Vec<[String; 4]> {
    let text = read(&root().join("paper/tables/statements.csv"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let heads = reader.headers().expect("a header").clone();
    let column = |name: &str| heads.iter().position(|head| head == name).expect("the column");
    let columns = ["label", "number", "verdict", "tests"].map(column);
    let records = reader.records().map(|record| record.expect("a row"));
    records.map(|record| columns.map(|column| record[column].to_owned())).collect()
}

/// Returns all sources below a folder as one text.
fn sources(folder: &str) -> String {
    files(&root().join(folder), "rs").iter().map(|path| read(path)).collect()
}

#[test]
fn every_statement_has_its_row() {
    let rows = rows();
    let labels: Vec<&str> = rows.iter().map(|row| row[0].as_str()).collect();
    let (paper, sharper) = labels.split_at(LABELS.len());
    assert_eq!(paper, LABELS);
    assert!(sharper.iter().all(|label| label.starts_with("sharper:")), "{labels:?}");
    // Each sharper statement has a section with its proof, and the page has no other sections.
    let page = read(&root().join("paper/SHARPER.md"));
    let kinds = ["## Lemma ", "## Theorem ", "## Proposition "];
    let is_one = |line: &&str| kinds.iter().any(|kind| line.starts_with(kind));
    assert_eq!(page.lines().filter(is_one).count(), sharper.len());
    assert_eq!(rows.len(), Statement::ALL.len());
    for (row, statement) in rows.iter().zip(Statement::ALL) {
        let expected = [statement.label(), statement.number(), statement.verdict().name()];
        assert_eq!([&row[0], &row[1], &row[2]], expected);
    }
}

/// The item of a list in Markdown that begins with `head`.
fn item<'a>(section: &'a str, head: &str) -> &'a str {
    section.lines().find_map(|line| line.strip_prefix("- ")?.strip_prefix(head)).unwrap_or_default()
}

/// What its row says of a statement is in its section of the page. The compiler knows that the
/// functions exist.
#[test]
fn every_statement_has_its_section_as_its_row_says() {
    let page = read(&root().join("paper/STATEMENTS.md"));
    // The page has another bar, since `|` ends a cell.
    let set = |claims: &str| -> BTreeSet<String> {
        claims.split("; ").map(|claim| claim.replace('|', "∣")).collect()
    };
    let mut wrong = Vec::new();
    for statement in Statement::ALL {
        let head = format!("\n## {}\n", statement.number());
        let (_, section) = page.split_once(&head).unwrap_or_else(|| panic!("no section {head}"));
        let section = section.split("\n## ").next().expect("the first part");
        let hypotheses: Vec<&str> = statement.hypotheses().collect();
        let hypotheses =
            if hypotheses.is_empty() { "none".to_owned() } else { hypotheses.join("; ") };
        let assumed: Vec<&str> = statement.assumed().collect();
        let code = format!("`tautline_statements::{}`", statement.function());
        let verdict = item(section, "verdict: ");
        for (what, agrees) in [
            ("claim", section.starts_with(&format!("\n{}.\n", statement.claim()))),
            ("code", item(section, "code: ") == code),
            ("verdict", verdict.contains(statement.verdict().name())),
            ("remark", verdict.trim_end_matches('*').ends_with(statement.verdict().remark())),
            ("hypotheses", set(item(section, "hypotheses evaluated: ")) == set(&hypotheses)),
            ("assumed", set(item(section, "assumed: ")) == set(&assumed.join("; "))),
        ] {
            if !agrees {
                wrong.push(format!("{statement}: {what}"));
            }
        }
    }
    assert!(wrong.is_empty(), "STATEMENTS.md does not agree with the table: {wrong:#?}");
}

#[test]
fn the_ledger_names_every_check_and_no_other() {
    let tests: BTreeSet<String> = suite().iter().map(|check| check.name.to_owned()).collect();
    let mut named = BTreeSet::new();
    for [label, _, _, names] in rows() {
        assert!(!names.is_empty(), "{label} has no test");
        named.extend(names.split("; ").map(str::to_owned));
    }
    assert_eq!(named, tests);
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

/// Every sharper statement has a section with its proof, and all functions and tests named there
/// exist.
#[test]
fn every_sharper_statement_is_proved_and_what_its_proof_names_exists() {
    let page = read(&root().join("paper/SHARPER.md"));
    for statement in Statement::ALL.into_iter().filter(|statement| !statement.is_of_the_paper()) {
        let head = format!("\n## {} (", statement.number());
        let section = page.split(&head).nth(1).unwrap_or_else(|| panic!("no section {head}"));
        let section = section.split("\n## ").next().expect("the first part");
        assert!(section.contains("*Proof.*") && section.contains('∎'), "{statement} has no proof");
        let code = section.split("*Code:*").nth(1).expect("a line of code");
        let code = code.lines().next().expect("a line");
        assert!(code.contains(&format!("`{}`", statement.function())), "{statement}: {code}");
    }
    let sources = sources("crates/library/tautline-bounds/src")
        + &sources("crates/companion/tautline-statements/src/statements")
        + &suite().iter().map(|check| check.name).collect::<Vec<_>>().join(" ");
    let lines = page
        .lines()
        .filter(|line| line.starts_with("*Code:*") || line.starts_with("The limits are tests:"));
    let names = lines.flat_map(|line| line.split('`').skip(1).step_by(2));
    let mut count = 0;
    for name in names {
        let name = name.rsplit("::").next().expect("a name");
        let words = sources.split(|c: char| !c.is_alphanumeric() && c != '_');
        assert!(words.into_iter().any(|word| word == name), "SHARPER.md names {name}");
        count += 1;
    }
    assert!(count > 40, "{count} names");
}

/// A case that could not have contradicted a statement is no evidence for it. For each statement,
/// at least a thousand cases, and more than half of those drawn, must therefore be able to fail.
/// The exception is a definition, which compares two ways to write one formula and has no
/// overestimation either.
#[test]
fn most_cases_of_every_statement_could_fail() {
    let text = read(&root().join("paper/tables/statements.csv"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let heads = reader.headers().expect("a header").clone();
    let column = |name: &str| heads.iter().position(|head| head == name).expect("the column");
    let [label, cases, could_fail, overestimation, witness] =
        ["label", "cases", "could_fail", "least_overestimation", "witness_overestimation"]
            .map(column);
    for record in reader.records() {
        let record = record.expect("a row");
        let number = |column: usize| record[column].parse::<u64>().expect("a number");
        if &record[label] == "C_tra(N)" {
            assert_eq!(
                (number(could_fail), &record[overestimation], &record[witness]),
                (0, "", "")
            );
            continue;
        }
        let [all, telling] = [cases, could_fail].map(number);
        assert!(telling >= 1000 && 2 * telling > all, "{}: {telling} of {all}", &record[label]);
    }
}

/// A hypothesis is either a number that is computed, or named as assumed. No statement takes a
/// boolean, and no caller passes an infinite length.
#[test]
fn no_hypothesis_is_handed_in_as_a_promise() {
    let crates = ["statements", "kit", "checks"];
    let sources = crates.map(|name| root().join(format!("crates/companion/tautline-{name}/src")));
    for path in sources.iter().flat_map(|source| files(source, "rs")) {
        let text = read(&path);
        let is_a_statement = path.components().any(|part| part.as_os_str() == "statements");
        for line in text.lines() {
            let yes_or_no = is_a_statement && line.ends_with(": bool,");
            let names = ["prop_", "lemma_", "theorem_", "way_out"];
            let infinite =
                line.contains("f64::INFINITY") && names.into_iter().any(|name| line.contains(name));
            assert!(!yes_or_no && !infinite, "{}: {line}", path.display());
        }
    }
}
