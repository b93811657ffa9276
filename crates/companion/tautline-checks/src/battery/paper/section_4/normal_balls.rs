//! Proposition 4.3: on a compact set, a single radius serves for all exponential maps.

use std::{f64::consts::TAU, fmt::Debug};

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{
    gallery::{Hyperbolic, Sphere},
    norm_squared,
};
use tautline_statements::{
    Evidence, LIBRARY,
    Statement::{self, Proposition4_3},
    VerifyError,
    curves::KnownGeodesics,
    prop_4_3,
};

use crate::battery::harness::{
    Check, Dropped, Homogeneous, Outcome, Random, Trial, Witness, all, close, fails_without,
    for_all,
};
use crate::strategies::{constant, separable, shear, vector};

const P43: &[Statement] = &[Proposition4_3];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("prop_4_3_holds_on_balls", P43, normal_balls),
    Homogeneous.check("prop_4_3_is_homogeneous", P43, |trial| {
        trial.homogeneous(4320, 128, tangent(1.0), |subject, (ball, x, v, radius), units| {
            let metric = units.metric(Sphere);
            let (x, v) = (units.vector(x), units.vector(v));
            Ok([prop_4_3(subject, &metric, [&x, &v], ball * units.ell, radius * units.m)?])
        })
    }),
    Witness.check("prop_4_3_is_attained_by_every_ray", P43, |trial| {
        trial.for_all(4330, 256, tangent(1.0), |subject, (ball, x, v, radius)| {
            Ok([prop_4_3(subject, &Sphere, [&x, &v], ball, radius)?.attained()?])
        })
    }),
    Dropped.check("prop_4_3_fails_beyond_half_a_great_circle", P43, beyond_the_radius),
    Dropped.check("prop_4_3_fails_on_the_whole_plane_and_outside_a_ball", P43, far_out),
];

/// Draws, on the sphere, the radius `R` of a ball, a point `|x| ≤ R`, a tangent vector with
/// `|v| ≤ reach · ε`, and the common radius `ε` of the ball. `ε` is the angle from the boundary of
/// the ball to the missing point.
fn tangent(reach: f64) -> impl Strategy<Value = (f64, SVector<f64, 2>, SVector<f64, 2>, f64)> {
    let point = (0.1..1.5, 0.0..1.0, 0.0..TAU);
    (point, 0.01..0.99, 0.0..TAU).prop_map(
        move |((ball, part, at), fraction, towards): ((f64, f64, f64), f64, f64)| {
            let x = SVector::from([at.cos(), at.sin()]) * (ball * part);
            let epsilon = Sphere.normal_radius(&SVector::from([ball, 0.0]));
            let direction = SVector::from([towards.cos(), towards.sin()]);
            let unit = norm_squared(&Sphere, &x, &direction).sqrt();
            // The vector is shorter than π, where the inverse is ill-conditioned.
            (ball, x, direction * ((epsilon * fraction * reach).min(2.8) / unit), epsilon)
        },
    )
}

fn normal_balls(trial: &Trial<'_>) -> Outcome {
    let on_the_sphere = trial.for_all(4301, 512, tangent(1.0), |subject, (ball, x, v, radius)| {
        Ok([prop_4_3(subject, &Sphere, [&x, &v], ball, radius)?])
    });
    let elsewhere = for_all!(
        trial,
        160,
        [
            (4302, vector_at::<_, 2>(shear(), 2.5)),
            (4303, vector_at::<_, 3>(separable(), 2.5)),
            (4304, vector_at::<_, 4>(constant(), 2.5)),
            (4305, vector_at::<_, 2>(Just(Hyperbolic), 0.25)),
        ],
        |subject, (metric, x, v)| {
            let ball = x.norm().max(1.0);
            // In these spaces any radius is admissible.
            let epsilon = 2.0 * norm_squared(&metric, &x, &v).sqrt();
            Ok([prop_4_3(subject, &metric, [&x, &v], ball, epsilon)?])
        }
    );
    all([on_the_sphere, elsewhere])
}

/// Draws a metric, a point in the cube `[−size, size]^D`, and a tangent vector at that point.
fn vector_at<M: Debug, const D: usize>(
    metric: impl Strategy<Value = M>,
    size: f64,
) -> impl Strategy<Value = (M, SVector<f64, D>, SVector<f64, D>)> {
    let cases = (metric, vector::<D>(size), vector::<D>(2.0));
    cases.prop_filter("a vector", |(_, _, v)| v.norm() >= 0.1)
}

/// The geodesic runs along the equator by an angle between `π` and `2π`, so that `d = 2π − |v|`.
fn beyond_the_radius(trial: &Trial<'_>) -> Outcome {
    let x = SVector::from([1.0, 0.0]);
    for angle in [3.2, 4.0, 5.0, 6.0] {
        let v = SVector::from([0.0, angle]);
        let radius = Sphere.normal_radius(&x);
        let evidence = prop_4_3(trial.subject, &Sphere, [&x, &v], 1.0, radius)?;
        let distance = evidence.conclusion("|v| ≤ d(x, Exp_x v)").bound;
        close("d along the equator", distance, TAU - angle, 1e-14)?;
        fails_without(&["|v| < ε"], evidence)?;
    }
    Ok(Default::default())
}

/// On the sphere without a point, no `ε` serves for the whole plane, which is not compact. The `ε`
/// of a ball does not serve for points outside the ball, since `π − 2 arctan |x|` tends to 0.
fn far_out(_: &Trial<'_>) -> Outcome {
    let of = |x: f64, ball: f64, epsilon: f64| -> Result<Evidence, VerifyError> {
        let (x, v) = (SVector::from([x, 0.0]), SVector::from([0.0, 0.1]));
        Ok(prop_4_3(&LIBRARY, &Sphere, [&x, &v], ball, epsilon)?)
    };
    for epsilon in [1.0, 0.1, 1e-3] {
        fails_without(&["K is bounded"], of(4.0 / epsilon, f64::INFINITY, epsilon)?)?;
    }
    let unit = Sphere.normal_radius(&SVector::from([1.0, 0.0]));
    fails_without(&["x ∈ K"], of(2.0, 1.0, unit)?)
}
