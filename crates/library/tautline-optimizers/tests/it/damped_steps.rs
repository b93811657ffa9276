//! Tests how many damped steps a search takes from far away.

use tautline_discretizations::Rule;
use tautline_metrics::{
    Metric,
    gallery::{Constant, Shear, TwoChannels},
};
use tautline_optimizers::{Minimum, Stop, minimise};

use crate::setup::{from_to, lowest, only, straight};

/// Searches from the straight line alone.
fn from_the_line(
    metric: &impl Metric<2>,
    rule: Rule,
    [a, b]: [[f64; 2]; 2],
    n: usize,
) -> Minimum<2> {
    minimise(metric, &from_to(a, b), rule, n, &only(straight(a, b, n))).expect("a metric")
}

/// Each bound is less than half of what the search took without lengthening: 200 steps without
/// convergence, 227 and 235 steps. With lengthening it takes 9, 80 and 65.
#[test]
fn steps_that_a_shift_makes_too_short_are_lengthened() {
    let channels = TwoChannels::new(6.0, 1.0, 0.3).expect("widths");
    let across = [[-2.5, -2.0], [2.5, 2.0]];
    let shear = Shear::new(2.0, 3.0).expect("a wave number");
    let diagonal = [[-2.0, -2.0], [2.0, 2.0]];
    for (minimum, most) in [
        (from_the_line(&channels, Rule::TRAPEZOIDAL, across, 64), 100),
        (from_the_line(&channels, Rule::TRAPEZOIDAL, across, 250), 113),
        (from_the_line(&shear, Rule::LEFT_ENDPOINT, diagonal, 250), 117),
    ] {
        assert_eq!(minimum.stop, Stop::Converged);
        assert!(minimum.is_local_minimum(), "{:?}", minimum.curvature);
        assert!(minimum.iterations <= most, "{} steps", minimum.iterations);
    }
}

/// With one start, all steps belong to the result. With more starts, only some of the steps do.
#[test]
fn a_result_counts_the_steps_of_its_own_search() {
    let shear = Shear::new(0.5, 1.0).expect("a wave number");
    let ends = [[-2.0, -2.0], [2.0, 2.0]];
    let alone = from_the_line(&shear, Rule::TRAPEZOIDAL, ends, 250);
    assert_eq!(alone.own_iterations, alone.iterations);
    // There is at least one step on each grid.
    assert!(alone.own_iterations >= alone.levels.len());
    let of_many = lowest(&shear, &from_to(ends[0], ends[1]), Rule::TRAPEZOIDAL, 250);
    assert!(of_many.own_iterations >= of_many.levels.len());
    assert!(of_many.own_iterations < of_many.iterations);
}

/// A straight line is a minimiser of a constant metric, so it is evaluated once on each grid.
#[test]
fn an_evaluation_on_a_grid_counts_as_one_step() {
    let flat = Constant::new([[2.0, 0.5], [0.5, 1.0]].into()).expect("definite");
    for n in [1, 2, 16, 64] {
        let minimum = from_the_line(&flat, Rule::TRAPEZOIDAL, [[0.0, 0.0], [3.0, 1.0]], n);
        assert_eq!((minimum.iterations, minimum.own_iterations), (1, 1), "N = {n}");
    }
}
