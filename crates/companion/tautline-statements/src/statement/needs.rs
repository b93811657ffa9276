//! `Needs`: groups of hypotheses, for the rows of the table.

/// Hypotheses that belong together.
pub(crate) struct Needs {
    /// They are checked on every case.
    pub(crate) checked: &'static [&'static str],
    /// They are assumed, since no finite number of evaluations shows them.
    pub(crate) assumed: &'static [&'static str],
}

pub(super) const fn checked(checked: &'static [&'static str]) -> Needs {
    Needs { checked, assumed: &[] }
}

pub(super) const fn assumed(assumed: &'static [&'static str]) -> Needs {
    Needs { checked: &[], assumed }
}

pub(super) const CONSTANTS: Needs = Needs {
    checked: &["c₁ ≤ λ_min(H)", "λ_max(H) ≤ c₂", "‖H(x) − H(y)‖/|x − y| ≤ L_H"],
    assumed: &["c₁, c₂ and L_H hold elsewhere"],
};

pub(super) const CURVATURE: Needs =
    Needs { checked: &["|uᵀ D²H[w, w] u| ≤ M_H"], assumed: &["M_H holds elsewhere"] };

pub(super) const ENDS: Needs = checked(&["the ends lie in X⁽⁰⁾ and X⁽¹⁾"]);

/// The energy of the sequence is at most the bound on the minimum in the proof.
pub(super) const MINIMISER: Needs = checked(&[
    "the rule is that of the theorem",
    "the ends lie in X⁽⁰⁾ and X⁽¹⁾",
    "E_N ≤ the proof's bound on the minimum",
]);

pub(super) const GLOBAL: Needs = assumed(&["γᵖ is a global minimiser"]);

pub(super) const GEODESIC: Needs = checked(&["|γ̈ + Γ(γ̇, γ̇)| = 0", "|g(γ̇, γ̇) − d²| = 0"]);

pub(super) const NO_KINK: Needs = checked(&["γ̇ does not jump"]);
