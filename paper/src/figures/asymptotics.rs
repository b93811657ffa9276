//! The errors times their power of `N`, which converge to the predicted constants.

use tautline::{Level, Rule, extrapolate};

use crate::{
    Failure,
    artefact::Artefact,
    asymptotics::{Limits, Smooth, smooth_problems},
    case::Reference,
    data::{Data, Row, Tolerance},
    drawing::{
        self, Align, Axis, Colour, Curve, Marker, Note, Panel, Scale, Scene, SlopeTriangle, palette,
    },
    parallel,
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "asymptotics",
    "N^2 (E_tra,N - d^2), N (E_l,N - d^2) and N^2 (E - d^2) of the trapezoidal minimiser's curve, \
     divided by the constants predicted along a geodesic (or by d^2 where that constant is 0 by \
     symmetry), with their distance from the limit, and the error of d^2 extrapolated from the \
     last two (dashed) or three grids, against N; points beyond an axis are left out, and those \
     where rounding may exceed a twentieth of the value",
    data,
    draw,
);

/// Cases: both rules with their general orders in the plane, with a curve that turns; a sphere;
/// both ends on curved sets; an axis of symmetry.
const CASES: [(&str, &str, Colour, Marker); 5] = [
    ("valleys_oblique", "valleys", palette::VERMILLION, Marker::Disc),
    ("shear_points", "shear", palette::BLUE, Marker::Square),
    ("sphere_patch", "sphere", palette::GREEN, Marker::Triangle),
    ("lens_balls", "lens, ball to ball", palette::ORANGE, Marker::Ring),
    ("valleys_points", "valleys, symmetric", palette::PURPLE, Marker::Diamond),
];

/// A quantity: its column, the column of its limit, and its order.
const QUANTITIES: [(&str, &str, i32); 3] = [
    ("trapezoidal", "limit_trapezoidal", 2),
    ("left", "limit_left", 1),
    ("energy", "limit_energy", 2),
];

const N: usize = 2048;

/// The error of an energy and of `d²`, relative to `d²`, which is a few roundings each.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// A value is drawn only if rounding changes it by at most this fraction.
const NOISE: f64 = 0.05;

/// How far a quotient may deviate from its limit at the largest `N`.
///
/// For the trapezoidal rule, the next term has two more powers of `1/N`, and for the left rule one
/// more. If the constant of the left rule is 0, its second-order error divided by `d²` is compared
/// with 0 instead. At 2048 the measured deviations are at most `(13.4/N)²`, `2.1/N` and `12.7/N` in
/// these three cases.
fn allowed(order: i32, limit: f64, n: usize) -> f64 {
    let n = n as f64;
    match (order, limit == 0.0) {
        (1, true) => 16.0 / n,
        (1, false) => 4.0 / n,
        _ => (16.0 / n).powi(2),
    }
}

fn data(sweep: Sweep) -> Result<Data, Failure> {
    // Relative to d²: the rounding error times N², on values from 10⁻³ on.
    let scaled = Tolerance::Close { relative: 1e-6, absolute: (N * N) as f64 * 2.0 * ROUNDING };
    // Sums of second derivatives along 4096 chords, whose points are known to rounding times N².
    let predicted = Tolerance::relative(1e-8);
    // The absolute values of Neville's weights for doubling grids have a sum of at most 2.
    let extrapolated = Tolerance::Close { relative: 1e-6, absolute: 4.0 * ROUNDING };
    let mut data = Data::new(&[
        ("case n", Tolerance::Exact),
        ("trapezoidal left energy", scaled),
        ("limit_trapezoidal limit_left limit_energy", predicted),
        ("two_grids three_grids", extrapolated),
    ]);
    let mut problems = smooth_problems()?;
    problems.retain(|problem| CASES.iter().any(|(name, ..)| *name == problem.name));
    let numbers = sweep.powers_of_two(N);
    for rows in parallel::map(&problems, |problem| rows(problem, &numbers)) {
        rows?.into_iter().for_each(|row| data.push(row));
    }
    Ok(data)
}

/// Returns the rows of one problem. All numbers are divided by `d²`, so that rounding is the same
/// everywhere.
fn rows(problem: &Smooth, numbers: &[usize]) -> Result<Vec<Vec<String>>, Failure> {
    let limits: Limits = problem.limits()?;
    let d_squared = limits.d_squared;
    let predictions = limits.predictions();
    let limits_of = [predictions[0], predictions[1], predictions[2]].map(|limit| limit / d_squared);
    let mut levels: Vec<Level> = Vec::new();
    let mut rows = Vec::new();
    for (k, &n) in numbers.iter().enumerate() {
        let energies = problem.energies(n)?;
        levels.push(Level { n, energy: energies[0] });
        let mut row = vec![problem.name.to_owned(), n.to_string()];
        for ((energy, limit), (column, _, order)) in
            energies.into_iter().zip(limits_of).zip(QUANTITIES)
        {
            let value = (n as f64).powi(order) * (energy / d_squared - 1.0);
            let distance = from_limit(value, limit);
            if k + 1 == numbers.len() && !(distance <= allowed(order, limit, n)) {
                let claim = format!("{}, N = {n}: {column} is {distance} off", problem.name);
                return Err(Failure::Violated(claim));
            }
            row.push(format!("{value:.9e}"));
        }
        row.extend(limits_of.map(|limit| format!("{limit:.10e}")));
        // An extrapolated d² cannot serve as a reference.
        row.extend([2, 3].map(|grids| match levels.len().checked_sub(grids) {
            Some(from) if limits.reference == Reference::Exact => {
                let estimate = extrapolate(&levels[from..], Rule::TRAPEZOIDAL.error_exponent());
                estimate.map_or(String::new(), |d2| format!("{:.6e}", d2.value / d_squared - 1.0))
            }
            _ => String::new(),
        }));
        rows.push(row);
    }
    Ok(rows)
}

/// Returns the quotient divided by its limit, minus 1, or the value itself if the limit is 0.
fn from_limit(value: f64, limit: f64) -> f64 {
    if limit == 0.0 { value.abs() } else { (value / limit - 1.0).abs() }
}

/// Returns a quantity in a row, both as a quotient and as its distance from 1. It is NaN if
/// rounding hides it.
fn shown(row: &Row<'_>, (column, limit, order): (&str, &str, i32)) -> [(f64, f64); 2] {
    let (n, value, limit) = (row.number("n"), row.number(column), row.number(limit));
    let unit = if limit == 0.0 { 1.0 } else { limit };
    let noise = (n.powi(order) * ROUNDING / unit).abs();
    let heard = |value: f64| if noise <= NOISE * value.abs() { value } else { f64::NAN };
    [(n, heard(value / unit)), (n, heard(from_limit(value, limit)))]
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let last = data.greatest("n");
    let below = |numbered: bool| {
        let x = Axis::new(Scale::Decades, 1.0, last)?;
        Ok::<_, Failure>(x.labelled_if(numbered, "number of subintervals $N$"))
    };
    let titles = [
        ("(a) $N^2(E_\"tra\" - d^2)$ / predicted", 0.0, 2.0),
        ("(b) $N(E_\"l\" - d^2)$ / predicted", -1.0, 1.5),
        ("(c) $N^2(E(γ^\"pl\") - d^2)$ / predicted", 0.0, 2.0),
    ];
    let mut quotients = Vec::new();
    let mut distances = Vec::new();
    let points = |name: &str, k: usize, which: usize| -> Vec<(f64, f64)> {
        data.rows_with("case", name).map(|row| shown(&row, QUANTITIES[k])[which]).collect()
    };
    for (k, (title, from, to)) in titles.into_iter().enumerate() {
        let y = Axis::new(Scale::Linear, from, to)?.labelled(if k == 0 { "quotient" } else { "" });
        let mut panel = Panel::new(below(false)?, y).titled(title).tall(230.0);
        panel = panel.curve(Curve::level(1.0, palette::GREY));
        for (name, label, colour, marker) in CASES {
            let inside = |(n, y): (f64, f64)| (n, if from <= y && y <= to { y } else { f64::NAN });
            let curve = Curve::new(points(name, k, 0).into_iter().map(inside), colour);
            panel = panel.curve(curve.marked(marker).labelled(label));
        }
        if k == 1 {
            let text = "divided by $d^2$";
            panel = panel.curve(Curve::level(0.0, palette::GREY));
            panel = panel.note(Note::new((last, -0.35), text, palette::PURPLE, Align::Right));
        }
        quotients.push(panel);
    }
    let all = (0..2).flat_map(|k| CASES.iter().flat_map(move |(name, ..)| [(k, *name)]));
    let values: Vec<f64> =
        all.flat_map(|(k, name)| points(name, k, 1)).map(|point| point.1).collect();
    for (k, title, slope, under) in [
        (0, "(d) distance of (a) from its limit", -2.0, 2e-4),
        (1, "(e) distance of (b) from its limit", -1.0, 4e-3),
    ] {
        let y = Axis::decades_covering(values.iter().copied(), f64::INFINITY)?
            .labelled_if(k == 0, "distance");
        let mut panel = Panel::new(below(true)?, y).titled(title).tall(230.0);
        for (name, label, colour, marker) in CASES {
            let curve = Curve::new(points(name, k, 1), colour).marked(marker);
            panel = panel.curve(curve.labelled(label));
        }
        distances.push(panel.triangle(SlopeTriangle::below(slope, 8.0, 64.0, under)));
    }
    distances.push(extrapolated(data, below(true)?)?);
    let title =
        "Errors times their power of N divided by the predicted constants, and what is left";
    Ok(drawing::Figure::new(960.0, title, vec![quotients, distances]).keyed().draw()?)
}

/// Returns the panel of the extrapolated `d²`: a solid line from three grids, a dashed one from
/// two.
fn extrapolated(data: &Data, x: Axis) -> Result<Panel, Failure> {
    let points = |name: &str, column: &str| -> Vec<(f64, f64)> {
        let error = |row: Row<'_>| (row.number("n"), row.number(column).abs());
        // By the weights, this is twice the rounding error of one energy.
        let heard = |(n, error): (f64, f64)| {
            (n, if 2.0 * ROUNDING <= NOISE * error { error } else { f64::NAN })
        };
        data.rows_with("case", name).map(error).map(heard).collect()
    };
    let columns = ["two_grids", "three_grids"];
    let all = CASES.iter().flat_map(|(name, ..)| columns.map(|column| points(name, column)));
    let y = Axis::decades_covering(all.flatten().map(|point| point.1), f64::INFINITY)?;
    let title = "(f) error of the extrapolated $d^2$ / $d^2$";
    let mut panel = Panel::new(x, y).titled(title).tall(230.0);
    for (name, label, colour, marker) in CASES {
        let two = Curve::new(points(name, "two_grids"), colour).dashed(&[5.0, 3.0]);
        let three = Curve::new(points(name, "three_grids"), colour).marked(marker);
        panel = panel.curve(two).curve(three.labelled(label));
    }
    let (from, to) = (256.0, 1024.0);
    // A quick run has no grids this fine.
    if data.rows().any(|row| row.number("n") >= to) {
        panel = panel.triangle(SlopeTriangle::above(-4.0, from, to, 5e-6));
    }
    Ok(panel.triangle(SlopeTriangle::below(-6.0, 8.0, 32.0, 1e-8)))
}
