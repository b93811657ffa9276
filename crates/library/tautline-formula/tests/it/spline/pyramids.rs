//! The range over many cells, compared with brute force.

use tautline_chance::{Random, cases, seed};
use tautline_formula::spline::Spline;
use tautline_scalar::Interval;

use super::sampled::{all_orders, inside, shape};

/// Returns the difference number `number` of these orders, where coefficients beyond the array are
/// those at its border.
fn difference(spline: &Spline, number: &[i64], orders: &[u8]) -> Interval {
    let Some(axis) = orders.iter().position(|&order| order > 0) else {
        let at = number
            .iter()
            .zip(spline.shape())
            .fold(0, |at, (&k, &n)| at * n + k.clamp(0, n as i64 - 1) as usize);
        return Interval::point(spline.coefficients()[at]);
    };
    let mut lower = orders.to_vec();
    lower[axis] -= 1;
    let mut next = number.to_vec();
    next[axis] += 1;
    difference(spline, &next, &lower) - difference(spline, number, &lower)
}

/// Returns the hull of the differences that meet the cells of a box, which is finite.
fn brute_force(spline: &Spline, sides: &[Interval], orders: [u8; 3]) -> Interval {
    let cells = |axis: usize| {
        let side = sides[axis];
        if orders[axis] == 3 {
            (side.lo().ceil() as i64 - 1, side.hi().floor() as i64)
        } else {
            (side.lo().floor() as i64, side.hi().ceil() as i64 - 1)
        }
    };
    let mut numbers = vec![Vec::new()];
    for axis in 0..sides.len() {
        let (first, last) = cells(axis);
        let last = last.max(first) + 2 - i64::from(orders[axis]);
        let longer = |number: &Vec<i64>| {
            let number = number.clone();
            (first - 1..=last).map(move |k| [&number[..], &[k]].concat()).collect::<Vec<_>>()
        };
        numbers = numbers.iter().flat_map(longer).collect();
    }
    let own = &orders[..sides.len()];
    let all = numbers.iter().map(|number| difference(spline, number, own));
    all.reduce(Interval::hull).expect("a box has cells")
}

/// Returns how many cells lie in a box, without those where the spline is constant.
fn cells(sides: &[Interval], shape: &[usize]) -> f64 {
    let cells = |(side, &n): (&Interval, &usize)| {
        (side.hi().floor().min(n as f64) - side.lo().ceil().max(-1.0)).max(0.0)
    };
    sides.iter().zip(shape).map(cells).product()
}

/// A box of more than 16 cells, counted inside.
fn large_box(shape: &[usize], random: &mut Random) -> Vec<Interval> {
    loop {
        let side = |&n: &usize| {
            let all = Interval::new(-4.0, n as f64 + 3.0).expect("ordered");
            let (a, b) = (inside(all, random), inside(all, random));
            Interval::new(a.min(b), a.max(b)).expect("ordered")
        };
        let sides: Vec<Interval> = shape.iter().map(side).collect();
        if cells(&sides, shape) > 16.0 {
            return sides;
        }
    }
}

/// Differences of small integers are exact, so both hulls are the same, bit by bit. The values are
/// noise, a slope or a bowl: in these the extremes of a window are at its border, where blocks are
/// cut.
#[test]
fn the_pyramid_gives_the_hull_of_brute_force() {
    let mut random = Random(seed(8701));
    for axes in 1..=3 {
        for _ in 0..cases([100, 25, 3][axes - 1]) {
            let shape = shape(axes, [20, 5, 3][axes - 1], [60, 19, 7][axes - 1], &mut random);
            let kind = random.bits() % 3;
            let coefficient = |at: usize| match kind {
                0 => (random.bits() % 256) as f64,
                1 => at as f64,
                _ => (at as f64 - 40.0).powi(2),
            };
            let numbers = (0..shape.iter().product()).map(coefficient).collect();
            let spline = Spline::new(&shape, numbers).expect("finite");
            for orders in all_orders(axes, 3) {
                let sides = large_box(&shape, &mut random);
                let expected = brute_force(&spline, &sides, orders);
                assert_eq!(spline.enclosure(&sides, orders), expected, "{orders:?} {sides:?}");
            }
        }
    }
}

/// If differences are rounded, the error of an order with the sum `a` is counted at most
/// `2ᵃ⁺¹ a` times `u`, and once more by brute force.
#[test]
fn the_pyramid_gives_the_hull_of_brute_force_up_to_rounding() {
    let mut random = Random(seed(8702));
    for _ in 0..cases(20) {
        let shape = shape(2, 5, 19, &mut random);
        let numbers = (0..shape.iter().product()).map(|_| random.between(-1.0, 1.0)).collect();
        let spline = Spline::new(&shape, numbers).expect("finite");
        for orders in all_orders(2, 3) {
            let sides = large_box(&shape, &mut random);
            let expected = brute_force(&spline, &sides, orders);
            let found = spline.enclosure(&sides, orders);
            let a = f64::from(orders[0] + orders[1]);
            let slack = 4.0 * (a + 1.0) * a.exp2() * f64::EPSILON;
            assert!((found.lo() - expected.lo()).abs() <= slack, "{found:?} {expected:?}");
            assert!((found.hi() - expected.hi()).abs() <= slack, "{found:?} {expected:?}");
            if orders == [0; 3] {
                assert_eq!(found, expected);
            }
        }
    }
}

#[test]
fn the_range_over_all_of_space_is_that_of_all_differences() {
    let mut random = Random(seed(8703));
    for axes in 1..=3 {
        for _ in 0..cases([10, 10, 2][axes - 1]) {
            let shape = shape(axes, 1, 7, &mut random);
            let numbers = (0..shape.iter().product()).map(|_| (random.bits() % 256) as f64);
            let spline = Spline::new(&shape, numbers.collect()).expect("finite");
            let beyond = |&n: &usize| Interval::new(-4.0, n as f64 + 3.0).expect("ordered");
            let all: Vec<Interval> = shape.iter().map(beyond).collect();
            for orders in all_orders(axes, 3) {
                let expected = brute_force(&spline, &all, orders);
                assert_eq!(spline.range(orders), expected, "{shape:?} {orders:?}");
                let bounds = spline.enclosure(&vec![Interval::REALS; axes], orders);
                assert!(expected.contains_interval(bounds), "{bounds:?} {expected:?}");
            }
        }
    }
}

/// The documented sizes, in megabytes.
#[test]
fn a_picture_takes_2_1_megabytes_and_4_2_with_six_pyramids() {
    let picture = Spline::new(&[512, 512], vec![1.0; 512 * 512]).expect("finite");
    let megabytes = |spline: &Spline| (spline.memory() as f64 / 1e5).round() / 10.0;
    assert_eq!(megabytes(&picture), 2.1);
    for orders in all_orders(2, 2).into_iter().filter(|orders| orders[0] + orders[1] <= 2) {
        let _: Interval = picture.range(orders);
    }
    assert_eq!(megabytes(&picture), 4.2);
}
