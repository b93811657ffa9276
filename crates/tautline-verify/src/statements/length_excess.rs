//! Section 9: from energies to lengths, and the rate that is left open.

use super::geodesics::off_sets;
use crate::{
    Evidence, Known, PaperRule, Reconstruction, Statement, Subject, Unit, curves::Measured,
};

/// Evaluates Proposition 9.1, repaired, on a curve `γ` and a minimiser `γ*`:
/// `L(γ)² − L(γ*)² ≤ E(γ) − E(γ*)` if `γ*` has the least *energy* `d²`.
///
/// Equality: `γ` of constant speed.
#[doc(alias = "prop:length_energy_estimation")]
pub fn prop_9_1<M, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
    curve: &Measured<D>,
    minimiser: &Measured<D>,
) -> Evidence {
    let granted = minimiser.granted_energy() + 2.0 * known.distance * known.distance_error;
    let least = [minimiser.energy.value, known.distance.powi(2)];
    excess(subject, known, curve, minimiser).given("E(γ*) ≤ d²", Unit::ENERGY, least, granted)
}

/// Evaluates Proposition 9.1 as printed: `γ*` need only have the least *length*. False, since a
/// curve of least length may have any larger energy.
#[doc(alias = "prop:length_energy_estimation")]
pub fn prop_9_1_as_printed<M, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
    curve: &Measured<D>,
    minimiser: &Measured<D>,
) -> Evidence {
    excess(subject, known, curve, minimiser)
}

fn excess<M, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
    curve: &Measured<D>,
    minimiser: &Measured<D>,
) -> Evidence {
    let mut evidence = Evidence::of(Statement::Proposition9_1);
    for (claim, seen) in [("γ joins the sets", curve), ("γ* joins the sets", minimiser)] {
        let (off, rounding) = off_sets(subject, known, seen);
        evidence = evidence.given(claim, Unit::COORDINATE, [off, 0.0], rounding);
    }
    let length = minimiser.granted_length() + known.distance_error;
    let granted = curve.granted_energy() + minimiser.granted_energy();
    let gap = curve.length_squared() - minimiser.length_squared();
    let bound = curve.energy.value - minimiser.energy.value;
    evidence
        .given("L(γ*) ≤ d", Unit::LENGTH, [minimiser.length.value, known.distance], length)
        .paper("L(γ)² − L(γ*)² ≤ E(γ) − E(γ*)", Unit::ENERGY, [gap, bound], granted)
}

/// Evaluates the answer to Remark 9.2 on a computed minimiser of either rule: the gaps of its
/// energies and of its squared length are of order `1/N`, under the hypotheses of Theorem 1.1.
///
/// ```text
/// E_N − d²  ≤  d² (e − 1),     d² − E_N  ≤  d² (k δ/N) e Q,
/// L(γᵖˡ)² − d²  ≤  E(γᵖˡ) − d²  ≤  d² (e − 1 + (k δ/N) e Q)
/// ```
///
/// `δ = L_H d / c₁^{3/2}`, `k = ¼` or `½`, and `e = 1 + O(1/N)` and `Q` as in [`tautline::bounds`].
/// Needs: `E_N ≤ d² e`, as for a global minimiser, and stationary inner points. The solver finds
/// local minimisers: that it stopped at a worse one is a violation here, since this is worth
/// knowing.
///
/// Optimal among the bounds by `c₁`, `c₂`, `L_H` and `d`: two routes attain the leading constants
/// at `N = 1`, as `δ → 0`, and others keep `N (E(γᵖˡ) − d²)` from falling for all `N`.
#[doc(alias = "Remark 9.2")]
#[must_use]
pub fn remark_9_2<const D: usize>(subject: &impl Subject, seen: &Reconstruction<D>) -> Evidence {
    let &Reconstruction { setting, n, distance_squared: d2, granted, .. } = seen;
    let [excess, above, below] = match seen.rule {
        PaperRule::Trapezoidal => [
            subject.first_order_excess_trapezoidal(setting, n),
            subject.first_order_minimum_gap_trapezoidal(setting, n),
            subject.first_order_polyline_gap_trapezoidal(setting, n),
        ],
        PaperRule::LeftEndpoint => [
            subject.first_order_excess_left(setting, n),
            subject.first_order_minimum_gap_left(setting, n),
            subject.first_order_polyline_gap_left(setting, n),
        ],
    };
    let (energy, length2) = (seen.energy.value, seen.length_squared.value);
    let size = seen.minimum.sequence.first().norm() + seen.k3;
    Evidence::of(Statement::Remark9_2)
        .given_constants(setting.constants(), &seen.gram)
        .given(
            "the ends lie in X⁽⁰⁾ and X⁽¹⁾",
            Unit::COORDINATE,
            [seen.off_sets, 0.0],
            // As for the theorems of Section 1.
            1e-13 * size,
        )
        .paper("E(γᵖˡ) − d² = O(1/N)", Unit::ENERGY, [energy - d2, excess], granted)
        .paper("L(γᵖˡ)² − d² = O(1/N)", Unit::ENERGY, [length2 - d2, excess], granted)
        .paper("E_N − d² = O(1/N)", Unit::ENERGY, [seen.discrete_energy - d2, above], granted)
        .paper("d² − E_N = O(1/N)", Unit::ENERGY, [d2 - seen.discrete_energy, below], granted)
        .sharper("d² ≤ L(γᵖˡ)²", Unit::ENERGY, [d2, length2], granted)
        .sharper("L(γᵖˡ)² ≤ E(γᵖˡ)", Unit::ENERGY, [length2, energy], granted)
}
