//! Lemma S.1: bounds on the acceleration of a minimal geodesic, without the dimension.

use tautline_metrics::Constants;

use crate::{Setting, product::product};

/// Bounds the acceleration `|γ̈(t)|` of every minimal geodesic at every time, in `ℓ` (Lemma S.1).
///
/// ```text
/// K₂  =  G d/√c₁  ≤  ω (L_H/c₁) K_{1,g}²,      ω = 3/2,  or ½ for an isotropic metric and on the line
/// ```
///
/// with the [`G`](Setting::bend) of the setting.
///
/// The geodesic equation is `H γ̈ = −r`, where `r = DH[γ̇] γ̇ − ½ ∇(vᵀHv)` has norm at most
/// `ω L_H |γ̇|²`. Estimating `r` as a vector, rather than each Christoffel symbol, avoids the
/// factor `D²` of `K_{2,g}`.
///
/// Needs: `H ≥ c₁`, `H` Lipschitz with `L_H`, and a minimiser of the energy. For an isotropic
/// metric with `M_H`, the constants must hold everywhere. Neither `c₂` nor the dimension is needed.
///
/// Overestimation: the bound is attained for every `D ≥ 2`, at one point of a geodesic, in the
/// limit `c₂ → c₁`.
#[doc(alias = "K_{2,g}")]
#[must_use]
pub fn k2_sharp(setting: Setting) -> f64 {
    product([setting.bend(), setting.distance(), 1.0 / setting.constants().c1().sqrt()])
}

/// Bounds every Christoffel symbol, `|Γᵏ_ij|`, in `1/ℓ`: Proposition 7.11 without its factor `√D`.
///
/// ```text
/// |Γᵏ_ij|  ≤  3 L_H/2c₁,      on the line  L_H/2c₁
/// ```
///
/// `Γᵏ_ij` is an entry of `H⁻¹ r` with `r = ½ (DH[eᵢ] eⱼ + DH[eⱼ] eᵢ − ∇(eᵢᵀ H eⱼ))`. Each of the
/// three vectors in the bracket has norm at most `L_H`.
///
/// Needs: `H ≥ c₁`, and `H` Lipschitz with `L_H`. Overestimation: the bound is attained.
///
/// # Panics
///
/// If `dimension` is 0.
#[doc(alias = "prop:Christoffel_symbol_estimate")]
#[must_use]
pub fn christoffel_bound(constants: Constants, dimension: usize) -> f64 {
    assert!(dimension > 0, "D must be at least 1");
    let factor = if dimension == 1 { 0.5 } else { 1.5 };
    factor * (constants.l_h() / constants.c1())
}

#[cfg(test)]
mod tests {
    use super::{christoffel_bound, k2_sharp};
    use crate::{Setting, by_hand::constants, k2_g};

    #[test]
    fn by_hand() {
        // c₁ = 4, L_H = 8, d = 3: K₁² = 9/4, L_H K₁²/c₁ = 9/2.
        let constants = constants(4.0, 10.0, 8.0);
        let setting =
            |constants, dimension| Setting::new(constants, 3.0, dimension).expect("valid");
        assert_eq!(k2_sharp(setting(constants, 2)), 6.75);
        assert_eq!(k2_sharp(setting(constants, 1)), 2.25);
        assert_eq!(k2_sharp(setting(constants.isotropic(), 7)), 2.25);
        assert_eq!(k2_sharp(setting(constants, 5)) * 25.0, k2_g(setting(constants, 5)));
        assert_eq!((christoffel_bound(constants, 3), christoffel_bound(constants, 1)), (3.0, 1.0));
    }
}
