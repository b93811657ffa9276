//! Random metrics whose geodesics are known.

use proptest::prelude::*;
use tautline::{
    SVector,
    gallery::{Separable, Shear},
};

use crate::random::vector;

pub(crate) fn shear() -> impl Strategy<Value = Shear> {
    (-0.8..0.8, 0.5..2.0)
        .prop_map(|(amplitude, k)| Shear::new(amplitude, k).expect("a positive wave number"))
}

pub(crate) fn separable<const D: usize>() -> impl Strategy<Value = Separable<D>> {
    let wave_numbers = proptest::array::uniform::<_, D>(0.5..2.0);
    (vector(0.6), wave_numbers).prop_map(|(amplitudes, k): (SVector<f64, D>, _)| {
        Separable::new(amplitudes, k).expect("amplitudes below one")
    })
}
