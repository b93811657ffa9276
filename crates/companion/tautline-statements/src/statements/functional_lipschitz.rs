//! Proposition 7.5: the difference of a quadratic form at two points and two vectors.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, MetricError, check_gram};

use crate::{
    Evidence, Statement, Subject, Unit, Units, VerifyError, extreme_eigenvalues, operator_norm,
};

/// The data of Proposition 7.5: two points, a vector and a matrix at each, and the constants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoForms<const D: usize> {
    /// `x₁` and `x₂`, in `ℓ`.
    pub points: [SVector<f64, D>; 2],
    /// `u₁` and `u₂`, in `ℓ`.
    pub vectors: [SVector<f64, D>; 2],
    /// `H(x₁)` and `H(x₂)`, symmetric, in `m²/ℓ²`.
    pub matrices: [SMatrix<f64, D, D>; 2],
    /// `c₂`, in `m²/ℓ²`.
    pub c2: f64,
    /// `L_H`, in `m²/ℓ³`.
    pub l_h: f64,
}

impl<const D: usize> TwoForms<D> {
    /// Evaluates a metric at the two points, with its constants.
    ///
    /// # Errors
    ///
    /// [`MetricError`] where `H` is not finite, symmetric and positive definite.
    pub fn of(
        subject: &Subject,
        metric: &impl Bounded<D>,
        points: [SVector<f64, D>; 2],
        vectors: [SVector<f64, D>; 2],
    ) -> Result<Self, MetricError> {
        let matrices = [check_gram(metric, &points[0])?, check_gram(metric, &points[1])?];
        let constants = subject.constants(metric);
        Ok(Self { points, vectors, matrices, c2: constants.c2(), l_h: constants.l_h() })
    }

    /// Returns the same data in other units.
    ///
    /// # Errors
    ///
    /// [`VerifyError::OutOfRange`] if a constant overflows.
    pub fn in_units(&self, units: Units) -> Result<Self, VerifyError> {
        let gram = Unit::GRAM.factor(units.ell, units.m);
        let l_h = self.l_h * Unit::GRAM_SLOPE.factor(units.ell, units.m);
        if !l_h.is_finite() {
            let (name, high) = ("L_H", f64::MAX);
            return Err(VerifyError::OutOfRange { name, value: l_h, low: 0.0, high });
        }
        Ok(Self {
            points: self.points.map(|x| units.vector(x)),
            vectors: self.vectors.map(|u| units.vector(u)),
            matrices: self.matrices.map(|h| h * gram),
            c2: self.c2 * gram,
            l_h,
        })
    }

    /// Returns `|x₁ − x₂|`.
    fn step(&self) -> f64 {
        (self.points[0] - self.points[1]).norm()
    }

    /// Returns the allowance for eigenvalues. An entry has a dozen roundings, and a row has `D`
    /// entries.
    fn rounding(&self) -> f64 {
        let size = self.matrices.iter().map(|h| h.amax()).fold(0.0, f64::max);
        16.0 * f64::EPSILON * (D * D) as f64 * size
    }

    /// Adds the conclusion, which is the same in the printed and in the repaired form.
    fn conclude(&self, evidence: Evidence) -> Evidence {
        let [u1, u2] = self.vectors;
        let [h1, h2] = self.matrices;
        let (first, second) = (u1.dot(&(h1 * u1)), u2.dot(&(h2 * u2)));
        let (speed, difference) = (u1.norm(), (u1 - u2).norm());
        let bound = self.l_h * self.step() * speed * speed
            + self.c2 * difference * difference
            + 2.0 * self.c2 * speed * difference;
        let size = self.rounding() * (u1.norm_squared() + u2.norm_squared());
        let granted = size + 16.0 * f64::EPSILON * bound;
        let claim =
            "|u₁ᵀH(x₁)u₁ − u₂ᵀH(x₂)u₂| ≤ L_H|x₁ − x₂||u₁|² + c₂|u₁ − u₂|² + 2c₂|u₁||u₁ − u₂|";
        evidence.stated(claim, Unit::ENERGY, [(first - second).abs(), bound], granted)
    }
}

/// Evaluates Proposition 7.5 in its repaired form.
///
/// ```text
/// |u₁ᵀH(x₁)u₁ − u₂ᵀH(x₂)u₂|  ≤  L_H |x₁ − x₂| |u₁|² + c₂ |u₁ − u₂|² + 2 c₂ |u₁| |u₁ − u₂|
/// ```
///
/// Needs: `0 ≤ H(x₂) ≤ c₂` and `‖H(x₁) − H(x₂)‖ ≤ L_H |x₁ − x₂|`. Nothing more is needed of
/// `H(x₁)`.
///
/// The bound is attained in dimension 1 for `u₂ > u₁ > 0`, `H(x₂) = c₂` and
/// `H(x₁) = c₂ − L_H |x₁ − x₂|`, where all three terms contribute.
#[doc(alias = "prop:functional_lipschitz_estimate")]
#[must_use]
pub fn prop_7_5<const D: usize>(forms: &TwoForms<D>) -> Evidence {
    let (low, high) = extreme_eigenvalues(&forms.matrices[1]);
    let rounding = forms.rounding();
    let evidence = Evidence::of(Statement::Proposition7_5)
        .given("0 ≤ λ_min(H(x₂))", Unit::GRAM, [-low, 0.0], rounding)
        .given("λ_max(H(x₂)) ≤ c₂", Unit::GRAM, [high, forms.c2], rounding);
    forms.conclude(lipschitz(evidence, forms))
}

/// Evaluates Proposition 7.5 as printed, with `uᵀHu ≤ c₂ |u|²` and no lower bound. It is false for
/// `H = −2` and `c₂ = 1` in dimension 1.
#[must_use]
pub fn prop_7_5_as_printed<const D: usize>(forms: &TwoForms<D>) -> Evidence {
    let rounding = forms.rounding();
    let mut evidence = Evidence::of(Statement::Proposition7_5);
    for (claim, matrix) in
        ["λ_max(H(x₁)) ≤ c₂", "λ_max(H(x₂)) ≤ c₂"].into_iter().zip(&forms.matrices)
    {
        let (_, high) = extreme_eigenvalues(matrix);
        evidence = evidence.given(claim, Unit::GRAM, [high, forms.c2], rounding);
    }
    forms.conclude(lipschitz(evidence, forms))
}

fn lipschitz<const D: usize>(evidence: Evidence, forms: &TwoForms<D>) -> Evidence {
    let [h1, h2] = forms.matrices;
    let numbers = [operator_norm(&(h1 - h2)), forms.l_h * forms.step()];
    evidence.given("‖H(x₁) − H(x₂)‖ ≤ L_H |x₁ − x₂|", Unit::GRAM, numbers, 2.0 * forms.rounding())
}
