//! `MixedJet`: a value and its mixed second derivatives in two groups of `D` directions.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::{Scalar, operators::jet_is_scalar};

/// An expansion `v + Σ pᵢ dsᵢ + Σ qⱼ dtⱼ + Σ mᵢⱼ dsᵢ dtⱼ` to first order in each of two groups of
/// `D` directions.
///
/// Where a function has too many variables for a [`Jet2`](crate::Jet2) of all of them, this takes
/// a block of its second derivatives at a time: `sᵢ` stands for some of the variables, `tⱼ` for
/// others or for the same. It has `(1 + D)²` numbers, however many variables there are.
///
/// Arithmetic on expansions is arithmetic on functions, cut after first order in each group. The
/// value follows the same operations, in the same order, as the formula in `T` itself.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "hyper-dual number")]
pub struct MixedJet<T, const D: usize> {
    value: T,
    first: [[T; D]; 2],
    mixed: [[T; D]; D],
}

impl<T: Scalar, const D: usize> MixedJet<T, D> {
    /// Returns the variable with the given value that grows in the direction `i < D` of the first
    /// group and `j < D` of the second, each if there is one.
    #[must_use]
    #[inline]
    pub fn variable(value: T, i: Option<usize>, j: Option<usize>) -> Self {
        let mut jet = Self::constant_part(value);
        for (first, direction) in jet.first.iter_mut().zip([i, j]) {
            if let Some(direction) = direction {
                first[direction] = T::one();
            }
        }
        jet
    }

    /// Returns the value.
    #[must_use]
    #[inline]
    pub fn value(&self) -> T {
        self.value
    }

    /// Returns the second derivative in the directions `i < D` of the first group and `j < D` of
    /// the second.
    #[must_use]
    #[inline]
    pub fn mixed(&self, i: usize, j: usize) -> T {
        self.mixed[i][j]
    }

    #[inline]
    fn constant_part(value: T) -> Self {
        Self { value, first: [[T::zero(); D]; 2], mixed: [[T::zero(); D]; D] }
    }

    /// The mixed part with entry `f(i, j)`.
    #[inline]
    fn all(f: impl Fn(usize, usize) -> T) -> [[T; D]; D] {
        let mut mixed = [[T::zero(); D]; D];
        for i in 0..D {
            for j in 0..D {
                mixed[i][j] = f(i, j);
            }
        }
        mixed
    }

    /// The first-order parts with entry `f(group, i)`.
    #[inline]
    fn both(f: impl Fn(usize, usize) -> T) -> [[T; D]; 2] {
        let mut first = [[T::zero(); D]; 2];
        for group in 0..2 {
            for i in 0..D {
                first[group][i] = f(group, i);
            }
        }
        first
    }

    #[inline]
    fn map(self, f: impl Fn(T) -> T) -> Self {
        Self {
            value: f(self.value),
            first: Self::both(|group, i| f(self.first[group][i])),
            mixed: Self::all(|i, j| f(self.mixed[i][j])),
        }
    }

    /// Changes every number by the one in its place.
    #[inline]
    fn zip(&mut self, other: &Self, f: impl Fn(&mut T, T)) {
        f(&mut self.value, other.value);
        for i in 0..D {
            for group in 0..2 {
                f(&mut self.first[group][i], other.first[group][i]);
            }
            for j in 0..D {
                f(&mut self.mixed[i][j], other.mixed[i][j]);
            }
        }
    }

    #[inline]
    fn shift(self, c: f64) -> Self {
        Self { value: self.value + c, ..self }
    }

    /// `f ∘ self`, where `f` has the given value and derivatives there.
    #[inline]
    fn chain(self, value: T, first: T, second: T) -> Self {
        let [p, q] = self.first;
        Self {
            value,
            first: Self::both(|group, i| self.first[group][i] * first),
            mixed: Self::all(|i, j| self.mixed[i][j] * first + p[i] * q[j] * second),
        }
    }
}

impl<T: Scalar, const D: usize> Add for MixedJet<T, D> {
    type Output = Self;
    #[inline]
    fn add(mut self, other: Self) -> Self {
        self.zip(&other, |a, b| *a += b);
        self
    }
}

impl<T: Scalar, const D: usize> Sub for MixedJet<T, D> {
    type Output = Self;
    #[inline]
    fn sub(mut self, other: Self) -> Self {
        self.zip(&other, |a, b| *a -= b);
        self
    }
}

impl<T: Scalar, const D: usize> Mul for MixedJet<T, D> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let ([ap, aq], [bp, bq]) = (a.first, b.first);
        Self {
            value: a.value * b.value,
            first: Self::both(|group, i| a.first[group][i] * b.value + b.first[group][i] * a.value),
            mixed: Self::all(|i, j| {
                a.mixed[i][j] * b.value + b.mixed[i][j] * a.value + ap[i] * bq[j] + bp[i] * aq[j]
            }),
        }
    }
}

impl<T: Scalar, const D: usize> Div for MixedJet<T, D> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let (a, b) = (self, other);
        // q b = a, differentiated once and twice, as for `Jet2`.
        let q = a.value / b.value;
        let first = Self::both(|group, i| (a.first[group][i] - q * b.first[group][i]) / b.value);
        let mixed = Self::all(|i, j| {
            (a.mixed[i][j]
                - first[0][i] * b.first[1][j]
                - b.first[0][i] * first[1][j]
                - q * b.mixed[i][j])
                / b.value
        });
        Self { value: q, first, mixed }
    }
}

jet_is_scalar!(MixedJet);
