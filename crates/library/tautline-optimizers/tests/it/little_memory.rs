//! Tests that a solve without memory ends with an error and does not end the process.
#![cfg(target_os = "linux")]

use std::{env, process::Command};

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{LARGEST_N, Rule};
use tautline_formula::Prepared;
use tautline_metrics::{Metric, Scalar, gallery::Separable};
use tautline_optimizers::{Options, SolveError, Starts, Workspace, minimise, newton_step};
use tautline_sets::Sphere;

use crate::setup::{between, from_to, sequence};

/// On this grid, a step takes 302 MB for its `2D² + 2D` doubles per point, and the points take 17
/// MB.
const N: usize = 1 << 18;
const D: usize = 8;

/// This variable is set in a process with little memory.
const HERE: &str = "TAUTLINE_TESTS_LITTLE_MEMORY";

/// Runs a test in a separate process that is limited to this many megabytes.
fn with_megabytes(megabytes: u32, test: &str, run: fn()) {
    if env::var_os(HERE).is_some() {
        return run();
    }
    let limited = format!("ulimit -v {} && exec \"$0\" \"$@\"", megabytes * 1024);
    let output = Command::new("sh")
        .args(["-c", &limited])
        .arg(env::current_exe().expect("this program"))
        .args(["--exact", &format!("little_memory::{test}"), "--nocapture"])
        .env(HERE, "")
        .output()
        .expect("a shell");
    let said = String::from_utf8_lossy(&output.stderr);
    let passed = String::from_utf8_lossy(&output.stdout).contains("1 passed");
    assert!(output.status.success() && passed, "{}: {said}", output.status);
}

/// A wave of 400 radians in every direction, so that the finest grid needs a step.
fn metric() -> Separable<D> {
    Separable::new([0.3; D], [400.0; D]).expect("a metric")
}

#[test]
fn a_step_without_memory_is_none() {
    with_megabytes(300, "a_step_without_memory_is_none", || {
        let ends = from_to([0.0; D], [1.0; D]);
        let pieces = [&**ends.first(), &**ends.second()];
        let line = |n: usize| {
            let points = (0..=n).map(|k| SVector::repeat(k as f64 / n as f64));
            sequence(points.collect())
        };
        let flat = Prepared::new(Separable::new([0.1; D], [1.0; D]).expect("a metric"));
        let mut workspace = Workspace::default();
        let mut step = |n| newton_step(&mut workspace, &flat, pieces, Rule::TRAPEZOIDAL, &line(n));
        assert!(step(1024).is_some());
        assert!(step(N).is_none());
    });
}

#[test]
fn a_grid_without_memory_is_an_error() {
    with_megabytes(300, "a_grid_without_memory_is_an_error", || {
        let ends = from_to([0.0; D], [1.0; D]);
        let error = minimise(&metric(), &ends, Rule::LEFT_ENDPOINT, N, &Options::default());
        let error = error.map(|minimum| minimum.sequence.n()).expect_err("no memory");
        // The error reports the bytes of an undamped step.
        let bytes = (N + 1) * (2 * D * D + 2 * D) * 8;
        assert_eq!(error, SolveError::OutOfMemory { n: N, bytes });
    });
}

#[test]
fn points_without_memory_are_an_error_before_any_search() {
    with_megabytes(500, "points_without_memory_are_an_error_before_any_search", || {
        let wave = Separable::new([0.1], [1.0]).expect("a metric");
        let ends = from_to([0.0], [1.0]);
        let error = minimise(&wave, &ends, Rule::TRAPEZOIDAL, LARGEST_N, &Options::default());
        let error = error.map(|minimum| minimum.sequence.n()).expect_err("no memory");
        let bytes = 8 * (LARGEST_N + 1);
        assert_eq!(error, SolveError::OutOfMemory { n: LARGEST_N, bytes });
    });
}

/// Between concentric spheres the minimisers form a continuum, so every step needs damping, but
/// there is memory for undamped steps only. The earlier error of a refused start is not reported.
#[test]
fn damped_steps_without_memory_are_an_error() {
    struct ToTheRight;
    impl Metric<D> for ToTheRight {
        fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
            SMatrix::from_diagonal_element((x[0] + 5.0).sqrt() * 0.0 + 1.0)
        }
    }
    with_megabytes(450, "damped_steps_without_memory_are_an_error", || {
        let n = 1 << 17;
        let sphere = |r| Sphere::new([0.0; D], r).expect("a radius");
        let ends = between(sphere(1.0), sphere(2.0));
        let on_axis = |x: f64| SVector::<f64, D>::from_fn(|i, _| if i == 0 { x } else { 0.0 });
        let through = |x: f64| sequence([1.0, x, 2.0].map(on_axis).to_vec());
        let starts = Starts::Only(vec![through(-10.0), through(1.5)]);
        let options = Options { starts, ..Options::default() };
        let error = minimise(&ToTheRight, &ends, Rule::TRAPEZOIDAL, n, &options);
        let error = error.map(|minimum| minimum.sequence.n()).expect_err("no memory");
        let bytes = (n + 1) * 4 * (2 * D * D + 2 * D) * 8;
        assert_eq!(error, SolveError::OutOfMemory { n, bytes });
    });
}
