//! The catalogue behind [`Statement`]: one entry for each, in the paper's order.

use crate::{Statement, Verdict};

/// What is known of a statement without evaluating it.
pub(crate) struct Entry {
    pub(crate) number: &'static str,
    pub(crate) label: &'static str,
    pub(crate) claim: &'static str,
    pub(crate) verdict: Verdict,
    pub(crate) function: &'static str,
}

/// Returns the entry of a statement.
pub(crate) fn entry(statement: Statement) -> &'static Entry {
    &CATALOGUE[statement as usize]
}

const fn statement(
    number: &'static str,
    label: &'static str,
    claim: &'static str,
    verdict: Verdict,
    function: &'static str,
) -> Entry {
    Entry { number, label, claim, verdict, function }
}

/// By the order of [`Statement::ALL`]. `‖·‖` is the norm of L² over the interval that is meant.
const CATALOGUE: [Entry; Statement::ALL.len()] = [
    statement(
        "Theorem 1.1",
        "theo:approx_numerical_integral_trapezoidal",
        "min E − C/√N ≤ E(γᵖˡ) − C/√N ≤ min E_tra,N ≤ min E + C/N",
        Verdict::Holds,
        "theorem_1_1",
    ),
    statement(
        "Theorem 1.2",
        "theo:approx_numerical_integral_trapezoidal_length",
        "L(γᵖˡ)² − d² ≤ C/√N for the trapezoidal rule, with the C of Theorem 1.1",
        Verdict::Holds,
        "theorem_1_2",
    ),
    statement(
        "Theorem 1.3",
        "theo:approx_numerical_integral_left",
        "min E − C/√N ≤ E(γᵖˡ) − C/√N ≤ min E_l,N ≤ min E + C/√N",
        Verdict::Holds,
        "theorem_1_3",
    ),
    statement(
        "Theorem 1.4",
        "theo:approx_numerical_integral_left_length",
        "L(γᵖˡ)² − d² ≤ C/√N for the left-endpoint rule, with the C of Theorem 1.3",
        Verdict::Holds,
        "theorem_1_4",
    ),
    statement(
        "Proposition 3.1",
        "prop:metric_geodesic_constant",
        "a geodesic has constant speed, its length",
        Verdict::Holds,
        "prop_3_1",
    ),
    statement(
        "Proposition 3.2",
        "prop:Hopf-Rinow-theorem",
        "in a complete space two points are joined by a minimal geodesic",
        Verdict::Cited,
        "prop_3_2",
    ),
    statement(
        "Proposition 3.3",
        "prop:bounded_g_completeness",
        "c₁ ≤ H ≤ c₂ makes the space complete: c₁∣x − y∣² ≤ d(x, y)² ≤ c₂∣x − y∣²",
        Verdict::Holds,
        "prop_3_3",
    ),
    statement(
        "Proposition 4.1",
        "prop:geodesic_min_loc_path_min",
        "near a point, the minimal curves are the minimal geodesics, reparametrised",
        Verdict::HoldsReadAs("\"monotone increasing\" is nondecreasing: the curve may pause"),
        "prop_4_1",
    ),
    statement(
        "Proposition 4.2",
        "prop:geodesic_min_path_min",
        "everywhere, the minimal curves are the minimal geodesics, reparametrised",
        Verdict::HoldsReadAs("\"monotone increasing\" is nondecreasing: the curve may pause"),
        "prop_4_2",
    ),
    statement(
        "Proposition 4.3",
        "prop:uniformal_normal_radius",
        "on a compact set, geodesics shorter than one common radius are minimal and unique",
        Verdict::Cited,
        "prop_4_3",
    ),
    statement(
        "Lemma 4.4",
        "lem:minimal_constant_speed_geodesic",
        "a minimal curve of constant speed is a geodesic",
        Verdict::Holds,
        "lemma_4_4",
    ),
    statement(
        "Section 5, left-endpoint rule",
        "eq:length-left-point-min",
        "over the valleys min L_l,N = 4π for every N, and the distance is 8π",
        Verdict::Holds,
        "section_5_left",
    ),
    statement(
        "Section 5, trapezoidal rule",
        "eq:length-tra-point-min",
        "over the valleys min L_tra,N = 4π for every N, and the distance is 8π",
        Verdict::Holds,
        "section_5_trapezoidal",
    ),
    statement(
        "Proposition 6.1",
        "prop:geodesic_len_and_energy",
        "between two points min E = min L², and the minimisers of E are the minimal geodesics",
        Verdict::Holds,
        "prop_6_1",
    ),
    statement(
        "Proposition 6.2",
        "prop:bounded_2sets_min",
        "two closed sets, one bounded, have a nearest pair, and the set of nearest pairs is compact",
        Verdict::Holds,
        "prop_6_2",
    ),
    statement(
        "Proposition 6.3",
        "prop:geodesic_len_and_energy_2",
        "between two closed sets, one bounded, min E = min L², at minimal geodesics",
        Verdict::Holds,
        "prop_6_3",
    ),
    statement(
        "Proposition 7.1",
        "prop:existence_discrete_minimizers",
        "H ≥ c₁ and a bounded set: both discrete energies have a minimiser, within √(E/c₁) of that set",
        Verdict::Holds,
        "prop_7_1",
    ),
    statement(
        "Proposition 7.2",
        "prop:morrey_ineq",
        "∣γ(s₂) − γ(s₁)∣ ≤ √(s₂ − s₁) ‖γ̇‖ on [s₁, s₂], and ∣γ(s)∣ ≤ ‖γ‖ + 2‖γ̇‖ there",
        Verdict::RefutedRepairedAs(
            "the second with ‖γ‖/√l + √(l/3) ‖γ̇‖ on an interval of length l",
        ),
        "prop_7_2",
    ),
    statement(
        "Proposition 7.3",
        "prop:morrey_ineq_cor",
        "∣γ(s₂) − γ(s₁)∣ ≤ l (‖γ̇‖ + 2‖γ̈‖) on an interval of length l",
        Verdict::RefutedRepairedAs(
            "l (‖γ̇‖/√l + √(l/3) ‖γ̈‖); or l (‖γ̇‖ + ‖γ̈‖/√3) with the norms over [0, 1], where γ̇ does not jump",
        ),
        "prop_7_3",
    ),
    statement(
        "Proposition 7.4",
        "prop:approx_numerical_integral_beta-gamma",
        "∣βₙ − γ̇(t)∣ ≤ 2 ‖γ̈‖/√N on the n-th subinterval",
        Verdict::RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        "prop_7_4",
    ),
    statement(
        "Proposition 7.5",
        "prop:functional_lipschitz_estimate",
        "∣u₁ᵀH(x₁)u₁ − u₂ᵀH(x₂)u₂∣ ≤ L∣x₁ − x₂∣∣u₁∣² + c₂∣u₁ − u₂∣² + 2c₂∣u₁∣∣u₁ − u₂∣",
        Verdict::RefutedRepairedAs("0 ≤ H(x₂) ≤ c₂, not only H ≤ c₂"),
        "prop_7_5",
    ),
    statement(
        "Proposition 7.6",
        "prop:approx_numerical_integral",
        "∣E(γ) − E_tra,N(γ)∣ ≤ C_tra(N) where ‖γ̇‖ ≤ K₁ and ‖γ̈‖ ≤ K₂",
        Verdict::RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        "prop_7_6",
    ),
    statement(
        "C_tra(N)",
        "C_tra(N)",
        "C_tra(N) = (L_H (K₁³ + 2K₁²K₂) + 4c₂K₁K₂)/N + 4c₂K₂²/N²",
        Verdict::Holds,
        "constant_c_tra",
    ),
    statement(
        "C_tra♯",
        "C_tra^sharp",
        "C_tra(N) ≤ C_tra♯/N",
        Verdict::Holds,
        "constant_c_tra_sharp",
    ),
    statement(
        "Proposition 7.7",
        "prop:approx_numerical_integral_set",
        "inf E_tra,N ≤ inf E + C_tra(N) over a set of such curves",
        Verdict::RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        "prop_7_7",
    ),
    statement(
        "Proposition 7.8",
        "prop:ineq_cube_3/2",
        "Σ xₙ³ ≤ (Σ xₙ²)^{3/2}",
        Verdict::Holds,
        "prop_7_8",
    ),
    statement(
        "Proposition 7.9",
        "prop:approx_numerical_integral_pts",
        "∣E(γᵖˡ) − E_tra,N(γᵖ)∣ ≤ L_H K₃³/(4√N) for every point sequence",
        Verdict::Holds,
        "prop_7_9",
    ),
    statement(
        "Proposition 7.10",
        "prop:estimate_derivation_g",
        "∣∂ₗ H_ij∣ ≤ L_H",
        Verdict::Holds,
        "prop_7_10",
    ),
    statement(
        "Proposition 7.11",
        "prop:Christoffel_symbol_estimate",
        "∣Γᵏ_ij∣ ≤ 3 L_H √D/(2 c₁)",
        Verdict::Holds,
        "prop_7_11",
    ),
    statement(
        "K_{1,g}",
        "K_{1,g}",
        "K_{1,g} = d/√c₁ bounds the speed of a minimal geodesic",
        Verdict::Holds,
        "constant_k1",
    ),
    statement(
        "K_{2,g}",
        "K_{2,g}",
        "K_{2,g} = 3 L_H D² K_{1,g}²/(2 c₁) bounds its acceleration",
        Verdict::Holds,
        "constant_k2",
    ),
    statement(
        "Proposition 7.12",
        "prop:apriori_estuimate_geodesic",
        "every minimiser of E has ‖γ̇‖ ≤ K_{1,g} and ‖γ̈‖ ≤ K_{2,g}",
        Verdict::Holds,
        "prop_7_12",
    ),
    statement(
        "K̄_{3,g}",
        "overline K_{3,g}",
        "K̄_{3,g}² = (d² + C_tra♯)/c₁ bounds K₃² of the minimisers of E_tra,N",
        Verdict::Holds,
        "constant_k3_bar",
    ),
    statement(
        "C of Theorem 1.1",
        "C (Theorem 1.1)",
        "C = C_tra♯ + L_H K̄_{3,g}³/4: C_tra♯/N + L_H K̄_{3,g}³/(4√N) ≤ C/√N",
        Verdict::Holds,
        "constant_c_1_1",
    ),
    statement(
        "Proposition 8.1",
        "prop:left_trapezoidal_fomula",
        "∣E_l,N(γᵖ) − E_tra,N(γᵖ)∣ ≤ L_H K₃³/(2√N) for every point sequence",
        Verdict::Holds,
        "prop_8_1",
    ),
    statement(
        "Proposition 8.2",
        "prop:approx_numerical_integral_pts_left",
        "∣E(γᵖˡ) − E_l,N(γᵖ)∣ ≤ L_H K₃³/(2√N) for every point sequence",
        Verdict::Holds,
        "prop_8_2",
    ),
    statement(
        "K̄_{4,g}",
        "overline K_{4,g}",
        "K̄_{4,g}² = (d² + C_tra♯ + L_H K̄_{3,g}³/2)/c₁ bounds K₃² of the minimisers of E_l,N",
        Verdict::Holds,
        "constant_k4_bar",
    ),
    statement(
        "C of Theorem 1.3",
        "C (Theorem 1.3)",
        "C = C_tra♯ + L_H (K̄_{3,g}³ + K̄_{4,g}³)/2 bounds all three gaps of the left rule",
        Verdict::Holds,
        "constant_c_1_3",
    ),
    statement(
        "Proposition 9.1",
        "prop:length_energy_estimation",
        "L(γ)² − L(γ*)² ≤ E(γ) − E(γ*) where γ* has the least length",
        Verdict::RefutedRepairedAs("γ* has the least energy"),
        "prop_9_1",
    ),
    statement(
        "Remark 9.2",
        "Remark 9.2",
        "the minima converge like 1/N; whether E(γᵖˡ) and L(γᵖˡ)² do better than 1/√N is left open",
        Verdict::OpenAnsweredBy("they converge like 1/N under the same hypotheses, for both rules"),
        "remark_9_2",
    ),
];
