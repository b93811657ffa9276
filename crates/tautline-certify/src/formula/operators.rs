//! The operators that follow from others, for the number types that read a formula.

/// Implements, for a type that has `+ × ÷`, `−x` and
/// [`Scalar::constant`](tautline_scalar::Scalar::constant), the difference, the operators with an
/// `f64` on either side and those that assign, `0` and `1`.
macro_rules! operators_follow {
    ([$($generics:tt)*] $number:ty) => {
        impl<$($generics)*> Sub for $number {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                self + -other
            }
        }
        operators_follow!(@with [$($generics)*] $number, Add, add, AddAssign, add_assign);
        operators_follow!(@with [$($generics)*] $number, Sub, sub, SubAssign, sub_assign);
        operators_follow!(@with [$($generics)*] $number, Mul, mul, MulAssign, mul_assign);
        operators_follow!(@with [$($generics)*] $number, Div, div, DivAssign, div_assign);
        tautline_scalar::f64_on_the_left!([$($generics)*] $number);
        impl<$($generics)*> One for $number {
            fn one() -> Self {
                Self::constant(1.0)
            }
        }
    };
    (@with [$($generics:tt)*] $number:ty, $Op:ident, $op:ident, $Assign:ident, $assign:ident) => {
        impl<$($generics)*> $Op<f64> for $number {
            type Output = Self;
            fn $op(self, c: f64) -> Self {
                self.$op(Self::constant(c))
            }
        }
        impl<$($generics)*> $Assign for $number {
            fn $assign(&mut self, other: Self) {
                *self = self.$op(other);
            }
        }
    };
}

pub(super) use operators_follow;
