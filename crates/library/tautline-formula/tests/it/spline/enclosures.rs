//! Enclosures over boxes contain what they should.

use tautline_chance::{Random, cases, seed};
use tautline_formula::spline::Spline;
use tautline_scalar::{FastInterval, Interval};

use super::{
    exact::Exact,
    sampled::{all_orders, inside, point, shape, side, sides, spline, total},
};

#[test]
fn enclosures_contain_the_values_at_all_points_of_a_box() {
    let mut random = Random(seed(8501));
    for axes in 1..=3 {
        for _ in 0..cases([150, 60, 12][axes - 1]) {
            let spline = spline(&shape(axes, 1, 7, &mut random), &mut random);
            for orders in all_orders(axes, 3) {
                let sides = sides(spline.shape(), &mut random);
                let bounds = spline.enclosure(&sides, orders);
                assert!(bounds.is_finite());
                for _ in 0..4 {
                    let u: Vec<f64> = sides.iter().map(|&x| inside(x, &mut random)).collect();
                    // At nodes third derivatives have two values.
                    let jumps = orders.contains(&3);
                    for below in [false, true].into_iter().take(1 + usize::from(jumps)) {
                        let exact = Exact::new(&spline, &u, orders, below);
                        assert!(
                            exact.is_in(bounds),
                            "{spline:?} {orders:?}: {bounds:?} over {sides:?} misses that at {u:?}"
                        );
                    }
                }
            }
        }
    }
}

/// At a single point nothing but the bound on rounding makes room for the value, and values at
/// random points come near to every wrong bound.
#[test]
fn enclosures_contain_the_value_at_a_point() {
    let mut random = Random(seed(8502));
    for axes in 1..=3 {
        for _ in 0..cases([2000, 400, 50][axes - 1]) {
            let spline = spline(&shape(axes, 1, 5, &mut random), &mut random);
            let orders = [(); 3].map(|()| (random.bits() % 4) as u8);
            let orders = std::array::from_fn(|axis| if axis < axes { orders[axis] } else { 0 });
            let u = point(spline.shape(), &mut random);
            let here: Vec<Interval> = u.iter().map(|&u| Interval::point(u)).collect();
            let bounds = spline.enclosure(&here, orders);
            assert!(Exact::new(&spline, &u, orders, false).is_in(bounds), "{bounds:?} at {u:?}");
        }
    }
}

/// Products of weights and coefficients near the smallest double underflow.
#[test]
fn enclosures_hold_for_subnormal_coefficients() {
    let mut random = Random(seed(8503));
    for _ in 0..cases(500) {
        let size = random.with_exponent(-1074, -1000);
        let coefficients = (0..16).map(|_| size * random.between(-1.0, 1.0)).collect();
        let spline = Spline::new(&[4, 4], coefficients).expect("finite");
        let sides = [(); 2].map(|()| side(4, &mut random));
        let u = sides.map(|side| inside(side, &mut random));
        for orders in all_orders(2, 2) {
            let bounds = spline.enclosure(&sides, orders);
            assert!(Exact::new(&spline, &u, orders, false).is_in(bounds), "{bounds:?} at {u:?}");
        }
    }
}

/// Half of the smallest double rounds to 0, on each axis. The mixed second differences are 1 in
/// units of it, but one, which is 3. Their mean is 1.25, and it is computed as 0.
#[test]
fn enclosures_hold_where_products_underflow_on_three_axes() {
    let unit = f64::from_bits(1);
    let second_sum = |k: usize| [0.0, 0.0, 1.0, 3.0][k];
    let mut units: Vec<f64> =
        (0..64).map(|k| second_sum(k / 16) * second_sum(k / 4 % 4) * second_sum(k % 4)).collect();
    units[63] += 2.0;
    let spline = Spline::new(&[4; 3], units.iter().map(|k| k * unit).collect()).expect("finite");
    let bounds = spline.enclosure(&[Interval::point(1.5); 3], [2; 3]);
    assert!(bounds.lo() <= unit && 2.0 * unit <= bounds.hi(), "{bounds:?}");
}

/// Coefficients `a + k`, rounded: first differences are 1 and are rounded, second differences are
/// rounding errors themselves.
#[test]
fn enclosures_know_of_the_rounding_of_differences() {
    let mut random = Random(seed(8505));
    for axes in 1..=2 {
        for _ in 0..cases(200) {
            let shape = vec![6; axes];
            let a = random.with_exponent(-8, -1);
            let coefficient = |k: usize| (a + (k % 6) as f64) * (a + (k / 6) as f64);
            let numbers = (0..shape.iter().product()).map(coefficient).collect();
            let spline = Spline::new(&shape, numbers).expect("finite");
            let u: Vec<f64> = shape.iter().map(|_| random.between(1.0, 4.0)).collect();
            let here: Vec<Interval> = u.iter().map(|&u| Interval::point(u)).collect();
            for orders in all_orders(axes, 3) {
                let bounds = spline.enclosure(&here, orders);
                assert!(Exact::new(&spline, &u, orders, false).is_in(bounds), "{bounds:?}");
            }
        }
    }
}

/// A part of a box has a narrower enclosure, up to the rounding of both: at most `2ᵃ⁻⁴⁶` times the
/// largest coefficient, for orders with the sum `a`.
#[test]
fn enclosures_are_isotone_up_to_rounding() {
    let mut random = Random(seed(8504));
    for axes in 1..=3 {
        for _ in 0..cases([300, 60, 20][axes - 1]) {
            let spline = spline(&shape(axes, 1, 12, &mut random), &mut random);
            let largest = spline.coefficients().iter().fold(0.0_f64, |m, c| m.max(c.abs()));
            for orders in all_orders(axes, 3) {
                let outer = sides(spline.shape(), &mut random);
                let part = |&x: &Interval| {
                    let (a, b) = (inside(x, &mut random), inside(x, &mut random));
                    Interval::new(a.min(b), a.max(b)).expect("ordered")
                };
                let inner: Vec<Interval> = outer.iter().map(part).collect();
                let slack = 2.0_f64.powi(total(orders) - 46) * largest;
                let (a, b) = (spline.enclosure(&inner, orders), spline.enclosure(&outer, orders));
                assert!(
                    b.lo() - slack <= a.lo() && a.hi() <= b.hi() + slack,
                    "{orders:?}: {a:?} over {inner:?}, {b:?} over {outer:?}"
                );
            }
        }
    }
}

/// The third derivative of a hill is `1, −3, 3, −1` on four cells.
#[test]
fn third_derivatives_have_both_values_at_a_node() {
    let hill = Spline::new(&[7], vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).expect("finite");
    let over = |lo, hi| {
        let x = hill.enclosure(&[Interval::new(lo, hi).expect("ordered")], [3, 0, 0]);
        (x.lo(), x.hi())
    };
    assert_eq!(over(2.0, 2.0), (-3.0, 1.0));
    assert_eq!(over(3.0, 3.0), (-3.0, 3.0));
    assert_eq!(over(2.5, 3.0), (-3.0, 3.0));
    assert_eq!(over(3.0, 3.5), (-3.0, 3.0));
    assert_eq!(over(3.0_f64.next_up(), 4.0_f64.next_down()), (3.0, 3.0));
    assert_eq!(over(1.0, 1.5), (0.0, 1.0));
    assert_eq!(over(f64::NEG_INFINITY, 1.0_f64.next_down()), (0.0, 0.0));
    // At the border of an array, the values are those of the cell outside and of that beyond.
    let ramp = Spline::new(&[2], vec![0.0, 6.0]).expect("finite");
    for (at, expected) in [(-1.0, (0.0, 6.0)), (0.0, (-12.0, 6.0)), (2.0, (0.0, 6.0))] {
        let x = ramp.enclosure(&[Interval::point(at)], [3, 0, 0]);
        assert_eq!((x.lo(), x.hi()), expected, "at {at}");
    }
}

#[test]
fn enclosures_are_undefined_where_a_side_is() {
    let spline = Spline::new(&[2, 2], vec![1.0, 2.0, 3.0, 5.0]).expect("finite");
    let (unit, nothing) = (Interval::new(0.0, 1.0).expect("ordered"), Interval::UNDEFINED);
    for orders in [[0; 3], [1, 0, 0], [3, 3, 0], [4, 0, 0], [0, 0, 1]] {
        for sides in [&[unit, nothing][..], &[nothing, unit], &[unit], &[unit; 3], &[]] {
            assert!(spline.enclosure(sides, orders).is_undefined(), "{sides:?} {orders:?}");
        }
    }
    for orders in [[4, 0, 0], [0, 255, 0], [0, 0, 1], [1, 1, 1]] {
        assert_eq!(spline.enclosure(&[unit; 2], orders), Interval::point(0.0));
        assert_eq!(spline.range(orders), Interval::point(0.0));
    }
    // Both kinds of intervals have the same ends.
    let fast: FastInterval = spline.enclosure(&[unit.with_kernel(); 2], [1, 0, 0]);
    assert_eq!(fast.with_kernel(), spline.enclosure(&[unit; 2], [1, 0, 0]));
}

#[test]
fn enclosures_of_an_expansion_are_those_of_its_parts() {
    let mut random = Random(seed(8506));
    for axes in 1..=3 {
        let spline = spline(&shape(axes, 2, 7, &mut random), &mut random);
        let sides: Vec<Interval> = spline.shape().iter().map(|&n| side(n, &mut random)).collect();
        let all = spline.enclosures(&sides);
        assert_eq!(all.value, spline.enclosure(&sides, [0; 3]));
        for i in 0..3 {
            let mut orders = [0; 3];
            orders[i] = 1;
            assert_eq!(all.gradient[i], spline.enclosure(&sides, orders));
            for j in 0..3 {
                let mut both = orders;
                both[j] += 1;
                assert_eq!(all.hessian[i][j], spline.enclosure(&sides, both));
            }
        }
        assert!(spline.enclosures::<tautline_scalar::Rigorous>(&[]).hessian[0][0].is_undefined());
    }
}
