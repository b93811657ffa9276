//! `Jet1`: a value and its gradient in `D` variables.

use std::{
    ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign},
    sync::Arc,
};

use crate::{Scalar, Table, elementary, operators::jet, table::raised};

/// A first-order Taylor expansion `v + Σ gᵢ dxᵢ` in `D` variables.
///
/// Arithmetic on expansions is arithmetic on functions, truncated after first order. The value is
/// computed by the same operations, in the same order, as when the formula is evaluated in `T`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "dual number")]
pub struct Jet1<T, const D: usize> {
    value: T,
    first: [T; D],
}

impl<T: Scalar, const D: usize> Jet1<T, D> {
    /// Returns the function with this value and this gradient.
    #[must_use]
    #[inline]
    pub fn new(value: T, first: [T; D]) -> Self {
        Self { value, first }
    }

    /// Returns the `D` coordinate functions at the point `x`.
    #[must_use]
    #[inline]
    pub fn variables(x: &[T; D]) -> [Self; D] {
        std::array::from_fn(|i| Self {
            value: x[i],
            first: std::array::from_fn(|j| if i == j { T::one() } else { T::zero() }),
        })
    }

    /// The order of the expansion.
    const ORDER: usize = 1;

    #[inline]
    fn constant_part(value: T) -> Self {
        Self { value, first: [T::zero(); D] }
    }

    #[inline]
    fn map(self, f: impl Fn(T) -> T) -> Self {
        Self { value: f(self.value), first: self.first.map(f) }
    }

    /// Applies `f` to corresponding coefficients.
    #[inline]
    fn zip(&mut self, other: &Self, f: impl Fn(&mut T, T)) {
        f(&mut self.value, other.value);
        for i in 0..D {
            f(&mut self.first[i], other.first[i]);
        }
    }

    /// Returns `f ∘ self`, where `f` has the given value and derivative at the value of `self`.
    #[inline]
    fn chain(self, [value, first, _]: [T; 3]) -> Self {
        Self { value, first: self.first.map(|g| g * first) }
    }
}

impl<T: Scalar, const D: usize> Mul for Jet1<T, D> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self {
            value: a.value * b.value,
            first: std::array::from_fn(|i| a.first[i] * b.value + b.first[i] * a.value),
        }
    }
}

impl<T: Scalar, const D: usize> Div for Jet1<T, D> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let (a, b) = (self, other);
        // Differentiating q b = a gives q' b + q b' = a'.
        let q = a.value / b.value;
        Self { value: q, first: std::array::from_fn(|i| (a.first[i] - q * b.first[i]) / b.value) }
    }
}

jet!(Jet1);
