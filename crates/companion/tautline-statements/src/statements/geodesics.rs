//! Propositions 3.1 and 3.2: geodesics have constant speed, and join points of a complete space.

use tautline::{KnownDistance, Metric, MetricError};

use super::way_out::WayOut;
use crate::{
    Evidence, Known, Statement, Subject, Unit,
    curves::{Curve, Measured, Residual, largest},
};

/// Evaluates Proposition 3.1 on a curve: if it satisfies the geodesic equation (3.2), then
/// `g(γ̇, γ̇) = L(γ)²` at all times. This equality is compared as two inequalities of
/// overestimation 1.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:metric_geodesic_constant")]
pub fn prop_3_1<const D: usize>(
    subject: &Subject,
    metric: &impl Metric<D>,
    curve: &impl Curve<D>,
) -> Result<Evidence, MetricError> {
    let residual = Residual::of(subject, metric, curve)?;
    let seen = Measured::of(metric, curve);
    let [least, largest] = seen.speeds.map(|speed| speed.powi(2));
    let (length2, granted) = (seen.length_squared(), seen.granted_energy());
    Ok(Evidence::of(Statement::Proposition3_1)
        .given("γ̈ = −Γ(γ̇, γ̇)", Unit::COORDINATE, [residual.value, 0.0], residual.granted)
        .stated("g(γ̇, γ̇) ≤ L(γ)²", Unit::ENERGY, [largest, length2], granted)
        .stated("L(γ)² ≤ g(γ̇, γ̇)", Unit::ENERGY, [length2, least], granted))
}

/// Evaluates the observable part of Proposition 3.2 (Hopf and Rinow): the given curve is a minimal
/// geodesic between the two points.
///
/// `way_out` starts from one of the points. A space is complete if and only if there is no way out;
/// it is complete if `H ≥ c₁ > 0` on all of `R^D` (Proposition 3.3).
///
/// No finite number of curves shows the claim for *any* two points. Theorem 1.2 bounds how much
/// longer than `d` a computed curve may be.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:Hopf-Rinow-theorem")]
pub fn prop_3_2<M: KnownDistance<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    curve: &impl Curve<D>,
    way_out: WayOut,
) -> Result<Evidence, MetricError> {
    let residual = Residual::of(subject, &known.metric, curve)?;
    let seen = Measured::of(&known.metric, curve);
    let granted = seen.granted_length() + known.distance_error;
    let (off, rounding) = off_sets(subject, known, &seen);
    let evidence = Evidence::of(Statement::Proposition3_2);
    Ok(way_out
        .given_longer(evidence, [known.distance, known.distance_error])
        .stated("γ joins the points", Unit::COORDINATE, [off, 0.0], rounding)
        .stated("γ̈ = −Γ(γ̇, γ̇)", Unit::COORDINATE, [residual.value, 0.0], residual.granted)
        .stated("L(γ) ≤ d", Unit::LENGTH, [seen.length.value, known.distance], granted)
        .sharper("d ≤ L(γ)", Unit::LENGTH, [known.distance, seen.length.value], granted))
}

/// Returns the distance of the ends of a curve from their sets, and the allowance for it, both in
/// `ℓ`.
pub(super) fn off_sets<M, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
) -> (f64, f64) {
    let sets = [known.ends.first(), known.ends.second()];
    let off = sets.into_iter().zip(&seen.ends);
    let off = largest(off.map(|(set, x)| (subject.project(&**set, x) - x).norm()));
    // Closed forms and maps from flat coordinates have some dozens of roundings, and projections
    // have 4 D.
    let size = seen.ends.iter().map(|x| x.norm()).sum::<f64>();
    (off, 64.0 * f64::EPSILON * size)
}
