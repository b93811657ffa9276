//! Section 1: the chains of inequalities in Theorems 1.1 to 1.4, and the constants in them, on
//! random problems with a known distance.

use tautline::Bounded;
use tautline_statements::{
    Evidence, Known, PaperRule, Reconstruction,
    Statement::{
        self, ConstantC1_1, ConstantC1_3, ConstantK3Bar, ConstantK4Bar, Theorem1_1, Theorem1_2,
        Theorem1_3, Theorem1_4,
    },
    Subject, VerifyError, constant_c_1_1, constant_c_1_3, constant_k3_bar, constant_k4_bar,
    theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4,
};

use crate::battery::{
    cases::{Problems, Question},
    harness::{Check, Homogeneous, Random},
};

const TRAPEZOIDAL: &[Statement] = &[Theorem1_1, Theorem1_2, ConstantK3Bar, ConstantC1_1];
const LEFT: &[Statement] = &[Theorem1_3, Theorem1_4, ConstantK4Bar, ConstantC1_3];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("theorems_1_1_and_1_2_hold_between_points", TRAPEZOIDAL, |trial| {
        problems(PaperRule::Trapezoidal, 1100).between_points(trial)
    }),
    Random.check("theorems_1_1_and_1_2_hold_from_set_to_set", TRAPEZOIDAL, |trial| {
        problems(PaperRule::Trapezoidal, 1200).between_sets(trial)
    }),
    Random.check("theorems_1_3_and_1_4_hold_between_points", LEFT, |trial| {
        problems(PaperRule::LeftEndpoint, 1300).between_points(trial)
    }),
    Random.check("theorems_1_3_and_1_4_hold_from_set_to_set", LEFT, |trial| {
        problems(PaperRule::LeftEndpoint, 1400).between_sets(trial)
    }),
    Homogeneous.check("theorems_1_1_and_1_2_are_homogeneous", TRAPEZOIDAL, |trial| {
        problems(PaperRule::Trapezoidal, 1500).homogeneous(trial)
    }),
    Homogeneous.check("theorems_1_3_and_1_4_are_homogeneous", LEFT, |trial| {
        problems(PaperRule::LeftEndpoint, 1600).homogeneous(trial)
    }),
];

/// Evaluates both theorems of a rule and the constants in them on one minimiser: the gap between
/// the energies, the excess of the squared length, `K̄` and `C`.
pub(crate) fn of_minimiser<const D: usize>(
    subject: &Subject,
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

/// Evaluates [`of_minimiser`] on random problems.
#[derive(Clone, Copy)]
struct PaperTheorems;

fn problems(rule: PaperRule, seed: u64) -> Problems<PaperTheorems> {
    Problems { rule, seed, one_in: 1, question: PaperTheorems }
}

impl Question for PaperTheorems {
    fn evidence<M: Bounded<D>, const D: usize>(
        self,
        subject: &Subject,
        _: &Known<M, D>,
        seen: &Reconstruction<D>,
    ) -> Result<Vec<Evidence>, VerifyError> {
        Ok(of_minimiser(subject, seen).to_vec())
    }
}
