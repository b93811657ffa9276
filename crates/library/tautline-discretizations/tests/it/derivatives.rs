//! Compares the gradients and Hessians of the discrete energies with an independent implementation.
//! The sum is written out again and differentiated by `num-dual`, in all coordinates of all points.

use nalgebra::{SMatrix, SVector};
use num_dual::{Dual2SVec64, DualNum, hessian};
use proptest::prelude::*;
use tautline_discretizations::{PointSequence, QuadraticModel, Rule, energy_gradient};
use tautline_metrics::{Metric, Scalar};

/// A full matrix that depends on both coordinates.
struct Skew;

impl Metric<2> for Skew {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let off = (x[0] + x[1] * 2.0).sin() * 0.3;
        SMatrix::from([
            [(x[0] * x[1]).cos() + 3.0, off],
            [off, (-x[0].sqr()).exp() + x[1].sin() * 0.5 + 1.5],
        ])
    }
}

type Dual = Dual2SVec64<8>;

/// Returns `(1/N) Σ βᵀHβ` with `H` at the given fraction of each chord, for `N = 3`, written by
/// hand.
fn energy(v: &SVector<Dual, 8>, fraction: f64) -> Dual {
    let mut sum = v[0] * 0.0;
    for k in 0..3 {
        let (x, y) = ([v[2 * k], v[2 * k + 1]], [v[2 * k + 2], v[2 * k + 3]]);
        let d = [y[0] - x[0], y[1] - x[1]];
        let m = [x[0] + d[0] * fraction, x[1] + d[1] * fraction];
        let off = (m[0] + m[1] * 2.0).sin() * 0.3;
        let first = (m[0] * m[1]).cos() + 3.0;
        let second = (-(m[0] * m[0])).exp() + m[1].sin() * 0.5 + 1.5;
        sum += first * d[0] * d[0] + off * d[0] * d[1] * 2.0 + second * d[1] * d[1];
    }
    sum * 3.0
}

fn check(rule: Rule, fractions: &[f64], coordinates: [f64; 8]) -> Result<(), TestCaseError> {
    let v = SVector::<f64, 8>::from(coordinates);
    let points = (0..4).map(|k| SVector::from([v[2 * k], v[2 * k + 1]])).collect();
    let sequence = PointSequence::new(points).expect("finite");
    let model = QuadraticModel::new(rule, &Skew, &sequence);
    let (value, gradient) = energy_gradient(rule, &Skew, &sequence);
    let (mut e, mut g, mut h) = (0.0, SVector::<f64, 8>::zeros(), SMatrix::<f64, 8, 8>::zeros());
    for &fraction in fractions {
        let (e1, g1, h1) = hessian(|v| energy(&v, fraction), &v);
        let share = 1.0 / fractions.len() as f64;
        e += e1 * share;
        g += g1 * share;
        h += h1 * share;
    }
    // Coordinates up to 2 and chords up to 4 give terms of size 3 · 4 · 16 · D²H ≲ 10³. There are
    // about a hundred roundings of relative size 1e-16.
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-11 * (1.0 + b.abs());
    prop_assert!(close(model.energy, e), "energy {} {e}", model.energy);
    prop_assert!(close(value, e) && close(rule.energy(&Skew, &sequence), e));
    for n in 0..4 {
        for i in 0..2 {
            let exact = g[2 * n + i];
            prop_assert!(close(model.gradient::<2>()[n][i], exact), "gradient {n} {i}");
            prop_assert!(close(gradient[n][i], exact), "first-order gradient {n} {i}");
            for m in 0..4 {
                for j in 0..2 {
                    let ours = match (n, m) {
                        _ if n == m => model.hessian::<2>().diagonal[n][(i, j)],
                        _ if n + 1 == m => model.hessian::<2>().upper[n][(i, j)],
                        _ if m + 1 == n => model.hessian::<2>().upper[m][(j, i)],
                        _ => 0.0,
                    };
                    let exact = h[(2 * n + i, 2 * m + j)];
                    prop_assert!(close(ours, exact), "Hessian {n} {i}, {m} {j}: {ours} {exact}");
                }
            }
        }
    }
    Ok(())
}

/// A full matrix in four dimensions.
struct Woven;

impl Metric<4> for Woven {
    fn gram<S: Scalar>(&self, x: &SVector<S, 4>) -> SMatrix<S, 4, 4> {
        SMatrix::from_fn(|i, j| {
            let off = ((x[i] - x[j]).cos() + (x[i] * x[j]).sin()) * 0.2;
            if i == j { off + x[(i + 1) % 4].exp() + 2.0 } else { off }
        })
    }
}

/// Returns `E = Σ Hᵢⱼ dᵢ dⱼ` for one chord in four dimensions, written by hand.
fn chord_energy(v: &SVector<Dual, 8>, fraction: f64) -> Dual {
    let d: [Dual; 4] = std::array::from_fn(|i| v[4 + i] - v[i]);
    let m: [Dual; 4] = std::array::from_fn(|i| v[i] + d[i] * fraction);
    let mut sum = v[0] * 0.0;
    for i in 0..4 {
        for j in 0..4 {
            let off = ((m[i] - m[j]).cos() + (m[i] * m[j]).sin()) * 0.2;
            let entry = if i == j { off + m[(i + 1) % 4].exp() + 2.0 } else { off };
            sum += entry * d[i] * d[j];
        }
    }
    sum
}

fn check_four(rule: Rule, fraction: f64, v: [f64; 8]) -> Result<(), TestCaseError> {
    let v = SVector::<f64, 8>::from(v);
    let ends = [0, 4].map(|k| SVector::<f64, 4>::from_fn(|i, _| v[k + i]));
    let sequence = PointSequence::new(ends.to_vec()).expect("finite");
    let model = QuadraticModel::new(rule, &Woven, &sequence);
    let (energy, gradient) = energy_gradient(rule, &Woven, &sequence);
    let (e, g, h) = hessian(|v| chord_energy(&v, fraction), &v);
    // As above, terms are up to about 10³, and there are a hundred roundings.
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-11 * (1.0 + b.abs());
    prop_assert!(close(model.energy, e) && close(energy, e));
    for i in 0..8 {
        prop_assert!(close(model.gradient::<4>()[i / 4][i % 4], g[i]), "gradient {i}");
        prop_assert!(close(gradient[i / 4][i % 4], g[i]), "first-order gradient {i}");
        for j in 0..8 {
            let ours = match (i / 4, j / 4) {
                (0, 1) => model.hessian::<4>().upper[0][(i % 4, j % 4)],
                (1, 0) => model.hessian::<4>().upper[0][(j % 4, i % 4)],
                (n, _) => model.hessian::<4>().diagonal[n][(i % 4, j % 4)],
            };
            prop_assert!(close(ours, h[(i, j)]), "Hessian {i} {j}: {ours} {}", h[(i, j)]);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(tautline_chance::config(2, 64))]

    #[test]
    fn derivatives_of_every_rule_agree_with_num_dual(
        v in proptest::array::uniform8(-2.0..2.0_f64),
    ) {
        check(Rule::TRAPEZOIDAL, &[0.5], v)?;
        check(Rule::LEFT_ENDPOINT, &[0.0], v)?;
        check(Rule::TRUE_TRAPEZOID, &[0.0, 1.0], v)?;
        check_four(Rule::TRAPEZOIDAL, 0.5, v)?;
        check_four(Rule::LEFT_ENDPOINT, 0.0, v)?;
    }

    /// `Hessian · v`, computed by blocks, is the derivative of the gradient along `v`.
    #[test]
    fn the_product_is_the_second_derivative(v in proptest::array::uniform8(-2.0..2.0_f64)) {
        let line = PointSequence::straight([0.0, 0.1], [1.0, 0.4], 3).expect("finite");
        let direction: Vec<_> = (0..4).map(|k| SVector::from([v[2 * k], v[2 * k + 1]])).collect();
        let model = QuadraticModel::new(Rule::TRAPEZOIDAL, &Skew, &line);
        let product = model.hessian::<2>().mul(&direction);
        let gradient = |s: f64| {
            let moved = line.points().iter().zip(&direction).map(|(x, u)| x + u * s).collect();
            energy_gradient(Rule::TRAPEZOIDAL, &Skew, &PointSequence::new(moved).expect("finite")).1
        };
        // The error of the central difference is s² times a third derivative of about 10³, plus
        // 1e-14 / s.
        let s = 1e-5;
        let (ahead, behind) = (gradient(s), gradient(-s));
        for n in 0..4 {
            let difference = (ahead[n] - behind[n]) / (2.0 * s);
            prop_assert!((difference - product[n]).amax() < 1e-6, "{difference} {}", product[n]);
        }
    }
}
