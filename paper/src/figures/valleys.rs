//! The valleys of Section 5, with the minimisers of the length and of the energy.

use std::f64::consts::PI;

use tautline::Rule;

use crate::{
    Failure,
    artefact::Artefact,
    data::{Data, Tolerance},
    drawing::{self, Axis, Curve, Field, Marker, Panel, Scale, Scene, palette},
    section_5::{left_minimisers, middle_jump, problem},
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "valleys",
    "the conformal factor f = 2 - cos x1 of Section 5 with the minimisers of the discrete \
     lengths, which jump from valley to valley, and of the trapezoidal energy",
    data,
    draw,
);

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    // Coordinates are at most 4π, and the minimisers are accurate to rounding times the condition
    // N².
    let position = Tolerance::Close { relative: 0.0, absolute: 1e-7 };
    let mut data = Data::new(&[("sequence index", Tolerance::Exact), ("x1 x2", position)]);
    let mut push = |name: &str, points: Vec<(f64, f64)>| {
        for (index, (x1, x2)) in points.into_iter().enumerate() {
            let cells = [x1, x2].map(|x| format!("{:.9}", x + 0.0));
            data.push([name.to_owned(), index.to_string()].into_iter().chain(cells));
        }
    };
    let n = 8;
    let flat = |x1: &Vec<f64>| x1.iter().map(|&x| (x, 0.0)).collect();
    // The minimiser that rests for the same time in every valley.
    let left = left_minimisers(n)
        .find(|x1| {
            x1.iter().filter(|&&x| x == 0.0).count() == 3
                && x1.iter().filter(|&&x| x > 7.0).count() == 3
        })
        .ok_or_else(|| Failure::Data("no minimiser rests in all valleys".to_owned()))?;
    push("length_left", flat(&left));
    push("length_trapezoidal", flat(&middle_jump(n)));
    let problem = problem()?;
    for n in [4, 8, 16, 64] {
        let line = problem.solve(Rule::TRAPEZOIDAL, n)?;
        let mut points: Vec<_> = line.sequence().points().iter().map(|x| (x[0], x[1])).collect();
        // The mirror image x₁ → 4π − x₁, t → 1 − t of a minimiser is also a minimiser, and rounding
        // decides which one is found. The one that is ahead is taken.
        if points.iter().map(|x| x.0 - 2.0 * PI).sum::<f64>() < 0.0 {
            points = points.into_iter().rev().map(|(x1, x2)| (4.0 * PI - x1, x2)).collect();
        }
        push(&format!("energy_{n}"), points);
    }
    Ok(data)
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let x = (-1.0, 4.0 * PI + 1.0);
    let x_axis = || Axis::new(Scale::MultiplesOfPi, x.0, x.1);
    let levels = (0..=20).map(|k| 1.0 + 0.1 * f64::from(k)).collect();
    let y = (-1.5, 1.5);
    let field =
        Field::sample(x, y, levels, |x1, _| 2.0 - x1.cos())?.labelled("$f = 2 - \"cos\" x_1$");
    let mut map = Panel::new(x_axis()?, Axis::new(Scale::Linear, y.0, y.1)?.labelled("$x_2$"))
        .over(field)
        .tall(110.0);
    let mut time = Panel::new(
        x_axis()?.labelled("$x_1$"),
        Axis::new(Scale::Linear, 0.0, 1.0)?.labelled("time $t$"),
    )
    .tall(280.0)
    .flush();

    // The geodesic runs along the axis with ∫ f dx₁ = 2x₁ − sin x₁ = 8π t.
    let geodesic = |x1: f64| (x1, (2.0 * x1 - x1.sin()) / (8.0 * PI));
    let geodesic: Vec<_> = (0..=200).map(|k| geodesic(4.0 * PI * f64::from(k) / 200.0)).collect();
    let axis = geodesic.iter().map(|&(x1, _)| (x1, 0.0));
    map = map.curve(Curve::new(axis, palette::INK).wide(1.6).over_field());
    time =
        time.curve(Curve::new(geodesic, palette::INK).wide(1.6).labelled("true minimal geodesic"));
    for (name, label, colour, marker) in [
        ("length_left", "least length, left-endpoint rule", palette::PURPLE, Some(Marker::Square)),
        (
            "length_trapezoidal",
            "least length, trapezoidal rule",
            palette::GREEN,
            Some(Marker::Diamond),
        ),
        ("energy_4", "least energy, $N = 4$", palette::SKY, Some(Marker::Triangle)),
        ("energy_8", "$N = 8$", palette::BLUE, Some(Marker::Ring)),
        ("energy_16", "$N = 16$", palette::VERMILLION, Some(Marker::Disc)),
        ("energy_64", "$N = 64$", palette::ORANGE, None),
    ] {
        let rows: Vec<_> = data.rows_with("sequence", name).collect();
        let last = (rows.len() - 1) as f64;
        let in_time = rows.iter().map(|row| (row.number("x1"), row.number("index") / last));
        let curve = Curve::new(in_time, colour).labelled(label);
        time = time.curve(match marker {
            Some(marker) => curve.marked(marker),
            // Its many points are close to the geodesic, so dashes on top of it show more.
            None => curve.dashed(&[7.0, 7.0]).wide(2.0),
        });
        if name == "length_left" {
            let in_plane = rows.iter().map(|row| row.point("x1", "x2"));
            let squares = Curve::new(in_plane, colour).marked(Marker::Square);
            map = map.curve(squares.without_line().over_field());
        }
    }
    let title = "Valleys with the minimisers of discrete length and energy";
    Ok(drawing::Figure::new(720.0, title, vec![vec![map], vec![time]]).keyed().draw()?)
}
