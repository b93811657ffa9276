//! The sharper statements.

use super::{Entry, statement};
use crate::Verdict;

/// By the order of [`Statement::ALL`](crate::Statement::ALL), after those of the paper.
pub(super) const SHARPER: [Entry; 12] = [
    statement(
        "Lemma S.1",
        "sharper:acceleration",
        "∣γ̈∣ ≤ G d/√c₁ for a minimal geodesic, with G = ωδ, ω = 3/2, or ½ for an isotropic metric, and less with M_H",
        Verdict::ProvedHere,
        "lemma_s_1",
    ),
    statement(
        "Lemma S.2",
        "sharper:gaps",
        "∣E(γᵖˡ) − E_N∣ ≤ (k L_H/N) mean ∣β∣³ for both rules, ≤ (M_H/24N²) mean ∣β∣⁴ for the trapezoidal one",
        Verdict::ProvedHere,
        "lemma_s_2",
    ),
    statement(
        "Lemma S.3",
        "sharper:speeds",
        "max qₙ ≤ √E_N + (L_H/c₁^{3/2}) E_N + mean∣ρ∣/√c₁ with the residual ρ of the inner points",
        Verdict::ProvedHere,
        "lemma_s_3",
    ),
    statement(
        "Lemma S.4",
        "sharper:ceiling",
        "min E_N ≤ d² e with e − 1 = O(1/N) for both rules, O(1/N²) for the trapezoidal one",
        Verdict::ProvedHere,
        "lemma_s_4",
    ),
    statement(
        "Lemma S.5",
        "sharper:spread",
        "L(γᵖˡ)² ≤ E_N + (kΛ/N) E_N^{3/2}, ≤ E_tra,N + (M_H/24c₁²N²) E_tra,N² for every sequence; E_N ≤ d² ε bounds the variance and the moments of the speeds",
        Verdict::ProvedHere,
        "lemma_s_5",
    ),
    statement(
        "Theorem A",
        "sharper:A",
        "E(γᵖˡ) − d² ≤ d² [e − 1 + (kδ/N) e Q] = O(1/N), without D and c₂",
        Verdict::ProvedHere,
        "theorem_a",
    ),
    statement(
        "Theorem B",
        "sharper:B",
        "E(γᵖˡ) − d² ≤ d² [e₂ − 1 + (μ/24N²) e₂ Q²] = O(1/N²) for the trapezoidal rule",
        Verdict::ProvedHere,
        "theorem_b",
    ),
    statement(
        "Theorem C",
        "sharper:C",
        "E(γᵖˡ) − d² ≤ d² [e − 1 + (kδ/N) m₃] ~ 2kδ d²/N and d² − E_N ≤ kδ d²/N from the energy alone",
        Verdict::ProvedHere,
        "theorem_c",
    ),
    statement(
        "Theorem D",
        "sharper:D",
        "E(γᵖˡ) − d² ≤ d² [ε − 1 + (μ/24N²) m₄] ~ (G²/12 + μ/12) d²/N² and d² − E_tra,N ≤ μ d²/24N² from the energy alone, trapezoidal rule",
        Verdict::ProvedHere,
        "theorem_d",
    ),
    statement(
        "Proposition S.6",
        "sharper:enclosure",
        "max{d² : d² e(d) ≤ min E_N} ≤ d² ≤ L(γᵖˡ)² from one computed sequence",
        Verdict::ProvedHere,
        "prop_s_6",
    ),
    statement(
        "Proposition S.7",
        "sharper:convexity",
        "where c₁ − 2L_H Br − ½M_H B²r² > 0, E_N is strictly convex and a computed minimum between two points global",
        Verdict::ProvedHere,
        "prop_s_7",
    ),
    statement(
        "Proposition S.8",
        "sharper:region",
        "where d̄² e < c₁R² with the constants within R of the bounded end, no minimal geodesic and no discrete minimiser goes farther",
        Verdict::ProvedHere,
        "prop_s_8",
    ),
];
