//! Routes of one chord on the line, for which a rule's value of `H` is too large or too small.

use tautline::{Constants, Ends, FiniteSet, gallery::Constant};
use tautline_statements::{
    Known, LIBRARY, PaperRule, Reconstruction, Subject, VerifyError,
    witnesses::{Polygonal, two_routes},
};

use super::claiming;

/// The slope of all profiles here; `δ` equals it to within a percent.
pub(crate) const SLOPE: f64 = 1e-3;

/// The amount by which the wrong route seems shorter: ten times the difference that the solver
/// treats as a tie.
pub(crate) const MARGIN: f64 = 1e-8;

/// The values of `H` along a route, given as `[s, H]` at three knots.
pub(crate) type Knots = [[f64; 2]; 3];

/// Returns a profile with two opposite slopes, on a route of length 1.
fn tent(foot: f64, tip: f64) -> Knots {
    [[0.0, foot], [0.5, tip], [1.0, foot]]
}

pub(crate) fn ridge(foot: f64) -> Knots {
    tent(foot, foot + 0.5 * SLOPE)
}

pub(crate) fn valley(tip: f64) -> Knots {
    tent(tip + 0.5 * SLOPE, tip)
}

fn straight(start: f64, end: f64) -> Knots {
    [[0.0, start], [0.5, 0.5 * (start + end)], [1.0, end]]
}

pub(crate) fn upwards(start: f64) -> Knots {
    straight(start, start + SLOPE)
}

pub(crate) fn downwards(end: f64) -> Knots {
    straight(end + SLOPE, end)
}

/// Returns the profile `H = 1` along a route of this length.
pub(crate) fn level(length: f64) -> Knots {
    [[0.0, 1.0], [0.5 * length, 1.0], [length, 1.0]]
}

/// Makes a profile a hundred times as steep, so that its slope is 0.1.
pub(crate) fn steep(knots: Knots) -> Knots {
    knots.map(|[s, h]| [s, 1.0 + 0.1 / SLOPE * (h - 1.0)])
}

/// Returns two routes, of which the longer one seems shorter by [`MARGIN`]: the rule evaluates `H`
/// at the top of the first route and at the bottom of the second.
pub(crate) fn misleading(rule: PaperRule) -> [Knots; 2] {
    match rule {
        PaperRule::Trapezoidal => [ridge(1.0), valley(1.0 + 0.5 * SLOPE - MARGIN)],
        PaperRule::LeftEndpoint => [downwards(1.0), upwards(1.0 + SLOPE - MARGIN)],
    }
}

/// Observes the minimiser with one chord from set to set, on two routes.
pub(crate) fn routes(
    subject: &Subject,
    rule: PaperRule,
    [first, second]: [Knots; 2],
) -> Result<Reconstruction<1>, VerifyError> {
    let known = two_routes(&first, &second).expect("apart");
    Reconstruction::observe(subject, &known, rule, 1)
}

/// Observes the one chord between two points.
pub(crate) fn route(
    subject: &Subject,
    rule: PaperRule,
    knots: Knots,
) -> Result<Reconstruction<1>, VerifyError> {
    let metric = Polygonal::new(&knots).expect("in order");
    let known = Known::between(metric, [0.0], [1.0])?.expect("between the knots");
    Reconstruction::observe(subject, &known, rule, 1)
}

/// Observes the minimiser on two routes under constants that are only claimed.
pub(crate) fn claimed(
    rule: PaperRule,
    [first, second]: [Knots; 2],
    [c1, c2, l_h]: [f64; 3],
) -> Result<Reconstruction<1>, VerifyError> {
    let known = two_routes(&first, &second).expect("apart");
    let known = claiming(known, Constants::new(c1, c2, l_h)?);
    Reconstruction::observe(&LIBRARY, &known, rule, 1)
}

/// Observes a level route with `d² = 1.005` and a second route on which the rule evaluates `H = 1`.
/// On the second route the energy and the squared length are 1.025 (trapezoidal) or 1.05 (left), to
/// a thousandth.
pub(crate) fn cheap_second_route(
    rule: PaperRule,
    constants: [f64; 3],
) -> Result<Reconstruction<1>, VerifyError> {
    let second = match rule {
        PaperRule::Trapezoidal => valley(1.0),
        PaperRule::LeftEndpoint => upwards(1.0),
    };
    claimed(rule, [level(1.005_f64.sqrt()), steep(second)], constants)
}

/// Returns a problem from `{0, 10}` to `{1, 12}` under `H = 1`, where `C = 0` and `K̄ = d = 1`. The
/// observed minimiser leads straight from 10 to 12. It is a local minimiser, since the sets are
/// discrete, and it has `E = 4`.
pub(crate) fn longer_way(
    rule: PaperRule,
    n: usize,
) -> Result<(Known<Constant<1>, 1>, Reconstruction<1>), VerifyError> {
    let metric = Constant::<1>::new([[1.0]].into())?;
    let ends = Ends::new(FiniteSet::new([[0.0], [10.0]])?, FiniteSet::new([[1.0], [12.0]])?)?;
    let known = Known { metric, ends, distance: 1.0, distance_error: 0.0 };
    let far = LIBRARY.minimise(rule.into(), &metric, &Ends::points([10.0], [12.0])?, n)?;
    let seen = Reconstruction::read(&LIBRARY, &known, rule, far)?;
    Ok((known, seen))
}

/// Observes a minimiser that leads up an incline of slope 0.1 from 0 to 1.1 instead of 1, with `n`
/// subintervals. It has `E − d² = 0.226`.
pub(crate) fn beyond_the_end(rule: PaperRule, n: usize) -> Result<Reconstruction<1>, VerifyError> {
    let metric = Polygonal::new(&[[0.0, 1.0], [1.0, 1.1], [2.0, 1.2]]).expect("in order");
    let beyond = LIBRARY.minimise(rule.into(), &metric, &Ends::points([0.0], [1.1])?, n)?;
    let known = Known::between(metric, [0.0], [1.0])?.expect("between the knots");
    Reconstruction::read(&LIBRARY, &known, rule, beyond)
}
