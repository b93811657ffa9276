//! Propositions 7.9, 8.1 and 8.2 compare a discrete energy with the energy of the reconstruction,
//! for any point sequence.

use std::fmt::Debug;

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use tautline::{Bounded, Constants, Metric, PointSequence, Rule, Scalar, gallery::Valleys};
use tautline_statements::{
    Evidence, LIBRARY,
    Statement::{self, Proposition7_9, Proposition8_1, Proposition8_2},
    Subject, VerifyError, prop_7_9, prop_8_1, prop_8_2,
    witnesses::{Incline, one_step, tent},
};

use crate::battery::{
    cases::clauses::LIPSCHITZ,
    harness::{
        Check, Dropped, Failure, Homogeneous, Outcome, Random, Trial, Witness, all, fails_without,
        for_all,
    },
};
use crate::strategies::{ramp, separable, sequence, shear};

const ALL: &[Statement] = &[Proposition7_9, Proposition8_1, Proposition8_2];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("props_7_9_8_1_and_8_2_hold_for_random_sequences", ALL, random),
    Homogeneous.check("props_7_9_8_1_and_8_2_are_homogeneous", ALL, homogeneous),
    Witness.check("prop_7_9_is_attained_by_the_tent", &[Proposition7_9], attained_by_the_tent),
    Witness.check(
        "props_8_1_and_8_2_are_attained_by_the_incline",
        &[Proposition8_1, Proposition8_2],
        attained_by_the_incline,
    ),
    Witness.check(
        "the_left_rule_reads_the_point_where_a_chord_begins",
        &[Proposition8_1],
        left_is_left,
    ),
    Dropped.check("props_7_9_8_1_and_8_2_fail_where_the_metric_jumps", ALL, dropped_lipschitz),
];

pub(crate) fn evidence<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<[Evidence; 3], VerifyError> {
    Ok([
        prop_7_9(subject, metric, sequence)?,
        prop_8_1(subject, metric, sequence)?,
        prop_8_2(subject, metric, sequence)?,
    ])
}

fn random(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        256,
        [
            (7901, (shear(), sequence(3.0))),
            (7902, (separable::<1>(), sequence(3.0))),
            (7903, (separable::<3>(), sequence(3.0))),
            (7904, (ramp(), sequence(3.0))),
            (7905, (Just(Valleys), sequence::<2>(3.0))),
        ],
        |subject, (metric, sequence)| evidence(subject, &metric, &sequence)
    )
}

fn homogeneous(trial: &Trial<'_>) -> Outcome {
    trial.homogeneous(7920, 128, (shear(), sequence(3.0)), |subject, (metric, sequence), units| {
        evidence(subject, &units.metric(metric), &units.sequence(&sequence)?)
    })
}

/// Draws a sequence with a single step at a random place, and a slope.
fn steps() -> impl Strategy<Value = (PointSequence<1>, f64)> {
    (1..300_usize, 0.0..1.0, 0.1..10.0)
        .prop_map(|(n, at, slope): (_, f64, _)| (one_step(n, (at * n as f64) as usize), slope))
}

/// For one step over the valley of a tent, `E(γᵖˡ) = N (2 + L/4)` and `E_tra,N = 2N` for every `N`.
fn attained_by_the_tent(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7910, 256, steps(), |subject, (sequence, slope)| {
        let metric = tent(2.0, slope).expect("positive");
        Ok([prop_7_9(subject, &metric, &sequence)?.attained()?])
    })
}

/// For one step up an incline, `E_l,N = 2N`, and the other two energies are `N (2 + L/2)`, for
/// every `N`.
fn attained_by_the_incline(trial: &Trial<'_>) -> Outcome {
    trial.for_all(8110, 256, steps(), |subject, (sequence, slope)| {
        let metric = Incline::new(2.0, slope).expect("positive");
        Ok([
            prop_8_1(subject, &metric, &sequence)?.attained()?,
            prop_8_2(subject, &metric, &sequence)?.attained()?,
        ])
    })
}

/// The left rule is not symmetric: for the step down an incline its error has the opposite sign.
/// The trapezoidal rule is symmetric. All numbers are small integers.
fn left_is_left(trial: &Trial<'_>) -> Outcome {
    let metric = Incline::new(2.0, 4.0).expect("positive");
    let up = one_step(3, 1);
    let down = PointSequence::new(up.points().iter().rev().copied().collect())?;
    let energies = [&up, &down].map(|sequence| {
        [
            trial.subject.discrete_energy(Rule::LEFT_ENDPOINT, &metric, sequence),
            trial.subject.discrete_energy(Rule::TRAPEZOIDAL, &metric, sequence),
        ]
    });
    if energies != [[6.0, 12.0], [18.0, 12.0]] {
        return Err(Failure::new(format!("up and down: {energies:?}")));
    }
    Ok(Default::default())
}

/// `H = 1.5 + ½ tanh(1000 (x − ¼))`, which is nearly a jump, although a Lipschitz constant of 1 is
/// claimed for it.
#[derive(Debug)]
struct Jump;

impl Metric<1> for Jump {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element(((x[0] - 0.25) * 1000.0).tanh() * 0.5 + 1.5)
    }
}

impl Bounded<1> for Jump {
    fn constants(&self) -> Constants {
        Constants::new(1.0, 2.0, 1.0).expect("in order")
    }
}

/// One chord leads from 0 to 0.6 across a jump of `H` from 1 to 2 at `¼`. With `|β|² = 0.36`, the
/// energies are 0.72 (trapezoidal), 0.36 (left) and `0.6 (¼ + 2 · 0.35) = 0.57`. The gaps 0.15,
/// 0.36 and 0.21 exceed the bounds for a Lipschitz constant of 1, which are 0.054, 0.108 and 0.108.
fn dropped_lipschitz(_: &Trial<'_>) -> Outcome {
    let sequence = PointSequence::straight([0.0], [0.6], 1)?;
    let evidence = evidence(&LIBRARY, &Jump, &sequence)?;
    all(evidence.map(|evidence| fails_without(&[LIPSCHITZ], evidence)))
}
