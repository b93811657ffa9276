//! Bounds on the excess energy divided by the observed excess, against `N`.

use super::excess_bounds::{COLUMNS, excess_bounds};
use crate::{
    Failure,
    artefact::Artefact,
    case::{Case, PaperRule, subintervals},
    cases::cases_named,
    data::{Data, Row, Tolerance},
    drawing::{self, Axis, Colour, Curve, Marker, Panel, Scale, Scene, palette},
    observation::Observation,
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "overestimation",
    "the bounds of the paper, of Theorems A to D and of one computed sequence for the \
     excess E - d^2 of the curve reconstructed from the trapezoidal minimiser, divided by \
     the observed excess, against N",
    data,
    draw,
);

/// One panel for each of these: the counterexample, a full matrix, sets, and three dimensions.
const PANELS: [(&str, &str); 4] = [
    ("valleys_points", "(a) valleys, $(0,0)$ to $(4π,0)$"),
    ("shear_points", "(b) shear, $(0,0)$ to $(2,3)$"),
    ("valleys_ball", "(c) valleys, ball to half-plane"),
    ("separable_points", "(d) separable, $D = 3$"),
];

/// A bound: its column, its name and its style. Theorems of the same order have the same colour.
type Bound = (&'static str, &'static str, Colour, &'static [f64], Option<Marker>);

const BOUNDS: [Bound; 6] = [
    ("paper", "$C/√{N}$ of Theorem 1.1", palette::VERMILLION, &[], None),
    ("theorem_a", "Theorem A, $1/N$", palette::BLUE, &[6.0, 3.0], None),
    ("theorem_c", "Theorem C, $1/N$", palette::BLUE, &[], None),
    ("theorem_b", "Theorem B, $1/N^2$", palette::GREEN, &[6.0, 3.0], None),
    ("theorem_d", "Theorem D, $1/N^2$", palette::GREEN, &[], None),
    ("a_posteriori", "from the computed sequence alone", palette::PURPLE, &[], Some(Marker::Disc)),
];

fn data(sweep: Sweep) -> Result<Data, Failure> {
    // A difference of energies up to 700, each with an error of 1e-12.
    let seen = Tolerance::Close { relative: 1e-6, absolute: 2e-10 };
    // These are closed forms.
    let proven = Tolerance::relative(1e-9);
    let mut data = Data::new(&[
        ("case n", Tolerance::Exact),
        ("excess", seen),
        (COLUMNS, proven),
        ("a_posteriori", seen),
    ]);
    for case in cases_named(&PANELS.map(|(name, _)| name))? {
        for n in sweep.powers_of_two(4096) {
            let observation = case.solve(PaperRule::Trapezoidal, n)?;
            data.push(row(&case, &observation)?);
        }
    }
    Ok(data)
}

fn row(case: &Case, seen: &Observation) -> Result<Vec<String>, Failure> {
    // E(γᵖˡ) − d² is at most this, whatever d is.
    let a_posteriori = seen.energy.value - case.enclose(PaperRule::Trapezoidal, seen)?.lower;
    let proven = excess_bounds(case.setting, subintervals(seen.n)?)?;
    let excess = seen.energy.value - case.distance_squared;
    let mut row = vec![case.name.to_owned(), seen.n.to_string(), format!("{excess:.6e}")];
    row.extend(proven.map(|bound| format!("{bound:.11e}")));
    row.push(format!("{a_posteriori:.6e}"));
    Ok(row)
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let ratio = |row: &Row<'_>, bound: &str| row.number(bound) / row.number("excess");
    let ratios = data.rows().flat_map(|row| BOUNDS.map(|(column, ..)| ratio(&row, column)));
    let most = ratios.fold(1.0, f64::max);
    let last = data.greatest("n");
    let mut panels = Vec::new();
    for (k, (name, title)) in PANELS.into_iter().enumerate() {
        let x =
            Axis::new(Scale::Decades, 1.0, last)?.labelled_if(k >= 2, "number of subintervals $N$");
        let y = Axis::decades_covering([1.0, most], f64::INFINITY)?
            .labelled_if(k % 2 == 0, "bound / excess");
        let mut panel = Panel::new(x, y).titled(title).tall(240.0);
        panel = panel.curve(Curve::level(1.0, palette::GREY));
        for (column, label, colour, dash, marker) in BOUNDS {
            let rows = data.rows_with("case", name);
            let points = rows.map(|row| (row.number("n"), ratio(&row, column)));
            let curve = Curve::new(points, colour).dashed(dash).marked(marker);
            panel = panel.curve(curve.labelled(label));
        }
        panels.push(panel);
    }
    let lower = panels.split_off(2);
    let title = "Bounds of the excess energy divided by the observed one, for four cases";
    Ok(drawing::Figure::new(960.0, title, vec![panels, lower]).keyed().draw()?)
}
