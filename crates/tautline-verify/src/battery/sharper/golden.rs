//! Theorems A and B from metrics with known distances, against reference values that were computed
//! with 40 digits by a program which shares no code with this workspace.

use std::{f64::consts::PI, num::NonZeroUsize};

use tautline::{
    Bounded, Constants, KnownDistance,
    bounds::Setting,
    gallery::{Shear, Valleys},
};

use super::super::{Check, Failure, Kind, Outcome, Trial, close::close};
use crate::{
    PaperRule,
    Statement::{LemmaS1, LemmaS4, TheoremA, TheoremB},
    Subject, VerifyError,
};

pub(super) fn checks<S: Subject>() -> Vec<Check<S>> {
    vec![Check::new(
        "golden_bounds_of_theorems_a_and_b",
        Kind::Reference,
        &[LemmaS1, LemmaS4, TheoremA, TheoremB],
        bounds,
    )]
}

/// The bounds of one problem in the plane with `ω = 3/2`, at `N = 64`.
struct Golden {
    k2_sharp: f64,
    delta: f64,
    mu: f64,
    theorem_a: f64,
    theorem_a_left: f64,
    theorem_b: f64,
    e_tra: f64,
    e_left: f64,
}

/// The valleys, from (0, 0) to (4π, 0).
const ALONG_VALLEYS: Golden = Golden {
    k2_sharp: 4172.3976606541013836,
    delta: 110.676285373026788735,
    mu: 3789.92809001831370963,
    theorem_a: 5812.1097587435424396,
    theorem_a_left: 11671.5047983993711711,
    theorem_b: 5593.4381959514445589,
    e_tra: 1.80614638280392738228,
    e_left: 1.86465847947677178699,
};

/// The valleys, from (0, 0) to (2, 3/2).
const ACROSS_VALLEYS: Golden = Golden {
    k2_sharp: 94.4700997015284895321,
    delta: 16.6536301219835887045,
    mu: 85.8103454284663918433,
    theorem_a: 9.33009516661246021739,
    theorem_a_left: 19.7444061752205996208,
    theorem_b: 1.35211449026135146437,
    e_tra: 1.07351709142620051495,
    e_left: 1.13010648532799678675,
};

/// The shear by `Φ = (x₁ + ½ sin x₂, x₂)`, from (0, 0) to (2, 3).
const SHEARED: Golden = Golden {
    k2_sharp: 29.9808284239202032139,
    delta: 4.28116542232659681464,
    mu: 28.9257749996325963221,
    theorem_a: 1.44209722498150908244,
    theorem_a_left: 2.94330865092338469206,
    theorem_b: 0.143461043675911394083,
    e_tra: 1.01728264011935819276,
    e_left: 1.03344660486192653761,
};

/// Compares what follows from the constants of `metric` and the distance of two points.
///
/// Up to `10⁻¹²`, relatively: `d` is known to some `10⁻¹⁵`, and enters with powers up to 7.
fn between<S: Subject>(
    trial: &Trial<'_, S>,
    golden: &Golden,
    metric: &(impl Bounded<2> + KnownDistance<2>),
    to: [f64; 2],
) -> Result<(), Failure> {
    let (subject, claimed) = (trial.subject, trial.subject.constants(metric));
    // As for a metric of which it is not known that it is isotropic.
    let constants = Constants::new(claimed.c1(), claimed.c2(), claimed.l_h())
        .and_then(|constants| constants.with_m_h(claimed.m_h().unwrap_or(f64::NAN)))
        .map_err(VerifyError::from)?;
    let distance = metric.distance(&[0.0, 0.0].into(), &to.into()).expect("known");
    let setting = Setting::new(constants, distance, 2).map_err(VerifyError::from)?;
    let n = NonZeroUsize::new(64).expect("positive");
    let (tra, left) = (PaperRule::Trapezoidal, PaperRule::LeftEndpoint);
    let second = subject.theorem_b_minimum_gap(setting, n);
    let theorem_b = second.zip(subject.theorem_b_polyline_gap(setting, n)).map(|(a, b)| a + b);
    let above = |rule| 1.0 + subject.theorem_a_minimum_gap(setting, rule, n) / distance.powi(2);
    let excess = |rule| {
        subject.theorem_a_minimum_gap(setting, rule, n)
            + subject.theorem_a_polyline_gap(setting, rule, n)
    };
    for (name, value, expected) in [
        ("K₂", subject.k2_sharp(setting), golden.k2_sharp),
        ("δ", setting.delta(), golden.delta),
        ("μ", setting.mu().unwrap_or(f64::NAN), golden.mu),
        ("Theorem A, trapezoidal", excess(tra), golden.theorem_a),
        ("Theorem A, left", excess(left), golden.theorem_a_left),
        ("Theorem B", theorem_b.unwrap_or(f64::NAN), golden.theorem_b),
        ("e, trapezoidal", above(tra), golden.e_tra),
        ("e, left", above(left), golden.e_left),
    ] {
        close(name, value, expected, 1e-12 * expected)?;
    }
    Ok(())
}

fn bounds<S: Subject>(trial: &Trial<'_, S>) -> Outcome {
    between(trial, &ALONG_VALLEYS, &Valleys, [4.0 * PI, 0.0])?;
    between(trial, &ACROSS_VALLEYS, &Valleys, [2.0, 1.5])?;
    let shear = Shear::new(0.5, 1.0).map_err(VerifyError::from)?;
    between(trial, &SHEARED, &shear, [2.0, 3.0])?;
    Ok(Default::default())
}
