//! The tightest cases that the adversary finds, statement by statement and family by family.

use tautline_checks::adversary::{Edge, Search, Tightest, families};
use tautline_statements::{LIBRARY, Source};

use super::statements::symbol;
use crate::{
    Failure,
    artefact::{Artefact, Seed},
    data::{Data, Row, Tolerance},
    layout::{Layout, or_dash, scientific},
    sweep::Sweep,
};

/// The seed is the year of the pattern search by Hooke and Jeeves.
const SEED: u64 = 1961;

pub(super) const TABLE: Artefact = Artefact::table(
    "tightness",
    "the least overestimation bound/observed that a search over metrics, ends and N finds for \
     each statement in each family, by its own conclusions and by their sharper companions; and, \
     for a case at edges of the search, why there is no tighter one beyond",
    data,
    layout,
)
.seeded(Seed::One(SEED));

/// One per cent: the search stops when a step changes the overestimation by a tenth of this.
const OVERESTIMATION: Tolerance = Tolerance::relative(1e-2);

fn data(sweep: Sweep) -> Result<Data, Failure> {
    // If a minimum is flat, or if two conclusions or two cases tie, the last bits of elementary
    // functions decide which one is found. Only the overestimation is therefore compared.
    let mut data = Data::new(&[
        ("statement family conclusions", Tolerance::Exact),
        ("overestimation", OVERESTIMATION),
        ("n tightest_conclusion parameters edges", Tolerance::Free),
    ]);
    let full = Search { seed: SEED, ..Search::default() };
    let search = if sweep.quick { Search { restarts: 1, ..full } } else { full };
    for family in families(&LIBRARY) {
        for (source, name) in [(Source::Stated, "stated"), (Source::Sharper, "sharper")] {
            // Some families never use a bound, such as the bound on the length on the line, where
            // every reconstruction has the length d. They have no overestimation.
            let found = search.tightest(&family, source)?;
            let of = |cell: fn(&Tightest) -> String| found.as_ref().map_or(String::new(), cell);
            data.push(vec![
                family.statement.number().to_owned(),
                family.name.to_owned(),
                name.to_owned(),
                of(|found| format!("{:.4e}", found.overestimation)),
                of(|found| found.parameter("N").map_or(String::new(), |n| n.to_string())),
                of(|found| found.conclusion.claim.to_owned()),
                of(case),
                of(edges),
            ]);
        }
    }
    Ok(data)
}

/// Returns the parameters except `N`, to three digits.
fn case(found: &Tightest) -> String {
    let others = found.parameters.iter().filter(|(name, _)| *name != "N");
    let cells = others.map(|(name, value)| format!("{name} = {}", three_digits(*value)));
    cells.collect::<Vec<_>>().join("; ")
}

/// Returns why nothing is tighter beyond the ends of the ranges that the case has reached.
fn edges(found: &Tightest) -> String {
    found.edges.iter().map(Edge::to_string).collect::<Vec<_>>().join("; ")
}

fn three_digits(value: f64) -> String {
    let small = value != 0.0 && value.abs() < 1e-2;
    if small { format!("{value:.2e}") } else { format!("{:.3}", value + 0.0) }
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "For each statement and each family of problems the least overestimation bound/observed \
         that a search finds: of the bound as stated and of its sharper companion, each with its \
         N. The case belongs to the former: step is the distance of the ends over N, phi or way \
         the direction, a or L the amplitude of the metric. At the edge are the parameters at an \
         end of their range, and why the search ends there: nothing lies beyond, or a limit, \
         towards which the overestimation falls by at most 1 %. Families in which only rounding \
         is observed are left out, such as the length of one chord on the line, and Proposition \
         7.9 where H is linear.",
        "statement & family & overestimation & $N$ & sharper overestimation & $N$ & case & \
         at the edge",
    );
    let rows: Vec<Row<'_>> = data.rows().collect();
    for pair in rows.chunks(2) {
        let [paper, sharper] = pair else {
            return Err(Failure::Data("a family without its second row".to_owned()));
        };
        if paper.text("overestimation").is_empty() && sharper.text("overestimation").is_empty() {
            continue;
        }
        layout.group_by(paper.text("statement"));
        let mut cells = vec![symbol(paper.text("statement")), paper.text("family").to_owned()];
        for row in [paper, sharper] {
            cells.extend([overestimation(row.number("overestimation")), or_dash(row.text("n"))]);
        }
        cells.extend([paper.text("parameters"), paper.text("edges")].map(or_dash));
        layout.push(cells);
    }
    Ok(layout)
}

/// Returns the overestimation with four or five digits.
fn overestimation(value: f64) -> String {
    match value {
        1e4.. => scientific(value, 2),
        100.0.. => format!("${value:.1}$"),
        0.0.. => format!("${value:.3}$"),
        _ => "–".to_owned(),
    }
}
