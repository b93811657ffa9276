//! With samples as coefficients, the spline smooths them and keeps their shape.

use tautline_chance::{Random, cases, seed};
use tautline_formula::spline::Spline;
use tautline_scalar::Interval;

use super::sampled::{all_orders, point, shape};

/// The weights have the sum 1 up to rounding, which is at most `2⁻⁴⁷`, and enclosures know that it
/// is exactly 1.
#[test]
fn the_weights_are_a_partition_of_unity() {
    let mut random = Random(seed(8301));
    for axes in 1..=3 {
        for _ in 0..cases(200) {
            let shape = shape(axes, 1, 5, &mut random);
            let c = random.sign() * random.with_exponent(-30, 30);
            let spline = Spline::new(&shape, vec![c; shape.iter().product()]).expect("finite");
            let u = point(&shape, &mut random);
            assert!((spline.value(&u, [0; 3]) - c).abs() <= 2.0_f64.powi(-47) * c.abs());
            for orders in all_orders(axes, 4).into_iter().skip(1) {
                assert_eq!(spline.value(&u, orders), 0.0);
            }
            let here: Vec<Interval> = u.iter().map(|&u| Interval::point(u)).collect();
            assert_eq!(spline.enclosure(&here, [0; 3]), Interval::point(c));
        }
    }
}

/// Where all four coefficients of a cell are in the array, linear samples are reproduced.
#[test]
fn linear_samples_are_reproduced_inside() {
    let mut random = Random(seed(8302));
    let n = 12;
    for _ in 0..cases(200) {
        let [a, b, c] = [(); 3].map(|()| random.between(-1.0, 1.0));
        let linear = |x: f64, y: f64| a + b * x + c * y;
        let samples = (0..n * n).map(|k| linear((k / n) as f64, (k % n) as f64)).collect();
        let spline = Spline::new(&[n, n], samples).expect("finite");
        let (x, y) = (random.between(1.0, 10.0), random.between(1.0, 10.0));
        // Samples are at most 1 + 11 + 11, and rounded three times; the spline as documented.
        let tolerance = 24.0 * (2.0_f64.powi(-47) + 3.0 * f64::EPSILON);
        assert!((spline.value(&[x, y], [0; 3]) - linear(x, y)).abs() <= tolerance);
        assert!((spline.value(&[x, y], [1, 0, 0]) - b).abs() <= 2.0 * tolerance);
        assert!(spline.value(&[x, y], [1, 1, 0]).abs() <= 4.0 * tolerance);
    }
}

/// Differences of increasing coefficients are not negative, nor are their weights, so the slope is
/// not negative, exactly.
#[test]
fn monotone_samples_give_a_monotone_function() {
    let mut random = Random(seed(8303));
    for _ in 0..cases(300) {
        let n = 2 + (random.bits() % 9) as usize;
        let mut sum = random.between(-1.0, 1.0);
        let steps = |_| {
            sum += if random.bits().is_multiple_of(3) { 0.0 } else { random.with_exponent(-20, 2) };
            sum
        };
        let samples: Vec<f64> = (0..n).map(steps).collect();
        let largest = samples.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        let spline = Spline::new(&[n], samples).expect("finite");
        let (a, b) = (random.between(-2.0, n as f64), random.between(-2.0, n as f64));
        let (a, b) = (a.min(b), a.max(b));
        assert!(spline.value(&[a], [1, 0, 0]) >= 0.0);
        let (low, high) = (spline.value(&[a], [0; 3]), spline.value(&[b], [0; 3]));
        assert!(low <= high + 2.0_f64.powi(-46) * largest, "{low} at {a}, {high} at {b}");
        let slopes = spline.enclosure(&[Interval::new(a, b).expect("ordered")], [1, 0, 0]);
        assert!(slopes.lo() >= 0.0, "{slopes:?}");
    }
}

/// Values lie between the samples next to the cell, and enclosures say so exactly: a cost that is
/// at least 0 is proved to be.
#[test]
fn values_lie_between_the_nearest_samples() {
    let mut random = Random(seed(8304));
    for _ in 0..cases(300) {
        let n = 9;
        let samples: Vec<f64> = (0..n * n)
            .map(|_| if random.bits().is_multiple_of(2) { 0.0 } else { random.unit() })
            .collect();
        let spline = Spline::new(&[n, n], samples).expect("finite");
        let (i, j) = ((random.bits() % 6) as usize + 1, (random.bits() % 6) as usize + 1);
        let near = (i - 1..=i + 2).flat_map(|i| (j - 1..=j + 2).map(move |j| (i, j)));
        let (mut lo, mut hi) = (f64::INFINITY, 0.0_f64);
        for (i, j) in near {
            lo = lo.min(spline.coefficients()[i * n + j]);
            hi = hi.max(spline.coefficients()[i * n + j]);
        }
        let (x, y) = (i as f64 + random.unit(), j as f64 + random.unit());
        let value = spline.value(&[x, y], [0; 3]);
        let slack = 2.0_f64.powi(-47) * hi;
        assert!(lo - slack <= value && value <= hi + slack, "{value} not in [{lo}, {hi}]");
        let here = spline.enclosure(&[Interval::point(x), Interval::point(y)], [0; 3]);
        assert!(lo <= here.lo() && here.hi() <= hi, "{here:?} not in [{lo}, {hi}]");
    }
}
