//! Overestimation of the bounds of Theorem 1.2 on sheared planes.

use std::num::NonZeroUsize;

use tautline::gallery::Shear;
use tautline_statements::{Finding, Known, LIBRARY, PaperRule, Reconstruction, theorem_1_2};

use crate::{
    Failure,
    artefact::Artefact,
    data::{Data, Row, Tolerance},
    drawing::{
        self, Align, Axis, Curve, DrawingError, Field, Marker, Note, Panel, Scale, Scene, palette,
    },
    grid::{Grid, Lines},
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "tightness",
    "the bounds C/sqrt(N) of Theorem 1.2 and d^2 O(1/N) of first order, divided by the observed \
     excess L^2 - d^2, over amplitude and wave number of a sheared plane, from (0, 0) to (1, 2) \
     with N = 8",
    data,
    draw,
);

const FROM: [f64; 2] = [0.0, 0.0];
const TO: [f64; 2] = [1.0, 2.0];
const N: NonZeroUsize = NonZeroUsize::new(8).expect("positive");

/// The decimal logarithms of the amplitudes, which range from 0.0016 to 0.5.
const EXPONENTS: Lines = Lines { from: -2.8, to: -0.3, count: 41 };
const WAVE_NUMBERS: Lines = Lines { from: 0.4, to: 3.4, count: 41 };

/// The claims of the two panels.
const PAPER: &str = "L(γᵖˡ)² − d² ≤ C/√N";
const FIRST_ORDER: &str = "L(γᵖˡ)² − d² = O(1/N)";

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    // The square root of the remaining decrement changes an excess by about 1e-8 times the excess,
    // which is a difference of numbers up to 30.
    let seen = Tolerance::Close { relative: 1e-6, absolute: 3e-13 };
    // These are closed forms.
    let proven = Tolerance::relative(1e-9);
    let mut data = Data::new(&[
        ("amplitude", proven),
        ("wave_number", Tolerance::Exact),
        ("excess", seen),
        ("paper_bound first_order_bound", proven),
    ]);
    for k in WAVE_NUMBERS.all() {
        for a in EXPONENTS.all().map(|exponent| 10_f64.powf(exponent)) {
            let known = Known::between(Shear::new(a, k)?, FROM, TO)?
                .ok_or(Failure::NoReference("a shear"))?;
            let seen = Reconstruction::observe(&LIBRARY, &known, PaperRule::Trapezoidal, N.get())?;
            let evidence = theorem_1_2(&LIBRARY, &seen);
            if evidence.finding() != Finding::Holds {
                return Err(Failure::Violated(format!("a = {a}, k = {k}: {evidence:?}")));
            }
            let [paper, first] = [PAPER, FIRST_ORDER].map(|claim| evidence.conclusion(claim));
            data.push(vec![
                format!("{a:.11e}"),
                format!("{k:.5}"),
                format!("{:.9e}", paper.observed),
                format!("{:.11e}", paper.bound),
                format!("{:.11e}", first.bound),
            ]);
        }
    }
    Ok(data)
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let mut panels = Vec::new();
    for (k, (column, title)) in [
        ("paper_bound", "(a) bound $C/√{N}$ of Theorem 1.2"),
        ("first_order_bound", "(b) bound of first order, $O(1/N)$"),
    ]
    .into_iter()
    .enumerate()
    {
        let decades = |row: Row<'_>| (row.number(column) / row.number("excess")).log10();
        let grid = Grid::new(EXPONENTS, WAVE_NUMBERS, data.rows().map(decades).collect())?;
        panels.push(panel(&grid, title, k == 0)?);
    }
    let title =
        "Overestimation of the bounds on the length of the reconstruction, on sheared planes";
    Ok(drawing::Figure::new(960.0, title, vec![panels]).draw()?)
}

/// Returns the map of one bound, with its tightest case.
fn panel(grid: &Grid, title: &str, first: bool) -> Result<Panel, DrawingError> {
    let amplitude = |exponent: f64| 10_f64.powf(exponent);
    let x = (amplitude(EXPONENTS.from), amplitude(EXPONENTS.to));
    let y = (WAVE_NUMBERS.from, WAVE_NUMBERS.to);
    let ((exponent, wave_number), least) = grid.least();
    let place = (amplitude(exponent), wave_number);
    let all = WAVE_NUMBERS.all().flat_map(|k| EXPONENTS.all().map(move |e| (e, k)));
    let most = all.map(|(e, k)| grid.at(e, k)).fold(least, f64::max);
    // Bands are a quarter of a decade wide. A numbered line is at every whole decade, or at every
    // other one.
    let stride = if most - least > 6.0 { 2 } else { 1 };
    let low = least.floor() as i32 / stride * stride;
    let levels = (4 * low..=4 * most.ceil() as i32).map(|k| 0.25 * f64::from(k)).collect();
    let field = Field::sample_over_decades(x, y, levels, |a, k| grid.at(a.log10(), k))?
        .lined_every(4 * stride as usize)
        .labelled("$\"log\"_{10}$");
    let x_axis = Axis::new(Scale::Decades, x.0, x.1)?.labelled("amplitude $a$");
    let y_axis = Axis::new(Scale::Linear, y.0, y.1)?.labelled_if(first, "wave number $k$");
    let star = Curve::new([place], palette::VERMILLION).marked(Marker::Star);
    let name = Note::new(place, power_of_ten(least), palette::INK, Align::Left);
    let mut panel = Panel::new(x_axis, y_axis)
        .titled(title)
        .tall(340.0)
        .over(field)
        .curve(star.without_line().over_field())
        .note(name.shifted(10.0, 0.0));
    // On a steep line to the corner, where contours are close to each other but their numbers are
    // not.
    let right_third = EXPONENTS.to - (EXPONENTS.to - EXPONENTS.from) / 3.0;
    let ends = [(right_third, WAVE_NUMBERS.from), (EXPONENTS.to, WAVE_NUMBERS.to)];
    let on_the_way = |s: f64| {
        let [from, to] = ends;
        (from.0 + s * (to.0 - from.0), from.1 + s * (to.1 - from.1))
    };
    for decade in (low..most.ceil() as i32).step_by(stride as usize) {
        let above = |s: f64| grid.at(on_the_way(s).0, on_the_way(s).1) >= f64::from(decade);
        // Away from both ends, where a number would touch the frame.
        let mut steps = (20..=180).map(|k| f64::from(k) / 200.0);
        if let Some(s) = steps.find(|&s| above(s - 0.005) != above(s)) {
            let (exponent, wave_number) = on_the_way(s);
            let number = format!("$10^{{{decade}}}$");
            let at = (amplitude(exponent), wave_number);
            panel = panel.note(Note::new(at, number, palette::INK, Align::Centre));
        }
    }
    Ok(panel)
}

/// Returns `4.3·10⁵` for `10^5.63`, and `310` for `10^2.49`.
fn power_of_ten(decades: f64) -> String {
    if decades < 4.0 {
        return format!("{:.0}", 10_f64.powf(decades));
    }
    let whole = decades.floor();
    format!("${:.1}·10^{{{whole}}}$", 10_f64.powf(decades - whole))
}
