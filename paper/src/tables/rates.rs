//! Proven and observed rates, in continuation of the comparison in the paper's Table 1.

use tautline_statements::slope;

use crate::{
    Failure,
    artefact::Artefact,
    case::{Case, PaperRule, Reference},
    cases::cases,
    convergence,
    data::{Data, Row, Tolerance},
    layout::{Layout, or_dash},
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "rates",
    "the proven orders in 1/N of the discrete minimum, of the energy and of the squared \
     length of the reconstructed curve, with the observed ones, fitted from N = 256 on",
    data,
    layout,
);

/// A quantity compared with `d²`.
#[derive(Clone, Copy, PartialEq)]
enum Quantity {
    Minimum,
    Energy,
    Length,
}

impl Quantity {
    /// Returns its name in the data file, and its name in the table.
    fn names(self) -> (&'static str, &'static str) {
        match self {
            Quantity::Minimum => ("discrete_minimum", "$|E_N-d^2|$"),
            Quantity::Energy => ("energy", "$E(\\gamma^{\\mathrm{pl}})-d^2$"),
            Quantity::Length => ("squared_length", "$L(\\gamma^{\\mathrm{pl}})^2-d^2$"),
        }
    }

    /// Returns its size in a row of the convergence data, in `m²`.
    fn of(self, row: &Row<'_>) -> f64 {
        let d2 = row.number("d_squared");
        match self {
            Quantity::Minimum => (row.number("discrete_energy") - d2).abs(),
            Quantity::Energy => row.number("excess"),
            Quantity::Length => row.number("length_squared") - d2,
        }
    }
}

/// A claimed order, with the regularity that it requires.
#[derive(Clone, Copy)]
struct Claim {
    statement: &'static str,
    rules: &'static [PaperRule],
    regularity: &'static str,
    order: f64,
    depends_on: &'static str,
}

/// The claim in the paper's Table 1, which does not say what its constant depends on.
const EARLIER: Claim = Claim {
    statement: "Rumpf and Wirth (2015)",
    rules: &PaperRule::BOTH,
    regularity: "consistent discretization",
    order: 1.0,
    depends_on: "",
};

/// The claims about all three quantities.
const THEOREMS: [Claim; 3] = [
    Claim {
        statement: "Theorems 1.1 and 1.3",
        rules: &PaperRule::BOTH,
        regularity: "$c_1\\le H\\le c_2$, $H$ Lipschitz",
        order: 0.5,
        depends_on: "$c_1,c_2,L_H,d,D$",
    },
    Claim {
        statement: "Theorems A and C",
        rules: &PaperRule::BOTH,
        regularity: "$c_1\\le H$, $H\\in C^1$ Lipschitz",
        order: 1.0,
        depends_on: "$c_1,L_H,d$",
    },
    Claim {
        statement: "Theorems B and D",
        rules: &[PaperRule::Trapezoidal],
        regularity: "$c_1\\le H$, $H$ and $DH$ Lipschitz",
        order: 2.0,
        depends_on: "$c_1,L_H,M_H,d$",
    },
];

const ALL: [Quantity; 3] = [Quantity::Minimum, Quantity::Energy, Quantity::Length];

/// Returns all claims with their quantities.
fn claims() -> impl Iterator<Item = (Quantity, Claim)> {
    let of_all = |claim: Claim| {
        ALL.map(|quantity| match (quantity, claim.statement) {
            (Quantity::Length, "Theorems 1.1 and 1.3") => {
                (quantity, Claim { statement: "Theorems 1.2 and 1.4", ..claim })
            }
            _ => (quantity, claim),
        })
    };
    [(Quantity::Minimum, EARLIER)].into_iter().chain(THEOREMS.into_iter().flat_map(of_all))
}

/// Slopes are fitted to at least three values with errors below 2e-3 each: see [`LEGIBLE`].
const ORDER: Tolerance = Tolerance::Close { relative: 0.0, absolute: 5e-3 };

/// Differences below this fraction of `d²` are not fitted. Energies are printed with 13 digits, so
/// the difference of two energies has an error of up to `1e-12 d²`.
const LEGIBLE: f64 = 5e-10;

/// How far a fitted order may fall short of the proven order. At `N = 256`, the next term of the
/// expansion is a few per cent of the first.
const SHORT: f64 = 0.05;

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("statement quantity rule regularity proven_order depends_on", Tolerance::Exact),
        ("least_observed_order greatest_observed_order", ORDER),
        ("cases", Tolerance::Exact),
    ]);
    let (solved, cases) = (convergence::data(sweep)?, cases()?);
    for (quantity, claim) in claims() {
        let Claim { statement, rules, regularity, order: proven, depends_on } = claim;
        for &rule in rules {
            let orders = cases.iter().filter_map(|case| observed(&solved, case, rule, quantity));
            let orders: Vec<f64> = orders.collect();
            let least = orders.iter().copied().fold(f64::INFINITY, f64::min);
            let greatest = orders.iter().copied().fold(0.0, f64::max);
            let (quantity, rule) = (quantity.names().0, rule.name());
            if !(least >= proven - SHORT) {
                let claim = format!("{statement}, {quantity}, {rule}: order {least}");
                return Err(Failure::Violated(claim));
            }
            let texts = [statement, quantity, rule, regularity, &proven.to_string(), depends_on];
            let orders =
                [format!("{least:.4}"), format!("{greatest:.4}"), orders.len().to_string()];
            data.push(texts.map(str::to_owned).into_iter().chain(orders));
        }
    }
    Ok(data)
}

/// Returns the order of a quantity on the last five grids of a case. Returns `None` if fewer than
/// three values are legible, as for the length of a straight curve, or if the leading term of
/// `E_N − d²` vanishes or is hidden.
fn observed(solved: &Data, case: &Case, rule: PaperRule, quantity: Quantity) -> Option<f64> {
    if quantity == Quantity::Minimum {
        case.orders.of(rule)?;
    }
    // A proved distance resolves coarse grids only, on which no order shows yet.
    if case.reference != Reference::Exact {
        return None;
    }
    let series = convergence::series(solved, case.name, rule);
    let points: Vec<(f64, f64)> = series[series.len().saturating_sub(5)..]
        .iter()
        .map(|row| (row.number("n"), quantity.of(row), row.number("d_squared")))
        .filter(|(_, value, d2)| *value >= LEGIBLE * d2)
        .map(|(n, value, _)| (n, value))
        .collect();
    (points.len() >= 3).then(|| -slope(&points))
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Proven orders in 1/N, and those observed between N = 256 and 4096: the least and the \
         greatest over the cases in which the quantity exceeds rounding and has a leading term \
         (for the left-endpoint rule, that of the discrete minimum vanishes where H is the same \
         at both ends). From above, Theorem 1.1 has the order 1 for the discrete minimum. Fixed \
         ends in the first row, sets in all others.",
        "statement & quantity & regularity & proven & constant depends on & observed, \
         trapezoidal & cases & observed, left-endpoint & cases",
    );
    let rows: Vec<Row<'_>> = data.rows().collect();
    // The rows for the two rules of a claim are adjacent.
    let same = |a: &Row<'_>, b: &Row<'_>| {
        ["statement", "quantity"].iter().all(|column| a.text(column) == b.text(column))
    };
    for claim in rows.chunk_by(same) {
        let first = claim[0];
        layout.group_by(first.text("regularity"));
        let quantity = ALL.into_iter().find(|q| q.names().0 == first.text("quantity"));
        let quantity = quantity.ok_or_else(|| Failure::Data("an unknown quantity".to_owned()))?;
        let mut cells = vec![
            first.text("statement").to_owned(),
            quantity.names().1.to_owned(),
            first.text("regularity").to_owned(),
            order(first.number("proven_order")),
            or_dash(first.text("depends_on")),
        ];
        for rule in [PaperRule::Trapezoidal, PaperRule::LeftEndpoint] {
            let row = claim.iter().find(|row| row.text("rule") == rule.name());
            cells.extend(row.map_or(["–", "–"].map(str::to_owned), |row| {
                let [least, greatest] = ["least_observed_order", "greatest_observed_order"]
                    .map(|column| row.number(column));
                [format!("${least:.3}$ to ${greatest:.3}$"), row.text("cases").to_owned()]
            }));
        }
        layout.push(cells);
    }
    Ok(layout)
}

/// Returns an order as mathematics, such as `O(N^{-1/2})`.
fn order(order: f64) -> String {
    match order {
        0.5 => "$O(N^{-1/2})$".to_owned(),
        order => format!("$O(N^{{-{order}}})$"),
    }
}
