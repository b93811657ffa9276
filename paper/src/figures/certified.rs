//! The constants that a formula proves, box by box.

use tautline::{
    Bounded, Domain, Metric, Quantity, SMatrix, SVector, Scalar,
    certify::{Accuracy, Cell, certify},
    gallery::Swirl,
};

use crate::{
    Failure,
    artefact::Artefact,
    data::{Data, Tolerance},
    decoder::decoder,
    drawing::{self, Axis, DrawingError, Field, Panel, Scale, Scene},
    grid::{Grid, Lines},
    parallel,
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "certified",
    "bounds of the least and the greatest eigenvalue of H and of the norm of DH on each of \
     31 x 31 small boxes, proved from the formulas of three metrics: one that states no \
     constants, the stirred plane, and the pullback by a decoder",
    data,
    draw,
);

/// `[[2 + cos x₁, 0.3 sin(x₁ + x₂)], [·, 1.5 + 0.5 sin x₂]]`, without stated constants.
#[derive(Clone, Copy, Debug)]
struct Formula;

impl Metric<2> for Formula {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let off = (x[0] + x[1]).sin() * 0.3;
        SMatrix::<S, 2, 2>::new(x[0].cos() + 2.0, off, off, x[1].sin() * 0.5 + 1.5)
    }
}

/// The number of boxes along a side.
const COUNT: usize = 31;

/// The number of boxes along a side in a quick run.
const QUICK: usize = 7;

/// The names of the metrics, each with half the side of a square about the origin.
const SQUARES: [(&str, &str, f64); 3] = [
    ("formula", "a formula", std::f64::consts::PI),
    ("swirl", "the stirred plane", 2.5),
    ("decoder", "a decoder", 3.0),
];

const QUANTITIES: [(Quantity, &str, &str); 3] = [
    (Quantity::C1, "least_eigenvalue", "$c_1(x)$"),
    (Quantity::C2, "greatest_eigenvalue", "$c_2(x)$"),
    (Quantity::LH, "derivative", "$‖DH(x)‖$"),
];

/// Returns the centres of the boxes along a side.
fn centres(half: f64, count: usize) -> Lines {
    let step = 2.0 * half / count as f64;
    Lines { from: -half + 0.5 * step, to: half - 0.5 * step, count }
}

fn data(sweep: Sweep) -> Result<Data, Failure> {
    // Two per cent, since the bounds depend on the library of elementary functions.
    let bound = Tolerance::relative(0.02);
    let mut data = Data::new(&[
        ("metric x1 x2", Tolerance::Exact),
        ("least_eigenvalue greatest_eigenvalue derivative", bound),
    ]);
    let (swirl, decoder) = (Swirl::new(1.0, 1.0)?, decoder()?);
    let stated = [None, Some(swirl.constants()), Some(Bounded::<2>::constants(&decoder))];
    for ((name, _, half), stated) in SQUARES.into_iter().zip(stated) {
        let lines = centres(half, if sweep.quick { QUICK } else { COUNT });
        let places: Vec<[f64; 2]> =
            lines.all().flat_map(|y| lines.all().map(move |x| [x, y])).collect();
        let step = 0.5 * (lines.all().nth(1).unwrap_or(half) - lines.from);
        let rows = parallel::map(&places, |&at| match name {
            "formula" => bounds(&Formula, at, step),
            "swirl" => bounds(&swirl, at, step),
            _ => bounds(&decoder, at, step),
        });
        for (at, row) in places.into_iter().zip(rows) {
            let row = row?;
            // No stated constant may be sharper than the bound in a box.
            if let Some(c) = stated {
                let worse =
                    [c.c1() <= row[0] * 1.03, c.c2() >= row[1] * 0.97, c.l_h() >= row[2] * 0.97];
                if worse.contains(&false) {
                    return Err(Failure::Violated(format!(
                        "{name} at {at:?}: {row:?}, stated {c:?}"
                    )));
                }
            }
            let place = at.map(|x| format!("{x:.6}"));
            let numbers = row.map(|x| format!("{x:.6e}"));
            data.push([name.to_owned()].into_iter().chain(place).chain(numbers));
        }
    }
    Ok(data)
}

/// Returns safe bounds on the three quantities in a square with half side `step`.
fn bounds(metric: &impl Metric<2>, [x, y]: [f64; 2], step: f64) -> Result<[f64; 3], Failure> {
    let domain = Domain::cell(Cell::new([x - step, y - step], [x + step, y + step])?);
    let accuracy = Accuracy { tolerance: 0.01, ..Accuracy::default() };
    let of = |quantity| certify(metric, quantity, &domain, accuracy);
    Ok([of(Quantity::C1)?.lower, of(Quantity::C2)?.upper, of(Quantity::LH)?.upper])
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let mut rows = Vec::new();
    for (name, title, half) in SQUARES {
        let mut panels = Vec::new();
        for (k, (_, column, symbol)) in QUANTITIES.into_iter().enumerate() {
            let values = data.rows_with("metric", name).map(|row| row.number(column));
            let values: Vec<f64> = values.collect();
            let lines = centres(half, values.len().isqrt());
            let grid = Grid::new(lines, lines, values)?;
            let title =
                format!("({}) {title}: {symbol}", char::from(b'a' + (3 * rows.len() + k) as u8));
            panels.push(panel(&grid, lines, &title, symbol)?);
        }
        rows.push(panels);
    }
    let title = "Constants from place to place, proved from the formula";
    Ok(drawing::Figure::new(1100.0, title, rows).draw()?)
}

fn panel(grid: &Grid, lines: Lines, title: &str, symbol: &str) -> Result<Panel, DrawingError> {
    let range = (lines.from, lines.to);
    let all = || lines.all().flat_map(|y| lines.all().map(move |x| grid.at(x, y)));
    let (least, most) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
    let step = nice(least, most);
    let (first, last) = ((least / step).floor() as i32, (most / step).ceil() as i32);
    let levels = (first..=last).map(|k| f64::from(k) * step).collect();
    let field =
        Field::sample(range, range, levels, |x, y| grid.at(x, y))?.labelled(symbol).lined_every(2);
    let axis = || Axis::new(Scale::Linear, range.0, range.1);
    Ok(Panel::new(axis()?.labelled("$x_1$"), axis()?.labelled("$x_2$"))
        .titled(title)
        .tall(230.0)
        .over(field))
}

/// Returns a round number with ten to twenty multiples between the two numbers.
fn nice(least: f64, most: f64) -> f64 {
    let rough = (most - least) / 12.0;
    let power = 10_f64.powf(rough.log10().floor());
    [1.0, 2.0, 5.0]
        .map(|k| k * power)
        .into_iter()
        .find(|&step| step >= rough)
        .unwrap_or(10.0 * power)
}
