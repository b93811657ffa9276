//! Errors and observed orders of both rules on every case.

use crate::{
    Failure,
    artefact::Artefact,
    case::PaperRule,
    cases::cases,
    convergence::{data, series},
    data::{Data, Row},
    layout::{Layout, scientific},
};

pub(super) const TABLE: Artefact = Artefact::table(
    "convergence",
    "the errors of discrete energy, reconstructed energy and squared length for both rules, \
     with observed orders and the bound C/sqrt(N)",
    data,
    layout,
);

/// Every fourth power of two; the data file contains all powers.
const SHOWN: [usize; 5] = [1, 16, 256, 1024, 4096];

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Errors in m², with the order observed between N/2 and N.",
        "case & rule & $N$ & $E_N-d^2$ & order & $E(\\gamma^{\\mathrm{pl}})-d^2$ & order & \
         $L(\\gamma^{\\mathrm{pl}})^2-d^2$ & order & bound $C/\\sqrt N$",
    );
    for case in cases()? {
        for rule in PaperRule::BOTH {
            layout.group();
            let series = series(data, case.name, rule);
            for (k, row) in series.iter().enumerate() {
                if SHOWN.contains(&(row.number("n") as usize)) {
                    layout.push(cells(row, k.checked_sub(1).map(|before| &series[before])));
                }
            }
        }
    }
    Ok(layout)
}

fn cells(row: &Row<'_>, before: Option<&Row<'_>>) -> Vec<String> {
    let of = |row: &Row<'_>, column: &str| match column {
        "excess" => row.number(column),
        _ => row.number(column) - row.number("d_squared"),
    };
    let mut cells = vec![
        row.text("case").to_owned(),
        row.text("rule").replace('_', "-"),
        row.text("n").to_owned(),
    ];
    for column in ["discrete_energy", "excess", "length_squared"] {
        let value = of(row, column);
        // Differences of energies printed with 13 digits. Below this, they are rounding errors.
        let noise = 1e-11 * row.number("d_squared");
        let legible = |value: f64| value.abs() > noise;
        cells.push(if legible(value) { scientific(value, 3) } else { "$0$".to_owned() });
        let order = before.map(|before| of(before, column)).and_then(|old| {
            let halvings = (row.number("n") / before?.number("n")).log2();
            (legible(old) && legible(value) && old.signum() == value.signum())
                .then(|| (old / value).log2() / halvings)
        });
        cells.push(order.map_or_else(|| "–".to_owned(), |order| format!("${order:.2}$")));
    }
    cells.push(scientific(row.number("paper_bound"), 2));
    cells
}
