//! The accuracy of a distance against the time that it takes, by every method.

use crate::{
    Failure,
    artefact::{Artefact, Times},
    data::{Data, Row},
    drawing::{
        self, Align, Axis, Colour, Curve, Marker, Note, Panel, Region, Scale, Scene, palette,
    },
    methods::{self, Method, problems},
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "methods",
    "the relative error of the distance against the time on one thread, for every method and for \
     settings from coarse to fine: numbers of chords, tolerances, or cells of a lattice; on three \
     problems whose distance is known",
    data,
    draw,
)
.timed(Times::Free);

/// Another geodesic is off by more than this, and every coarse setting by less.
const ANOTHER: f64 = 0.3;

/// The range of the errors. Below are roundings.
const ERRORS: (f64, f64) = (1e-15, 100.0);

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = methods::columns();
    for problem in problems()? {
        // The discrete logarithm is in the table: it takes the time of the solver for its first chord.
        for method in Method::ALL.into_iter().filter(|&m| m != Method::DiscreteLogarithm) {
            let mut settings = method.settings(problem.dimension);
            if sweep.quick {
                settings.truncate(1);
            }
            for setting in settings {
                data.push(problem.row(method, setting, sweep.repeats));
            }
        }
    }
    Ok(data)
}

/// The colour of a family of methods, and the marker and the dashes of one of them.
fn style(method: Method) -> (Colour, Marker, &'static [f64]) {
    let (dashed, dotted): (&[f64], &[f64]) = (&[6.0, 3.0], &[2.0, 2.0]);
    match method {
        Method::Trapezoidal => (palette::VERMILLION, Marker::Disc, &[]),
        Method::Extrapolated => (palette::VERMILLION, Marker::Star, &[]),
        Method::LeftEndpoint => (palette::VERMILLION, Marker::Square, dashed),
        Method::FromTheLine => (palette::VERMILLION, Marker::Ring, dotted),
        Method::Classes => (palette::VERMILLION, Marker::Diamond, dotted),
        Method::LbfgsPoints => (palette::BLUE, Marker::Disc, dashed),
        Method::LbfgsSobolev => (palette::BLUE, Marker::Square, &[]),
        Method::SobolevGradient => (palette::BLUE, Marker::Triangle, &[]),
        Method::DynamicProgramming => (palette::BLUE, Marker::Diamond, &[]),
        Method::GaussNewton => (palette::BLUE, Marker::Ring, dotted),
        Method::EqualSpeeds | Method::DiscreteLogarithm => {
            (palette::PURPLE, Marker::Diamond, dashed)
        }
        Method::Shooting => (palette::GREEN, Marker::Triangle, &[]),
        Method::Collocation => (palette::GREEN, Marker::Square, &[]),
        Method::LatticePath => (palette::ORANGE, Marker::Diamond, &[]),
        Method::FirstOrderMarch => (palette::INK, Marker::Triangle, dashed),
        Method::SecondOrderMarch => (palette::INK, Marker::Disc, &[]),
    }
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let times = data.rows().filter(|row| !row.number("error").is_nan());
    let times: Vec<f64> = times.map(|row| row.number("seconds")).collect();
    let shortest = times.iter().copied().fold(f64::INFINITY, f64::min);
    let longest = times.iter().copied().fold(0.0, f64::max);
    let from = 10_f64.powi(shortest.log10().floor() as i32);
    let to = 10_f64.powi(longest.log10().ceil() as i32);
    let mut panels = Vec::new();
    for (k, problem) in problems()?.iter().enumerate() {
        let rows: Vec<Row<'_>> = data.rows_with("problem", problem.name).collect();
        let x = Axis::new(Scale::Decades, from, to)?;
        let y = Axis::new(Scale::Decades, ERRORS.0, ERRORS.1)?
            .labelled_if(k == 0, "relative error of the distance");
        let letter = ["a", "b", "c"][k];
        let title = format!("({letter}) {}, $D = {}$", problem.name, problem.dimension);
        let (low, high) = (ANOTHER, ERRORS.1);
        let band = vec![(from, low), (to, low), (to, high), (from, high)];
        let band = Region::new(vec![band]).filled(palette::GREY, 0.15);
        let mut panel =
            Panel::new(x.labelled("time in s"), y).titled(title).tall(430.0).region(band);
        let mut without: Vec<&str> = Vec::new();
        for method in Method::ALL {
            let runs = || rows.iter().filter(|row| row.text("method") == method.name());
            let points: Vec<(f64, f64)> = runs()
                .filter(|row| !row.number("error").is_nan())
                .map(|row| (row.number("seconds"), row.number("error").abs().max(ERRORS.0)))
                .collect();
            if runs().count() == 0 {
                continue;
            }
            if points.is_empty() {
                without.push(method.name());
            }
            let (colour, marker, dash) = style(method);
            let curve = Curve::new(points, colour).marked(marker).dashed(dash);
            panel = panel.curve(curve.labelled(method.name()));
        }
        let another = rows.iter().any(|row| row.number("error") > ANOTHER);
        let mut lines = Vec::new();
        if another {
            lines.push("another geodesic".to_owned());
        }
        for method in without {
            lines.push(format!("no answer: {method}"));
        }
        for (line, text) in lines.into_iter().enumerate() {
            let at = (from, 0.4 * ERRORS.1);
            let note = Note::new(at, text, palette::GREY, Align::Left);
            panel = panel.note(note.shifted(5.0, 14.0 * line as f64));
        }
        panels.push(panel);
    }
    let title = "Error of the distance against time, by every method";
    Ok(drawing::Figure::new(1080.0, title, vec![panels]).keyed().draw()?)
}
