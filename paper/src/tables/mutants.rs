//! Deliberately wrong variants of the library, and which checks kill them.

use tautline_verify::{
    Mutant,
    battery::{Scope, kills},
};

use super::{Layout, Seed, Table, no_pages};
use crate::{
    Failure,
    data::{Data, Tolerance},
    parallel,
    sweep::Sweep,
};

pub(super) const TABLE: Table = Table {
    id: "mutants",
    shows: "deliberately wrong variants of the library, the checks that kill each of them, and \
            whether the paper's bounds alone, observed <= bound on random cases, would",
    seed: Seed::Suite,
    data,
    layout,
    pages: no_pages,
};

/// Random cases a family where the whole suite is put to a mutant: a mistake that matters shows
/// soon, and that it does not show in the paper's bounds is asked with all cases.
const CASES: u32 = 48;

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("mutant", Tolerance::Exact),
        ("mistake", Tolerance::Exact),
        ("killed_by", Tolerance::Exact),
        ("killed_by_paper_bounds_alone", Tolerance::Exact),
    ]);
    let (cases, all) = if sweep.quick { (8, 32) } else { (CASES, u32::MAX) };
    // Nothing is worth anything if the suite kills the library itself.
    let healthy = kills(None, Scope::Everything, cases);
    if !healthy.is_empty() {
        return Err(Failure::Violated(format!("the library fails {}", healthy.join(", "))));
    }
    let killed = parallel::map(&Mutant::ALL, |mutant| {
        let by_all = kills(Some(*mutant), Scope::Everything, cases);
        let by_paper = kills(Some(*mutant), Scope::PaperAlone, all);
        (by_all, by_paper)
    });
    let mut survivors = Vec::new();
    for (mutant, (by_all, by_paper)) in Mutant::ALL.into_iter().zip(killed) {
        if by_all.is_empty() {
            survivors.push(mutant.mistake());
        }
        data.push(vec![
            format!("{mutant:?}"),
            mutant.mistake().to_owned(),
            by_all.join("; "),
            if by_paper.is_empty() { "no" } else { "yes" }.to_owned(),
        ]);
    }
    if !survivors.is_empty() && !sweep.quick {
        return Err(Failure::Violated(format!("no check kills: {}", survivors.join("; "))));
    }
    Ok(data)
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Deliberately wrong variants: how many checks kill each, the first of them, and whether \
         the paper's bounds alone would.",
        &["mistake", "checks that kill it", "one of them", "paper's bounds alone"],
    );
    for row in data.rows() {
        let killers: Vec<&str> = row.text("killed_by").split("; ").collect();
        layout.push(vec![
            row.text("mistake").to_owned(),
            killers.len().to_string(),
            killers[0].to_owned(),
            row.text("killed_by_paper_bounds_alone").to_owned(),
        ]);
    }
    Ok(layout)
}
