//! Random metrics with known distances.

use proptest::prelude::*;
use tautline::{
    SMatrix, SVector,
    gallery::{Bump, Constant, Hill, Lens, Ramp, Separable, Shear},
};

use super::points::vector;

/// Draws a symmetric positive definite matrix `MᵀM + ¼ I`, where `M` has entries in `[−1, 1]`.
pub(super) fn matrix<const D: usize>() -> impl Strategy<Value = SMatrix<f64, D, D>> {
    let entries = proptest::array::uniform::<_, D>(vector::<D>(1.0));
    entries.prop_map(|columns| {
        let m: SMatrix<f64, D, D> = SMatrix::from_columns(&columns);
        let square: SMatrix<f64, D, D> = m.tr_mul(&m) + SMatrix::identity() * 0.25;
        (square + square.transpose()) * 0.5
    })
}

/// Draws constant metrics with eigenvalues in `[¼, D² + ¼]`.
pub fn constant<const D: usize>() -> impl Strategy<Value = Constant<D>> {
    matrix().prop_map(|a| Constant::new(a).expect("positive definite"))
}

/// Draws shears with amplitude up to 0.8 and wave number up to 2.
pub fn shear() -> impl Strategy<Value = Shear> {
    (-0.8..0.8, 0.5..2.0)
        .prop_map(|(amplitude, k)| Shear::new(amplitude, k).expect("a positive wave number"))
}

/// Draws separable metrics with amplitudes up to 0.6 and wave numbers up to 2.
pub fn separable<const D: usize>() -> impl Strategy<Value = Separable<D>> {
    let wave_numbers = proptest::array::uniform::<_, D>(0.5..2.0);
    (vector(0.6), wave_numbers).prop_map(|(amplitudes, k): (SVector<f64, D>, _)| {
        Separable::new(amplitudes, k).expect("amplitudes below one")
    })
}

/// Draws ramps with amplitude up to 0.7 and wave number up to 2.
pub fn ramp() -> impl Strategy<Value = Ramp> {
    (-0.7..0.7, 0.5..2.0).prop_map(|(amplitude, k)| Ramp::new(amplitude, k).expect("below one"))
}

/// Draws bumps with heights up to 2 and widths from 0.5 to 2.
pub fn bump() -> impl Strategy<Value = Bump> {
    (0.0..2.0, 0.5..2.0).prop_map(|(height, width)| Bump::new(height, width).expect("a width"))
}

/// Draws lenses with heights up to 3 and widths from 0.5 to 2.
pub fn lens() -> impl Strategy<Value = Lens> {
    (0.0..3.0, 0.5..2.0).prop_map(|(height, width)| Lens::new(height, width).expect("a width"))
}

/// Draws hills with heights up to 1 and widths from 0.5 to 2.
pub fn hill() -> impl Strategy<Value = Hill> {
    (-1.0..1.0, 0.5..2.0).prop_map(|(height, width)| Hill::new(height, width).expect("a width"))
}
