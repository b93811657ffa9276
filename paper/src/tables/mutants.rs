//! Deliberately wrong variants of the library, and the checks that kill them.

use tautline_checks::battery::{Examination, Scope, Sight};
use tautline_statements::Mutant;

use crate::{
    Failure,
    artefact::{Artefact, Seed},
    data::{Data, Row, Tolerance},
    layout::Layout,
    parallel,
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "mutants",
    "deliberately wrong variants of the library, the first checks that kill each of them, whether \
     the paper's bounds alone (observed <= bound on random cases) see a number that differs from \
     the library's, and whether they kill it",
    data,
    layout,
)
.seeded(Seed::Suite);

/// Random cases per family when the whole suite runs against a mutant, where a mistake shows early.
const CASES: u32 = 32;

/// Random cases per family for the paper's bounds alone, which need more cases to detect a mistake.
const CASES_ALONE: u32 = 96;

/// Whether the paper's bounds alone compare any number that differs from the library's.
const SEEN: &str = "seen_by_paper_bounds_alone";

/// Whether one of the paper's bounds is violated.
const KILLED: &str = "killed_by_paper_bounds_alone";

/// The number of checks that are named. Further checks do not run.
const NAMED: usize = 3;

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("mutant mistake killed_by", Tolerance::Exact),
        (SEEN, Tolerance::Exact),
        (KILLED, Tolerance::Exact),
    ]);
    let (cases, alone) = if sweep.quick { (8, 32) } else { (CASES, CASES_ALONE) };
    // The kills would mean nothing if the suite killed the library itself.
    let put = |scope, cases| {
        Examination::new(scope, cases).map_err(|failure| Failure::Violated(failure.message))
    };
    let (suite, paper) = (put(Scope::Everything, cases)?, put(Scope::PaperAlone, alone)?);
    let killed =
        parallel::map(&Mutant::ALL, |&mutant| (suite.kills(mutant, NAMED), paper.sight(mutant)));
    let mut survivors = Vec::new();
    for (mutant, (by_all, sight)) in Mutant::ALL.into_iter().zip(killed) {
        if by_all.is_empty() {
            survivors.push(mutant.mistake());
        }
        data.push(vec![
            format!("{mutant:?}"),
            mutant.mistake().to_owned(),
            by_all.join("; "),
            yes_or_no(sight != Sight::Unseen),
            yes_or_no(sight == Sight::Killed),
        ]);
    }
    if !survivors.is_empty() && !sweep.quick {
        return Err(Failure::Violated(format!("no check kills: {}", survivors.join("; "))));
    }
    Ok(data)
}

fn yes_or_no(answer: bool) -> String {
    if answer { "yes" } else { "no" }.to_owned()
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let is = |column: &'static str, answer: &'static str| {
        move |row: &Row<'_>| row.text(column) == answer
    };
    let (all, seen) = (data.rows().count(), data.rows().filter(is(SEEN, "yes")));
    let (seen, killed) = (seen.count(), data.rows().filter(is(KILLED, "yes")).count());
    let caption = format!(
        "{all} deliberately wrong variants: the first check that kills each, and the verdict of the \
         paper's bounds alone (observed ≤ bound on random cases). Only {seen} of the {all} change a \
         number that these compare; {killed} of them are killed and {passed} pass. The other {unseen} \
         are invisible to them (–).",
        passed = seen - killed,
        unseen = all - seen,
    );
    let mut layout = Layout::new(caption, "mistake & killed by & paper's bounds alone");
    for row in data.rows() {
        let killers: Vec<&str> = row.text("killed_by").split("; ").collect();
        layout.push(vec![
            row.text("mistake").to_owned(),
            killers[0].to_owned(),
            match (row.text(SEEN), row.text(KILLED)) {
                ("no", _) => "–",
                (_, "yes") => "kill it",
                _ => "pass it",
            }
            .to_owned(),
        ]);
    }
    Ok(layout)
}
