//! The constants of compositions hold at random points, for random parts.

use nalgebra::{SMatrix, SVector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    composition::{AffinePullback, Product, Scaled, Sum},
    gallery::{Lens, Ramp, RotatingAnisotropy, Shear, TwoLinkArm},
};

use super::conformal::Conformal;
use crate::laws::{cube, hold};

fn shear() -> impl Strategy<Value = Shear> {
    (-2.0..2.0_f64, 0.2..3.0_f64).prop_map(|(a, k)| Shear::new(a, k).expect("k > 0"))
}

fn rotating() -> impl Strategy<Value = RotatingAnisotropy> {
    (uniform(0.1..5.0_f64), cube::<2>()).prop_map(|(eigenvalues, k)| {
        RotatingAnisotropy::new(eigenvalues, k * 3.0).expect("positive")
    })
}

fn lens() -> impl Strategy<Value = Lens> {
    (0.05..5.0_f64, 0.1..3.0_f64).prop_map(|(a, s)| Lens::new(a, s).expect("s > 0"))
}

#[test]
fn constants_of_scaled_hold() {
    hold(61, (shear(), 0.01..100.0_f64), |(g, s)| (Scaled::new(g, s).expect("positive"), 4.0));
}

#[test]
fn constants_of_sum_hold() {
    hold(62, (shear(), rotating()), |(g, h)| (Sum::new(g, h), 4.0));
}

#[test]
fn constants_of_product_hold() {
    let ramp = (-0.95..0.95_f64, 0.2..4.0_f64).prop_map(|(a, k)| Ramp::new(a, k).expect("|a| < 1"));
    let product = |(g, h)| (Product::<_, _, 2, 1>::new(g, h), 4.0);
    hold::<3, _, _>(63, (rotating(), ramp), product);
    let product = |(g, h)| (Product::<_, _, 3, 2>::new(g, h), 4.0);
    hold::<5, _, _>(64, (lens(), shear()), product);
}

#[test]
fn constants_of_affine_pullback_hold() {
    let map = || (uniform::<_, 4>(-2.0..2.0_f64), cube::<2>());
    let invertible = |(entries, _): &([f64; 4], SVector<f64, 2>)| {
        (entries[0] * entries[3] - entries[1] * entries[2]).abs() > 1e-3
    };
    let pull = |(g, (entries, shift)): (Shear, ([f64; 4], SVector<f64, 2>))| {
        let matrix = SMatrix::<f64, 2, 2>::from_column_slice(&entries);
        (AffinePullback::new(g, matrix, shift).expect("invertible"), 4.0)
    };
    hold(65, (shear(), map().prop_filter("invertible", invertible)), pull);
    let pull = |(g, (entries, shift)): (RotatingAnisotropy, ([f64; 4], SVector<f64, 2>))| {
        let matrix = SMatrix::<f64, 2, 2>::from_column_slice(&entries);
        (AffinePullback::new(g, matrix, shift).expect("invertible"), 4.0)
    };
    hold(66, (rotating(), map().prop_filter("invertible", invertible)), pull);
}

#[test]
fn constants_of_conformal_hold() {
    // C = 1 and A = 1 + B² + excess.
    let arm = (-2.0..2.0_f64, 0.01..2.0_f64)
        .prop_map(|(b, excess)| TwoLinkArm::new(1.0 + b * b + excess, b, 1.0).expect("definite"));
    hold(67, (lens(), arm), |(lens, arm)| (Conformal(lens, arm), 4.0));
}

/// All of them inside each other.
#[test]
fn constants_of_nested_compositions_hold() {
    hold::<3, _, _>(68, (shear(), rotating(), cube::<3>(), 0.1..2.0_f64), |(g, h, b, s)| {
        let sum = Sum::new(g, Scaled::new(h, s).expect("positive"));
        let ramp = Ramp::new(0.5, 1.0).expect("|a| < 1");
        // Diagonally dominant.
        let matrix = SMatrix::<f64, 3, 3>::from_fn(|i, j| if i == j { 3.0 } else { b[i] - b[j] });
        let product = Product::<_, _, 1, 2>::new(ramp, sum);
        (AffinePullback::new(product, matrix, b).expect("invertible"), 2.0)
    });
}
