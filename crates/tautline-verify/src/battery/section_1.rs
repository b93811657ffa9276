//! Section 1: the chains of Theorems 1.1 to 1.4, and the constants in them, on random problems with
//! a known distance.

use std::fmt::Debug;

use proptest::prelude::*;
use tautline::Bounded;

use super::{Check, Kind, Outcome, Trial, check::all};
use crate::{
    Evidence, Known, PaperRule, Reconstruction, Statement,
    Statement::{
        ConstantC1_1, ConstantC1_3, ConstantK3Bar, ConstantK4Bar, Theorem1_1, Theorem1_2,
        Theorem1_3, Theorem1_4,
    },
    Subject,
    statements::{
        constant_c_1_1, constant_c_1_3, constant_k3_bar, constant_k4_bar, theorem_1_1, theorem_1_2,
        theorem_1_3, theorem_1_4,
    },
    strategies::{
        constant, constant_ball_half_space, constant_finite_sets, points, ramp, separable,
        separable_box_half_space, separable_boxes, shear, shear_ball_half_plane, subintervals,
        valleys_across, valleys_along, valleys_ball_half_space,
    },
};

const TRAPEZOIDAL: &[Statement] = &[Theorem1_1, Theorem1_2, ConstantK3Bar, ConstantC1_1];
const LEFT: &[Statement] = &[Theorem1_3, Theorem1_4, ConstantK4Bar, ConstantC1_3];

pub(super) fn checks<S: Subject>() -> Vec<Check<S>> {
    vec![
        Check::new(
            "theorems_1_1_and_1_2_hold_between_points",
            Kind::Random,
            TRAPEZOIDAL,
            |trial| between_points(trial, PaperRule::Trapezoidal, 1100),
        ),
        Check::new(
            "theorems_1_1_and_1_2_hold_from_set_to_set",
            Kind::Random,
            TRAPEZOIDAL,
            |trial| from_set_to_set(trial, PaperRule::Trapezoidal, 1200),
        ),
        Check::new("theorems_1_3_and_1_4_hold_between_points", Kind::Random, LEFT, |trial| {
            between_points(trial, PaperRule::LeftEndpoint, 1300)
        }),
        Check::new("theorems_1_3_and_1_4_hold_from_set_to_set", Kind::Random, LEFT, |trial| {
            from_set_to_set(trial, PaperRule::LeftEndpoint, 1400)
        }),
        Check::new(
            "theorems_1_1_and_1_2_are_homogeneous",
            Kind::Homogeneous,
            TRAPEZOIDAL,
            |trial| homogeneous(trial, PaperRule::Trapezoidal, 1500),
        ),
        Check::new("theorems_1_3_and_1_4_are_homogeneous", Kind::Homogeneous, LEFT, |trial| {
            homogeneous(trial, PaperRule::LeftEndpoint, 1600)
        }),
    ]
}

/// Both theorems of a rule, and the constants in them, on one minimiser.
pub(super) fn evidence<const D: usize>(
    subject: &impl Subject,
    seen: &Reconstruction<D>,
) -> [Evidence; 4] {
    match seen.rule {
        PaperRule::Trapezoidal => [
            theorem_1_1(subject, seen),
            theorem_1_2(subject, seen),
            constant_k3_bar(subject, seen),
            constant_c_1_1(subject, seen),
        ],
        PaperRule::LeftEndpoint => [
            theorem_1_3(subject, seen),
            theorem_1_4(subject, seen),
            constant_k4_bar(subject, seen),
            constant_c_1_3(subject, seen),
        ],
    }
}

/// Both theorems of a rule on random problems of one family.
fn theorems<S: Subject, M, const D: usize>(
    trial: &Trial<'_, S>,
    rule: PaperRule,
    seed: u64,
    cases: u32,
    family: impl Strategy<Value = Known<M, D>>,
) -> Outcome
where
    M: Bounded<D> + Clone + Debug,
{
    trial.for_all(seed, cases, (family, subintervals()), |subject, (known, n)| {
        let seen = Reconstruction::observe(subject, &known, rule, n)?;
        Ok(evidence(subject, &seen))
    })
}

fn homogeneous<S: Subject>(trial: &Trial<'_, S>, rule: PaperRule, seed: u64) -> Outcome {
    fn family<S: Subject, M, const D: usize>(
        trial: &Trial<'_, S>,
        rule: PaperRule,
        seed: u64,
        family: impl Strategy<Value = Known<M, D>>,
    ) -> Outcome
    where
        M: Bounded<D> + Clone + Debug,
    {
        trial.homogeneous(seed, 64, (family, subintervals()), |subject, (known, n), units| {
            let known = units.known(known)?;
            Ok(evidence(subject, &Reconstruction::observe(subject, &known, rule, n)?))
        })
    }
    all([
        family(trial, rule, seed, shear_ball_half_plane()),
        family(trial, rule, seed + 1, separable_boxes::<3>()),
        family(trial, rule, seed + 2, points(ramp())),
    ])
}

fn between_points<S: Subject>(trial: &Trial<'_, S>, rule: PaperRule, seed: u64) -> Outcome {
    all([
        theorems(trial, rule, seed, 128, points(constant::<2>())),
        theorems(trial, rule, seed + 1, 128, points(constant::<4>())),
        theorems(trial, rule, seed + 2, 384, points(shear())),
        theorems(trial, rule, seed + 3, 256, points(separable::<1>())),
        theorems(trial, rule, seed + 4, 256, points(separable::<2>())),
        theorems(trial, rule, seed + 5, 192, points(separable::<3>())),
        theorems(trial, rule, seed + 6, 128, points(separable::<5>())),
        theorems(trial, rule, seed + 7, 384, points(ramp())),
        theorems(trial, rule, seed + 8, 256, valleys_along()),
        theorems(trial, rule, seed + 9, 256, valleys_across::<2>()),
        theorems(trial, rule, seed + 10, 128, valleys_across::<3>()),
    ])
}

fn from_set_to_set<S: Subject>(trial: &Trial<'_, S>, rule: PaperRule, seed: u64) -> Outcome {
    all([
        theorems(trial, rule, seed, 192, constant_ball_half_space::<2>()),
        theorems(trial, rule, seed + 1, 128, constant_ball_half_space::<3>()),
        // The bounds are 0 for a constant metric, so that no pair but the nearest will do.
        theorems(trial, rule, seed + 2, 128, constant_finite_sets()),
        theorems(trial, rule, seed + 3, 256, shear_ball_half_plane()),
        theorems(trial, rule, seed + 4, 192, separable_box_half_space::<2>()),
        theorems(trial, rule, seed + 5, 128, separable_box_half_space::<3>()),
        theorems(trial, rule, seed + 6, 192, separable_boxes::<1>()),
        theorems(trial, rule, seed + 7, 192, separable_boxes::<2>()),
        theorems(trial, rule, seed + 8, 128, separable_boxes::<3>()),
        theorems(trial, rule, seed + 9, 256, valleys_ball_half_space()),
    ])
}
