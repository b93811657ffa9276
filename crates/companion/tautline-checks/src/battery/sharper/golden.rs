//! Compares the bounds of Theorems A to D, for metrics with known distances, with the reference
//! values of `golden_bounds.csv`.

use std::{f64::consts::PI, num::NonZeroUsize};

use tautline::{
    Bounded, Constants, KnownDistance,
    bounds::Setting,
    gallery::{Shear, Valleys},
};
use tautline_statements::{
    PaperRule,
    Statement::{self, LemmaS1, LemmaS4, LemmaS5, TheoremA, TheoremB, TheoremC, TheoremD},
    Subject, VerifyError,
};

use crate::battery::harness::{Check, Golden, Outcome, Reference, Trial};

const ALL: &[Statement] = &[LemmaS1, LemmaS4, LemmaS5, TheoremA, TheoremB, TheoremC, TheoremD];

pub(crate) const CHECKS: &[Check] =
    &[Reference.check("golden_bounds_of_theorems_a_to_d", ALL, bounds)];

/// Returns the setting of two points, without using that the metric is isotropic.
pub(crate) fn setting(
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

/// Compares what follows from the constants of `metric` and from the distance between two points.
///
/// The relative tolerance is `10⁻¹²`: `d` is known to some `10⁻¹⁵`, and it enters with powers up to
/// 7.
fn between(
    trial: &Trial<'_>,
    problem: &str,
    metric: &(impl Bounded<2> + KnownDistance<2>),
    to: [f64; 2],
) -> Outcome {
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
    let known = |bound: Option<f64>| bound.unwrap_or(f64::NAN);
    let computed = [
        ("k2_sharp", subject.k2_sharp(setting)),
        ("delta", setting.delta()),
        ("mu", known(setting.mu())),
        ("a_tra", excess(tra)),
        ("a_left", excess(left)),
        ("b", known(theorem_b)),
        ("e_tra", above(tra)),
        ("e_left", above(left)),
        ("c_gap_tra", subject.theorem_c_polyline_gap(setting, tra, n)),
        ("c_length_tra", subject.theorem_c_length_excess(setting, tra, n)),
        ("c_deficit_tra", subject.theorem_c_deficit(setting, tra, n)),
        ("c_gap_left", subject.theorem_c_polyline_gap(setting, left, n)),
        ("c_length_left", subject.theorem_c_length_excess(setting, left, n)),
        ("c_deficit_left", subject.theorem_c_deficit(setting, left, n)),
        ("d_minimum", known(subject.theorem_d_minimum_gap(setting, n))),
        ("d_gap", known(subject.theorem_d_polyline_gap(setting, n))),
        ("d_length", known(subject.theorem_d_length_excess(setting, n))),
        ("d_deficit", known(subject.theorem_d_deficit(setting, n))),
    ];
    Golden::of(include_str!("golden_bounds.csv"), problem).agrees(&computed, 1e-12)
}

fn bounds(trial: &Trial<'_>) -> Outcome {
    between(trial, "along-valleys", &Valleys, [4.0 * PI, 0.0])?;
    between(trial, "across-valleys", &Valleys, [2.0, 1.5])?;
    let shear = Shear::new(0.5, 1.0)?;
    between(trial, "sheared", &shear, [2.0, 3.0])
}
