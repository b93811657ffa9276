//! `Approximation`: a number to about twice the precision of a double, with an error bound.

use super::directed::{add_down, add_up};

/// The real numbers `y` with `|y − head − tail| ≤ error`.
///
/// The head and the tail are added only at the end, so that the result is rounded once.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approximation {
    pub(super) head: f64,
    pub(super) tail: f64,
    pub(super) error: f64,
}

impl Approximation {
    /// Returns bounds on all these numbers. The sum `tail ∓ error` is rounded to nearest, hence the
    /// step to its neighbour. Its sum with the head is rounded in the direction of the bound.
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
    //! Compares stated errors with actual errors, before the rounding of the result hides them.

    use astro_float::BigFloat;

    use super::*;
    use crate::interval::{
        directed::two_sum,
        elementary::{arctangent, circular, even_odd, exponential, logarithm},
        high_precision::{P, RM, at_most, big, constants, error_of_sum},
    };

    /// The error is so small that `tail ∓ error` rounds to the tail.
    #[test]
    fn bounds_hold_where_the_error_is_rounded_away() {
        for (head, tail) in [(0.0, 1.0), (0.0, -1.0), (1.0, 2.0_f64.powi(-54)), (-1.0, -0.25)] {
            let (lo, hi) = Approximation { head, tail, error: 2.0_f64.powi(-120) }.bounds();
            let (exact, rest) = two_sum(head, tail);
            // The bounds lie strictly on either side of head + tail.
            assert!(lo < exact || (lo == exact && rest > 0.0), "{head} {tail}: {lo:e}");
            assert!(hi > exact || (hi == exact && rest < 0.0), "{head} {tail}: {hi:e}");
        }
    }

    const CASES: usize = 4_000;

    /// Returns arguments that fill `[lo, hi]` evenly: fractional parts of multiples of the golden
    /// ratio.
    fn arguments(lo: f64, hi: f64) -> impl Iterator<Item = f64> {
        (1..=CASES).map(move |i| lo + (hi - lo) * (i as f64 * 0.618_033_988_749_895).fract())
    }

    /// Fails unless each error is within its stated bound and at least one reaches a tenth of it. A
    /// bound that is far too large therefore does not pass.
    #[track_caller]
    fn assert_errors(cases: impl Iterator<Item = (Approximation, BigFloat)>) {
        let mut reached = false;
        for (y, value) in cases {
            let error = error_of_sum(&[y.head, y.tail], &value);
            assert!(at_most(&error, &big(y.error)), "{y:?} misses {value} by {error}");
            reached |= at_most(&big(0.1 * y.error), &error);
        }
        assert!(reached, "no error reaches 0.1 of its bound");
    }

    #[test]
    fn errors_of_the_exponential_are_as_stated() {
        let mut constants = constants();
        for end in [0.3465, 700.0] {
            assert_errors(arguments(-end, end).map(|x| {
                let (k, y) = exponential::reduced(x);
                let power = big(2.0).powi(k.unsigned_abs() as usize, P, RM);
                let e = big(x).exp(P, RM, &mut constants);
                (y, if k < 0 { e.mul(&power, P, RM) } else { e.div(&power, P, RM) })
            }));
        }
    }

    /// Compares a function with the `BigFloat` method of the same name on intervals of arguments.
    macro_rules! errors_are_as_stated {
        ($($test:ident: $function:expr, $method:ident, $intervals:expr;)*) => {$(
            #[test]
            fn $test() {
                let mut constants = constants();
                for (lo, hi) in $intervals {
                    assert_errors(
                        arguments(lo, hi)
                            .map(|x| ($function(x), big(x).$method(P, RM, &mut constants))),
                    );
                }
            }
        )*};
    }

    const ANGLES: [(f64, f64); 3] = [(-0.785, 0.785), (-20.0, 20.0), (-1e6, 1e6)];

    errors_are_as_stated! {
        errors_of_the_logarithm_are_as_stated:
            logarithm::of_positive, ln, [(0.708, 1.414), (1e-9, 1e9), (1.5, 40.0)];
        errors_of_the_sine_are_as_stated: |x| circular::approximations(x).0, sin, ANGLES;
        errors_of_the_cosine_are_as_stated: |x| circular::approximations(x).1, cos, ANGLES;
        errors_of_the_hyperbolic_sine_are_as_stated:
            |x| even_odd::odd(x, 0.0, 0.0, 1.0), sinh, [(0.0, 1.0)];
        errors_of_the_hyperbolic_cosine_are_as_stated:
            |x| even_odd::even(x, 0.0, 0.0, 1.0), cosh, [(0.0, 1.0)];
        errors_of_the_arctangent_are_as_stated:
            arctangent::of_positive, atan,
            [(0.001, 0.0624), (0.0626, 1.0), (1.0, 20.0), (20.0, 1e9)];
    }
}
