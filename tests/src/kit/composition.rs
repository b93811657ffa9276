//! Runs the kit on metrics composed from metrics of the gallery.

use std::f64::consts::TAU;

use tautline::{
    composition::{AffinePullback, Product, Scaled, Sum},
    gallery::{EggCrate, Hill, Lens, Shear},
};
use tautline_kit::prelude::*;

use super::gallery::{cube, period};

pub(super) fn shear() -> Shear {
    Shear::new(0.5, 1.0).expect("a wave number")
}

/// Returns the product of a shear and a lens.
pub(super) fn product() -> Product<Shear, Lens, 2, 2> {
    Product::new(shear(), Lens::new(1.0, 0.5).expect("a width"))
}

/// Returns a region that spans one period of the shear, and six widths of the lens on each side.
pub(super) fn beside() -> Region<4> {
    Region::cell([0.0, 0.0, -3.0, -3.0], [TAU, TAU, 3.0, 3.0])
}

pub(super) fn sum() -> Sum<Shear, EggCrate> {
    Sum::new(shear(), EggCrate::new(0.5, 1.0).expect("a wave number"))
}

pub(super) fn scaled() -> Scaled<Hill> {
    Scaled::new(Hill::new(0.5, 0.5).expect("a width"), 2.5).expect("a factor")
}

/// Returns the pullback of a shear by a matrix that is neither a similarity nor symmetric.
pub(super) fn pullback() -> AffinePullback<Shear, 2> {
    let matrix = SMatrix::<f64, 2, 2>::new(1.2, -0.5, 0.3, 0.8);
    AffinePullback::new(shear(), matrix, [0.5, -0.25]).expect("invertible")
}

metric_suite!(a_product: product(), dimension 4, in beside(), with distances);
metric_suite!(a_sum: sum(), dimension 2, in period());
metric_suite!(a_multiple: scaled(), dimension 2, in cube(3.0), with distances);
metric_suite!(an_affine_pullback: pullback(), dimension 2, in cube(4.0), with distances);
