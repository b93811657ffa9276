//! The table of statements, one row each. Pages, tables and tests are made from it.

use super::needs::{
    CONSTANTS, CURVATURE, ENDS, GEODESIC, GLOBAL, MINIMISER, NO_KINK, assumed, checked,
};
use super::row::{Refutation, Row, or, statements};
use crate::{
    Verdict::{Cited, Holds, HoldsReadAs, OpenAnsweredBy, ProvedHere, RefutedRepairedAs},
    refutations,
};

// `‖·‖` is the norm of L² over the interval in question.
statements! {
    Theorem1_1 "Theorem 1.1" "theo:approx_numerical_integral_trapezoidal" {
        claim: "min E − C/√N ≤ E(γᵖˡ) − C/√N ≤ min E_tra,N ≤ min E + C/N",
        needs: [CONSTANTS, MINIMISER, GLOBAL],
        verdict: Holds,
        code: theorem_1_1, is_a_bound: true,
    }
    Theorem1_2 "Theorem 1.2" "theo:approx_numerical_integral_trapezoidal_length" {
        claim: "L(γᵖˡ)² − d² ≤ C/√N for the trapezoidal rule, with the C of Theorem 1.1",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: theorem_1_2, is_a_bound: true,
    }
    Theorem1_3 "Theorem 1.3" "theo:approx_numerical_integral_left" {
        claim: "min E − C/√N ≤ E(γᵖˡ) − C/√N ≤ min E_l,N ≤ min E + C/√N",
        needs: [CONSTANTS, MINIMISER, GLOBAL],
        verdict: Holds,
        code: theorem_1_3, is_a_bound: true,
    }
    Theorem1_4 "Theorem 1.4" "theo:approx_numerical_integral_left_length" {
        claim: "L(γᵖˡ)² − d² ≤ C/√N for the left-endpoint rule, with the C of Theorem 1.3",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: theorem_1_4, is_a_bound: true,
    }
    Proposition3_1 "Proposition 3.1" "prop:metric_geodesic_constant" {
        claim: "A geodesic has constant speed, equal to its length",
        needs: [checked(&["γ̈ = −Γ(γ̇, γ̇)"])],
        verdict: Holds,
        code: prop_3_1,
    }
    Proposition3_2 "Proposition 3.2" "prop:Hopf-Rinow-theorem" {
        claim: "In a complete space two points are joined by a minimal geodesic",
        needs: [assumed(&["geodesics never end"])],
        verdict: Cited,
        code: prop_3_2,
    }
    Proposition3_3 "Proposition 3.3" "prop:bounded_g_completeness" {
        claim: "c₁ ≤ H ≤ c₂ makes the space complete: c₁∣x − y∣² ≤ d(x, y)² ≤ c₂∣x − y∣²",
        needs: [
            checked(&["c₁ ≤ λ_min(H)", "λ_max(H) ≤ c₂"]),
            assumed(&["c₁ and c₂ hold elsewhere"]),
        ],
        verdict: Holds,
        code: prop_3_3,
    }
    Proposition4_1 "Proposition 4.1" "prop:geodesic_min_loc_path_min" {
        claim: "Near a point, the minimal curves are the minimal geodesics, reparametrised",
        needs: [
            checked(&["L(γ**) ≤ d", "d < ε", "γ** joins the points"]),
            checked(&["γ̈** = −Γ(γ̇**, γ̇**)", "∫|φ′| ≤ 1"]),
        ],
        verdict: HoldsReadAs("\"monotone increasing\" is nondecreasing: the curve may pause"),
        code: prop_4_1,
    }
    Proposition4_2 "Proposition 4.2" "prop:geodesic_min_path_min" {
        claim: "Everywhere, the minimal curves are the minimal geodesics, reparametrised",
        needs: [
            checked(&["L(γ) ≤ d", "L(γ**) ≤ d", "γ joins the points", "γ** joins the points"]),
            checked(&["γ̈** = −Γ(γ̇**, γ̇**)", "∫|φ′| ≤ 1"]),
            assumed(&["γ** is the only minimal geodesic"]),
        ],
        verdict: HoldsReadAs("\"monotone increasing\" is nondecreasing: the curve may pause"),
        code: prop_4_2,
    }
    Proposition4_3 "Proposition 4.3" "prop:uniformal_normal_radius" {
        claim: "On a compact set, geodesics shorter than one common radius are minimal and unique",
        needs: [checked(&["K is bounded", "x ∈ K", "|v| < ε"])],
        verdict: Cited,
        code: prop_4_3,
    }
    Lemma4_4 "Lemma 4.4" "lem:minimal_constant_speed_geodesic" {
        claim: "A minimal curve of constant speed is a geodesic",
        needs: [checked(&["L(γ) ≤ d", "the speed is constant", "γ joins the points"])],
        verdict: Holds,
        code: lemma_4_4,
    }
    Section5Left "Section 5, left-endpoint rule" "eq:length-left-point-min" {
        claim: "Over the valleys min L_l,N = 4π for every N, and the distance is 8π",
        needs: [checked(&["γᵖ begins at (0, 0)", "γᵖ ends at (4π, 0)"])],
        verdict: Holds,
        code: section_5_left,
    }
    Section5Trapezoidal "Section 5, trapezoidal rule" "eq:length-tra-point-min" {
        claim: "Over the valleys min L_tra,N = 4π for every N, and the distance is 8π",
        needs: [checked(&["γᵖ begins at (0, 0)", "γᵖ ends at (4π, 0)"])],
        verdict: Holds,
        code: section_5_trapezoidal,
    }
    Proposition6_1 "Proposition 6.1" "prop:geodesic_len_and_energy" {
        claim: "Between two points min E = min L², and the minimisers of E are the minimal \
            geodesics",
        needs: [ENDS, checked(&["the two sets are points"])],
        verdict: Holds,
        code: prop_6_1,
    }
    Proposition6_2 "Proposition 6.2" "prop:bounded_2sets_min" {
        claim: "Two closed sets, one bounded, have a nearest pair, and the set of nearest pairs \
            is compact",
        needs: [
            checked(&["c₁ ≤ λ_min(H) at x and y", "one of the sets is bounded"]),
            checked(&["the sets are closed", "x ∈ X⁽⁰⁾ and y ∈ X⁽¹⁾"]),
            assumed(&["c₁ ≤ λ_min(H) everywhere"]),
        ],
        verdict: Holds,
        code: prop_6_2,
    }
    Proposition6_3 "Proposition 6.3" "prop:geodesic_len_and_energy_2" {
        claim: "Between two closed sets, one bounded, min E = min L², at minimal geodesics",
        needs: [ENDS],
        verdict: Holds,
        code: prop_6_3,
    }
    Proposition7_1 "Proposition 7.1" "prop:existence_discrete_minimizers" {
        claim: "H ≥ c₁ and a bounded set: both discrete energies have a minimiser, within √(E/c₁) \
            of that set",
        needs: [
            ENDS,
            checked(&["both sequences have the same N", "c₁ ≤ λ_min(H)"]),
            checked(&["one of the sets is bounded"]),
            assumed(&["c₁ holds elsewhere"]),
        ],
        verdict: Holds,
        code: prop_7_1,
    }
    Proposition7_2 "Proposition 7.2" "prop:morrey_ineq" {
        claim: "∣γ(s₂) − γ(s₁)∣ ≤ √(s₂ − s₁) ‖γ̇‖ on [s₁, s₂], and ∣γ(s)∣ ≤ ‖γ‖ + 2‖γ̇‖ there",
        verdict: RefutedRepairedAs(
            "the second bound is ‖γ‖/√l + √(l/3) ‖γ̇‖ on an interval of length l",
        ),
        code: prop_7_2,
        refuted_by: Refutation {
            witness: "the constant curve γ = 1 on [0, 1/4], where ‖γ‖ = 1/2 and ‖γ̇‖ = 0",
            relied_on_by: "Proposition 7.3, and Proposition 7.6 on [0, 1], where it holds",
            evidence: refutations::still_curve,
        },
    }
    Proposition7_3 "Proposition 7.3" "prop:morrey_ineq_cor" {
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
    Proposition7_4 "Proposition 7.4" "prop:approx_numerical_integral_beta-gamma" {
        claim: "∣βₙ − γ̇(t)∣ ≤ 2 ‖γ̈‖/√N on the n-th subinterval",
        needs: [NO_KINK],
        verdict: RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        code: prop_7_4, is_a_bound: true,
        refuted_by: Refutation {
            witness: "γ(t) = |t − 1/2| with N = 1: β = 0, γ̇(0) = −1, and γ̈ = 0 but for the kink",
            relied_on_by: "Proposition 7.6; Theorem 1.1 applies both to geodesics, which are smooth",
            evidence: refutations::kink,
        },
    }
    Proposition7_5 "Proposition 7.5" "prop:functional_lipschitz_estimate" {
        claim: "∣u₁ᵀH(x₁)u₁ − u₂ᵀH(x₂)u₂∣ ≤ L∣x₁ − x₂∣∣u₁∣² + c₂∣u₁ − u₂∣² + 2c₂∣u₁∣∣u₁ − u₂∣",
        needs: [checked(&[
            "0 ≤ λ_min(H(x₂))", "λ_max(H(x₂)) ≤ c₂", "‖H(x₁) − H(x₂)‖ ≤ L_H |x₁ − x₂|",
        ])],
        verdict: RefutedRepairedAs("0 ≤ H(x₂) ≤ c₂, not only H ≤ c₂"),
        code: prop_7_5,
        refuted_by: Refutation {
            witness: "D = 1, H = −2 ≤ c₂ = 1, u₁ = 0 and u₂ = 1",
            relied_on_by: "Proposition 7.6, where H is a metric and so positive",
            evidence: refutations::negative_form,
        },
    }
    Proposition7_6 "Proposition 7.6" "prop:approx_numerical_integral" {
        claim: "∣E(γ) − E_tra,N(γ)∣ ≤ C_tra(N) where ‖γ̇‖ ≤ K₁ and ‖γ̈‖ ≤ K₂",
        needs: [CONSTANTS, NO_KINK],
        verdict: RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        code: prop_7_6, is_a_bound: true,
        refuted_by: Refutation {
            witness: "γ(t) = |t − 1/2| with H = 1, N = 1, K₁ = 1 and K₂ = 1/10: E = 1 and E_tra,N \
                = 0",
            relied_on_by: "Proposition 7.7 and Theorem 1.1, for minimal geodesics, which are smooth",
            evidence: refutations::kink_between_samples,
        },
    }
    ConstantCTra "C_tra(N)" "C_tra(N)" {
        claim: "C_tra(N) = (L_H (K₁³ + 2K₁²K₂) + 4c₂K₁K₂)/N + 4c₂K₂²/N²",
        verdict: Holds,
        code: constant_c_tra,
    }
    ConstantCTraSharp "C_tra♯" "C_tra^sharp" {
        claim: "C_tra(N) ≤ C_tra♯/N",
        verdict: Holds,
        code: constant_c_tra_sharp, is_a_bound: true,
    }
    Proposition7_7 "Proposition 7.7" "prop:approx_numerical_integral_set" {
        claim: "inf E_tra,N ≤ inf E + C_tra(N) over a set of curves with ‖γ̇‖ ≤ K₁ and ‖γ̈‖ ≤ K₂",
        needs: [CONSTANTS, NO_KINK],
        verdict: RefutedRepairedAs("γ̇ is absolutely continuous with γ̈ in L²: no kinks"),
        code: prop_7_7, is_a_bound: true,
        refuted_by: Refutation {
            witness: "from 0 to 1 in the time 1/N over a ridge, then at rest; any N ≥ 17, here 17",
            relied_on_by: "Theorem 1.1, for minimal geodesics, which are smooth",
            evidence: refutations::fast_start,
        },
    }
    Proposition7_8 "Proposition 7.8" "prop:ineq_cube_3/2" {
        claim: "Σ xₙ³ ≤ (Σ xₙ²)^{3/2}",
        needs: [checked(&["0 ≤ xₙ"])],
        verdict: Holds,
        code: prop_7_8,
    }
    Proposition7_9 "Proposition 7.9" "prop:approx_numerical_integral_pts" {
        claim: "∣E(γᵖˡ) − E_tra,N(γᵖ)∣ ≤ L_H K₃³/(4√N) for every point sequence",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_7_9, is_a_bound: true,
    }
    Proposition7_10 "Proposition 7.10" "prop:estimate_derivation_g" {
        claim: "∣∂ₗ H_ij∣ ≤ L_H",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_7_10, is_a_bound: true,
    }
    Proposition7_11 "Proposition 7.11" "prop:Christoffel_symbol_estimate" {
        claim: "∣Γᵏ_ij∣ ≤ 3 L_H √D/(2 c₁)",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_7_11, is_a_bound: true,
    }
    ConstantK1 "K_{1,g}" "K_{1,g}" {
        claim: "K_{1,g} = d/√c₁ bounds the speed of a minimal geodesic",
        needs: [CONSTANTS, GEODESIC],
        verdict: Holds,
        code: constant_k1, is_a_bound: true,
    }
    ConstantK2 "K_{2,g}" "K_{2,g}" {
        claim: "K_{2,g} = 3 L_H D² K_{1,g}²/(2 c₁) bounds the acceleration of a minimal geodesic",
        needs: [CONSTANTS, GEODESIC],
        verdict: Holds,
        code: constant_k2, is_a_bound: true,
    }
    Proposition7_12 "Proposition 7.12" "prop:apriori_estuimate_geodesic" {
        claim: "Every minimiser of E has ‖γ̇‖ ≤ K_{1,g} and ‖γ̈‖ ≤ K_{2,g}",
        needs: [CONSTANTS, checked(&["E(γ) ≤ d²"])],
        verdict: Holds,
        code: prop_7_12, is_a_bound: true,
    }
    ConstantK3Bar "K̄_{3,g}" "overline K_{3,g}" {
        claim: "K̄_{3,g}² = (d² + C_tra♯)/c₁ bounds K₃² of the minimisers of E_tra,N",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: constant_k3_bar, is_a_bound: true,
    }
    ConstantC1_1 "C of Theorem 1.1" "C (Theorem 1.1)" {
        claim: "C = C_tra♯ + L_H K̄_{3,g}³/4: C_tra♯/N + L_H K̄_{3,g}³/(4√N) ≤ C/√N",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: constant_c_1_1, is_a_bound: true,
    }
    Proposition8_1 "Proposition 8.1" "prop:left_trapezoidal_fomula" {
        claim: "∣E_l,N(γᵖ) − E_tra,N(γᵖ)∣ ≤ L_H K₃³/(2√N) for every point sequence",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_8_1, is_a_bound: true,
    }
    Proposition8_2 "Proposition 8.2" "prop:approx_numerical_integral_pts_left" {
        claim: "∣E(γᵖˡ) − E_l,N(γᵖ)∣ ≤ L_H K₃³/(2√N) for every point sequence",
        needs: [CONSTANTS],
        verdict: Holds,
        code: prop_8_2, is_a_bound: true,
    }
    ConstantK4Bar "K̄_{4,g}" "overline K_{4,g}" {
        claim: "K̄_{4,g}² = (d² + C_tra♯ + L_H K̄_{3,g}³/2)/c₁ bounds K₃² of the minimisers of \
            E_l,N",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: constant_k4_bar, is_a_bound: true,
    }
    ConstantC1_3 "C of Theorem 1.3" "C (Theorem 1.3)" {
        claim: "C = C_tra♯ + L_H (K̄_{3,g}³ + K̄_{4,g}³)/2 bounds all three gaps of the left rule",
        needs: [CONSTANTS, MINIMISER],
        verdict: Holds,
        code: constant_c_1_3, is_a_bound: true,
    }
    Proposition9_1 "Proposition 9.1" "prop:length_energy_estimation" {
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
    Remark9_2 "Remark 9.2" "Remark 9.2" {
        claim: "The minima converge like 1/N; whether E(γᵖˡ) and L(γᵖˡ)² do better than 1/√N under \
            additional discrete regularity or equidistribution information is left open",
        needs: [CONSTANTS, ENDS, GLOBAL],
        verdict: OpenAnsweredBy(
            "they converge like 1/N under the same hypotheses, for both rules; and like 1/N² for \
             the trapezoidal rule if DH is Lipschitz (Theorem D)",
        ),
        code: remark_9_2,
    }
    LemmaS1 "Lemma S.1" "sharper:acceleration" {
        claim: "∣γ̈∣ ≤ G d/√c₁ for a minimal geodesic, with G = ωδ, ω = 3/2, or ½ for an \
            isotropic metric, and less with M_H",
        needs: [CONSTANTS, CURVATURE, GEODESIC],
        verdict: ProvedHere,
        code: lemma_s_1,
    }
    LemmaS2 "Lemma S.2" "sharper:gaps" {
        claim: "∣E(γᵖˡ) − E_N∣ ≤ (k L_H/N) mean ∣β∣³ for both rules, ≤ (M_H/24N²) mean ∣β∣⁴ for \
            the trapezoidal one",
        needs: [CONSTANTS, CURVATURE],
        verdict: ProvedHere,
        code: lemma_s_2,
    }
    LemmaS3 "Lemma S.3" "sharper:speeds" {
        claim: "max qₙ ≤ √E_N + (L_H/c₁^{3/2}) E_N + mean∣ρ∣/√c₁ with the residual ρ of the inner \
            points",
        needs: [CONSTANTS],
        verdict: ProvedHere,
        code: lemma_s_3,
    }
    LemmaS4 "Lemma S.4" "sharper:ceiling" {
        claim: "min E_N ≤ d² e with e − 1 = O(1/N) for both rules, O(1/N²) for the trapezoidal one",
        needs: [CONSTANTS, CURVATURE, ENDS, GLOBAL],
        verdict: ProvedHere,
        code: lemma_s_4,
    }
    LemmaS5 "Lemma S.5" "sharper:spread" {
        claim: "L(γᵖˡ)² ≤ E_N + (kΛ/N) E_N^{3/2}, ≤ E_tra,N + (M_H/24c₁²N²) E_tra,N² for every \
            sequence; E_N ≤ d² ε bounds the variance and the moments of the speeds",
        needs: [CONSTANTS, CURVATURE, ENDS, checked(&["0 < d"])],
        verdict: ProvedHere,
        code: lemma_s_5,
    }
    TheoremA "Theorem A" "sharper:A" {
        claim: "E(γᵖˡ) − d² ≤ d² [e − 1 + (kδ/N) e Q] = O(1/N), without D and c₂",
        needs: [CONSTANTS, CURVATURE, MINIMISER],
        verdict: ProvedHere,
        code: theorem_a,
    }
    TheoremB "Theorem B" "sharper:B" {
        claim: "E(γᵖˡ) − d² ≤ d² [e₂ − 1 + (μ/24N²) e₂ Q²] = O(1/N²) for the trapezoidal rule",
        needs: [CONSTANTS, CURVATURE, MINIMISER],
        verdict: ProvedHere,
        code: theorem_b,
    }
    TheoremC "Theorem C" "sharper:C" {
        claim: "E(γᵖˡ) − d² ≤ d² [e − 1 + (kδ/N) m₃] ~ 2kδ d²/N and d² − E_N ≤ kδ d²/N from the \
            energy alone",
        needs: [CONSTANTS, CURVATURE, MINIMISER],
        verdict: ProvedHere,
        code: theorem_c,
    }
    TheoremD "Theorem D" "sharper:D" {
        claim: "E(γᵖˡ) − d² ≤ d² [ε − 1 + (μ/24N²) m₄] ~ (G²/12 + μ/12) d²/N² and d² − E_tra,N ≤ \
            μ d²/24N² for the trapezoidal rule, from the energy alone",
        needs: [CONSTANTS, CURVATURE, MINIMISER],
        verdict: ProvedHere,
        code: theorem_d,
    }
    PropositionS6 "Proposition S.6" "sharper:enclosure" {
        claim: "max{d² : d² e(d) ≤ min E_N} ≤ d² ≤ L(γᵖˡ)² from one computed sequence",
        needs: [CONSTANTS, CURVATURE, ENDS, GLOBAL],
        verdict: ProvedHere,
        code: prop_s_6,
    }
    PropositionS7 "Proposition S.7" "sharper:convexity" {
        claim: "Where c₁ − 2L_H Br − ½M_H B²r² > 0, E_N is strictly convex and a computed minimum \
            between two points is global",
        needs: [CONSTANTS, CURVATURE, checked(&["N is the same", "the ends are the same", "x ≠ y"])],
        verdict: ProvedHere,
        code: prop_s_7,
    }
    PropositionS8 "Proposition S.8" "sharper:region" {
        claim: "Where d̄² e < c₁R² with the constants within R of the bounded end, no minimal \
            geodesic and no discrete minimiser goes farther, nor, between points, farther than \
            ½ d̄ √(e/c₁) from their middle",
        needs: [CONSTANTS, CURVATURE, MINIMISER, GLOBAL],
        verdict: ProvedHere,
        code: prop_s_8,
    }
    PropositionS9 "Proposition S.9" "sharper:convex_excess" {
        claim: "E(γᵖˡ) − d² ≤ P + (K + S)²/4σ = O(1/N²) for any sequence between two points, for \
            both rules, where σ > 0",
        needs: [CONSTANTS, CURVATURE, ENDS],
        verdict: ProvedHere,
        code: prop_s_9,
    }
    PropositionS10 "Proposition S.10" "sharper:monotone" {
        claim: "For fixed constants no bound of Lemma S.4, of Theorems A to D and of Proposition S.8 \
            increases with N",
        needs: [checked(&["N ≤ M"])],
        verdict: ProvedHere,
        code: prop_s_10,
    }
}
