//! `Pair`: two `f64` in one vector register.

use std::{
    ops::{Add, Div, Mul, Neg, Sub},
    sync::Arc,
};

use num_traits::One;
use wide::f64x2;

use crate::{Scalar, Table};

/// Two `f64` in one vector register, with which a formula is evaluated at two points at once.
///
/// `+ − × ÷ √` agree with `f64` bit for bit. `sin` and `cos` are vectorised too, with an error of
/// at most `2 ε` times the larger of the result and `ε max(1, |x|)`. Every other function applies
/// the `f64` function to each lane.
#[derive(Clone, Copy, Debug)]
pub struct Pair(f64x2);

/// Up to this angle, [`f64x2::sin_cos`] reduces angles as if by a `π/2` with an error of about
/// `ε²`. The first two parts of its `π/2` have 25 bits, so their multiples by integers below `2²⁰`
/// are exact.
const LARGEST_ANGLE: f64 = 1e6;

impl Pair {
    /// Returns the pair of the two numbers.
    #[must_use]
    #[inline]
    pub fn new(first: f64, second: f64) -> Self {
        Self(f64x2::new([first, second]))
    }

    /// Returns the two numbers.
    #[must_use]
    #[inline]
    pub fn both(self) -> [f64; 2] {
        self.0.to_array()
    }

    /// Applies `f` to each lane.
    #[inline]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        let [first, second] = self.both();
        Self::new(f(first), f(second))
    }

    /// Returns whether both lanes are in `(above, most]`.
    #[inline(always)]
    pub(crate) fn are_between(self, above: f64, most: f64) -> bool {
        let (above, most) = (f64x2::splat(above), f64x2::splat(most));
        (self.0.simd_gt(above) & self.0.simd_le(most)).all()
    }

    /// Returns whether both lanes are at most `largest` in absolute value; false for NaN.
    #[inline]
    fn are_within(self, largest: f64) -> bool {
        let [first, second] = self.both();
        first.abs() <= largest && second.abs() <= largest
    }
}

impl PartialEq for Pair {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.both() == other.both()
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident)*) => {$(
        impl $operator for Pair {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

operators!(Add add Sub sub Mul mul Div div);
crate::operators_follow!([] Pair);

impl Neg for Pair {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! by_lane {
    ($($function:ident)*) => {$(
        #[inline]
        fn $function(self) -> Self {
            self.each(f64::$function)
        }
    )*};
}

impl Scalar for Pair {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self(f64x2::splat(value))
    }

    #[inline(always)]
    fn sqr(self) -> Self {
        self * self
    }

    by_lane!(exp ln tan atan tanh);

    #[inline]
    fn powi(self, n: i32) -> Self {
        self.each(|x| x.powi(n))
    }

    #[inline(always)]
    fn recip(self) -> Self {
        Self::one() / self
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        if self.are_within(LARGEST_ANGLE) {
            let (sin, cos) = self.0.sin_cos();
            (Self(sin), Self(cos))
        } else {
            (self.each(f64::sin), self.each(f64::cos))
        }
    }

    #[inline]
    fn sinh_cosh(self) -> (Self, Self) {
        (self.each(f64::sinh), self.each(f64::cosh))
    }

    fn tabulated(table: &Arc<dyn Table>, orders: [u8; 3], u: &[Self]) -> Self {
        if u.len() > 3 {
            return Self::constant(f64::NAN);
        }
        let lane = |lane: usize| {
            let mut arguments = [0.0; 3];
            arguments.iter_mut().zip(u).for_each(|(to, u)| *to = u.both()[lane]);
            f64::tabulated(table, orders, &arguments[..u.len()])
        };
        Self::new(lane(0), lane(1))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use proptest::prelude::*;

    use num_traits::Zero;

    use super::{LARGEST_ANGLE, Pair};
    use crate::{Jet2, Lanes, Scalar};

    /// A formula with all functions, for arguments near 1.
    fn everything<S: Scalar>(x: S) -> S {
        let (sinh, cosh) = (x * 0.1).sinh_cosh();
        let far = (x + 2.5).powi(-3) + (x + 2.0).ln() + (x * 0.2).tan() + x.atan() * sinh + cosh;
        -far / ((x.sqr() + 1.0).sqrt() - 0.25) + x.exp().recip() * x.sin() - x.cos() * x.tanh()
    }

    fn bits(numbers: [f64; 2]) -> [u64; 2] {
        numbers.map(f64::to_bits)
    }

    proptest! {
        #![proptest_config(tautline_chance::config(4, 256))]

        #[test]
        fn arithmetic_gives_the_bits_of_f64(
            [a, b] in prop::array::uniform2(-1e3..1e3_f64),
            [c, d] in prop::array::uniform2(-1e3..1e3_f64),
        ) {
            let (x, y) = (Pair::new(a, b), Pair::new(c, d));
            prop_assert_eq!(bits((x + y).both()), bits([a + c, b + d]));
            prop_assert_eq!(bits((x - y).both()), bits([a - c, b - d]));
            prop_assert_eq!(bits((x * y).both()), bits([a * c, b * d]));
            prop_assert_eq!(bits((x / y).both()), bits([a / c, b / d]));
            let with_number = |x: f64| x / c - d + c * 0.5;
            let pair = x / c - d + c * 0.5;
            prop_assert_eq!(bits(pair.both()), bits([a, b].map(with_number)));
            prop_assert_eq!(bits((-x).both()), bits([-a, -b]));
            prop_assert_eq!(bits(x.sqr().sqrt().both()), bits([(a * a).sqrt(), (b * b).sqrt()]));
            let mut sum = x;
            sum += y;
            sum *= x;
            sum -= y;
            sum /= x;
            let one = |a: f64, c: f64| ((a + c) * a - c) / a;
            prop_assert_eq!(bits(sum.both()), bits([one(a, c), one(b, d)]));
        }

        #[test]
        fn sine_and_cosine_agree_with_f64_to_rounding(
            angle in -LARGEST_ANGLE..LARGEST_ANGLE,
            small in -10.0..10.0_f64,
        ) {
            compare(angle, small);
        }

        #[test]
        fn a_formula_has_the_same_values_and_derivatives_in_pairs_and_in_f64(
            [a, b] in prop::array::uniform2(-1.5..1.5_f64),
        ) {
            let [pair] = Jet2::variables(&[Pair::new(a, b)]);
            let pair = everything(pair);
            for (lane, x) in [a, b].into_iter().enumerate() {
                let [one] = Jet2::variables(&[x]);
                let one = everything(one);
                // The values are below 100 and come from about thirty operations, each accurate to
                // within 2 ε.
                let close = |pair: Pair, one: f64| (pair.both()[lane] - one).abs() <= 1e-12;
                prop_assert!(close(pair.value(), one.value()), "{pair:?} {one:?}");
                prop_assert!(close(pair.first(0), one.first(0)), "{pair:?} {one:?}");
                prop_assert!(close(pair.second(0, 0), one.second(0, 0)), "{pair:?} {one:?}");
            }
        }
    }

    /// Checks the documented error. The largest error among four million random angles was 1.42 ε.
    #[track_caller]
    fn compare(a: f64, b: f64) {
        let (sin, cos) = Pair::new(a, b).sin_cos();
        for (lane, x) in [a, b].into_iter().enumerate() {
            for (found, expected) in [(sin, x.sin()), (cos, x.cos())] {
                let off = (found.both()[lane] - expected).abs();
                let unit = f64::EPSILON * expected.abs().max(f64::EPSILON * x.abs().max(1.0));
                assert!(off <= 2.0 * unit, "{x}: {found:?} {expected}");
            }
        }
    }

    /// At these angles, the sine or the cosine is the rounding error of the angle.
    #[test]
    fn sine_and_cosine_are_accurate_next_to_their_zeros() {
        for quarter in 0..600_000 {
            let angle = f64::from(quarter) * FRAC_PI_2;
            compare(angle, -angle.next_up());
        }
    }

    #[test]
    fn swapped_lanes_have_swapped_results() {
        let numbers = [1e7, -1e15, LARGEST_ANGLE, f64::INFINITY, f64::NAN, 0.5, -0.7, 0.0];
        for (x, y) in numbers.into_iter().flat_map(|x| numbers.map(|y| (x, y))) {
            let (pair, back) = (Pair::new(x, y), Pair::new(y, x));
            let results = |pair: Pair| {
                let (sin, cos) = pair.sin_cos();
                let (sinh, cosh) = pair.sinh_cosh();
                let [ln, exp] = [pair.ln(), pair.exp()];
                let (tan, atan, tanh) = (pair.tan(), pair.atan(), pair.tanh());
                let (root, power) = (pair.sqrt(), pair.powi(-3));
                [sin, cos, sinh, cosh, ln, exp, tan, atan, tanh, root, power].map(Pair::both)
            };
            for ([a, b], [c, d]) in results(pair).into_iter().zip(results(back)) {
                // Bits are compared, since NaN is not equal to itself.
                assert_eq!(bits([a, b]), bits([d, c]), "{x} {y}");
            }
            for (lane, number) in [x, y].into_iter().enumerate() {
                assert_eq!(pair.lane(lane).to_bits(), number.to_bits());
            }
        }
    }

    #[test]
    fn comparisons_need_both_lanes() {
        let pair = Pair::new(1.0, 2.0);
        assert_eq!(pair, Pair::new(1.0, 2.0));
        for other in [Pair::new(1.0, 3.0), Pair::new(0.0, 2.0), Pair::new(2.0, 1.0)] {
            assert_ne!(pair, other);
        }
        assert!(!Pair::new(0.0, 1.0).is_zero() && !Pair::new(1.0, 0.0).is_zero());
        assert!(Pair::new(0.0, -0.0).is_zero() && Pair::new(f64::NAN, 0.0) != Pair::zero());
        assert!(pair.are_positive() && f64::MAX.are_positive() && 5e-324.are_positive());
        for none in [0.0, -0.0, -1.0, f64::INFINITY, f64::NAN] {
            let pairs = [Pair::new(none, 1.0), Pair::new(1.0, none), Pair::new(none, none)];
            assert!(!none.are_positive() && !pairs.into_iter().any(Lanes::are_positive), "{none}");
        }
    }

    /// In addition, the other lane keeps its accuracy.
    #[test]
    fn huge_angles_infinities_and_nan_are_as_in_f64() {
        for x in [1e7, -1e15, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 0.0, -0.0] {
            let (sin, cos) = Pair::new(x, 0.5).sin_cos();
            let exp = Pair::new(x, 0.5).exp();
            let one = [x.sin(), x.cos(), x.exp()];
            for (pair, one) in [sin, cos, exp].into_iter().zip(one) {
                let [found, _] = pair.both();
                assert!(found == one || found.is_nan() && one.is_nan(), "{x}: {found} {one}");
            }
            let expected = [0.5_f64.sin(), 0.5_f64.cos()];
            for (pair, expected) in [sin, cos].into_iter().zip(expected) {
                assert!((pair.both()[1] - expected).abs() <= f64::EPSILON);
            }
        }
        assert_eq!(Pair::new(4.0, -1.0).sqrt().both()[0], 2.0);
        assert!(Pair::new(4.0, -1.0).sqrt().both()[1].is_nan());
    }
}
