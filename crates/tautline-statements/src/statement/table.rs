//! The table of statements, one row each: pages, tables and tests are made from it.

use super::row::{Needs, Refutation, Row, assumed, checked, or, statements};
use crate::{
    Verdict::{Cited, Holds, HoldsReadAs, OpenAnsweredBy, ProvedHere, RefutedRepairedAs},
    refutations,
};

const CONSTANTS: Needs = Needs {
    checked: &["c₁ ≤ λ_min(H)", "λ_max(H) ≤ c₂", "‖H(x) − H(y)‖/|x − y| ≤ L_H"],
    assumed: &["c₁, c₂ and L_H hold elsewhere"],
};

const CURVATURE: Needs =
    Needs { checked: &["|uᵀ D²H[u, u] u| ≤ M_H"], assumed: &["M_H holds elsewhere"] };

const ENDS: Needs = checked(&["the ends lie in X⁽⁰⁾ and X⁽¹⁾"]);

/// The sequence has at most the energy that the proof has for the minimum.
const MINIMISER: Needs = checked(&[
    "the rule is that of the theorem",
    "the ends lie in X⁽⁰⁾ and X⁽¹⁾",
    "E_N ≤ what the proof has for the minimum",
]);

const GLOBAL: Needs = assumed(&["γᵖ is a global minimiser"]);

const GEODESIC: Needs = checked(&["|γ̈ + Γ(γ̇, γ̇)| = 0", "|g(γ̇, γ̇) − d²| = 0"]);

const NO_KINK: Needs = checked(&["γ̇ does not jump"]);

// `‖·‖` is the norm of L² over the interval in question.
statements! {
    Theorem1_1 {
        number: "Theorem 1.1",
        label: "theo:approx_numerical_integral_trapezoidal",
        claim: "min E − C/√N ≤ E(γᵖˡ) − C/√N ≤ min E_tra,N ≤ min E + C/N",
        needs: [CONSTANTS, MINIMISER, GLOBAL],
        verdict: Holds,
        code: theorem_1_1,
        is_a_bound: true,
    }
    Theorem1_2 {
        number: "Theorem 1.2",
        label: "theo:approx_numerical_integral_trapezoidal_length",
        claim: "L(γᵖˡ)² − d² ≤ C/√N for the trapezoidal rule, with the C of Theorem 1.1",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: theorem_1_2,
        is_a_bound: true,
    }
    Theorem1_3 {
        number: "Theorem 1.3",
        label: "theo:approx_numerical_integral_left",
        claim: "min E − C/√N ≤ E(γᵖˡ) − C/√N ≤ min E_l,N ≤ min E + C/√N",
        needs: [CONSTANTS, MINIMISER, GLOBAL],
        verdict: Holds,
        code: theorem_1_3,
        is_a_bound: true,
    }
    Theorem1_4 {
        number: "Theorem 1.4",
        label: "theo:approx_numerical_integral_left_length",
        claim: "L(γᵖˡ)² − d² ≤ C/√N for the left-endpoint rule, with the C of Theorem 1.3",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: theorem_1_4,
        is_a_bound: true,
    }
    Proposition3_1 {
        number: "Proposition 3.1",
        label: "prop:metric_geodesic_constant",
        claim: "a geodesic has constant speed, its length",
        needs: [checked(&["γ̈ = −Γ(γ̇, γ̇)"])],
        verdict: Holds,
        code: prop_3_1,
    }
    Proposition3_2 {
        number: "Proposition 3.2",
        label: "prop:Hopf-Rinow-theorem",
        claim: "in a complete space two points are joined by a minimal geodesic",
        needs: [assumed(&["geodesics never end"])],
        verdict: Cited,
        code: prop_3_2,
    }
    Proposition3_3 {
        number: "Proposition 3.3",
        label: "prop:bounded_g_completeness",
        claim: "c₁ ≤ H ≤ c₂ makes the space complete: c₁∣x − y∣² ≤ d(x, y)² ≤ c₂∣x − y∣²",
        needs: [
            checked(&["c₁ ≤ λ_min(H)", "λ_max(H) ≤ c₂"]),
            assumed(&["c₁ and c₂ hold elsewhere"]),
        ],
        verdict: Holds,
        code: prop_3_3,
    }
    Proposition4_1 {
        number: "Proposition 4.1",
        label: "prop:geodesic_min_loc_path_min",
        claim: "near a point, the minimal curves are the minimal geodesics, reparametrised",
        needs: [
            checked(&[
                "L(γ**) ≤ d",
                "d < ε",
                "γ** joins the points",
                "γ̈** = −Γ(γ̇**, γ̇**)",
                "∫|φ′| ≤ 1",
            ]),
        ],
        verdict: HoldsReadAs("\"monotone increasing\" is nondecreasing: the curve may pause"),
        code: prop_4_1,
    }
    Proposition4_2 {
        number: "Proposition 4.2",
        label: "prop:geodesic_min_path_min",
        claim: "everywhere, the minimal curves are the minimal geodesics, reparametrised",
        needs: [
            checked(&[
                "L(γ) ≤ d",
                "L(γ**) ≤ d",
                "γ joins the points",
                "γ** joins the points",
                "γ̈** = −Γ(γ̇**, γ̇**)",
                "∫|φ′| ≤ 1",
            ]),
            assumed(&["γ** is the only minimal geodesic"]),
        ],
        verdict: HoldsReadAs("\"monotone increasing\" is nondecreasing: the curve may pause"),
        code: prop_4_2,
    }
    Proposition4_3 {
        number: "Proposition 4.3",
        label: "prop:uniformal_normal_radius",
        claim: "on a compact set, geodesics shorter than one common radius are minimal and unique",
        needs: [checked(&["K is bounded", "x ∈ K", "|v| < ε"])],
        verdict: Cited,
        code: prop_4_3,
    }
    Lemma4_4 {
        number: "Lemma 4.4",
        label: "lem:minimal_constant_speed_geodesic",
        claim: "a minimal curve of constant speed is a geodesic",
        needs: [checked(&["L(γ) ≤ d", "the speed is constant", "γ joins the points"])],
        verdict: Holds,
        code: lemma_4_4,
    }
    Section5Left {
        number: "Section 5, left-endpoint rule",
        label: "eq:length-left-point-min",
        claim: "over the valleys min L_l,N = 4π for every N, and the distance is 8π",
        needs: [checked(&["γᵖ begins at (0, 0)", "γᵖ ends at (4π, 0)"])],
        verdict: Holds,
        code: section_5_left,
    }
    Section5Trapezoidal {
        number: "Section 5, trapezoidal rule",
        label: "eq:length-tra-point-min",
        claim: "over the valleys min L_tra,N = 4π for every N, and the distance is 8π",
        needs: [checked(&["γᵖ begins at (0, 0)", "γᵖ ends at (4π, 0)"])],
        verdict: Holds,
        code: section_5_trapezoidal,
    }
    Proposition6_1 {
        number: "Proposition 6.1",
        label: "prop:geodesic_len_and_energy",
        claim: "between two points min E = min L², and the minimisers of E are the minimal \
            geodesics",
        needs: [ENDS, checked(&["the two sets are points"])],
        verdict: Holds,
        code: prop_6_1,
    }
    Proposition6_2 {
        number: "Proposition 6.2",
        label: "prop:bounded_2sets_min",
        claim: "two closed sets, one bounded, have a nearest pair, and the set of nearest pairs \
            is compact",
        needs: [
            checked(&[
                "c₁ ≤ λ_min(H) at x and y",
                "one of the sets is bounded",
                "the sets are closed",
                "x ∈ X⁽⁰⁾ and y ∈ X⁽¹⁾",
            ]),
            assumed(&["c₁ ≤ λ_min(H) everywhere"]),
        ],
        verdict: Holds,
        code: prop_6_2,
    }
    Proposition6_3 {
        number: "Proposition 6.3",
        label: "prop:geodesic_len_and_energy_2",
        claim: "between two closed sets, one bounded, min E = min L², at minimal geodesics",
        needs: [ENDS],
        verdict: Holds,
        code: prop_6_3,
    }
    Proposition7_1 {
        number: "Proposition 7.1",
        label: "prop:existence_discrete_minimizers",
        claim: "H ≥ c₁ and a bounded set: both discrete energies have a minimiser, within √(E/c₁) \
            of that set",
        needs: [
            ENDS,
            checked(&[
                "both sequences have the same N",
                "c₁ ≤ λ_min(H)",
                "one of the sets is bounded",
            ]),
            assumed(&["c₁ holds elsewhere"]),
        ],
        verdict: Holds,
        code: prop_7_1,
    }
    Proposition7_2 {
        number: "Proposition 7.2",
        label: "prop:morrey_ineq",
        claim: "∣γ(s₂) − γ(s₁)∣ ≤ √(s₂ − s₁) ‖γ̇‖ on [s₁, s₂], and ∣γ(s)∣ ≤ ‖γ‖ + 2‖γ̇‖ there",
        needs: [],
        verdict: RefutedRepairedAs(
            "the second with ‖γ‖/√l + √(l/3) ‖γ̇‖ on an interval of length l",
        ),
        code: prop_7_2,
        refuted_by: Refutation {
            witness: "the constant curve γ = 1 on [0, 1/4], where ‖γ‖ = 1/2 and ‖γ̇‖ = 0",
            relied_on_by: "Proposition 7.3, and Proposition 7.6 on [0, 1], where it holds",
            evidence: refutations::still_curve,
        },
    }
    Proposition7_3 {
        number: "Proposition 7.3",
        label: "prop:morrey_ineq_cor",
        claim: "∣γ(s₂) − γ(s₁)∣ ≤ l (‖γ̇‖ + 2‖γ̈‖) on an interval of length l",
        needs: [NO_KINK],
        verdict: RefutedRepairedAs(
            "l (‖γ̇‖/√l + √(l/3) ‖γ̈‖); or l (‖γ̇‖ + ‖γ̈‖/√3) with the norms over [0, 1], where γ̇ does not jump",
        ),
        code: prop_7_3,
        refuted_by: Refutation {
            witness: "γ(t) = t on [0, 1/4]",
            relied_on_by: "Proposition 7.6, which needs it on [0, 1] only",
            evidence: refutations::straight_line,
        },
    }
    Proposition7_4 {
        number: "Proposition 7.4",
        label: "prop:approx_numerical_integral_beta-gamma",
        claim: "∣βₙ − γ̇(t)∣ ≤ 2 ‖γ̈‖/√N on the n-th subinterval",
        needs: [NO_KINK],
        verdict: RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        code: prop_7_4,
        is_a_bound: true,
        refuted_by: Refutation {
            witness: "γ(t) = |t − 1/2| with N = 1: β = 0, γ̇(0) = −1, and γ̈ = 0 but for the kink",
            relied_on_by: "Proposition 7.6; Theorem 1.1 applies both to geodesics, which are smooth",
            evidence: refutations::kink,
        },
    }
    Proposition7_5 {
        number: "Proposition 7.5",
        label: "prop:functional_lipschitz_estimate",
        claim: "∣u₁ᵀH(x₁)u₁ − u₂ᵀH(x₂)u₂∣ ≤ L∣x₁ − x₂∣∣u₁∣² + c₂∣u₁ − u₂∣² + 2c₂∣u₁∣∣u₁ − u₂∣",
        needs: [
            checked(&["0 ≤ λ_min(H(x₂))", "λ_max(H(x₂)) ≤ c₂", "‖H(x₁) − H(x₂)‖ ≤ L_H |x₁ − x₂|"]),
        ],
        verdict: RefutedRepairedAs("0 ≤ H(x₂) ≤ c₂, not only H ≤ c₂"),
        code: prop_7_5,
        refuted_by: Refutation {
            witness: "D = 1, H = −2 ≤ c₂ = 1, u₁ = 0 and u₂ = 1",
            relied_on_by: "Proposition 7.6, where H is a metric and so positive",
            evidence: refutations::negative_form,
        },
    }
    Proposition7_6 {
        number: "Proposition 7.6",
        label: "prop:approx_numerical_integral",
        claim: "∣E(γ) − E_tra,N(γ)∣ ≤ C_tra(N) where ‖γ̇‖ ≤ K₁ and ‖γ̈‖ ≤ K₂",
        needs: [CONSTANTS, NO_KINK],
        verdict: RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        code: prop_7_6,
        is_a_bound: true,
        refuted_by: Refutation {
            witness: "γ(t) = |t − 1/2| with H = 1, N = 1, K₁ = 1 and K₂ = 1/10: E = 1 and E_tra,N \
                = 0",
            relied_on_by: "Proposition 7.7 and Theorem 1.1, for minimal geodesics, which are smooth",
            evidence: refutations::kink_between_samples,
        },
    }
    ConstantCTra {
        number: "C_tra(N)",
        label: "C_tra(N)",
        claim: "C_tra(N) = (L_H (K₁³ + 2K₁²K₂) + 4c₂K₁K₂)/N + 4c₂K₂²/N²",
        needs: [],
        verdict: Holds,
        code: constant_c_tra,
    }
    ConstantCTraSharp {
        number: "C_tra♯",
        label: "C_tra^sharp",
        claim: "C_tra(N) ≤ C_tra♯/N",
        needs: [],
        verdict: Holds,
        code: constant_c_tra_sharp,
        is_a_bound: true,
    }
    Proposition7_7 {
        number: "Proposition 7.7",
        label: "prop:approx_numerical_integral_set",
        claim: "inf E_tra,N ≤ inf E + C_tra(N) over a set of such curves",
        needs: [CONSTANTS, NO_KINK],
        verdict: RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        code: prop_7_7,
        is_a_bound: true,
        refuted_by: Refutation {
            witness: "from 0 to 1 in the time 1/N over a ridge, then at rest; any N ≥ 17, here 17",
            relied_on_by: "Theorem 1.1, for minimal geodesics, which are smooth",
            evidence: refutations::fast_start,
        },
    }
    Proposition7_8 {
        number: "Proposition 7.8",
        label: "prop:ineq_cube_3/2",
        claim: "Σ xₙ³ ≤ (Σ xₙ²)^{3/2}",
        needs: [checked(&["0 ≤ xₙ"])],
        verdict: Holds,
        code: prop_7_8,
    }
    Proposition7_9 {
        number: "Proposition 7.9",
        label: "prop:approx_numerical_integral_pts",
        claim: "∣E(γᵖˡ) − E_tra,N(γᵖ)∣ ≤ L_H K₃³/(4√N) for every point sequence",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_7_9,
        is_a_bound: true,
    }
    Proposition7_10 {
        number: "Proposition 7.10",
        label: "prop:estimate_derivation_g",
        claim: "∣∂ₗ H_ij∣ ≤ L_H",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_7_10,
        is_a_bound: true,
    }
    Proposition7_11 {
        number: "Proposition 7.11",
        label: "prop:Christoffel_symbol_estimate",
        claim: "∣Γᵏ_ij∣ ≤ 3 L_H √D/(2 c₁)",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_7_11,
        is_a_bound: true,
    }
    ConstantK1 {
        number: "K_{1,g}",
        label: "K_{1,g}",
        claim: "K_{1,g} = d/√c₁ bounds the speed of a minimal geodesic",
        needs: [CONSTANTS, GEODESIC],
        verdict: Holds,
        code: constant_k1,
        is_a_bound: true,
    }
    ConstantK2 {
        number: "K_{2,g}",
        label: "K_{2,g}",
        claim: "K_{2,g} = 3 L_H D² K_{1,g}²/(2 c₁) bounds its acceleration",
        needs: [CONSTANTS, GEODESIC],
        verdict: Holds,
        code: constant_k2,
        is_a_bound: true,
    }
    Proposition7_12 {
        number: "Proposition 7.12",
        label: "prop:apriori_estuimate_geodesic",
        claim: "every minimiser of E has ‖γ̇‖ ≤ K_{1,g} and ‖γ̈‖ ≤ K_{2,g}",
        needs: [CONSTANTS, checked(&["E(γ) ≤ d²"])],
        verdict: Holds,
        code: prop_7_12,
        is_a_bound: true,
    }
    ConstantK3Bar {
        number: "K̄_{3,g}",
        label: "overline K_{3,g}",
        claim: "K̄_{3,g}² = (d² + C_tra♯)/c₁ bounds K₃² of the minimisers of E_tra,N",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: constant_k3_bar,
        is_a_bound: true,
    }
    ConstantC1_1 {
        number: "C of Theorem 1.1",
        label: "C (Theorem 1.1)",
        claim: "C = C_tra♯ + L_H K̄_{3,g}³/4: C_tra♯/N + L_H K̄_{3,g}³/(4√N) ≤ C/√N",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: constant_c_1_1,
        is_a_bound: true,
    }
    Proposition8_1 {
        number: "Proposition 8.1",
        label: "prop:left_trapezoidal_fomula",
        claim: "∣E_l,N(γᵖ) − E_tra,N(γᵖ)∣ ≤ L_H K₃³/(2√N) for every point sequence",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_8_1,
        is_a_bound: true,
    }
    Proposition8_2 {
        number: "Proposition 8.2",
        label: "prop:approx_numerical_integral_pts_left",
        claim: "∣E(γᵖˡ) − E_l,N(γᵖ)∣ ≤ L_H K₃³/(2√N) for every point sequence",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_8_2,
        is_a_bound: true,
    }
    ConstantK4Bar {
        number: "K̄_{4,g}",
        label: "overline K_{4,g}",
        claim: "K̄_{4,g}² = (d² + C_tra♯ + L_H K̄_{3,g}³/2)/c₁ bounds K₃² of the minimisers of \
            E_l,N",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: constant_k4_bar,
        is_a_bound: true,
    }
    ConstantC1_3 {
        number: "C of Theorem 1.3",
        label: "C (Theorem 1.3)",
        claim: "C = C_tra♯ + L_H (K̄_{3,g}³ + K̄_{4,g}³)/2 bounds all three gaps of the left rule",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: constant_c_1_3,
        is_a_bound: true,
    }
    Proposition9_1 {
        number: "Proposition 9.1",
        label: "prop:length_energy_estimation",
        claim: "L(γ)² − L(γ*)² ≤ E(γ) − E(γ*) where γ* has the least length",
        needs: [checked(&["E(γ*) ≤ d²", "L(γ*) ≤ d", "γ joins the sets", "γ* joins the sets"])],
        verdict: RefutedRepairedAs("γ* has the least energy"),
        code: prop_9_1,
        refuted_by: Refutation {
            witness: "H = 1 from 0 to 1, γ* = t² and γ = t: both have the least length",
            relied_on_by: "Theorems 1.2 and 1.4, where γ* is a minimal geodesic",
            evidence: refutations::late_minimiser,
        },
    }
    Remark9_2 {
        number: "Remark 9.2",
        label: "Remark 9.2",
        claim: "the minima converge like 1/N; whether E(γᵖˡ) and L(γᵖˡ)² do better than 1/√N is \
            left open",
        needs: [CONSTANTS, ENDS, GLOBAL],
        verdict: OpenAnsweredBy("they converge like 1/N under the same hypotheses, for both rules"),
        code: remark_9_2,
    }
    LemmaS1 {
        number: "Lemma S.1",
        label: "sharper:acceleration",
        claim: "∣γ̈∣ ≤ G d/√c₁ for a minimal geodesic, with G = ωδ, ω = 3/2, or ½ for an \
            isotropic metric, and less with M_H",
        needs: [CONSTANTS, CURVATURE, GEODESIC],
        verdict: ProvedHere,
        code: lemma_s_1,
    }
    LemmaS2 {
        number: "Lemma S.2",
        label: "sharper:gaps",
        claim: "∣E(γᵖˡ) − E_N∣ ≤ (k L_H/N) mean ∣β∣³ for both rules, ≤ (M_H/24N²) mean ∣β∣⁴ for \
            the trapezoidal one",
        needs: [CONSTANTS, CURVATURE],
        verdict: ProvedHere,
        code: lemma_s_2,
    }
    LemmaS3 {
        number: "Lemma S.3",
        label: "sharper:speeds",
        claim: "max qₙ ≤ √E_N + (L_H/c₁^{3/2}) E_N + mean∣ρ∣/√c₁ with the residual ρ of the inner \
            points",
        needs: [CONSTANTS],
        verdict: ProvedHere,
        code: lemma_s_3,
    }
    LemmaS4 {
        number: "Lemma S.4",
        label: "sharper:ceiling",
        claim: "min E_N ≤ d² e with e − 1 = O(1/N) for both rules, O(1/N²) for the trapezoidal one",
        needs: [CONSTANTS, CURVATURE, ENDS, GLOBAL],
        verdict: ProvedHere,
        code: lemma_s_4,
    }
    LemmaS5 {
        number: "Lemma S.5",
        label: "sharper:spread",
        claim: "L(γᵖˡ)² ≤ E_N + (kΛ/N) E_N^{3/2}, ≤ E_tra,N + (M_H/24c₁²N²) E_tra,N² for every \
            sequence; E_N ≤ d² ε bounds the variance and the moments of the speeds",
        needs: [CONSTANTS, CURVATURE, ENDS, checked(&["0 < d"])],
        verdict: ProvedHere,
        code: lemma_s_5,
    }
    TheoremA {
        number: "Theorem A",
        label: "sharper:A",
        claim: "E(γᵖˡ) − d² ≤ d² [e − 1 + (kδ/N) e Q] = O(1/N), without D and c₂",
        needs: [CONSTANTS, CURVATURE, MINIMISER],
        verdict: ProvedHere,
        code: theorem_a,
    }
    TheoremB {
        number: "Theorem B",
        label: "sharper:B",
        claim: "E(γᵖˡ) − d² ≤ d² [e₂ − 1 + (μ/24N²) e₂ Q²] = O(1/N²) for the trapezoidal rule",
        needs: [CONSTANTS, CURVATURE, MINIMISER],
        verdict: ProvedHere,
        code: theorem_b,
    }
    TheoremC {
        number: "Theorem C",
        label: "sharper:C",
        claim: "E(γᵖˡ) − d² ≤ d² [e − 1 + (kδ/N) m₃] ~ 2kδ d²/N and d² − E_N ≤ kδ d²/N from the \
            energy alone",
        needs: [CONSTANTS, CURVATURE, MINIMISER],
        verdict: ProvedHere,
        code: theorem_c,
    }
    TheoremD {
        number: "Theorem D",
        label: "sharper:D",
        claim: "E(γᵖˡ) − d² ≤ d² [ε − 1 + (μ/24N²) m₄] ~ (G²/12 + μ/12) d²/N² and d² − E_tra,N ≤ \
            μ d²/24N² from the energy alone, trapezoidal rule",
        needs: [CONSTANTS, CURVATURE, MINIMISER],
        verdict: ProvedHere,
        code: theorem_d,
    }
    PropositionS6 {
        number: "Proposition S.6",
        label: "sharper:enclosure",
        claim: "max{d² : d² e(d) ≤ min E_N} ≤ d² ≤ L(γᵖˡ)² from one computed sequence",
        needs: [CONSTANTS, CURVATURE, ENDS, GLOBAL],
        verdict: ProvedHere,
        code: prop_s_6,
    }
    PropositionS7 {
        number: "Proposition S.7",
        label: "sharper:convexity",
        claim: "where c₁ − 2L_H Br − ½M_H B²r² > 0, E_N is strictly convex and a computed minimum \
            between two points global",
        needs: [
            CONSTANTS,
            CURVATURE,
            checked(&["N is the same", "the ends are the same", "x ≠ y"]),
        ],
        verdict: ProvedHere,
        code: prop_s_7,
    }
    PropositionS8 {
        number: "Proposition S.8",
        label: "sharper:region",
        claim: "where d̄² e < c₁R² with the constants within R of the bounded end, no minimal \
            geodesic and no discrete minimiser goes farther",
        needs: [CONSTANTS, CURVATURE, MINIMISER, GLOBAL],
        verdict: ProvedHere,
        code: prop_s_8,
    }
}
