//! Section 3: geodesics have constant speed, and distances lie between Euclidean ones.

use std::{f64::consts::TAU, fmt::Debug};

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use tautline::{
    Bounded, Constants,
    gallery::{Constant, Hyperbolic, Shear, Sphere, Valleys},
};
use tautline_statements::{
    Evidence, Known, LIBRARY,
    Statement::{Proposition3_1, Proposition3_2, Proposition3_3},
    Subject, VerifyError, WayOut, WithConstants,
    curves::{Clock, Curve, Geodesic, KnownGeodesics, Motion, Pace, Reparametrised},
    prop_3_1, prop_3_2, prop_3_3,
};

use super::{
    Check, Failure, Kind, Outcome, Trial, check::all, close::close, failing::fails_without,
};
use crate::strategies::{
    constant, in_hyperbolic_space, joined, on_sphere, points, ramp, separable, shear,
    valleys_across, valleys_along, vector,
};

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new("prop_3_1_holds_for_geodesics", Kind::Random, &[Proposition3_1], speeds),
        Check::new("prop_3_1_is_homogeneous", Kind::Homogeneous, &[Proposition3_1], |trial| {
            trial.homogeneous(3120, 128, joined(shear()), |subject, (metric, ends), units| {
                let metric = units.metric(metric);
                let curve = Geodesic::between(&metric, ends.map(|x| units.vector(x)));
                Ok([prop_3_1(subject, &metric, &curve)?])
            })
        }),
        Check::new(
            "prop_3_1_is_attained_by_every_geodesic_minimal_or_not",
            Kind::Witness,
            &[Proposition3_1],
            long_great_circles,
        ),
        Check::new(
            "prop_3_1_fails_for_curves_that_are_not_geodesics",
            Kind::Dropped,
            &[Proposition3_1],
            |_| dropped_equation(),
        ),
        Check::new("prop_3_2_holds_in_complete_spaces", Kind::Random, &[Proposition3_2], joins),
        Check::new("prop_3_2_is_homogeneous", Kind::Homogeneous, &[Proposition3_2], |trial| {
            trial.homogeneous(3220, 128, joined(shear()), |subject, (metric, ends), units| {
                let metric = units.metric(metric);
                let ends = ends.map(|x| units.vector(x));
                let known = Known::joined(&metric, ends)?.expect("known");
                let curve = Geodesic::between(&metric, ends);
                let way_out = WayOut::from(&metric, &ends[0]);
                Ok([prop_3_2(subject, &known, &curve, way_out)?])
            })
        }),
        Check::new(
            "prop_3_2_is_attained_by_the_known_geodesics",
            Kind::Witness,
            &[Proposition3_2],
            |trial| {
                trial.for_all(3230, 128, joined(separable::<2>()), |subject, (metric, ends)| {
                    Ok([shown(subject, &metric, ends)?.attained()?])
                })
            },
        ),
        Check::new(
            "prop_3_2_fails_on_the_sphere_without_a_point",
            Kind::Dropped,
            &[Proposition3_2],
            |_| dropped_completeness(),
        ),
        Check::new("prop_3_3_holds_between_points", Kind::Random, &[Proposition3_3], squeezed),
        Check::new("prop_3_3_is_homogeneous", Kind::Homogeneous, &[Proposition3_3], |trial| {
            trial.homogeneous(3320, 128, points(shear()), |subject, known, units| {
                Ok([prop_3_3(subject, &units.known(known)?)?])
            })
        }),
        Check::new(
            "prop_3_3_is_attained_by_constant_metrics",
            Kind::Witness,
            &[Proposition3_3],
            attained_by_constant_metrics,
        ),
        Check::new(
            "prop_3_3_fails_without_its_constants",
            Kind::Dropped,
            &[Proposition3_3],
            |_| dropped_constants(),
        ),
    ]
}

fn speeds(trial: &Trial<'_>) -> Outcome {
    fn family<M, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        family: impl Strategy<Value = (M, [SVector<f64, D>; 2])>,
    ) -> Outcome
    where
        M: KnownGeodesics<D> + Debug + 'static,
    {
        trial.for_all(seed, 160, family, |subject, (metric, ends)| {
            Ok([prop_3_1(subject, &metric, &Geodesic::between(&metric, ends))?])
        })
    }
    all([
        family(trial, 3101, joined(constant::<3>())),
        family(trial, 3102, joined(shear())),
        family(trial, 3103, joined(separable::<1>())),
        family(trial, 3104, joined(separable::<3>())),
        family(trial, 3105, on_sphere::<2>()),
        family(trial, 3106, on_sphere::<3>()),
        family(trial, 3107, in_hyperbolic_space::<2>()),
        family(trial, 3108, in_hyperbolic_space::<3>()),
    ])
}

/// Great circles of lengths up to `2π`, tilted by less than `45°` against the equator `|x| = 1`, so
/// that they keep their distance from the missing point.
fn long_great_circles(trial: &Trial<'_>) -> Outcome {
    let circles = (0.0..TAU, 0.5..TAU, -0.7..0.7);
    trial.for_all(3130, 256, circles, |subject, (from, length, tilt): (f64, f64, f64)| {
        let start = SVector::from([from.cos(), from.sin()]);
        let along = SVector::from([-from.sin(), from.cos()]);
        // On the equator H = I.
        let curve = Geodesic::leaving(Sphere, start, (along + start * tilt) * length);
        Ok([prop_3_1(subject, &Sphere, &curve)?.attained()?])
    })
}

/// A straight line over the valleys, along `x₁`: the trace of a geodesic, at the speed
/// `2π (2 − cos 2πt)`, from `2π` to `6π`. And a geodesic that accelerates.
fn dropped_equation() -> Outcome {
    struct Line;
    impl Curve<2> for Line {
        fn motion(&self, t: f64) -> Motion<2> {
            let velocity = SVector::from([TAU, 0.0]);
            Motion { position: velocity * t, velocity, acceleration: SVector::zeros() }
        }
    }
    let shear = Shear::new(0.5, 1.0).expect("a wave number");
    let geodesic = Geodesic::between(shear, [[0.0, 0.0].into(), [2.0, 3.0].into()]);
    let clock = Clock::plain(Pace::Accelerating);
    let late = Reparametrised { curve: &geodesic, clock: &clock };
    fails_without(&["γ̈ = −Γ"], prop_3_1(&LIBRARY, &Valleys, &Line).map_err(VerifyError::from)?)?;
    fails_without(&["γ̈ = −Γ"], prop_3_1(&LIBRARY, &shear, &late).map_err(VerifyError::from)?)
}

/// Evidence for the known geodesic between two points of a complete space.
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
    fn family<M, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        family: impl Strategy<Value = (M, [SVector<f64, D>; 2])>,
    ) -> Outcome
    where
        M: KnownGeodesics<D> + Debug + 'static,
    {
        trial.for_all(seed, 224, family, |subject, (metric, ends)| {
            Ok([shown(subject, &metric, ends)?])
        })
    }
    all([
        family(trial, 3201, joined(constant::<4>())),
        family(trial, 3202, joined(shear())),
        family(trial, 3203, joined(separable::<2>())),
        family(trial, 3204, in_hyperbolic_space::<2>()),
        family(trial, 3205, in_hyperbolic_space::<3>()),
    ])
}

/// Two arcs of great circles, with a corner.
pub(super) struct TwoArcs {
    arcs: [Geodesic<Sphere, 2>; 2],
}

impl Curve<2> for TwoArcs {
    fn motion(&self, t: f64) -> Motion<2> {
        let (arc, t) =
            if t < 0.5 { (&self.arcs[0], 2.0 * t) } else { (&self.arcs[1], 2.0 * t - 1.0) };
        let Motion { position, velocity, acceleration } = arc.motion(t);
        Motion { position, velocity: velocity * 2.0, acceleration: acceleration * 4.0 }
    }

    fn corners(&self) -> Vec<f64> {
        vec![0.5]
    }
}

/// From `(2, 0)` to `(−2, 0)` the short way on the sphere leads over the missing point, `4 arctan
/// ½`. Curves that go round it by `(0, r)` have lengths that fall to that with `r → ∞`, as `d +
/// c/r²`, but no curve has it. Returns one of these, and the length of the shortest way out.
pub(super) fn round_the_missing_point(
    r: f64,
) -> Result<(Known<Sphere, 2>, TwoArcs, WayOut), VerifyError> {
    let ends: [SVector<f64, 2>; 2] = [[2.0, 0.0].into(), [-2.0, 0.0].into()];
    let known = Known::joined(Sphere, ends)?.expect("known");
    let top = SVector::from([0.0, r]);
    let arcs = [[ends[0], top], [top, ends[1]]].map(|pair| Geodesic::between(Sphere, pair));
    Ok((known, TwoArcs { arcs }, WayOut::from(&Sphere, &ends[0])))
}

fn dropped_completeness() -> Outcome {
    let mut longer = f64::INFINITY;
    for r in [10.0, 100.0, 1000.0] {
        let (known, arcs, way_out) = round_the_missing_point(r)?;
        close("d", known.distance, 4.0 * 0.5_f64.atan(), 1e-15)?;
        let evidence = prop_3_2(&LIBRARY, &known, &arcs, way_out).map_err(VerifyError::from)?;
        let excess = evidence.conclusion("L(γ) ≤ d").observed - known.distance;
        // On the sphere of radius 1, a triangle of small height 2/r over the missing point.
        if !(excess > 0.0 && excess * 90.0 < longer) {
            return Err(Failure::new(format!("r = {r}: {excess:e} more than d, after {longer:e}")));
        }
        longer = excess;
        fails_without(&["no way out"], evidence)?;
    }
    Ok(Default::default())
}

fn squeezed(trial: &Trial<'_>) -> Outcome {
    fn family<M: Bounded<D> + Debug + 'static, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        family: impl Strategy<Value = Known<M, D>>,
    ) -> Outcome {
        trial.for_all(seed, 224, family, |subject, known| Ok([prop_3_3(subject, &known)?]))
    }
    all([
        family(trial, 3301, points(shear())),
        family(trial, 3302, points(ramp())),
        family(trial, 3303, points(separable::<3>())),
        family(trial, 3304, points(constant::<3>())),
        family(trial, 3305, valleys_along()),
        family(trial, 3306, valleys_across::<2>()),
        family(trial, 3307, valleys_across::<3>()),
    ])
}

/// `H = diag(λ, μ)` with `λ ≤ μ`: along the first axis `d² = c₁ |x − y|²`, along the second `c₂`.
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
        let overestimation = evidence.conclusion(claim).overestimation();
        if !(overestimation <= 1.01) {
            let statement = Proposition3_3;
            return Err(VerifyError::NotAttained { statement, overestimation, known: 1.01 });
        }
        Ok([evidence])
    })
}

/// Hyperbolic space has `H ≥ 4`, and no `c₂`: from 0 to `(0.99, 0)` it is `2 artanh 0.99 = 5.29`,
/// not at most `√5 · 0.99`. The sphere has `H ≤ 4`, and no `c₁`: from 0 to `(10, 0)` it is `2
/// arctan 10 = 2.94`, not at least `√½ · 10`.
fn dropped_constants() -> Outcome {
    fn case<M: KnownGeodesics<2>>(
        metric: M,
        constants: [f64; 2],
        end: f64,
    ) -> Result<Evidence, VerifyError> {
        let ends = [[0.0, 0.0].into(), [end, 0.0].into()];
        let Known { ends, distance, distance_error, .. } =
            Known::joined(&metric, ends)?.expect("known");
        let constants = Constants::new(constants[0], constants[1], 1e6)?;
        let metric = WithConstants { metric, constants };
        Ok(prop_3_3(&LIBRARY, &Known { metric, ends, distance, distance_error })?)
    }
    fails_without(&["c₂"], case(Hyperbolic, [4.0, 5.0], 0.99)?)?;
    fails_without(&["c₁"], case(Sphere, [0.5, 4.0], 10.0)?)
}
