//! Proposition 4.3: on a compact set, one radius for all exponential maps.

use std::{f64::consts::TAU, fmt::Debug};

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{
    gallery::{Hyperbolic, Sphere},
    norm_squared,
};
use tautline_statements::{
    Evidence, LIBRARY, Statement::Proposition4_3, VerifyError, curves::KnownGeodesics, prop_4_3,
};

use super::super::{Check, Failure, Kind, Outcome, Trial, check::all, failing::fails_without};
use crate::strategies::{constant, separable, shear, vector};

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new("prop_4_3_holds_on_balls", Kind::Random, &[Proposition4_3], normal_balls),
        Check::new("prop_4_3_is_homogeneous", Kind::Homogeneous, &[Proposition4_3], |trial| {
            trial.homogeneous(4320, 128, tangent(1.0), |subject, (ball, x, v, radius), units| {
                let metric = units.metric(Sphere);
                let (x, v) = (units.vector(x), units.vector(v));
                Ok([prop_4_3(subject, &metric, [&x, &v], ball * units.ell, radius * units.m)?])
            })
        }),
        Check::new(
            "prop_4_3_is_attained_by_every_ray",
            Kind::Witness,
            &[Proposition4_3],
            |trial| {
                trial.for_all(4330, 256, tangent(1.0), |subject, (ball, x, v, radius)| {
                    Ok([prop_4_3(subject, &Sphere, [&x, &v], ball, radius)?.attained()?])
                })
            },
        ),
        Check::new(
            "prop_4_3_fails_beyond_half_a_great_circle",
            Kind::Dropped,
            &[Proposition4_3],
            beyond_the_radius,
        ),
        Check::new(
            "prop_4_3_fails_on_the_whole_plane_and_outside_a_ball",
            Kind::Dropped,
            &[Proposition4_3],
            |_| far_out(),
        ),
    ]
}

/// The radius `R` of a ball, a point `|x| ≤ R`, a tangent vector, and the common radius `ε` of the
/// ball on the sphere, the angle from its boundary to the missing point. Of the vector, `|v|` is
/// the fraction `reach` of `ε` at most.
fn tangent(reach: f64) -> impl Strategy<Value = (f64, SVector<f64, 2>, SVector<f64, 2>, f64)> {
    let point = (0.1..1.5, 0.0..1.0, 0.0..TAU);
    (point, 0.01..0.99, 0.0..TAU).prop_map(
        move |((ball, part, at), fraction, towards): ((f64, f64, f64), f64, f64)| {
            let x = SVector::from([at.cos(), at.sin()]) * (ball * part);
            let epsilon = Sphere.normal_radius(&SVector::from([ball, 0.0]));
            let direction = SVector::from([towards.cos(), towards.sin()]);
            let unit = norm_squared(&Sphere, &x, &direction).sqrt();
            // Short of π, where the inverse is ill-conditioned.
            (ball, x, direction * ((epsilon * fraction * reach).min(2.8) / unit), epsilon)
        },
    )
}

fn normal_balls(trial: &Trial<'_>) -> Outcome {
    fn family<M: KnownGeodesics<D> + Debug + 'static, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        metrics: impl Strategy<Value = M>,
        size: f64,
    ) -> Outcome {
        let cases = (metrics, vector::<D>(size), vector::<D>(2.0))
            .prop_filter("a vector", |(_, _, v)| v.norm() >= 0.1);
        trial.for_all(seed, 160, cases, |subject, (metric, x, v)| {
            let ball = x.norm().max(1.0);
            // Any radius will do in these spaces.
            let epsilon = 2.0 * norm_squared(&metric, &x, &v).sqrt();
            Ok([prop_4_3(subject, &metric, [&x, &v], ball, epsilon)?])
        })
    }
    all([
        trial.for_all(4301, 512, tangent(1.0), |subject, (ball, x, v, radius)| {
            Ok([prop_4_3(subject, &Sphere, [&x, &v], ball, radius)?])
        }),
        family(trial, 4302, shear(), 2.5),
        family(trial, 4303, separable::<3>(), 2.5),
        family(trial, 4304, constant::<4>(), 2.5),
        family::<_, 2>(trial, 4305, Just(Hyperbolic), 0.25),
    ])
}

/// Along the equator by an angle between `π` and `2π`: `d = 2π − |v|`.
fn beyond_the_radius(trial: &Trial<'_>) -> Outcome {
    let x = SVector::from([1.0, 0.0]);
    for angle in [3.2, 4.0, 5.0, 6.0] {
        let v = SVector::from([0.0, angle]);
        let radius = Sphere.normal_radius(&x);
        let evidence = prop_4_3(trial.subject, &Sphere, [&x, &v], 1.0, radius);
        let evidence = evidence.map_err(VerifyError::from)?;
        let distance = evidence.conclusion("|v| ≤ d(x, Exp_x v)").bound;
        if !((distance - (TAU - angle)).abs() <= 1e-14) {
            return Err(Failure::new(format!("{angle} along the equator: {distance}")));
        }
        fails_without(&["|v| < ε"], evidence)?;
    }
    Ok(Default::default())
}

/// On the sphere without a point no `ε` is common to all of the plane, which is not compact, nor is
/// that of a ball a radius for points outside it: `π − 2 arctan |x|` tends to 0.
fn far_out() -> Outcome {
    let of = |x: f64, ball: f64, epsilon: f64| -> Result<Evidence, VerifyError> {
        let (x, v) = (SVector::from([x, 0.0]), SVector::from([0.0, 0.1]));
        Ok(prop_4_3(&LIBRARY, &Sphere, [&x, &v], ball, epsilon)?)
    };
    let mut outcomes = Vec::new();
    for epsilon in [1.0, 0.1, 1e-3] {
        outcomes.push(fails_without(&["K is bounded"], of(4.0 / epsilon, f64::INFINITY, epsilon)?));
    }
    let unit = Sphere.normal_radius(&SVector::from([1.0, 0.0]));
    outcomes.push(fails_without(&["x ∈ K"], of(2.0, 1.0, unit)?));
    all(outcomes)
}
