//! Metrics that are not twice differentiable: the search ends within its limit and claims nothing.

use nalgebra::{SMatrix, SVector, matrix};
use tautline_discretizations::{PointSequence, Rule, Trapezoidal};
use tautline_metrics::{Metric, Scalar};
use tautline_optimizers::{Curvature, Minimum, Options, Starts, Stop, minimise};
use tautline_sets::{Ball, Ends, Point, Sphere};

fn points<const D: usize>(a: [f64; D], b: [f64; D]) -> Ends<D> {
    Ends::points(a, b).expect("finite")
}

/// What any result must be, whatever the metric.
#[track_caller]
fn assert_honest(metric: &impl Metric<2>, minimum: &Minimum<2>) {
    let energy = Trapezoidal.energy(metric, &minimum.sequence);
    assert!((energy / minimum.energy - 1.0).abs() <= 1e-12, "{energy}");
    for value in [minimum.decrement, minimum.residual, minimum.residual_floor] {
        assert!(value >= 0.0, "{minimum:?}");
    }
    assert!(minimum.local_minima.iter().chain([&minimum.energy]).all(|e| e.is_finite()));
    if minimum.stop == Stop::Converged {
        // No claim without the numbers that go with it: residual² ≤ 2 N² κ decrement, here with
        // decrements up to 1e-10 and N ≤ 40, up to ends and a condition κ < 10.
        assert!(minimum.residual < 4e-3, "residual {:e}", minimum.residual);
    }
    if let Curvature::Indefinite { negative } = minimum.curvature {
        assert!(negative > 0);
    }
}

/// Four metrics that break the law of being twice differentiable, or obey it in name only.
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

// |x₂|: a valley with a kink, on which the curve wants to lie. On it, no derivative.
scalar_metric!(Kink, x => x[1].sqr().sqrt() + 1.0);
// Jumps by π/2 along lines that cross every curve.
scalar_metric!(Saw, x => ((x[0] * 7.0).tan().atan() + (x[1] * 11.0).tan().atan()) * 0.5 + 2.0);
// Random digits of the coordinates, as far as any Newton step is concerned.
scalar_metric!(Noise, x => (x[0] * 1e9 + x[1] * 3e9).sin() * 0.5 + 2.0);
// Smooth, with more hills than the grids have points.
scalar_metric!(Hills, x => (x[0] * 100.0).sin() * (x[1] * 77.0).cos() * 0.5 + 1.0);

#[test]
fn nasty_metrics_end_within_the_limit_and_say_how() {
    check_nasty(&Kink);
    check_nasty(&Saw);
    check_nasty(&Noise);
    check_nasty(&Hills);
}

fn check_nasty(metric: &impl Metric<2>) {
    let ball = Ball::new([1.5, 0.1], 0.3).expect("a radius");
    let circle = Sphere::new([-1.5, -0.1], 0.4).expect("a radius");
    let all = [
        points([-1.0, 0.3], [1.0, -0.2]),
        // On the kink.
        points([-1.0, 0.0], [1.0, 0.0]),
        Ends::new(circle, ball).expect("bounded"),
    ];
    for ends in &all {
        for n in [1, 2, 7, 40] {
            for limit in [0, 1, 30] {
                let options =
                    Options { starts: Starts::Automatic, iterations: limit, ..Options::default() };
                let minimum = minimise(metric, ends, Trapezoidal, n, &options).expect("a metric");
                assert_honest(metric, &minimum);
                // At most ten end pairs with six starts, or n jumps, and then eight followed.
                let searches = 10 * (6 + 8) + 8 * minimum.levels.len();
                assert!(minimum.iterations <= searches * (limit + 1), "{}", minimum.iterations);
                if limit == 0 {
                    assert_ne!(minimum.stop, Stop::Converged);
                }
            }
        }
    }
}

/// NaN derivatives reach the frames of the ends and every eigenvalue routine, in `D = 3` too.
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
    // Symmetric to x₁ = 0, where every straight start lies.
    let origin = Point::new([0.0; 3]).expect("finite");
    let ball = Ball::new([0.0, 2.0, 0.0], 0.5).expect("a radius");
    for ends in [Ends::new(origin, ball).expect("bounded"), points([0.0; 3], [0.0, 1.0, 1.0])] {
        for n in [1, 2, 8, 40] {
            let straight = PointSequence::straight([0.0; 3], [0.0, 1.0, 1.0], n).expect("finite");
            for starts in [Starts::Automatic, Starts::Only(vec![straight])] {
                let options = Options { starts, ..Options::default() };
                let minimum = minimise(&Kink, &ends, Trapezoidal, n, &options).expect("values");
                assert!(minimum.energy.is_finite() && minimum.residual >= 0.0);
                // Without derivatives nothing is known, and nothing is claimed.
                let blind = minimum.residual == f64::INFINITY;
                assert!(!blind || !minimum.is_local_minimum(), "{minimum:?}");
            }
        }
    }
}
