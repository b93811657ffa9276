//! Splines that pass through their samples and do not leave them between.

use std::sync::Arc;

use nalgebra::{Matrix3, SymmetricEigen};
use tautline_chance::{Random, cases, seed};
use tautline_formula::{
    Formula,
    spline::{FineSpline, Spline, SplineError},
};
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Table};

use super::sampled::{all_orders, point, shape, total};

/// The rounding error of a value, as `Spline::value` documents it, for samples of this size.
fn rounding(largest: f64) -> f64 {
    2.0_f64.powi(-46) * largest
}

/// Samples of many sizes, some of which are equal.
fn samples(count: usize, random: &mut Random) -> Vec<f64> {
    let mut last = 1.0;
    let mut next = |_| {
        if !random.bits().is_multiple_of(4) {
            last = random.sign() * random.with_exponent(-20, 10);
        }
        last
    };
    (0..count).map(&mut next).collect()
}

fn largest(samples: &[f64]) -> f64 {
    samples.iter().fold(0.0, |m, c| m.max(c.abs()))
}

#[test]
fn the_samples_are_its_values_and_bound_its_coefficients() {
    let mut random = Random(seed(8341));
    for axes in 1..=3 {
        for _ in 0..cases(60) {
            let shape = shape(axes, 1, 5, &mut random);
            let samples = samples(shape.iter().product(), &mut random);
            let spline = FineSpline::monotone(&shape, samples.clone()).expect("finite");
            assert_eq!(spline.shape(), shape);
            let mut at = vec![0; axes];
            for sample in &samples {
                let u: Vec<f64> = at.iter().map(|&i| i as f64).collect();
                let value = spline.value(&u, [0; 3]);
                let tolerance = rounding(largest(&samples));
                assert!((value - sample).abs() <= tolerance, "{value} at {at:?} of {samples:?}");
                for axis in (0..axes).rev() {
                    at[axis] += 1;
                    if at[axis] < shape[axis] {
                        break;
                    }
                    at[axis] = 0;
                }
            }
            let lo = samples.iter().copied().fold(f64::INFINITY, f64::min);
            let hi = samples.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let range: Interval = spline.spline().range([0; 3]);
            assert!(lo <= range.lo() && range.hi() <= hi, "{range:?} of {samples:?}");
        }
    }
}

/// Along one axis, slopes from one sample to the next have the sign of the step, exactly: they are
/// combinations of the differences of coefficients. A difference of rounded coefficients is wrong by their
/// rounding only.
#[test]
fn it_is_monotone_between_samples() {
    let mut random = Random(seed(8342));
    for _ in 0..cases(500) {
        let n = 2 + (random.bits() % 9) as usize;
        let samples = samples(n, &mut random);
        let spline = FineSpline::monotone(&[n], samples.clone()).expect("finite");
        let i = (random.bits() % (n as u64 - 1)) as usize;
        let (a, b) = (samples[i], samples[i + 1]);
        let u = i as f64 + random.between(0.0, 1.0);
        let tolerance = 4.0 * rounding(a.abs().max(b.abs()));
        let near = &samples[i.saturating_sub(1)..(i + 3).min(n)];
        let slope = spline.value(&[u], [1, 0, 0]) * (b - a).signum();
        assert!(
            a == b || slope >= -24.0 * rounding(largest(near)),
            "slope {slope} at {u}: {samples:?}"
        );
        let value = spline.value(&[u], [0; 3]);
        let (lo, hi) = (a.min(b) - tolerance, a.max(b) + tolerance);
        let reach = 4.0 * rounding(largest(near));
        assert!(lo - reach <= value && value <= hi + reach, "{value} at {u}: {samples:?}");
    }
}

/// A step, a road and a wall: the cubic spline through these samples leaves them by a tenth of the jump.
#[test]
fn a_jump_does_not_ring() {
    for samples in [
        vec![1.0, 1.0, 1.0, 1000.0, 1000.0, 1000.0],
        vec![10.0, 10.0, 1.0, 10.0, 10.0, 10.0],
        vec![1.0, 1.0, 1000.0, 1.0, 1.0, 1.0],
    ] {
        let spline = FineSpline::monotone(&[6], samples.clone()).expect("finite");
        let cubic = Spline::interpolating(&[6], samples.clone()).expect("finite");
        let top = largest(&samples);
        let beyond = |value: &dyn Fn(f64) -> f64| {
            let values = (0..=500).map(|k| value(f64::from(k) / 100.0));
            values.fold(f64::NEG_INFINITY, |most, value| most.max(value - top).max(1.0 - value))
        };
        assert!(beyond(&|u| spline.value(&[u], [0; 3])) <= rounding(top));
        assert!(beyond(&|u| cubic.value(&[u], [0; 3])) > 0.07 * (top - 1.0));
    }
}

/// Away from the border linear samples are reproduced, and quadratic ones where their slope changes by less
/// than a quarter from step to step; with the derivatives.
#[test]
fn quadratic_samples_are_reproduced_where_they_are_steep() {
    let mut random = Random(seed(8343));
    let n = 12;
    for _ in 0..cases(200) {
        let [a, b, c] = [(); 3].map(|()| random.between(-1.0, 1.0));
        // The steps are at least |b| − 0.4|b|, and differ by at most 0.03|b|.
        let [p, q] = [(); 2].map(|()| random.between(-0.015, 0.015));
        let f = |x: f64, y: f64| a + b * x + c * y + p * b * x * x + q * c * y * y;
        let samples = (0..n * n).map(|k| f((k / n) as f64, (k % n) as f64)).collect();
        let spline = FineSpline::monotone(&[n, n], samples).expect("finite");
        let (x, y) = (random.between(1.0, 10.0), random.between(1.0, 10.0));
        let tolerance = 100.0 * rounding(40.0);
        assert!((spline.value(&[x, y], [0; 3]) - f(x, y)).abs() <= tolerance);
        let slope = b + 2.0 * p * b * x;
        assert!((spline.value(&[x, y], [1, 0, 0]) - slope).abs() <= 6.0 * tolerance);
        assert!((spline.value(&[x, y], [0, 2, 0]) - 2.0 * q * c).abs() <= 36.0 * tolerance);
    }
}

/// The error falls with the third power of the step where a smooth function has slopes, and with the second
/// one at its extrema, which become flat.
#[test]
fn smooth_samples_are_approximated_to_second_order() {
    let error = |n: usize| {
        let step = 3.0 / (n - 1) as f64;
        let samples = (0..n).map(|i| (step * i as f64).sin()).collect();
        let spline = FineSpline::monotone(&[n], samples).expect("finite");
        let off = |x: f64| (spline.value(&[x / step], [0; 3]) - x.sin()).abs();
        let most = |from: f64, to: f64| {
            (0..=1000).map(|k| off(from + (to - from) * f64::from(k) / 1000.0)).fold(0.0, f64::max)
        };
        [most(0.5, 1.0), most(1.3, 1.8)]
    };
    let [coarse, fine] = [error(31), error(121)];
    let order = |k: usize| (coarse[k] / fine[k]).log(4.0);
    assert!(order(0) > 2.7 && (1.7..2.3).contains(&order(1)), "{} {}", order(0), order(1));
}

/// The mean over the orders of the axes has none of its own.
#[test]
fn a_transposed_array_has_the_transposed_function() {
    let mut random = Random(seed(8344));
    for _ in 0..cases(50) {
        let [n, m] = [(); 2].map(|()| 1 + (random.bits() % 5) as usize);
        let samples = samples(n * m, &mut random);
        let turned = (0..n * m).map(|k| samples[k % n * m + k / n]).collect();
        let [one, other] = [(&[n, m], samples), (&[m, n], turned)]
            .map(|(shape, samples)| FineSpline::monotone(shape, samples).expect("finite"));
        let (one, other) = (one.spline(), other.spline());
        let (rows, columns) = (one.shape()[0], one.shape()[1]);
        for k in 0..rows * columns {
            let (i, j) = (k / columns, k % columns);
            assert_eq!(one.coefficients()[k], other.coefficients()[j * rows + i]);
        }
    }
}

/// A formula records the spline at three times the arguments, and has the same derivatives and ranges as
/// the table by itself.
#[test]
fn a_formula_calls_the_spline_below() {
    let mut random = Random(seed(8345));
    for _ in 0..cases(50) {
        let samples: Vec<f64> = (0..12).map(|_| random.between(1.0, 3.0)).collect();
        let spline = FineSpline::monotone(&[4, 3], samples).expect("finite");
        let table: Arc<dyn Table> = Arc::new(spline.clone());
        let named = [("h", Arc::clone(&table))];
        let u = point(&[4, 3], &mut random);
        let below = Spline::value(spline.spline(), &[3.0 * u[0], 3.0 * u[1]], [0; 3]);
        assert_eq!(table.value(&u, [0; 3]), below);
        for (name, orders) in [("h", [0; 3]), ("h_10", [1, 0, 0]), ("h_12", [1, 2, 0])] {
            let text = format!("{name}(x1, x2) I");
            let formula = Formula::<2>::parse_with(&text, &[], &named).expect("a formula");
            assert!(formula.tables()[0].is_same(&**spline.spline()), "{formula}");
            let value = formula.gram(&[u[0], u[1]].into())[(0, 0)];
            assert_eq!(value, table.value(&u, orders), "{name}");
        }
        for orders in all_orders(2, 3).into_iter().filter(|&orders| total(orders) <= 3) {
            let side = |u: f64, w: f64| (u.min(u + w), u.max(u + w));
            let sides =
                [side(u[0], random.between(-0.5, 0.5)), side(u[1], random.between(-0.5, 0.5))];
            let (lo, hi) = table.bounds(&sides, orders).expect("bounds");
            let inside = sides.map(|(a, b)| a + (b - a) * random.between(0.0, 1.0));
            let value = table.value(&inside, orders);
            let slack = 3.0_f64.powi(8) * rounding(8.0);
            assert!(
                lo - slack <= value && value <= hi + slack,
                "{value} in [{lo}, {hi}], {orders:?}"
            );
        }
    }
}

/// Matrices of contrast up to 10⁶ whose axes turn at random from sample to sample.
#[test]
fn matrices_stay_positive_definite_and_are_those_at_the_samples() {
    let mut random = Random(seed(8346));
    let turns_matter = (0..cases(40)).filter(|_| {
        let shape = [3, 4, 2];
        let matrices: Vec<Matrix3<f64>> = (0..24)
            .map(|_| {
                let turn = Matrix3::from_fn(|_, _| random.between(-1.0, 1.0)).qr().q();
                let values = [0, -10, -20].map(|e| random.with_exponent(e, e + 1));
                turn * Matrix3::from_diagonal(&values.into()) * turn.transpose()
            })
            .collect();
        let upper = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
        let numbers = matrices.iter().flat_map(|h| upper.map(|at| h[at])).collect();
        let splines = FineSpline::monotone_matrices(&shape, 3, numbers).expect("finite");
        let at = |u: &[f64]| {
            let entries = splines.iter().map(|spline| spline.value(u, [0; 3]));
            let mut h = Matrix3::zeros();
            for (value, (i, j)) in entries.zip(upper) {
                (h[(i, j)], h[(j, i)]) = (value, value);
            }
            h
        };
        for (k, h) in matrices.iter().enumerate() {
            let u = [(k / 8) as f64, (k / 2 % 4) as f64, (k % 2) as f64];
            assert!((at(&u) - h).amax() <= rounding(2.0));
        }
        // A coefficient has at least half of the least eigenvalue of its sample, in all three passes.
        let least = |h: &Matrix3<f64>| SymmetricEigen::new(*h).eigenvalues.min();
        let bound = matrices.iter().map(least).fold(f64::INFINITY, f64::min) / 8.0;
        for _ in 0..20 {
            let u = point(&shape, &mut random);
            assert!(least(&at(&u)) >= bound - rounding(8.0), "{} at {u:?}", least(&at(&u)));
        }
        // Entry by entry, some coefficient would not be positive definite.
        let alone = upper.map(|at| {
            let entries = matrices.iter().map(|h| h[at]).collect();
            FineSpline::monotone(&shape, entries).expect("finite")
        });
        splines.iter().zip(&alone).any(|(one, other)| one != other)
    });
    assert!(turns_matter.count() > 0);
}

/// With the steps 1 and 9 the slope is 5/4 and the curvature 9/4, their bounds.
#[test]
fn slope_and_curvature_are_at_most_those_of_the_smaller_step() {
    let spline = FineSpline::monotone(&[3], vec![0.0, 1.0, 10.0]).expect("finite");
    let (slope, bend) = (1.25, 2.25);
    let around =
        [1.0 - slope / 3.0 + bend / 27.0, 1.0 - bend / 54.0, 1.0 + slope / 3.0 + bend / 27.0];
    assert_eq!(spline.spline().coefficients()[2..5], around);
}

/// At the matrix with rows 1, 0.9 and 0.9, 1, whose least eigenvalue is 0.1, a coefficient is kept if its own
/// is above 0.05: 0.066 beside the first of the last matrices, and 0.039 beside the second one.
#[test]
fn a_coefficient_has_at_least_half_of_the_least_eigenvalue() {
    let beside = |last: f64| {
        let matrices = vec![1.0, 0.6, 1.0, 1.0, 0.9, 1.0, 2.0, last, 2.0];
        let splines = FineSpline::monotone_matrices(&[3], 2, matrices).expect("finite");
        splines[1].spline().coefficients()[4]
    };
    assert!((0.934..0.935).contains(&beside(1.0)), "{}", beside(1.0));
    assert_eq!(beside(1.06), 0.9);
}

#[test]
fn what_is_no_array_is_refused() {
    let refused = |shape: &[usize], samples: Vec<f64>| {
        FineSpline::monotone(shape, samples).expect_err("refused")
    };
    assert_eq!(refused(&[], vec![]), SplineError::Axes { shape: vec![] });
    assert_eq!(refused(&[0], vec![]), SplineError::EmptyAxis { axis: 0, shape: vec![0] });
    let count = SplineError::Count { shape: vec![2, 2], expected: 4, found: 3 };
    assert_eq!(refused(&[2, 2], vec![1.0; 3]), count);
    let error = refused(&[2], vec![1.0, f64::NAN]);
    assert!(matches!(error, SplineError::NotFinite { .. }), "{error}");
    let error = refused(&[5463, 5463], vec![1.0; 5463 * 5463]);
    assert_eq!(error, SplineError::TooFine { shape: vec![5463, 5463], most: 1 << 28 });
    let matrices = FineSpline::monotone_matrices(&[2], 2, vec![1.0; 5]);
    assert!(matches!(matrices, Err(SplineError::Count { .. })), "{matrices:?}");
}
