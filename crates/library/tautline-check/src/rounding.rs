//! Sums, products and roots of doubles, rounded down or up.
//!
//! They are ends of intervals. If an argument is NaN or infinite, the result is NaN, which fails
//! every comparison.

use tautline_scalar::{Interval, Scalar};

pub(crate) fn add_down(a: f64, b: f64) -> f64 {
    (Interval::point(a) + Interval::point(b)).lo()
}

pub(crate) fn add_up(a: f64, b: f64) -> f64 {
    (Interval::point(a) + Interval::point(b)).hi()
}

pub(crate) fn mul_down(a: f64, b: f64) -> f64 {
    (Interval::point(a) * Interval::point(b)).lo()
}

pub(crate) fn mul_up(a: f64, b: f64) -> f64 {
    (Interval::point(a) * Interval::point(b)).hi()
}

pub(crate) fn div_down(a: f64, b: f64) -> f64 {
    (Interval::point(a) / Interval::point(b)).lo()
}

pub(crate) fn div_up(a: f64, b: f64) -> f64 {
    (Interval::point(a) / Interval::point(b)).hi()
}

pub(crate) fn sqrt_down(a: f64) -> f64 {
    Interval::point(a).sqrt().lo()
}

pub(crate) fn sqrt_up(a: f64) -> f64 {
    Interval::point(a).sqrt().hi()
}

#[cfg(test)]
mod tests {
    use tautline_chance::{Random, cases, seed};

    use super::{add_down, add_up, div_down, div_up, mul_down, mul_up, sqrt_down, sqrt_up};

    /// Asserts that the two numbers are in order and at most two doubles apart.
    fn assert_close(down: f64, up: f64) {
        assert!(down <= up && up <= down.next_up().next_up(), "{down:e} {up:e}");
    }

    /// A fused operation is rounded once, which keeps its sign.
    #[test]
    fn results_are_on_their_side_of_the_exact_ones_and_close() {
        let mut random = Random(seed(61));
        for _ in 0..cases(2000) {
            let a = random.sign() * random.with_exponent(-30, 30);
            let b = random.sign() * random.with_exponent(-30, 30);
            let (down, up) = (add_down(a, b), add_up(a, b));
            // The sum is s + e, exactly (TwoSum by Knuth).
            let s = a + b;
            let from_b = s - a;
            let e = (a - (s - from_b)) + (b - from_b);
            assert!(down - s <= e && e <= up - s, "{a:e} {b:e}");
            assert_close(down, up);
            let (down, up) = (mul_down(a, b), mul_up(a, b));
            assert!(a.mul_add(b, -down) >= 0.0 && a.mul_add(b, -up) <= 0.0, "{a:e} {b:e}");
            assert_close(down, up);
            let (down, up, size) = (div_down(a, b), div_up(a, b), b.signum());
            // The sign of b (down − a/b), and so on.
            assert!(down.mul_add(b, -a) * size <= 0.0, "{a:e} {b:e}");
            assert!(up.mul_add(b, -a) * size >= 0.0, "{a:e} {b:e}");
            assert_close(down, up);
            let square = a.abs();
            let (down, up) = (sqrt_down(square), sqrt_up(square));
            assert!(down.mul_add(down, -square) <= 0.0 && up.mul_add(up, -square) >= 0.0, "{a:e}");
            assert_close(down, up);
        }
    }

    #[test]
    fn what_is_exact_is_not_rounded() {
        for (found, exact) in [
            ([add_down(3.0, -0.25), add_up(3.0, -0.25)], 2.75),
            ([mul_down(1.5, -1.0), mul_up(1.5, -1.0)], -1.5),
            ([mul_down(0.0, 0.1), mul_up(0.0, 0.1)], 0.0),
            ([add_down(0.1, -0.1), add_up(0.1, -0.1)], 0.0),
        ] {
            assert_eq!(found, [exact; 2]);
        }
    }

    #[test]
    fn what_is_unknown_is_no_number() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for of in [add_down, add_up, mul_down, mul_up, div_down, div_up] {
                assert!(of(x, 2.0).is_nan() && of(2.0, x).is_nan(), "{x}");
            }
            assert!(sqrt_down(x).is_nan() && sqrt_up(x).is_nan(), "{x}");
        }
        assert!(sqrt_down(-1.0).is_nan() && sqrt_up(-1.0).is_nan());
    }
}
