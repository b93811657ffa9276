//! Operators with a number on the left of a scalar, such as `2.0 - x`.

/// Provides the type `T` as an associated type of every type.
///
/// A trait implies its bounds on `Self` and on associated types, but not a bound on another type
/// such as `f64: Sub<Self>`, which every function would have to repeat. Since `Beside<f64>::Is` is
/// `f64`, [`Scalar`](crate::Scalar) can put the bound there, so that `S: Scalar` suffices for
/// `2.0 - x`.
pub trait Beside<T> {
    /// The type `T`.
    type Is;
}

impl<T, U> Beside<T> for U {
    type Is = T;
}

/// Implements `c + x`, `c - x`, `c * x` and `c / x` with an `f64` on the left for your number type.
/// It uses the operators with an `f64` on the right, and
/// [`Scalar::constant`](crate::Scalar::constant) for `c / x`.
///
/// The generic parameters come first, in brackets: `f64_on_the_left!([] MyNumber)`,
/// `f64_on_the_left!([T: Scalar, const D: usize] MyJet<T, D>)`.
#[macro_export]
macro_rules! f64_on_the_left {
    ([$($generics:tt)*] $scalar:ty) => {
        $crate::f64_on_the_left!(@operator [$($generics)*] $scalar, Add add |c, x| x + c);
        $crate::f64_on_the_left!(@operator [$($generics)*] $scalar, Sub sub |c, x| -x + c);
        $crate::f64_on_the_left!(@operator [$($generics)*] $scalar, Mul mul |c, x| x * c);
        $crate::f64_on_the_left!(
            @operator [$($generics)*] $scalar,
            Div div |c, x| <$scalar as $crate::Scalar>::constant(c) / x
        );
    };
    (
        @operator [$($generics:tt)*] $scalar:ty,
        $operator:ident $method:ident |$c:ident, $x:ident| $value:expr
    ) => {
        impl<$($generics)*> ::std::ops::$operator<$scalar> for f64 {
            type Output = $scalar;
            #[inline]
            fn $method(self, $x: $scalar) -> $scalar {
                let $c = self;
                $value
            }
        }
        impl<'x, $($generics)*> ::std::ops::$operator<&'x $scalar> for f64 {
            type Output = $scalar;
            #[inline]
            fn $method(self, x: &'x $scalar) -> $scalar {
                ::std::ops::$operator::$method(self, *x)
            }
        }
    };
}

#[cfg(test)]
mod tests {
    use crate::{Interval, Jet1, Jet2, Pair, Scalar};

    /// Pairs of formulas, one with a number on the left, the other with it on the right.
    fn formulas<S: Scalar>(x: S) -> [[S; 2]; 5] {
        [
            [1.0 + x, x + 1.0],
            [2.0 - x.sin(), -x.sin() + 2.0],
            [2.0 * x, x * 2.0],
            [2.0 / x, S::constant(2.0) / x],
            [3.0 - &x, -x + 3.0],
        ]
    }

    #[track_caller]
    fn assert_same<S: Scalar>(x: S) {
        for [left, right] in formulas(x) {
            assert_eq!(left, right);
        }
    }

    #[test]
    fn a_number_may_be_on_the_left_in_every_type() {
        assert_same(0.75);
        assert_same(Pair::new(0.75, -1.25));
        let x = Interval::new(0.5, 0.75).expect("ordered");
        assert_same(x);
        assert_same(Jet1::variables(&[0.75])[0]);
        assert_same(Jet2::variables(&[0.75, 2.0])[0]);
        assert_same(Jet2::variables(&[x, x])[1]);
    }

    #[test]
    fn differences_and_quotients_are_not_reversed() {
        let [x] = Jet2::variables(&[0.5]);
        let all = |y: Jet2<f64, 1>| [y.value(), y.first(0), y.second(0, 0)];
        assert_eq!(all(2.0 - x), [1.5, -1.0, 0.0]);
        // The values are 2/x, −2/x², 4/x³.
        assert_eq!(all(2.0 / x), [4.0, -8.0, 32.0]);
        let x = Interval::new(0.5, 1.0).expect("ordered");
        let ends = |y: Interval| [y.lo(), y.hi()];
        assert_eq!([ends(2.0 - x), ends(2.0 / x)], [[1.0, 1.5], [2.0, 4.0]]);
    }

    /// In a scope with `S: Scalar`, its bound on `f64 - S` must not capture `f64 - f64`.
    #[test]
    fn arithmetic_of_numbers_is_not_taken_for_that_of_scalars() {
        struct Wave {
            height: f64,
            numbers: [f64; 2],
        }
        impl Wave {
            fn at<S: Scalar>(&self, x: S, u: &[f64]) -> S {
                let k = 2.0 * self.height.powi(2) - 1.0 / self.height;
                let mean = 0.5 * self.numbers.iter().sum::<f64>() - 1.0;
                let largest = 1.0 - self.numbers.iter().copied().fold(0.0, f64::max);
                let product: f64 = u.iter().zip(&self.numbers).map(|(u, k)| u * k).sum();
                (1.0 - 2.0 * self.numbers[0] * x.cos()) * (2.0 * u[0] * u[1])
                    + (k * mean - largest * product) * x
            }
        }
        let wave = Wave { height: 2.0, numbers: [0.5, 3.0] };
        // k = 7.5, the mean is 0.75, 1 − 3 = −2, and the product is 3.5: (1 − 1) 4 + 12.625 · 0.
        assert_eq!(wave.at(0.0, &[1.0, 2.0 / 2.0]), 0.0);
        assert_eq!(wave.at(1.0, &[0.0, 1.0]), 7.5 * 0.75 + 2.0 * 3.0);
    }
}
