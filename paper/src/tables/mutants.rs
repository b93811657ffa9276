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
    shows: "deliberately wrong variants of the library, the first checks that kill each of them, and \
            whether the paper's bounds alone, observed <= bound on random cases, would",
    seed: Seed::Suite,
    data,
    layout,
    repeatable: true,
    pages: no_pages,
};

/// Random cases a family where a mutant is put to the whole suite: a mistake shows soon.
const CASES: u32 = 32;

/// Random cases a family for the paper's bounds alone, which are asked more patiently.
const CASES_ALONE: u32 = 96;

/// So many checks are named; running the others would add nothing.
const NAMED: usize = 3;

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("mutant", Tolerance::Exact),
        ("mistake", Tolerance::Exact),
        ("killed_by", Tolerance::Exact),
        ("killed_by_paper_bounds_alone", Tolerance::Exact),
    ]);
    let (cases, alone) = if sweep.quick { (8, 32) } else { (CASES, CASES_ALONE) };
    // Nothing is worth anything if the suite kills the library itself.
    let healthy = kills(None, Scope::Everything, cases, usize::MAX);
    if !healthy.is_empty() {
        return Err(Failure::Violated(format!("the library fails {}", healthy.join(", "))));
    }
    let killed = parallel::map(&Mutant::ALL, |mutant| {
        let by_all = kills(Some(*mutant), Scope::Everything, cases, NAMED);
        let by_paper = kills(Some(*mutant), Scope::PaperAlone, alone, 1);
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
        "Deliberately wrong variants: the first check that kills each, and whether the paper's \
         bounds alone would.",
        &["mistake", "killed by", "paper's bounds alone"],
    );
    for row in data.rows() {
        let killers: Vec<&str> = row.text("killed_by").split("; ").collect();
        layout.push(vec![
            row.text("mistake").to_owned(),
            killers[0].to_owned(),
            row.text("killed_by_paper_bounds_alone").to_owned(),
        ]);
    }
    Ok(layout)
}
