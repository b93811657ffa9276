//! Tests bad input: every defect has its error, and every search ends.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_discretizations::{LARGEST_N, Rule};
use tautline_metrics::{
    Metric, MetricError, Scalar,
    gallery::{Hyperbolic, Valleys},
};
use tautline_optimizers::{Minimum, Options, SolveError, Starts, minimise};
use tautline_sets::{Ends, FiniteSet};

use crate::setup::{ball, between, euclidean, from_to, lowest, only, point, sequence, straight};

fn error<const D: usize>(metric: &impl Metric<D>, ends: &Ends<D>, n: usize) -> MetricError {
    let error =
        minimise(metric, ends, Rule::TRAPEZOIDAL, n, &Options::default()).expect_err("refused");
    let SolveError::Metric(error) = error else { panic!("{error}") };
    error
}

#[test]
fn no_subinterval_is_refused() {
    let ends = from_to([0.0], [1.0]);
    let result = minimise(&Valleys, &ends, Rule::TRAPEZOIDAL, 0, &Options::default());
    assert_eq!(result, Err(SolveError::NoSubinterval));
    // This check comes first, even if the ends touch.
    let touching = from_to([0.0], [0.0]);
    let result = minimise(&Valleys, &touching, Rule::TRAPEZOIDAL, 0, &Options::default());
    assert_eq!(result.expect_err("refused").to_string(), SolveError::NoSubinterval.to_string());
}

#[test]
fn more_chords_than_rounding_allows_are_refused() {
    fn refused<const D: usize>(to: f64, n: usize) {
        let ends = from_to([0.0; D], [to; D]);
        let too_many = Err(SolveError::TooManySubintervals { n });
        for starts in [Starts::Automatic, Starts::Only(vec![])] {
            let options = Options { starts, ..Options::default() };
            let flat = euclidean::<D>();
            assert_eq!(minimise(&flat, &ends, Rule::TRAPEZOIDAL, n, &options), too_many);
            assert_eq!(minimise(&flat, &ends, Rule::LEFT_ENDPOINT, n, &options), too_many);
        }
    }
    // The points would take 8 to 67 072 bytes each, but none of this memory is requested. Ends that
    // touch need their points too.
    for n in [LARGEST_N + 1, 1_000_000_000, usize::MAX / 8, usize::MAX - 1, usize::MAX] {
        refused::<1>(1.0, n);
        refused::<1>(0.0, n);
        refused::<64>(1.0, n);
        refused::<64>(0.0, n);
    }
    let error = SolveError::TooManySubintervals { n: 1_000_000_000 }.to_string();
    assert!(error.contains("1000000000") && error.contains("67108864"), "{error}");
}

/// The square of a length of 10⁻¹⁷⁰ is 0 in `f64`. The decrement must not become 0/0.
#[test]
fn an_energy_below_the_range_of_f64_is_zero_and_not_nan() {
    for n in [4, 100, 20_000] {
        let ends = from_to([0.0, 0.0], [3e-170, 1e-170]);
        let Minimum { energy, decrement, residual, residual_floor, .. } =
            lowest(&euclidean::<2>(), &ends, Rule::TRAPEZOIDAL, n);
        assert_eq!([energy, decrement, residual, residual_floor], [0.0; 4], "N = {n}");
    }
}

/// `1 + 0 √((x₁ − c)² − w²)`, which is NaN for `|x₁ − c| < w`.
struct Gap {
    c: f64,
    w: f64,
}

impl Metric<2> for Gap {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let root = ((x[0] - self.c).sqr() - self.w * self.w).sqrt();
        SMatrix::from_diagonal_element(root * 0.0 + 1.0)
    }
}

/// With 16 chords a node lies in the gap, with 64 and 256 chords none does. The nodes of the
/// quadrature along the result are at least 0.0197/256 away from its points.
#[test]
fn a_start_refused_on_a_coarse_grid_is_tried_on_the_next() {
    let gap = Gap { c: 8.5 / 16.0, w: 5e-5 };
    let options = only(straight([0.0, 0.0], [1.0, 0.0], 1));
    let solve =
        |n| minimise(&gap, &from_to([0.0, 0.0], [1.0, 0.0]), Rule::TRAPEZOIDAL, n, &options);
    assert!(matches!(solve(16), Err(SolveError::Metric(_))));
    let minimum = solve(256).expect("no node in the gap");
    // The 256 squares of 1/256 are each rounded.
    assert!((minimum.energy - 1.0).abs() < 1e-14 && minimum.is_local_minimum());
    assert_eq!(minimum.levels.iter().map(|level| level.n).collect::<Vec<_>>(), [64, 256]);
}

#[test]
fn no_start_is_an_error() {
    let options = Options { starts: Starts::Only(vec![]), ..Options::default() };
    let result = minimise(&Valleys, &from_to([0.0], [1.0]), Rule::TRAPEZOIDAL, 4, &options);
    assert_eq!(result, Err(SolveError::NoStart));
}

/// Two starts fail for different reasons.
#[test]
fn of_two_failed_starts_the_first_gives_the_error() {
    let through = |y: f64| sequence([[0.0, 0.0], [0.5, y], [1.0, 0.0]].map(SVector::from).to_vec());
    /// This metric is undefined for `|x₂| > ½`.
    struct Lane;
    impl Metric<2> for Lane {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            SMatrix::from_diagonal_element((-x[1].sqr() + 0.25).sqrt() * 0.0 + 1.0)
        }
    }
    for sign in [1.0, -1.0] {
        let starts = Starts::Only(vec![through(2.0 * sign), through(-2.0 * sign)]);
        let options = Options { starts, ..Options::default() };
        let ends = from_to([0.0, 0.0], [1.0, 0.0]);
        match minimise(&Lane, &ends, Rule::TRAPEZOIDAL, 4, &options) {
            Err(SolveError::Metric(MetricError::NotFinite { point, .. })) => {
                assert!(point[1] * sign > 0.5, "{point:?}");
            }
            other => panic!("{other:?}"),
        }
    }
}

/// `1 + √(1 − x₁²)`, which is NaN for `|x₁| > 1`, whatever `x₂` is.
struct Gorge;

impl Metric<2> for Gorge {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element((-x[0].sqr() + 1.0).sqrt() + 1.0)
    }
}

#[test]
fn a_metric_that_is_nan_along_the_way_is_an_error() {
    for n in [1, 2, 9, 100] {
        // Either one end is in the undefined region, or the region lies between the ends.
        for ends in [from_to([0.0, 0.0], [1.5, 0.0]), from_to([0.0, 1.0], [9.0, 0.0])] {
            let MetricError::NotFinite { point, entry, .. } = error(&Gorge, &ends, n) else {
                panic!("NaN is not finite");
            };
            assert!(entry.is_nan() && point[0] > 1.0, "{point:?}");
        }
    }
    let inside = from_to([-0.9, 0.0], [0.9, 0.5]);
    assert!(lowest(&Gorge, &inside, Rule::TRAPEZOIDAL, 64).is_local_minimum());
}

/// A start across the hole is refused, while one around it is not.
#[test]
fn the_search_goes_round_a_hole_in_the_metric() {
    /// The cost is infinite at the rim of the unit disc and NaN inside.
    struct Hole;
    impl Metric<2> for Hole {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let r2 = x[0].sqr() + x[1].sqr();
            SMatrix::from_diagonal_element((r2 - 1.0).sqrt().recip() + 1.0)
        }
    }
    let ends = from_to([-3.0, 0.1], [3.0, -0.1]);
    let options = only(straight([-3.0, 0.1], [3.0, -0.1], 30));
    // On its own the straight line fails; together with the bent ones it does no harm.
    assert!(minimise(&Hole, &ends, Rule::TRAPEZOIDAL, 30, &options).is_err());
    let minimum = lowest(&Hole, &ends, Rule::TRAPEZOIDAL, 200);
    assert!(minimum.is_local_minimum());
    assert!(minimum.sequence.points().iter().all(|x| x.norm() > 1.0));
}

/// A constant matrix, not necessarily a metric.
struct Matrix([[f64; 2]; 2]);

impl Metric<2> for Matrix {
    fn gram<S: Scalar>(&self, _: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_fn(|i, j| S::constant(self.0[i][j]))
    }
}

#[test]
fn matrices_that_are_not_metrics_are_errors() {
    let ends = from_to([0.0, 0.0], [1.0, 1.0]);
    for n in [1, 5, 80] {
        let refused = |h| error(&Matrix(h), &ends, n);
        assert!(matches!(
            refused([[1.0, 0.25], [0.5, 1.0]]),
            MetricError::NotSymmetric { row: 0, column: 1, above: 0.25, below: 0.5, .. }
        ));
        assert!(matches!(
            refused([[f64::INFINITY, 0.0], [0.0, 1.0]]),
            MetricError::NotFinite { row: 0, column: 0, .. }
        ));
        for (h, least) in [
            ([[1.0, 2.0], [2.0, 1.0]], -1.0),
            ([[-1.0, 0.0], [0.0, -1.0]], -1.0),
            ([[1.0, 1.0], [1.0, 1.0]], 0.0),
            ([[0.0, 0.0], [0.0, 0.0]], 0.0),
        ] {
            let MetricError::NotPositiveDefinite { eigenvalue, .. } = refused(h) else {
                panic!("{h:?}");
            };
            assert!((eigenvalue - least).abs() < 1e-15, "{eigenvalue}");
        }
    }
}

/// The identity, except in a strip about `x₁ = ½` in which the lower triangle differs. The strip is
/// narrower than the chords of a coarse grid. The search itself reads only the upper triangle.
struct Strip;

impl Metric<2> for Strip {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let strip = (-((x[0] - 0.5) * 4500.0).sqr()).exp();
        matrix![S::one(), S::zero(); strip, S::one()]
    }
}

#[test]
fn a_defect_that_only_the_fine_grid_meets_is_an_error() {
    let ends = from_to([0.0, 0.0], [1.0, 0.0]);
    // The nearest nodes are 1/32 away from the strip, and the nearest points of the quadrature
    // 0.0197/16. There the difference is e^(−30).
    assert!(lowest(&Strip, &ends, Rule::TRAPEZOIDAL, 16).is_local_minimum());
    let MetricError::NotSymmetric { point, above, .. } = error(&Strip, &ends, 1024) else {
        panic!("finite and definite");
    };
    assert!((point[0] - 0.5).abs() < 0.02 && above == 0.0, "{point:?}");
}

/// `diag(1, ½ + cos x₁)`, which is indefinite for `x₁` between `2π/3` and `4π/3`.
struct Flip;

impl Metric<2> for Flip {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal(&vector![S::one(), x[0].cos() + 0.5])
    }
}

#[test]
fn a_metric_that_is_indefinite_along_the_way_is_an_error() {
    for n in [2, 9, 64] {
        let across = from_to([1.5, 0.0], [5.0, 0.3]);
        let MetricError::NotPositiveDefinite { point, eigenvalue } = error(&Flip, &across, n)
        else {
            panic!("the straight line crosses the strip");
        };
        assert!(eigenvalue <= 0.0 && (2.0..4.2).contains(&point[0]), "{point:?} {eigenvalue}");
    }
    // Away from the strip the matrix is a metric, and the search stays there.
    let aside = from_to([-1.9, 0.0], [1.9, 2.0]);
    let minimum = lowest(&Flip, &aside, Rule::TRAPEZOIDAL, 100);
    assert!(minimum.sequence.points().iter().all(|x| x[0].cos() > -0.5));
}

#[test]
fn points_outside_the_hyperbolic_disc_are_errors() {
    for (a, b) in [([2.0, 0.0], [3.0, 0.0]), ([0.0, 0.0], [1.5, 0.0]), ([0.3, 0.0], [0.0, -1.2])] {
        for n in [1, 2, 33] {
            for ends in [from_to(a, b), from_to(b, a)] {
                let error = error(&Hyperbolic, &ends, n);
                let MetricError::NotFinite { point, .. } = error else { panic!("{error}") };
                assert!(vector![point[0], point[1]].norm() > 1.0, "{point:?}");
                // The left-endpoint rule does not evaluate the metric at the last point.
                let left =
                    minimise(&Hyperbolic, &ends, Rule::LEFT_ENDPOINT, n, &Options::default());
                assert!(matches!(left, Err(SolveError::Metric(MetricError::NotFinite { .. }))));
            }
        }
    }
    // Here the ends touch where the metric is undefined.
    let touching = from_to([2.0, 0.0], [2.0, 0.0]);
    assert!(matches!(error(&Hyperbolic, &touching, 3), MetricError::NotFinite { .. }));
    // Here one end lies on the rim, where the metric is infinite.
    assert!(matches!(
        error(&Hyperbolic, &from_to([0.0, 0.0], [1.0, 0.0]), 4),
        MetricError::NotFinite { .. }
    ));
}

/// The members of a finite set outside the disc are ignored, and so is the part of a ball beyond
/// the rim of the disc.
#[test]
fn the_part_of_a_set_with_a_metric_is_used() {
    let set = FiniteSet::new([[3.0, 0.0], [0.0, 0.5], [0.0, -2.0]]).expect("finite");
    let origin = point([0.0, 0.0]);
    let minimum = lowest(&Hyperbolic, &between(origin.clone(), set), Rule::TRAPEZOIDAL, 64);
    assert!(minimum.is_local_minimum());
    assert_eq!(*minimum.sequence.last(), vector![0.0, 0.5]);
    let ends = between(origin, ball([1.0, 0.0], 0.5));
    let minimum = lowest(&Hyperbolic, &ends, Rule::TRAPEZOIDAL, 64);
    assert!(minimum.is_local_minimum());
    assert!((minimum.sequence.last() - vector![0.5, 0.0]).norm() < 1e-9);
}
