//! Shortest paths along a lattice.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::PointSequence;
use tautline_formula::{Formula, Prepared};
use tautline_grid::{GraphPathError, Lattice, graph_path, path_round};
use tautline_metrics::{Metric, Scalar, gallery::Constant};
use tautline_sets::{AnyEnds, Ball, Ends, HalfSpace};

fn euclidean<const D: usize>() -> Constant<D> {
    Constant::new(SMatrix::identity()).expect("positive definite")
}

fn length<const D: usize>(path: &PointSequence<D>) -> f64 {
    path.chords().map(|(_, d)| d.norm()).sum()
}

/// Returns the largest relative excess of the length of a path along the lattice over the straight line,
/// for many directions.
fn excess<const D: usize>(ends: impl Fn(usize) -> SVector<f64, D>) -> f64 {
    let metric = Prepared::new(euclidean::<D>());
    let side = SVector::from_element(12.0);
    let lattice = Lattice::new(-side, side, 1.0).expect("a lattice");
    let of = |k| {
        let end = ends(k).map(f64::round);
        let ends = Ends::points(SVector::zeros(), end).expect("finite");
        let path = graph_path(&metric, &ends, &lattice, 50).expect("a path");
        assert_eq!((*path.first(), *path.last()), (SVector::zeros(), end));
        length(&path) / end.norm() - 1.0
    };
    (0..40).map(of).fold(0.0, f64::max)
}

/// Between neighbouring directions at the angle `α` the excess is at most `1/cos(α/2) − 1`: with the
/// angles atan ½ and atan ½ − π/4 of the sixteen directions in the plane it is 2.75 %, of both.
#[test]
fn a_path_in_the_plane_is_too_long_by_less_than_three_per_cent() {
    let circle = |k: usize| {
        let (sin, cos) = (k as f64 * 0.37).sin_cos();
        SVector::from([12.0 * cos, 12.0 * sin])
    };
    let worst = (0.5 * 0.5_f64.atan()).cos().recip() - 1.0;
    let found = excess(circle);
    assert!(found <= worst + 1e-12 && found > 0.5 * worst, "{found} beside {worst}");
}

/// The twenty-six directions in space: the worst direction is the middle of a triangle of them.
#[test]
fn a_path_in_space_is_too_long_by_less_than_thirteen_per_cent() {
    let sphere = |k: usize| {
        let z = 2.0 * (k as f64 * 0.618_034).fract() - 1.0;
        let (sin, cos) = (k as f64 * 2.4).sin_cos();
        let r = (1.0 - z * z).sqrt();
        SVector::from([11.0 * r * cos, 11.0 * r * sin, 11.0 * z])
    };
    // d = (a, b, c) with a ≥ b ≥ c ≥ 0 takes c steps √3, b − c steps √2 and a − b steps 1. By
    // Cauchy–Schwarz the largest quotient by |d| is the norm of (1, √2 − 1, √3 − √2).
    let worst = (1.0 + (2_f64.sqrt() - 1.0).powi(2) + (3_f64.sqrt() - 2_f64.sqrt()).powi(2)).sqrt();
    let found = excess(sphere);
    assert!(found <= worst - 1.0 + 1e-12 && found > 0.05, "{found} beside {worst}");
}

#[test]
fn a_path_joins_sets_at_points_of_theirs() {
    let ball = Ball::new([0.0, 0.0], 1.0).expect("a ball");
    let wall = HalfSpace::at_least([1.0, 0.0], 3.1).expect("a wall");
    let ends = Ends::new(ball, wall).expect("bounded");
    let lattice = Lattice::new([-4.0, -4.0], [4.0, 4.0], 0.5).expect("a lattice");
    let path = graph_path(&Prepared::new(euclidean::<2>()), &ends, &lattice, 8).expect("a path");
    assert!(path.first().norm() <= 1.0 + 1e-15 && path.last()[0] >= 3.1);
    // The nodes (1, 0) to (3.5, 0) are in the sets: the path may end at a node inside.
    assert!((length(&path) - 2.1).abs() <= 0.41, "{}", length(&path));
    let far = Lattice::new([10.0, 10.0], [12.0, 12.0], 0.5).expect("a lattice");
    let error = graph_path(&Prepared::new(euclidean::<2>()), &ends, &far, 8);
    assert_eq!(error, Err(GraphPathError::FarFromEnd { end: "first" }));
}

/// The cost `1 + x₁`, whose length from 0 is `x + x²/2`. The mean of both ends of an edge is exact.
#[test]
fn chords_have_equal_lengths_under_the_metric() {
    struct Rising;
    impl Metric<1> for Rising {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            SMatrix::from_diagonal_element((x[0] + 1.0).sqr())
        }
    }
    let (spacing, n) = (1.0 / 64.0, 10);
    let lattice = Lattice::new([0.0], [2.0], spacing).expect("a lattice");
    let ends = Ends::points([0.0], [2.0]).expect("finite");
    let path = graph_path(&Prepared::new(&Rising), &ends, &lattice, n).expect("a path");
    for (k, x) in path.points().iter().enumerate() {
        // Steps of two edges are taken, between whose ends the length is linear: off by (2h)²/8.
        let length = x[0] + x[0] * x[0] / 2.0;
        assert!((length - 4.0 * k as f64 / n as f64).abs() <= 0.5 * spacing * spacing + 1e-14);
    }
    let refused = graph_path(&Prepared::new(&Rising), &ends, &lattice, 1 << 40);
    assert_eq!(refused, Err(GraphPathError::Chords { n: 1 << 40 }));
}

/// `1/x₁` is negative on the left, where there is no metric.
#[test]
fn nodes_without_a_metric_are_left_out() {
    struct Half;
    impl Metric<2> for Half {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            SMatrix::from_diagonal_element(x[0].recip())
        }
    }
    let between = |a: [f64; 2], b: [f64; 2]| {
        let lattice = Lattice::new([-2.0, 0.0], [2.0, 2.0], 0.25).expect("a lattice");
        graph_path(&Prepared::new(&Half), &Ends::points(a, b).expect("finite"), &lattice, 20)
    };
    let path = between([0.5, 0.0], [0.5, 2.0]).expect("a path");
    assert!(path.points().iter().all(|x| x[0] > 0.0));
    assert_eq!(between([-1.5, 0.0], [0.5, 0.0]), Err(GraphPathError::FarFromEnd { end: "first" }));
}

#[test]
fn axes_may_have_spacings_of_their_own() {
    let metric = Prepared::new(euclidean::<2>());
    let lattice = Lattice::with_spacings([0.0, 0.0], [100.0, 1.0], [10.0, 0.1]).expect("a lattice");
    assert_eq!(lattice.nodes(), 11 * 11);
    let ends = Ends::points([0.0, 0.0], [100.0, 1.0]).expect("finite");
    let path = graph_path(&metric, &ends, &lattice, 7).expect("a path");
    assert!((length(&path) - 10_001_f64.sqrt()).abs() < 1e-9);
}

/// A wall that ends far above the ends is passed round on the larger lattice. Whatever its place between the
/// nodes, the path does not leap over it: it is thicker than 1/2048 of the way.
#[test]
fn a_path_goes_round_a_thin_wall() {
    for height in [1.0, 2.0, 7.0] {
        for place in [0.0, 0.013, 0.05, 0.31, 0.777, 1.234] {
            let wall = format!("((x1 - {place})/0.00102)^2 + exp(20*(x2 - {height})) - 1");
            let metric = format!("(1 + 0*ln({wall})) I");
            let metric = Prepared::new(Formula::<2>::parse(&metric, &[]).expect("a formula"));
            let ends = AnyEnds::points(&[-2.0, 0.0], &[2.0, 0.0]).expect("finite");
            let path = path_round(&metric, &ends, 64).expect("a path");
            // Above the wall, or below the lattice.
            let points: Vec<&[f64]> = path.coordinates().chunks(2).collect();
            let crossing = points.windows(2).find(|x| x[0][0] <= place && x[1][0] >= place);
            let crossing = crossing.expect("from left to right");
            let above = crossing.iter().map(|x| x[1]).fold(f64::NEG_INFINITY, f64::max);
            assert!(above > height - 0.2, "{height} {place}: {above}");
        }
    }
    // A closed wall.
    let closed = Formula::<2>::parse("(1 + 0*ln((x1/0.00102)^2 - 1)) I", &[]).expect("a formula");
    let ends = AnyEnds::points(&[-2.0, 0.0], &[2.0, 0.0]).expect("finite");
    assert_eq!(path_round(&Prepared::new(closed), &ends, 64), None);
}
