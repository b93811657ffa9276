//! Section 4: minimal curves are minimal geodesics, reparametrised by a clock that may pause.

use nalgebra::SVector;
use tautline::{Metric, MetricError, norm_squared, quadrature::integrate};

use super::geodesics::off_sets;
use crate::{
    Evidence, Known, LIBRARY, Statement, Subject, Unit,
    curves::{Clock, Curve, Geodesic, KnownGeodesics, Measured, Reparametrised, Residual, largest},
};

/// Evaluates Proposition 4.1, read with clocks that may pause. The claim is that of [`prop_4_2`],
/// for two points whose distance is less than the normal radius at the first, in `m`. In fact the
/// points need not be near each other.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:geodesic_min_loc_path_min")]
pub fn prop_4_1<M: Metric<D>, C: Curve<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    geodesic: &C,
    clock: &Clock,
    radius: f64,
) -> Result<Evidence, MetricError> {
    let evidence = Evidence::of(Statement::Proposition4_1);
    let evidence = evidence.given("d < ε", Unit::LENGTH, [known.distance, radius], 0.0);
    reparametrised(evidence, subject, known, geodesic, clock)
}

/// Evaluates Proposition 4.2, read with clocks that may pause, on `γ = γ** ∘ φ`.
///
/// If `γ**` is a minimal geodesic and `φ` is nondecreasing, then `γ` is minimal, and `φ(t)` is the
/// length of `γ` up to the time `t`, divided by `d`. If `d = 0`, all curves are constant, and any
/// `φ` will do. [`prop_4_2_converse`] starts from any minimal curve.
///
/// Equality holds on every reparametrised minimal geodesic.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:geodesic_min_path_min")]
pub fn prop_4_2<M: Metric<D>, C: Curve<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    geodesic: &C,
    clock: &Clock,
) -> Result<Evidence, MetricError> {
    let evidence = Evidence::of(Statement::Proposition4_2);
    reparametrised(evidence, subject, known, geodesic, clock)
}

fn reparametrised<M: Metric<D>, C: Curve<D>, const D: usize>(
    evidence: Evidence,
    subject: &Subject,
    known: &Known<M, D>,
    geodesic: &C,
    clock: &Clock,
) -> Result<Evidence, MetricError> {
    let (metric, d) = (&known.metric, known.distance);
    let residual = Residual::of(subject, metric, geodesic)?;
    let straight = Measured::of(metric, geodesic);
    let curve = Reparametrised { curve: geodesic, clock };
    let seen = Measured::of(metric, &curve);
    let (off, rounding) = off_sets(subject, known, &straight);
    let granted = straight.granted_length() + seen.granted_length() + known.distance_error;
    let lag = lengths(metric, &curve).into_iter().map(|(t, s)| (s / d - clock.at(t)[0]).abs());
    // The time is rounded, which each piece turns into a few roundings of φ.
    let ticks = 16.0 * f64::EPSILON * clock.pieces() as f64;
    let evidence = evidence
        .given("γ** joins the points", Unit::COORDINATE, [off, 0.0], rounding)
        .given("γ̈** = −Γ(γ̇**, γ̇**)", Unit::COORDINATE, [residual.value, 0.0], residual.granted)
        .given("L(γ**) ≤ d", Unit::LENGTH, [straight.length.value, d], granted)
        .given("∫|φ′| ≤ 1", Unit::NONE, [clock.variation(), 1.0], ticks)
        .stated("L(γ** ∘ φ) ≤ d", Unit::LENGTH, [seen.length.value, d], granted)
        .sharper("d ≤ L(γ** ∘ φ)", Unit::LENGTH, [d, seen.length.value], granted);
    // If d = 0, the curve is constant, and it is γ** ∘ φ for every φ.
    if d == 0.0 {
        return Ok(evidence);
    }
    let granted = ticks + granted / d;
    Ok(evidence.stated("φ(t) = (length up to t)/d", Unit::NONE, [largest(lag), 0.0], granted))
}

/// Returns the end of each piece, with the length of the curve up to this end, in `m`.
fn lengths<M: Metric<D>, const D: usize>(metric: &M, curve: &impl Curve<D>) -> Vec<(f64, f64)> {
    let speed = |t: f64| curve.motion(t).speed_squared(metric).sqrt();
    let mut sum = 0.0;
    let up_to = |[from, to]: [f64; 2]| {
        sum += integrate(speed, from, to, 20.0 * f64::EPSILON).value;
        (to, sum)
    };
    curve.pieces().into_iter().map(up_to).collect()
}

/// Evaluates the converse in Proposition 4.2 on any curve `γ`: if `γ` is minimal, then
/// `γ(t) = γ**(φ(t))`, where `φ(t)` is the length of `γ` up to `t`, divided by `d`. Both sides are
/// evaluated at 16 times. Their points are compared, and their greatest distances from `γ(0)`, as
/// two inequalities of overestimation 1.
///
/// `γ**` must be the only minimal geodesic. If `d = 0`, both curves are constant.
#[doc(alias = "prop:geodesic_min_path_min")]
pub fn prop_4_2_converse<M: Metric<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    curve: &impl Curve<D>,
    geodesic: &impl Curve<D>,
) -> Evidence {
    let (metric, d) = (&known.metric, known.distance);
    let seen = Measured::of(metric, curve);
    let speed = |t: f64| curve.motion(t).speed_squared(metric).sqrt();
    let granted = seen.granted_length() + known.distance_error;
    let (mut before, mut travelled) = (0.0, 0.0);
    let (mut apart, mut rate) = (0.0, 0.0_f64);
    let start = curve.motion(0.0).position;
    let mut away = [0.0; 2];
    for k in 1..=16 {
        let t = f64::from(k) / 16.0;
        travelled += integrate(speed, before, t, 20.0 * f64::EPSILON).value;
        before = t;
        let (reading, per_length) =
            if d == 0.0 { (0.0, 0.0) } else { ((travelled / d).min(1.0), 1.0 / d) };
        let other = geodesic.motion(reading);
        let here = curve.motion(t).position;
        apart = largest([apart, (here - other.position).norm()]);
        let [one, two] = [here, other.position].map(|x| (x - start).norm());
        away = [largest([away[0], one]), largest([away[1], two])];
        // This factor converts an error of a length into an error of coordinates.
        rate = rate.max(other.velocity.norm() * per_length);
    }
    let (off, rounding) = off_sets(subject, known, &seen);
    let moved = 4.0 * granted * rate + rounding;
    let [one, two] = away;
    Evidence::of(Statement::Proposition4_2)
        .given("γ joins the points", Unit::COORDINATE, [off, 0.0], rounding)
        .given("L(γ) ≤ d", Unit::LENGTH, [seen.length.value, d], granted)
        .assumed("γ** is the only minimal geodesic")
        .stated("γ = γ** ∘ φ", Unit::COORDINATE, [apart, 0.0], moved)
        .stated("max |γ − γ(0)| ≤ max |γ** ∘ φ − γ(0)|", Unit::COORDINATE, [one, two], moved)
        .stated("max |γ** ∘ φ − γ(0)| ≤ max |γ − γ(0)|", Unit::COORDINATE, [two, one], moved)
}

/// Evaluates Propositions 4.1 and 4.2 with "monotone increasing" read strictly, so that clocks must
/// not pause. They are then false.
#[doc(alias = "prop:geodesic_min_path_min")]
pub fn prop_4_2_read_strictly<M: Metric<D>, C: Curve<D>, const D: usize>(
    known: &Known<M, D>,
    geodesic: &C,
    clock: &Clock,
) -> Evidence {
    let seen = Measured::of(&known.metric, &Reparametrised { curve: geodesic, clock });
    let granted = seen.granted_length() + known.distance_error;
    // The sets are points, so their projections need no test.
    let (off, rounding) = off_sets(&LIBRARY, known, &seen);
    Evidence::of(Statement::Proposition4_2)
        .given("γ joins the points", Unit::COORDINATE, [off, 0.0], rounding)
        .given("L(γ) ≤ d", Unit::LENGTH, [seen.length.value, known.distance], granted)
        .stated("γ never pauses", Unit::NONE, [clock.longest_pause(), 0.0], 0.0)
}

/// Evaluates the observable part of Proposition 4.3: `Exp_x` maps radii to distances and has an
/// inverse. The arguments are a point `x` of the ball `K = {|x| ≤ R}` and a tangent vector `v`,
/// with `R` and `v` in `ℓ`, and the common radius `ε` of `K`, in `m`.
///
/// Companion: the geodesic equation. `K` must be compact: on the sphere without one point,
/// geodesics from `x` exist up to the length `π − 2 arctan |x|`, which tends to 0 as `|x| → ∞`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:uniformal_normal_radius")]
pub fn prop_4_3<M: KnownGeodesics<D>, const D: usize>(
    subject: &Subject,
    metric: &M,
    [x, v]: [&SVector<f64, D>; 2],
    ball: f64,
    epsilon: f64,
) -> Result<Evidence, MetricError> {
    let curve = Geodesic::leaving(metric, *x, *v);
    let end = curve.motion(1.0).position;
    let radius = norm_squared(metric, x, v).sqrt();
    let distance = metric.distance(x, &end).unwrap_or(f64::NAN);
    let back = (metric.logarithm(x, &end) - v).norm();
    let residual = Residual::of(subject, metric, &curve)?;
    let seen = Measured::of(metric, &curve);
    let granted = 2.0 * seen.granted_length();
    // On the sphere, the inverse of Exp expands by r / sin r, which is at most 10 for r ≤ 2.85.
    let expanded = 10.0 * granted * v.norm() / radius;
    // This allows for the rounding of an arc tangent, and of an x on the boundary of the ball.
    let normal = metric.normal_radius(x);
    let rounding = 16.0 * f64::EPSILON * if normal.is_finite() { normal } else { 0.0 };
    Ok(Evidence::of(Statement::Proposition4_3)
        .given_that("K is bounded", ball.is_finite())
        .given("x ∈ K", Unit::COORDINATE, [x.norm(), ball], 4.0 * f64::EPSILON * x.norm())
        .given("|v| < ε", Unit::LENGTH, [radius, epsilon], 0.0)
        .stated("ε ≤ the normal radius of x", Unit::LENGTH, [epsilon, normal], rounding)
        .stated("|v| ≤ d(x, Exp_x v)", Unit::LENGTH, [radius, distance], granted)
        .stated("d(x, Exp_x v) ≤ |v|", Unit::LENGTH, [distance, radius], granted)
        .stated("Log_x Exp_x v = v", Unit::COORDINATE, [back, 0.0], expanded)
        .sharper("γ̈ = −Γ(γ̇, γ̇)", Unit::COORDINATE, [residual.value, 0.0], residual.granted))
}

/// Evaluates Lemma 4.4 on a curve between two points: if it is minimal and has constant speed, it
/// satisfies the geodesic equation.
///
/// The two sides are compared as vectors, and their sizes are compared in both directions. If
/// `d = 0`, the curve is constant and therefore a geodesic.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "lem:minimal_constant_speed_geodesic")]
pub fn lemma_4_4<M: Metric<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    curve: &impl Curve<D>,
) -> Result<Evidence, MetricError> {
    let seen = Measured::of(&known.metric, curve);
    let Residual { value, acceleration, bending, granted } =
        Residual::of(subject, &known.metric, curve)?;
    let length = seen.granted_length() + known.distance_error;
    let [least, largest] = seen.speeds;
    let (off, rounding) = off_sets(subject, known, &seen);
    Ok(Evidence::of(Statement::Lemma4_4)
        .given("γ joins the points", Unit::COORDINATE, [off, 0.0], rounding)
        .given("L(γ) ≤ d", Unit::LENGTH, [seen.length.value, known.distance], length)
        .given("the speed is constant", Unit::LENGTH, [largest - least, 0.0], length)
        .stated("γ̈ = −Γ(γ̇, γ̇)", Unit::COORDINATE, [value, 0.0], granted)
        .stated("max |γ̈| ≤ max |Γ(γ̇, γ̇)|", Unit::COORDINATE, [acceleration, bending], granted)
        .stated("max |Γ(γ̇, γ̇)| ≤ max |γ̈|", Unit::COORDINATE, [bending, acceleration], granted))
}
