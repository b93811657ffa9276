//! Paths that descend the distances of fast marching.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{Random, cases, seed};
use tautline_grid::{Eikonal, EikonalPath, Lattice, Order, eikonal, graph};
use tautline_metrics::{
    KnownDistance, Metric, Scalar,
    gallery::{Constant, Ramp, Separable, Shear, Swirl, TwoChannels},
};
use tautline_sets::{Ball, Ends, HalfSpace, Point, Union};

use crate::orders::slope;

fn square(spacing: f64) -> Lattice<2> {
    Lattice::new([-1.5, -1.5], [1.5, 1.5], spacing).expect("a lattice")
}

/// Returns the slope of the error of the length of a path, with bands of chords whose width is as
/// `h^exponent`.
fn order_of_length<M: Metric<2>>(metric: &M, ends: &Ends<2>, exact: f64, exponent: f64) -> f64 {
    let errors = [8.0, 16.0, 32.0, 64.0, 128.0].map(|n: f64| {
        let equation = Eikonal::new(metric, &square(1.0 / n)).expect("stencils");
        let steps = 3.0 * (n / 8.0).powf(1.0 - exponent);
        let equation = equation.with_band(steps).expect("steps");
        let distances = equation.distances_from(&**ends.first(), Order::Second).expect("seeds");
        let path = distances.path_to(&**ends.second()).expect("a path");
        (1.0 / n, (path.length() - exact).abs())
    });
    slope(&errors)
}

/// The direction of a path is off by the error of the gradient, which is of first order at least, and its
/// length by the square; the chords of half a step by the square of theirs. The geodesics are spirals from
/// discs that the swirls map to themselves.
#[test]
fn the_length_of_a_path_from_a_smooth_set_converges_with_the_second_order() {
    let cases = [(1.0, 0.7, 0.37, [0.83, 0.47]), (-2.0, 0.5, 0.31, [-0.2, 1.1])];
    for (angle, width, r, end) in cases {
        let swirl = Swirl::new(angle, width).expect("a swirl");
        let disc = Ball::new([0.0, 0.0], r).expect("a disc");
        let ends = Ends::new(disc, Point::new(end).expect("finite")).expect("bounded");
        let order = order_of_length(&swirl, &ends, end[0].hypot(end[1]) - r, 1.0);
        assert!(order > 1.8, "{angle} {order}");
    }
}

/// Steps of second order keep to the geodesic up to the square of the spacing, as the gradients between the
/// nodes do; a step along the gradient at its begin alone would leave it by a multiple of the spacing. The
/// length does not tell, since it sees the square of the direction. In the coordinates of `Φ` the geodesic is
/// a ray from the origin.
#[test]
fn a_path_from_a_smooth_set_keeps_to_the_geodesic_with_the_second_order() {
    let cases = [(1.0, 0.7, 0.37, [0.83, 0.47]), (-2.0, 0.5, 0.31, [-0.2, 1.1])];
    for (angle, width, r, end) in cases {
        let swirl = Swirl::new(angle, width).expect("a swirl");
        let disc = Ball::new([0.0, 0.0], r).expect("a disc");
        let ends = Ends::new(disc, Point::new(end).expect("finite")).expect("bounded");
        let across = swirl.flatten(&SVector::from(end)).normalize();
        let errors = [16.0, 32.0, 64.0, 128.0].map(|n: f64| {
            let path = eikonal(&swirl, &ends, &square(1.0 / n), Order::Second).expect("a path");
            let off =
                path.corners().iter().map(|corner| swirl.flatten(&corner.1).perp(&across).abs());
            (1.0 / n, off.fold(0.0, f64::max))
        });
        assert!(slope(&errors) > 1.6, "{angle} {errors:?}");
    }
}

/// The gradient of an error `h g(θ)` is as `h/r` at the distance `r` from a point. Its square, integrated
/// from the width `b` of the band, is as `h²/b`, and a chord of the length `b` is off by `b³`: the order is
/// 3/2 with `b ~ h^{1/2}`.
#[test]
fn the_length_of_a_path_from_a_point_converges_with_a_wider_band() {
    let orders = |a: [f64; 2], b: [f64; 2]| {
        let ends = Ends::points(a, b).expect("finite");
        fn of<M: KnownDistance<2>>(metric: &M, ends: &Ends<2>, a: [f64; 2], b: [f64; 2]) -> f64 {
            let exact = metric.distance(&a.into(), &b.into()).expect("it is known");
            order_of_length(metric, ends, exact, 0.5)
        }
        let swirl = Swirl::new(1.0, 0.7).expect("a swirl");
        let shear = Shear::new(0.5, 1.0).expect("a shear");
        [of(&swirl, &ends, a, b), of(&shear, &ends, a, b)]
    };
    let orders = [orders([-0.9, -0.31], [0.83, 0.47]), orders([-1.1, -0.7], [0.9, 0.2])].concat();
    assert!(orders.iter().all(|&order| order > 1.3), "{orders:?}");
}

/// Both discs are mapped to themselves and to a disc of the same radius only if they are about the origin,
/// so that the distance of the two is `R − r` in the first case. The other set is the outside of a disc,
/// as four half-spaces that touch it: they are nearest where they touch.
#[test]
fn a_path_joins_two_sets_at_their_distance() {
    let swirl = Swirl::new(1.0, 0.7).expect("a swirl");
    let disc = Ball::new([0.0, 0.0], 0.37).expect("a disc");
    let walls = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.6, 0.8]];
    let walls =
        walls.map(|n| std::sync::Arc::new(HalfSpace::at_least(n, 1.2).expect("a wall")) as _);
    let ends = Ends::new(disc, Union::new(walls.to_vec()).expect("walls")).expect("bounded");
    let errors = [16.0, 32.0, 64.0, 128.0].map(|n: f64| {
        let path = eikonal(&swirl, &ends, &square(1.0 / n), Order::Second).expect("a path");
        let sequence = path.sequence(40).expect("chords");
        assert!(sequence.first().norm() <= 0.37 + 1e-15);
        let end = sequence.last();
        assert!((ends.second().project(end) - end).norm() < 1e-15, "{end}");
        // Differences of second order are off by `h²/3` times the third derivatives of the distance |x|,
        // which are 3/r² at most; along the way from 0.37 to 1.2 these add up to 6.
        assert!((path.distance() - 0.83).abs() < 2.0 / n / n, "{n} {}", path.distance());
        (1.0 / n, (path.length() - 0.83).abs())
    });
    assert!(slope(&errors) > 1.8, "{errors:?}");
}

/// The Euclidean metric outside of a disc of radius ½.
struct Hole;

impl Metric<2> for Hole {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let outside = x[0].sqr() + x[1].sqr() - 0.25;
        SMatrix::from_diagonal_element(outside.sqrt() * 0.0 + 1.0)
    }
}

/// From `(−1, 0)` to `(1, 0)` two tangents of length `√¾` and an arc of `π − 2 arccos ½` at the radius ½.
/// Both ways round are equally long, and no gradient points to one of them. The nodes outside keep within
/// a few steps of the disc, which lengthens both the distance and the path by as many steps at most. From
/// a point, the march of first order is off by a multiple of `h log 1/h`.
#[test]
fn a_path_leads_round_nodes_without_a_metric() {
    let exact = 3_f64.sqrt() + 0.5 * (std::f64::consts::PI - 2.0 * 0.5_f64.acos());
    let ends = Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite");
    for n in [10.0, 20.0, 40.0, 80.0] {
        for order in [Order::First, Order::Second] {
            let path = eikonal(&Hole, &ends, &square(1.0 / n), order).expect("a path");
            let corners = path.corners();
            // A chord of one diagonal step may cut the disc by an eighth of the square of its length.
            let inner = 0.5 - 0.25 / n / n;
            assert!(corners.iter().all(|corner| corner.1.norm() >= inner));
            let most = if order == Order::First { 1.5 * n.ln() } else { 3.0 };
            for found in [path.length(), path.distance()] {
                let steps = (found - exact) * n;
                assert!((0.0..most).contains(&steps), "{n} {order:?} {found}");
            }
        }
    }
}

/// Two paths of a different kind: a graph of reach 4, whose factor is 1.0076, has edges of 0.17 at most,
/// along which costs that change within 0.3 are off by `(0.17/0.3)²/12 < 0.03` of the mean of both ends. The
/// chord of a path, of 0.09, is off by about `(0.09/0.3)² ≈ 0.1` of itself, and the distance from a point
/// by about one step of 0.03 at the highest cost, which is `√5`.
#[test]
fn no_path_is_much_longer_than_one_along_a_graph() {
    let channels = TwoChannels::new(4.0, 0.7, 0.3).expect("channels");
    let lattice = square(0.03);
    let mut random = Random(seed(32));
    for case in 0..cases(12) {
        // Nodes, so that the graph begins and ends there.
        let mut node = || lattice.point(random.bits() as usize % lattice.nodes());
        let ends = Ends::points(node(), node()).expect("finite");
        let path = eikonal(&channels, &ends, &lattice, Order::Second).expect("a path");
        let along = graph(&channels, &ends, &lattice, 4, None).expect("a path").length();
        assert!(path.length() <= 1.03 * along + 0.01, "{case} {} {along}", path.length());
        assert!(path.length() >= along / 1.0076 / 1.03 - 0.01, "{case} {} {along}", path.length());
        let consistent = (path.length() - path.distance()).abs();
        assert!(consistent <= 0.03 * 5_f64.sqrt(), "{case} {consistent}");
    }
}

/// On the line the distance from a ball is that of the ramp, and in space the geodesics are images of
/// straight lines. There, differences of second order are off by `h²/3` times third derivatives up to `3/r²`
/// of the distance from the point, along the way from `3h`: less than `h/3`. The square of such an error in
/// the direction, and chords of half a step, make the length wrong by less than `h²`.
#[test]
fn paths_on_the_line_and_in_space_converge() {
    let ramp = Ramp::new(0.5, 1.0).expect("a ramp");
    let ball = Ball::new([-0.7], 0.2).expect("a ball");
    let ends = Ends::new(ball, Point::new([0.93]).expect("finite")).expect("bounded");
    let exact = ramp.distance(&[-0.5].into(), &[0.93].into()).expect("it is known");
    let errors = [10.0, 20.0, 40.0, 80.0].map(|n: f64| {
        let lattice = Lattice::new([-1.0], [1.0], 1.0 / n).expect("a lattice");
        let path = eikonal(&ramp, &ends, &lattice, Order::Second).expect("a path");
        (1.0 / n, (path.length() - exact).abs())
    });
    assert!(slope(&errors) > 1.8, "{errors:?}");

    let waves = Separable::<3>::new([0.3, 0.2, 0.2], [1.0, 2.0, 1.5]).expect("waves");
    let (a, b) = ([-0.6, -0.5, -0.4], [0.7, 0.3, 0.6]);
    let ends = Ends::points(a, b).expect("finite");
    let exact = waves.distance(&a.into(), &b.into()).expect("it is known");
    for h in [1.0 / 8.0, 1.0 / 12.0, 1.0 / 16.0, 1.0 / 24.0] {
        let lattice = Lattice::new([-0.9; 3], [0.9; 3], h).expect("a lattice");
        let path = eikonal(&waves, &ends, &lattice, Order::Second).expect("a path");
        let [distance, length] = [path.distance() - exact, path.length() - exact];
        assert!(distance.abs() < h / 3.0 && length.abs() < h * h, "{h} {distance} {length}");
    }
}

/// All nodes are in the first set.
#[test]
fn a_set_may_hold_the_lattice() {
    let shear = Shear::new(0.5, 1.0).expect("a shear");
    let all = Ball::new([0.0, 0.0], 9.0).expect("a ball");
    let ends = Ends::new(all, Point::new([0.3, 0.2]).expect("finite")).expect("bounded");
    let path = eikonal(&shear, &ends, &square(0.5), Order::Second).expect("a path");
    assert_eq!((path.distance(), path.length()), (0.0, 0.0));
    assert_eq!(*path.sequence(2).expect("chords").last(), SVector::from([0.3, 0.2]));
}

/// Returns the corners of a path, which are in order and as long as they say.
fn check<M: Metric<2>>(metric: &M, path: &EikonalPath<2>) {
    for pair in path.corners().windows(2) {
        let d = pair[1].1 - pair[0].1;
        let h = metric.gram(&((pair[0].1 + pair[1].1) * 0.5));
        // A few roundings of a length below 5.
        assert!((pair[1].0 - pair[0].0 - d.dot(&(h * d)).sqrt()).abs() < 1e-14);
    }
}

/// Sets that overlap, a second set that reaches into the band around the first, and one beyond it.
#[test]
fn a_path_may_be_short() {
    let shear = Shear::new(0.5, 1.0).expect("a shear");
    let disc = Ball::new([0.0, 0.0], 0.5).expect("a disc");
    for x in [0.2, 0.5, 0.52, 0.7, 0.9] {
        let ends = Ends::new(disc.clone(), Point::new([x, 0.0]).expect("finite")).expect("bounded");
        let path = eikonal(&shear, &ends, &square(0.1), Order::Second).expect("a path");
        check(&shear, &path);
        // Φ maps the segment from the nearest point of the disc to a chord that is not longer than that
        // along x₁, and all chords are at least √c₁ = (√(1 + 1/16) − ¼) ≥ 0.78 times as long as in ℓ.
        let away = (x - 0.5_f64).max(0.0);
        assert!(path.length() <= away + 1e-3 && path.length() >= 0.78 * away, "{x}");
        assert!((path.distance() - path.length()).abs() <= 1e-2 * away, "{x}");
        assert_eq!(path.sequence(3).expect("chords").n().get(), 3);
    }
}

/// Values between the nodes of a distance that is linear are exact up to rounding, inside the band and
/// beyond, and there are none outside of the box.
#[test]
fn distances_are_interpolated_in_the_box_alone() {
    let flat = Constant::<2>::new(SMatrix::identity() * 4.0).expect("positive");
    let wall = HalfSpace::new([1.0, 0.0], -1.0).expect("a wall");
    let lattice = square(0.25);
    let equation = Eikonal::new(&flat, &lattice).expect("stencils");
    for order in [Order::First, Order::Second] {
        let distances = equation.distances_from(&wall, order).expect("seeds");
        for x in [-1.2, -1.0, -0.9, -0.3, 0.1, 0.77, 1.5] {
            let found = distances.at(&[x, 0.3].into()).expect("in the box");
            assert!((found - 2.0 * (x + 1.0_f64).max(0.0)).abs() < 1e-12, "{x} {found}");
        }
        assert_eq!(distances.at(&[1.6, 0.0].into()), None);
        assert_eq!(distances.at(&[f64::NAN, 0.0].into()), None);
    }
}

/// The gradient of a linear distance is the same at every node, also at the last ones on each side, where there
/// is a neighbour on one side only.
#[test]
fn the_gradient_of_a_linear_distance_is_constant_up_to_the_boundary() {
    let flat = Constant::<2>::new(SMatrix::identity() * 4.0).expect("positive");
    let lattice = square(0.25);
    let equation = Eikonal::new(&flat, &lattice).expect("stencils");
    for normal in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
        let (wall, normal) = (HalfSpace::new(normal, -1.0).expect("a wall"), SVector::from(normal));
        let distances = equation.distances_from(&wall, Order::Second).expect("seeds");
        let beyond = (0..lattice.nodes()).filter(|&n| normal.dot(&lattice.point(n)) > -0.6);
        let mut count = 0;
        for node in beyond {
            let gradient = distances.gradient(node).expect("reached");
            assert!((gradient - normal * 2.0).norm() < 1e-12, "{} {gradient}", lattice.point(node));
            count += 1;
        }
        assert_eq!(count, 9 * 13);
    }
}

/// The point of a disc that is nearest to a wall is none of those that are nearest to nodes. The distance is
/// linear, so that the descent along the disc finds it up to its last step and the rounding of values.
#[test]
fn the_nearest_point_of_a_disc_lies_between_those_of_nodes() {
    let flat = Constant::<2>::new(SMatrix::identity() * 4.0).expect("positive");
    let wall = HalfSpace::new([1.0, 0.0], -1.0).expect("a wall");
    let disc = Ball::new([0.77, 0.31], 0.2).expect("a disc");
    let lattice = square(0.25);
    let equation = Eikonal::new(&flat, &lattice).expect("stencils");
    let distances = equation.distances_from(&wall, Order::Second).expect("seeds");
    let (nearest, distance) = distances.nearest_in(&disc).expect("in the box");
    // The square of a step of 10⁻⁶ spacings over the radius, and values rounded to 10⁻¹⁵.
    assert!((distance - 2.0 * 1.57).abs() < 1e-11, "{distance}");
    assert!((nearest - SVector::from([0.57, 0.31])).norm() < 1e-5, "{nearest}");
}

/// A set is reached if a part of it is: whether the metric is missing on its part at the first nodes of the
/// lattice or at the last.
#[test]
fn a_set_that_is_partly_without_a_metric_is_reached() {
    struct Half(f64);
    impl Metric<2> for Half {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let inside = (x[1] * self.0 + 0.55).sqrt();
            SMatrix::identity() * (inside * 0.0 + 1.0)
        }
    }
    let near = HalfSpace::at_least([-1.0, 0.0], 1.0).expect("a half-plane");
    let far = HalfSpace::at_least([1.0, 0.0], 1.0).expect("a half-plane");
    let lattice = square(0.25);
    for sign in [1.0, -1.0] {
        let metric = Half(sign);
        let equation = Eikonal::new(&metric, &lattice).expect("stencils");
        let distances = equation.distances_from(&near, Order::Second).expect("seeds");
        let (nearest, distance) = distances.nearest_in(&far).expect("in reach");
        assert!((distance - 2.0).abs() < 1e-12 && nearest[0] >= 1.0, "{sign} {distance}");
        assert!(nearest[1] * sign > -0.55, "{sign} {nearest}");
    }
}
