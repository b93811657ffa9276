//! Propositions 4.1 and 4.2: minimal curves are minimal geodesics reparametrised by a clock.

use std::f64::consts::TAU;

use nalgebra::SVector;
use tautline::gallery::{Shear, Sphere};
use tautline_statements::{
    Evidence, Known, LIBRARY,
    Statement::{self, Proposition4_1, Proposition4_2},
    Subject, VerifyError,
    curves::{
        Clock, Curve, EvenSegment, Geodesic, KnownGeodesics, Pace, Reparametrised, SmoothCurve,
    },
    prop_4_1, prop_4_2, prop_4_2_converse, prop_4_2_read_strictly,
};

use super::ends;
use crate::battery::{
    cases::sheared,
    harness::{
        Check, Dropped, Homogeneous, Outcome, Random, Refuted, Trial, Witness, all, close,
        fails_without, for_all, holds_without, refuted,
    },
};
use crate::strategies::{
    bump, clock, constant, hill, in_hyperbolic_space, joined, lens, on_sphere, points, ramp, ray,
    separable, shear, valleys_along, vector,
};

const BOTH: &[Statement] = &[Proposition4_1, Proposition4_2];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("props_4_1_and_4_2_hold_for_every_clock", BOTH, clocks),
    Random.check(
        "prop_4_2_holds_for_segments_that_are_minimal",
        &[Proposition4_2],
        minimal_segments,
    ),
    Random.check("props_4_1_and_4_2_hold_for_a_point", BOTH, points_alone),
    Homogeneous.check("props_4_1_and_4_2_are_homogeneous", BOTH, |trial| {
        let cases = (joined(shear()), clock());
        trial.homogeneous(4120, 96, cases, |subject, ((metric, ends), clock), units| {
            both(subject, &units.metric(metric), ends.map(|x| units.vector(x)), &clock)
        })
    }),
    Witness.check("props_4_1_and_4_2_are_attained_by_a_curve_that_pauses", BOTH, |trial| {
        trial.for_all(4130, 96, joined(shear()), |subject, (metric, ends)| {
            let [local, global] = both(subject, &metric, ends, &Clock::pausing())?;
            Ok([local.attained()?, global.attained()?])
        })
    }),
    Refuted.check(
        "props_4_1_and_4_2_read_strictly_are_refuted_by_a_pause",
        BOTH,
        refuted_by_a_pause,
    ),
    Dropped.check("props_4_1_and_4_2_fail_for_a_clock_that_turns_back", BOTH, dropped_monotone),
    Dropped.check("props_4_1_and_4_2_fail_for_the_long_way_round", BOTH, dropped_minimal),
    Dropped.check("prop_4_2_says_nothing_of_a_detour", &[Proposition4_2], detour),
    Dropped.check("props_4_1_and_4_2_fail_for_a_curve_that_stops_short", BOTH, dropped_ends),
    Dropped.check("props_4_1_and_4_2_fail_for_an_uneven_curve", BOTH, dropped_equation),
    Dropped.check("prop_4_1_holds_for_points_that_are_not_near", &[Proposition4_1], far_apart),
];

/// Evaluates both propositions for the known geodesic between two points.
fn both<M: KnownGeodesics<D>, const D: usize>(
    subject: &Subject,
    metric: &M,
    ends: [SVector<f64, D>; 2],
    clock: &Clock,
) -> Result<[Evidence; 2], VerifyError> {
    let known = Known::joined(metric, ends)?.expect("known");
    let geodesic = Geodesic::between(metric, ends);
    let radius = metric.normal_radius(&ends[0]);
    Ok([
        prop_4_1(subject, &known, &geodesic, clock, radius)?,
        prop_4_2(subject, &known, &geodesic, clock)?,
    ])
}

fn clocks(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        160,
        [
            (4101, (joined(constant::<3>()), clock())),
            (4102, (joined(shear()), clock())),
            (4103, (joined(separable::<1>()), clock())),
            (4104, (joined(separable::<2>()), clock())),
            (4105, (on_sphere::<2>(), clock())),
            (4106, (on_sphere::<3>(), clock())),
            (4107, (in_hyperbolic_space::<2>(), clock())),
        ],
        |subject, ((metric, ends), clock)| {
            // On the sphere not all pairs of points are near; the second evidence covers all of
            // them.
            let [local, global] = both(subject, &metric, ends, &clock)?;
            let near = local.hypotheses[0].holds();
            Ok([global].into_iter().chain(near.then_some(local)))
        }
    )
}

/// Segments on rays of radial metrics, along the valleys and on the line are shortest curves, and
/// their parametrisation does not depend on the metric.
fn minimal_segments(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        64,
        [
            (4201, ray::<_, 2>(bump())),
            (4202, ray::<_, 3>(lens())),
            (4203, ray::<_, 2>(hill())),
            (4204, valleys_along()),
            (4205, points(ramp())),
        ],
        |subject, known| {
            let [a, b] = ends(&known);
            let geodesic = EvenSegment::new(&known.metric, [a, b]);
            Ok([prop_4_2_converse(subject, &known, &SmoothCurve::straight(a, b), &geodesic)])
        }
    )
}

/// The clock has `φ = ½` from `⅓` to `⅔`, so that the curve is minimal, but at rest for a third of
/// the time.
fn refuted_by_a_pause(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let evidence = prop_4_2_read_strictly(&known, &geodesic, &Clock::pausing());
    refuted(&evidence, "γ never pauses", [1.0 / 3.0, 0.0])
}

/// From a point to itself the curve is constant, and any clock is admissible.
fn points_alone(trial: &Trial<'_>) -> Outcome {
    trial.for_all(4140, 64, (shear(), vector(2.5), clock()), |subject, (metric, a, clock)| {
        let known = Known::joined(&metric, [a, a])?.expect("known");
        let still = Geodesic::between(&metric, [a, a]);
        let [local, global] = both(subject, &metric, [a, a], &clock)?;
        Ok([local, global, prop_4_2_converse(subject, &known, &still, &still)])
    })
}

/// The clock runs to `¾`, back to `¼` and on to 1, so that the length is `d ∫|φ′| = 2d`.
fn dropped_monotone(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let clock = Clock::turning_back();
    let length = prop_4_2(&LIBRARY, &known, &geodesic, &clock)?;
    let ratio = length.conclusion("L(γ** ∘ φ) ≤ d").observed / known.distance;
    close("L(γ** ∘ φ)/d", ratio, 2.0, 1e-13)?;
    both_fail_without("∫|φ′| ≤ 1", &known, &geodesic, &clock)
}

/// The geodesic runs along the equator from angle 0 to angle 1 the long way round, and its length
/// is `2π − 1`.
fn dropped_minimal(_: &Trial<'_>) -> Outcome {
    let angle = 1.0_f64;
    let ends = [[1.0, 0.0].into(), [angle.cos(), angle.sin()].into()];
    let known = Known::joined(Sphere, ends)?.expect("known");
    let way_round = SVector::from([0.0, angle - TAU]);
    let geodesic = Geodesic::leaving(Sphere, ends[0], way_round);
    both_fail_without("L(γ**) ≤ d", &known, &geodesic, &Clock::plain(Pace::Even))
}

/// Under a shear the straight segment is longer than the geodesic, and a different curve.
fn detour(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let [a, b] = ends(&known);
    let segment = SmoothCurve::straight(a, b);
    fails_without(&["L(γ) ≤ d"], prop_4_2_converse(&LIBRARY, &known, &segment, &geodesic))
}

/// Both propositions must fail for a curve `γ**` between the ends of a problem if this clause is
/// dropped.
fn both_fail_without<M: KnownGeodesics<2>>(
    clause: &str,
    known: &Known<M, 2>,
    curve: &impl Curve<2>,
    clock: &Clock,
) -> Outcome {
    let radius = known.metric.normal_radius(&ends(known)[0]);
    all([
        fails_without(&[clause], prop_4_1(&LIBRARY, known, curve, clock, radius)?),
        fails_without(&[clause], prop_4_2(&LIBRARY, known, curve, clock)?),
    ])
}

/// One geodesic stops after nine tenths of the way, so that its length up to `t` is `0.9 d φ(t)`.
/// The other curve is a segment that does not join the ends and is no reparametrised geodesic.
fn dropped_ends(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let velocity = geodesic.motion(0.0).velocity;
    let short: Geodesic<Shear, 2> =
        Geodesic::leaving(known.metric, ends(&known)[0], velocity * 0.9);
    let elsewhere = SmoothCurve::straight([0.0, 0.0], [0.0, 1.0]);
    all([
        both_fail_without("γ** joins", &known, &short, &Clock::plain(Pace::Smooth)),
        fails_without(&["γ joins"], prop_4_2_converse(&LIBRARY, &known, &elsewhere, &geodesic)),
    ])
}

/// `γ**` is replaced by a minimal curve of uneven speed, which covers a quarter of its length in
/// half of its time.
fn dropped_equation(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let late = Clock::plain(Pace::Accelerating);
    let uneven = Reparametrised { curve: &geodesic, clock: &late };
    let halves = Clock::new(&[1.0, 1.0], &[0.5], Pace::Even).expect("in order");
    both_fail_without("γ̈** = −Γ", &known, &uneven, &halves)
}

/// The second point need not lie in a normal neighbourhood of the first, since Proposition 4.2 does
/// not assume this.
fn far_apart(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let local = prop_4_1(&LIBRARY, &known, &geodesic, &Clock::pausing(), 0.5 * known.distance);
    holds_without(&["d < ε"], local?)
}
