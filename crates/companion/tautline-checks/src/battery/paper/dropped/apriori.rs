//! Propositions 7.10 to 7.12, `K_{1,g}` and `K_{2,g}`, each without one of its hypotheses.

use std::f64::consts::TAU;

use nalgebra::{SMatrix, SVector};
use tautline::{Constants, gallery::Constant};
use tautline_statements::{
    LIBRARY,
    Statement::{self, ConstantK1, ConstantK2, Proposition7_10, Proposition7_11, Proposition7_12},
    VerifyError, WithConstants, constant_k1, constant_k2,
    curves::SmoothCurve,
    prop_7_10, prop_7_11, prop_7_12,
    witnesses::{Incline, InclineGeodesic},
};

use crate::battery::{
    cases::clauses::{ABOVE, BELOW, LIPSCHITZ},
    harness::{Check, Dropped, Outcome, Trial, all, fails_without, holds_without},
};

const POINTWISE: &[Statement] = &[Proposition7_10, Proposition7_11];
const SPEED: &str = "|g(γ̇, γ̇) − d²| = 0";
const EQUATION: &str = "|γ̈ + Γ(γ̇, γ̇)| = 0";

pub(crate) const CHECKS: &[Check] = &[
    Dropped.check("props_7_10_and_7_11_fail_with_false_constants", POINTWISE, false_constants),
    Dropped.check("k1_fails_without_its_hypotheses", &[ConstantK1], speed),
    Dropped.check("k2_fails_without_its_hypotheses", &[ConstantK2], bend),
    Dropped.check("prop_7_12_fails_without_its_hypotheses", &[Proposition7_12], dropped_minimality),
];

/// Returns the incline `H = foot + x` with constants that are only claimed.
fn incline(foot: f64, [c1, c2, l_h]: [f64; 3]) -> WithConstants<Incline> {
    let metric = Incline::new(foot, 1.0).expect("positive");
    WithConstants { metric, constants: Constants::new(c1, c2, l_h).expect("in order") }
}

/// Returns the metric `H = I` with a claimed `c₁` and with `L_H = 0`.
fn flat<const D: usize>(c1: f64) -> WithConstants<Constant<D>> {
    let metric = Constant::new(SMatrix::identity()).expect("positive definite");
    WithConstants { metric, constants: Constants::new(c1, c1.max(2.0), 0.0).expect("in order") }
}

/// The derivative is 1 where `L_H = ¼` is claimed, and `Γ = 1/2H` exceeds `3/2c₁` where 9 times the
/// true `c₁` is claimed. The bound on derivatives needs only `L_H`, and the bound on `Γ` does not
/// need `c₂`.
fn false_constants(_: &Trial<'_>) -> Outcome {
    let origin = SVector::from([0.0]);
    let derivatives = |foot, constants| {
        prop_7_10(&LIBRARY, &incline(foot, constants), &origin).map_err(VerifyError::from)
    };
    let symbols = |foot, constants| {
        prop_7_11(&LIBRARY, &incline(foot, constants), &origin).map_err(VerifyError::from)
    };
    all([
        fails_without(&[LIPSCHITZ], derivatives(1.0, [1.0, 10.0, 0.25])?),
        fails_without(&[LIPSCHITZ], symbols(1.0, [1.0, 10.0, 0.25])?),
        fails_without(&[BELOW], symbols(1.0 / 9.0, [1.0, 10.0, 1.0])?),
        holds_without(&[BELOW], derivatives(1.0 / 9.0, [1.0, 10.0, 1.0])?),
        holds_without(&[ABOVE], derivatives(1.0, [0.5, 0.75, 1.0])?),
        holds_without(&[ABOVE], symbols(1.0, [0.5, 0.75, 1.0])?),
    ])
}

/// Returns a full circle run through at speed 1. It is curved, so it is no geodesic of the plane.
fn circle() -> SmoothCurve<2> {
    let r = 1.0 / TAU;
    let [cos, sin] = [[r, 0.0], [0.0, r]].map(SVector::from);
    SmoothCurve::new(Vec::new(), vec![[SVector::zeros(); 2], [cos, sin]])
}

/// The counterexample is a line of length 1 for which `d = ½` or `c₁ = 4` is claimed. The bound
/// follows from the speed alone, so that a circle can replace the geodesic. `L_H` and `c₂` do not
/// occur in the bound.
fn speed(_: &Trial<'_>) -> Outcome {
    let line = SmoothCurve::straight([0.0], [1.0]);
    let short = InclineGeodesic::new(1.0, 1.0, 0.5)?;
    let of =
        |constants| constant_k1(&LIBRARY, &incline(1.0, constants), &short, short.distance(), 0.0);
    all([
        fails_without(&[SPEED], constant_k1(&LIBRARY, &flat(1.0), &line, 0.5, 0.0)?),
        fails_without(&[BELOW], constant_k1(&LIBRARY, &flat(4.0), &line, 1.0, 0.0)?),
        holds_without(&[EQUATION], constant_k1(&LIBRARY, &flat(1.0), &circle(), 1.0, 0.3)?),
        holds_without(&[ABOVE], of([0.5, 0.75, 1.0])?),
    ])
}

/// On a short geodesic up an incline, `|γ̈|` is nearly `L_H d²/2c₁²`, which is a third of
/// `K_{2,g}`. Half of `d` lowers the bound to a quarter, four times `c₁` lowers it to a sixteenth,
/// and a hundredth of `L_H` lowers it to a hundredth. The other counterexample is a circle, where
/// `H` is constant and `K_{2,g} = 0`. `c₂` does not occur in the bound.
fn bend(_: &Trial<'_>) -> Outcome {
    let short = InclineGeodesic::new(1.0, 1.0, 2e-3)?;
    let of = |constants, part: f64| {
        constant_k2(&LIBRARY, &incline(1.0, constants), &short, part * short.distance(), 0.0)
    };
    all([
        fails_without(&[SPEED], of([1.0, 2.0, 1.0], 0.5)?),
        fails_without(&[BELOW], of([4.0, 4.0, 1.0], 1.0)?),
        fails_without(&[LIPSCHITZ], of([1.0, 2.0, 0.01], 1.0)?),
        fails_without(&[EQUATION], constant_k2(&LIBRARY, &flat(1.0), &circle(), 1.0, 0.3)?),
        holds_without(&[ABOVE], of([0.5, 0.75, 1.0], 1.0)?),
    ])
}

/// Minimality is dropped by a wave, which is longer than the straight line and has `γ̈ ≠ 0`. With a
/// false `c₁` or `L_H`, minimal geodesics are faster and bend more than these constants allow. `c₂`
/// is not needed.
fn dropped_minimality(_: &Trial<'_>) -> Outcome {
    let wave = SmoothCurve::new(
        vec![SVector::from([0.0]), SVector::from([1.0])],
        vec![[SVector::from([0.0]), SVector::from([0.2])]],
    );
    let line = SmoothCurve::straight([0.0], [1.0]);
    let bent = InclineGeodesic::new(1.0, 1.0, 1.0)?;
    let of = |constants| prop_7_12(&LIBRARY, &incline(1.0, constants), &bent, bent.distance());
    all([
        fails_without(&["E(γ) ≤ d²"], prop_7_12(&LIBRARY, &flat(1.0), &wave, 1.0)?),
        fails_without(&[BELOW], prop_7_12(&LIBRARY, &flat(4.0), &line, 1.0)?),
        fails_without(&[LIPSCHITZ], of([1.0, 2.0, 0.01])?),
        holds_without(&[ABOVE], of([0.5, 0.75, 1.0])?),
    ])
}
