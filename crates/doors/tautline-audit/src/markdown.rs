//! A report in Markdown.

use std::fmt::Write;

use crate::{
    answer::{Audit, Status},
    words,
};

/// Returns a report in Markdown: the verdict first, then what is proved, tested and not tried.
#[must_use]
pub fn markdown(audit: &Audit) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = report(audit, &mut text);
    text
}

fn report(audit: &Audit, to: &mut String) -> std::fmt::Result {
    writeln!(to, "# Audit of a metric in {} dimensions\n", audit.dimension)?;
    writeln!(to, "{}\n", words::verdict(audit))?;
    for lie in &audit.lies {
        writeln!(to, "- {}", words::lie(lie))?;
    }
    writeln!(to, "- Constants: {}", words::constants(audit))?;
    writeln!(to, "- Samples: {}", words::samples(audit))?;
    if !audit.measured.is_empty() {
        writeln!(to, "\n## Extreme values that were found\n")?;
        table(to, &["constant", "value", "point", "direction"])?;
    }
    for found in &audit.measured {
        let [point, direction] = [&found.point, &found.direction].map(|x| words::vector(x));
        row(to, &[found.constant, &words::number(found.value), &point, &direction])?;
    }
    if !audit.proved.is_empty() {
        writeln!(to, "\n## Proved\n")?;
        table(to, &["constant", "proof", "in"])?;
    }
    for standing in &audit.proved {
        row(to, &[standing.constant, &standing.proof, &standing.within])?;
    }
    let of = |status| audit.laws.iter().filter(move |law| law.status == status);
    if of(Status::Fails).next().is_some() {
        writeln!(to, "\n## Laws that fail\n")?;
        table(to, &["law", "says", "why"])?;
    }
    for law in of(Status::Fails) {
        row(to, &[law.law, law.says, law.reason.as_deref().unwrap_or_default()])?;
    }
    if of(Status::FalseHypothesis).next().is_some() {
        writeln!(to, "\n## Statements that rest on a false claim\n")?;
        table(to, &["law", "says", "the hypothesis that fails"])?;
    }
    for law in of(Status::FalseHypothesis) {
        row(to, &[law.law, law.says, law.reason.as_deref().unwrap_or_default()])?;
    }
    if of(Status::Holds).next().is_some() {
        writeln!(to, "\n## Laws that hold\n")?;
        table(to, &["law", "says", "cases", "could fail", "overestimation", "assumed"])?;
    }
    for law in of(Status::Holds) {
        let [cases, could_fail] = [law.cases, law.could_fail].map(|count| count.to_string());
        let over = words::overestimation(law.overestimation);
        row(to, &[law.law, law.says, &cases, &could_fail, &over, &law.assumed.join(", ")])?;
    }
    for (title, status) in
        [("Not tried", Status::NotTried), ("Not about this metric", Status::DoesNotApply)]
    {
        let untried = words::untried(audit, status);
        if !untried.is_empty() {
            writeln!(to, "\n## {title}\n")?;
            table(to, &["laws", "why"])?;
        }
        for (reason, laws) in untried {
            row(to, &[&laws.join(", "), reason])?;
        }
    }
    Ok(())
}

fn table(to: &mut String, names: &[&str]) -> std::fmt::Result {
    row(to, names)?;
    row(to, &vec!["---"; names.len()])
}

/// Writes a row. A formula may contain the bar that separates cells.
fn row(to: &mut String, cells: &[&str]) -> std::fmt::Result {
    let cells = cells.iter().map(|cell| cell.replace('|', "\\|").replace('\n', " "));
    writeln!(to, "| {} |", cells.collect::<Vec<_>>().join(" | "))
}
