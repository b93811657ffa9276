//! A spline as a table, which formulas call.

use tautline_chance::{Random, cases, seed};
use tautline_formula::spline::Spline;
use tautline_scalar::Table;

use super::sampled::{all_orders, point, shape, sides, spline, total};

/// A table that is no spline, but claims the fingerprint of one.
#[derive(Debug)]
struct Imitation(u64);

impl Table for Imitation {
    fn axes(&self) -> usize {
        1
    }

    fn value(&self, _: &[f64], _: [u8; 3]) -> f64 {
        f64::NAN
    }

    fn bounds(&self, _: &[(f64, f64)], _: [u8; 3]) -> Option<(f64, f64)> {
        None
    }

    fn fingerprint(&self) -> u64 {
        self.0
    }

    fn is_same(&self, _: &dyn Table) -> bool {
        true
    }
}

/// A spline of this shape whose coefficients are fourth powers.
fn powers(shape: &[usize]) -> Spline {
    let count: usize = shape.iter().product();
    Spline::new(shape, (0..count).map(|i| ((i + 2) as f64).powi(4)).collect()).expect("finite")
}

#[test]
fn a_table_has_the_values_and_the_bounds_of_its_spline() {
    let mut random = Random(seed(8521));
    for axes in 1..=3 {
        for _ in 0..cases([40, 20, 5][axes - 1]) {
            let spline = spline(&shape(axes, 1, 6, &mut random), &mut random);
            let table: &dyn Table = &spline;
            assert_eq!((table.axes(), table.fingerprint()), (axes, spline.fingerprint()));
            for orders in all_orders(axes, 3).into_iter().filter(|&orders| total(orders) <= 3) {
                let u = point(spline.shape(), &mut random);
                assert_eq!(table.value(&u, orders), spline.value(&u, orders), "{u:?} {orders:?}");
                let sides = sides(spline.shape(), &mut random);
                let ends: Vec<(f64, f64)> = sides.iter().map(|x| (x.lo(), x.hi())).collect();
                let bounds = spline.enclosure(&sides, orders);
                let expected = Some((bounds.lo(), bounds.hi()));
                assert_eq!(table.bounds(&ends, orders), expected, "{ends:?} {orders:?}");
            }
        }
    }
}

/// The third derivatives jump at the nodes from −1 to `n`, the first ones at which the spline is not
/// constant on both sides. A box with a jump inside has no bounds on the fourth derivatives.
#[test]
fn fourth_derivatives_have_bounds_only_between_neighbouring_nodes() {
    let beyond = [f64::NEG_INFINITY, f64::INFINITY];
    for n in 1..=4_i32 {
        let halves = (-5..=2 * n + 4).map(|i| f64::from(i) / 2.0);
        let ends: Vec<f64> = halves.chain(beyond).collect();
        let (line, plane) = (powers(&[n as usize]), powers(&[n as usize, 3]));
        let pairs = ends.iter().flat_map(|&lo| ends.iter().map(move |&hi| (lo, hi)));
        for side @ (lo, hi) in
            pairs.filter(|(lo, hi)| lo <= hi && *lo < beyond[1] && *hi > beyond[0])
        {
            let jumps = (-1..=n).any(|node| lo < f64::from(node) && f64::from(node) < hi);
            let bounds = |table: &dyn Table, sides: &[(f64, f64)], orders: [u8; 3]| {
                table.bounds(sides, orders).is_some()
            };
            assert_eq!(bounds(&line, &[side], [4, 0, 0]), !jumps, "{n} {side:?}");
            assert!(bounds(&line, &[side], [3, 0, 0]), "{n} {side:?}");
            for orders in [[3, 1, 0], [2, 2, 0], [1, 3, 0]] {
                for (other, is_one_cell) in [((1.0, 2.0), true), ((0.5, 1.5), false)] {
                    let found = bounds(&plane, &[side, other], orders);
                    assert_eq!(found, !jumps && is_one_cell, "{n} {side:?} {other:?} {orders:?}");
                }
            }
        }
    }
}

#[test]
fn what_is_no_box_has_no_bounds() {
    let (line, plane) = (powers(&[4]), powers(&[4, 3]));
    let (line, plane): (&dyn Table, &dyn Table) = (&line, &plane);
    let good = (0.25, 0.5);
    assert!(line.bounds(&[good], [0; 3]).is_some() && plane.bounds(&[good; 2], [0; 3]).is_some());
    for wrong in [(0.5, 0.25), (f64::NAN, 0.5), (0.25, f64::NAN), (f64::NAN, f64::NAN)] {
        assert_eq!(line.bounds(&[wrong], [0; 3]), None, "{wrong:?}");
        assert_eq!(plane.bounds(&[wrong, good], [0; 3]), None, "{wrong:?}");
        assert_eq!(plane.bounds(&[good, wrong], [0; 3]), None, "{wrong:?}");
    }
    for (table, sides) in [(line, 0), (line, 2), (plane, 1), (plane, 3)] {
        assert_eq!(table.bounds(&vec![good; sides], [0; 3]), None, "{sides} sides");
    }
}

#[test]
fn a_table_is_the_same_only_as_an_equal_spline() {
    let (one, equal, other) = (powers(&[4]), powers(&[4]), powers(&[2, 2]));
    assert!(one.is_same(&one) && one.is_same(&equal));
    assert!(!one.is_same(&other) && !other.is_same(&one));
    assert!(!one.is_same(&Imitation(one.fingerprint())));
}
