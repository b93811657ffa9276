//! The ledger: every statement of the paper and every sharper statement, with our verdict and the
//! results of the suite.

use std::collections::BTreeSet;

use tautline_checks::battery::ledger;
use tautline_statements::{Statement, Verdict};

use crate::{
    Failure,
    artefact::{Artefact, Seed},
    data::{Data, Row, Tolerance},
    layout::{Layout, scientific},
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "statements",
    "every statement of the paper and every sharper one with our verdict, the number of \
     random cases and of those that could fail, their least overestimation (bound / observed), the \
     overestimation of the best witness, the tests, the hypotheses that are evaluated with it and \
     those that are assumed, and the number of cases in which every number is proved with \
     outward rounding",
    data,
    layout,
)
.seeded(Seed::Suite)
.with_pages(pages);

/// The smallest number of random cases for a statement that could fail.
const CASES: u64 = 1000;

/// The only definition among the statements. Its cases compare two ways to write it and cannot
/// fail. What it defines is tested with the other statements.
const DEFINITION: Statement = Statement::ConstantCTra;

/// Overestimations are compared loosely, because they depend on where the solver stops.
const OVERESTIMATION: Tolerance = Tolerance::relative(0.02);

/// In at most one case in a hundred, the last digits decide whether a number is distinct from 0.
const TOLD: Tolerance = Tolerance::relative(0.01);

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("label number verdict cases", Tolerance::Exact),
        ("could_fail", TOLD),
        ("least_overestimation witness_overestimation", OVERESTIMATION),
        ("tests hypotheses assumed", Tolerance::Exact),
        ("proved", TOLD),
    ]);
    let mut missing = Vec::new();
    for entry in ledger()? {
        let statement = entry.statement;
        let enough = match statement {
            DEFINITION => entry.cases >= CASES && entry.could_fail == 0,
            _ => entry.could_fail >= CASES && entry.witness_overestimation.is_finite(),
        };
        if !enough {
            missing.push(format!(
                "{statement}: {} cases of which {} could fail, witness of overestimation {}",
                entry.cases, entry.could_fail, entry.witness_overestimation
            ));
        }
        for (what, found, stated) in [
            ("hypotheses", &entry.hypotheses, statement.hypotheses().collect::<Vec<_>>()),
            ("assumptions", &entry.assumed, statement.assumed().collect()),
        ] {
            let [seen, row] = [found, &stated].map(|list| list.iter().collect::<BTreeSet<_>>());
            if seen != row {
                missing.push(format!("{statement}: {what} {seen:?}, but its row has {row:?}"));
            }
        }
        let overestimation = |overestimation: f64| {
            if overestimation.is_finite() { format!("{overestimation:.3e}") } else { String::new() }
        };
        data.push(vec![
            statement.label().to_owned(),
            statement.number().to_owned(),
            statement.verdict().name().to_owned(),
            entry.cases.to_string(),
            entry.could_fail.to_string(),
            overestimation(entry.least_overestimation),
            overestimation(entry.witness_overestimation),
            entry.checks.join("; "),
            statement.hypotheses().collect::<Vec<_>>().join("; "),
            statement.assumed().collect::<Vec<_>>().join("; "),
            entry.proved.to_string(),
        ]);
    }
    if !missing.is_empty() {
        return Err(Failure::Violated(format!("the ledger has gaps:\n{}", missing.join("\n"))));
    }
    Ok(data)
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "The statements of the paper, and sharper ones: our verdict, random cases and those of them \
         that could fail, and overestimation (bound / observed) at random and at the best witness.",
        "statement & verdict & cases & could fail & least overestimation at random & \
         overestimation of the witness",
    );
    for row in data.rows() {
        layout.push(vec![
            symbol(row.text("number")),
            row.text("verdict").to_owned(),
            row.text("cases").to_owned(),
            row.text("could_fail").to_owned(),
            overestimation(&row, "least_overestimation"),
            overestimation(&row, "witness_overestimation"),
        ]);
    }
    Ok(layout)
}

/// Returns a symbol as mathematics that both Markdown and LaTeX understand.
pub(super) fn symbol(number: &str) -> String {
    match number {
        "C_tra(N)" => "$C_{\\mathrm{tra}}(N)$".to_owned(),
        "C_tra♯" => "$C_{\\mathrm{tra}}^\\sharp$".to_owned(),
        "K_{1,g}" => "$K_{1,g}$".to_owned(),
        "K_{2,g}" => "$K_{2,g}$".to_owned(),
        "K̄_{3,g}" => "$\\overline K_{3,g}$".to_owned(),
        "K̄_{4,g}" => "$\\overline K_{4,g}$".to_owned(),
        other => other.to_owned(),
    }
}

fn overestimation(row: &Row<'_>, column: &str) -> String {
    let value = row.number(column);
    match value {
        value if value.is_nan() => "–".to_owned(),
        value if value < 1000.0 => format!("${value:.3}$"),
        value => scientific(value, 1),
    }
}

/// Returns `STATEMENTS.md`, the ledger for readers, with one section for each statement.
fn pages(data: &Data) -> Vec<(&'static str, String)> {
    let mut text = "\
# The statements of the paper, and sharper ones

This page lists every numbered statement of the paper, both claims of Section 5 and every displayed constant, followed by the statements of [SHARPER.md](SHARPER.md). For each it gives the claim, the function that evaluates it, our verdict, and the tests.
`cargo xtask tables statements` writes this page together with `tables/statements.csv`.
*Overestimation* is the bound divided by what is observed: 1 where a statement is attained.
A case *could fail* if the bound is finite and the observed number is distinguishable from 0. If a gap vanishes identically (on the line, the gap of the length does), the case holds for any bound and cannot fail.
An *assumed* hypothesis is one that the cases cannot test.
A *witness* is a case built by hand to come as near to equality as possible.
*Holds* reports the outcome of these tests and is not a proof: no case contradicts the statement as printed. A *cited* statement is a known theorem; only its observable part is tested. The printed form of a *refuted* statement is contradicted by a witness, and its repaired form is tested. A statement *proved here* has its proof in SHARPER.md.
`γᵖ` is the point sequence and `γᵖˡ` the polygon through it; the other symbols are those of the paper and of the first section of SHARPER.md.

"
    .to_owned();
    for (row, statement) in data.rows().zip(Statement::ALL) {
        text += &section(&row, statement);
    }
    vec![("STATEMENTS.md", text)]
}

fn section(row: &Row<'_>, statement: Statement) -> String {
    let verdict = match statement.verdict() {
        Verdict::Holds | Verdict::Cited => statement.verdict().name().to_owned(),
        Verdict::ProvedHere => "proved here".to_owned() + ", in [SHARPER.md](SHARPER.md)",
        verdict => format!("{}: {}", verdict.name(), verdict.remark()),
    };
    let tests: Vec<String> =
        row.text("tests").split("; ").map(|test| format!("`{test}`")).collect();
    let hypotheses = match row.text("hypotheses") {
        "" => "none".to_owned(),
        claims => claims.replace('|', "∣"),
    };
    let assumed = match row.text("assumed") {
        "" => String::new(),
        claims => format!("- assumed: {}\n", claims.replace('|', "∣")),
    };
    let overestimation = |column: &str| match row.text(column) {
        "" if statement == DEFINITION => {
            "not applicable: both sides are one formula, written in two ways".to_owned()
        }
        "" => "indistinguishable from rounding".to_owned(),
        overestimation => overestimation.to_owned(),
    };
    let proved = match row.text("proved") {
        "0" => String::new(),
        cases => {
            format!("- cases that could fail with every number proved by intervals: {cases}\n")
        }
    };
    format!(
        "## {}\n\n{}.\n\n- label: `{}`\n- code: `tautline_statements::{}`\n- verdict: \
         **{verdict}**\n- hypotheses evaluated: {hypotheses}\n{assumed}- random cases: {}, of which {} \
         could fail, least overestimation {}\n- overestimation of the best witness: {}\n{proved}- \
         tests: {}\n\n",
        statement.number(),
        statement.claim(),
        statement.label(),
        statement.function(),
        row.text("cases"),
        row.text("could_fail"),
        overestimation("least_overestimation"),
        overestimation("witness_overestimation"),
        tests.join(", "),
    )
}
