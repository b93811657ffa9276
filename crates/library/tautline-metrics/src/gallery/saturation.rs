//! A saturating function, which turns a metric without constants into one that has them.

use tautline_scalar::Scalar;

/// The exponent `p`, which must be even.
pub(super) const P: i32 = 128;

/// `1/p`.
pub(super) const INVERSE: f64 = 1.0 / P as f64;

/// For `|u|` up to this, `s(u) = u` and `s′(u) = 1` to rounding: `u¹²⁸ < 1.1e-16`, and the relative
/// error of `s` is the 128th part of this number.
pub(super) const PLATEAU: f64 = 0.75;

/// Returns `s(u) = u / (1 + u^p)^{1/p}` with `p = 128`, which is odd and increasing with
/// `|s| < min(|u|, 1)`.
///
/// ```text
/// s′ = (1 − s^p)^{1 + 1/p},   s″ = −(p + 1) s^{p−1} (1 − s^p)^{1 + 2/p},   u = s (1 − s^p)^{−1/p}
/// ```
///
/// The formula for `s′` follows from `s^p = u^p / (1 + u^p)`, that is, `1 − s^p = 1 / (1 + u^p)`;
/// the formula for `s″` follows from that for `s′`.
fn saturate<S: Scalar>(u: S) -> S {
    // With u = tan θ this is sin θ / (cos^p θ + sin^p θ)^{1/p}, where nothing overflows.
    let (sin, cos) = u.atan().sin_cos();
    let norm = cos.powi(P) + sin.powi(P);
    sin * (norm.ln() * -INVERSE).exp()
}

/// Returns `Q s(q/Q)`, which is `q` saturated at the limit `Q`.
#[inline]
pub(super) fn saturate_at<S: Scalar>(limit: f64, q: S) -> S {
    saturate(q * (1.0 / limit)) * limit
}

/// Returns `(1 − s^p)^power`, which decreases with `s`; for `power = 1 + 1/p` it is `s′`.
pub(super) fn rest(s: f64, power: f64) -> f64 {
    (1.0 - s.powi(P)).powf(power)
}

/// Returns an upper bound on a function of `0 ≤ s < 1`, by branch and bound. `cell(a, b)` must be
/// an upper bound on `[a, b]`, and `cell(a, a)` the value at `a`.
///
/// An increasing factor at `b` times a decreasing one at `a` is an upper bound on `[a, b]`, and so
/// is a sum of products of this kind. In terms that are subtracted, exchange `a` and `b`.
///
/// Cells are halved twenty times, and those that cannot contain the maximum are dropped. The bound
/// is too large by at most `2⁻²⁰` times the sum of the slopes of all factors. NaN and `+∞`
/// propagate.
pub(super) fn greatest(cell: impl Fn(f64, f64) -> f64) -> f64 {
    let mut cells = vec![(0.0, 1.0)];
    let mut reached = f64::NEG_INFINITY;
    for _ in 0..20 {
        cells = cells
            .into_iter()
            .flat_map(|(a, b)| {
                let middle = 0.5 * (a + b);
                [(a, middle), (middle, b)]
            })
            .collect();
        reached = cells.iter().map(|&(a, _)| cell(a, a)).fold(reached, larger);
        if reached.is_nan() {
            return reached;
        }
        // The condition is written so that a NaN bound is kept.
        cells.retain(|&(a, b)| !(cell(a, b) <= reached));
    }
    cells.into_iter().map(|(a, b)| cell(a, b)).fold(reached, larger)
}

/// Returns the larger of two numbers, or NaN if either is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

#[cfg(test)]
mod tests {
    use tautline_scalar::Jet2;

    use super::{P, PLATEAU, greatest, rest, saturate};

    #[test]
    fn saturate_is_the_identity_on_the_plateau() {
        for i in -1000..=1000 {
            let u = f64::from(i) * 1e-3 * PLATEAU;
            let [variable] = Jet2::<f64, 1>::variables(&[u]);
            let s = saturate(variable);
            // We measured at most 1.6 ε for the value and 1.6e-14 for the derivative. The second
            // derivative is (p + 1) u^{p−1}, 1.7e-14, plus the rounding of cancelling terms of size
            // p² = 16384.
            assert!((s.value() - u).abs() <= 4.0 * f64::EPSILON * u.abs(), "{u}: {s:?}");
            assert!((s.first(0) - 1.0).abs() < 1e-13, "{u}: {s:?}");
            assert!(s.second(0, 0).abs() < 1e-11, "{u}: {s:?}");
        }
    }

    #[test]
    fn saturate_does_not_overflow() {
        for u in [1e3, 1e154, 1e155, 1e300, f64::MAX] {
            for sign in [1.0, -1.0] {
                let [variable] = Jet2::<f64, 1>::variables(&[sign * u]);
                let s = saturate(variable);
                assert!((s.value() - sign).abs() <= 2.0 * f64::EPSILON, "{u}: {s:?}");
                assert!(s.first(0).abs() < 1e-15 && s.second(0, 0).abs() < 1e-15, "{u}: {s:?}");
            }
        }
    }

    /// The differential equations in the documentation hold throughout the transition.
    #[test]
    fn the_derivatives_of_saturate_are_functions_of_its_value() {
        let p = f64::from(P);
        for i in 750..1250 {
            let u = f64::from(i) * 1e-3;
            let [variable] = Jet2::<f64, 1>::variables(&[u]);
            let s = saturate(variable);
            let z = s.value();
            let rest = 1.0 - z.powi(P);
            assert!((z - u * (1.0 + u.powi(P)).powf(-1.0 / p)).abs() < 1e-15);
            // 1 − z^p has 128 times the rounding of z.
            assert!((s.first(0) - rest.powf(1.0 + 1.0 / p)).abs() < 1e-13);
            let second = -(p + 1.0) * z.powi(P - 1) * rest.powf(1.0 + 2.0 / p);
            assert!((s.second(0, 0) - second).abs() < 1e-10, "{u}: {s:?} {second}");
        }
    }

    #[test]
    fn greatest_is_a_close_upper_bound() {
        // s^p (1 − s^p) is at most 1/4; there the slope of s^p is p/2 divided by s, about 64.
        let quarter = greatest(|a, b| b.powi(P) * rest(a, 1.0));
        assert!((0.25..0.25 * (1.0 + 129.0 / 2_f64.powi(20))).contains(&quarter), "{quarter}");
        // s (1 − s^p)² is largest at s^p = 1/(1 + 2p).
        let y = 1.0 / (1.0 + 2.0 * f64::from(P));
        let exact = y.powf(1.0 / f64::from(P)) * (1.0 - y).powi(2);
        let bound = greatest(|a, b| b * rest(a, 2.0));
        assert!((exact..exact * (1.0 + 2e-6)).contains(&bound), "{bound} {exact}");
        // A difference of increasing functions, s − s², and its negative.
        let bound = greatest(|a, b| b - a * a);
        assert!((0.25..0.25 + 4e-6).contains(&bound), "{bound}");
        let bound = greatest(|a, b| b * b - a);
        assert!((0.0..4e-6).contains(&bound), "{bound}");
        assert_eq!(greatest(|a, _| 3.0 * rest(a, 1.0)), 3.0);
        // The cases are a NaN value, a NaN bound, and infinity.
        assert!(greatest(|_, b| if b > 0.7 { f64::NAN } else { b }).is_nan());
        assert!(greatest(|a, b| if a < b && b > 0.7 { f64::NAN } else { a }).is_nan());
        assert_eq!(greatest(|_, b| 1.0 / (1.0 - b)), f64::INFINITY);
    }
}
