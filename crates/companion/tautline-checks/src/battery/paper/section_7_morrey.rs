//! Propositions 7.2 to 7.4: curves, their velocities and their means.

use std::num::NonZeroUsize;

use proptest::prelude::*;
use tautline::SVector;
use tautline_statements::{
    Evidence,
    Statement::{self, Proposition7_2, Proposition7_3, Proposition7_4},
    VerifyError,
    curves::{BoundedCurve, KinkedCurve, SmoothCurve},
    prop_7_2, prop_7_2_as_printed, prop_7_3, prop_7_3_as_printed, prop_7_4,
};

use crate::battery::harness::{
    Check, Dropped, Homogeneous, Outcome, Random, Refuted, Trial, Witness, all, fails_without,
    for_all, refuted,
};
use crate::strategies::{kinked_curve, smooth_curve, times};

const ALL: &[Statement] = &[Proposition7_2, Proposition7_3, Proposition7_4];

const P72: &[Statement] = &[Proposition7_2];
const P73: &[Statement] = &[Proposition7_3];
const P74: &[Statement] = &[Proposition7_4];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("props_7_2_to_7_4_hold_for_smooth_curves", ALL, smooth),
    Random.check("prop_7_2_holds_for_kinked_curves", P72, kinked),
    Homogeneous.check("props_7_2_to_7_4_are_homogeneous", ALL, homogeneous),
    Witness.check("prop_7_2_is_attained_by_constant_velocity", P72, constant_velocity),
    Witness.check("the_constants_of_prop_7_2_are_the_best", P72, best_constants_of_7_2),
    Refuted.check(
        "the_second_inequality_of_prop_7_2_refuted_by_a_constant_curve",
        P72,
        refuted_by_a_constant_curve,
    ),
    Witness.check("prop_7_3_is_attained_by_constant_velocity", P73, attained_7_3),
    Witness.check("the_constant_of_prop_7_3_is_the_best", P73, best_constant_of_7_3),
    Refuted.check("prop_7_3_refuted_by_constant_velocity", P73, refuted_by_constant_velocity),
    Dropped.check("prop_7_3_fails_for_a_kink", P73, kink_of_7_3),
    Witness.check("the_sharp_form_of_prop_7_4_is_attained_by_a_cube", P74, attained_by_a_cube),
    Witness.check(
        "the_mean_square_form_of_prop_7_4_is_attained_by_half_a_cosine",
        P74,
        attained_by_half_a_cosine,
    ),
    Refuted.check("prop_7_4_refuted_by_a_kink", P74, kink_of_7_4),
];

/// Evaluates the three statements; the last one uses `θ = s` and `k = ⌊s₁ N⌋`.
fn evidence<const D: usize>(
    curve: &impl BoundedCurve<D>,
    [s1, s, s2]: [f64; 3],
    n: NonZeroUsize,
) -> Result<[Evidence; 3], VerifyError> {
    let k = ((s1 * n.get() as f64) as usize).min(n.get() - 1);
    Ok([prop_7_2(curve, [s1, s, s2])?, prop_7_3(curve, [s1, s2])?, prop_7_4(curve, n, k, s)?])
}

fn subintervals() -> impl Strategy<Value = NonZeroUsize> {
    (1..50_usize).prop_map(|n| NonZeroUsize::new(n).expect("positive"))
}

fn smooth(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        448,
        [
            (7201, (smooth_curve::<1>(2.0), times(), subintervals())),
            (7202, (smooth_curve::<2>(2.0), times(), subintervals())),
            (7203, (smooth_curve::<3>(2.0), times(), subintervals())),
        ],
        // One curve in five is straight, and then Proposition 7.4 states only `0 ≤ 0`.
        |_, (curve, times, n)| evidence(&curve, times, n)
    )
}

fn kinked(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        512,
        [(7211, (kinked_curve::<1>(2.0), times())), (7212, (kinked_curve::<3>(2.0), times())),],
        |_, (curve, times)| Ok([prop_7_2(&curve, times)?])
    )
}

fn homogeneous(trial: &Trial<'_>) -> Outcome {
    let cases = (smooth_curve::<2>(2.0), times(), subintervals());
    trial.homogeneous(7220, 128, cases, |_, (curve, times, n), units| {
        evidence(&units.curve(curve), times, n)
    })
}

/// Draws a straight line and an interval.
fn lines() -> impl Strategy<Value = (SmoothCurve<2>, [f64; 3])> {
    let velocity = [0.2..3.0, -2.0..2.0];
    (velocity, times()).prop_map(|(velocity, times)| {
        (SmoothCurve::straight([0.3, -0.2], SVector::from(velocity)), times)
    })
}

fn constant_velocity(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7230, 256, lines(), |_, (line, times)| {
        let first = "|γ(s₂) − γ(s₁)| ≤ √l ‖γ̇‖";
        Ok([prop_7_2(&line, times)?.claim_is_attained(first, 1.0 + 1e-9)?])
    })
}

/// The curve is `e (1 + ε w)` with `ẇ = (r − 1)/l` and `r = (t − s₁)/l`, so that `w = r²/2 − r`. At
/// `s₁` it exceeds `‖γ‖/√l` by `ε/3 + O(ε²)`, and `√(l/3) ‖γ̇‖ = ε/3`. For a constant curve
/// `|γ| = ‖γ‖/√l`, and the bound is 0, so that the other factor is optimal too.
fn best_constants_of_7_2(trial: &Trial<'_>) -> Outcome {
    let second = "|γ(s)| − ‖γ‖/√l ≤ √(l/3) ‖γ̇‖";
    let intervals = (0.0..0.5_f64, 0.1..1.0_f64);
    trial.for_all(7231, 128, intervals, |_, (s1, length)| {
        let length = length.min(1.0 - s1);
        let (e, epsilon) = (SVector::from([0.6, 0.8]), 1e-3);
        // r = u t − c with u = 1/l and c = s₁/l.
        let (u, c) = (1.0 / length, s1 / length);
        let w = [0.5 * c * c + c, -c * u - u, 0.5 * u * u];
        let bent = SmoothCurve::polynomial([
            e * (1.0 + epsilon * w[0]),
            e * (epsilon * w[1]),
            e * (epsilon * w[2]),
        ]);
        let bent = prop_7_2(&bent, [s1, s1, s1 + length])?.claim_is_attained(second, 1.01)?;
        let still = prop_7_2(&SmoothCurve::polynomial([e]), [s1, s1, s1 + length])?;
        let gap = *still.conclusion(second);
        // The error is two roundings of a number of size 1, plus the error of the quadrature.
        let gap = Evidence::of(Proposition7_2).sharper(
            "‖γ‖/√l ≤ |γ(s)| for a constant curve",
            gap.unit,
            [-gap.observed, 0.0],
            1e-14,
        );
        Ok([bent, still, gap])
    })
}

/// On `[0, ¼]` a constant curve of norm 1 has `‖γ‖ = ½` and `‖γ̇‖ = 0`.
fn refuted_by_a_constant_curve(_: &Trial<'_>) -> Outcome {
    let constant = SmoothCurve::polynomial([SVector::from([1.0])]);
    let evidence = prop_7_2_as_printed(&constant, [0.0, 0.125, 0.25])?;
    refuted(&evidence, "|γ(s)| − ‖γ‖ ≤ 2‖γ̇‖", [0.5, 0.0])
}

fn attained_7_3(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7330, 256, lines(), |_, (line, [s1, _, s2])| {
        Ok([prop_7_3(&line, [s1, s2])?.attained()?])
    })
}

/// The curve has `γ̇ = 1 + ε w` with the `w` used for Proposition 7.2. On a short interval at 0,
/// its mean speed exceeds its norm over `[0, 1]` by `ε/3 − ε l/2`.
fn best_constant_of_7_3(trial: &Trial<'_>) -> Outcome {
    let epsilon = 1e-3;
    let powers = [0.0, 1.0, -0.5 * epsilon, epsilon / 6.0];
    let curve = SmoothCurve::polynomial(powers.map(|power| SVector::from([power])));
    let claim = "|γ(s₂) − γ(s₁)| − l‖γ̇‖₍₀,₁₎ ≤ l‖γ̈‖₍₀,₁₎/√3";
    trial.one([prop_7_3(&curve, [0.0, 1e-3])?.claim_is_attained(claim, 1.01)?])
}

/// For `γ(t) = t` on `[0, ¼]`, the claim `¼ ≤ ⅛` is false.
fn refuted_by_constant_velocity(_: &Trial<'_>) -> Outcome {
    let line = SmoothCurve::straight([0.0], [1.0]);
    let evidence = prop_7_3_as_printed(&line, [0.0, 0.25])?;
    refuted(&evidence, "|γ(s₂) − γ(s₁)| ≤ l (‖γ̇‖ + 2‖γ̈‖)", [0.25, 0.125])
}

/// The curve has `γ̇ = 1/ε` on `[0, ε]` and 0 after that. The claim `1 ≤ √ε` is false on `[0, 1]`
/// and on `[0, ε]`, both as printed and as repaired. Only the first repaired form remains true,
/// since it is Proposition 7.2.
fn kink_of_7_3(_: &Trial<'_>) -> Outcome {
    let epsilon = 1.0 / 16.0;
    let ramp = KinkedCurve::new([0.0], [(epsilon, [1.0].into())], [1.0])?;
    let evidence = prop_7_3(&ramp, [0.0, epsilon])?;
    all([
        fails_without(&["γ̇ does not jump"], evidence),
        // Since γ̈ = 0 almost everywhere, the form for H² agrees with the printed one.
        refuted(
            &prop_7_3_as_printed(&ramp, [0.0, epsilon])?,
            "|γ(s₂) − γ(s₁)| ≤ l (‖γ̇‖ + 2‖γ̈‖)",
            [1.0, 0.25],
        ),
    ])
}

/// For `(tₖ₊₁ − t)³` on the subinterval `k` of `N`, evaluated at `tₖ`, the bound is attained: with
/// `h = 1`, `|−1 + 3| = 2 = ‖γ̈‖/√3`. The paper's bound is `2√3` times as large.
fn attained_by_a_cube(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7430, 128, (subintervals(), 0.0..1.0), |_, (n, at)| {
        let count = n.get() as f64;
        let k = (at * count) as usize;
        // With c = tₖ₊₁, (c − t)³ = c³ − 3c²t + 3ct² − t³.
        let c = (k as f64 + 1.0) / count;
        let powers = [c.powi(3), -3.0 * c * c, 3.0 * c, -1.0];
        let cube = SmoothCurve::polynomial(powers.map(|power| SVector::from([power])));
        let evidence = prop_7_4(&cube, n, k, 0.0)?;
        let evidence = evidence.claim_is_attained("|β − γ̇(t)| ≤ (h/3)^{1/2} ‖γ̈‖", 1.0 + 1e-6)?;
        Ok([evidence.overestimates_at_most(12_f64.sqrt() * (1.0 + 1e-6))?])
    })
}

/// The curve has `γ̇ = cos Nπt`, whose mean over each subinterval is 0.
fn attained_by_half_a_cosine(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7431, 64, (1..12_usize, 0.0..1.0), |_, (n, at)| {
        let mut waves = vec![[SVector::zeros(), SVector::zeros()]; n];
        waves[n - 1][1] = SVector::from([1.0]);
        let sine = SmoothCurve::<1>::new(Vec::new(), waves);
        let k = (at * n as f64) as usize;
        let evidence = prop_7_4(&sine, NonZeroUsize::new(n).expect("positive"), k, 0.5)?;
        Ok([evidence.claim_is_attained("‖γ̇ − β‖² ≤ (h/π)² ‖γ̈‖²", 1.0 + 1e-6)?])
    })
}

/// For `|t − ½|` with `N = 1`, `β = 0`, `γ̇(0) = −1`, and `γ̈ = 0` almost everywhere. Proposition
/// 7.4 would claim `1 ≤ 0` for this curve, although it is piecewise `C¹`, as the proposition
/// assumes.
fn kink_of_7_4(_: &Trial<'_>) -> Outcome {
    let modulus = KinkedCurve::new([0.5], [(0.5, [0.0].into())], [0.5])?;
    let evidence = prop_7_4(&modulus, NonZeroUsize::MIN, 0, 0.0)?;
    let clause = "γ̇ does not jump";
    all([
        fails_without(&[clause], evidence.clone()),
        refuted(&evidence.without(clause), "|β − γ̇(t)| ≤ 2‖γ̈‖/√N", [1.0, 0.0]),
    ])
}
