//! The `L²` norms of a curve and its derivatives over an interval.

use tautline::{Integral, quadrature::integrate};

use super::BoundedCurve;

/// Returns `(∫ₐᵇ |γ⁽ᵏ⁾|² dt)^{1/2}` for `k = derivative ≤ 2`, in `ℓ`, with its error.
///
/// The quadrature splits the interval at the corners. The error covers the quadrature and the
/// rounding of the derivative, which is a sum of a dozen terms of the size of its supremum, with a
/// few roundings each.
///
/// # Panics
///
/// If `derivative` is above 2.
#[must_use]
pub fn l2_norm<const D: usize>(
    curve: &impl BoundedCurve<D>,
    derivative: usize,
    [a, b]: [f64; 2],
) -> Integral {
    let mut square = Integral::default();
    let mut from = a;
    let inner = curve.corners().into_iter().filter(|corner| a < *corner && *corner < b);
    for to in inner.chain([b]) {
        square += integrate(
            |t| curve.motion(t).derivatives()[derivative].norm_squared(),
            from,
            to,
            1e-14,
        );
        from = to;
    }
    let value = square.value.sqrt();
    // |√(v + e) − √v| is at most √e, and at most e/√v.
    let root = square.error.sqrt().min(square.error / value);
    let root = if value > 0.0 { root } else { square.error.sqrt() };
    let rounding = 64.0 * f64::EPSILON * curve.suprema()[derivative] * (b - a).abs().sqrt();
    Integral { value, error: root + rounding }
}

#[cfg(test)]
mod tests {
    use super::l2_norm;
    use crate::curves::{KinkedCurve, SmoothCurve};
    use nalgebra::vector;
    use std::f64::consts::PI;

    #[test]
    fn norms_are_those_by_hand() {
        // (∫₀¹ (1 + 2t)²)^{1/2} = √(13/3), and γ̈ = 2.
        let curve = SmoothCurve::polynomial([vector![0.0], vector![1.0], vector![1.0]]);
        let velocity = l2_norm(&curve, 1, [0.0, 1.0]);
        assert!((velocity.value - (13.0_f64 / 3.0).sqrt()).abs() <= velocity.error);
        assert!(velocity.error <= 1e-13);
        assert!((l2_norm(&curve, 2, [0.25, 0.5]).value - 1.0).abs() <= 1e-14);
        // ∫ sin² πt = ½, and ∫ of the squared derivative is π²/2.
        let wave = SmoothCurve::new(Vec::new(), vec![[vector![0.0], vector![1.0]]]);
        assert!((l2_norm(&wave, 1, [0.0, 1.0]).value - PI / 2_f64.sqrt()).abs() <= 1e-13);
        // The velocity is 4 on [0, ¼] and then 0. Hence ∫ of its square is 4, and 2 from ⅛ on.
        let ramp = KinkedCurve::new([0.0], [(0.25, vector![1.0])], [1.0]).expect("in order");
        assert!((l2_norm(&ramp, 1, [0.0, 1.0]).value - 2.0).abs() <= 1e-14);
        assert!((l2_norm(&ramp, 1, [0.125, 1.0]).value - 2_f64.sqrt()).abs() <= 1e-14);
        assert_eq!(l2_norm(&ramp, 2, [0.0, 1.0]).value, 0.0);
    }
}
