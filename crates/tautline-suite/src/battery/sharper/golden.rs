//! Theorems A to D from metrics with known distances, against reference values that were computed
//! with 40 digits by a program which shares no code with this workspace.

use std::{f64::consts::PI, num::NonZeroUsize};

use tautline::{
    Bounded, Constants, KnownDistance,
    bounds::Setting,
    gallery::{Shear, Valleys},
};
use tautline_statements::{
    PaperRule, Statement,
    Statement::{LemmaS1, LemmaS4, LemmaS5, TheoremA, TheoremB, TheoremC, TheoremD},
    Subject, VerifyError,
};

use super::super::{Check, Failure, Kind, Outcome, Trial, close::close};

const ALL: &[Statement] = &[LemmaS1, LemmaS4, LemmaS5, TheoremA, TheoremB, TheoremC, TheoremD];

pub(super) fn checks() -> Vec<Check> {
    vec![Check::new("golden_bounds_of_theorems_a_to_d", Kind::Reference, ALL, bounds)]
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
    /// `d² (kδ/N) m₃`, `d² [e − 1 + (kδ/N) e^{3/2}]` and `d² (1 − s²)`, for both rules.
    theorem_c: [[f64; 3]; 2],
    /// `d² (ε − 1)`, `d² (μ/24N²) m₄`, `d² [ε − 1 + (μ/24N²) ε²]`, `d² (1 − 2/(1 + √(1 + μ/6N²)))`.
    theorem_d: [f64; 4],
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
    theorem_c: [
        [5176.90049329118922126, 1172.06908955100168316, 170.404125216467705873],
        [11125.3392217924476706, 1936.83297933097945922, 253.247102372007630321],
    ],
    theorem_d: [
        509.206136809210146533,
        4945.5060737778517805,
        588.647262733307559225,
        22.6380185519473455814,
    ],
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
    theorem_c: [
        [1.63605835636076187664, 2.08625541814424248348, 0.848790042960067993468],
        [5.13381571114267323055, 4.09620446230577685425, 1.5640175176270622633],
    ],
    theorem_d: [
        0.27444834357919610758,
        0.0154545678841862466044,
        0.287416166280016859273,
        0.0124623416470206670012,
    ],
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
    theorem_c: [
        [0.250662280160635651618, 0.457629678663741178829, 0.216790246595188154429],
        [0.574935031108301499516, 0.911306241801302853743, 0.423343342031364758051],
    ],
    theorem_d: [
        0.0162915815579994298261,
        0.00395110354128405866532,
        0.0202109151599701698088,
        0.0039074410103588455249,
    ],
};

/// The setting of two points under a metric of which it is not known that it is isotropic.
pub(super) fn setting(
    subject: &Subject,
    metric: &(impl Bounded<2> + KnownDistance<2>),
    to: [f64; 2],
) -> Result<Setting, VerifyError> {
    let claimed = subject.constants(metric);
    let constants = Constants::new(claimed.c1(), claimed.c2(), claimed.l_h())
        .and_then(|constants| constants.with_m_h(claimed.m_h().unwrap_or(f64::NAN)))?;
    let distance = metric.distance(&[0.0, 0.0].into(), &to.into()).expect("known");
    Ok(Setting::new(constants, distance, 2)?)
}

/// Compares what follows from the constants of `metric` and the distance of two points.
///
/// Up to `10⁻¹²`, relatively: `d` is known to some `10⁻¹⁵`, and enters with powers up to 7.
fn between(
    trial: &Trial<'_>,
    golden: &Golden,
    metric: &(impl Bounded<2> + KnownDistance<2>),
    to: [f64; 2],
) -> Result<(), Failure> {
    let subject = trial.subject;
    let setting = setting(subject, metric, to)?;
    let n = NonZeroUsize::new(64).expect("positive");
    let (tra, left) = (PaperRule::Trapezoidal, PaperRule::LeftEndpoint);
    let second = subject.theorem_b_minimum_gap(setting, n);
    let theorem_b = second.zip(subject.theorem_b_polyline_gap(setting, n)).map(|(a, b)| a + b);
    let d2 = setting.distance().powi(2);
    let above = |rule| 1.0 + subject.theorem_a_minimum_gap(setting, rule, n) / d2;
    let excess = |rule| {
        subject.theorem_a_minimum_gap(setting, rule, n)
            + subject.theorem_a_polyline_gap(setting, rule, n)
    };
    let mut pairs = vec![
        ("K₂", subject.k2_sharp(setting), golden.k2_sharp),
        ("δ", setting.delta(), golden.delta),
        ("μ", setting.mu().unwrap_or(f64::NAN), golden.mu),
        ("Theorem A, trapezoidal", excess(tra), golden.theorem_a),
        ("Theorem A, left", excess(left), golden.theorem_a_left),
        ("Theorem B", theorem_b.unwrap_or(f64::NAN), golden.theorem_b),
        ("e, trapezoidal", above(tra), golden.e_tra),
        ("e, left", above(left), golden.e_left),
    ];
    for (rule, golden) in PaperRule::BOTH.into_iter().zip(golden.theorem_c) {
        let found = [
            subject.theorem_c_polyline_gap(setting, rule, n),
            subject.theorem_c_length_excess(setting, rule, n),
            subject.theorem_c_deficit(setting, rule, n),
        ];
        pairs.extend(found.into_iter().zip(golden).map(|(a, b)| ("Theorem C", a, b)));
    }
    let found = [
        subject.theorem_d_minimum_gap(setting, n),
        subject.theorem_d_polyline_gap(setting, n),
        subject.theorem_d_length_excess(setting, n),
        subject.theorem_d_deficit(setting, n),
    ];
    let found = found.map(|bound| bound.unwrap_or(f64::NAN));
    pairs.extend(found.into_iter().zip(golden.theorem_d).map(|(a, b)| ("Theorem D", a, b)));
    for (name, value, expected) in pairs {
        close(name, value, expected, 1e-12 * expected)?;
    }
    Ok(())
}

fn bounds(trial: &Trial<'_>) -> Outcome {
    between(trial, &ALONG_VALLEYS, &Valleys, [4.0 * PI, 0.0])?;
    between(trial, &ACROSS_VALLEYS, &Valleys, [2.0, 1.5])?;
    let shear = Shear::new(0.5, 1.0).map_err(VerifyError::from)?;
    between(trial, &SHEARED, &shear, [2.0, 3.0])?;
    Ok(Default::default())
}
