//! Section 9: from energies to lengths, and the open question about the rate.

use super::geodesics::off_sets;
use super::section_1::{GLOBAL, admitted};
use crate::{Evidence, Known, Reconstruction, Statement, Subject, Unit, curves::Measured};

/// Evaluates Proposition 9.1 in its repaired form on a curve `γ` and a minimiser `γ*`:
/// `L(γ)² − L(γ*)² ≤ E(γ) − E(γ*)` if `γ*` has the least *energy* `d²`.
///
/// Needs: `γ*` joins the sets, and `E(γ*) ≤ d²`. Then `d² ≤ L(γ*)² ≤ E(γ*) ≤ d²`, which implies
/// `L(γ*) ≤ d`. What remains is `L(γ)² ≤ E(γ)`, which is true for any curve `γ`. A complete space
/// and bounded sets matter only for the existence of `γ*`.
///
/// Equality holds if `γ` has constant speed.
#[doc(alias = "prop:length_energy_estimation")]
pub fn prop_9_1<M, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    curve: &Measured<D>,
    minimiser: &Measured<D>,
) -> Evidence {
    let granted = minimiser.granted_energy() + known.squared_error();
    let least = [minimiser.energy.value, known.distance.powi(2)];
    let printed = prop_9_1_as_printed(subject, known, curve, minimiser);
    printed.given("E(γ*) ≤ d²", Unit::ENERGY, least, granted)
}

/// Evaluates Proposition 9.1 as printed, where `γ*` need only have the least *length*. This is
/// false, since the energy of a curve of least length may have any larger value.
#[doc(alias = "prop:length_energy_estimation")]
pub fn prop_9_1_as_printed<M, const D: usize>(
    subject: &Subject,
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
        .stated("L(γ)² − L(γ*)² ≤ E(γ) − E(γ*)", Unit::ENERGY, [gap, bound], granted)
}

/// Evaluates the answer to Remark 9.2 on a computed minimiser of either rule: the gaps of its
/// energies and of its squared length are of order `1/N`, under the hypotheses of Theorem 1.1.
///
/// ```text
/// E_N − d²  ≤  d² (e − 1),     d² − E_N  ≤  d² (k δ/N) e Q,
/// L(γᵖˡ)² − d²  ≤  E(γᵖˡ) − d²  ≤  d² (e − 1 + (k δ/N) e Q)
/// ```
///
/// Here `δ = L_H d / c₁^{3/2}`, `k` is `¼` or `½`, and `e = 1 + O(1/N)` and `Q` are as in
/// [`tautline::bounds`]. Needs: `E_N ≤ d² e`, which a global minimiser satisfies. The sequence
/// needs no other property ([`remark_9_2_for_any_sequence`]). A worse local minimiser counts as a
/// violation here.
///
/// The bounds are optimal among those in terms of `c₁`, `c₂`, `L_H` and `d`: two routes attain the
/// leading constants at `N = 1`, as `δ → 0`, and on other routes `N (E(γᵖˡ) − d²)` does not
/// decrease with `N`.
#[doc(alias = "Remark 9.2")]
#[must_use]
pub fn remark_9_2<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let above = subject.theorem_a_minimum_gap(seen.setting, seen.rule, seen.n);
    let (over, granted) = (seen.discrete_energy - seen.distance_squared, seen.granted);
    let evidence = admitted(Evidence::of(Statement::Remark9_2), seen).assumed(GLOBAL);
    let evidence = curve_and_minimum(evidence, subject, seen);
    evidence.stated("E_N − d² = O(1/N)", Unit::ENERGY, [over, above], granted)
}

/// Evaluates the answer to Remark 9.2 on any sequence from set to set whose discrete energy does
/// not exceed the bound of [`remark_9_2`] on the minimum.
///
/// ```text
/// E_N ≤ d² e   ⟹   d² − E_N  ≤  d² (k δ/N) e Q,
///                  L(γᵖˡ)² − d²  ≤  E(γᵖˡ) − d²  ≤  d² (e − 1 + (k δ/N) e Q)
/// ```
///
/// The inner points need not be stationary: Theorem C has a smaller bound without this hypothesis.
#[doc(alias = "Remark 9.2")]
#[must_use]
pub fn remark_9_2_for_any_sequence<const D: usize>(
    subject: &Subject,
    seen: &Reconstruction<D>,
) -> Evidence {
    let least =
        seen.distance_squared + subject.theorem_a_minimum_gap(seen.setting, seen.rule, seen.n);
    let numbers = [seen.discrete_energy, least];
    let evidence = admitted(Evidence::of(Statement::Remark9_2), seen);
    let evidence = evidence.given("E_N ≤ d² e", Unit::ENERGY, numbers, seen.granted);
    curve_and_minimum(evidence, subject, seen)
}

/// Adds the claims about the curve, and the claim that the discrete energy is not far below `d²`.
fn curve_and_minimum<const D: usize>(
    evidence: Evidence,
    subject: &Subject,
    seen: &Reconstruction<D>,
) -> Evidence {
    let &Reconstruction { setting, rule, n, distance_squared: d2, granted, .. } = seen;
    let excess = subject.theorem_a_excess(setting, rule, n);
    let below = subject.theorem_a_polyline_gap(setting, rule, n);
    let (energy, length2) = (seen.energy.value, seen.length_squared.value);
    evidence
        .stated("E(γᵖˡ) − d² = O(1/N)", Unit::ENERGY, [energy - d2, excess], granted)
        .stated("L(γᵖˡ)² − d² = O(1/N)", Unit::ENERGY, [length2 - d2, excess], granted)
        .stated("d² − E_N = O(1/N)", Unit::ENERGY, [d2 - seen.discrete_energy, below], granted)
        .sharper("d² ≤ L(γᵖˡ)²", Unit::ENERGY, [d2, length2], granted)
        .sharper("L(γᵖˡ)² ≤ E(γᵖˡ)", Unit::ENERGY, [length2, energy], granted)
}
