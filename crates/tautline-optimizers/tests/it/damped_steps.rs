//! How many damped steps a search takes from far away.

use tautline_discretizations::{LeftEndpoint, PointSequence, Rule, Trapezoidal};
use tautline_metrics::{
    Metric,
    gallery::{Constant, Shear, TwoChannels},
};
use tautline_optimizers::{Minimum, Options, Starts, Stop, minimise};
use tautline_sets::Ends;

/// The search from the straight line alone.
fn straight(
    metric: &impl Metric<2>,
    rule: impl Rule,
    [a, b]: [[f64; 2]; 2],
    n: usize,
) -> Minimum<2> {
    let line = PointSequence::straight(a, b, n).expect("finite");
    let options = Options { starts: Starts::Only(vec![line]), ..Options::default() };
    minimise(metric, &Ends::points(a, b).expect("finite"), rule, n, &options).expect("a metric")
}

/// Each bound is less than half of what the search took when it accepted every step of a shifted
/// Hessian as it was: 200 steps without arriving, 227 and 235. With steps that are lengthened it
/// takes 9, 80 and 65.
#[test]
fn steps_that_a_shift_makes_too_short_are_lengthened() {
    let channels = TwoChannels::new(6.0, 1.0, 0.3).expect("widths");
    let across = [[-2.5, -2.0], [2.5, 2.0]];
    let shear = Shear::new(2.0, 3.0).expect("a wave number");
    let diagonal = [[-2.0, -2.0], [2.0, 2.0]];
    for (minimum, most) in [
        (straight(&channels, Trapezoidal, across, 64), 100),
        (straight(&channels, Trapezoidal, across, 250), 113),
        (straight(&shear, LeftEndpoint, diagonal, 250), 117),
    ] {
        assert_eq!(minimum.stop, Stop::Converged);
        assert!(minimum.is_local_minimum(), "{:?}", minimum.curvature);
        assert!(minimum.iterations <= most, "{} steps", minimum.iterations);
    }
}

/// One start, one search: all steps are its own. With more starts they are a part of all.
#[test]
fn a_result_tells_the_steps_of_its_own_search() {
    let shear = Shear::new(0.5, 1.0).expect("a wave number");
    let ends = [[-2.0, -2.0], [2.0, 2.0]];
    let alone = straight(&shear, Trapezoidal, ends, 250);
    assert_eq!(alone.own_iterations, alone.iterations);
    // At least one on each grid.
    assert!(alone.own_iterations >= alone.levels.len());
    let points = Ends::points(ends[0], ends[1]).expect("finite");
    let of_many = minimise(&shear, &points, Trapezoidal, 250, &Options::default());
    let of_many = of_many.expect("a metric");
    assert!(of_many.own_iterations >= of_many.levels.len());
    assert!(of_many.own_iterations < of_many.iterations);
}

/// A straight line under a constant metric is a minimiser as it stands: one look at each grid, which
/// counts, and no more.
#[test]
fn a_look_at_a_grid_counts_as_one_step() {
    let flat = Constant::new([[2.0, 0.5], [0.5, 1.0]].into()).expect("definite");
    for n in [1, 2, 16, 64] {
        let minimum = straight(&flat, Trapezoidal, [[0.0, 0.0], [3.0, 1.0]], n);
        assert_eq!((minimum.iterations, minimum.own_iterations), (1, 1), "N = {n}");
    }
}
