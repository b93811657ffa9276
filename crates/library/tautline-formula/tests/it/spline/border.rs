//! Outside of the array the nearest coefficient is repeated.

use tautline_chance::{Random, cases, seed};
use tautline_formula::spline::Spline;
use tautline_scalar::Interval;

use super::sampled::{all_orders, shape, spline};

const INFINITY: f64 = f64::INFINITY;

/// The function depends on `u` only through the nearest point with coordinates in `[−1, n]`.
#[test]
fn beyond_one_cell_outside_the_function_is_constant() {
    let mut random = Random(seed(8201));
    for axes in 1..=3 {
        for _ in 0..cases(100) {
            let spline = spline(&shape(axes, 1, 5, &mut random), &mut random);
            let mut inner = Vec::new();
            let mut outer = Vec::new();
            let mut beyond = Vec::new();
            for &n in spline.shape() {
                let n = n as f64;
                let (a, b, outside) = match random.bits() % 5 {
                    0 => (-1.0, -1.0 - random.with_exponent(-50, 60), true),
                    1 => (n, n + random.with_exponent(-50, 60), true),
                    2 => (-1.0, -INFINITY, true),
                    3 => (n, INFINITY, true),
                    _ => {
                        let u = random.between(-1.0, n);
                        (u, u, false)
                    }
                };
                inner.push(a);
                outer.push(b);
                beyond.push(outside);
            }
            for orders in all_orders(axes, 2) {
                assert_eq!(spline.value(&outer, orders), spline.value(&inner, orders), "{outer:?}");
            }
            for orders in all_orders(axes, 3) {
                if (0..axes).any(|axis| beyond[axis] && orders[axis] > 0) {
                    assert_eq!(spline.value(&outer, orders), 0.0, "{outer:?} {orders:?}");
                }
            }
            assert_eq!(spline.expansion(&outer).value, spline.expansion(&inner).value);
        }
    }
}

/// One cell outside, the function still changes: from `−1` to `0` it is
/// `c₀ + (c₁ − c₀) (1 + u)³ / 6`, and likewise at the other end.
#[test]
fn in_the_cell_outside_the_border_it_is_a_cubic() {
    let spline = Spline::new(&[3], vec![2.0, 8.0, -4.0]).expect("finite");
    for k in 0..=64 {
        let t = f64::from(k) / 64.0;
        // All numbers have few bits, except for the division by 6.
        let (below, above) = (spline.value(&[t - 1.0], [0; 3]), spline.value(&[3.0 - t], [0; 3]));
        assert!((below - (2.0 + t * t * t)).abs() <= 8.0 * 2.0_f64.powi(-47));
        assert!((above - (-4.0 + 2.0 * t * t * t)).abs() <= 8.0 * 2.0_f64.powi(-47));
    }
}

/// There is no slack in the enclosure of a constant.
#[test]
fn enclosures_beyond_the_border_are_exact() {
    let mut random = Random(seed(8202));
    let interval = |lo, hi| Interval::new(lo, hi).expect("ordered");
    for axes in 1..=3 {
        for _ in 0..cases(50) {
            let spline = spline(&shape(axes, 1, 5, &mut random), &mut random);
            let mut at = 0;
            let mut sides = Vec::new();
            for &n in spline.shape() {
                let (below, end) = (random.bits().is_multiple_of(2), n as f64);
                at = at * n + if below { 0 } else { n - 1 };
                sides.push(match (below, random.bits().is_multiple_of(2)) {
                    (true, true) => interval(-INFINITY, -1.0),
                    (true, false) => interval(-1.75, -1.25),
                    (false, true) => interval(end, INFINITY),
                    (false, false) => interval(end + 0.5, end + 7.0),
                });
            }
            let corner = spline.coefficients()[at];
            assert_eq!(spline.enclosure(&sides, [0; 3]), Interval::point(corner), "{sides:?}");
            for orders in all_orders(axes, 2).into_iter().skip(1) {
                assert_eq!(spline.enclosure(&sides, orders), Interval::point(0.0), "{sides:?}");
            }
            let away: Vec<Interval> = sides
                .iter()
                .map(|side| interval(side.lo() - 0.5, side.hi() + 0.5))
                .map(|side| if side.lo() < -1.0 { side - 1.0 } else { side + 1.0 })
                .collect();
            for orders in all_orders(axes, 3).into_iter().skip(1) {
                assert_eq!(spline.enclosure(&away, orders), Interval::point(0.0), "{away:?}");
            }
        }
    }
}
