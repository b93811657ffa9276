//! Lemma 4.4: minimal curves of constant speed are geodesics.

use std::{cell::Cell, f64::consts::FRAC_PI_2, fmt::Debug};

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use tautline::{
    KnownDistance, Metric,
    gallery::{Constant, Shear, Sphere},
};
use tautline_statements::{
    Evidence, Known, LIBRARY,
    Statement::Lemma4_4,
    Subject, VerifyError,
    curves::{Clock, Curve, EvenSegment, Geodesic, KnownGeodesics, Motion, Pace, Reparametrised},
    lemma_4_4,
};

use super::{
    super::{
        Check, Failure, Kind, Outcome, Trial, check::all, failing::fails_without, sheared::sheared,
    },
    ends,
};
use crate::strategies::{
    bump, hill, in_hyperbolic_space, joined, lens, on_sphere, points, ramp, ray, shear,
    valleys_along,
};

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new("lemma_4_4_holds_for_minimal_curves", Kind::Random, &[Lemma4_4], even_curves),
        Check::new("lemma_4_4_is_homogeneous", Kind::Homogeneous, &[Lemma4_4], |trial| {
            trial.homogeneous(4420, 96, joined(shear()), |subject, (metric, ends), units| {
                let (metric, ends) = (units.metric(metric), ends.map(|x| units.vector(x)));
                let known = Known::joined(&metric, ends)?.expect("known");
                Ok([lemma_4_4(subject, &known, &Geodesic::between(&metric, ends))?])
            })
        }),
        Check::new("lemma_4_4_is_attained_on_a_ramp", Kind::Witness, &[Lemma4_4], attained),
        Check::new("lemma_4_4_holds_for_a_point", Kind::Witness, &[Lemma4_4], |trial| {
            let [a] = [SVector::from([0.3, -0.2])];
            let shear = Shear::new(0.5, 1.0).expect("a wave number");
            let known = Known::joined(shear, [a, a]).map_err(VerifyError::from)?.expect("known");
            let still = Geodesic::between(shear, [a, a]);
            trial.one([lemma_4_4(trial.subject, &known, &still).map_err(VerifyError::from)?])
        }),
        Check::new(
            "lemma_4_4_fails_for_a_minimal_curve_that_accelerates",
            Kind::Dropped,
            &[Lemma4_4],
            |_| dropped_speed(),
        ),
        Check::new(
            "lemma_4_4_fails_for_a_circle_of_constant_speed",
            Kind::Dropped,
            &[Lemma4_4],
            |_| dropped_least_length(),
        ),
        Check::new(
            "lemma_4_4_fails_for_an_arc_that_stops_half_way",
            Kind::Dropped,
            &[Lemma4_4],
            |_| dropped_ends(),
        ),
    ]
}

/// Lemma 4.4 for the segment between two points, at constant speed.
fn segment<M: Metric<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
) -> Result<Evidence, VerifyError> {
    Ok(lemma_4_4(subject, known, &EvenSegment::new(&known.metric, ends(known)))?)
}

/// Two equal sizes, which are two inequalities of overestimation 1 wherever there is something to
/// be seen.
fn attained(trial: &Trial<'_>) -> Outcome {
    let bent = Cell::new(0);
    let tally = trial.for_all(4430, 64, points(ramp()), |subject, known| {
        // The acceleration may vanish to rounding where the ramp is flat.
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
    fn segments<M, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        family: impl Strategy<Value = Known<M, D>>,
    ) -> Outcome
    where
        M: KnownDistance<D> + Debug + 'static,
    {
        trial.for_all(seed, 64, family, |subject, known| Ok([segment(subject, &known)?]))
    }
    fn geodesics<M, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        family: impl Strategy<Value = (M, [SVector<f64, D>; 2])>,
    ) -> Outcome
    where
        M: KnownGeodesics<D> + Debug + 'static,
    {
        trial.for_all(seed, 192, family, |subject, (metric, ends)| {
            let known = Known::joined(&metric, ends)?.expect("known");
            Ok([lemma_4_4(subject, &known, &Geodesic::between(&metric, ends))?])
        })
    }
    all([
        segments(trial, 4401, ray::<_, 2>(bump())),
        segments(trial, 4402, ray::<_, 3>(bump())),
        segments(trial, 4403, ray::<_, 2>(lens())),
        segments(trial, 4404, ray::<_, 3>(lens())),
        segments(trial, 4405, ray::<_, 2>(hill())),
        segments(trial, 4406, ray::<_, 3>(hill())),
        segments(trial, 4407, valleys_along()),
        segments(trial, 4408, points(ramp())),
        geodesics(trial, 4409, joined(shear())),
        geodesics(trial, 4410, on_sphere::<3>()),
        geodesics(trial, 4411, in_hyperbolic_space::<3>()),
    ])
}

/// The minimal geodesic of a shear, run through as `t²`.
fn dropped_speed() -> Outcome {
    let (known, geodesic) = sheared();
    let clock = Clock::plain(Pace::Accelerating);
    let curve = Reparametrised { curve: &geodesic, clock: &clock };
    let evidence = lemma_4_4(&LIBRARY, &known, &curve).map_err(VerifyError::from)?;
    fails_without(&["speed is constant"], evidence)
}

/// An arc of the circle of radius `½` about the origin from `(½, 0)` on, of this angle; on the
/// sphere part of a circle of latitude.
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

/// A quarter of the circle joins `(½, 0)` and `(0, ½)`, but is too long.
fn dropped_least_length() -> Outcome {
    let ends = [[0.5, 0.0].into(), [0.0, 0.5].into()];
    let known = Known::joined(Sphere, ends).map_err(VerifyError::from)?.expect("known");
    let quarter = lemma_4_4(&LIBRARY, &known, &Arc(FRAC_PI_2)).map_err(VerifyError::from)?;
    fails_without(&["L(γ) ≤ d"], quarter)
}

/// An eighth of it is shorter than `d`, and ends half-way: `π/8 < 1/√2` in the plane.
fn dropped_ends() -> Outcome {
    fn eighth<M: KnownGeodesics<2>>(metric: M) -> Outcome {
        let ends = [[0.5, 0.0].into(), [0.0, 0.5].into()];
        let known = Known::joined(metric, ends).map_err(VerifyError::from)?.expect("known");
        let arc = Arc(0.5 * FRAC_PI_2);
        let evidence = lemma_4_4(&LIBRARY, &known, &arc).map_err(VerifyError::from)?;
        fails_without(&["γ joins the points"], evidence)
    }
    all([eighth(Constant::new(SMatrix::identity()).expect("positive definite")), eighth(Sphere)])
}
