//! The observed errors of both rules, compared with the proven bounds.

use super::triangle_below;
use crate::{
    Failure,
    artefact::Artefact,
    case::PaperRule,
    convergence::{data, series},
    data::Data,
    drawing::{self, Axis, Curve, Marker, Panel, Scale, Scene, palette},
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "convergence",
    "the excess energy of the reconstructed curve for both rules under the bounds C/sqrt(N) \
     of Theorems 1.1 and 1.3, the sharper ones of order 1/N and 1/N^2, and the width of the \
     enclosure of d^2 by one computed sequence, for ten cases, of which the figure shows \
     three whose distance is known exactly",
    data,
    draw,
);

/// One panel for each of these: fixed points, sets, and three dimensions.
const PANELS: [(&str, &str); 3] = [
    ("shear_points", "(a) shear, point to point"),
    ("valleys_ball", "(b) valleys, ball to half-plane"),
    ("separable_points", "(c) separable, $D = 3$"),
];

/// The columns that the axis must cover.
const DRAWN: [&str; 4] = ["excess", "paper_bound", "first_order_bound", "second_order_bound"];

fn draw(data: &Data) -> Result<Scene, Failure> {
    let shown = PANELS.iter().flat_map(|(case, _)| data.rows_with("case", case));
    let values: Vec<f64> = shown
        .flat_map(|row| DRAWN.map(|column| row.number(column)))
        .filter(|value| *value > 0.0)
        .collect();
    let last = data.greatest("n");
    let mut panels = Vec::new();
    for (k, (case, title)) in PANELS.into_iter().enumerate() {
        let x = Axis::new(Scale::Decades, 1.0, last)?.labelled("number of subintervals $N$");
        let y = Axis::decades_covering(values.iter().copied(), 4.0)?
            .labelled_if(k == 0, "excess energy $E(γ^\"pl\") - d^2$");
        let mut panel = Panel::new(x, y).titled(title).tall(340.0);
        for (rule, colour, marker, bound, sharper, observed) in [
            (
                PaperRule::LeftEndpoint,
                palette::BLUE,
                Marker::Ring,
                "$C/√{N}$ of Theorem 1.3",
                ["order $1/N$, left endpoint", ""],
                "observed, left-endpoint rule",
            ),
            (
                PaperRule::Trapezoidal,
                palette::VERMILLION,
                Marker::Disc,
                "$C/√{N}$ of Theorem 1.1",
                ["order $1/N$, trapezoidal", "order $1/N^2$, trapezoidal"],
                "observed, trapezoidal rule",
            ),
        ] {
            let series = series(data, case, rule);
            let points = |column: &str| -> Vec<(f64, f64)> {
                series.iter().map(|row| row.point("n", column)).collect()
            };
            let (proven, seen) = (points("paper_bound"), points("excess"));
            panel = panel.triangle(match rule {
                PaperRule::Trapezoidal => triangle_below(&seen, -2.0)?,
                PaperRule::LeftEndpoint => triangle_below(&proven, -0.5)?,
            });
            panel = panel.curve(Curve::new(proven, colour).dashed(&[6.0, 3.0]).labelled(bound));
            let columns = ["first_order_bound", "second_order_bound"];
            let dashes: [&[f64]; 2] = [&[2.0, 2.0], &[8.0, 2.0, 2.0, 2.0]];
            for ((column, label), dash) in columns.into_iter().zip(sharper).zip(dashes) {
                if !label.is_empty() {
                    let curve = Curve::new(points(column), colour).dashed(dash);
                    panel = panel.curve(curve.labelled(label));
                }
            }
            panel = panel.curve(Curve::new(seen, colour).marked(marker).labelled(observed));
        }
        panels.push(panel);
    }
    let title = "Excess energy of both rules under the bounds of the paper and the sharper ones";
    Ok(drawing::Figure::new(960.0, title, vec![panels]).keyed().draw()?)
}
