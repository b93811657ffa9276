//! `Approximation`: a number to about twice the precision of a double, with a bound of its error.

use super::directed::{add_down, add_up};

/// The real numbers `y` with `|y − head − tail| ≤ error`.
///
/// The sum of head and tail is not evaluated before the end, so that the one rounding that
/// remains is that of the result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approximation {
    pub(super) head: f64,
    pub(super) tail: f64,
    pub(super) error: f64,
}

impl Approximation {
    /// Bounds of all these numbers: `tail ∓ error` is rounded to nearest, hence the step to the
    /// neighbour, and the sum with the head in the direction of the bound.
    #[inline]
    pub(super) fn bounds(self) -> (f64, f64) {
        (
            add_down(self.head, (self.tail - self.error).next_down()),
            add_up(self.head, (self.tail + self.error).next_up()),
        )
    }
}

impl std::ops::Neg for Approximation {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { head: -self.head, tail: -self.tail, error: self.error }
    }
}

#[cfg(test)]
mod tests {
    //! The errors that are stated, against those that are made: before the rounding of the
    //! result, which hides them.

    use astro_float::{BigFloat, Consts, RoundingMode};

    use super::*;
    use crate::interval::{arctangent, circular, even_odd, exponential, logarithm};

    /// The tail is far above the error, and `tail ∓ error` is rounded to the tail.
    #[test]
    fn bounds_hold_where_the_error_is_rounded_away() {
        for (head, tail) in [(0.0, 1.0), (0.0, -1.0), (1.0, 2.0_f64.powi(-54)), (-1.0, -0.25)] {
            let (lo, hi) = Approximation { head, tail, error: 2.0_f64.powi(-120) }.bounds();
            let (exact, rest) = super::super::directed::two_sum(head, tail);
            // Strictly on either side of head + tail, by less than a double can tell.
            assert!(lo < exact || (lo == exact && rest > 0.0), "{head} {tail}: {lo:e}");
            assert!(hi > exact || (hi == exact && rest < 0.0), "{head} {tail}: {hi:e}");
        }
    }

    const P: usize = 256;
    const RM: RoundingMode = RoundingMode::None;
    const CASES: usize = 4_000;

    fn big(x: f64) -> BigFloat {
        BigFloat::from_f64(x, P)
    }

    fn at_most(a: &BigFloat, b: &BigFloat) -> bool {
        a.cmp(b).is_some_and(|order| order <= 0)
    }

    /// Arguments that fill `[lo, hi]` evenly: fractions of multiples of the golden ratio.
    fn arguments(lo: f64, hi: f64) -> impl Iterator<Item = f64> {
        (1..=CASES).map(move |i| lo + (hi - lo) * (i as f64 * 0.618_033_988_749_895).fract())
    }

    /// Fails unless each value is as near as stated, and one of them at least `least` times that:
    /// so that a bound which is far too large, or an error far too small, does not pass.
    #[track_caller]
    fn assert_errors(cases: impl Iterator<Item = (Approximation, BigFloat)>, least: f64) {
        let mut reached = false;
        for (y, value) in cases {
            let sum = big(y.head).add(&big(y.tail), P, RM);
            let made = value.sub(&sum, P, RM).abs();
            assert!(at_most(&made, &big(y.error)), "{y:?} misses {value} by {made}");
            reached |= at_most(&big(least * y.error), &made);
        }
        assert!(reached, "no error reaches {least} of its bound");
    }

    #[test]
    fn errors_of_the_exponential_are_as_stated() {
        let mut constants = Consts::new().expect("memory");
        for end in [0.3465, 700.0] {
            assert_errors(
                arguments(-end, end).map(|x| {
                    let (k, y) = exponential::reduced(x);
                    let power = big(2.0).powi(k.unsigned_abs() as usize, P, RM);
                    let e = big(x).exp(P, RM, &mut constants);
                    (y, if k < 0 { e.mul(&power, P, RM) } else { e.div(&power, P, RM) })
                }),
                0.1,
            );
        }
    }

    #[test]
    fn errors_of_the_logarithm_are_as_stated() {
        let mut constants = Consts::new().expect("memory");
        for (lo, hi) in [(0.708, 1.414), (1e-9, 1e9), (1.5, 40.0)] {
            assert_errors(
                arguments(lo, hi)
                    .map(|x| (logarithm::of_positive(x), big(x).ln(P, RM, &mut constants))),
                0.1,
            );
        }
    }

    #[test]
    fn errors_of_sine_and_cosine_are_as_stated() {
        let mut constants = Consts::new().expect("memory");
        for end in [0.785, 20.0, 1e6] {
            for shift in [0, 1] {
                assert_errors(
                    arguments(-end, end).map(|x| {
                        let (s, c) = circular::approximations(x);
                        if shift == 0 {
                            (s, big(x).sin(P, RM, &mut constants))
                        } else {
                            (c, big(x).cos(P, RM, &mut constants))
                        }
                    }),
                    0.1,
                );
            }
        }
    }

    #[test]
    fn errors_of_the_hyperbolic_series_are_as_stated() {
        let mut constants = Consts::new().expect("memory");
        assert_errors(
            arguments(0.0, 1.0)
                .map(|x| (even_odd::odd(x, 0.0, 0.0, 1.0), big(x).sinh(P, RM, &mut constants))),
            0.1,
        );
        assert_errors(
            arguments(0.0, 1.0)
                .map(|x| (even_odd::even(x, 0.0, 0.0, 1.0), big(x).cosh(P, RM, &mut constants))),
            0.1,
        );
    }

    #[test]
    fn errors_of_the_arctangent_are_as_stated() {
        let mut constants = Consts::new().expect("memory");
        for (lo, hi) in [(0.001, 0.0624), (0.0626, 1.0), (1.0, 20.0), (20.0, 1e9)] {
            assert_errors(
                arguments(lo, hi)
                    .map(|x| (arctangent::of_positive(x), big(x).atan(P, RM, &mut constants))),
                0.1,
            );
        }
    }
}
