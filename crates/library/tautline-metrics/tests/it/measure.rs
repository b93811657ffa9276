//! Measurements of a metric from its formula alone: `H`, its derivatives, their norms, and the
//! places at which its constants are attained.
//!
//! A measured value is a formula with about ten roundings and an eigenvalue of a small matrix,
//! which gives an error of about 1e-14. Constants that are computed eigenvalues have a margin of
//! the same size. The tolerance is 1e-12; an error of one percent in a constant exceeds it by ten
//! decades.

use approx::assert_relative_eq;
use nalgebra::{DMatrix, SMatrix, SVector};
use proptest::test_runner::TestRunner;
use tautline_metrics::{Bounded, Jet1, Jet2, Metric};

/// Runs random cases, which are the same in every run unless the environment overrides the seed.
pub(crate) fn runner(seed: u64) -> TestRunner {
    TestRunner::new(tautline_chance::config(seed, 256))
}

/// Returns the least and the greatest eigenvalue.
pub(crate) fn extremes<const D: usize>(h: &SMatrix<f64, D, D>) -> (f64, f64) {
    let eigenvalues = DMatrix::from_fn(D, D, |i, j| h[(i, j)]).symmetric_eigenvalues();
    (eigenvalues.min(), eigenvalues.max())
}

/// Returns the operator norm of a symmetric matrix.
pub(crate) fn norm<const D: usize>(h: &SMatrix<f64, D, D>) -> f64 {
    let (low, high) = extremes(h);
    low.abs().max(high.abs())
}

/// Returns `DH(x)[w]`, from the first jet along `t ↦ x + t w`.
pub(crate) fn first<const D: usize>(
    g: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let [t] = Jet1::variables(&[0.0]);
    g.gram(&SVector::from_fn(|i, _| t * w[i] + x[i])).map(|entry: Jet1<f64, 1>| entry.first(0))
}

/// Returns `D²H(x)[w, w]`, from the second jet along `t ↦ x + t w`.
pub(crate) fn second<const D: usize>(
    g: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let [t] = Jet2::variables(&[0.0]);
    g.gram(&SVector::from_fn(|i, _| t * w[i] + x[i])).map(|entry: Jet2<f64, 1>| entry.second(0, 0))
}

/// Asserts that `x` attains `c₁`.
#[track_caller]
pub(crate) fn low<const D: usize>(g: &impl Bounded<D>, x: SVector<f64, D>) {
    assert_relative_eq!(extremes(&g.gram(&x)).0, g.constants().c1(), max_relative = 1e-12);
}

/// Asserts that `x` attains `c₂`.
#[track_caller]
pub(crate) fn high<const D: usize>(g: &impl Bounded<D>, x: SVector<f64, D>) {
    assert_relative_eq!(extremes(&g.gram(&x)).1, g.constants().c2(), max_relative = 1e-12);
}

/// Asserts that `x` and the direction `w` attain `L_H`.
#[track_caller]
pub(crate) fn slope<const D: usize>(g: &impl Bounded<D>, x: SVector<f64, D>, w: SVector<f64, D>) {
    let measured = norm(&first(g, &x, &w)) / w.norm();
    assert_relative_eq!(measured, g.constants().l_h(), max_relative = 1e-12);
}

/// Asserts that `x` and the direction `w` attain `M_H`.
#[track_caller]
pub(crate) fn curvature<const D: usize>(
    g: &impl Bounded<D>,
    x: SVector<f64, D>,
    w: SVector<f64, D>,
) {
    let measured = norm(&second(g, &x, &w)) / w.norm_squared();
    let m_h = g.constants().m_h().expect("every metric here has one");
    assert_relative_eq!(measured, m_h, max_relative = 1e-12);
}

/// Returns the largest `‖DH(x)[w]‖` and `‖D²H(x)[w, w]‖` over points and unit directions, as
/// fractions of `L_H` and `M_H`.
pub(crate) fn scan<const D: usize>(
    g: &impl Bounded<D>,
    places: impl IntoIterator<Item = (SVector<f64, D>, SVector<f64, D>)>,
) -> [f64; 2] {
    let [mut slope, mut curvature] = [0.0_f64; 2];
    for (x, w) in places {
        slope = slope.max(norm(&first(g, &x, &w)));
        curvature = curvature.max(norm(&second(g, &x, &w)));
    }
    let constants = g.constants();
    [slope / constants.l_h(), curvature / constants.m_h().expect("known")]
}

/// Returns some unit vectors of the plane, spread over half a circle.
pub(crate) fn directions(count: u32) -> impl Iterator<Item = SVector<f64, 2>> + Clone {
    (0..count).map(move |j| {
        let (sin, cos) = (f64::from(j) * std::f64::consts::PI / f64::from(count)).sin_cos();
        SVector::from([cos, sin])
    })
}
