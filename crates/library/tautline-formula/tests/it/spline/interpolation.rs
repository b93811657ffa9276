//! The spline through samples.

use tautline_chance::{Random, cases, seed};
use tautline_formula::spline::{Spline, SplineError};

use super::sampled::shape;

fn norm(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

/// A bound on the error of a value, relative to the largest sample.
///
/// Elimination in a tridiagonal matrix without exchanges solves a system whose matrix differs by at
/// most `4u |L| |U|`, and `|L| |U| ≤ 3 |A|` if it is diagonally dominant (Higham, *Accuracy and
/// Stability of Numerical Algorithms*, Theorems 9.13 and 9.14). So the residual is at most `12u` of
/// the largest coefficient, and `13u` with the rounding of the right-hand side. The coefficients of
/// `k` solved axes are at most `3ᵏ` times the samples. A value then has its own rounding, `2⁻⁴⁷` of
/// the coefficients.
fn rounding(axes: usize) -> f64 {
    let solved: f64 = (1..=axes as i32).map(|k| 13.0 * 0.5 * f64::EPSILON * 3.0_f64.powi(k)).sum();
    solved + 2.0_f64.powi(-47) * 3.0_f64.powi(axes as i32)
}

#[test]
fn it_hits_the_samples() -> Result<(), SplineError> {
    let mut random = Random(seed(8401));
    for axes in 1..=3 {
        for _ in 0..cases(60) {
            let shape = shape(axes, 1, 9, &mut random);
            let size = random.with_exponent(-100, 100);
            let samples: Vec<f64> =
                (0..shape.iter().product()).map(|_| size * random.between(-1.0, 1.0)).collect();
            let spline = Spline::interpolating(&shape, samples.clone())?;
            for (at, &sample) in samples.iter().enumerate() {
                let mut rest = at;
                let mut u = shape.clone();
                for (u, &n) in u.iter_mut().zip(&shape).rev() {
                    *u = rest % n;
                    rest /= n;
                }
                let u: Vec<f64> = u.iter().map(|&u| u as f64).collect();
                let error = (spline.value(&u, [0; 3]) - sample).abs();
                assert!(error <= rounding(axes) * norm(&samples), "{shape:?} {u:?}: {error:e}");
            }
        }
    }
    Ok(())
}

/// The spline without a border through the samples of a cubic is the cubic. The border changes the
/// coefficient at distance `k` by at most `0.268ᵏ` of what it changes the first one: with 40 nodes
/// on each side, by less than `10⁻²²`.
#[test]
fn cubics_are_reproduced_away_from_the_border() -> Result<(), SplineError> {
    let mut random = Random(seed(8402));
    let n = 100;
    for _ in 0..cases(100) {
        let c = [(); 8].map(|()| random.between(-1.0, 1.0));
        // In units of 50 nodes, so that the samples are of one size.
        let cubic = |c: &[f64], x: f64| ((c[3] * x + c[2]) * x + c[1]) * x + c[0];
        let place = |i: f64| i / 50.0 - 1.0;
        let samples: Vec<f64> = (0..n * n)
            .map(|k| cubic(&c[..4], place((k / n) as f64)) * cubic(&c[4..], place((k % n) as f64)))
            .collect();
        let largest = norm(&samples);
        let spline = Spline::interpolating(&[n, n], samples)?;
        let (u, v) = (random.between(40.0, 59.0), random.between(40.0, 59.0));
        let (x, y) = (place(u), place(v));
        // The samples and the expected values have about ten roundings of numbers up to 16.
        let tolerance = rounding(2) * largest + 160.0 * f64::EPSILON;
        let expected = cubic(&c[..4], x) * cubic(&c[4..], y);
        assert!((spline.value(&[u, v], [0; 3]) - expected).abs() <= tolerance);
        let bend = (6.0 * c[3] * x + 2.0 * c[2]) / 2500.0 * cubic(&c[4..], y);
        assert!((spline.value(&[u, v], [2, 0, 0]) - bend).abs() <= 4.0 * tolerance);
        let third = 6.0 * c[3] / 125_000.0 * cubic(&c[4..], y);
        assert!((spline.value(&[u, v], [3, 0, 0]) - third).abs() <= 8.0 * tolerance);
    }
    Ok(())
}

/// The first and the last row of the system are `5, 1` and `1, 5`: mirror images of the samples at
/// `−1/2` and `n − 1/2` change nothing.
#[test]
fn mirror_images_beyond_the_border_change_nothing_inside() -> Result<(), SplineError> {
    let mut random = Random(seed(8403));
    for _ in 0..cases(100) {
        let n = 1 + (random.bits() % 8) as usize;
        let samples: Vec<f64> = (0..n).map(|_| random.between(-1.0, 1.0)).collect();
        let mirrored = (0..41 * n).map(|k| {
            let (copy, at) = (k / n, k % n);
            samples[if copy % 2 == 0 { at } else { n - 1 - at }]
        });
        let long = Spline::interpolating(&[41 * n], mirrored.collect())?;
        let short = Spline::interpolating(&[n], samples)?;
        let u = random.between(0.0, n as f64 - 1.0);
        let difference = short.value(&[u], [0; 3]) - long.value(&[u + 20.0 * n as f64], [0; 3]);
        // Both have the rounding of one axis, and the second one also that of the coordinate: a
        // slope of at most 2 · 3 for a shift of 2⁻⁴⁵. Its border is far away, unless n = 1, where
        // all samples are the same.
        assert!(difference.abs() <= 2.0 * rounding(1) + 6.0 * 2.0_f64.powi(-45), "{difference:e}");
    }
    Ok(())
}

/// Samples `±1` that alternate on both sides of a pair of equal ones: half-way between these, the
/// spline is `(1 + 3√3)/4 = 1.549`, the most that it can be.
#[test]
fn the_worst_overshoot_between_nodes_is_1_549() -> Result<(), SplineError> {
    let worst = (1.0 + 3.0 * 3.0_f64.sqrt()) / 4.0;
    let sign = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
    let line: Vec<f64> = (0..80).map(|k| if k < 40 { sign(k + 1) } else { sign(k) }).collect();
    let spline = Spline::interpolating(&[80], line.clone())?;
    let value = spline.value(&[39.5], [0; 3]);
    assert!((value - worst).abs() <= rounding(1), "{value}");
    // On two axes, the product of two such lines.
    let plane = line.iter().flat_map(|a| line.iter().map(move |b| a * b)).collect();
    let spline = Spline::interpolating(&[80, 80], plane)?;
    let value = spline.value(&[39.5, 39.5], [0; 3]);
    assert!((value - worst * worst).abs() <= rounding(2), "{value}");
    Ok(())
}

/// Alternating samples: beyond the border the spline is `√3`, and inside its coefficients are 3.
#[test]
fn the_worst_overshoot_beyond_the_border_is_the_root_of_3() -> Result<(), SplineError> {
    let line = (0..80).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
    let spline = Spline::interpolating(&[80], line)?;
    assert!((spline.value(&[f64::NEG_INFINITY], [0; 3]) - 3.0_f64.sqrt()).abs() <= rounding(1));
    assert!((spline.coefficients()[40] - 3.0).abs() <= rounding(1));
    Ok(())
}

#[test]
fn overshoot_is_at_most_what_is_proved() -> Result<(), SplineError> {
    let mut random = Random(seed(8404));
    for axes in 1..=3 {
        let power = |base: f64| base.powi(axes as i32) + rounding(axes);
        let inside = power((1.0 + 3.0 * 3.0_f64.sqrt()) / 4.0);
        let (outside, coefficient) = (power(3.0_f64.sqrt()), power(3.0));
        for _ in 0..cases(200) {
            let shape = shape(axes, 1, 8, &mut random);
            let samples = (0..shape.iter().product()).map(|_| random.sign()).collect();
            let spline = Spline::interpolating(&shape, samples)?;
            assert!(norm(spline.coefficients()) <= coefficient);
            for _ in 0..20 {
                let u: Vec<f64> =
                    shape.iter().map(|&n| random.between(0.0, n as f64 - 1.0)).collect();
                assert!(spline.value(&u, [0; 3]).abs() <= inside, "{u:?}");
                let u: Vec<f64> =
                    shape.iter().map(|&n| random.between(-2.0, n as f64 + 1.0)).collect();
                assert!(spline.value(&u, [0; 3]).abs() <= outside, "{u:?}");
            }
        }
    }
    Ok(())
}
