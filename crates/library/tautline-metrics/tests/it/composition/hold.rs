//! The constants of compositions hold at random points, for random parts.

use nalgebra::{SMatrix, SVector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    Metric,
    composition::{AffinePullback, Product, Scaled, Sum},
    gallery::{Lens, Ramp, RotatingAnisotropy, Shear, TwoLinkArm},
};
use tautline_scalar::Scalar;

use super::conformal::Conformal;
use crate::laws::{constants_hold, cube};

/// A matrix that is not symmetric, `(3 1; x₁ 2)`.
struct Torn;

impl Metric<2> for Torn {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::<S, 2, 2>::new(S::constant(3.0), S::constant(1.0), x[0], S::constant(2.0))
    }
}

/// What is wrong with a part is seen in the composition: no half is made from the other one.
#[test]
fn compositions_keep_the_halves_of_a_matrix_apart() {
    let x = SVector::from([0.25, 0.5]);
    // [1, 2; 0, 1] takes x to (1.25, 0.5), and pulls (a, b; c, d) back to (a, 2a + b; 2a + c, …).
    let shear = SMatrix::<f64, 2, 2>::new(1.0, 2.0, 0.0, 1.0);
    let pulled = AffinePullback::new(Torn, shear, [0.0, 0.0]).expect("invertible").gram(&x);
    assert_eq!([pulled[(0, 1)], pulled[(1, 0)]], [7.0, 7.25]);
    let scaled = Scaled::new(Torn, 2.0).expect("positive").gram(&x);
    assert_eq!([scaled[(0, 1)], scaled[(1, 0)]], [2.0, 0.5]);
    let sum = Sum::new(Torn, Torn).gram(&x);
    assert_eq!([sum[(0, 1)], sum[(1, 0)]], [2.0, 0.5]);
    let product = Product::<_, _, 2, 1>::new(Torn, Ramp::new(0.5, 1.0).expect("|a| < 1"));
    let h = Metric::<3>::gram(&product, &SVector::from([0.25, 0.5, 0.0]));
    assert_eq!([h[(0, 1)], h[(1, 0)]], [1.0, 0.25]);
}

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

fn ramp() -> impl Strategy<Value = Ramp> {
    (-0.95..0.95_f64, 0.2..4.0_f64).prop_map(|(a, k)| Ramp::new(a, k).expect("|a| < 1"))
}

/// Draws an arm with C = 1 and A = 1 + B² + excess.
fn arm() -> impl Strategy<Value = TwoLinkArm> {
    (-2.0..2.0_f64, 0.01..2.0_f64)
        .prop_map(|(b, excess)| TwoLinkArm::new(1.0 + b * b + excess, b, 1.0).expect("definite"))
}

/// Draws the entries of an invertible map, and a shift.
fn map() -> impl Strategy<Value = ([f64; 4], SVector<f64, 2>)> {
    (uniform::<_, 4>(-2.0..2.0_f64), cube::<2>()).prop_filter("invertible", |(entries, _)| {
        (entries[0] * entries[3] - entries[1] * entries[2]).abs() > 1e-3
    })
}

fn pulled_back<M>(
    (metric, (entries, shift)): (M, ([f64; 4], SVector<f64, 2>)),
) -> (AffinePullback<M, 2>, f64) {
    let matrix = SMatrix::<f64, 2, 2>::from_column_slice(&entries);
    (AffinePullback::new(metric, matrix, shift).expect("invertible"), 4.0)
}

constants_hold! {
    constants_of_scaled_hold, 2, seed 61: (shear(), 0.01..100.0_f64), |(g, s)| {
        (Scaled::new(g, s).expect("positive"), 4.0)
    };
    constants_of_sum_hold, 2, seed 62: (shear(), rotating()), |(g, h)| (Sum::new(g, h), 4.0);
    constants_of_product_hold, 3, seed 63: (rotating(), ramp()), |(g, h)| {
        (Product::<_, _, 2, 1>::new(g, h), 4.0)
    };
    constants_of_product_hold_in_five_dimensions, 5, seed 64: (lens(), shear()), |(g, h)| {
        (Product::<_, _, 3, 2>::new(g, h), 4.0)
    };
    constants_of_affine_pullback_of_a_shear_hold, 2, seed 65: (shear(), map()), pulled_back;
    constants_of_affine_pullback_of_an_anisotropy_hold, 2, seed 66:
        (rotating(), map()), pulled_back;
    constants_of_conformal_hold, 2, seed 67: (lens(), arm()), |(lens, arm)| {
        (Conformal(lens, arm), 4.0)
    };
    // This composition nests all of them.
    constants_of_nested_compositions_hold, 3, seed 68:
        (shear(), rotating(), cube::<3>(), 0.1..2.0_f64), |(g, h, b, s)| {
            let sum = Sum::new(g, Scaled::new(h, s).expect("positive"));
            let ramp = Ramp::new(0.5, 1.0).expect("|a| < 1");
            // The matrix is diagonally dominant.
            let matrix =
                SMatrix::<f64, 3, 3>::from_fn(|i, j| if i == j { 3.0 } else { b[i] - b[j] });
            let product = Product::<_, _, 1, 2>::new(ramp, sum);
            (AffinePullback::new(product, matrix, b).expect("invertible"), 2.0)
        };
}
