//! Lemmas S.1 to S.3 and Proposition S.7 on random minimal geodesics and point sequences.

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{Bounded, PointSequence, gallery::Valleys};
use tautline_statements::{
    Evidence, Known, PaperRule, Reconstruction,
    Statement::{self, LemmaS1, LemmaS2, LemmaS3, PropositionS7},
    Subject, VerifyError, lemma_s_1, lemma_s_2, lemma_s_3, prop_s_7,
};

use crate::battery::{
    cases::known_geodesic,
    harness::{Check, Homogeneous, Outcome, Random, Trial, for_all},
};
use crate::strategies::{
    constant, points, ramp, separable, sequence, shear, two_points, valleys_along, vector,
};

const SEQUENCES: &[Statement] = &[LemmaS2, LemmaS3];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("lemma_s_1_holds_for_minimal_geodesics", &[LemmaS1], geodesics),
    Homogeneous.check("lemma_s_1_is_homogeneous", &[LemmaS1], geodesics_in_units),
    Random.check("lemmas_s_2_and_s_3_hold_for_random_sequences", SEQUENCES, sequences),
    Homogeneous.check("lemmas_s_2_and_s_3_are_homogeneous", SEQUENCES, sequences_in_units),
    Random.check("prop_s_7_holds_beside_minimisers", &[PropositionS7], minimisers),
    Homogeneous.check("prop_s_7_is_homogeneous", &[PropositionS7], minimisers_in_units),
];

fn geodesics(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        [
            (2700, 512, (shear(), two_points(2.5), 0.0..1.0)),
            (2701, 256, (separable::<1>(), two_points(2.5), 0.0..1.0)),
            (2702, 256, (separable::<3>(), two_points(2.5), 0.0..1.0)),
        ],
        |subject, (metric, ends, t)| {
            let (curve, distance) = known_geodesic(metric, ends);
            Ok([lemma_s_1(subject, &metric, &curve, distance, t)?])
        }
    )
}

fn geodesics_in_units(trial: &Trial<'_>) -> Outcome {
    let cases = (shear(), two_points(2.5), 0.0..1.0);
    trial.homogeneous(2710, 128, cases, |subject, (metric, ends, t), units| {
        let (curve, distance) = known_geodesic(metric, ends);
        let (metric, curve) = (units.metric(metric), units.curve(curve));
        Ok([lemma_s_1(subject, &metric, &curve, distance * units.m, t)?])
    })
}

fn of_sequence<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<[Evidence; 3], VerifyError> {
    Ok([
        lemma_s_2(subject, metric, sequence)?,
        lemma_s_3(subject, metric, PaperRule::Trapezoidal, sequence)?,
        lemma_s_3(subject, metric, PaperRule::LeftEndpoint, sequence)?,
    ])
}

fn sequences(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        192,
        [
            (2720, (shear(), sequence(3.0))),
            (2721, (separable::<1>(), sequence(3.0))),
            (2722, (separable::<3>(), sequence(3.0))),
            (2723, (ramp(), sequence(3.0))),
            (2724, (Just(Valleys), sequence::<2>(3.0))),
            // With L_H = 0 only the residual is left.
            (2725, (constant::<2>(), sequence(3.0))),
        ],
        |subject, (metric, sequence)| of_sequence(subject, &metric, &sequence)
    )
}

fn sequences_in_units(trial: &Trial<'_>) -> Outcome {
    trial.homogeneous(2730, 128, (shear(), sequence(3.0)), |subject, (metric, sequence), units| {
        of_sequence(subject, &units.metric(metric), &units.sequence(&sequence)?)
    })
}

/// Compares a minimiser between two points with the same sequence plus a wave that vanishes at the
/// ends.
fn beside<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    rule: PaperRule,
    n: usize,
    (wave, by): (usize, SVector<f64, D>),
) -> Result<[Evidence; 2], VerifyError> {
    let seen = Reconstruction::observe(subject, known, rule, n)?;
    let x = &seen.minimum.sequence;
    let at = |k: usize| {
        let turn = std::f64::consts::PI * (wave * k) as f64 / n as f64;
        // The wave is exactly 0 at both ends, while the computed sine is not.
        if k == 0 || k == n { 0.0 } else { turn.sin() }
    };
    let moved = x.points().iter().enumerate().map(|(k, x)| x + by * at(k));
    let y = PointSequence::new(moved.collect())?;
    let [of_x, of_y] = [x, &y].map(|sequence| subject.curve_length(&known.metric, sequence).value);
    Ok([
        prop_s_7(subject, &known.metric, rule, [x, &y], of_x)?,
        prop_s_7(subject, &known.metric, rule, [&y, x], of_y)?,
    ])
}

/// Draws `N`, the number of half waves, and their amplitude. Some waves are short and slow, so that
/// some of the energies are convex.
fn waves<const D: usize>() -> impl Strategy<Value = (usize, (usize, SVector<f64, D>))> {
    let amplitude = (-3.0..0.0_f64, vector::<D>(1.0));
    (2..40_usize, 1..4_usize, amplitude).prop_map(|(n, wave, (power, by))| {
        (n, (wave.min(n - 1), (by + by.map(|_| 1e-3)) * 10_f64.powf(power)))
    })
}

fn minimisers(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        96,
        [
            (2740, (points(shear()), waves())),
            (2741, (points(separable::<1>()), waves())),
            (2742, (points(separable::<3>()), waves())),
            (2743, (points(ramp()), waves())),
            (2744, (valleys_along(), waves())),
        ],
        |subject, (known, (n, wave))| {
            let [one, two] = PaperRule::BOTH.map(|rule| beside(subject, &known, rule, n, wave));
            Ok(one?.into_iter().chain(two?))
        }
    )
}

fn minimisers_in_units(trial: &Trial<'_>) -> Outcome {
    let cases = (points(shear()), waves::<2>());
    trial.homogeneous(2750, 64, cases, |subject, (known, (n, (wave, by))), units| {
        let known = units.known(known)?;
        beside(subject, &known, PaperRule::Trapezoidal, n, (wave, units.vector(by)))
    })
}
