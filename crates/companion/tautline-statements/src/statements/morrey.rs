//! Propositions 7.2 to 7.4: the distance of a curve and its velocity from their means.
//!
//! The intervals are `[s₁, s₂] ⊂ [0, 1]`, of length `l = s₂ − s₁ > 0`. An inequality with two terms
//! on the right is compared as a gap: the left side minus the first term is compared with the
//! second term.

use std::num::NonZeroUsize;

use nalgebra::SVector;
use tautline::{Integral, bounds::velocity_error, quadrature::integrate};

use crate::{
    Evidence, Statement, Unit, VerifyError,
    curves::{BoundedCurve, l2_norm},
};

/// Returns `value` if it lies in `[low, high]`.
fn within(name: &'static str, value: f64, [low, high]: [f64; 2]) -> Result<f64, VerifyError> {
    if low <= value && value <= high {
        Ok(value)
    } else {
        Err(VerifyError::OutOfRange { name, value, low, high })
    }
}

/// A curve on `[s₁, s₂]`, for Propositions 7.2 and 7.3.
struct Interval<const D: usize> {
    /// `γ(s₂) − γ(s₁)`.
    chord: SVector<f64, D>,
    length: f64,
    /// `‖γ‖`, `‖γ̇‖` and `‖γ̈‖`.
    norms: [Integral; 3],
    /// The rounding of a position, in `ℓ`.
    rounding: f64,
}

impl<const D: usize> Interval<D> {
    fn of(curve: &impl BoundedCurve<D>, [s1, s2]: [f64; 2]) -> Result<Self, VerifyError> {
        within("s₁", s1, [0.0, 1.0])?;
        // On a shorter interval, rounding would dominate.
        within("s₂", s2, [s1 + 1e-6, 1.0])?;
        Ok(Self {
            chord: curve.motion(s2).position - curve.motion(s1).position,
            length: s2 - s1,
            norms: [0, 1, 2].map(|k| l2_norm(curve, k, [s1, s2])),
            // A position is a sum of a dozen terms with a few roundings each. The rounding of t
            // moves γ by ε|γ̇|.
            rounding: f64::EPSILON * (64.0 * curve.suprema()[0] + 4.0 * curve.suprema()[1]),
        })
    }
}

/// Adds the hypothesis that the paper omits: `γ̇` is absolutely continuous, that is,
/// `γ̇(t) − γ̇(s) = ∫ γ̈`. It is checked on each sixteenth of `[0, 1]`, in each coordinate.
pub(super) fn without_kinks<const D: usize>(
    evidence: Evidence,
    curve: &impl BoundedCurve<D>,
) -> Evidence {
    let mut worst = [0.0_f64; 2];
    // A velocity or an acceleration has a dozen terms, with a few roundings each.
    let [_, speed, bend] = curve.suprema();
    let rounding = 64.0 * f64::EPSILON * (speed + bend);
    for k in 0..16 {
        let [from, to] = [k, k + 1].map(|k| f64::from(k) / 16.0);
        let change = curve.motion(to).velocity - curve.motion(from).velocity;
        for i in 0..D {
            let bent = integrate(|t| curve.motion(t).acceleration[i], from, to, 1e-12);
            let found = [(change[i] - bent.value).abs(), bent.error + rounding];
            // This keeps NaN.
            if !(found[0] - found[1] <= worst[0] - worst[1]) {
                worst = found;
            }
        }
    }
    evidence.given("γ̇ does not jump", Unit::COORDINATE, [worst[0], 0.0], worst[1])
}

/// Evaluates Proposition 7.2, with its second inequality repaired, at `0 ≤ s₁ ≤ s ≤ s₂ ≤ 1`.
///
/// ```text
/// |γ(s₂) − γ(s₁)|  ≤  √l ‖γ̇‖,        |γ(s)|  ≤  ‖γ‖/√l + √(l/3) ‖γ̇‖
/// ```
///
/// Equality holds in the first inequality if and only if `γ̇` is constant. It holds in the second
/// for constant curves, and there `√(1/3)` is the best constant. The proposition needs only that
/// `γ` is continuous and piecewise smooth, as every [`Curve`](crate::curves::Curve) is.
///
/// Companion: `γ(s)` is the mean of `γ` plus `(1/l) ∫ k_s γ̇`, where the kernel `k_s` is `r − s₁`
/// before `s` and `r − s₂` after it. Hence `((a³ + (l − a)³)/3)^{1/2}/l`, where `a = s − s₁`, may
/// replace the factor of `‖γ̇‖`. In the middle of the interval, it is half as large.
///
/// # Errors
///
/// [`VerifyError::OutOfRange`] if the times are not in order, or `l < 10⁻⁶`.
#[doc(alias = "prop:morrey_ineq")]
pub fn prop_7_2<const D: usize>(
    curve: &impl BoundedCurve<D>,
    [s1, s, s2]: [f64; 3],
) -> Result<Evidence, VerifyError> {
    let Interval { chord, length, norms: [position, velocity, _], rounding } =
        Interval::of(curve, [s1, s2])?;
    let a = within("s", s, [s1, s2])? - s1;
    let root = length.sqrt();
    let kernel = ((a.powi(3) + (length - a).powi(3)) / 3.0).sqrt() / length;
    let gap = curve.motion(s).position.norm() - position.value / root;
    let far = [chord.norm(), root * velocity.value];
    let plain = [gap, (length / 3.0).sqrt() * velocity.value];
    let sharp = [gap, kernel * velocity.value];
    let sharper = "|γ(s)| − ‖γ‖/√l ≤ ((a³ + (l − a)³)/3)^{1/2} ‖γ̇‖/l";
    let granted = 2.0 * rounding + root * velocity.error;
    let granted_gap = granted + position.error / root;
    Ok(Evidence::of(Statement::Proposition7_2)
        .stated("|γ(s₂) − γ(s₁)| ≤ √l ‖γ̇‖", Unit::COORDINATE, far, granted)
        .stated("|γ(s)| − ‖γ‖/√l ≤ √(l/3) ‖γ̇‖", Unit::COORDINATE, plain, granted_gap)
        .sharper(sharper, Unit::COORDINATE, sharp, granted_gap))
}

/// Evaluates the second inequality of Proposition 7.2 as printed: `|γ(s)| ≤ ‖γ‖ + 2‖γ̇‖`.
///
/// It is false on every interval shorter than 1: for a constant curve the right side is `√l |γ|`.
///
/// # Errors
///
/// The errors of [`prop_7_2`].
pub fn prop_7_2_as_printed<const D: usize>(
    curve: &impl BoundedCurve<D>,
    [s1, s, s2]: [f64; 3],
) -> Result<Evidence, VerifyError> {
    let Interval { norms: [position, velocity, _], rounding, .. } = Interval::of(curve, [s1, s2])?;
    let gap = curve.motion(within("s", s, [s1, s2])?).position.norm() - position.value;
    let granted = rounding + position.error + 2.0 * velocity.error;
    let (claim, numbers) = ("|γ(s)| − ‖γ‖ ≤ 2‖γ̇‖", [gap, 2.0 * velocity.value]);
    Ok(Evidence::of(Statement::Proposition7_2).stated(claim, Unit::COORDINATE, numbers, granted))
}

/// Evaluates Proposition 7.3 in its repaired form on `[s₁, s₂] ⊂ [0, 1]`, with the norms over the
/// interval, and with the norms over `[0, 1]`, as Proposition 7.6 needs them.
///
/// ```text
/// |γ(s₂) − γ(s₁)|  ≤  l (‖γ̇‖/√l + √(l/3) ‖γ̈‖)
/// |γ(s₂) − γ(s₁)|  ≤  l (‖γ̇‖₍₀,₁₎ + ‖γ̈‖₍₀,₁₎/√3)
/// ```
///
/// Equality holds for constant velocity. The second inequality follows from the mean value theorem
/// and from Proposition 7.2 for `γ̇` on `[0, 1]`; `1/√3` is the best constant, and `γ̇` must not
/// jump. The first inequality also holds for kinked curves. It holds even without its last term, by
/// the first inequality of Proposition 7.2.
///
/// # Errors
///
/// The errors of [`prop_7_2`].
#[doc(alias = "prop:morrey_ineq_cor")]
pub fn prop_7_3<const D: usize>(
    curve: &impl BoundedCurve<D>,
    [s1, s2]: [f64; 2],
) -> Result<Evidence, VerifyError> {
    let Interval { chord, length, norms: [_, velocity, acceleration], rounding } =
        Interval::of(curve, [s1, s2])?;
    let [whole, bend] = [1, 2].map(|k| l2_norm(curve, k, [0.0, 1.0]));
    let local = velocity.value / length.sqrt() + (length / 3.0).sqrt() * acceleration.value;
    let errors = velocity.error / length.sqrt() + whole.error + acceleration.error + bend.error;
    let granted = 2.0 * rounding + length * errors;
    let local = [chord.norm(), length * local];
    let on_whole = [chord.norm() - length * whole.value, length * bend.value / 3_f64.sqrt()];
    let claims =
        ["|γ(s₂) − γ(s₁)| ≤ l (‖γ̇‖/√l + √(l/3) ‖γ̈‖)", "|γ(s₂) − γ(s₁)| − l‖γ̇‖₍₀,₁₎ ≤ l‖γ̈‖₍₀,₁₎/√3"];
    Ok(without_kinks(Evidence::of(Statement::Proposition7_3), curve)
        .stated(claims[0], Unit::COORDINATE, local, granted)
        .stated(claims[1], Unit::COORDINATE, on_whole, granted))
}

/// Evaluates Proposition 7.3 as printed: `|γ(s₂) − γ(s₁)| ≤ l (‖γ̇‖ + 2‖γ̈‖)`.
///
/// It is false on every interval shorter than 1: for constant velocity the right side is
/// `l^{3/2} |γ̇|`.
///
/// # Errors
///
/// The errors of [`prop_7_2`].
pub fn prop_7_3_as_printed<const D: usize>(
    curve: &impl BoundedCurve<D>,
    [s1, s2]: [f64; 2],
) -> Result<Evidence, VerifyError> {
    let Interval { chord, length, norms: [_, velocity, acceleration], rounding } =
        Interval::of(curve, [s1, s2])?;
    let claim = "|γ(s₂) − γ(s₁)| ≤ l (‖γ̇‖ + 2‖γ̈‖)";
    let numbers = [chord.norm(), length * (velocity.value + 2.0 * acceleration.value)];
    let granted = 2.0 * rounding + length * (velocity.error + 2.0 * acceleration.error);
    Ok(Evidence::of(Statement::Proposition7_3).stated(claim, Unit::COORDINATE, numbers, granted))
}

/// Evaluates Proposition 7.4 in its repaired form at `t = tₖ + θh` with `h = 1/N`.
///
/// ```text
/// |βₖ − γ̇(t)|  ≤  2 ‖γ̈‖/√N      with the norm over [tₖ, tₖ₊₁]
/// ```
///
/// Needs: `γ̇` does not jump, which the paper omits. The overestimation is at least `2√3`, by the
/// companions.
///
/// Companions: `βₖ` is the mean of `γ̇`, so that Proposition 7.2 gives the factor
/// `((θ³ + (1 − θ)³) h/3)^{1/2}`, which is at most `(h/3)^{1/2}`. Both are attained by
/// `(tₖ₊₁ − t)³` at `tₖ`. In `L²` over the subinterval, `‖γ̇ − βₖ‖ ≤ (h/π) ‖γ̈‖`, which is attained
/// if `γ̇` is half a cosine.
///
/// # Errors
///
/// [`VerifyError::OutOfRange`] unless `k < N` and `0 ≤ θ ≤ 1`.
#[doc(alias = "prop:approx_numerical_integral_beta-gamma")]
pub fn prop_7_4<const D: usize>(
    curve: &impl BoundedCurve<D>,
    n: NonZeroUsize,
    k: usize,
    theta: f64,
) -> Result<Evidence, VerifyError> {
    let (count, n) = (n, n.get() as f64);
    let k = within("k", k as f64, [0.0, n - 1.0])?;
    within("θ", theta, [0.0, 1.0])?;
    let (h, cell) = (1.0 / n, [k / n, (k + 1.0) / n]);
    let Interval { chord, norms: [_, velocity, acceleration], rounding, .. } =
        Interval::of(curve, cell)?;
    let beta = chord * n;
    let derivative = curve.motion((k + theta) / n).velocity;
    let gap = (beta - derivative).norm();
    // ∫ |γ̇ − β|² = ∫ |γ̇|² − h |β|² is a difference of numbers of the size of the first.
    let square = (velocity.value.powi(2) - h * beta.norm_squared()).max(0.0);
    let granted_square = 4.0 * velocity.value * (velocity.error + 2.0 * rounding / h.sqrt())
        + h * h * acceleration.value * acceleration.error;
    let wirtinger = (h * acceleration.value / std::f64::consts::PI).powi(2);
    let error = |theta| velocity_error(acceleration.value, theta, count);
    let granted = 2.0 * n * rounding
        + 64.0 * f64::EPSILON * curve.suprema()[1]
        + 4.0 * f64::EPSILON * curve.suprema()[2]
        + 2.0 * h.sqrt() * acceleration.error;
    let squared = Unit { ell: 2, m: 0 };
    let stated = [gap, 2.0 * acceleration.value / n.sqrt()];
    let at_theta = "|β − γ̇(t)| ≤ ((θ³ + (1 − θ)³) h/3)^{1/2} ‖γ̈‖";
    Ok(without_kinks(Evidence::of(Statement::Proposition7_4), curve)
        .stated("|β − γ̇(t)| ≤ 2‖γ̈‖/√N", Unit::COORDINATE, stated, granted)
        .sharper("|β − γ̇(t)| ≤ (h/3)^{1/2} ‖γ̈‖", Unit::COORDINATE, [gap, error(0.0)], granted)
        .sharper(at_theta, Unit::COORDINATE, [gap, error(theta)], granted)
        .sharper("‖γ̇ − β‖² ≤ (h/π)² ‖γ̈‖²", squared, [square, wirtinger], granted_square))
}
