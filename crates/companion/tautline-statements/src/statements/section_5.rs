//! Section 5: over the valleys, from `(0, 0)` to `(4π, 0)`, the discrete lengths have the minimum
//! `4π` for every `N`, but the distance is `8π`.

use std::f64::consts::PI;

use nalgebra::SVector;
use tautline::{PointSequence, Rule, gallery::Valleys};

use crate::{Evidence, Statement, Subject, Unit, Units, VerifyError, witnesses::valley_jump};

/// Evaluates the claim of Section 5 on the left-endpoint rule, for a sequence from `(0, 0)` to
/// `(4π, 0)`; the sequence and the resulting numbers are in `units`.
///
/// ```text
/// 4π ≤ L_l,N(γᵖ),    L_l,N(γ*) ≤ 4π for a γ* of the same N,    8π ≤ L(γᵖˡ),    d ≤ 8π
/// ```
///
/// `γ*` stops in the valley at `2π`. The distance is at most the length of a straight line.
///
/// # Errors
///
/// If coordinates overflow in these units.
#[doc(alias = "eq:length-left-point-min")]
pub fn section_5_left(
    subject: &Subject,
    units: Units,
    sequence: &PointSequence<2>,
) -> Result<Evidence, VerifyError> {
    let n = sequence.n().get();
    let claims = ["4π ≤ L_l,N(γᵖ)", "min L_l,N ≤ 4π"];
    let minimiser = valley_jump(n, n.div_ceil(2), n);
    let begun = Evidence::of(Statement::Section5Left);
    evaluate(begun, subject, Rule::LEFT_ENDPOINT, units, [sequence, &minimiser], claims)
}

/// Evaluates the claim of Section 5 on the trapezoidal rule, as [`section_5_left`] does.
///
/// Here `γ*` jumps over both ridges at once, since the rule evaluates `H` in the valley between
/// them.
///
/// # Errors
///
/// If coordinates overflow in these units.
#[doc(alias = "eq:length-tra-point-min")]
pub fn section_5_trapezoidal(
    subject: &Subject,
    units: Units,
    sequence: &PointSequence<2>,
) -> Result<Evidence, VerifyError> {
    let n = sequence.n().get();
    let claims = ["4π ≤ L_tra,N(γᵖ)", "min L_tra,N ≤ 4π"];
    let minimiser = valley_jump(n, n.div_ceil(2), n.div_ceil(2));
    let begun = Evidence::of(Statement::Section5Trapezoidal);
    evaluate(begun, subject, Rule::TRAPEZOIDAL, units, [sequence, &minimiser], claims)
}

fn evaluate(
    evidence: Evidence,
    subject: &Subject,
    rule: Rule,
    units: Units,
    [sequence, minimiser]: [&PointSequence<2>; 2],
    [above, attained]: [&'static str; 2],
) -> Result<Evidence, VerifyError> {
    let metric = units.metric(Valleys);
    let ends = [0.0, 4.0 * PI].map(|x1| units.vector(SVector::from([x1, 0.0])));
    let off = [sequence.first() - ends[0], sequence.last() - ends[1]].map(|x| x.norm());
    let length = subject.discrete_length(rule, &metric, sequence);
    let least = subject.discrete_length(rule, &metric, &units.sequence(minimiser)?);
    let curve = subject.curve_length(&metric, sequence);
    let line = PointSequence::straight(ends[0], ends[1], 1)?;
    let line = subject.curve_length(&metric, &line);
    let [four, eight] = [4.0, 8.0].map(|k| k * PI * units.m);
    // 4π is rounded. A length is a compensated sum of positive terms, with a dozen roundings per
    // chord.
    let granted = |length: f64| 1e-14 * (eight + length);
    let off_curve = granted(curve.value) + curve.error;
    Ok(evidence
        .given("γᵖ begins at (0, 0)", Unit::COORDINATE, [off[0], 0.0], 0.0)
        .given("γᵖ ends at (4π, 0)", Unit::COORDINATE, [off[1], 0.0], 1e-14 * units.ell)
        .stated(above, Unit::LENGTH, [four, length], granted(length))
        .stated(attained, Unit::LENGTH, [least, four], granted(least))
        .stated("8π ≤ L(γᵖˡ)", Unit::LENGTH, [eight, curve.value], off_curve)
        .stated("d ≤ 8π", Unit::LENGTH, [line.value, eight], granted(eight) + line.error))
}
