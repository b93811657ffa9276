//! The counterexamples to statements that are false as printed, evaluated on the printed form.

use std::num::NonZeroUsize;

use nalgebra::{SMatrix, SVector};
use tautline::gallery::Constant;

use crate::{
    Evidence, Known, LIBRARY, Statement, VerifyError,
    curves::{Clock, Geodesic, KinkedCurve, Measured, Pace, Reparametrised, SmoothCurve},
    statements::{
        TwoForms, prop_7_2_as_printed, prop_7_3_as_printed, prop_7_4, prop_7_5_as_printed,
        prop_7_6_as_printed, prop_7_7, prop_9_1_as_printed,
    },
    witnesses::{Polygonal, tent},
};

type Refuted = Result<Evidence, VerifyError>;

/// Evaluates Proposition 7.2 as printed for `γ = 1` on `[0, 1/4]`.
pub(crate) fn still_curve() -> Refuted {
    let still = SmoothCurve::polynomial([SVector::from([1.0])]);
    prop_7_2_as_printed(&still, [0.0, 0.125, 0.25])
}

/// Evaluates Proposition 7.3 as printed for `γ(t) = t` on `[0, 1/4]`.
pub(crate) fn straight_line() -> Refuted {
    prop_7_3_as_printed(&SmoothCurve::straight([0.0], [1.0]), [0.0, 0.25])
}

/// Evaluates Proposition 7.4 for `γ(t) = |t − ½|` and one chord.
pub(crate) fn kink() -> Refuted {
    prop_7_4(&modulus()?, NonZeroUsize::MIN, 0, 0.0)
}

/// Evaluates Proposition 7.5 as printed for `H = −2` in one dimension.
pub(crate) fn negative_form() -> Refuted {
    Ok(prop_7_5_as_printed(&TwoForms {
        points: [SVector::from([0.0]); 2],
        vectors: [SVector::from([0.0]), SVector::from([1.0])],
        matrices: [SMatrix::from_diagonal_element(-2.0); 2],
        c2: 1.0,
        l_h: 0.0,
    }))
}

/// Evaluates Proposition 7.6 as printed for `γ(t) = |t − ½|`, `H = 1` and one chord.
pub(crate) fn kink_between_samples() -> Refuted {
    prop_7_6_as_printed(&LIBRARY, &flat()?, &modulus()?, [1.0, 0.1], NonZeroUsize::MIN)
}

/// Evaluates Proposition 7.7 for a curve that reaches its end at the time `1/17`.
pub(crate) fn fast_start() -> Refuted {
    let seventeen = NonZeroUsize::MIN.saturating_add(16);
    let end = (1.0 / 17.0, SVector::from([1.0]));
    let curve = KinkedCurve::new([0.0], [end], [1.0])?;
    prop_7_7(&LIBRARY, &ridge()?, &[curve], seventeen)
}

/// Evaluates Proposition 9.1 as printed for a straight line that starts from rest.
pub(crate) fn late_minimiser() -> Refuted {
    let metric = flat()?;
    let ends = [SVector::from([0.0]), SVector::from([1.0])];
    let on_time = Geodesic::between(metric, ends);
    let clock = Clock::plain(Pace::Accelerating);
    let late = Reparametrised { curve: &on_time, clock: &clock };
    let known = Known::joined(metric, ends)?
        .ok_or(VerifyError::NotRefuted { statement: Statement::Proposition9_1 })?;
    let [on_time, late] = [Measured::of(&metric, &on_time), Measured::of(&metric, &late)];
    Ok(prop_9_1_as_printed(&LIBRARY, &known, &on_time, &late))
}

/// Returns the metric `H = 1`.
fn flat() -> Result<Constant<1>, VerifyError> {
    Ok(Constant::new(SMatrix::from_diagonal_element(1.0))?)
}

/// Returns the curve `|t − ½|`.
fn modulus() -> Result<KinkedCurve<1>, VerifyError> {
    KinkedCurve::new([0.5], [(0.5, [0.0].into())], [0.5])
}

/// Returns the metric `H = 2 − 3/2 |x − ½|` on `[0, 1]`.
fn ridge() -> Result<Polygonal, VerifyError> {
    let slope = -1.5;
    let range = VerifyError::OutOfRange { name: "slope", value: slope, low: -4.0, high: 4.0 };
    tent(2.0, slope).ok_or(range)
}
