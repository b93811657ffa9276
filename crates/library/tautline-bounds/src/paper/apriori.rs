//! `K_{1,g}` and `K_{2,g}`: bounds on speed and acceleration of a minimal geodesic.

use crate::{Setting, product::product};

/// Bounds the speed `‖γ̇‖_{L²}` of every minimiser of the energy, in `ℓ` (Proposition 7.12).
///
/// ```text
/// K_{1,g}  =  d / √c₁
/// ```
///
/// Needs: `H ≥ c₁`, and a minimiser of `E` among the curves between the ends. The bound does not
/// depend on `c₂`, `L_H` or `D`.
///
/// Overestimation: the bound is attained if `H = c₁` in the direction of the geodesic, all along
/// it. It also holds at every time, since a minimiser has constant Riemannian speed.
#[doc(alias = "K_{1,g}")]
#[doc(alias = "prop:apriori_estuimate_geodesic")]
#[must_use]
pub fn k1_g(setting: Setting) -> f64 {
    setting.distance() / setting.constants().c1().sqrt()
}

/// Bounds the acceleration `‖γ̈‖_{L²}` of every minimiser of the energy, in `ℓ` (Proposition 7.12).
///
/// ```text
/// K_{2,g}  =  (3 L_H D² / (2 c₁)) K_{1,g}²
/// ```
///
/// Needs: `H ≥ c₁`, `H` Lipschitz with `L_H`, and a minimiser of `E` among the curves between the
/// ends. The bound does not depend on `c₂`.
///
/// Overestimation: the proof sums over the Christoffel symbols, which costs the factor `D²`.
/// Estimating the geodesic equation as a vector ([`k2_sharp`](crate::k2_sharp)) avoids this factor.
#[doc(alias = "K_{2,g}")]
#[doc(alias = "prop:apriori_estuimate_geodesic")]
#[must_use]
pub fn k2_g(setting: Setting) -> f64 {
    let constants = setting.constants();
    let (l_h, k1, d) = (constants.l_h(), k1_g(setting), setting.dimension() as f64);
    // 1/c₁ may overflow, but its square root does not.
    let root = 1.0 / constants.c1().sqrt();
    product([1.5, l_h, d, d, root, root, k1, k1])
}
