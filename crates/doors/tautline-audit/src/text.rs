//! A report as text for a terminal.

use std::fmt::Write;

use crate::{
    answer::{Audit, Status},
    words,
};

/// Returns a report as text: the verdict first, then what is proved, tested and not tried.
#[must_use]
pub fn text(audit: &Audit) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = report(audit, &mut text);
    text
}

fn report(audit: &Audit, to: &mut String) -> std::fmt::Result {
    writeln!(to, "{}", words::verdict(audit))?;
    for lie in &audit.lies {
        writeln!(to, "  {}", words::lie(lie))?;
    }
    writeln!(to, "\nconstants  {}", words::constants(audit))?;
    writeln!(to, "samples    {}", words::samples(audit))?;
    if !audit.measured.is_empty() {
        writeln!(to, "\nThe extreme values that were found:")?;
    }
    for found in &audit.measured {
        let [point, direction] = [&found.point, &found.direction].map(|x| words::vector(x));
        let value = words::number(found.value);
        writeln!(to, "  {:<4} {value} at x = {point}, w = {direction}", found.constant)?;
    }
    if !audit.proved.is_empty() {
        writeln!(to, "\nWhat is proved of the constants:")?;
    }
    for standing in &audit.proved {
        writeln!(to, "  {:<4} {}, in {}", standing.constant, standing.proof, standing.within)?;
    }
    let of = |status| audit.laws.iter().filter(move |law| law.status == status);
    if of(Status::Fails).next().is_some() {
        writeln!(to, "\nThe laws that fail:")?;
    }
    for law in of(Status::Fails) {
        writeln!(to, "  {}: {}", law.law, law.says)?;
        writeln!(to, "    {}", law.reason.as_deref().unwrap_or_default())?;
        if let Some(sample) = &law.sample {
            writeln!(to, "    smallest random sample that breaks it: {sample}")?;
        }
    }
    let resting: Vec<&str> = of(Status::FalseHypothesis).map(|law| law.law).collect();
    if !resting.is_empty() {
        writeln!(to, "\nNothing is learnt from statements that rest on a false claim:")?;
        list(to, &resting)?;
    }
    if of(Status::Holds).next().is_some() {
        let head = ("The laws that hold:", "cases", "could fail", "overestimation");
        writeln!(to, "\n{:<36} {:>8} {:>11} {:>15}", head.0, head.1, head.2, head.3)?;
    }
    for law in of(Status::Holds) {
        let over = words::overestimation(law.overestimation);
        let (id, cases, could_fail) = (law.law, law.cases, law.could_fail);
        writeln!(to, "  {id:<34} {cases:>8} {could_fail:>11} {over:>15}  {}", law.says)?;
        if !law.assumed.is_empty() {
            writeln!(to, "    assumed: {}", law.assumed.join(", "))?;
        }
        if let Some(note) = &law.reason {
            writeln!(to, "    {note}")?;
        }
    }
    for (title, status) in
        [("Not tried:", Status::NotTried), ("Not about this metric:", Status::DoesNotApply)]
    {
        let untried = words::untried(audit, status);
        if !untried.is_empty() {
            writeln!(to, "\n{title}")?;
        }
        for (reason, laws) in untried {
            writeln!(to, "  {reason}:")?;
            list(to, &laws)?;
        }
    }
    Ok(())
}

/// The number of columns that a list fills.
const COLUMNS: usize = 100;

/// Writes names, separated by commas, in lines of limited length.
fn list(to: &mut String, names: &[&str]) -> std::fmt::Result {
    let mut line = "   ".to_owned();
    for (k, name) in names.iter().enumerate() {
        let comma = if k + 1 < names.len() { "," } else { "" };
        if line.len() + name.len() + 2 > COLUMNS {
            writeln!(to, "{line}")?;
            line = "   ".to_owned();
        }
        write!(line, " {name}{comma}")?;
    }
    writeln!(to, "{line}")
}
