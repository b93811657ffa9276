//! Random curves, smooth and kinked.

use proptest::{collection::vec, prelude::*};
use tautline::SVector;
use tautline_statements::curves::{KinkedCurve, SmoothCurve};

use super::points::vector;

/// Draws polynomials of degree up to 4 plus up to three waves, with coefficients in
/// `[−size, size]^D`. One curve in eight is forced to be linear.
pub fn smooth_curve<const D: usize>(size: f64) -> impl Strategy<Value = SmoothCurve<D>> {
    let waves = vec([vector(size), vector(size)], 0..4);
    (vec(vector(size), 1..6), waves, 0..8_u8).prop_map(|(mut powers, waves, kind)| {
        if kind == 0 {
            powers.truncate(2);
            return SmoothCurve::polynomial(powers);
        }
        SmoothCurve::new(powers, waves)
    })
}

/// Draws smooth curves between two points that deviate from the straight line by waves of size up
/// to `wiggle`.
pub fn smooth_curve_between<const D: usize>(
    [a, b]: [SVector<f64, D>; 2],
    wiggle: f64,
) -> impl Strategy<Value = SmoothCurve<D>> {
    smooth_curve(wiggle).prop_map(move |curve| curve.between(a, b))
}

/// Draws piecewise linear curves with up to six pieces and with stops in `[−size, size]^D`.
pub fn kinked_curve<const D: usize>(size: f64) -> impl Strategy<Value = KinkedCurve<D>> {
    let stops = vec((0.05..1.0, vector::<D>(size)), 0..6);
    (vector(size), stops, vector(size)).prop_map(|(first, stops, last): (SVector<f64, D>, _, _)| {
        let total = 0.2 + stops.iter().map(|(pause, _)| pause).sum::<f64>();
        let mut time = 0.0;
        let stops: Vec<_> = stops
            .into_iter()
            .map(|(pause, point)| {
                time += pause / total;
                (time, point)
            })
            .collect();
        KinkedCurve::new(first, stops, last).expect("the times increase")
    })
}

/// Draws three times `0 ≤ s₁ ≤ s ≤ s₂ ≤ 1` with `s₁ < s₂`. In two cases of three, `s` is `s₁` or
/// `s₂`.
pub fn times() -> impl Strategy<Value = [f64; 3]> {
    ((0.0..1.0_f64, 0.0..1.0_f64), 0.0..1.0, 0..3_u8)
        .prop_filter("an interval", |((a, b), _, _)| (a - b).abs() >= 1e-3)
        .prop_map(|((a, b), theta, kind)| {
            let (s1, s2) = (a.min(b), a.max(b));
            let s = match kind {
                0 => s1,
                1 => s2,
                _ => s1 + theta * (s2 - s1),
            };
            [s1, s.clamp(s1, s2), s2]
        })
}
