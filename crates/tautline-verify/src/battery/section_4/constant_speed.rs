//! Lemma 4.4: minimal curves of constant speed are geodesics.

use std::fmt::Debug;

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{
    KnownDistance, Metric,
    gallery::{Shear, Sphere},
};

use super::{
    super::{Check, Kind, Outcome, Trial, check::all, failing::fails_without},
    ends, sheared,
};
use crate::{
    Evidence, Known, Library,
    Statement::Lemma4_4,
    Subject, VerifyError,
    curves::{Clock, Curve, EvenSegment, Geodesic, KnownGeodesics, Motion, Pace, Reparametrised},
    statements::lemma_4_4,
    strategies::{
        bump, hill, in_hyperbolic_space, joined, lens, on_sphere, points, ramp, ray, shear,
        valleys_along,
    },
};

pub(super) fn checks<S: Subject>() -> Vec<Check<S>> {
    vec![
        Check::new("lemma_4_4_holds_for_minimal_curves", Kind::Random, &[Lemma4_4], even_curves),
        Check::new("lemma_4_4_is_homogeneous", Kind::Homogeneous, &[Lemma4_4], |trial| {
            trial.homogeneous(4420, 96, joined(shear()), |subject, (metric, ends), units| {
                let (metric, ends) = (units.metric(metric), ends.map(|x| units.vector(x)));
                let known = Known::joined(&metric, ends)?.expect("known");
                Ok([lemma_4_4(subject, &known, &Geodesic::between(&metric, ends))?])
            })
        }),
        Check::new("lemma_4_4_is_attained_on_a_ramp", Kind::Witness, &[Lemma4_4], |trial| {
            trial.for_all(4430, 64, points(ramp()), |subject, known| {
                // The acceleration may vanish to rounding where the ramp is flat.
                let evidence = segment(subject, &known)?;
                let seen = evidence.slack().is_finite();
                Ok([if seen { evidence.attained()? } else { evidence }])
            })
        }),
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
    ]
}

/// Lemma 4.4 for the segment between two points, at constant speed.
fn segment<M: Metric<D>, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
) -> Result<Evidence, VerifyError> {
    Ok(lemma_4_4(subject, known, &EvenSegment::new(&known.metric, ends(known)))?)
}

fn even_curves<S: Subject>(trial: &Trial<'_, S>) -> Outcome {
    fn segments<S: Subject, M, const D: usize>(
        trial: &Trial<'_, S>,
        seed: u64,
        family: impl Strategy<Value = Known<M, D>>,
    ) -> Outcome
    where
        M: KnownDistance<D> + Debug,
    {
        trial.for_all(seed, 64, family, |subject, known| Ok([segment(subject, &known)?]))
    }
    fn geodesics<S: Subject, M, const D: usize>(
        trial: &Trial<'_, S>,
        seed: u64,
        family: impl Strategy<Value = (M, [SVector<f64, D>; 2])>,
    ) -> Outcome
    where
        M: KnownGeodesics<D> + Debug,
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
    let evidence = lemma_4_4(&Library, &known, &curve).map_err(VerifyError::from)?;
    fails_without("speed is constant", evidence)
}

/// A quarter of the circle of radius `½` about the origin, on the sphere a circle of latitude.
fn dropped_least_length() -> Outcome {
    struct Quarter;
    impl Curve<2> for Quarter {
        fn motion(&self, t: f64) -> Motion<2> {
            let rate = std::f64::consts::FRAC_PI_2;
            let (sin, cos) = (rate * t).sin_cos();
            let position = SVector::from([cos, sin]) * 0.5;
            let velocity = SVector::from([-sin, cos]) * (0.5 * rate);
            Motion { position, velocity, acceleration: -position * (rate * rate) }
        }
    }
    let ends = [[0.5, 0.0].into(), [0.0, 0.5].into()];
    let known = Known::joined(Sphere, ends).map_err(VerifyError::from)?.expect("known");
    fails_without("L(γ) ≤ d", lemma_4_4(&Library, &known, &Quarter).map_err(VerifyError::from)?)
}
