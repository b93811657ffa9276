//! The speeds on each chord of the minimisers of the energy and of the length, and of the minimiser of
//! the energy among sequences of equal speeds.

use std::{f64::consts::PI, ops::ControlFlow};

use tautline::{
    Bounded, Iterate, PointSequence, Prepared, Rule,
    bounds::{Setting, Spread, greatest_speed},
    gallery::Valleys,
};
use tautline_baselines::{
    descent::{Ended, Limits},
    equal_speeds::equal_speeds,
};

use crate::{
    Failure,
    artefact::Artefact,
    case::subintervals,
    data::{Data, Row, Tolerance},
    drawing::{self, Align, Axis, Curve, Marker, Note, Panel, Scale, Scene, palette},
    section_5::{DISTANCE, along_the_axis, middle_jump, problem},
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "speeds",
    "the speeds of the chords of the minimisers of the trapezoidal energy, of the same among \
     sequences of equal speeds, and of the trapezoidal length between (0, 0) and (4 pi, 0) over the \
     valleys, with the bound of Lemma S.3 and the spread of Lemma S.5",
    data,
    draw,
);

const NUMBERS: [usize; 3] = [8, 32, 128];

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    // The speeds are at most 2000, and the minimisers are accurate to rounding times the condition
    // N².
    let speed = Tolerance::Close { relative: 1e-7, absolute: 1e-6 };
    let mut data = Data::new(&[
        ("n index", Tolerance::Exact),
        ("least_energy least_length mean greatest deviation equal", speed),
    ]);
    let problem = problem()?;
    let constants = Bounded::<2>::constants(&Valleys);
    let setting = Setting::new(constants, DISTANCE, 2)?;
    for number in NUMBERS {
        let n = subintervals(number)?;
        let line = problem.solve(Rule::TRAPEZOIDAL, number)?;
        let mut energy = line.speeds();
        // The mirror image of a minimiser is also a minimiser. The one that is ahead is taken.
        let ahead: f64 = line.sequence().points().iter().map(|x| x[0] - 2.0 * PI).sum();
        if ahead < 0.0 {
            energy.reverse();
        }
        let equal = equal_speed(line.sequence())?;
        let length = Rule::TRAPEZOIDAL.speeds(&Valleys, &along_the_axis(&middle_jump(number))?);
        let mean = energy.iter().sum::<f64>() / number as f64;
        let fastest = energy.iter().copied().fold(0.0, f64::max);
        let discrete = line.discrete_energy();
        // The residual is rounding alone, and √(N E_N) is the smaller bound here.
        let greatest = greatest_speed(constants, discrete, 0.0, n);
        let surplus = (discrete / (DISTANCE * DISTANCE) - 1.0).max(0.0);
        let spread = Spread::of_second_order(setting, n, surplus)
            .ok_or_else(|| Failure::Data("M_H is not known".to_owned()))?;
        let deviation = DISTANCE * spread.deviation;
        let furthest = energy.iter().map(|q| (q - mean).abs()).fold(0.0, f64::max);
        if !(fastest <= greatest && furthest <= deviation) {
            let claim = format!("N = {number}: speeds up to {fastest}, {furthest} from the mean");
            return Err(Failure::Violated(claim));
        }
        for (index, (energy, length)) in energy.into_iter().zip(length).enumerate() {
            let cells = [energy, length, mean, greatest, deviation, equal];
            let cells = cells.map(|value| format!("{value:.9e}"));
            data.push([number.to_string(), index.to_string()].into_iter().chain(cells));
        }
    }
    Ok(data)
}

/// Returns the speed of all chords of the minimiser among sequences of equal speeds, as of Liu et al.
/// (2017), near a minimiser without this constraint.
fn equal_speed(free: &PointSequence<2>) -> Result<f64, Failure> {
    let metric = Prepared::new(Valleys);
    // The speeds are printed with ten digits, of which a tolerance of 10⁻⁸ leaves seven and more.
    let limits = Limits { tolerance: 1e-8, ..Limits::default() };
    let unseen = &mut |_: &Iterate<'_, 2>| ControlFlow::Continue(());
    let found = equal_speeds(&metric, Rule::TRAPEZOIDAL, free.clone(), &limits, unseen)?;
    let (ended, n) = (found.descended.ended, free.n());
    let speeds = Rule::TRAPEZOIDAL.speeds(&Valleys, &found.descended.sequence);
    let speed = found.descended.energy.sqrt();
    // The residual of the speeds, and their rounding.
    let are_equal = |q: &f64| (q / speed - 1.0).abs() <= limits.tolerance + 1e-12;
    if ended != Ended::Stationary || !speeds.iter().all(are_equal) {
        return Err(Failure::Violated(format!("N = {n}: {ended:?}, the speeds are {speeds:?}")));
    }
    Ok(speed)
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let mut panels = Vec::new();
    let fastest = data.greatest("least_length");
    let slowest = data.rows().map(|row| row.number("least_energy")).fold(f64::INFINITY, f64::min);
    let from = 10_f64.powi(slowest.log10().floor() as i32);
    for (k, number) in NUMBERS.into_iter().enumerate() {
        let rows: Vec<Row<'_>> = data.rows_with("n", &number.to_string()).collect();
        let first = rows.first().ok_or_else(|| Failure::Data("no speeds".to_owned()))?;
        let [mean, greatest, deviation, equal] =
            ["mean", "greatest", "deviation", "equal"].map(|column| first.number(column));
        let x = Axis::new(Scale::Linear, 0.0, 1.0)?.labelled("place $n/N$ of the chord");
        // Leave room for the name of the highest jump.
        let y =
            Axis::new(Scale::Decades, from, 1.6 * fastest)?.labelled_if(k == 0, "speed $|β_n|_g$");
        let letter = ["a", "b", "c"][k];
        let mut panel = Panel::new(x, y).titled(format!("({letter}) $N = {number}$")).tall(260.0);
        let level = |value: f64| [(0.0, value), (1.0, value)];
        panel = panel
            .curve(
                Curve::new(level(greatest), palette::BLUE)
                    .dashed(&[6.0, 3.0])
                    .labelled("greatest by Lemma S.3"),
            )
            .curve(
                Curve::new(level(mean + deviation), palette::GREEN)
                    .dashed(&[2.0, 2.0])
                    .labelled("mean + $R$ of Lemma S.5"),
            );
        let at = |row: &Row<'_>| (row.number("index") + 0.5) / number as f64;
        // For these N, mean − R is negative and gives no information. Chords at rest cannot be
        // shown on a logarithmic axis, so only the jump is drawn, as a stem.
        let jump = rows.iter().find(|row| row.number("least_length") > 0.0);
        let jump = jump.ok_or_else(|| Failure::Data("nothing jumps".to_owned()))?;
        let (place, height) = (at(jump), jump.number("least_length"));
        let stem = Curve::new([(place, from), (place, height)], palette::PURPLE);
        let top = Curve::new([(place, height)], palette::PURPLE).marked(Marker::Diamond);
        panel = panel
            .curve(Curve::new(level(equal), palette::INK).labelled("least energy at equal speeds"));
        let energy = rows.iter().map(|row| (at(row), row.number("least_energy")));
        let energy = Curve::new(energy, palette::VERMILLION).labelled("least energy");
        panel = panel
            .curve(stem.wide(2.4))
            .curve(top.labelled("least length: one jump, rest elsewhere"))
            .curve(if number <= 32 { energy.marked(Marker::Disc) } else { energy.wide(2.4) });
        let times = format!("${:.0}\u{2009}d$", height / DISTANCE);
        let note = Note::new((place, height), times, palette::PURPLE, Align::Left);
        panels.push(panel.note(note.shifted(8.0, -7.0)));
    }
    let title = "Speeds of the chords of the minimisers of energy and of length";
    Ok(drawing::Figure::new(960.0, title, vec![panels]).keyed().draw()?)
}
