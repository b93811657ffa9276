//! The certified bounds of a distance, level after level of the search.

use std::f64::consts::PI;

use tautline::{
    Ends, KnownDistance, Metric, Options, Problem, Rule, SVector,
    distance::Ended,
    gallery::{Bump, Shear, Sphere, Valleys},
};

use super::triangle_below;
use crate::{
    Failure,
    artefact::Artefact,
    data::{Data, Row, Tolerance},
    drawing::{self, Axis, Colour, Curve, Marker, Panel, Scale, Scene, palette},
    parallel,
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "sandwich",
    "the proved bounds lo <= d <= hi of four distances after each level of the search for a \
     certificate: hi is the length of one curve, and lo rises with the cubes of all levels so far; d \
     is known in closed form, but for the hill, where it is extrapolated",
    data,
    draw,
);

/// What is drawn of a problem: its name in the data, its name in the picture, and its colour.
const PROBLEMS: [(&str, &str, Colour, Marker); 4] = [
    ("valleys", "valleys, over two of them", palette::BLUE, Marker::Square),
    ("hill", "around a hill", palette::VERMILLION, Marker::Disc),
    ("shear", "shear", palette::GREEN, Marker::Triangle),
    ("sphere", "sphere, $D = 3$", palette::PURPLE, Marker::Diamond),
];

const DASHES: [f64; 2] = [6.0, 3.0];

/// The number of chords of the lines, which is that of `tautline certify`.
const CHORDS: usize = 256;

/// The wanted gap in the plane and in space, and in a quick run.
const GAPS: [f64; 2] = [1e-5, 1e-4];
const QUICK: f64 = 3e-2;

/// The bounds after each level.
struct Levels {
    /// The distance, and how far it may be off.
    distance: [f64; 2],
    /// How the distance is known.
    known: &'static str,
    upper: f64,
    /// The number of cubes of each level, and the lower bound after it.
    levels: Vec<(usize, f64)>,
}

fn data(sweep: Sweep) -> Result<Data, Failure> {
    // Elementary functions differ in their last bits, and cubes at the edge of a level with them.
    let counted = Tolerance::relative(0.01);
    let mut data = Data::new(&[
        ("problem level", Tolerance::Exact),
        ("cubes", counted),
        ("lower", Tolerance::relative(1e-4)),
        // Lengths have a relative error of the square of that of a minimum, which is 1e-9 at most.
        ("upper d", Tolerance::relative(1e-9)),
        ("known", Tolerance::Exact),
        // A bound that is off by some last bits of a cube that stays or goes has the same two digits.
        ("gap", Tolerance::relative(0.05)),
    ]);
    let names = PROBLEMS.map(|(name, ..)| name);
    let found = parallel::map(&names, |&name| levels(name, sweep.quick));
    for (name, found) in names.into_iter().zip(found) {
        let Levels { distance: [d, error], known, upper, levels } = found?;
        let (mut cubes, mut before) = (0, 0.0);
        for (level, (more, lower)) in levels.into_iter().enumerate() {
            if !(before <= lower && lower <= d + error && d - error <= upper) {
                let claim = format!("{name}: {before}, then {lower}, d = {d} ± {error}, {upper}");
                return Err(Failure::Violated(claim));
            }
            (cubes, before) = (cubes + more, lower);
            let gap = format!("{:.6e}", (upper - lower) / upper);
            let bounds = [lower, upper, d].map(|length| format!("{length:.15}"));
            let row = [name.to_owned(), (level + 1).to_string(), cubes.to_string()];
            data.push(row.into_iter().chain(bounds).chain([known.to_owned(), gap]));
        }
    }
    Ok(data)
}

/// Searches for a certificate of the problem of this name.
fn levels(name: &str, quick: bool) -> Result<Levels, Failure> {
    let wanted = |gap| if quick { QUICK } else { gap };
    let [plane, space] = GAPS.map(wanted);
    match name {
        "valleys" => {
            // Along x₁ the cost is 2 − cos x₁, and it depends on x₁ alone.
            search(Valleys, [[0.0, 0.0], [4.0 * PI, 0.0]], Some(8.0 * PI), plane)
        }
        "hill" => search(Bump::new(4.0, 0.5)?, [[-1.5, 0.05], [1.5, -0.1]], None, plane),
        "shear" => known(Shear::new(0.6, 3.0)?, [[-0.5, -0.3], [0.5, 0.4]], plane),
        _ => known(Sphere, [[-0.3, -0.1, 0.1], [0.4, 0.2, -0.1]], space),
    }
}

/// Does the same with a metric that knows the distance.
fn known<M: KnownDistance<D>, const D: usize>(
    metric: M,
    ends: [[f64; D]; 2],
    gap: f64,
) -> Result<Levels, Failure> {
    let [x, y] = ends.map(SVector::from);
    let d = metric.distance(&x, &y).ok_or(Failure::NoReference("a metric that knows distances"))?;
    search(metric, ends, Some(d), gap)
}

fn search<M: Metric<D>, const D: usize>(
    metric: M,
    [from, to]: [[f64; D]; 2],
    d: Option<f64>,
    gap: f64,
) -> Result<Levels, Failure> {
    let options = Options { threads: 1, ..Options::default() };
    let line = Problem::new(metric, Ends::points(from, to)?).solve_with(
        Rule::TRAPEZOIDAL,
        CHORDS,
        &options,
    )?;
    let found = line.certificate(gap)?;
    let upper = found.proved.upper.filter(|_| found.ended == Ended::Reached);
    let upper = upper.ok_or_else(|| {
        let (proved, ended) = (&found.proved, found.ended);
        Failure::Violated(format!("{ended:?} with {:?} of {gap:e}", proved.gap()))
    })?;
    let (distance, known) = match (d, line.distance_squared_estimate()) {
        // A closed form is computed with a few roundings.
        (Some(d), _) => ([d, 1e-12 * d], "closed form"),
        (None, Some(square)) => {
            let d = square.value.sqrt();
            ([d, 0.5 * square.error / d], "extrapolated")
        }
        _ => return Err(Failure::NoReference("a line on one grid")),
    };
    Ok(Levels { distance, known, upper, levels: found.proved.levels })
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let all = |column| data.rows().map(move |row: Row<'_>| row.number(column));
    let cubes = || -> Result<Axis, Failure> {
        let axis = Axis::decades_covering(all("cubes"), f64::INFINITY)?;
        Ok(axis.labelled("cubes of all levels so far"))
    };
    let share = Axis::new(Scale::Linear, 0.76, 1.02)?.labelled("bounds over $d$");
    let errors = data.rows().flat_map(|row| [below(&row), above(&row)]);
    let error = Axis::decades_covering(errors, f64::INFINITY)?
        .labelled("$(d-\"lo\")/d$ and $(\"hi\"-d)/d$");
    let mut bounds = Panel::new(cubes()?, share).titled("(a) bounds").tall(330.0);
    let mut errors = Panel::new(cubes()?, error).titled("(b) how far they are off").tall(330.0);
    for (name, shown, colour, marker) in PROBLEMS {
        let rows: Vec<Row<'_>> = data.rows_with("problem", name).collect();
        let against = |value: fn(&Row<'_>) -> f64| -> Vec<(f64, f64)> {
            rows.iter().map(|row| (row.number("cubes"), value(row))).collect()
        };
        let lower = |points| Curve::new(points, colour).marked(marker).labelled(shown);
        let upper = |points| Curve::new(points, colour).dashed(&DASHES);
        bounds = bounds
            .curve(upper(against(|row| 1.0 + above(row))))
            .curve(lower(against(|row| 1.0 - below(row))));
        errors = errors.curve(upper(against(above))).curve(lower(against(below)));
        // Levels that nest, each with half the width; a quick run ends before they do.
        if name == PROBLEMS[0].0 && rows.len() > 3 {
            errors = errors.triangle(triangle_below(&against(below), -2.0)?);
        }
    }
    // For the key alone.
    bounds = bounds
        .curve(Curve::new([], palette::INK).labelled("$\"lo\"$"))
        .curve(Curve::new([], palette::INK).dashed(&DASHES).labelled("$\"hi\"$"));
    let title = "Certified bounds of distances, level after level";
    Ok(drawing::Figure::new(960.0, title, vec![vec![bounds, errors]]).keyed().draw()?)
}

/// Returns how far the lower bound is below the distance, relative to it.
fn below(row: &Row<'_>) -> f64 {
    1.0 - row.number("lower") / row.number("d")
}

/// Returns how far the upper bound is above the distance, relative to it.
fn above(row: &Row<'_>) -> f64 {
    row.number("upper") / row.number("d") - 1.0
}
