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
/// `constant_part(T)`, `map(f: T → T)`, `zip(&other, f: (&mut T, T))` and `chain(f, f′, f″)`. Each
/// elementary function is one line of the chain rule.
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
                let x = self.value();
                self.chain(x.sqr(), x * 2.0, T::constant(2.0))
            }

            #[inline]
            fn powi(self, n: i32) -> Self {
                let x = self.value();
                match n {
                    // The general case would compute n xⁿ⁻¹ as 0 · ∞ at x = 0. `chain` multiplies
                    // by these zeros, so what is undefined stays undefined.
                    0 => self.chain(x.powi(0), T::zero(), T::zero()),
                    1 => self,
                    2 => self.sqr(),
                    // Here n − 2 overflows.
                    ..=-2_147_483_647 => {
                        let (power, k) = (x.powi(n), f64::from(n));
                        let first = power / x * k;
                        self.chain(power, first, first / x * (k - 1.0))
                    }
                    // Here n (n − 1) has at most 53 bits.
                    -67_108_863..=67_108_864 => {
                        let k = f64::from(n);
                        self.chain(x.powi(n), x.powi(n - 1) * k, x.powi(n - 2) * (k * (k - 1.0)))
                    }
                    // Here it is rounded, so intervals must enclose it.
                    _ => {
                        let k = f64::from(n);
                        let bend = T::constant(k) * (k - 1.0);
                        self.chain(x.powi(n), x.powi(n - 1) * k, x.powi(n - 2) * bend)
                    }
                }
            }

            #[inline]
            fn recip(self) -> Self {
                let r = self.value().recip();
                self.chain(r, -r.sqr(), r.sqr() * r * 2.0)
            }

            #[inline]
            fn sqrt(self) -> Self {
                let x = self.value();
                let s = x.sqrt();
                let first = s.recip() * 0.5;
                self.chain(s, first, -first / x * 0.5)
            }

            #[inline]
            fn exp(self) -> Self {
                let e = self.value().exp();
                self.chain(e, e, e)
            }

            #[inline]
            fn ln(self) -> Self {
                let x = self.value();
                let first = x.recip();
                // ln x is NaN for x < 0, though 1/x is not. The derivatives must be NaN too.
                let inside = x.ln() * 0.0;
                self.chain(x.ln(), first + inside, -first.sqr() + inside)
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let (s, c) = self.value().sin_cos();
                (self.chain(s, c, -s), self.chain(c, -s, -c))
            }

            #[inline]
            fn tan(self) -> Self {
                let t = self.value().tan();
                let first = t.sqr() + 1.0;
                self.chain(t, first, t * first * 2.0)
            }

            #[inline]
            fn atan(self) -> Self {
                let x = self.value();
                let first = (x.sqr() + 1.0).recip();
                self.chain(x.atan(), first, -x * first.sqr() * 2.0)
            }

            #[inline]
            fn sinh_cosh(self) -> (Self, Self) {
                let (s, c) = self.value().sinh_cosh();
                (self.chain(s, c, s), self.chain(c, s, c))
            }

            #[inline]
            fn tanh(self) -> Self {
                let x = self.value();
                let t = x.tanh();
                // The derivative is 1/cosh², not 1 − tanh², which cancels where tanh is close to
                // ±1.
                let first = x.cosh().sqr().recip();
                self.chain(t, first, -t * first * 2.0)
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
