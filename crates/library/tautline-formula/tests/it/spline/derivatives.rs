//! Values and derivatives at points.

use tautline_chance::{Random, cases, seed};
use tautline_formula::spline::Spline;

use super::{
    exact::Exact,
    sampled::{all_orders, point, shape, spline, total},
};

/// The documented bound on the rounding error of a derivative.
fn rounding(orders: [u8; 3], largest: f64) -> f64 {
    2.0_f64.powi(total(orders) - 47) * largest
}

#[test]
fn derivatives_are_those_of_the_exact_polynomials() {
    let mut random = Random(seed(8101));
    for axes in 1..=3 {
        for _ in 0..cases(60 / axes as u32) {
            let spline = spline(&shape(axes, 1, 6, &mut random), &mut random);
            for orders in all_orders(axes, 3) {
                let u = point(spline.shape(), &mut random);
                let (value, exact) =
                    (spline.value(&u, orders), Exact::new(&spline, &u, orders, false));
                let tolerance = rounding(orders, exact.largest);
                assert!(exact.is_near(value, tolerance), "{spline:?} {u:?} {orders:?}: {value}");
            }
        }
    }
}

#[test]
fn an_expansion_has_the_same_derivatives() {
    let mut random = Random(seed(8102));
    for axes in 1..=3 {
        for _ in 0..cases(100) {
            let spline = spline(&shape(axes, 1, 6, &mut random), &mut random);
            let u = point(spline.shape(), &mut random);
            let all = spline.expansion(&u);
            let near = |found: f64, orders: [u8; 3]| {
                // An expansion divides weights by 6, not sums, so it has one more rounding on each
                // axis; the bound has room for them.
                let exact = Exact::new(&spline, &u, orders, false);
                let tolerance = rounding(orders, exact.largest);
                assert!(exact.is_near(found, tolerance), "{spline:?} {u:?} {orders:?}: {found}");
            };
            near(all.value, [0; 3]);
            for i in 0..axes {
                let mut orders = [0; 3];
                orders[i] = 1;
                near(all.gradient[i], orders);
                for j in 0..axes {
                    let mut both = orders;
                    both[j] += 1;
                    near(all.hessian[i][j], both);
                }
            }
            for i in axes..3 {
                assert_eq!(
                    (all.gradient[i], all.hessian[i], all.hessian[0][i]),
                    (0.0, [0.0; 3], 0.0)
                );
            }
        }
    }
}

/// The central difference of `g` is the mean of `g′` over `[u − h, u + h]`. It differs from `g′(u)`
/// by at most `h/2` times the largest `|g″|`, which is at most `2ᵃ⁺²` times the largest coefficient,
/// for derivatives `g` of orders with the sum `a`.
#[test]
fn derivatives_are_limits_of_divided_differences() {
    let mut random = Random(seed(8103));
    let h = 2.0_f64.powi(-13);
    for axes in 1..=3 {
        for _ in 0..cases(100) {
            let spline = spline(&shape(axes, 1, 6, &mut random), &mut random);
            let largest = spline.coefficients().iter().fold(0.0_f64, |m, c| m.max(c.abs()));
            for orders in all_orders(axes, 1) {
                let u: Vec<f64> =
                    spline.shape().iter().map(|&n| random.between(-2.0, n as f64 + 1.0)).collect();
                for axis in 0..axes {
                    let shifted = |by: f64| {
                        let mut u = u.clone();
                        u[axis] += by;
                        (u[axis], spline.value(&u, orders))
                    };
                    let ((from, low), (to, high)) = (shifted(-h), shifted(h));
                    let mut next = orders;
                    next[axis] += 1;
                    let slope = spline.value(&u, next);
                    let bound = 2.0_f64.powi(total(orders) + 2) * largest;
                    // The points are rounded, which moves the middle by at most 2⁻⁵⁰.
                    let tolerance = (0.5 * h + 2.0_f64.powi(-50)) * bound
                        + 2.0 * rounding(orders, largest) / (to - from)
                        + rounding(next, largest);
                    let quotient = (high - low) / (to - from);
                    assert!((quotient - slope).abs() <= tolerance, "{quotient} {slope}");
                }
            }
        }
    }
}

/// Across a node, from one double to the next, a derivative up to the second order changes by at
/// most the distance of these times the next derivative. That holds at the border as well.
#[test]
fn second_derivatives_are_continuous_across_nodes_and_at_the_border() {
    let mut random = Random(seed(8104));
    for axes in 1..=3 {
        for _ in 0..cases(30) {
            let spline = spline(&shape(axes, 1, 5, &mut random), &mut random);
            let largest = spline.coefficients().iter().fold(0.0_f64, |m, c| m.max(c.abs()));
            for orders in all_orders(axes, 2) {
                let mut u = point(spline.shape(), &mut random);
                for axis in 0..axes {
                    for node in -2..=spline.shape()[axis] as i32 + 1 {
                        let at = f64::from(node);
                        u[axis] = at;
                        let above = spline.value(&u, orders);
                        u[axis] = at.next_down();
                        let below = spline.value(&u, orders);
                        let change =
                            (at - at.next_down()) * 2.0_f64.powi(total(orders) + 1) * largest;
                        let tolerance = change + 2.0 * rounding(orders, largest);
                        assert!((above - below).abs() <= tolerance, "{below} {above} at {node}");
                    }
                }
            }
        }
    }
}

/// The third derivative of a single coefficient 1 is `1, −3, 3, −1` on the four cells around it.
#[test]
fn third_derivatives_at_a_node_are_those_of_the_cell_above() {
    let hill = Spline::new(&[7], vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).expect("finite");
    for (node, expected) in
        [(0.0, 0.0), (1.0, 1.0), (2.0, -3.0), (3.0, 3.0), (4.0, -1.0), (5.0, 0.0)]
    {
        assert_eq!(hill.value(&[node], [3, 0, 0]), expected);
        assert_eq!(hill.value(&[f64::next_up(node)], [3, 0, 0]), expected);
        let below = hill.value(&[f64::next_down(node) - 0.5], [3, 0, 0]);
        assert_eq!(below, hill.value(&[node - 1.0], [3, 0, 0]));
    }
}

#[test]
fn derivatives_beyond_the_third_and_along_absent_axes_are_zero() {
    let spline = Spline::new(&[2, 2], vec![1.0, 2.0, 3.0, 5.0]).expect("finite");
    for orders in [[4, 0, 0], [0, 255, 0], [0, 0, 1], [1, 1, 3]] {
        assert_eq!(spline.value(&[0.5, 0.5], orders), 0.0);
    }
    // The mixed difference is 5 − 2 − 3 + 1 = 1, and 1/2 of the cell's square weights are its.
    assert!(spline.value(&[0.5, 0.5], [1, 1, 0]) > 0.5);
}

/// Coefficients of the largest size, and coordinates of every kind.
#[test]
fn no_float_panics_and_only_nan_gives_nan() {
    let special = [
        f64::NEG_INFINITY,
        -f64::MAX,
        -1e19,
        -2.0,
        -1.0,
        -f64::EPSILON,
        -5e-324,
        -0.0,
        0.0,
        5e-324,
        1.0_f64.next_down(),
        1.0,
        2.0,
        1e19,
        f64::MAX,
        f64::INFINITY,
    ];
    let large = 2.0_f64.powi(1000);
    for axes in 1..=3 {
        let coefficients =
            (0..2_usize.pow(axes)).map(|k| if k.count_ones() % 2 == 0 { large } else { -large });
        let spline = Spline::new(&vec![2; axes as usize], coefficients.collect()).expect("finite");
        for orders in all_orders(axes as usize, 4) {
            for k in 0..special.len().pow(axes) {
                let u: Vec<f64> = (0..axes)
                    .map(|axis| special[k / special.len().pow(axis) % special.len()])
                    .collect();
                assert!(spline.value(&u, orders).is_finite(), "{u:?} {orders:?}");
                assert!(spline.expansion(&u).hessian[0][0].is_finite());
            }
            let mut u = vec![0.5; axes as usize];
            assert!(spline.value(&[], orders).is_nan() && spline.value(&[0.0; 4], orders).is_nan());
            u[axes as usize - 1] = f64::NAN;
            assert!(spline.value(&u, orders).is_nan());
            assert!(spline.expansion(&u).value.is_nan() && spline.expansion(&[]).value.is_nan());
        }
    }
}
