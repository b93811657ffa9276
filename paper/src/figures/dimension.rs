//! How bounds and errors depend on the dimension.

use std::thread;

use tautline::{
    Bounded, Ends, KnownDistance, Options, PointSequence, Problem, Rule, SVector, Starts,
    bounds::Setting, gallery::Separable,
};
use tautline_statements::slope;

use super::excess_bounds::{COLUMNS, excess_bounds};
use crate::{
    Failure,
    artefact::Artefact,
    case::subintervals,
    data::{Data, Tolerance},
    drawing::{self, Align, Axis, Curve, Marker, Note, Panel, Scale, Scene, palette},
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "dimension",
    "the bounds of the excess E - d^2 by Theorem 1.1, which grows like D^6, and by Theorems \
     A to D, which are the same from D = 2 on, with the excess observed along an axis and \
     along the diagonal of the same wave in every coordinate, at one distance and N = 16",
    data,
    draw,
);

const N: usize = 16;
/// The amplitude `a` of the profile `f = 1 + a sin kxᵢ` in every coordinate.
const AMPLITUDE: f64 = 0.3;
const WAVE_NUMBER: f64 = 1.0;
/// The end of the curve along an axis, in `ℓ`. It starts at the origin.
const END: f64 = 2.0;

/// Up to this dimension the search uses all its starts, about `2D`, and each must lead to the same
/// minimiser as the straight line. In higher dimensions the straight line is the only start.
///
/// The metric is flat, with one geodesic between two points. With all starts, 64 dimensions alone
/// take half a minute; from the straight line they take a seventh of a second.
const ALL_STARTS: usize = 32;
/// The relative difference of the energies of two searches that reached the same minimiser. It
/// covers a few roundings of the 16 terms; the error that a converged search leaves is smaller.
const SAME: f64 = 1e-13;

/// The setting in one dimension, and the excesses observed at the same distance.
struct Observed {
    setting: Setting,
    along_axis: f64,
    along_diagonal: f64,
}

/// Solves along an axis and along the diagonal, at the same distance.
fn observe<const D: usize>() -> Result<Observed, Failure> {
    let all = SVector::<f64, D>::repeat;
    let metric = Separable::<D>::new(all(AMPLITUDE), all(WAVE_NUMBER))?;
    let line = Separable::<1>::new([AMPLITUDE], [WAVE_NUMBER])?;
    let reach = |x: f64| line.flatten(&SVector::from([x]))[0];
    let distance = reach(END);
    // Fᵢ = d/√D in every coordinate. Fᵢ′ ≥ 1 − a > 0, and bisection ends at neighbouring numbers.
    let share = distance / (D as f64).sqrt();
    let (mut low, mut high) = (0.0, 2.0 * END);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if reach(middle) <= share { low = middle } else { high = middle }
    }
    let origin = SVector::<f64, D>::zeros();
    let mut axis = origin;
    axis[0] = END;
    let excess = |end: SVector<f64, D>| -> Result<f64, Failure> {
        let found = metric.distance(&origin, &end).ok_or(Failure::NoReference("waves"))?;
        let problem = Problem::new(metric, Ends::points(origin, end)?);
        let straight = PointSequence::straight(origin, end, N)?;
        let starts = Starts::Only(vec![straight]);
        let options = Options { starts, ..Options::default() };
        let solved = problem.solve_with(Rule::TRAPEZOIDAL, N, &options)?;
        if !solved.minimum().is_local_minimum() {
            return Err(Failure::Violated(format!("D = {D}: no minimum was found")));
        }
        if D <= ALL_STARTS {
            let energy = solved.discrete_energy();
            let found = problem.solve(Rule::TRAPEZOIDAL, N)?;
            let same = |other: &f64| (other - energy).abs() <= SAME * energy;
            // Minima whose energies differ by less than 10⁻⁹ are listed once.
            let minima = &found.minimum().local_minima;
            if minima.len() != 1 || !minima.iter().all(same) {
                return Err(Failure::Violated(format!("D = {D}: there are other minima")));
            }
        }
        Ok(solved.energy().value - found * found)
    };
    let setting = Setting::new(metric.constants(), distance, D)?;
    let diagonal = SVector::<f64, D>::repeat(low);
    Ok(Observed { setting, along_axis: excess(axis)?, along_diagonal: excess(diagonal)? })
}

type Observe = fn() -> Result<Observed, Failure>;

/// Each dimension has its own type.
const DIMENSIONS: [(usize, Observe); 11] = [
    (1, observe::<1>),
    (2, observe::<2>),
    (3, observe::<3>),
    (5, observe::<5>),
    (8, observe::<8>),
    (12, observe::<12>),
    (16, observe::<16>),
    (24, observe::<24>),
    (32, observe::<32>),
    (64, observe::<64>),
    (100, observe::<100>),
];

/// In 100 dimensions a matrix of derivatives in 8 directions takes 720 kB. Several of these
/// matrices are on the stack, which is 2 MB for a thread by default.
const STACK: usize = 1 << 26;

fn data(sweep: Sweep) -> Result<Data, Failure> {
    // These are differences of energies below 10, and closed forms.
    let seen = Tolerance::Close { relative: 1e-7, absolute: 2e-13 };
    let proven = Tolerance::relative(1e-9);
    let mut data = Data::new(&[
        ("dimension", Tolerance::Exact),
        ("along_axis along_diagonal", seen),
        (COLUMNS, proven),
    ]);
    let chosen = DIMENSIONS.into_iter().filter(|(dimension, _)| !sweep.quick || *dimension <= 8);
    for (dimension, observe) in chosen {
        let worker = thread::Builder::new().stack_size(STACK).spawn(observe);
        let worker = worker.map_err(|error| Failure::Data(error.to_string()))?;
        let seen = worker.join().map_err(|_| Failure::Data(format!("D = {dimension}")))??;
        let bounds = excess_bounds(seen.setting, subintervals(N)?)?;
        let observed = [seen.along_axis, seen.along_diagonal];
        let most = observed[0].max(observed[1]);
        if let Some(bound) = bounds.iter().find(|bound| !(most <= **bound)) {
            return Err(Failure::Violated(format!("D = {dimension}: {most} exceeds {bound}")));
        }
        let mut row = vec![dimension.to_string()];
        row.extend(observed.map(|value| format!("{value:.9e}")));
        row.extend(bounds.map(|value| format!("{value:.11e}")));
        data.push(row);
    }
    Ok(data)
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let points = |column: &str| -> Vec<(f64, f64)> {
        data.rows().map(|row| row.point("dimension", column)).collect()
    };
    let columns = ["paper", "along_axis", "along_diagonal"];
    let values = columns.iter().flat_map(|column| points(column)).map(|point| point.1);
    let last = data.greatest("dimension");
    let x = Axis::new(Scale::Decades, 1.0, last)?.labelled("dimension $D$");
    let y = Axis::decades_covering(values, f64::INFINITY)?;
    let mut panel = Panel::new(x, y.labelled("$E(γ^\"pl\") - d^2$ and its bounds")).tall(380.0);
    let paper = points("paper");
    let tail: Vec<(f64, f64)> = paper.iter().rev().take(4).copied().collect();
    let place = paper.get(paper.len() / 2).copied();
    let place = place.ok_or_else(|| Failure::Data("no dimension".to_owned()))?;
    let rate = format!("slope {:.2}", slope(&tail));
    for (column, label, colour, dash, marker) in [
        ("paper", "Theorem 1.1", palette::VERMILLION, &[][..], Some(Marker::Disc)),
        ("theorem_a", "Theorem A", palette::BLUE, &[6.0, 3.0], None),
        ("theorem_c", "Theorem C", palette::BLUE, &[], None),
        ("theorem_b", "Theorem B", palette::GREEN, &[6.0, 3.0], None),
        ("theorem_d", "Theorem D", palette::GREEN, &[], None),
        ("along_axis", "observed along an axis", palette::INK, &[], Some(Marker::Square)),
        (
            "along_diagonal",
            "observed along the diagonal",
            palette::GREY,
            &[],
            Some(Marker::Diamond),
        ),
    ] {
        let curve = Curve::new(points(column), colour).dashed(dash).labelled(label);
        panel = panel.curve(curve.marked(marker));
    }
    let note = Note::new(place, rate, palette::VERMILLION, Align::Right).shifted(-14.0, -14.0);
    let title = "Bounds of the excess energy and observed excess against the dimension";
    Ok(drawing::Figure::new(720.0, title, vec![vec![panel.note(note)]]).draw()?)
}
