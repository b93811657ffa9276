//! Propositions 7.10 and 7.11: the first derivatives of the metric, and its Christoffel symbols.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Jet1, MetricError, bounds::christoffel_bound};

use crate::{Evidence, GramRange, Statement, Subject, Unit, operator_norm};

/// Evaluates Proposition 7.10 at a point: `|∂ₗ Hᵢⱼ| ≤ L_H` for all `i`, `j` and `l`.
///
/// Needs: `H` Lipschitz; `c₁ ≤ H ≤ c₂` is checked, but not needed. The bound is attained by a wave
/// in one pair of entries along one axis.
///
/// Companion: the matrices `∂ₗ H` and the derivative along the diagonal, `Σ ∂ₗ H/√D`, have operator
/// norms of at most `L_H`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:estimate_derivation_g")]
pub fn prop_7_10<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    x: &SVector<f64, D>,
) -> Result<Evidence, MetricError> {
    let constants = subject.constants(metric);
    let jets = metric.gram(&SVector::from(Jet1::variables(&(*x).into())));
    let slopes: [SMatrix<f64, D, D>; D] =
        std::array::from_fn(|l| SMatrix::from_fn(|i, j| jets[(i.min(j), i.max(j))].first(l)));
    let largest = slopes.iter().map(|slope| slope.amax()).fold(0.0, f64::max);
    let diagonal: SMatrix<f64, D, D> =
        slopes.iter().sum::<SMatrix<f64, D, D>>() / (D as f64).sqrt();
    let norms = slopes.iter().chain([&diagonal]).map(operator_norm);
    let operator = norms.fold(0.0, f64::max);
    let bound = constants.l_h();
    // An entry has a dozen roundings. Its argument has the size |x| L_H/c₁ and is rounded, too.
    let size = 1.0 + x.norm() * bound / constants.c1();
    let granted = 32.0 * f64::EPSILON * (D as f64 + size) * bound;
    Ok(Evidence::of(Statement::Proposition7_10)
        .given_constants(constants, &GramRange::near(metric, constants, x)?)
        .stated("|∂ₗHᵢⱼ| ≤ L_H", Unit::GRAM_SLOPE, [largest, bound], granted)
        .sharper("‖DH[w]‖ ≤ L_H|w|", Unit::GRAM_SLOPE, [operator, bound], granted))
}

/// Evaluates Proposition 7.11 at a point: `|Γᵏᵢⱼ| ≤ 3 L_H √D/2c₁`.
///
/// Needs: `H ≥ c₁` and `H` Lipschitz, but not `c₂`. The overestimation is at least `√D`, by the
/// companion.
///
/// Companion: `Γᵏᵢⱼ` is the product of row `k` of `H⁻¹`, whose norm is at most `1/c₁`, and half of
/// the vector `(∂ᵢHⱼ + ∂ⱼHᵢ − ∇Hᵢⱼ)`, whose three terms have norms of at most `L_H`. Hence the
/// factor `√D` is not needed. In two dimensions, `3/2` is sharp; in one dimension, terms cancel,
/// which leaves `L_H/2c₁`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:Christoffel_symbol_estimate")]
pub fn prop_7_11<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    x: &SVector<f64, D>,
) -> Result<Evidence, MetricError> {
    let constants = subject.constants(metric);
    let symbols = subject.christoffel(metric, x)?;
    let largest = symbols.iter().map(|matrix| matrix.amax()).fold(0.0, f64::max);
    let natural = constants.l_h() / constants.c1();
    let bound = 1.5 * natural * (D as f64).sqrt();
    let sharp = christoffel_bound(constants, D);
    let claim = if D == 1 { "|Γ| ≤ L_H/2c₁" } else { "|Γᵏᵢⱼ| ≤ 3 L_H/2c₁" };
    // In addition to Proposition 7.10, a solution of H z = r is off by ε times the condition
    // number.
    let size = D as f64 + x.norm() * natural + constants.c2() / constants.c1();
    let granted = 64.0 * f64::EPSILON * size * bound;
    Ok(Evidence::of(Statement::Proposition7_11)
        .given_constants(constants, &GramRange::near(metric, constants, x)?)
        .stated("|Γᵏᵢⱼ| ≤ 3 L_H √D/2c₁", Unit::CHRISTOFFEL, [largest, bound], granted)
        .sharper(claim, Unit::CHRISTOFFEL, [largest, sharp], granted))
}
