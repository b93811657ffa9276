//! `Jet2`: a value with its gradient and second derivatives in `D` variables.

use std::{
    ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign},
    sync::Arc,
};

use crate::{Scalar, Table, elementary, operators::jet, table::raised};

/// A second-order Taylor expansion `v + Σ gᵢ dxᵢ + ½ Σ hᵢⱼ dxᵢ dxⱼ` in `D` variables.
///
/// Arithmetic on expansions is arithmetic on functions, truncated after second order. The value is
/// computed by the same operations, in the same order, as when the formula is evaluated in `T`.
#[derive(Clone, Copy, Debug)]
#[doc(alias = "hyper-dual number")]
pub struct Jet2<T, const D: usize> {
    value: T,
    first: [T; D],
    // Invariant: entries below the diagonal stay zero.
    second: [[T; D]; D],
    // Whether `second` may be nonzero. It is zero for coordinates and their linear combinations,
    // with which most formulas begin; for D = 8 these need 9 of 45 numbers. If a formula is
    // inlined, the branch disappears.
    bent: bool,
}

impl<T: PartialEq, const D: usize> PartialEq for Jet2<T, D> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value && self.first == other.first && self.second == other.second
    }
}

impl<T: Scalar, const D: usize> Jet2<T, D> {
    /// Returns the function with this value, this gradient, and the second derivatives
    /// `second(i, j)` for `i ≤ j`.
    #[must_use]
    #[inline]
    pub fn new(value: T, first: [T; D], second: impl Fn(usize, usize) -> T) -> Self {
        Self { value, first, second: Self::upper(second), bent: true }
    }

    /// Returns the `D` coordinate functions at the point `x`.
    #[must_use]
    #[inline]
    pub fn variables(x: &[T; D]) -> [Self; D] {
        std::array::from_fn(|i| {
            let mut jet = Self::constant_part(x[i]);
            jet.first[i] = T::one();
            jet
        })
    }

    /// Returns the second derivative with respect to the variables `i, j < D`, in either order.
    #[must_use]
    #[inline]
    pub fn second(&self, i: usize, j: usize) -> T {
        self.second[i.min(j)][i.max(j)]
    }

    /// The order of the expansion.
    const ORDER: usize = 2;

    #[inline]
    fn constant_part(value: T) -> Self {
        Self { value, first: [T::zero(); D], second: [[T::zero(); D]; D], bent: false }
    }

    /// Returns the second-order part with the entries `f(i, j)` for `j ≥ i`.
    #[inline(always)]
    fn upper(f: impl Fn(usize, usize) -> T) -> [[T; D]; D] {
        let mut second = [[T::zero(); D]; D];
        for i in 0..D {
            for j in i..D {
                second[i][j] = f(i, j);
            }
        }
        second
    }

    #[inline]
    fn map(self, f: impl Fn(T) -> T) -> Self {
        Self {
            value: f(self.value),
            first: self.first.map(&f),
            second: if self.bent { Self::upper(|i, j| f(self.second[i][j])) } else { self.second },
            bent: self.bent,
        }
    }

    /// Applies `f` to corresponding coefficients, except where the coefficient of `other` is zero.
    #[inline]
    fn zip(&mut self, other: &Self, f: impl Fn(&mut T, T)) {
        f(&mut self.value, other.value);
        for i in 0..D {
            f(&mut self.first[i], other.first[i]);
        }
        if other.bent {
            for i in 0..D {
                for j in i..D {
                    f(&mut self.second[i][j], other.second[i][j]);
                }
            }
        }
        self.bent |= other.bent;
    }

    /// Returns `f ∘ self`, where `f` has the given value and derivatives at the value of `self`.
    #[inline]
    fn chain(self, [value, first, second]: [T; 3]) -> Self {
        let g = self.first;
        Self {
            value,
            first: g.map(|gi| gi * first),
            second: Self::upper(|i, j| {
                // The square of an interval is tighter than its product with itself.
                let product = if i == j { g[i].sqr() } else { g[i] * g[j] };
                if self.bent {
                    self.second[i][j] * first + product * second
                } else {
                    product * second
                }
            }),
            bent: true,
        }
    }
}

impl<T: Scalar, const D: usize> Mul for Jet2<T, D> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self {
            value: a.value * b.value,
            first: std::array::from_fn(|i| a.first[i] * b.value + b.first[i] * a.value),
            second: Self::upper(|i, j| {
                let mixed = a.first[i] * b.first[j] + a.first[j] * b.first[i];
                match (a.bent, b.bent) {
                    (true, true) => a.second[i][j] * b.value + b.second[i][j] * a.value + mixed,
                    (true, false) => a.second[i][j] * b.value + mixed,
                    (false, true) => b.second[i][j] * a.value + mixed,
                    (false, false) => mixed,
                }
            }),
            bent: true,
        }
    }
}

impl<T: Scalar, const D: usize> Div for Jet2<T, D> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let (a, b) = (self, other);
        // Differentiating q b = a once and twice gives
        // q' b + q b' = a',   qᵢⱼ b + qᵢ bⱼ + qⱼ bᵢ + q bᵢⱼ = aᵢⱼ.
        let q = a.value / b.value;
        let first: [T; D] = std::array::from_fn(|i| (a.first[i] - q * b.first[i]) / b.value);
        let second = Self::upper(|i, j| {
            (a.second[i][j] - first[i] * b.first[j] - first[j] * b.first[i] - q * b.second[i][j])
                / b.value
        });
        Self { value: q, first, second, bent: true }
    }
}

jet!(Jet2);
