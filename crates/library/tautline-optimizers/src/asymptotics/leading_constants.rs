//! `LeadingConstants`: the predicted leading errors of both rules on smooth data.

use nalgebra::SVector;
use tautline_discretizations::{LinearModel, QuadraticModel, Rule};
use tautline_metrics::Metric;
use tautline_sets::{ClosedSet, Ends, InAny};

use crate::{
    AsymptoticsError, Minimum, Stop,
    asymptotics::geodesic_means::GeodesicMeans,
    newton::{reduced_system::ReducedSystem, rounding::margin},
};

/// The limits, as `N → ∞`, of the errors of the discrete minimisers times `N` or `N²`, in `m²`.
///
/// Here `γ` is a minimal geodesic between the sets, `w = DH[γ̇](γ̇, γ̇) = −2 γ̇ᵀHγ̈` is the growth
/// rate of the metric along it, and integrals are over `t ∈ [0, 1]`:
///
/// | field | limit of | is |
/// | --- | --- | --- |
/// | `trapezoidal` | `N² (E_tra,N − d²)` | `(1/12) ∫ γ̈ᵀHγ̈ − (1/24) ∫ D²H[γ̇, γ̇](γ̇, γ̇)` |
/// | `left` | `N (E_l,N − d²)` | `−½ ∫ w` |
/// | `energy_trapezoidal` | `N² (E(γᵖˡ) − d²)` | `(1/12) ∫ γ̈ᵀHγ̈` |
/// | `length_trapezoidal` | `N² (L(γᵖˡ)² − d²)` | `(1/12) ∫ (γ̈ᵀHγ̈ − w²/4d²)` |
/// | `energy_left` | `N² (E(γᵖˡ) − d²)` | `(1/12) ∫ γ̈ᵀHγ̈ + ½ E″[η, η]` |
/// | `length_left` | `N² (L(γᵖˡ)² − d²)` | `(1/12) ∫ (γ̈ᵀHγ̈ − w²/4d²) + ½ E″[η, η] − V` |
///
/// To first order, the points of the left rule lie on `γ + η/N`, where `η` minimises
/// `½ E″[η, η] + F′[η]` with `F = −½ ∫ DH[γ̇](γ̇, γ̇)`. `E″` is the second variation of the energy
/// among the curves between the sets, and includes the curvature of the sets. The variance
/// `V = (∫ w² − (∫ w)²) / 4d²` is the part of `½ E″[η, η]` that shifts points along `γ`, which
/// costs energy but no length.
///
/// For the derivation see [`leading_constants`]. The limits are computed, not proved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[doc(alias = "asymptotics")]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LeadingConstants {
    /// The limit of `N² (E_tra,N − d²)`. It may have either sign.
    pub trapezoidal: f64,
    /// The limit of `N (E_l,N − d²)`. It may have either sign. It is 0 if `w` has mean 0, for
    /// example by symmetry; then `E_l,N − d²` is of second order. For `H = φ I`, and in one
    /// dimension, it is `−(d²/2) log (φ(γ(1))/φ(γ(0)))`.
    pub left: f64,
    /// The limit of `N² (E(γᵖˡ) − d²) ≥ 0` for the trapezoidal rule.
    pub energy_trapezoidal: f64,
    /// The limit of `N² (L(γᵖˡ)² − d²) ≥ 0` for the trapezoidal rule. It is 0 in one dimension.
    pub length_trapezoidal: f64,
    /// The limit of `N² (E(γᵖˡ) − d²) ≥ 0` for the left rule.
    pub energy_left: f64,
    /// The limit of `N² (L(γᵖˡ)² − d²) ≥ 0` for the left rule. It is 0 in one dimension, and equals
    /// `length_trapezoidal` for `H = φ I`.
    pub length_left: f64,
}

/// The relative decrement of the trapezoidal energy up to which a sequence counts as its minimiser.
/// A search has converged there even if rounding stops it.
const STATIONARY: f64 = 1e-10;

/// Returns the leading constants of the errors of both rules, in `m²`, along a minimiser of the
/// [`Rule::TRAPEZOIDAL`] energy. The minimiser should be computed with a large `N`. All constants are 0
/// if the sets touch.
///
/// - `ends`: the sets between which `minimum` was computed. Only the constants of the left rule's
///   curve use them.
///
/// # Derivation
///
/// For the points of a smooth curve the energies have the expansions `E_tra,N = E + N⁻² F₂ + …` and
/// `E_l,N = E + N⁻¹ F + …`. To leading order a minimum changes by the value of the perturbation at
/// the minimiser. With integration by parts and the geodesic equation, this gives the first two
/// limits. The curve `γᵖˡ` differs from the smooth curve through its points by an `r` that vanishes
/// at the points, with `∫ ṙᵀHṙ = N⁻² (1/12) ∫ γ̈ᵀHγ̈`. The points of the trapezoidal rule are off
/// by `N⁻²`, which is negligible; the points of the left rule are off by `η/N`. `E − L²` is the
/// variance of the speed. For the trapezoidal rule the speed varies only within a chord, by `w/2dN`
/// from end to end. For the left rule `E + F/N` conserves `γ̇ᵀHγ̇ − w/N`, so that the squared speed
/// also varies from chord to chord, like `w/N`: this gives `V`.
///
/// Needs: `H` is three times continuously differentiable; the minimal geodesic is unique and
/// nondegenerate (otherwise the limits hold for sequences near this one, or fail); each end is free
/// along a smooth face of its set, or fixed by a nonzero force. The derivation is formal: the
/// limits are computed and agree with measurements, but they are not proved.
///
/// Accuracy: the constants are computed to second order. The error is `(c/N)²` times the two
/// integrals, where `c` is the size of the curve divided by the scale of the metric. If a sum
/// cancels, as `left` does by symmetry, only this error remains.
///
/// # Errors
///
/// [`AsymptoticsError`] if the metric is not positive definite along the curve, or if the sequence
/// is not a nondegenerate minimiser of the trapezoidal energy between these sets.
pub fn leading_constants<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    minimum: &Minimum<D>,
) -> Result<LeadingConstants, AsymptoticsError> {
    if !minimum.is_local_minimum() {
        return Err(AsymptoticsError::Degenerate);
    }
    if minimum.stop == Stop::EndsTouch {
        return Ok(LeadingConstants::default());
    }
    let displacement = displacement_energy(metric, ends, minimum)?;
    let means = GeodesicMeans::along(metric, minimum)?;
    let shift = (means.growth_squared - means.growth.powi(2)) / (4.0 * minimum.energy);
    Ok(LeadingConstants {
        trapezoidal: means.bending / 12.0 - means.second / 24.0,
        left: -0.5 * means.growth,
        energy_trapezoidal: means.bending / 12.0,
        length_trapezoidal: means.turning / 12.0,
        energy_left: means.bending / 12.0 + displacement,
        length_left: means.turning / 12.0 + displacement - shift,
    })
}

/// Returns `½ E″[η, η]`, in `m²`. It is half the square of the Newton decrement of
/// `E_tra,N + N⁻¹ F` at the minimiser of `E_tra,N`, times `N²`. Here `(N/2) (E_l,N − E_r,N)`
/// approximates `F` to second order, unlike `N (E_l,N − E_tra,N)`.
fn displacement_energy<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    minimum: &Minimum<D>,
) -> Result<f64, AsymptoticsError> {
    let sequence = &minimum.sequence;
    let n = sequence.n().get();
    // Selects the pieces of the sets in which the curve begins and ends.
    let gap = |set: &dyn ClosedSet<D>, x: &SVector<f64, D>| (set.project(x) - x).norm();
    let pairs = ends.pairs().map(|(first, second)| {
        (gap(&*first, sequence.first()) + gap(&*second, sequence.last()), [first, second])
    });
    let nearest = pairs.min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, [first, second]) = nearest.ok_or(AsymptoticsError::Degenerate)?;
    let model = QuadraticModel::new(Rule::TRAPEZOIDAL, metric, sequence);
    // The system subtracts the margin. With the margin as the shift, the Hessian is unchanged.
    let ends: [InAny<'_, D>; 2] = [InAny(&*first), InAny(&*second)];
    let system =
        ReducedSystem::new(&model, [&ends[0], &ends[1]], sequence.coordinates(), margin(n));
    let factorization = system.factorize().ok_or(AsymptoticsError::Degenerate)?;
    let decrement = system.newton_step(&factorization).decrement / model.energy;
    if !(decrement <= STATIONARY) {
        return Err(AsymptoticsError::NotStationary { decrement });
    }
    let left = LinearModel::new(Rule::LEFT_ENDPOINT, metric, sequence).slopes;
    let right = LinearModel::new(Rule::RIGHT_ENDPOINT, metric, sequence).slopes;
    let half = 0.5 * n as f64;
    let slopes: Vec<f64> = left.iter().zip(&right).map(|(l, r)| (l - r) * half).collect();
    Ok(system.decrement_of(&factorization, &slopes))
}

#[cfg(test)]
mod tests;
