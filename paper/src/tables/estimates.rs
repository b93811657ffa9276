//! How far the extrapolated distance is from the distance, beside the error that it states.

use std::f64::consts::FRAC_PI_2;

use tautline::{
    Ends, Formula, Grid, KnownDistance, Metric, Prepare, Problem, Request, Rule, SVector,
    gallery::{
        Corrugated, GaussianFisher, HyperbolicPatch, Lens, Ramp, Separable, Shear, SpherePatch,
        Swirl,
    },
};
use tautline_checks::adversary::SplitMix;

use crate::{
    Failure,
    artefact::{Artefact, Seed},
    data::{Data, Tolerance},
    layout::{Layout, scientific},
    parallel,
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "estimates",
    "random problems with a known distance, by the rule: those without an extrapolated distance, those that \
     are farther from the distance than the stated error, of which one in a hundred may be, the largest such \
     factor, and the median of the stated error relative to the squared distance",
    data,
    layout,
)
.seeded(Seed::One(SEED));

const SEED: u64 = 7;

/// The number of problems of each kind by each rule, and the number in a quick run.
const PROBLEMS: usize = 70;
const QUICK: usize = 7;

/// One in so many problems may be farther from the distance than its error.
const ONE_IN: usize = 100;

/// The numbers of chords, which take turns.
const CHORDS: [usize; 7] = [64, 100, 128, 256, 500, 1000, 2291];

/// A distance is known to this part of its square: the closed forms, and the energies, are rounded.
const ROUNDING: f64 = 1e-13;

/// An extrapolated distance.
#[derive(Clone, Copy, Debug)]
struct Estimated {
    /// The error of the estimated squared distance, relative to the known squared distance.
    off: f64,
    /// The stated error of the estimated squared distance, relative to the known squared distance.
    error: f64,
}

/// Draws a problem, and returns its extrapolated distance if it has one; `None` without a problem.
type Draw = fn(&mut SplitMix, usize, Rule) -> Result<Option<Option<Estimated>>, Failure>;

const KINDS: [(&str, Draw); 11] = [
    ("Separable", |random, n, rule| {
        let metric = Separable::new(
            [random.between(-0.9, 0.9), random.between(-0.9, 0.9)],
            [random.between(0.3, 3.3), random.between(0.3, 3.3)],
        )?;
        let [x, y] = pair(random, 3.0);
        between(metric, x, y, n, rule)
    }),
    ("Ramp", |random, n, rule| {
        let metric = Ramp::new(random.between(0.0, 0.9), random.between(0.2, 3.2))?;
        let [x, y] = [random.between(-6.0, 6.0), random.between(-6.0, 6.0)];
        between(metric, [x].into(), [y].into(), n, rule)
    }),
    ("Corrugated", |random, n, rule| {
        let metric = Corrugated::new(random.between(0.1, 1.1), random.between(0.2, 3.2))?;
        let [x, y] = pair(random, 3.0);
        between(metric, x, y, n, rule)
    }),
    ("Shear", |random, n, rule| {
        let metric = Shear::new(random.between(0.1, 1.1), random.between(0.2, 3.2))?;
        let [x, y] = pair(random, 3.0);
        between(metric, x, y, n, rule)
    }),
    ("Swirl", |random, n, rule| {
        let metric = Swirl::new(random.between(0.0, 3.0), random.between(0.3, 1.3))?;
        let [x, y] = pair(random, 3.0);
        between(metric, x, y, n, rule)
    }),
    ("Lens", |random, n, rule| {
        let metric = Lens::new(random.between(0.0, 10.0), random.between(0.05, 1.05))?;
        // Both ends are on one ray from the centre.
        let ray = pair(random, 1.0)[0].normalize();
        let [x, y] = [random.between(0.1, 3.0), random.between(0.0, 3.0)];
        between(metric, ray * x, ray * y, n, rule)
    }),
    ("GaussianFisher", |random, n, rule| {
        let [x, y] = pair(random, 3.0);
        between(GaussianFisher, x, y, n, rule)
    }),
    ("SpherePatch", |random, n, rule| {
        let [x, y] = pair(random, 1.5);
        between(SpherePatch::new(3.0)?, x, y, n, rule)
    }),
    ("HyperbolicPatch", |random, n, rule| {
        let [x, y] = pair(random, 0.6);
        between(HyperbolicPatch::new(0.85)?, x, y, n, rule)
    }),
    ("latitude and longitude", |random, n, rule| {
        let globe = formula("diag(cos(x2)^2, 1)")?;
        let place = |random: &mut SplitMix| {
            SVector::from([random.between(-FRAC_PI_2, FRAC_PI_2), random.between(-1.45, 1.45)])
        };
        let [x, y] = [place(random), place(random)];
        let half = (0.5 * (y - x)).map(f64::sin);
        let chord = half[1].powi(2) + x[1].cos() * y[1].cos() * half[0].powi(2);
        estimated(globe, x, y, n, rule, 2.0 * chord.sqrt().asin())
    }),
    ("half-plane", |random, n, rule| {
        let half = formula("cost(1/x2)")?;
        let place = |random: &mut SplitMix| {
            SVector::from([random.between(-3.0, 3.0), random.between(-4.0, 0.0).exp()])
        };
        let [x, y] = [place(random), place(random)];
        let across = (y - x).norm_squared() / (2.0 * x[1] * y[1]);
        estimated(half, x, y, n, rule, (1.0 + across).acosh())
    }),
];

/// Two points of a square about 0, with sides of twice this length.
fn pair(random: &mut SplitMix, side: f64) -> [SVector<f64, 2>; 2] {
    [(); 2].map(|()| SVector::from_fn(|_, _| random.between(-side, side)))
}

fn formula(text: &str) -> Result<Formula<2>, Failure> {
    Formula::parse(text, &[]).map_err(|error| Failure::Violated(format!("{text}: {error}")))
}

fn between<M, const D: usize>(
    metric: M,
    x: SVector<f64, D>,
    y: SVector<f64, D>,
    n: usize,
    rule: Rule,
) -> Result<Option<Option<Estimated>>, Failure>
where
    M: KnownDistance<D> + Metric<D> + Prepare<D>,
    M::Prepared: Send,
{
    match metric.distance(&x, &y) {
        Some(distance) => estimated(metric, x, y, n, rule, distance),
        None => Ok(None),
    }
}

fn estimated<M, const D: usize>(
    metric: M,
    x: SVector<f64, D>,
    y: SVector<f64, D>,
    n: usize,
    rule: Rule,
    distance: f64,
) -> Result<Option<Option<Estimated>>, Failure>
where
    M: Metric<D> + Prepare<D>,
    M::Prepared: Send,
{
    // Close points are no problem.
    if !(distance > 1e-3) {
        return Ok(None);
    }
    let problem = Problem::new(metric, Ends::points(x, y)?);
    let request = Request { grid: Grid::Chords(n), rule, ..Request::default() };
    let line = problem
        .answer(&request)
        .map_err(|error| Failure::Violated(format!("from {x} to {y}: {error}")))?;
    let square = distance * distance;
    Ok(Some(line.distance_squared_estimate().map(|estimate| Estimated {
        off: (estimate.value / square - 1.0).abs(),
        error: estimate.error / square,
    })))
}

fn data(sweep: Sweep) -> Result<Data, Failure> {
    // A problem or two may change sides on another machine, and so does the worst.
    let count = Tolerance::Close { relative: 0.0, absolute: 2.0 };
    let mut data = Data::new(&[
        ("kind rule problems", Tolerance::Exact),
        ("without beyond", count),
        ("worst", Tolerance::Free),
        ("median", Tolerance::relative(0.5)),
    ]);
    let problems = if sweep.quick { QUICK } else { PROBLEMS };
    let rules = [Rule::TRAPEZOIDAL, Rule::LEFT_ENDPOINT];
    let cases: Vec<(usize, Rule)> =
        (0..KINDS.len()).flat_map(|kind| rules.map(|rule| (kind, rule))).collect();
    let found = parallel::map(&cases, |&(kind, rule)| {
        let mut random = SplitMix::new(SEED + kind as u64);
        let mut all = Vec::new();
        while all.len() < problems {
            let n = CHORDS[all.len() % CHORDS.len()];
            all.extend(KINDS[kind].1(&mut random, n, rule)?);
        }
        Ok::<_, Failure>(all)
    });
    let mut all = Vec::new();
    for ((kind, rule), found) in cases.iter().zip(found) {
        let found: Vec<Option<Estimated>> = found?;
        data.push(row(KINDS[*kind].0, rule.name(), &found));
        all.extend(found);
    }
    data.push(row("all", "both", &all));
    let known: Vec<&Estimated> = all.iter().flatten().collect();
    let beyond = known.iter().filter(|estimated| estimated.is_beyond()).count();
    if beyond * ONE_IN > known.len() {
        let message = format!("{beyond} of {} estimates are beyond their errors", known.len());
        return Err(Failure::Violated(message));
    }
    Ok(data)
}

impl Estimated {
    fn is_beyond(&self) -> bool {
        self.off > self.error + ROUNDING
    }
}

fn row(kind: &str, rule: &str, found: &[Option<Estimated>]) -> Vec<String> {
    let known: Vec<&Estimated> = found.iter().flatten().collect();
    let beyond = known.iter().filter(|estimated| estimated.is_beyond()).count();
    let worst = known.iter().map(|it| it.off / (it.error + ROUNDING)).fold(0.0, f64::max);
    let mut errors: Vec<f64> = known.iter().map(|estimated| estimated.error).collect();
    errors.sort_by(f64::total_cmp);
    let median = errors.get(errors.len() / 2).copied().unwrap_or(f64::NAN);
    let counts = [found.len(), found.len() - known.len(), beyond].map(|count| count.to_string());
    let mut row = vec![kind.to_owned(), rule.to_owned()];
    row.extend(counts);
    row.extend([format!("{worst:.2}"), format!("{median:.1e}")]);
    row
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "The extrapolated distance on random problems whose distance is known, between points and on 64 to \
         2,291 chords. None: the search did not converge, or the chords do not resolve the metric. Beyond: \
         the squared distance is farther from the estimate than the stated error; one in a hundred may be. \
         Worst: the largest of these factors. Error: the median of the stated error, relative to the \
         squared distance.",
        "metric & rule & problems & none & beyond & worst & error",
    );
    for row in data.rows() {
        let kind = row.text("kind");
        let mut cells = vec![if layout.group_by(kind) { kind } else { "" }.to_owned()];
        cells.push(row.text("rule").replace('_', "-"));
        cells.extend(row.texts("problems without beyond worst"));
        cells.push(scientific(row.number("median"), 1));
        layout.push(cells);
    }
    Ok(layout)
}
