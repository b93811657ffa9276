//! Propositions 7.5 and 7.8: the two algebraic lemmas.

use std::fmt::Debug;

use nalgebra::{SMatrix, SVector};
use proptest::{collection::vec, prelude::*};
use tautline::{Bounded, gallery::Valleys};
use tautline_statements::{
    Evidence,
    Statement::{self, Proposition7_5, Proposition7_8},
    TwoForms, prop_7_5, prop_7_5_as_printed, prop_7_8,
};

use super::{
    Check, Kind, Outcome, Trial,
    check::all,
    failing::{fails_without, refuted},
};
use crate::{
    arbitrary::{AnyTwoForms, Nonnegatives},
    strategies::{separable, shear, vector},
};

const P75: &[Statement] = &[Proposition7_5];
const P78: &[Statement] = &[Proposition7_8];

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new("prop_7_5_holds_for_random_metrics", Kind::Random, P75, metrics),
        Check::new("prop_7_5_holds_for_random_matrices", Kind::Random, P75, matrices),
        Check::new("prop_7_5_is_homogeneous", Kind::Homogeneous, P75, homogeneous_forms),
        Check::new("prop_7_5_is_attained_by_all_three_terms", Kind::Witness, P75, attained_forms),
        Check::new("prop_7_5_fails_without_its_hypotheses", Kind::Dropped, P75, |_| {
            dropped_forms()
        }),
        Check::new("prop_7_5_refuted_by_a_negative_form", Kind::Refuted, P75, |_| {
            refuted_by_a_negative_form()
        }),
        Check::new("prop_7_8_holds_for_random_numbers", Kind::Random, P78, numbers),
        Check::new("prop_7_8_is_homogeneous", Kind::Homogeneous, P78, homogeneous_numbers),
        Check::new("prop_7_8_is_attained_by_one_number", Kind::Witness, P78, attained_numbers),
        Check::new("prop_7_8_holds_for_negative_numbers_too", Kind::Random, P78, negative_numbers),
    ]
}

fn metrics(trial: &Trial<'_>) -> Outcome {
    fn family<M: Bounded<D> + Debug + 'static, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        metrics: impl Strategy<Value = M>,
    ) -> Outcome {
        let pair = |size| (vector::<D>(size), vector::<D>(size));
        let cases = (metrics, pair(3.0), pair(2.0));
        trial.for_all(seed, 256, cases, |subject, (metric, (x1, x2), (u1, u2))| {
            Ok([prop_7_5(&TwoForms::of(subject, &metric, [x1, x2], [u1, u2])?)])
        })
    }
    all([
        family(trial, 7501, shear()),
        family(trial, 7502, separable::<1>()),
        family(trial, 7503, separable::<3>()),
        family::<_, 2>(trial, 7504, Just(Valleys)),
    ])
}

fn matrices(trial: &Trial<'_>) -> Outcome {
    all([
        trial.quick(7511, 512, |_, any: &AnyTwoForms<1>| Ok([prop_7_5(&any.forms())])),
        trial.quick(7512, 512, |_, any: &AnyTwoForms<2>| Ok([prop_7_5(&any.forms())])),
        trial.quick(7513, 512, |_, any: &AnyTwoForms<3>| Ok([prop_7_5(&any.forms())])),
    ])
}

fn homogeneous_forms(trial: &Trial<'_>) -> Outcome {
    let pair = |size| (vector::<2>(size), vector::<2>(size));
    let cases = (shear(), pair(3.0), pair(2.0));
    trial.homogeneous(7520, 128, cases, |subject, (metric, (x1, x2), (u1, u2)), units| {
        let forms = TwoForms::of(subject, &metric, [x1, x2], [u1, u2])?;
        Ok([prop_7_5(&forms.in_units(units)?)])
    })
}

/// The data in dimension 1.
fn on_the_line(x: [f64; 2], u: [f64; 2], h: [f64; 2], c2: f64, l_h: f64) -> TwoForms<1> {
    let [points, vectors] = [x, u].map(|pair| pair.map(|number| SVector::from([number])));
    TwoForms { points, vectors, matrices: h.map(SMatrix::from_diagonal_element), c2, l_h }
}

/// `H(x₂) = c₂`, `H(x₁) = c₂ − L_H |x₁ − x₂|` and `u₂ > u₁ > 0`: both sides are
/// `c₂ (u₂² − u₁²) + L_H |x₁ − x₂| u₁²`, and none of the three terms on the right is less than a
/// hundredth of the whole.
fn attained_forms(trial: &Trial<'_>) -> Outcome {
    let cases = (0.5..4.0, 0.3..1.0, 0.5..2.0, 0.5..2.0, -3.0..3.0);
    trial.for_all(7530, 256, cases, |_, (c2, drop, u1, more, x)| {
        let step = 0.5;
        let forms =
            on_the_line([x + step, x], [u1, u1 + more], [c2 - drop * c2, c2], c2, drop * c2 / step);
        Ok([prop_7_5(&forms).overestimates_at_most(1.0 + 1e-9)?])
    })
}

/// Each hypothesis fails alone, and the conclusion with it: a negative form, a form above `c₂`, and
/// a jump.
fn dropped_forms() -> Outcome {
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

/// `H = −2 ≤ 1 = c₂`, `u₁ = 0` and `u₂ = 1`: `2 ≤ 1` is false.
fn refuted_by_a_negative_form() -> Outcome {
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

/// Equality exactly if all numbers are 0, or all but one, which is positive: two equal numbers
/// already have the overestimation `√2`.
fn attained_numbers(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7830, 256, (1..40_usize, 0..40_usize, 0.1..10.0), |_, (n, k, x)| {
        let mut numbers = vec![0.0; n];
        numbers[k % n] = x;
        let one = prop_7_8(&numbers).overestimates_at_most(1.0 + 1e-9)?;
        let two = prop_7_8(&[x, x]).overestimates_at_most(2_f64.sqrt() * (1.0 + 1e-9))?;
        Ok([one, two, prop_7_8(&vec![0.0; n])])
    })
}

/// No counterexample is there to be found without `xₙ ≥ 0`: turning a sign makes the left side
/// smaller and leaves the right side, so that the hypothesis is not needed. Only the case of
/// equality is lost: `−1` alone has `−1 < 1`.
fn negative_numbers(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7840, 512, vec(-10.0..10.0_f64, 0..40), |_, numbers| {
        let evidence = prop_7_8(&numbers);
        // The conclusions alone.
        Ok([Evidence { hypotheses: Vec::new(), ..evidence }])
    })
}
