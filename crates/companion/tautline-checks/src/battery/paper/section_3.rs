//! Section 3: geodesics have constant speed, and distances lie between Euclidean ones.

use std::f64::consts::TAU;

use nalgebra::{SMatrix, SVector};
use tautline::{
    Constants,
    gallery::{Constant, Hyperbolic, Sphere, Valleys},
};
use tautline_statements::{
    Evidence, Known, LIBRARY,
    Statement::{self, Proposition3_1, Proposition3_2, Proposition3_3},
    Subject, VerifyError, WayOut,
    curves::{Clock, Curve, Geodesic, KnownGeodesics, Motion, Pace, Reparametrised},
    prop_3_1, prop_3_2, prop_3_3,
};

use crate::battery::{
    cases::{claiming, round_the_missing_point, sheared},
    harness::{
        Check, Dropped, Failure, Homogeneous, Outcome, Random, Trial, Witness, close,
        fails_without, for_all,
    },
};
use crate::strategies::{
    constant, in_hyperbolic_space, joined, on_sphere, points, ramp, separable, shear,
    valleys_across, valleys_along, vector,
};

const P31: &[Statement] = &[Proposition3_1];
const P32: &[Statement] = &[Proposition3_2];
const P33: &[Statement] = &[Proposition3_3];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("prop_3_1_holds_for_geodesics", P31, speeds),
    Homogeneous.check("prop_3_1_is_homogeneous", P31, |trial| {
        trial.homogeneous(3120, 128, joined(shear()), |subject, (metric, ends), units| {
            let metric = units.metric(metric);
            let curve = Geodesic::between(&metric, ends.map(|x| units.vector(x)));
            Ok([prop_3_1(subject, &metric, &curve)?])
        })
    }),
    Witness.check("prop_3_1_is_attained_by_every_geodesic_minimal_or_not", P31, long_great_circles),
    Dropped.check("prop_3_1_fails_for_curves_that_are_not_geodesics", P31, dropped_equation),
    Random.check("prop_3_2_holds_in_complete_spaces", P32, joins),
    Homogeneous.check("prop_3_2_is_homogeneous", P32, |trial| {
        trial.homogeneous(3220, 128, joined(shear()), |subject, (metric, ends), units| {
            let metric = units.metric(metric);
            let ends = ends.map(|x| units.vector(x));
            let known = Known::joined(&metric, ends)?.expect("known");
            let curve = Geodesic::between(&metric, ends);
            let way_out = WayOut::from(&metric, &ends[0]);
            Ok([prop_3_2(subject, &known, &curve, way_out)?])
        })
    }),
    Witness.check("prop_3_2_is_attained_by_the_known_geodesics", P32, |trial| {
        trial.for_all(3230, 128, joined(separable::<2>()), |subject, (metric, ends)| {
            Ok([shown(subject, &metric, ends)?.attained()?])
        })
    }),
    Dropped.check("prop_3_2_fails_on_the_sphere_without_a_point", P32, dropped_completeness),
    Random.check("prop_3_3_holds_between_points", P33, squeezed),
    Homogeneous.check("prop_3_3_is_homogeneous", P33, |trial| {
        trial.homogeneous(3320, 128, points(shear()), |subject, known, units| {
            Ok([prop_3_3(subject, &units.known(known)?)?])
        })
    }),
    Witness.check("prop_3_3_is_attained_by_constant_metrics", P33, attained_by_constant_metrics),
    Dropped.check("prop_3_3_fails_without_its_constants", P33, dropped_constants),
];

fn speeds(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        160,
        [
            (3101, joined(constant::<3>())),
            (3102, joined(shear())),
            (3103, joined(separable::<1>())),
            (3104, joined(separable::<3>())),
            (3105, on_sphere::<2>()),
            (3106, on_sphere::<3>()),
            (3107, in_hyperbolic_space::<2>()),
            (3108, in_hyperbolic_space::<3>()),
        ],
        |subject, (metric, ends)| {
            let curve = Geodesic::between(&metric, ends);
            Ok([prop_3_1(subject, &metric, &curve)?])
        }
    )
}

/// The curves are great circles with lengths up to `2π`. They are inclined to the equator `|x| = 1`
/// by less than `45°`, which keeps them away from the missing point.
fn long_great_circles(trial: &Trial<'_>) -> Outcome {
    let circles = (0.0..TAU, 0.5..TAU, -0.7..0.7);
    trial.for_all(3130, 256, circles, |subject, (from, length, tilt): (f64, f64, f64)| {
        let start = SVector::from([from.cos(), from.sin()]);
        let along = SVector::from([-from.sin(), from.cos()]);
        // H = I on the equator.
        let curve = Geodesic::leaving(Sphere, start, (along + start * tilt) * length);
        Ok([prop_3_1(subject, &Sphere, &curve)?.attained()?])
    })
}

/// One curve is a straight line over the valleys along `x₁`. It has the same image as a geodesic,
/// but its speed `2π (2 − cos 2πt)` varies from `2π` to `6π`. The other curve is a geodesic that
/// accelerates.
fn dropped_equation(_: &Trial<'_>) -> Outcome {
    struct Line;
    impl Curve<2> for Line {
        fn motion(&self, t: f64) -> Motion<2> {
            let velocity = SVector::from([TAU, 0.0]);
            Motion { position: velocity * t, velocity, acceleration: SVector::zeros() }
        }
    }
    let (known, geodesic) = sheared();
    let clock = Clock::plain(Pace::Accelerating);
    let late = Reparametrised { curve: &geodesic, clock: &clock };
    fails_without(&["γ̈ = −Γ"], prop_3_1(&LIBRARY, &Valleys, &Line)?)?;
    fails_without(&["γ̈ = −Γ"], prop_3_1(&LIBRARY, &known.metric, &late)?)
}

/// Evaluates Proposition 3.2 for the known geodesic between two points of a complete space.
fn shown<M: KnownGeodesics<D>, const D: usize>(
    subject: &Subject,
    metric: &M,
    ends: [SVector<f64, D>; 2],
) -> Result<Evidence, VerifyError> {
    let known = Known::joined(metric, ends)?.expect("known");
    let way_out = WayOut::from(metric, &ends[0]);
    Ok(prop_3_2(subject, &known, &Geodesic::between(metric, ends), way_out)?)
}

fn joins(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        224,
        [
            (3201, joined(constant::<4>())),
            (3202, joined(shear())),
            (3203, joined(separable::<2>())),
            (3204, in_hyperbolic_space::<2>()),
            (3205, in_hyperbolic_space::<3>()),
        ],
        |subject, (metric, ends)| Ok([shown(subject, &metric, ends)?])
    )
}

fn dropped_completeness(_: &Trial<'_>) -> Outcome {
    let mut longer = f64::INFINITY;
    for r in [10.0, 100.0, 1000.0] {
        let (known, arcs, way_out) = round_the_missing_point(r)?;
        close("d", known.distance, 4.0 * 0.5_f64.atan(), 1e-15)?;
        let evidence = prop_3_2(&LIBRARY, &known, &arcs, way_out)?;
        let excess = evidence.conclusion("L(γ) ≤ d").observed - known.distance;
        // On the sphere of radius 1, the curve forms a triangle of small height 2/r over the
        // missing point.
        if !(excess > 0.0 && excess * 90.0 < longer) {
            return Err(Failure::new(format!("r = {r}: {excess:e} more than d, after {longer:e}")));
        }
        longer = excess;
        fails_without(&["no way out"], evidence)?;
    }
    Ok(Default::default())
}

fn squeezed(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        224,
        [
            (3301, points(shear())),
            (3302, points(ramp())),
            (3303, points(separable::<3>())),
            (3304, points(constant::<3>())),
            (3305, valleys_along()),
            (3306, valleys_across::<2>()),
            (3307, valleys_across::<3>()),
        ],
        |subject, known| Ok([prop_3_3(subject, &known)?])
    )
}

/// For `H = diag(λ, μ)` with `λ ≤ μ`, `d² = c₁ |x − y|²` along the first axis and
/// `d² = c₂ |x − y|²` along the second.
fn attained_by_constant_metrics(trial: &Trial<'_>) -> Outcome {
    let cases = (0.1..1.0, 1.0..10.0, vector::<2>(3.0), 0.1..3.0, 0..2_usize);
    trial.for_all(3310, 256, cases, |subject, (low, high, x, step, axis): (_, _, _, f64, _)| {
        let matrix = SMatrix::from_diagonal(&SVector::from([low, high]));
        let metric = Constant::new(matrix).expect("positive definite");
        let mut y = x;
        y[axis] += step;
        let known = Known::between(metric, x, y)?.expect("known");
        let evidence = prop_3_3(subject, &known)?;
        let claim = ["c₁|x − y|² ≤ d²", "d² ≤ c₂|x − y|²"][axis];
        Ok([evidence.claim_is_attained(claim, 1.01)?])
    })
}

/// Hyperbolic space has `H ≥ 4` and no `c₂`: the distance from 0 to `(0.99, 0)` is
/// `2 artanh 0.99 = 5.29`, which is more than `√5 · 0.99`. The sphere has `H ≤ 4` and no `c₁`: the
/// distance from 0 to `(10, 0)` is `2 arctan 10 = 2.94`, which is less than `√½ · 10`.
fn dropped_constants(_: &Trial<'_>) -> Outcome {
    fn case<M: KnownGeodesics<2>>(
        metric: M,
        constants: [f64; 2],
        end: f64,
    ) -> Result<Evidence, VerifyError> {
        let known = Known::joined(metric, [[0.0, 0.0].into(), [end, 0.0].into()])?.expect("known");
        let constants = Constants::new(constants[0], constants[1], 1e6)?;
        Ok(prop_3_3(&LIBRARY, &claiming(known, constants))?)
    }
    fails_without(&["c₂"], case(Hyperbolic, [4.0, 5.0], 0.99)?)?;
    fails_without(&["c₁"], case(Sphere, [0.5, 4.0], 10.0)?)
}
