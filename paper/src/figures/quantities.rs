//! The three quantities that the theorems compare with `d²`, against `N`.

use super::triangle_below;
use crate::{
    Failure,
    artefact::Artefact,
    case::PaperRule,
    cases::{cases_named, over_a_ridge},
    data::{Data, Row, Tolerance},
    drawing::{self, Axis, Curve, Marker, Panel, Scale, Scene, palette},
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "quantities",
    "the discrete energy, the energy and the squared length of the reconstructed curve \
     minus d^2 against N, for both rules: where the left-endpoint rule shows its first \
     order, and where the second hides it up to some hundred chords",
    data,
    draw,
);

/// One row of panels for each: the general case, and a case with nearly the same `H` at both ends.
const CASES: [(&str, &str); 2] = [
    ("valleys_oblique", "valleys, $(0,0)$ to $(2,3/2)$"),
    ("valleys_ridge", "over a ridge, $(1,0)$ to $(5.29,1)$"),
];

/// Differences of energies up to 200, each with an error of 1e-13.
const GAP: Tolerance = Tolerance::Close { relative: 1e-6, absolute: 2e-11 };

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("case rule n", Tolerance::Exact),
        ("discrete_energy_gap energy_gap squared_length_gap", GAP),
    ]);
    let [general, hidden] = [cases_named(&[CASES[0].0])?, vec![over_a_ridge()?]];
    for case in general.iter().chain(&hidden) {
        for rule in PaperRule::BOTH {
            for n in sweep.powers_of_two(4096) {
                let seen = case.solve(rule, n)?;
                let values = [seen.discrete_energy, seen.energy.value, seen.length_squared.value];
                let names = [case.name.to_owned(), rule.name().to_owned(), n.to_string()];
                let gaps = values.map(|value| value - case.distance_squared);
                data.push(names.into_iter().chain(gaps.map(|gap| format!("{gap:.6e}"))));
            }
        }
    }
    Ok(data)
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let columns = ["discrete_energy_gap", "energy_gap", "squared_length_gap"];
    let last = data.greatest("n");
    let mut rows = Vec::new();
    for (k, (name, title)) in CASES.into_iter().enumerate() {
        let of_case = || data.rows_with("case", name);
        let values = of_case().flat_map(|row| columns.map(|column| row.number(column).abs()));
        let values: Vec<f64> = values.collect();
        let mut panels = Vec::new();
        for rule in [PaperRule::Trapezoidal, PaperRule::LeftEndpoint] {
            let left = rule == PaperRule::LeftEndpoint;
            let x = Axis::new(Scale::Decades, 1.0, last)?
                .labelled_if(k > 0, "number of subintervals $N$");
            let y = Axis::decades_covering(values.iter().copied(), f64::INFINITY)?
                .labelled_if(!left, "difference from $d^2$");
            let series: Vec<Row<'_>> =
                of_case().filter(|row| row.text("rule") == rule.name()).collect();
            let letter = ["(a)", "(b)", "(c)", "(d)"][2 * k + usize::from(left)];
            let of_rule = if left { "left-endpoint rule" } else { "trapezoidal rule" };
            let panel = Panel::new(x, y).titled(format!("{letter} {title}: {of_rule}")).tall(250.0);
            panels.push(curves(panel, &series, left && k == 0)?);
        }
        rows.push(panels);
    }
    let title = "Discrete energy, energy and squared length minus the squared distance against N";
    Ok(drawing::Figure::new(960.0, title, rows).keyed().draw()?)
}

/// Draws the three quantities of one case and rule. The discrete energy has one curve for each
/// sign.
fn curves(panel: Panel, series: &[Row<'_>], first_order: bool) -> Result<Panel, Failure> {
    let points = |column: &str, sign: f64| -> Vec<(f64, f64)> {
        series.iter().map(|row| (row.number("n"), sign * row.number(column))).collect()
    };
    let above = Curve::new(points("discrete_energy_gap", 1.0), palette::VERMILLION);
    let below = Curve::new(points("discrete_energy_gap", -1.0), palette::VERMILLION);
    let energy = points("energy_gap", 1.0);
    let length = points("squared_length_gap", 1.0);
    let mut panel = panel.triangle(triangle_below(&length, -2.0)?);
    if first_order {
        let triangle = triangle_below(&points("discrete_energy_gap", -1.0), -1.0)?;
        panel = panel.triangle(triangle);
    }
    // The energy is a wide line underneath, since the length covers it where the speed is nearly
    // constant.
    let energy = Curve::new(energy, palette::BLUE).wide(3.4).marked(Marker::Square);
    let length = Curve::new(length, palette::GREEN).marked(Marker::Diamond);
    Ok(panel
        .curve(energy.labelled("$E(γ^\"pl\") - d^2$"))
        .curve(length.labelled("$L(γ^\"pl\")^2 - d^2$"))
        .curve(above.marked(Marker::Disc).labelled("$E_N - d^2$, positive"))
        .curve(below.dashed(&[5.0, 3.0]).marked(Marker::Ring).labelled("$d^2 - E_N$, positive")))
}
