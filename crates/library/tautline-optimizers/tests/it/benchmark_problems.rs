//! Tests problems with known answers, at realistic sizes.
//!
//! The references are closed forms, or the digits on which a boundary value solver and Richardson
//! extrapolation agree.

use std::f64::consts::PI;

use tautline_discretizations::Rule;
use tautline_metrics::{
    Metric,
    gallery::{Bump, CoupledCosines, SineProjections, Sphere, Valleys},
};
use tautline_optimizers::{Curvature, Minimum, Options, Stop, minimise};

use crate::setup::{
    assert_close, ball, between, bump, extrapolated, from_to, half_space, lowest, only, straight,
};

#[track_caller]
fn assert_minimum<const D: usize>(minimum: &Minimum<D>) {
    assert_eq!((minimum.stop, minimum.curvature), (Stop::Converged, Curvature::PositiveDefinite));
    assert!(minimum.decrement <= 1e-18, "decrement {:e}", minimum.decrement);
    // residual² = (N/4) |g|² / (c E), and |g|² ≤ ‖A‖ gᵀA⁻¹g = ‖A‖ 2 E decrement, where ‖A‖ is about
    // 4N c. So residual² is at most 2 N² times the decrement. The floor is a typical size.
    let n = minimum.sequence.n().get() as f64;
    assert!(
        minimum.residual <= 8.0 * minimum.residual_floor + 2.0 * n * minimum.decrement.sqrt(),
        "residual {:e}, floor {:e}",
        minimum.residual,
        minimum.residual_floor
    );
}

#[test]
fn valleys_over_two_ridges() {
    let ends = from_to([0.0, 0.0], [4.0 * PI, 0.0]);
    let minimum = lowest(&Valleys, &ends, Rule::TRAPEZOIDAL, 1000);
    assert_minimum(&minimum);
    // At N = 1000, E_N − d² is −3.2e-3.
    let d2 = 64.0 * PI * PI;
    assert!((minimum.energy - d2 + 3.2e-3).abs() < 1e-4, "{}", minimum.energy - d2);
    assert_close(extrapolated(&minimum), d2, 1e-8);
}

/// From the straight line alone, the search finds the way round the bump. It avoids the geodesic
/// over the bump, which has three times the energy, 64.07.
#[test]
fn the_straight_line_goes_round_the_bump() {
    let bump = bump();
    let ends = from_to([-1.5, 0.05], [1.5, -0.1]);
    let options = only(straight([-1.5, 0.05], [1.5, -0.1], 100));
    for n in [100, 1000] {
        let minimum = minimise(&bump, &ends, Rule::TRAPEZOIDAL, n, &options).expect("ok");
        assert_minimum(&minimum);
        assert!((minimum.energy - 21.858_160_535).abs() < 24.0 / (n as f64).powi(2));
    }
    let minimum = lowest(&bump, &ends, Rule::TRAPEZOIDAL, 1000);
    assert_close(extrapolated(&minimum), 21.858_160_535, 1e-9);
}

#[track_caller]
fn assert_distance<const D: usize>(
    name: &str,
    metric: &impl Metric<D>,
    [from, to]: [[f64; D]; 2],
    d2: f64,
) {
    let minimum = lowest(metric, &from_to(from, to), Rule::TRAPEZOIDAL, 1000);
    assert_minimum(&minimum);
    let error = extrapolated(&minimum) / d2 - 1.0;
    assert!(error.abs() <= 1e-11, "{name}: {error:e}");
}

#[test]
fn distances_in_two_three_and_eight_dimensions() {
    let corner = [3.0, 2.0, -2.0];
    assert_distance("cosines", &CoupledCosines, [[0.0; 3], corner], 32.361_817_823_502_6);
    let sines = SineProjections::benchmark();
    assert_distance("sines", &sines, [[0.0; 8], [1.0; 8]], 8.849_588_854_249);
    // The sphere has no c₁ > 0, so jumps far out would lower the energy without bound. The local
    // minimiser is the great circle.
    assert_distance("sphere", &Sphere, [[-0.8, 0.3], [1.1, 0.6]], 5.278_323_900_279_761);
}

/// The ends are a ball and a half-space on either side of the bump. A search on the axis of
/// symmetry begins at a saddle and must leave it. The ends lie in their sets up to rounding.
#[test]
fn the_saddle_on_the_axis_is_left() {
    let bump = bump();
    let ends = between(ball([-2.0, 0.0], 0.5), half_space([1.0, 0.0], 2.0));
    let axis = straight([-1.5, 0.0], [2.0, 0.0], 100);
    let oblique = straight([-1.6, 0.3], [2.0, 0.3], 100);
    for start in [axis, oblique] {
        let options = only(start);
        let minimum = minimise(&bump, &ends, Rule::TRAPEZOIDAL, 1000, &options).expect("ok");
        assert_minimum(&minimum);
        // The reference is the value of the exactly parametrised problem at N = 1000.
        assert_close(minimum.energy, 17.476_781_885_75, 1e-11);
        let (first, last) = (minimum.sequence.first(), minimum.sequence.last());
        let radius = ((first[0] + 2.0).powi(2) + first[1].powi(2)).sqrt();
        // The allowance is the rounding of coordinates of size 2.
        assert!((radius - 0.5).abs() <= 2.0 * f64::EPSILON, "{:e}", radius - 0.5);
        assert!(last[0] >= 2.0 && last[0] <= 2.0 + 4.0 * f64::EPSILON, "{:e}", last[0] - 2.0);
        assert_close(extrapolated(&minimum), 17.476_778_558, 1e-9);
    }
}

/// The sequence runs straight over the bump, and no step is taken.
#[test]
fn a_saddle_has_a_negative_eigenvalue() {
    let bump = Bump::new(1.0, 0.5).expect("positive");
    let ends = from_to([-2.0, 0.0], [2.0, 0.0]);
    let axis = straight([-2.0, 0.0], [2.0, 0.0], 16);
    let options = Options { iterations: 0, ..only(axis) };
    let minimum = minimise(&bump, &ends, Rule::TRAPEZOIDAL, 16, &options).expect("a metric");
    assert_eq!(minimum.stop, Stop::IterationLimit);
    // Only one direction leads down: it moves all points to one side.
    assert!(matches!(minimum.curvature, Curvature::Indefinite { negative: 1 }), "{minimum:?}");
    assert!(!minimum.is_local_minimum());
}

/// The grids are 16, 63 and 250, and then two more.
#[test]
fn steps_on_all_grids_are_counted() {
    let ends = from_to([0.0, 0.0], [2.0, 1.5]);
    let of = |n| {
        let minimum = lowest(&Valleys, &ends, Rule::TRAPEZOIDAL, n);
        (minimum.levels.len(), minimum.iterations)
    };
    let ((three, few), (five, more)) = (of(250), of(4000));
    assert_eq!((three, five), (3, 5));
    assert!(more >= few + 2, "{few} and {more}");
}
