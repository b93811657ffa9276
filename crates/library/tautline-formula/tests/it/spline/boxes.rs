//! A spline as a table: over which boxes a derivative has bounds.

use tautline_formula::spline::Spline;
use tautline_scalar::Table;

/// Sides in a cell of an axis of three coefficients, beyond its border or on nodes, and sides that
/// have a node inside.
const WITHIN: [(f64, f64); 6] =
    [(0.25, 0.75), (1.0, 2.0), (-1.0, 0.0), (2.0, 2.0), (f64::NEG_INFINITY, -1.0), (3.0, 9.0)];
const ACROSS: [(f64, f64); 5] =
    [(0.5, 1.5), (1.0, 2.5), (-1.5, -0.5), (2.5, 3.5), (f64::NEG_INFINITY, f64::INFINITY)];

fn cubes(axes: usize) -> Spline {
    let coefficients = (0..3_u32.pow(axes as u32)).map(|k| f64::from(k * k % 7)).collect();
    Spline::new(&vec![3; axes], coefficients).expect("a shape")
}

/// Third derivatives jump at nodes, and across a node the next derivative is no function. It is enough
/// that one side has a node inside.
#[test]
fn there_is_no_derivative_of_one_that_jumps() {
    for axes in 1..=3 {
        let spline = cubes(axes);
        for axis in 0..axes {
            for across in ACROSS {
                for within in WITHIN {
                    let mut sides = vec![within; axes];
                    sides[axis] = across;
                    let over = |orders| Table::bounds(&spline, &sides, orders);
                    let mut orders = [0; 3];
                    for order in 4..=6 {
                        orders[axis] = order;
                        assert_eq!(over(orders), None, "{sides:?} {orders:?}");
                    }
                    orders[axis] = 3;
                    assert!(over(orders).is_some(), "both values of a jump: {sides:?}");
                    if axes > 1 {
                        orders[(axis + 1) % axes] = 1;
                        assert_eq!(over(orders), None, "{sides:?} {orders:?}");
                    }
                }
            }
        }
    }
}

/// In a cell a spline is a polynomial of degree 3 in each argument.
#[test]
fn in_a_cell_every_derivative_has_bounds() {
    for axes in 1..=3 {
        let spline = cubes(axes);
        for within in WITHIN {
            let sides = vec![within; axes];
            for order in 4..=6 {
                let zero = Table::bounds(&spline, &sides, [order, 0, 0]);
                assert_eq!(zero, Some((0.0, 0.0)), "{sides:?} {order}");
            }
            if axes > 1 {
                for orders in [[3, 1, 0], [2, 2, 0], [3, 3, 0]] {
                    let (lo, hi) = Table::bounds(&spline, &sides, orders).expect("a polynomial");
                    let inside =
                        |(lo, hi): (f64, f64)| lo.max(-9.0) + 0.5 * (hi.min(9.0) - lo.max(-9.0));
                    let u = vec![inside(within); axes];
                    let value = Table::value(&spline, &u, orders);
                    // Twelve differences of numbers up to 6.
                    assert!(lo - 1e-10 <= value && value <= hi + 1e-10, "{u:?} {orders:?}");
                }
            }
        }
    }
}
