//! `QuarterTurns`: an angle reduced modulo `π/2`.

use super::constants::HALF_PI;
use crate::interval::directed::two_sum;

/// The largest `|x|`, in radians, for which sine and cosine get better bounds than `[−1, 1]`:
/// `2³⁸`. Doubles there are `2⁻¹⁴` apart or less.
pub(crate) const LARGEST_ANGLE: f64 = f64::from_bits((1023 + 38) << 52);

/// The number `2²⁰`. The products of an integer up to that with `P₀`, `P₁` and `P₂` are exact.
const SPLIT: f64 = 1_048_576.0;

/// An angle `x = turns · π/2 + head + tail + δ`, where `|δ| ≤ error`, `|head| < 0.7855` and
/// `|tail| ≤ u |head|`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct QuarterTurns {
    turns: i64,
    pub(crate) head: f64,
    pub(crate) tail: f64,
    pub(crate) error: f64,
}

impl QuarterTurns {
    /// Splits the angle `x`, in radians.
    ///
    /// Needs: `|x| ≤ 2³⁸`.
    ///
    /// Beyond `2²⁰` see [`large`](QuarterTurns::large). Up to there, let `k` be the integer nearest to
    /// the rounded `x · (2/π)`. The splitting is valid for any `k`. Since `|k| ≤ 667 545 < 2²⁰` and the error of the product is below `2⁻³¹`, the remainder
    /// is below `π/4 + 2⁻³⁰ < 0.7855`.
    ///
    /// * `x − k P₀` is exact. The product `k P₀` has 33 + 20 bits, and for `k ≠ 0` we have
    ///   `|x| > 0.78`. Both are therefore multiples of `2⁻⁵³`, and so is their difference, which is
    ///   less than `0.7855 + 2²⁰ · 2⁻³³ < 1`.
    /// * `k P₁` and `k P₂` have 53 bits as well, and two exact sums subtract them.
    /// * `k P₃` is rounded by at most `u |k P₃|`, and `k ε ≤ 2²⁰⁻¹⁵⁶ = 2⁻¹³⁶`.
    /// * What remains is a sum of three small numbers `b`, `c` and `d`. It takes two roundings of
    ///   at most `u (|b| + |c| + |d|)(1 + u)` each. Together with the rounding of `k P₃` they are
    ///   below `4 u (|b| + |c| + |d|)`, which is itself computed with a relative error of `3 u`.
    #[inline]
    pub(crate) fn of(x: f64) -> Self {
        if x.abs() > SPLIT {
            return Self::large(x);
        }
        let k = (x * std::f64::consts::FRAC_2_PI).round_ties_even();
        if k == 0.0 {
            return Self { turns: 0, head: x, tail: 0.0, error: 0.0 };
        }
        let [p0, p1, p2, p3] = HALF_PI;
        let (r, b) = two_sum(x - k * p0, -(k * p1));
        let (r, c) = two_sum(r, -(k * p2));
        let d = k * p3;
        let (head, tail) = two_sum(r, (b + c) - d);
        let error = 2.0 * f64::EPSILON * (b.abs() + c.abs() + d.abs()) + SMALL;
        Self { turns: k as i64, head, tail, error }
    }

    /// Splits an angle beyond `2²⁰`, in radians.
    ///
    /// Needs: `2²⁰ < |x| ≤ 2³⁸`.
    ///
    /// Now `|k| < 2³⁸`, and the error of the product is below `2⁻¹⁴`, so that the remainder is below
    /// `π/4 + 2⁻¹³ · π/4 < 0.7855`. Let `k = m + l`, where `m` is a multiple of `2²⁰` and `|l| ≤ 2¹⁹`.
    /// The products of `m` and of `l` with `P₀`, `P₁` and `P₂` are exact: `m` has 18 bits.
    ///
    /// * `x − m P₀` is exact. `|x| > 2²⁰`, so both are multiples of `2⁻³²`, and so is their difference,
    ///   which is less than `|l P₀| + 2³⁸⁻³³ + 1 < 2²⁰`.
    /// * `x − m P₀ − l P₀` is exact for the same reason: it is less than `2³⁸⁻³³ + 1`.
    /// * Four exact sums subtract the multiples of `P₁` and `P₂`.
    /// * `k P₃` is rounded by at most `u |k P₃|`, and `k ε ≤ 2³⁸⁻¹⁵⁶ = 2⁻¹¹⁸`.
    /// * What remains is a sum of five small numbers. Each takes part in at most three roundings, and `k P₃`
    ///   in one more. They are below `4 u (1 + 4u)` times the sum of the absolute values, which is itself
    ///   computed with a relative error of `5 u`. We allow for `6 u`.
    #[cold]
    fn large(x: f64) -> Self {
        let k = (x * std::f64::consts::FRAC_2_PI).round_ties_even();
        let m = (k / SPLIT).round_ties_even() * SPLIT;
        let l = k - m;
        let [p0, p1, p2, p3] = HALF_PI;
        let (r, b) = two_sum(x - m * p0 - l * p0, -(m * p1));
        let (r, c) = two_sum(r, -(l * p1));
        let (r, d) = two_sum(r, -(m * p2));
        let (r, e) = two_sum(r, -(l * p2));
        let f = k * p3;
        let (head, tail) = two_sum(r, ((b + c) + (d + e)) - f);
        let sum = b.abs() + c.abs() + d.abs() + e.abs() + f.abs();
        let error = 3.0 * f64::EPSILON * sum + SMALL_FOR_LARGE;
        Self { turns: k as i64, head, tail, error }
    }

    /// Returns `k mod 4`.
    #[inline]
    pub(crate) fn quadrant(self) -> i64 {
        self.turns & 3
    }

    /// Returns bounds on `⌊x / (π/2)⌋`.
    ///
    /// The value is `k` or `k − 1`, depending on the sign of the remainder. Apart from 0, no double
    /// is known to be so close to a multiple of `π/2` that the sign is in doubt, but nothing
    /// depends on that.
    #[inline]
    pub(crate) fn floor(self) -> (i64, i64) {
        // head + tail has the sign of the head, and more than half its size.
        if self.head >= 0.0 && (self.error == 0.0 || 0.5 * self.head > self.error) {
            (self.turns, self.turns)
        } else if 0.5 * self.head < -self.error {
            (self.turns - 1, self.turns - 1)
        } else {
            (self.turns - 1, self.turns)
        }
    }
}

/// The number `2⁻¹³⁵`.
const SMALL: f64 = f64::from_bits((1023 - 135) << 52);

/// The number `2⁻¹¹⁷`.
const SMALL_FOR_LARGE: f64 = f64::from_bits((1023 - 117) << 52);

#[cfg(test)]
mod tests {
    use super::{LARGEST_ANGLE, QuarterTurns, SPLIT};
    use crate::interval::high_precision::{P, RM, at_most, big, error_of_sum, half_pi};

    /// The errors are within the stated error, which is not much larger than they are.
    #[test]
    fn errors_of_the_remainder_are_as_stated() {
        let half_pi = half_pi();
        for end in [3.0, 1e3, SPLIT, 1e9, LARGEST_ANGLE] {
            let mut reached = false;
            for case in 1..4000 {
                let x = end * (1.7 * f64::from(case)).sin();
                let angle = QuarterTurns::of(x);
                let QuarterTurns { turns, head, tail, error } = angle;
                assert!(head.abs() < 0.7855 && tail.abs() <= f64::EPSILON / 2.0 * head.abs());
                let rest = big(x).sub(&half_pi.mul(&big(turns as f64), P, RM), P, RM);
                let found = error_of_sum(&[head, tail], &rest);
                assert!(at_most(&found, &big(error)), "{x}: {angle:?} is off by {found}");
                reached |= error > 0.0 && at_most(&big(0.02 * error), &found);
                let floor = (x * std::f64::consts::FRAC_2_PI).floor() as i64;
                let (below, above) = angle.floor();
                assert!(below <= floor && floor <= above, "{x}: {angle:?}");
            }
            assert!(reached, "no error reaches 0.02 of its bound up to {end}");
        }
    }
}
