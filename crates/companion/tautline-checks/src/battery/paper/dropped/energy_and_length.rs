//! Propositions 6.1 to 6.3 and 9.1, each without one of its hypotheses.

use nalgebra::{SMatrix, SVector};
use tautline::{
    Ball, ClosedSet, Ends, HalfSpace, KnownDistance, Point, PointSequence, Segment,
    gallery::{Constant, Sphere},
};
use tautline_statements::{
    Known, LIBRARY, NearestPair,
    Statement::{self, Proposition6_1, Proposition6_2, Proposition6_3, Proposition9_1},
    VerifyError, WayOut,
    curves::{Clock, Geodesic, KnownGeodesics, Measured, Pace, Reparametrised, SmoothCurve},
    prop_6_1, prop_6_1_attained, prop_6_1_minimiser, prop_6_2, prop_6_3, prop_6_3_attained,
    prop_9_1,
};

use crate::battery::{
    cases::{AboveExponential, clauses::ENDS, round_the_missing_point, sheared},
    harness::{Check, Dropped, Failure, Outcome, Trial, all, close, fails_without, holds_without},
    paper::section_9::late,
};

const P61: &[Statement] = &[Proposition6_1];
const P62: &[Statement] = &[Proposition6_2];
const P91: &[Statement] = &[Proposition9_1];

pub(crate) const CHECKS: &[Check] = &[
    Dropped.check("prop_6_1_fails_for_a_curve_that_stops_short", P61, stops_short),
    Dropped.check("prop_6_1_says_nothing_of_a_clock_that_runs_late", P61, runs_late),
    Dropped.check("prop_6_1_fails_for_a_segment_in_place_of_a_point", P61, segments),
    Dropped.check(
        "props_6_1_and_6_3_fail_on_the_sphere_without_a_point",
        &[Proposition6_1, Proposition6_3],
        not_attained,
    ),
    Dropped.check("prop_6_2_fails_for_two_unbounded_sets", P62, both_unbounded),
    Dropped.check(
        "prop_6_2_fails_on_the_sphere_without_a_point",
        P62,
        nearest_at_the_missing_point,
    ),
    Dropped.check("prop_6_2_fails_for_an_open_set_and_for_other_points", P62, open_or_outside),
    Dropped.check("prop_6_3_fails_for_a_curve_outside_the_sets", &[Proposition6_3], outside),
    Dropped.check("prop_9_1_fails_for_a_minimiser_of_the_length_alone", P91, |_| {
        let (known, on_time, late) = late()?;
        fails_without(&["E(γ*) ≤ d²"], prop_9_1(&LIBRARY, &known, &on_time, &late))
    }),
    Dropped.check(
        "prop_9_1_fails_for_other_curves_in_place_of_the_minimiser",
        P91,
        other_minimisers,
    ),
    Dropped.check("prop_9_1_holds_for_curves_that_join_nothing", P91, joins_nothing),
];

/// The geodesic stops after nine tenths of the way, so that `L² = E = 0.81 d²`.
fn stops_short(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let velocity = known.metric.logarithm(&[0.0, 0.0].into(), &[2.0, 3.0].into());
    let short = Geodesic::leaving(known.metric, SVector::zeros(), velocity * 0.9);
    let seen = Measured::of(&known.metric, &short);
    let whole = Measured::of(&known.metric, &geodesic);
    close("E/d²", seen.energy.value / whole.energy.value, 0.81, 1e-13)?;
    let minimiser = prop_6_1_minimiser(&LIBRARY, &known, &short)?;
    all([
        fails_without(&[ENDS], prop_6_1(&LIBRARY, &known, &seen)),
        fails_without(&[ENDS], minimiser),
    ])
}

/// A minimal geodesic parametrised by `t²` has `E = 4d²/3`. It has the least length, but it is not
/// a geodesic.
fn runs_late(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let clock = Clock::plain(Pace::Accelerating);
    let curve = Reparametrised { curve: &geodesic, clock: &clock };
    let evidence = prop_6_1_minimiser(&LIBRARY, &known, &curve)?;
    fails_without(&["E(γ) ≤ d²"], evidence)
}

/// The problem leads from a segment along `(1, −1)` to the point `(3, 3)` in the plane. With
/// `d = √20`, the distance from the ends of the segment, the curve from its middle has length
/// `√18`, which is less. Between sets, `d` has to be the distance of the sets, as in Proposition
/// 6.3.
///
/// Projections of points on the axes detect a segment, however short it is and however far from the
/// origin it lies.
fn segments(_: &Trial<'_>) -> Outcome {
    let metric = Constant::<2>::new(SMatrix::identity())?;
    for ([a, b], from, to) in [
        ([[-1.0, 1.0], [1.0, -1.0]], [0.0, 0.0], [3.0, 3.0]),
        ([[1e3, 1e3], [999.9, 999.9]], [999.9, 999.9], [0.0, 0.0]),
    ] {
        let segment = Segment::new(a, b)?;
        let point = Point::new(to)?;
        let distance = metric.distance(&a.into(), &to.into()).expect("known");
        let ends = Ends::new(segment, point)?;
        let known = Known { metric, ends, distance, distance_error: 1e-15 * distance };
        let line = Measured::of(&metric, &SmoothCurve::straight(from, to));
        let clause = "the two sets are points";
        fails_without(&[clause], prop_6_1(&LIBRARY, &known, &line))?;
    }
    Ok(Default::default())
}

/// The wider the detour of a curve round the missing point, the shorter the curve is, and none is
/// shortest.
fn not_attained(_: &Trial<'_>) -> Outcome {
    let mut longer = f64::INFINITY;
    for r in [10.0, 100.0, 1000.0] {
        let (known, arcs, way_out) = round_the_missing_point(r)?;
        let seen = Measured::of(&known.metric, &arcs);
        if !(seen.energy.value < longer) {
            return Err(Failure::new(format!("r = {r}: {} after {longer}", seen.energy.value)));
        }
        longer = seen.energy.value;
        for statement in [prop_6_1_attained, prop_6_3_attained] {
            let evidence = statement(&LIBRARY, &known, &seen, way_out);
            fails_without(&["no way out"], evidence)?;
        }
    }
    Ok(Default::default())
}

/// Makes a pair of points of two sets in the plane; `distance` is the infimum over all pairs.
fn pair(
    sets: [&dyn ClosedSet<2>; 2],
    points: [[f64; 2]; 2],
    distance: f64,
) -> Result<NearestPair<2>, VerifyError> {
    let metric = Constant::<2>::new(SMatrix::identity())?;
    let points = points.map(SVector::from);
    let way_out = WayOut::from(&metric, &points[0]);
    let lengths = [(points[1] - points[0]).norm(), distance];
    Ok(NearestPair::between(&LIBRARY, &metric, sets, points, lengths, (way_out, 0.0))?)
}

/// For `X⁽⁰⁾ = {x₂ ≤ 0}` and `X⁽¹⁾ = {x₂ ≥ exp(−x₁)}` in the plane, `(t, 0)` and `(t, e⁻ᵗ)` come
/// arbitrarily close, but no pair has distance 0.
fn both_unbounded(_: &Trial<'_>) -> Outcome {
    let floor = HalfSpace::new([0.0, 1.0], 0.0)?;
    let sets: [&dyn ClosedSet<2>; 2] = [&floor, &AboveExponential];
    let pairs = [1.0, 5.0, 25.0, 125.0].map(|t: f64| pair(sets, [[t, 0.0], [t, (-t).exp()]], 0.0));
    all(pairs.map(|pair| fails_without(&["one of the sets is bounded"], prop_6_2(&pair?, 1.0))))
}

/// On the sphere, consider `X⁽⁰⁾ = {(−3, 0)}` and `X⁽¹⁾ = {x₁ ≥ 0}`. `X⁽¹⁾` is a closed hemisphere
/// without the missing point on its boundary, which would be the nearest point, at distance
/// `π − 2 arctan 3`. Points `(t, 0)` with `t ≥ ⅓` are farther away by `2 arctan 1/t`.
fn nearest_at_the_missing_point(_: &Trial<'_>) -> Outcome {
    let from = SVector::from([-3.0, 0.0]);
    let nearest = Sphere.normal_radius(&from);
    close("d", nearest, std::f64::consts::PI - 2.0 * 3_f64.atan(), 1e-15)?;
    let first = Point::new(from)?;
    let half = HalfSpace::at_least([1.0, 0.0], 0.0)?;
    all([1.0, 10.0, 100.0, 1000.0].map(|t: f64| {
        let to = SVector::from([t, 0.0]);
        let farther = SVector::from([10.0 * t + 10.0, 0.0]);
        let distance = |y| Sphere.distance(&from, y).expect("known");
        let (apart, sampled) = (distance(&to), distance(&farther));
        close("d(x, y)", apart, nearest + 2.0 * 1_f64.atan2(t), 1e-14)?;
        if !(sampled < apart) {
            return Err(Failure::new(format!("t = {t}: {sampled} is not nearer than {apart}")));
        }
        let sets: [&dyn ClosedSet<2>; 2] = [&first, &half];
        let granted = (WayOut::from(&Sphere, &from), 1e-14);
        let lengths = [apart, nearest];
        let pair = NearestPair::between(&LIBRARY, &Sphere, sets, [from, to], lengths, granted);
        let pair = pair?.beside(sampled);
        let c1 = 4.0 / (1.0 + t.max(3.0).powi(2)).powi(2);
        fails_without(&["no way out"], prop_6_2(&pair, c1))
    }))
}

/// The half-plane `{x₁ > 1}` is not closed. Points outside it have no nearest point in it, and
/// `project` returns another point of it.
#[derive(Debug)]
struct OpenHalfPlane;

impl ClosedSet<2> for OpenHalfPlane {
    fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        if x[0] > 1.0 { *x } else { SVector::from([2.0, x[1]]) }
    }

    fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::identity()
    }

    fn radius(&self) -> Option<f64> {
        None
    }
}

/// No pair of the origin and a point of the open half-plane `{x₁ > 1}` has distance 1. A pair whose
/// first point is not in its set may be arbitrarily far apart.
fn open_or_outside(_: &Trial<'_>) -> Outcome {
    let origin = Point::new([0.0, 0.0])?;
    let closed = HalfSpace::at_least([1.0, 0.0], 1.0)?;
    for more in [1.0, 0.1, 1e-3, 1e-6] {
        let open = pair([&origin, &OpenHalfPlane], [[0.0, 0.0], [1.0 + more, 0.0]], 1.0)?;
        fails_without(&["the sets are closed"], prop_6_2(&open, 1.0))?;
    }
    let elsewhere = pair([&origin, &closed], [[0.0, 2.0], [1.0, 0.0]], 1.0)?;
    fails_without(&["x ∈ X⁽⁰⁾"], prop_6_2(&elsewhere, 1.0))
}

/// From a ball to a half-plane, a straight line that starts outside the ball is shorter.
fn outside(_: &Trial<'_>) -> Outcome {
    let metric = Constant::new(SMatrix::identity())?;
    let ends = Ends::new(Ball::new([0.0, 0.0], 1.0)?, HalfSpace::at_least([1.0, 0.0], 3.0)?)?;
    let known = Known { metric, ends, distance: 2.0, distance_error: 0.0 };
    let line = PointSequence::straight([1.5, 0.0], [3.0, 0.0], 2)?;
    let seen = Measured::of_sequence(&LIBRARY, &known.metric, &line);
    fails_without(&[ENDS], prop_6_3(&LIBRARY, &known, &seen))
}

/// The problem leads from 0 to 1 on the line with `H = 1`, and `γ = t`.
///
/// `γ* = t²/2` stops half-way and has `E(γ*) = 1/3`, so that `1 − 1/4 ≤ 1 − 1/3` is false. A curve
/// that turns back at `¾` and again at `¼` has `L(γ*) = 2` and `E(γ*) = 33/8`, so that
/// `1 − 4 ≤ 1 − 33/8` is false. For curves that join the sets, `E(γ*) ≤ d²` implies `L(γ*) ≤ d`, so
/// both clauses fail.
fn other_minimisers(_: &Trial<'_>) -> Outcome {
    let (known, on_time, _) = late()?;
    let half = SmoothCurve::polynomial([0.0, 0.0, 0.5].map(|x| SVector::from([x])));
    let line = SmoothCurve::straight([0.0], [1.0]);
    let clock = Clock::turning_back();
    let back = Reparametrised { curve: &line, clock: &clock };
    let [half, back] = [Measured::of(&known.metric, &half), Measured::of(&known.metric, &back)];
    all([
        fails_without(&["γ* joins"], prop_9_1(&LIBRARY, &known, &on_time, &half)),
        fails_without(&["L(γ*) ≤ d", "E(γ*) ≤ d²"], prop_9_1(&LIBRARY, &known, &on_time, &back)),
    ])
}

/// If `γ*` is a minimiser, the proposition states `L(γ)² ≤ E(γ)`, which does not depend on the
/// ends.
fn joins_nothing(_: &Trial<'_>) -> Outcome {
    let (known, minimiser, _) = late()?;
    let uneven = SmoothCurve::polynomial([3.0, 0.0, 0.5].map(|x| SVector::from([x])));
    let seen = Measured::of(&known.metric, &uneven);
    holds_without(&["γ joins"], prop_9_1(&LIBRARY, &known, &seen, &minimiser))
}
