//! `GalleryError`: the reasons why a metric of the gallery cannot be built, and the checks of
//! single parameters.

use crate::{HypothesisError, MetricError};

/// A parameter for which the formula is not a metric or has no finite constants.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GalleryError {
    /// A parameter is NaN or infinite.
    #[error("{name} = {value} must be finite")]
    NotFinite {
        /// The name of the parameter in the constructor.
        name: &'static str,
        /// The number that was given.
        value: f64,
    },
    /// A width, a wave number or an eigenvalue is not positive.
    #[error("{name} = {value} must be positive and finite")]
    NotPositive {
        /// The name of the parameter in the constructor.
        name: &'static str,
        /// The number that was given.
        value: f64,
    },
    /// A height, a mass or an inertia is negative.
    #[error("{name} = {value} must be nonnegative and finite")]
    Negative {
        /// The name of the parameter in the constructor.
        name: &'static str,
        /// The number that was given.
        value: f64,
    },
    /// `1 + a sin` or `1 + a tanh` is not positive for this relative amplitude `a`.
    #[error("{name} = {value} must lie strictly between -1 and 1")]
    NotBelowOne {
        /// The name of the parameter in the constructor.
        name: &'static str,
        /// The number that was given.
        value: f64,
    },
    /// The patch does not exist for this radius, or it overflows; the square of a width does.
    #[error("{name} = {value:?} must lie strictly between {low:?} and {high:?}")]
    OutOfRange {
        /// The name of the parameter in the constructor.
        name: &'static str,
        /// The number that was given.
        value: f64,
        /// The lower end of the range, excluded.
        low: f64,
        /// The upper end of the range, excluded.
        high: f64,
    },
    /// The inertia of a two-link arm is not positive definite in every position.
    #[error(
        "C (A - C) - B² = {determinant}, the determinant of the inertia of the stretched arm, \
         must be positive"
    )]
    SingularArm {
        /// The value of `C (A − C) − B²`.
        determinant: f64,
    },
    /// A given matrix is not symmetric positive definite.
    #[error(transparent)]
    Matrix(#[from] MetricError),
    /// The constants of the metric overflow, or its `c₁` underflows.
    #[error(transparent)]
    Constants(#[from] HypothesisError),
}

pub(super) fn finite(name: &'static str, value: f64) -> Result<f64, GalleryError> {
    if value.is_finite() { Ok(value) } else { Err(GalleryError::NotFinite { name, value }) }
}

pub(super) fn positive(name: &'static str, value: f64) -> Result<f64, GalleryError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(GalleryError::NotPositive { name, value })
    }
}

/// Returns a width, whose square and reciprocal the formula has. Where they over- or underflow, the formula
/// would be another one.
pub(super) fn squarable(name: &'static str, value: f64) -> Result<f64, GalleryError> {
    between(name, positive(name, value)?, NARROWEST, 1.0 / NARROWEST)
}

/// `2⁻⁵⁰⁰`, below the widths that may be.
const NARROWEST: f64 = f64::from_bits((1023 - 500) << 52);

pub(super) fn nonnegative(name: &'static str, value: f64) -> Result<f64, GalleryError> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(GalleryError::Negative { name, value })
    }
}

pub(super) fn below_one(name: &'static str, value: f64) -> Result<f64, GalleryError> {
    if value.abs() < 1.0 { Ok(value) } else { Err(GalleryError::NotBelowOne { name, value }) }
}

pub(super) fn between(
    name: &'static str,
    value: f64,
    low: f64,
    high: f64,
) -> Result<f64, GalleryError> {
    if low < value && value < high {
        Ok(value)
    } else {
        Err(GalleryError::OutOfRange { name, value, low, high })
    }
}

#[cfg(test)]
mod tests {
    use super::{GalleryError, between, squarable};

    #[test]
    fn the_square_of_a_width_is_a_number() {
        for good in [1e-150, 1.0, 1e150] {
            assert_eq!(squarable("width", good), Ok(good));
        }
        for bad in [1e-170, 1.4e154, 1e300] {
            let refused = squarable("width", bad);
            assert!(matches!(refused, Err(GalleryError::OutOfRange { .. })), "{bad}");
        }
        assert!(matches!(squarable("width", 0.0), Err(GalleryError::NotPositive { .. })));
    }

    #[test]
    fn the_ends_of_a_range_are_not_between_them() {
        assert_eq!(between("x", 0.5, 0.0, 1.0), Ok(0.5));
        for bad in [0.0, 1.0, -1.0, f64::NAN] {
            assert!(between("x", bad, 0.0, 1.0).is_err(), "{bad}");
        }
    }
}
