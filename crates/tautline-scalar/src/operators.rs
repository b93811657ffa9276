//! What the jets share: every operator that follows from `+`, `×`, a constant and the
//! chain rule, and every elementary function as one line of the chain rule.

/// Implements [`Scalar`](crate::Scalar) and its operators for a jet type which has
/// `+ − × ÷` with itself, `constant_part(T)`, `map(f: T → T)`, `shift(f64)`, `chain(f, f′, f″)` and
/// `zip(other, f: (&mut T, T))`.
macro_rules! jet_is_scalar {
    ($jet:ident) => {
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
                self.shift(c)
            }
        }
        impl<T: Scalar, const D: usize> Sub<f64> for $jet<T, D> {
            type Output = Self;
            #[inline]
            fn sub(self, c: f64) -> Self {
                self.shift(-c)
            }
        }
        impl<T: Scalar, const D: usize> Mul<f64> for $jet<T, D> {
            type Output = Self;
            #[inline]
            fn mul(self, c: f64) -> Self {
                self.map(|a| a * c)
            }
        }
        impl<T: Scalar, const D: usize> Div<f64> for $jet<T, D> {
            type Output = Self;
            #[inline]
            fn div(self, c: f64) -> Self {
                self.map(|a| a / c)
            }
        }
        $crate::f64_on_the_left!([T: Scalar, const D: usize] $jet<T, D>);

        impl<T: Scalar, const D: usize> AddAssign for $jet<T, D> {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                self.zip(&other, |a, b| *a += b);
            }
        }
        impl<T: Scalar, const D: usize> SubAssign for $jet<T, D> {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                self.zip(&other, |a, b| *a -= b);
            }
        }
        impl<T: Scalar, const D: usize> MulAssign for $jet<T, D> {
            #[inline]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }
        impl<T: Scalar, const D: usize> DivAssign for $jet<T, D> {
            #[inline]
            fn div_assign(&mut self, other: Self) {
                *self = *self / other;
            }
        }
        impl<T: Scalar, const D: usize> Zero for $jet<T, D> {
            #[inline]
            fn zero() -> Self {
                Self::constant_part(T::zero())
            }
            #[inline]
            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }
        impl<T: Scalar, const D: usize> One for $jet<T, D> {
            #[inline]
            fn one() -> Self {
                Self::constant_part(T::one())
            }
        }

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
                    // Apart, since n xⁿ⁻¹ would be 0 · ∞ at x = 0. Zero times what comes in, and
                    // not zero, so that what is not defined stays so.
                    0 => self.chain(x.powi(0), T::zero(), T::zero()),
                    1 => self,
                    2 => self.sqr(),
                    // The exponents of the derivatives are none.
                    ..=-2_147_483_647 => {
                        let (power, k) = (x.powi(n), f64::from(n));
                        let first = power / x * k;
                        self.chain(power, first, first / x * (k - 1.0))
                    }
                    _ => {
                        let k = f64::from(n);
                        self.chain(x.powi(n), x.powi(n - 1) * k, x.powi(n - 2) * (k * (k - 1.0)))
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
                // ln x is NaN for x < 0, though 1/x is not: the derivatives must be NaN too.
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
                // 1/cosh², not 1 − tanh²: the latter cancels where tanh is near ±1.
                let first = x.cosh().sqr().recip();
                self.chain(t, first, -t * first * 2.0)
            }
        }
    };
}

pub(crate) use jet_is_scalar;
