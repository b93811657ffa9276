//! Proposition S.10: the bounds for two numbers of subintervals.

use std::num::NonZeroUsize;

use proptest::prelude::*;
use tautline::{Constants, bounds::Setting};
use tautline_statements::{
    LIBRARY, PaperRule,
    Statement::{self, PropositionS10},
    prop_s_10,
};

use crate::battery::harness::{
    Check, Dropped, Homogeneous, Outcome, Random, Trial, Witness, fails_without, for_rules,
};

const S10: &[Statement] = &[PropositionS10];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("prop_s_10_holds_for_random_constants", S10, random),
    Homogeneous.check("prop_s_10_is_homogeneous", S10, in_units),
    Witness.check("prop_s_10_is_attained_by_the_cap", S10, capped),
    Dropped.check("prop_s_10_fails_for_fewer_chords", S10, fewer),
];

fn numbers(n: usize, more: usize) -> [NonZeroUsize; 2] {
    [n, n + more].map(|n| NonZeroUsize::new(n).expect("positive"))
}

/// Draws `δ` and `μ` from 0.01 to 100, so that each entry of each minimum is the least in some
/// cases, and often one chord and two.
fn settings() -> impl Strategy<Value = (Setting, [NonZeroUsize; 2])> {
    let decades = |low: f64, high: f64| (low..high).prop_map(|power| 10_f64.powf(power));
    let numbers_of_chords =
        prop_oneof![Just((1, 1)), (1..6_usize, 1..4_usize), (1..3000_usize, 1..500_usize)];
    let pure = (decades(0.0, 3.0), decades(-2.0, 2.0), decades(-2.0, 2.0));
    let cases = (decades(-2.0, 2.0), decades(-2.0, 2.0), pure, 1..4_usize, numbers_of_chords);
    cases.prop_map(|(c1, d, (kappa, delta, mu), dimension, (n, more))| {
        let constants = Constants::new(c1, kappa * c1, delta * c1.powf(1.5) / d).expect("in order");
        let constants = constants.with_m_h(mu * c1 * c1 / (d * d)).expect("positive");
        (Setting::new(constants, d, dimension).expect("a distance"), numbers(n, more))
    })
}

fn random(trial: &Trial<'_>) -> Outcome {
    trial.for_all(2930, 2048, settings(), |subject, (setting, chords)| {
        Ok(PaperRule::BOTH.map(|rule| prop_s_10(subject, setting, rule, chords)))
    })
}

fn in_units(trial: &Trial<'_>) -> Outcome {
    trial.homogeneous(2931, 128, settings(), |subject, (setting, chords), units| {
        let constants = units.constants(setting.constants())?;
        let setting = Setting::new(constants, setting.distance() * units.m, setting.dimension())?;
        Ok(PaperRule::BOTH.map(|rule| prop_s_10(subject, setting, rule, chords)))
    })
}

/// With `κ = 1.01` and `δ = 3` the cap is the least up to `N = 75`.
fn capped(trial: &Trial<'_>) -> Outcome {
    let constants = Constants::new(4.0, 4.04, 8.0)?;
    let setting = Setting::new(constants, 3.0, 2)?;
    for_rules([1, 10, 60], |rule, n| {
        let found = prop_s_10(trial.subject, setting, rule, numbers(n, 7));
        trial.one([found.claim_is_attained("e − 1 falls", 1.0)?])
    })
}

fn fewer(_: &Trial<'_>) -> Outcome {
    let setting = Setting::new(Constants::new(4.0, 400.0, 8.0)?, 3.0, 2)?;
    for_rules([1, 10, 60], |rule, n| {
        let [coarse, fine] = numbers(n, 7);
        fails_without(&["N ≤ M"], prop_s_10(&LIBRARY, setting, rule, [fine, coarse]))
    })
}
