//! Tests metrics that are not twice differentiable. The search ends within its limit and claims
//! nothing false.

use nalgebra::{SMatrix, SVector, matrix};
use tautline_discretizations::Rule;
use tautline_metrics::{Metric, Scalar};
use tautline_optimizers::{Curvature, Minimum, Options, Starts, Stop, minimise};
use tautline_sets::Sphere;

use crate::setup::{ball, between, from_to, point, straight};

/// Checks what holds for any metric.
#[track_caller]
fn assert_honest(metric: &impl Metric<2>, minimum: &Minimum<2>) {
    let energy = Rule::TRAPEZOIDAL.energy(metric, &minimum.sequence);
    assert!((energy / minimum.energy - 1.0).abs() <= 1e-12, "{energy}");
    for value in [minimum.decrement, minimum.residual, minimum.residual_floor] {
        assert!(value >= 0.0, "{minimum:?}");
    }
    assert!(minimum.local_minima.iter().chain([&minimum.energy]).all(|e| e.is_finite()));
    if minimum.stop == Stop::Converged {
        // residual² ≤ 2 N² κ decrement, up to the ends. Here decrements are at most 1e-10, N ≤ 40,
        // and the condition number is κ < 10.
        assert!(minimum.residual < 4e-3, "residual {:e}", minimum.residual);
    }
    if let Curvature::Indefinite { negative } = minimum.curvature {
        assert!(negative > 0);
    }
}

/// Four metrics that are not twice differentiable, or that are so in name only.
macro_rules! scalar_metric {
    ($name:ident, $x:ident => $formula:expr) => {
        struct $name;
        impl Metric<2> for $name {
            fn gram<S: Scalar>(&self, $x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
                SMatrix::from_diagonal_element($formula)
            }
        }
    };
}

// |x₂| is a valley with a kink along the minimising curve, where it has no derivative.
scalar_metric!(Kink, x => x[1].sqr().sqrt() + 1.0);
// This metric jumps by π/2 along lines that cross every curve.
scalar_metric!(Saw, x => ((x[0] * 7.0).tan().atan() + (x[1] * 11.0).tan().atan()) * 0.5 + 2.0);
// To a Newton step this metric looks random.
scalar_metric!(Noise, x => (x[0] * 1e9 + x[1] * 3e9).sin() * 0.5 + 2.0);
// This metric is smooth, with more hills than the grids have points.
scalar_metric!(Hills, x => (x[0] * 100.0).sin() * (x[1] * 77.0).cos() * 0.5 + 1.0);

#[test]
fn searches_on_nasty_metrics_end_within_the_limit_and_are_honest() {
    check_nasty(&Kink);
    check_nasty(&Saw);
    check_nasty(&Noise);
    check_nasty(&Hills);
}

fn check_nasty(metric: &impl Metric<2>) {
    let ball = ball([1.5, 0.1], 0.3);
    let circle = Sphere::new([-1.5, -0.1], 0.4).expect("a radius");
    let all = [
        from_to([-1.0, 0.3], [1.0, -0.2]),
        // These ends lie on the kink.
        from_to([-1.0, 0.0], [1.0, 0.0]),
        between(circle, ball),
    ];
    for ends in &all {
        for n in [1, 2, 7, 40] {
            for limit in [0, 1, 30] {
                let options = Options { iterations: limit, ..Options::default() };
                let minimum =
                    minimise(metric, ends, Rule::TRAPEZOIDAL, n, &options).expect("a metric");
                assert_honest(metric, &minimum);
                // There are at most ten pairs of ends with six starts, or n jumps, and eight
                // minimisers are followed.
                let searches = 10 * (6 + 8) + 8 * minimum.levels.len();
                assert!(minimum.iterations <= searches * (limit + 1), "{}", minimum.iterations);
                if limit == 0 {
                    assert_ne!(minimum.stop, Stop::Converged);
                }
            }
        }
    }
}

/// NaN derivatives reach the frames of the ends and every eigenvalue routine, here for `D = 3`.
#[test]
fn derivatives_that_are_nan_end_the_search() {
    struct Kink;
    impl Metric<3> for Kink {
        fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
            let kink = x[0].sqr().sqrt();
            let (diagonal, off) = (kink + 1.0, kink * 0.25);
            matrix![diagonal, off, off; off, diagonal, off; off, off, diagonal]
        }
    }
    // Every straight start lies in the plane of symmetry x₁ = 0.
    let ball = ball([0.0, 2.0, 0.0], 0.5);
    for ends in [between(point([0.0; 3]), ball), from_to([0.0; 3], [0.0, 1.0, 1.0])] {
        for n in [1, 2, 8, 40] {
            let straight = straight([0.0; 3], [0.0, 1.0, 1.0], n);
            for starts in [Starts::Automatic, Starts::Only(vec![straight])] {
                let options = Options { starts, ..Options::default() };
                let minimum =
                    minimise(&Kink, &ends, Rule::TRAPEZOIDAL, n, &options).expect("values");
                assert!(minimum.energy.is_finite() && minimum.residual >= 0.0);
                // Without derivatives the result claims nothing.
                let blind = minimum.residual == f64::INFINITY;
                assert!(!blind || !minimum.is_local_minimum(), "{minimum:?}");
            }
        }
    }
}
