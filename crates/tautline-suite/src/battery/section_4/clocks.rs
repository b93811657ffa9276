//! Propositions 4.1 and 4.2: minimal curves are minimal geodesics run through by a clock.

use std::fmt::Debug;

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{
    Metric,
    gallery::{Shear, Sphere},
};
use tautline_statements::{
    Evidence, Known, LIBRARY, Statement,
    Statement::{Proposition4_1, Proposition4_2},
    Subject, VerifyError,
    curves::{Clock, Curve, EvenSegment, Geodesic, KnownGeodesics, Pace, Reparametrised},
    prop_4_1, prop_4_2, prop_4_2_converse, prop_4_2_read_strictly,
};

use super::{
    super::{
        Check, Failure, Kind, Outcome, Trial,
        check::all,
        failing::{fails_without, holds_without, refuted},
        sheared::sheared,
    },
    Segment, ends,
};
use crate::strategies::{
    bump, clock, constant, hill, in_hyperbolic_space, joined, lens, on_sphere, points, ramp, ray,
    separable, shear, valleys_along, vector,
};

const BOTH: &[Statement] = &[Proposition4_1, Proposition4_2];

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new("props_4_1_and_4_2_hold_for_every_clock", Kind::Random, BOTH, clocks),
        Check::new(
            "prop_4_2_holds_for_segments_that_are_minimal",
            Kind::Random,
            &[Proposition4_2],
            minimal_segments,
        ),
        Check::new("props_4_1_and_4_2_hold_for_a_point", Kind::Random, BOTH, points_alone),
        Check::new("props_4_1_and_4_2_are_homogeneous", Kind::Homogeneous, BOTH, |trial| {
            let cases = (joined(shear()), clock());
            trial.homogeneous(4120, 96, cases, |subject, ((metric, ends), clock), units| {
                both(subject, &units.metric(metric), ends.map(|x| units.vector(x)), &clock)
            })
        }),
        Check::new(
            "props_4_1_and_4_2_are_attained_by_a_curve_that_pauses",
            Kind::Witness,
            BOTH,
            |trial| {
                trial.for_all(4130, 96, joined(shear()), |subject, (metric, ends)| {
                    let [local, global] = both(subject, &metric, ends, &Clock::pausing())?;
                    Ok([local.attained()?, global.attained()?])
                })
            },
        ),
        Check::new(
            "props_4_1_and_4_2_read_strictly_are_refuted_by_a_pause",
            Kind::Refuted,
            BOTH,
            |_| refuted_by_a_pause(),
        ),
        Check::new(
            "props_4_1_and_4_2_fail_for_a_clock_that_turns_back",
            Kind::Dropped,
            BOTH,
            |_| dropped_monotone(),
        ),
        Check::new("props_4_1_and_4_2_fail_for_the_long_way_round", Kind::Dropped, BOTH, |_| {
            dropped_minimal()
        }),
        Check::new("prop_4_2_says_nothing_of_a_detour", Kind::Dropped, &[Proposition4_2], |_| {
            detour()
        }),
        Check::new(
            "props_4_1_and_4_2_fail_for_a_curve_that_stops_short",
            Kind::Dropped,
            BOTH,
            |_| dropped_ends(),
        ),
        Check::new("props_4_1_and_4_2_fail_for_an_uneven_curve", Kind::Dropped, BOTH, |_| {
            dropped_equation()
        }),
        Check::new(
            "prop_4_1_holds_for_points_that_are_not_near",
            Kind::Dropped,
            &[Proposition4_1],
            |_| far_apart(),
        ),
    ]
}

/// Both propositions for the known geodesic between two points.
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
    fn family<M, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        family: impl Strategy<Value = (M, [SVector<f64, D>; 2])>,
    ) -> Outcome
    where
        M: KnownGeodesics<D> + Debug + 'static,
    {
        trial.for_all(seed, 160, (family, clock()), |subject, ((metric, ends), clock)| {
            // On the sphere not all pairs are near: the second evidence is for all of them.
            let [local, global] = both(subject, &metric, ends, &clock)?;
            let near = local.hypotheses[0].holds();
            Ok([global].into_iter().chain(near.then_some(local)))
        })
    }
    all([
        family(trial, 4101, joined(constant::<3>())),
        family(trial, 4102, joined(shear())),
        family(trial, 4103, joined(separable::<1>())),
        family(trial, 4104, joined(separable::<2>())),
        family(trial, 4105, on_sphere::<2>()),
        family(trial, 4106, on_sphere::<3>()),
        family(trial, 4107, in_hyperbolic_space::<2>()),
    ])
}

/// Segments on rays of radial metrics, along the valleys and on the line are shortest curves; their
/// clocks have nothing to do with the metric.
fn minimal_segments(trial: &Trial<'_>) -> Outcome {
    fn family<M: Metric<D> + Debug + 'static, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        family: impl Strategy<Value = Known<M, D>>,
    ) -> Outcome {
        trial.for_all(seed, 64, family, |subject, known| {
            let ends = ends(&known);
            let geodesic = EvenSegment::new(&known.metric, ends);
            Ok([prop_4_2_converse(subject, &known, &Segment(ends), &geodesic)])
        })
    }
    all([
        family(trial, 4201, ray::<_, 2>(bump())),
        family(trial, 4202, ray::<_, 3>(lens())),
        family(trial, 4203, ray::<_, 2>(hill())),
        family(trial, 4204, valleys_along()),
        family(trial, 4205, points(ramp())),
    ])
}

/// `φ = ½` from `⅓` to `⅔`: a minimal curve, at rest for a third of the time.
fn refuted_by_a_pause() -> Outcome {
    let (known, geodesic) = sheared();
    let evidence = prop_4_2_read_strictly(&known, &geodesic, &Clock::pausing());
    refuted(&evidence, "γ never pauses", [1.0 / 3.0, 0.0])
}

/// From a point to itself: a constant curve, and any clock.
fn points_alone(trial: &Trial<'_>) -> Outcome {
    trial.for_all(4140, 64, (shear(), vector(2.5), clock()), |subject, (metric, a, clock)| {
        let known = Known::joined(&metric, [a, a])?.expect("known");
        let still = Geodesic::between(&metric, [a, a]);
        let [local, global] = both(subject, &metric, [a, a], &clock)?;
        Ok([local, global, prop_4_2_converse(subject, &known, &still, &still)])
    })
}

/// To `¾`, back to `¼` and on: the length is `d ∫|φ′| = 2d`.
fn dropped_monotone() -> Outcome {
    let (known, geodesic) = sheared();
    let clock = Clock::turning_back();
    let length = prop_4_2(&LIBRARY, &known, &geodesic, &clock).map_err(VerifyError::from)?;
    let ratio = length.conclusion("L(γ** ∘ φ) ≤ d").observed / known.distance;
    if !((ratio - 2.0).abs() <= 1e-13) {
        return Err(Failure::new(format!("{ratio} times d")));
    }
    let radius = known.metric.normal_radius(&ends(&known)[0]);
    let local = prop_4_1(&LIBRARY, &known, &geodesic, &clock, radius);
    all([
        fails_without(&["∫|φ′| ≤ 1"], length),
        fails_without(&["∫|φ′| ≤ 1"], local.map_err(VerifyError::from)?),
    ])
}

/// Along the equator from angle 0 to angle 1, but the other way round: a geodesic, `2π − 1` long.
fn dropped_minimal() -> Outcome {
    let angle = 1.0_f64;
    let ends = [[1.0, 0.0].into(), [angle.cos(), angle.sin()].into()];
    let known = Known::joined(Sphere, ends).map_err(VerifyError::from)?.expect("known");
    let way_round = SVector::from([0.0, angle - std::f64::consts::TAU]);
    let geodesic = Geodesic::leaving(Sphere, ends[0], way_round);
    let clock = Clock::plain(Pace::Even);
    let radius = Sphere.normal_radius(&ends[0]);
    let local = prop_4_1(&LIBRARY, &known, &geodesic, &clock, radius);
    let global = prop_4_2(&LIBRARY, &known, &geodesic, &clock);
    all([
        fails_without(&["L(γ**) ≤ d"], local.map_err(VerifyError::from)?),
        fails_without(&["L(γ**) ≤ d"], global.map_err(VerifyError::from)?),
    ])
}

/// The straight segment under a shear is longer than the geodesic, and elsewhere.
fn detour() -> Outcome {
    let (known, geodesic) = sheared();
    let segment = Segment(ends(&known));
    fails_without(&["L(γ) ≤ d"], prop_4_2_converse(&LIBRARY, &known, &segment, &geodesic))
}

/// Both propositions for a curve `γ**` between the ends of [`sheared`], without a clause.
fn without_a_clause(clause: &str, curve: &impl Curve<2>, clock: &Clock) -> Outcome {
    let (known, _) = sheared();
    let radius = known.metric.normal_radius(&ends(&known)[0]);
    let local = prop_4_1(&LIBRARY, &known, curve, clock, radius);
    let global = prop_4_2(&LIBRARY, &known, curve, clock);
    all([
        fails_without(&[clause], local.map_err(VerifyError::from)?),
        fails_without(&[clause], global.map_err(VerifyError::from)?),
    ])
}

/// The geodesic that has gone nine tenths of the way: its length up to `t` is `0.9 d φ(t)`. And
/// what a curve that stops there is not, the reparametrised geodesic.
fn dropped_ends() -> Outcome {
    let (known, geodesic) = sheared();
    let velocity = geodesic.motion(0.0).velocity;
    let short: Geodesic<Shear, 2> =
        Geodesic::leaving(known.metric, ends(&known)[0], velocity * 0.9);
    let elsewhere = Segment([[0.0, 0.0].into(), [0.0, 1.0].into()]);
    all([
        without_a_clause("γ** joins", &short, &Clock::plain(Pace::Smooth)),
        fails_without(&["γ joins"], prop_4_2_converse(&LIBRARY, &known, &elsewhere, &geodesic)),
    ])
}

/// A minimal curve of uneven speed in place of `γ**`: half of its time is a quarter of its length.
fn dropped_equation() -> Outcome {
    let (_, geodesic) = sheared();
    let late = Clock::plain(Pace::Accelerating);
    let uneven = Reparametrised { curve: &geodesic, clock: &late };
    let halves = Clock::new(&[1.0, 1.0], &[0.5], Pace::Even).expect("in order");
    without_a_clause("γ̈** = −Γ", &uneven, &halves)
}

/// That the second point lies in a normal neighbourhood of the first is not needed: Proposition 4.2
/// is without it.
fn far_apart() -> Outcome {
    let (known, geodesic) = sheared();
    let local = prop_4_1(&LIBRARY, &known, &geodesic, &Clock::pausing(), 0.5 * known.distance);
    holds_without(&["d < ε"], local.map_err(VerifyError::from)?)
}
