//! Jets over intervals: bounds on the derivatives of a formula over a box.

use astro_float::{BigFloat, RoundingMode};
use tautline_chance::{cases, seed};
use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

use crate::{
    ends, interval,
    reference::{FAMILIES, Random, Reference, holds},
};

const P: usize = 320;
const RM: RoundingMode = RoundingMode::None;

/// A formula in two variables that uses most operations.
fn formula<S: Scalar>([x, y]: [S; 2]) -> S {
    let (s, c) = (x * y).sin_cos();
    ((-x.sqr()).exp() * c + (y.sqr() + 1.5).ln().sqrt() * s) / (x.cosh() + y.atan().tanh() + 1.5)
        + (x * 0.25).tan() * (y + 3.0).powi(-2)
        + (x.sinh() * 0.1 + y).powi(3)
}

/// `q = (x + 2)²/(1 + x²)` with its first two derivatives, in high precision.
fn rational(x: f64) -> [BigFloat; 3] {
    let big = Reference::big;
    let (mul, add) = (
        |a: &BigFloat, b: &BigFloat| a.mul(b, P, RM),
        |a: &BigFloat, b: &BigFloat| a.add(b, P, RM),
    );
    let x = big(x);
    // q = n/d: q' = (n' − q d')/d, q'' = (n'' − 2 q' d' − q d'')/d.
    let (root, d) = (add(&x, &big(2.0)), add(&big(1.0), &mul(&x, &x)));
    let q = mul(&root, &root).div(&d, P, RM);
    let (n1, d1) = (mul(&big(2.0), &root), mul(&big(2.0), &x));
    let q1 = n1.sub(&mul(&q, &d1), P, RM).div(&d, P, RM);
    let rest = add(&mul(&mul(&big(2.0), &q1), &d1), &mul(&big(2.0), &q));
    let q2 = big(2.0).sub(&rest, P, RM).div(&d, P, RM);
    [q, q1, q2]
}

#[test]
fn jets_enclose_derivatives_known_in_high_precision() {
    let mut random = Random(seed(7));
    let mut reference = Reference::new();
    for _ in 0..cases(2000) {
        let (a, b) = (random.between(-3.0, 3.0), random.between(-3.0, 3.0));
        let exp = &reference.values(FAMILIES[0], b)[0];
        let [q, q1, q2] = rational(a).map(|part| part.mul(exp, P, RM));
        for spread in [0.0, 1e-3, 0.5] {
            let x = interval(a - spread, a + spread);
            let [x, y] = Jet2::variables(&[x, interval(b - spread, b + spread)]);
            let z = (x + 2.0).sqr() * y.exp() / (x.sqr() + 1.0);
            assert!(holds(z.value(), &q) && holds(z.first(0), &q1) && holds(z.first(1), &q));
            assert!(holds(z.second(0, 0), &q2) && holds(z.second(0, 1), &q1));
            assert!(holds(z.second(1, 1), &q));
            if spread == 0.0 {
                // There are a dozen operations of one or two ulps each, with cancellation in q''.
                assert!(z.second(0, 0).width() < 1e-11, "{z:?}");
            }
        }
    }
}

#[test]
fn jets_at_points_meet_jets_over_boxes() {
    let mut random = Random(seed(8));
    for _ in 0..cases(2000) {
        let centre = [random.between(-1.5, 1.5), random.between(-1.5, 1.5)];
        let size = random.with_exponent(-20, -3);
        let over = centre.map(|c| interval(c - size, c + size));
        let (first, second) = (formula(Jet1::variables(&over)), formula(Jet2::variables(&over)));
        for _ in 0..5 {
            let p = centre.map(|c| random.between(c - size, c + size));
            let at = formula(Jet2::variables(&p.map(Interval::point)));
            let meets = |x: Interval, y: Interval| x.intersection(y).is_some() && y.is_finite();
            // The tolerance is hundreds of ulps of the largest intermediate value, about 10.
            let near = |x: Interval, y: f64| (x.midpoint() - y).abs() < 1e-11;
            let plain = formula(Jet2::variables(&p));
            assert!(meets(second.value(), at.value()) && near(at.value(), plain.value()));
            for i in 0..2 {
                assert!(meets(second.first(i), at.first(i)) && meets(first.first(i), at.first(i)));
                assert!(near(at.first(i), plain.first(i)));
                for j in 0..2 {
                    assert!(meets(second.second(i, j), at.second(i, j)));
                    assert!(near(at.second(i, j), plain.second(i, j)));
                }
            }
        }
    }
}

#[test]
fn jets_of_the_undefined_are_undefined() {
    let [x] = Jet2::variables(&[interval(-1.0, 1.0)]);
    for y in [x.recip(), x.ln(), x.sqrt(), x.powi(-1), x.powi(-1).powi(0), (x * 2.0).tan()] {
        assert!(y.value().is_undefined() && y.first(0).is_undefined());
        assert!(y.second(0, 0).is_undefined());
    }
    // At zero the root is defined, but its slope is not.
    let [x] = Jet1::variables(&[interval(0.0, 1.0)]);
    assert!(x.sqrt().value().is_finite() && x.sqrt().first(0).is_undefined());
    // x⁰ is 1 at zero, with slope 0.
    assert_eq!((ends(x.powi(0).value()), ends(x.powi(0).first(0))), ((1.0, 1.0), (0.0, 0.0)));
}

#[test]
fn second_derivatives_square_the_slopes() {
    // The second derivative of (x²)² is 12 x². Computed as 2 (2x)² + 2 x² · 2, it is never
    // negative.
    let [x] = Jet2::variables(&[interval(-1.0, 1.0)]);
    assert_eq!(ends(x.sqr().sqr().second(0, 0)), (0.0, 12.0));
}
