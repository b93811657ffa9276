//! Time and width of enclosures of the energy and the length of a curve.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use tautline::{
    Interpolation, Interval, Metric, PointSequence, Polygon, Rule, SVector,
    gallery::{EggCrate, GaussianFisher, Valleys},
};

use crate::{
    Failure,
    artefact::{Artefact, Times},
    data::{Data, Tolerance},
    layout::{Layout, scientific},
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "certified_curves",
    "the time to enclose the energy and the length of a polygon, and its discrete energy, beside \
     the same in doubles, on one thread of the machine that wrote the file",
    data,
    layout,
)
.timed(Times::Unchecked);

/// The number of rounds, each of which makes all measurements. The smallest time of each counts.
const ROUNDS: usize = 3;

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("metric n what", Tolerance::Exact),
        ("nanoseconds_per_chord ratio_to_doubles ratio_to_discrete_energy", Tolerance::Free),
        ("relative_width", Tolerance::Close { relative: 0.5, absolute: 1e-12 }),
    ]);
    let most = if sweep.quick { 10_000 } else { 1_000_000 };
    for n in [1_000, 10_000, 100_000, 1_000_000].into_iter().filter(|&n| n <= most) {
        rows(&mut data, "valleys", &Valleys, n)?;
        rows(&mut data, "Gaussian Fisher", &GaussianFisher, n)?;
        rows(&mut data, "egg crate", &EggCrate::new(0.5, 2.0)?, n)?;
    }
    Ok(data)
}

/// Returns the time of a computation, and its result.
fn timed<T>(compute: impl FnOnce() -> T) -> (Duration, T) {
    let begun = Instant::now();
    let result = black_box(compute());
    (begun.elapsed(), result)
}

/// Adds the rows of one metric, along `(3(2t − 1), 2 sin 3t)`.
fn rows(data: &mut Data, name: &str, metric: &impl Metric<2>, n: usize) -> Result<(), Failure> {
    let at = |k: usize| {
        let t = k as f64 / n as f64;
        SVector::from([3.0 * (2.0 * t - 1.0), 2.0 * (3.0 * t).sin()])
    };
    let sequence = PointSequence::new((0..=n).map(at).collect())?;
    let (polygon, curve) = (Polygon::new(&sequence), Interpolation::new(&sequence));
    let mut least = [Duration::MAX; 4];
    let mut widths = [0.0; 4];
    for _ in 0..ROUNDS {
        let (value, energy) = timed(|| Rule::TRAPEZOIDAL.energy(black_box(metric), &sequence));
        let (enclosing, discrete) =
            timed(|| polygon.discrete_energy(Rule::TRAPEZOIDAL, black_box(metric)));
        let (quadratures, (integral, length)) =
            timed(|| (curve.energy(black_box(metric)), curve.length(black_box(metric))));
        let (proving, bounds) = timed(|| polygon.energy_and_length(black_box(metric)));
        // The error estimates of the quadratures are not rigorous, and the values are rounded.
        let near = |found: f64, error: f64, bounds: Interval| {
            let granted = 1e-12 * bounds.hi() + error;
            bounds.lo() - granted <= found && found <= bounds.hi() + granted
        };
        let agree = [
            near(energy, 0.0, discrete),
            near(integral.value, integral.error, bounds.0),
            near(length.value, length.error, bounds.1),
        ];
        if agree.contains(&false) {
            return Err(Failure::Violated(format!("{name}, N = {n}: {agree:?}")));
        }
        for (least, time) in least.iter_mut().zip([value, enclosing, quadratures, proving]) {
            *least = (*least).min(time);
        }
        let relative = |bounds: Interval| bounds.width() / bounds.lo();
        let curve = relative(bounds.0).max(relative(bounds.1));
        widths = [f64::NAN, relative(discrete), f64::NAN, curve];
    }
    let what = [
        "discrete energy, in doubles",
        "discrete energy, enclosed",
        "energy and length, in doubles",
        "energy and length, enclosed",
    ];
    for (k, what) in what.into_iter().enumerate() {
        let ratio_to = |of: usize| least[k].as_secs_f64() / least[of].as_secs_f64();
        data.push(vec![
            name.to_owned(),
            n.to_string(),
            what.to_owned(),
            format!("{:.1}", 1e9 * least[k].as_secs_f64() / n as f64),
            format!("{:.1}", ratio_to(k & 2)),
            format!("{:.1}", ratio_to(0)),
            if widths[k].is_nan() { String::new() } else { format!("{:.1e}", widths[k]) },
        ]);
    }
    Ok(())
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Enclosing the energies of a polygon: nanoseconds a chord, the ratio to the same in doubles \
         and to one discrete energy in doubles, and the relative width.",
        "metric & $N$ & what & ns a chord & to doubles & to $E_{tra,N}$ & width",
    );
    for row in data.rows() {
        let mut cells = row.texts("metric n what nanoseconds_per_chord");
        cells.extend(row.texts("ratio_to_doubles ratio_to_discrete_energy"));
        cells.push(scientific(row.number("relative_width"), 1));
        layout.push(cells);
    }
    Ok(layout)
}
