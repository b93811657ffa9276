//! Lemmas S.2 to S.5, Theorems A to D, and Propositions S.6 and S.8, on random problems with a
//! known distance.

use tautline::Bounded;
use tautline_statements::{
    Evidence, Known, PaperRule, Reconstruction,
    Statement::{
        self, LemmaS2, LemmaS3, LemmaS4, LemmaS5, PropositionS6, PropositionS8, TheoremA, TheoremB,
        TheoremC, TheoremD,
    },
    Subject, VerifyError, least_length_bound, lemma_s_2, lemma_s_3, lemma_s_4, lemma_s_5, prop_s_6,
    prop_s_8, theorem_a, theorem_b, theorem_c, theorem_d,
};

use crate::battery::{
    cases::{Problems, Question},
    harness::{Check, Homogeneous, Random},
};

const TRAPEZOIDAL: &[Statement] = &[
    LemmaS2,
    LemmaS3,
    LemmaS4,
    LemmaS5,
    TheoremA,
    TheoremB,
    TheoremC,
    TheoremD,
    PropositionS6,
    PropositionS8,
];
const LEFT: &[Statement] =
    &[LemmaS2, LemmaS3, LemmaS4, LemmaS5, TheoremA, TheoremC, PropositionS6, PropositionS8];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("theorems_a_to_d_hold_between_points", TRAPEZOIDAL, |trial| {
        problems(PaperRule::Trapezoidal, 2100).between_points(trial)
    }),
    Random.check("theorems_a_to_d_hold_from_set_to_set", TRAPEZOIDAL, |trial| {
        problems(PaperRule::Trapezoidal, 2200).between_sets(trial)
    }),
    Random.check("theorems_a_and_c_hold_between_points", LEFT, |trial| {
        problems(PaperRule::LeftEndpoint, 2300).between_points(trial)
    }),
    Random.check("theorems_a_and_c_hold_from_set_to_set", LEFT, |trial| {
        problems(PaperRule::LeftEndpoint, 2400).between_sets(trial)
    }),
    Random.check("theorems_a_to_d_hold_with_constants_of_a_ball", TRAPEZOIDAL, |trial| {
        problems(PaperRule::Trapezoidal, 2700).on_balls(trial)
    }),
    Random.check("theorems_a_and_c_hold_with_constants_of_a_ball", LEFT, |trial| {
        problems(PaperRule::LeftEndpoint, 2750).on_balls(trial)
    }),
    Homogeneous.check("theorems_a_to_d_are_homogeneous", TRAPEZOIDAL, |trial| {
        problems(PaperRule::Trapezoidal, 2500).homogeneous(trial)
    }),
    Homogeneous.check("theorems_a_and_c_are_homogeneous", LEFT, |trial| {
        problems(PaperRule::LeftEndpoint, 2600).homogeneous(trial)
    }),
];

/// Evaluates the sharper statements about one minimiser and its problem.
#[derive(Clone, Copy)]
struct SharperTheorems;

fn problems(rule: PaperRule, seed: u64) -> Problems<SharperTheorems> {
    Problems { rule, seed, one_in: 2, question: SharperTheorems }
}

impl Question for SharperTheorems {
    fn evidence<M: Bounded<D>, const D: usize>(
        self,
        subject: &Subject,
        known: &Known<M, D>,
        seen: &Reconstruction<D>,
    ) -> Result<Vec<Evidence>, VerifyError> {
        let sequence = &seen.minimum.sequence;
        let mut found = vec![
            lemma_s_2(subject, &known.metric, sequence)?,
            lemma_s_3(subject, &known.metric, seen.rule, sequence)?,
            lemma_s_4(subject, seen),
            theorem_a(subject, seen),
            theorem_c(subject, seen),
            prop_s_6(subject, seen, 0.0)?,
            prop_s_8(subject, known, seen)?,
            least_length_bound(subject, seen),
        ];
        // If the ends touch, there is no speed to compare with.
        if seen.distance_squared > 0.0 {
            found.push(lemma_s_5(subject, seen));
        }
        found.extend(theorem_b(subject, seen));
        found.extend(theorem_d(subject, seen));
        Ok(found)
    }
}
