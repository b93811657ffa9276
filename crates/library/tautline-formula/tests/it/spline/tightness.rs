//! How much enclosures exceed the true range.

use tautline_chance::{Random, cases, seed};
use tautline_formula::spline::Spline;
use tautline_scalar::Interval;

use super::sampled::{all_orders, shape, spline, total};

/// Returns by how much the enclosure over a square is wider than the range of 33 × 33 values in it.
fn excess(spline: &Spline, [x, y]: [f64; 2], width: f64, orders: [u8; 3]) -> f64 {
    let side = |lo| Interval::new(lo, lo + width).expect("ordered");
    let bounds = spline.enclosure(&[side(x), side(y)], orders);
    let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
    for k in 0..33 * 33 {
        let part = |k: usize| k as f64 / 32.0 * width;
        let value = spline.value(&[x + part(k / 33), y + part(k % 33)], orders);
        lo = lo.min(value);
        hi = hi.max(value);
    }
    (bounds.hi() - bounds.lo()) - (hi - lo)
}

/// Squares that shrink towards an extremum inside a cell, of value and slopes: the
/// worst case, since elsewhere a small square has its extremes at corners, where enclosures are
/// exact.
#[test]
fn the_excess_falls_with_the_square_of_the_width() {
    let wave = |k: usize| {
        let (x, y) = ((k / 16) as f64, (k % 16) as f64);
        (0.7 * x + 0.3).cos() * (0.9 * y).sin() + 0.5 * (0.4 * x * y).sin()
    };
    let spline = Spline::new(&[16, 16], (0..256).map(wave).collect()).expect("finite");
    for orders in [[0; 3], [1, 0, 0], [0, 1, 0]] {
        // Newton's method for a stationary point near to some start.
        let gradient = |u: &[f64; 2]| {
            let d = |i: usize, j: usize| {
                let mut all = orders;
                all[0] += i as u8;
                all[1] += j as u8;
                spline.value(u, all)
            };
            (d(1, 0), d(0, 1), d(2, 0), d(1, 1), d(0, 2))
        };
        let mut found = 0;
        for start in 0..196 {
            let mut u = [1.5 + (start / 14) as f64, 1.5 + (start % 14) as f64];
            let cell = u.map(f64::floor);
            for _ in 0..30 {
                let (a, b, aa, ab, bb) = gradient(&u);
                let determinant = aa * bb - ab * ab;
                u[0] -= (a * bb - b * ab) / determinant;
                u[1] -= (b * aa - a * ab) / determinant;
            }
            let inside = |axis: usize| (0.1..0.7).contains(&(u[axis] - cell[axis]));
            let (a, b, aa, ab, bb) = gradient(&u);
            // At a saddle point the extremes may be at corners.
            if !(inside(0) && inside(1) && a.abs() + b.abs() < 1e-12 && aa * bb > ab * ab) {
                continue;
            }
            found += 1;
            // The point is at a third of each side, so that no symmetry helps.
            let at = |width: f64| excess(&spline, u.map(|u| u - width / 3.0), width, orders);
            let (wide, narrow) = (at(2.0_f64.powi(-3)), at(2.0_f64.powi(-9)));
            let order = (wide / narrow).log2() / 6.0;
            println!("orders {orders:?}, near {u:?}: the excess is of order {order:.3}");
            assert!(order >= 1.9, "order {order} at {u:?}: {wide:e}, {narrow:e}");
        }
        assert!(found >= 3, "only {found} stationary points");
    }
}

/// In a square of width `w` in one cell, Bernstein coefficients differ from values by at most
/// `w²/18 · (|f₁₁| + 2 |f₁₂| + |f₂₂|)`, and by less for lower degrees; each of these is at most 4
/// times the largest coefficient, times `2ᵃ` for orders with the sum `a`. Sampling misses at most
/// `(w/32)²/4` of the same.
#[test]
fn the_excess_over_one_cell_is_bounded_by_second_derivatives() {
    let mut random = Random(seed(8601));
    for _ in 0..cases(60) {
        let spline = spline(&shape(2, 3, 8, &mut random), &mut random);
        let largest = spline.coefficients().iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        for orders in all_orders(2, 3) {
            let width = random.with_exponent(-12, -2);
            let corner = [0, 1].map(|axis: usize| {
                let cell = (random.bits() % spline.shape()[axis] as u64) as f64;
                // Third derivatives jump at nodes, so neither end is one.
                cell + random.between(0.01, 0.99 - width)
            });
            let scale = 2.0_f64.powi(total(orders)) * largest;
            let curvature = 2.0 * 16.0 * scale * (1.0 / 18.0 + 1.0 / 4096.0);
            let bound = width * width * curvature + 2.0_f64.powi(-44) * scale;
            let found = excess(&spline, corner, width, orders);
            assert!(found <= bound, "{orders:?} {width:e}: {found:e} > {bound:e}");
        }
    }
}

/// At a point, the bound on rounding is `(13 E + 2) u` on both sides, with `u = 2⁻⁵³`, and the ends
/// are moved by one double: less than `2⁻⁴⁶` times the largest coefficient. Differences of small
/// integers are exact.
#[test]
fn at_a_point_an_enclosure_is_some_roundings_wide() {
    let mut random = Random(seed(8602));
    for axes in 1..=3 {
        for _ in 0..cases(200) {
            let shape = shape(axes, 2, 5, &mut random);
            let coefficients = (0..shape.iter().product()).map(|_| (random.bits() % 256) as f64);
            let spline = Spline::new(&shape, coefficients.collect()).expect("finite");
            let u: Vec<Interval> =
                shape.iter().map(|&n| Interval::point(random.between(-1.0, n as f64))).collect();
            for orders in all_orders(axes, 3) {
                let width = spline.enclosure(&u, orders).width();
                let differences: Interval = spline.range(orders);
                let bound = 2.0_f64.powi(-46) * differences.magnitude();
                assert!(width <= bound, "{orders:?} at {u:?}: {width:e} > {bound:e}");
            }
        }
    }
}
