//! Compares jets with closed forms, and with the automatic differentiation of `num-dual`, which
//! shares no code with ours.

use approx::assert_relative_eq;
use nalgebra::{SVector, vector};
use num_dual::{Dual2SVec64, DualNum, hessian};
use num_traits::Zero;
use proptest::prelude::*;
use tautline_scalar::{Jet1, Jet2, Scalar};

/// Compares functions with their first and second derivatives in closed form.
macro_rules! closed_forms {
    ($($name:ident, $at:expr, |$x:ident| $f:expr, $first:expr, $second:expr;)*) => {$(
        #[test]
        fn $name() {
            for $x in $at {
                let f = |$x: Jet2<f64, 1>| $f;
                let y = f(Jet2::variables(&[$x])[0]);
                let f = |$x: Jet1<f64, 1>| $f;
                let z = f(Jet1::variables(&[$x])[0]);
                let f = |$x: f64| $f;
                assert_eq!(y.value(), f($x), "value at {}", $x);
                assert_eq!(z.value(), f($x), "value at {}", $x);
                // Each side has a few roundings; 1e-13 is 400 ulps.
                assert_relative_eq!(y.first(0), $first, max_relative = 1e-13);
                assert_relative_eq!(z.first(0), $first, max_relative = 1e-13);
                assert_relative_eq!(y.second(0, 0), $second, max_relative = 1e-13);
            }
        }
    )*};
}

const REAL: [f64; 5] = [-2.3, -0.4, 0.1, 0.7, 1.9];
const POSITIVE: [f64; 4] = [0.03, 0.4, 1.7, 25.0];

closed_forms! {
    sqr, REAL, |x| x.sqr(), 2.0 * x, 2.0;
    recip, REAL, |x| x.recip(), -1.0 / (x * x), 2.0 / (x * x * x);
    cube, REAL, |x| x.powi(3), 3.0 * x * x, 6.0 * x;
    inverse_square, REAL, |x| x.powi(-2), -2.0 / (x * x * x), 6.0 / (x * x * x * x);
    sqrt, POSITIVE, |x| x.sqrt(), 0.5 / x.sqrt(), -0.25 / (x * x.sqrt());
    exp, REAL, |x| x.exp(), x.exp(), x.exp();
    ln, POSITIVE, |x| x.ln(), 1.0 / x, -1.0 / (x * x);
    sin, REAL, |x| x.sin(), x.cos(), -x.sin();
    cos, REAL, |x| x.cos(), -x.sin(), -x.cos();
    tan, REAL, |x| x.tan(), 1.0 / x.cos().powi(2), 2.0 * x.sin() / x.cos().powi(3);
    atan, REAL, |x| x.atan(), 1.0 / (1.0 + x * x), -2.0 * x / (1.0 + x * x).powi(2);
    sinh, REAL, |x| x.sinh(), x.cosh(), x.sinh();
    cosh, REAL, |x| x.cosh(), x.sinh(), x.cosh();
    tanh, REAL, |x| x.tanh(), x.cosh().powi(-2), -2.0 * x.sinh() / x.cosh().powi(3);
    with_numbers, REAL, |x| (x * 3.0 - 0.5) / 4.0 + 2.0, 0.75, 0.0;
    quotient, REAL, |x| (x + 5.0) / (x.sqr() + 1.0),
        (1.0 - 10.0 * x - x * x) / (1.0 + x * x).powi(2),
        2.0 * (x * x * x + 15.0 * x * x - 3.0 * x - 5.0) / (1.0 + x * x).powi(3);
}

/// A formula in three variables that uses every operation.
fn formula<S: Scalar>([x, y, z]: [S; 3]) -> S {
    let (s, c) = (x * y).sin_cos();
    let (sh, ch) = (z - x).sinh_cosh();
    let mut sum = (x.sqr() + y.sqr() * 2.0 + 0.5).ln() * c - (s / 3.0 + 2.0).sqrt();
    sum += (-(z.sqr()) - y).exp() / (ch + sh.tanh());
    sum -= (x * 0.3).tan() * z.powi(3) + (y + z).atan().powi(-2);
    sum *= (x - y + 4.0).recip() - 0.25;
    // Sums of jets with and without a second-order part, in either order.
    sum += (x - y * 2.0) / (z + 9.0) + x * z.sqr() - z.sqr() * y + x * y;
    sum -= (x * z) / (y + 7.0) + (x - 8.0) / (y.sqr() + 1.0) + (z.sqr() - y) - (y - z.sqr());
    let mut line = x * 2.0;
    line -= y * 0.7;
    line += y * z * 0.3 + z * 1.5;
    sum += line * 0.4;
    sum /= z.cosh();
    sum
}

/// The same formula, written again for `num-dual`.
fn formula_in_num_dual(v: SVector<Dual2SVec64<3>, 3>) -> Dual2SVec64<3> {
    let [x, y, z] = [v[0], v[1], v[2]];
    let mut sum =
        ((x * x + y * y * 2.0 + 0.5).ln()) * (x * y).cos() - ((x * y).sin() / 3.0 + 2.0).sqrt();
    sum += (-(z * z) - y).exp() / ((z - x).cosh() + (z - x).sinh().tanh());
    sum -= (x * 0.3).tan() * z * z * z + ((y + z).atan() * (y + z).atan()).recip();
    sum *= (x - y + 4.0).recip() - 0.25;
    sum += (x - y * 2.0) / (z + 9.0) + x * z * z - z * z * y + x * y;
    sum -= (x * z) / (y + 7.0) + (x - 8.0) / (y * y + 1.0) + (z * z - y) * 2.0;
    sum += (x * 2.0 - y * 0.7 + y * z * 0.3 + z * 1.5) * 0.4;
    sum /= z.cosh();
    sum
}

proptest! {
    #![proptest_config(tautline_chance::config(1, 256))]

    /// All first and second derivatives of a formula agree with `num-dual`.
    #[test]
    fn jets_agree_with_num_dual(x in -1.5..1.5_f64, y in 0.2..1.5_f64, z in 0.2..1.5_f64) {
        let ours = formula(Jet2::variables(&[x, y, z]));
        let first_order = formula(Jet1::variables(&[x, y, z]));
        let (value, gradient, second) = hessian(formula_in_num_dual, &vector![x, y, z]);
        // atan⁻² of an argument ≥ 0.4 and its second derivative are at most 300. About forty
        // roundings of relative size 1e-16 in numbers of that size stay below 1e-11.
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-11 * (1.0 + b.abs());
        prop_assert!(close(ours.value(), value));
        prop_assert_eq!(first_order.value(), ours.value());
        prop_assert_eq!(formula([x, y, z]), ours.value());
        for i in 0..3 {
            prop_assert!(close(ours.first(i), gradient[i]), "∂{i}: {} {}", ours.first(i), gradient[i]);
            prop_assert!(close(first_order.first(i), gradient[i]));
            for j in 0..3 {
                prop_assert!(close(ours.second(i, j), second[(i, j)]), "∂{i}∂{j}");
            }
        }
    }
}

/// Powers at zero have the derivatives of the polynomial, not `0 · ∞`.
#[test]
fn powers_at_zero_are_polynomials() {
    let [x] = Jet2::variables(&[0.0]);
    let expected = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 2.0), (0.0, 0.0, 0.0)];
    for (n, (value, first, second)) in expected.into_iter().enumerate() {
        let y = x.powi(i32::try_from(n).expect("a small exponent"));
        assert_eq!((y.value(), y.first(0), y.second(0, 0)), (value, first, second), "x^{n}");
    }
}

/// A jet with the value 0 and a nonzero derivative is not 0.
#[test]
fn jets_are_equal_if_value_and_derivatives_are() {
    let [x] = Jet2::<f64, 1>::variables(&[0.0]);
    let one = Jet2::constant(1.0);
    // 1 + x differs from 1 + 2x, 1 + x + x² and 2 + x.
    for other in [one + x * 2.0, one + x + x.sqr(), one + x + 1.0] {
        assert!(other != one + x && other == other * 1.0, "{other:?}");
    }
    assert!(!x.is_zero() && !x.sqr().is_zero() && (x - x).is_zero());
    let [x] = Jet1::<f64, 1>::variables(&[0.0]);
    assert!(!x.is_zero() && x != x * 2.0 && x == x * 1.0);
}

/// Where `tanh x` rounds to 1, `1 − tanh² x` would be rounding error.
#[test]
fn the_derivative_of_a_saturated_tanh_keeps_its_digits() {
    for x in [5.0_f64, 15.0, 25.0, -40.0] {
        let [jet] = Jet2::variables(&[x]);
        // The derivatives are 4 e^{−2|x|}/(1 + e^{−2|x|})², and this times −2 tanh x.
        let e = (-2.0 * x.abs()).exp();
        let slope = 4.0 * e / (1.0 + e).powi(2);
        assert_relative_eq!(jet.tanh().first(0), slope, max_relative = 1e-13);
        assert_relative_eq!(jet.tanh().second(0, 0), -2.0 * x.tanh() * slope, max_relative = 1e-13);
    }
}

/// Outside the domain of a function the value and all derivatives are NaN.
#[test]
fn outside_the_domain_is_nan() {
    let [x] = Jet2::variables(&[-1.0]);
    for y in [x.ln(), x.sqrt()] {
        assert!(y.value().is_nan() && y.first(0).is_nan() && y.second(0, 0).is_nan());
    }
}

/// A first-order jet over first-order jets contains second derivatives.
#[test]
fn jets_nest() {
    let [inner] = Jet1::variables(&[0.7_f64]);
    let [outer] = Jet1::<Jet1<f64, 1>, 1>::variables(&[inner]);
    let y = outer.sin() * outer.exp();
    // (sin x eˣ)'' = 2 cos x eˣ
    assert_relative_eq!(
        y.first(0).first(0),
        2.0 * 0.7_f64.cos() * 0.7_f64.exp(),
        max_relative = 1e-14
    );
}
