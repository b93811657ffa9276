//! Propositions 7.5 and 7.8: the two algebraic lemmas.

use nalgebra::{SMatrix, SVector};
use proptest::{collection::vec, prelude::*};
use tautline::gallery::Valleys;
use tautline_statements::{
    Evidence,
    Statement::{self, Proposition7_5, Proposition7_8},
    TwoForms, prop_7_5, prop_7_5_as_printed, prop_7_8,
};

use crate::battery::harness::{
    Check, Dropped, Homogeneous, Outcome, Random, Refuted, Trial, Witness, all, fails_without,
    for_all, refuted,
};
use crate::{
    arbitrary::{AnyTwoForms, Nonnegatives},
    strategies::{separable, shear, vector},
};

const P75: &[Statement] = &[Proposition7_5];
const P78: &[Statement] = &[Proposition7_8];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("prop_7_5_holds_for_random_metrics", P75, metrics),
    Random.check("prop_7_5_holds_for_random_matrices", P75, matrices),
    Homogeneous.check("prop_7_5_is_homogeneous", P75, homogeneous_forms),
    Witness.check("prop_7_5_is_attained_by_all_three_terms", P75, attained_forms),
    Dropped.check("prop_7_5_fails_without_its_hypotheses", P75, dropped_forms),
    Refuted.check("prop_7_5_refuted_by_a_negative_form", P75, refuted_by_a_negative_form),
    Random.check("prop_7_8_holds_for_random_numbers", P78, numbers),
    Homogeneous.check("prop_7_8_is_homogeneous", P78, homogeneous_numbers),
    Witness.check("prop_7_8_is_attained_by_one_number", P78, attained_numbers),
    Random.check("prop_7_8_holds_for_negative_numbers_too", P78, negative_numbers),
];

fn metrics(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        256,
        [
            (7501, (shear(), two_vectors(3.0), two_vectors(2.0))),
            (7502, (separable::<1>(), two_vectors(3.0), two_vectors(2.0))),
            (7503, (separable::<3>(), two_vectors(3.0), two_vectors(2.0))),
            (7504, (Just(Valleys), two_vectors::<2>(3.0), two_vectors(2.0))),
        ],
        |subject, (metric, (x1, x2), (u1, u2))| {
            Ok([prop_7_5(&TwoForms::of(subject, &metric, [x1, x2], [u1, u2])?)])
        }
    )
}

fn two_vectors<const D: usize>(
    size: f64,
) -> impl Strategy<Value = (SVector<f64, D>, SVector<f64, D>)> {
    (vector(size), vector(size))
}

fn matrices(trial: &Trial<'_>) -> Outcome {
    all([
        trial.quick(7511, 512, |_, any: &AnyTwoForms<1>| Ok([prop_7_5(&any.forms())])),
        trial.quick(7512, 512, |_, any: &AnyTwoForms<2>| Ok([prop_7_5(&any.forms())])),
        trial.quick(7513, 512, |_, any: &AnyTwoForms<3>| Ok([prop_7_5(&any.forms())])),
    ])
}

fn homogeneous_forms(trial: &Trial<'_>) -> Outcome {
    let cases = (shear(), two_vectors::<2>(3.0), two_vectors(2.0));
    trial.homogeneous(7520, 128, cases, |subject, (metric, (x1, x2), (u1, u2)), units| {
        let forms = TwoForms::of(subject, &metric, [x1, x2], [u1, u2])?;
        Ok([prop_7_5(&forms.in_units(units)?)])
    })
}

/// Returns the data in dimension 1.
fn on_the_line(x: [f64; 2], u: [f64; 2], h: [f64; 2], c2: f64, l_h: f64) -> TwoForms<1> {
    let [points, vectors] = [x, u].map(|pair| pair.map(|number| SVector::from([number])));
    TwoForms { points, vectors, matrices: h.map(SMatrix::from_diagonal_element), c2, l_h }
}

/// With `H(x₂) = c₂`, `H(x₁) = c₂ − L_H |x₁ − x₂|` and `u₂ > u₁ > 0`, both sides are
/// `c₂ (u₂² − u₁²) + L_H |x₁ − x₂| u₁²`. Each of the three terms on the right is at least a
/// hundredth of the total.
fn attained_forms(trial: &Trial<'_>) -> Outcome {
    let cases = (0.5..4.0, 0.3..1.0, 0.5..2.0, 0.5..2.0, -3.0..3.0);
    trial.for_all(7530, 256, cases, |_, (c2, drop, u1, more, x)| {
        let step = 0.5;
        let forms =
            on_the_line([x + step, x], [u1, u1 + more], [c2 - drop * c2, c2], c2, drop * c2 / step);
        Ok([prop_7_5(&forms).overestimates_at_most(1.0 + 1e-9)?])
    })
}

/// Each hypothesis is violated alone, and then the conclusion fails: by a negative form, by a form
/// above `c₂`, and by a jump.
fn dropped_forms(_: &Trial<'_>) -> Outcome {
    all([
        fails_without(
            &["0 ≤ λ_min(H(x₂))"],
            prop_7_5(&on_the_line([0.0, 0.0], [0.0, 1.0], [-2.0, -2.0], 1.0, 0.0)),
        ),
        fails_without(
            &["λ_max(H(x₂)) ≤ c₂"],
            prop_7_5(&on_the_line([0.0, 0.0], [0.0, 1.0], [3.0, 3.0], 1.0, 0.0)),
        ),
        fails_without(
            &["‖H(x₁) − H(x₂)‖ ≤ L_H |x₁ − x₂|"],
            prop_7_5(&on_the_line([0.0, 1.0], [1.0, 1.0], [1.0, 0.0], 1.0, 0.5)),
        ),
    ])
}

/// With `H = −2 ≤ 1 = c₂`, `u₁ = 0` and `u₂ = 1`, the claim `2 ≤ 1` is false.
fn refuted_by_a_negative_form(_: &Trial<'_>) -> Outcome {
    let forms = on_the_line([0.0, 0.0], [0.0, 1.0], [-2.0, -2.0], 1.0, 0.0);
    refuted(
        &prop_7_5_as_printed(&forms),
        "|u₁ᵀH(x₁)u₁ − u₂ᵀH(x₂)u₂| ≤ L_H|x₁ − x₂||u₁|² + c₂|u₁ − u₂|² + 2c₂|u₁||u₁ − u₂|",
        [2.0, 1.0],
    )
}

fn numbers(trial: &Trial<'_>) -> Outcome {
    all([
        trial.quick(7801, 768, |_, any: &Nonnegatives| Ok([prop_7_8(&any.numbers())])),
        trial.for_all(7802, 512, vec(0.0..10.0, 0..40), |_, numbers| Ok([prop_7_8(&numbers)])),
    ])
}

fn homogeneous_numbers(trial: &Trial<'_>) -> Outcome {
    trial.homogeneous(7820, 128, vec(0.0..10.0, 0..40), |_, numbers, units| {
        let numbers: Vec<f64> = numbers.into_iter().map(|x| x * units.ell).collect();
        Ok([prop_7_8(&numbers)])
    })
}

/// Equality holds exactly if all numbers are 0, or if all are 0 but one positive number. Two equal
/// numbers already have the overestimation `√2`.
fn attained_numbers(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7830, 256, (1..40_usize, 0..40_usize, 0.1..10.0), |_, (n, k, x)| {
        let mut numbers = vec![0.0; n];
        numbers[k % n] = x;
        let one = prop_7_8(&numbers).overestimates_at_most(1.0 + 1e-9)?;
        let two = prop_7_8(&[x, x]).overestimates_at_most(2_f64.sqrt() * (1.0 + 1e-9))?;
        Ok([one, two, prop_7_8(&vec![0.0; n])])
    })
}

/// The hypothesis `xₙ ≥ 0` is not needed: flipping a sign lowers the left side and does not change
/// the right side. Only the case of equality is lost, since the single number `−1` gives `−1 < 1`.
fn negative_numbers(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7840, 512, vec(-10.0..10.0_f64, 0..40), |_, numbers| {
        let evidence = prop_7_8(&numbers);
        // Only the conclusions are kept.
        Ok([Evidence { hypotheses: Vec::new(), ..evidence }])
    })
}
