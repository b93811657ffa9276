//! Proposition 3.3: the distance lies between two Euclidean ones.

use nalgebra::SVector;
use tautline::{Bounded, MetricError};

use crate::{Evidence, GramRange, Known, Statement, Subject, Unit};

/// Evaluates Proposition 3.3 on two points: `c₁|x − y|² ≤ d(x, y)² ≤ c₂|x − y|²`.
///
/// Completeness follows: a sequence is a Cauchy sequence for `d` if and only if it is one for the
/// Euclidean distance. Completeness needs only `c₁`.
///
/// Equality holds for a constant metric, along its eigenvectors.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:bounded_g_completeness")]
pub fn prop_3_3<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
) -> Result<Evidence, MetricError> {
    let sets = [known.ends.first(), known.ends.second()];
    let [x, y] = sets.map(|set| subject.project(&**set, &SVector::zeros()));
    let segment = (0..=32).map(|k| x + (y - x) * (f64::from(k) / 32.0));
    let seen = GramRange::along(&known.metric, segment)?;
    let constants = subject.constants(&known.metric);
    let (c1, c2) = (constants.c1(), constants.c2());
    let (d2, euclidean) = (known.distance.powi(2), (x - y).norm_squared());
    // An entry of H has a dozen roundings, and a product follows.
    let rounding = 1e-14 * seen.high;
    let granted = known.squared_error() + rounding * euclidean;
    // Between the 33 points of the segment, H grows by at most c₂ − c₁, and by at most L_H |x −
    // y|/64.
    let top = seen.high + (constants.l_h() * euclidean.sqrt() / 64.0).min(c2 - c1);
    let sharper = "d² ≤ sup H |x − y|² on the segment";
    Ok(Evidence::of(Statement::Proposition3_3)
        .given("c₁ ≤ λ_min(H)", Unit::GRAM, [c1, seen.low], rounding)
        .given("λ_max(H) ≤ c₂", Unit::GRAM, [seen.high, c2], rounding)
        .assumed("c₁ and c₂ hold elsewhere")
        .stated("c₁|x − y|² ≤ d²", Unit::ENERGY, [c1 * euclidean, d2], granted)
        .stated("d² ≤ c₂|x − y|²", Unit::ENERGY, [d2, c2 * euclidean], granted)
        .sharper(sharper, Unit::ENERGY, [d2, top * euclidean], granted))
}
