//! The operators of every number type in this crate, and which of them follow from which.

/// Implements further operators for a number type with `+ − × ÷` and
/// [`Scalar::constant`](crate::Scalar::constant): those with an `f64` on either side, the
/// assignment operators, `0` and `1`.
///
/// The generic parameters come first, in brackets: `operators_follow!([] MyNumber)`.
#[macro_export]
macro_rules! operators_follow {
    ([$($generics:tt)*] $number:ty) => {
        $crate::operators_follow!(@each [$($generics)*] $number, Add add AddAssign add_assign);
        $crate::operators_follow!(@each [$($generics)*] $number, Sub sub SubAssign sub_assign);
        $crate::operators_follow!(@each [$($generics)*] $number, Mul mul MulAssign mul_assign);
        $crate::operators_follow!(@each [$($generics)*] $number, Div div DivAssign div_assign);
        $crate::operators_follow!(@constants [$($generics)*] $number);
        $crate::f64_on_the_left!([$($generics)*] $number);
    };
    (
        @each [$($generics:tt)*] $number:ty,
        $operator:ident $method:ident $assign:ident $assign_method:ident
    ) => {
        impl<$($generics)*> ::std::ops::$operator<f64> for $number {
            type Output = Self;
            #[inline(always)]
            fn $method(self, c: f64) -> Self {
                ::std::ops::$operator::$method(self, <Self as $crate::Scalar>::constant(c))
            }
        }
        impl<$($generics)*> ::std::ops::$assign for $number {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = ::std::ops::$operator::$method(*self, other);
            }
        }
    };
    (@constants [$($generics:tt)*] $number:ty) => {
        impl<$($generics)*> $crate::num_traits::Zero for $number {
            #[inline(always)]
            fn zero() -> Self {
                <Self as $crate::Scalar>::constant(0.0)
            }
            #[inline]
            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }
        impl<$($generics)*> $crate::num_traits::One for $number {
            #[inline(always)]
            fn one() -> Self {
                <Self as $crate::Scalar>::constant(1.0)
            }
        }
    };
}

/// Implements [`Scalar`](crate::Scalar), its operators and the accessors of value and gradient for
/// a jet type. The type must have the fields `value` and `first`, `×` and `÷` with itself,
/// `constant_part(T)`, `map(f: T → T)`, `zip(&other, f: (&mut T, T))` and the chain rule
/// `chain([f, f′, f″])`.
macro_rules! jet {
    ($jet:ident) => {
        jet!(@sum $jet, Add add AddAssign add_assign);
        jet!(@sum $jet, Sub sub SubAssign sub_assign);
        jet!(@product $jet, Mul mul MulAssign mul_assign);
        jet!(@product $jet, Div div DivAssign div_assign);

        impl<T: Scalar, const D: usize> $jet<T, D> {
            /// Returns the value.
            #[must_use]
            #[inline]
            pub fn value(&self) -> T {
                self.value
            }

            /// Returns the derivative with respect to variable `i < D`.
            #[must_use]
            #[inline]
            pub fn first(&self, i: usize) -> T {
                self.first[i]
            }

            /// Returns the gradient.
            #[must_use]
            #[inline]
            pub fn gradient(&self) -> &[T; D] {
                &self.first
            }
        }

        impl<T: Scalar, const D: usize> Neg for $jet<T, D> {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                self.map(|c| -c)
            }
        }
        impl<T: Scalar, const D: usize> Add<f64> for $jet<T, D> {
            type Output = Self;
            #[inline]
            fn add(self, c: f64) -> Self {
                Self { value: self.value + c, ..self }
            }
        }
        impl<T: Scalar, const D: usize> Sub<f64> for $jet<T, D> {
            type Output = Self;
            #[inline]
            fn sub(self, c: f64) -> Self {
                self + -c
            }
        }
        $crate::f64_on_the_left!([T: Scalar, const D: usize] $jet<T, D>);
        $crate::operators_follow!(@constants [T: Scalar, const D: usize] $jet<T, D>);

        impl<T: Scalar, const D: usize> Scalar for $jet<T, D> {
            #[inline]
            fn constant(value: f64) -> Self {
                Self::constant_part(T::constant(value))
            }

            #[inline]
            fn sqr(self) -> Self {
                self.chain(elementary::sqr(self.value))
            }

            #[inline]
            fn powi(self, n: i32) -> Self {
                // `chain` multiplies by the zeros of n = 0, so what is undefined stays undefined.
                if n == 1 { self } else { self.chain(elementary::powi(self.value, n)) }
            }

            #[inline]
            fn recip(self) -> Self {
                self.chain(elementary::recip(self.value))
            }

            #[inline]
            fn sqrt(self) -> Self {
                self.chain(elementary::sqrt(self.value))
            }

            #[inline]
            fn exp(self) -> Self {
                self.chain(elementary::exp(self.value))
            }

            #[inline]
            fn ln(self) -> Self {
                self.chain(elementary::ln(self.value))
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let [sin, cos] = elementary::sin_cos(self.value);
                (self.chain(sin), self.chain(cos))
            }

            #[inline]
            fn tan(self) -> Self {
                self.chain(elementary::tan(self.value))
            }

            #[inline]
            fn atan(self) -> Self {
                self.chain(elementary::atan(self.value))
            }

            #[inline]
            fn sinh_cosh(self) -> (Self, Self) {
                let [sinh, cosh] = elementary::sinh_cosh(self.value);
                (self.chain(sinh), self.chain(cosh))
            }

            #[inline]
            fn tanh(self) -> Self {
                self.chain(elementary::tanh(self.value))
            }

            /// Taylor's formula to second order, which is exact for jets.
            fn tabulated(table: &Arc<dyn Table>, orders: [u8; 3], u: &[Self]) -> Self {
                if u.len() > 3 {
                    // NaN with all its derivatives: that of a constant would be 0.
                    return u[0].sqr() * f64::NAN;
                }
                let mut at = [T::zero(); 3];
                at.iter_mut().zip(u).for_each(|(at, u)| *at = u.value);
                let at = &at[..u.len()];
                let value = T::tabulated(table, orders, at);
                let mut sum = Self::constant_part(value);
                // What an argument adds to its value.
                let step = |axis: usize| Self { value: T::zero(), ..u[axis] };
                for axis in 0..at.len() {
                    let slopes = raised(orders, axis);
                    let slope = T::tabulated(table, slopes, at);
                    sum += step(axis).map(|c| c * slope);
                    if Self::ORDER < 2 {
                        continue;
                    }
                    for other in axis..at.len() {
                        let bend = T::tabulated(table, raised(slopes, other), at);
                        let bend = if other == axis { bend * 0.5 } else { bend };
                        sum += (step(axis) * step(other)).map(|c| c * bend);
                    }
                }
                Self { value, ..sum }
            }
        }
    };
    (
        @sum $jet:ident, $operator:ident $method:ident $assign:ident $assign_method:ident
    ) => {
        impl<T: Scalar, const D: usize> $operator for $jet<T, D> {
            type Output = Self;
            #[inline]
            fn $method(mut self, other: Self) -> Self {
                $assign::$assign_method(&mut self, other);
                self
            }
        }
        impl<T: Scalar, const D: usize> $assign for $jet<T, D> {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                self.zip(&other, $assign::$assign_method);
            }
        }
    };
    // The product and the quotient of two jets are implemented in the file of each type.
    (
        @product $jet:ident, $operator:ident $method:ident $assign:ident $assign_method:ident
    ) => {
        impl<T: Scalar, const D: usize> $operator<f64> for $jet<T, D> {
            type Output = Self;
            #[inline]
            fn $method(self, c: f64) -> Self {
                self.map(|a| $operator::$method(a, c))
            }
        }
        impl<T: Scalar, const D: usize> $assign for $jet<T, D> {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                *self = $operator::$method(*self, other);
            }
        }
    };
}

pub(crate) use jet;
