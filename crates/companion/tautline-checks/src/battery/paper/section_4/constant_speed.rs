//! Lemma 4.4: minimal curves of constant speed are geodesics.

use std::{cell::Cell, f64::consts::FRAC_PI_2};

use nalgebra::{SMatrix, SVector};
use tautline::{
    Metric,
    gallery::{Constant, Shear, Sphere},
};
use tautline_statements::{
    Evidence, Known, LIBRARY,
    Statement::{self, Lemma4_4},
    Subject, VerifyError,
    curves::{Clock, Curve, EvenSegment, Geodesic, KnownGeodesics, Motion, Pace, Reparametrised},
    lemma_4_4,
};

use super::ends;
use crate::battery::{
    cases::sheared,
    harness::{
        Check, Dropped, Failure, Homogeneous, Outcome, Random, Trial, Witness, all, fails_without,
        for_all,
    },
};
use crate::strategies::{
    bump, hill, in_hyperbolic_space, joined, lens, on_sphere, points, ramp, ray, shear,
    valleys_along,
};

const L44: &[Statement] = &[Lemma4_4];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("lemma_4_4_holds_for_minimal_curves", L44, even_curves),
    Homogeneous.check("lemma_4_4_is_homogeneous", L44, |trial| {
        trial.homogeneous(4420, 96, joined(shear()), |subject, (metric, ends), units| {
            Ok([geodesic(subject, &units.metric(metric), ends.map(|x| units.vector(x)))?])
        })
    }),
    Witness.check("lemma_4_4_is_attained_on_a_ramp", L44, attained),
    Witness.check("lemma_4_4_holds_for_a_point", L44, |trial| {
        let a = SVector::from([0.3, -0.2]);
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        trial.one([geodesic(trial.subject, &shear, [a, a])?])
    }),
    Dropped.check("lemma_4_4_fails_for_a_minimal_curve_that_accelerates", L44, dropped_speed),
    Dropped.check("lemma_4_4_fails_for_a_circle_of_constant_speed", L44, dropped_least_length),
    Dropped.check("lemma_4_4_fails_for_an_arc_that_stops_half_way", L44, dropped_ends),
];

/// Evaluates Lemma 4.4 for the segment between two points, at constant speed.
fn segment<M: Metric<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
) -> Result<Evidence, VerifyError> {
    Ok(lemma_4_4(subject, known, &EvenSegment::new(&known.metric, ends(known)))?)
}

/// Evaluates Lemma 4.4 for the known geodesic between two points.
fn geodesic<M: KnownGeodesics<D>, const D: usize>(
    subject: &Subject,
    metric: &M,
    ends: [SVector<f64, D>; 2],
) -> Result<Evidence, VerifyError> {
    let known = Known::joined(metric, ends)?.expect("known");
    Ok(lemma_4_4(subject, &known, &Geodesic::between(metric, ends))?)
}

/// The lemma states that two quantities are equal, so both inequalities have overestimation 1
/// wherever the quantities are not 0.
fn attained(trial: &Trial<'_>) -> Outcome {
    let bent = Cell::new(0);
    let tally = trial.for_all(4430, 64, points(ramp()), |subject, known| {
        // Where the ramp is flat, the acceleration may be zero up to rounding.
        let evidence = segment(subject, &known)?;
        if !evidence.overestimation().is_finite() {
            return Ok([evidence]);
        }
        bent.set(bent.get() + 1);
        Ok([evidence.attained()?])
    })?;
    if bent.get() > 0 { Ok(tally) } else { Err(Failure::new("all segments are flat")) }
}

fn even_curves(trial: &Trial<'_>) -> Outcome {
    let segments = for_all!(
        trial,
        64,
        [
            (4401, ray::<_, 2>(bump())),
            (4402, ray::<_, 3>(bump())),
            (4403, ray::<_, 2>(lens())),
            (4404, ray::<_, 3>(lens())),
            (4405, ray::<_, 2>(hill())),
            (4406, ray::<_, 3>(hill())),
            (4407, valleys_along()),
            (4408, points(ramp())),
        ],
        |subject, known| Ok([segment(subject, &known)?])
    );
    let geodesics = for_all!(
        trial,
        192,
        [(4409, joined(shear())), (4410, on_sphere::<3>()), (4411, in_hyperbolic_space::<3>()),],
        |subject, (metric, ends)| Ok([geodesic(subject, &metric, ends)?])
    );
    all([segments, geodesics])
}

/// The curve is the minimal geodesic of a shear, parametrised by `t²`.
fn dropped_speed(_: &Trial<'_>) -> Outcome {
    let (known, geodesic) = sheared();
    let clock = Clock::plain(Pace::Accelerating);
    let curve = Reparametrised { curve: &geodesic, clock: &clock };
    let evidence = lemma_4_4(&LIBRARY, &known, &curve)?;
    fails_without(&["speed is constant"], evidence)
}

/// An arc of this angle on the circle of radius `½` about the origin, starting at `(½, 0)`. On the
/// sphere it is part of a circle of latitude.
struct Arc(f64);

impl Curve<2> for Arc {
    fn motion(&self, t: f64) -> Motion<2> {
        let Self(rate) = *self;
        let (sin, cos) = (rate * t).sin_cos();
        let position = SVector::from([cos, sin]) * 0.5;
        let velocity = SVector::from([-sin, cos]) * (0.5 * rate);
        Motion { position, velocity, acceleration: -position * (rate * rate) }
    }
}

/// A quarter of the circle joins `(½, 0)` and `(0, ½)`, but is longer than `d`.
fn dropped_least_length(_: &Trial<'_>) -> Outcome {
    arc_fails_without("L(γ) ≤ d", Sphere, FRAC_PI_2)
}

/// An eighth of the circle is shorter than `d`, since `π/8 < 1/√2` in the plane, but it stops
/// half-way.
fn dropped_ends(_: &Trial<'_>) -> Outcome {
    let plane = Constant::new(SMatrix::identity()).expect("positive definite");
    let clause = "γ joins the points";
    all([
        arc_fails_without(clause, plane, 0.5 * FRAC_PI_2),
        arc_fails_without(clause, Sphere, 0.5 * FRAC_PI_2),
    ])
}

/// Lemma 4.4 must fail for an arc, as a curve from `(½, 0)` to `(0, ½)`, if this clause is dropped.
fn arc_fails_without<M: KnownGeodesics<2>>(clause: &str, metric: M, angle: f64) -> Outcome {
    let known = Known::joined(metric, [[0.5, 0.0].into(), [0.0, 0.5].into()])?.expect("known");
    fails_without(&[clause], lemma_4_4(&LIBRARY, &known, &Arc(angle))?)
}
