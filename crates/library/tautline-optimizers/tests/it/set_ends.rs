//! Tests ends that move in sets together with the curve: on faces, edges, corners and curved
//! boundaries.
//!
//! The references are closed forms. Flat metrics map some sets to sets of the same kind, and under
//! a constant metric every discrete energy is exact.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_discretizations::{Rule, energy_gradient};
use tautline_metrics::{
    KnownDistance, Metric,
    gallery::{Constant, Separable, Shear, Valleys},
};
use tautline_optimizers::{Curvature, Minimum, Options, Stop, extrapolate, minimise};
use tautline_sets::{AffineSubspace, AxisBox, ClosedSet, Ends, Segment, Sphere};

use crate::setup::{
    assert_close, ball, between, euclidean, extrapolated, half_space, lowest, only, point, straight,
};

/// Solves with the trapezoidal rule, and checks what holds for every minimum between sets.
/// `condition` is a bound on the condition number of the metric.
#[track_caller]
fn solve<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    n: usize,
    condition: f64,
) -> Minimum<D> {
    let minimum = lowest(metric, ends, Rule::TRAPEZOIDAL, n);
    assert_eq!((minimum.stop, minimum.curvature), (Stop::Converged, Curvature::PositiveDefinite));
    assert!(minimum.decrement <= 1e-18, "decrement {:e}", minimum.decrement);
    let (_, gradient) = energy_gradient(Rule::TRAPEZOIDAL, metric, &minimum.sequence);
    for (set, x, g) in [
        (ends.first(), minimum.sequence.first(), &gradient[0]),
        (ends.second(), minimum.sequence.last(), &gradient[n]),
    ] {
        assert_in_set(&**set, x);
        // Transversality: x is the nearest point to a point farther out along the force −g. A step
        // of length 1/4 loses at most a factor 3/2 on a ball of radius ½.
        let z = x - g * (0.25 / g.norm());
        let off = (x - set.project(&z)).norm() / 0.25;
        // A gradient gₜ along the face predicts a decrease of at least gₜ²/(2‖A‖), where ‖A‖ ≤ 4N
        // c₂. So gₜ² ≤ 8N c₂ E decrement, while |g|² ≥ 4 c₁ E.
        let bound =
            (2.0 * n as f64 * condition * minimum.decrement).sqrt() + 30.0 * minimum.residual_floor;
        assert!(off <= bound, "the curve is {off:e} off the normal, bound {bound:e}");
    }
    minimum
}

/// Checks membership up to the rounding of a projection: `(D + 4) ε max |xᵢ|`.
#[track_caller]
fn assert_in_set<const D: usize>(set: &dyn ClosedSet<D>, x: &SVector<f64, D>) {
    let off = (set.project(x) - x).amax();
    assert!(off <= (D + 4) as f64 * f64::EPSILON * x.amax(), "{off:e} off {set:?}");
}

/// Compares the extrapolated squared distance with the exact one, to within a relative `1e-9`.
#[track_caller]
fn assert_distance<const D: usize>(minimum: &Minimum<D>, distance: f64) {
    assert_close(extrapolated(minimum), distance * distance, 1e-9);
}

#[test]
fn valleys_from_a_ball_to_a_half_space_and_back() {
    let d = 5.0 - 3_f64.sin() + 0.5_f64.sin();
    let (ball, wall) = (ball([0.0, 0.0], 0.5), half_space([1.0, 0.0], 3.0));
    for ends in [between(ball.clone(), wall.clone()), between(wall, ball)] {
        let minimum = solve(&Valleys, &ends, 512, 9.0);
        assert_distance(&minimum, d);
        let left = lowest(&Valleys, &ends, Rule::LEFT_ENDPOINT, 512);
        assert_eq!((left.stop, left.curvature), (Stop::Converged, Curvature::PositiveDefinite));
        // The extrapolation is a polynomial in 1/N through the grids 8, 32, 128, 512. The first
        // omitted term is (1/8)(1/32)(1/128)(1/512) = 6e-8 times derivatives of about 100.
        let d2 = extrapolate(&left.levels, 1).expect("several grids").value;
        assert_close(d2, d * d, 1e-5);
    }
}

/// The wave preserves `x₂`. So the nearest point of `{x₂ ≥ 3}` is straight above in the flat plane,
/// and the highest point of a set is the nearest to it.
#[test]
fn sheared_plane_from_the_highest_point_to_a_half_plane() {
    let shear = Shear::new(0.5, 1.0).expect("k > 0");
    // The condition number is c₂/c₁ = c₂², where c₂ = (√(1 + 1/16) + 1/4)² = 1.64.
    let condition = 2.7;
    let above = |x: SVector<f64, 2>| {
        let flat = shear.flatten(&x);
        shear.unflatten(&vector![flat[0], 3.0])
    };
    let segment = Segment::new([-1.0, -0.5], [1.0, 0.75]).expect("finite");
    let line = AffineSubspace::new([0.0, 3.0], [[1.0, 0.0]]).expect("a direction");
    let wall = half_space([0.0, 1.0], 3.0);
    // The last ball is above the line, so its lowest point is the nearest.
    for (ends, from, d) in [
        (between(ball([0.0, 0.0], 0.5), wall.clone()), [0.0, 0.5], 2.5),
        (between(segment, wall.clone()), [1.0, 0.75], 2.25),
        (between(point([0.3, 0.2]), wall), [0.3, 0.2], 2.8),
        (between(ball([0.0, 0.0], 0.5), line.clone()), [0.0, 0.5], 2.5),
        (between(ball([0.7, 5.0], 0.5), line), [0.7, 4.5], 1.5),
    ] {
        let minimum = solve(&shear, &ends, 512, condition);
        assert_distance(&minimum, d);
        // The discrete minimiser is off by O(N⁻²) = 4e-6, with a constant of size 1.
        assert!((minimum.sequence.first() - SVector::from(from)).norm() < 1e-4);
        assert!((minimum.sequence.last() - above(from.into())).norm() < 1e-4);
    }
}

/// Checks two boxes, the images of which are boxes at a Euclidean distance.
#[track_caller]
fn check_boxes<const D: usize>(first: ([f64; D], [f64; D]), second: ([f64; D], [f64; D])) {
    let separable = Separable::new(
        SVector::from_fn(|i, _| [0.3, -0.5, 0.2, 0.4, -0.1][i]),
        SVector::from_fn(|i, _| [1.0, 0.7, 1.9, 1.3, 2.2][i]),
    )
    .expect("below one");
    let corners = |(lower, upper)| AxisBox::from_corners(lower, upper).expect("in order");
    let minimum = solve(&separable, &between(corners(first), corners(second)), 512, 9.0);
    // The nearest points are found coordinate by coordinate, since F is increasing in each.
    let near: SVector<f64, D> = SVector::from_fn(|i, _| second.0[i].clamp(first.0[i], first.1[i]));
    let far = SVector::from_fn(|i, _| near[i].clamp(second.0[i], second.1[i]));
    let d = separable.distance(&near, &far).expect("all pairs");
    assert_distance(&minimum, d);
    assert!((minimum.sequence.first() - near).norm() < 1e-4);
    assert!((minimum.sequence.last() - far).norm() < 1e-4);
}

#[test]
fn boxes_in_two_dimensions_meet_at_a_face_and_at_corners() {
    let unit = ([-1.0, -1.0], [1.0, 1.0]);
    check_boxes(unit, ([3.0, 0.4], [3.0, 0.4]));
    check_boxes(unit, ([3.0, 2.0], [4.0, 5.0]));
    check_boxes(([2.0, 1.5], [2.5, 4.0]), ([-1.0, -3.0], [0.0, 0.0]));
    // Here a corner is level with the other box: its multiplier is zero, and either face may be
    // active.
    check_boxes(unit, ([3.0, 1.0], [3.0, 1.0]));
}

#[test]
fn boxes_in_three_dimensions_meet_at_a_face_an_edge_and_a_corner() {
    let unit = ([-1.0; 3], [1.0; 3]);
    for x in [[0.2, 2.5, -0.3], [0.2, 2.5, -2.0], [-2.0, 2.5, -2.0]] {
        check_boxes(unit, (x, x));
        check_boxes((x, x), unit);
    }
    check_boxes(unit, ([1.5, 2.0, -4.0], [2.0, 3.0, -2.0]));
}

#[test]
fn boxes_in_five_dimensions_meet_at_every_kind_of_face() {
    let unit = ([-1.0; 5], [1.0; 5]);
    for inside in 0..5 {
        let x = std::array::from_fn(|i| if i < inside { 0.1 * (i + 1) as f64 } else { 2.0 });
        check_boxes(unit, (x, x));
    }
    check_boxes(unit, ([2.0; 5], [3.0; 5]));
}

/// For the ball about `c` and `{a·x ≥ b}`, `d = (b − a·c − r|a|) / (aᵀH⁻¹a)^{1/2}`.
#[test]
fn a_ball_and_an_oblique_half_space_under_a_constant_metric() {
    let h = matrix![4.0, 1.5, 0.0; 1.5, 2.0, -0.5; 0.0, -0.5, 1.0];
    let (a, c) = (vector![1.0, 2.0, -0.5], vector![0.2, -0.1, 0.4]);
    let (r, b) = (0.5_f64, 4.0_f64);
    let inverse: SMatrix<f64, 3, 3> = h.try_inverse().expect("positive definite");
    let d = (b - a.dot(&c) - r * a.norm()) / a.dot(&(inverse * a)).sqrt();
    let ends = between(ball(c, r), half_space(a, b));
    let metric = Constant::new(h).expect("positive definite");
    for n in [1, 2, 3, 16, 200] {
        let minimum = solve(&metric, &ends, n, 15.0);
        // The energy is exact for every N, up to the decrement and rounding.
        assert_close(minimum.energy, d * d, 4e-15);
        // The contact is the point where the Euclidean normals agree.
        let contact = c + a * (r / a.norm());
        assert!((minimum.sequence.first() - contact).norm() < 1e-6);
    }
}

/// Only the distance across the line counts: it is `(|n·(c − p)| − r) / (nᵀH⁻¹n)^{1/2}`.
#[test]
fn an_unbounded_line_and_a_ball_under_a_constant_metric() {
    let h = matrix![3.0, 1.0; 1.0, 1.0];
    let (p, q) = (vector![0.0, 3.0], vector![2.0, 1.0]);
    let normal = vector![1.0, -2.0].normalize();
    let line = AffineSubspace::new(p, [q]).expect("a direction");
    let d = (normal.dot(&(vector![1.0, 0.5] - p)).abs() - 0.75)
        / normal.dot(&(h.try_inverse().expect("definite") * normal)).sqrt();
    let metric = Constant::new(h).expect("positive definite");
    for n in [1, 2, 50] {
        let minimum = solve(&metric, &between(line.clone(), ball([1.0, 0.5], 0.75)), n, 6.0);
        assert_close(minimum.energy, d * d, 4e-15);
    }
}

/// Returns the squared distance between `x` and a box, as the minimum over all faces. On each face
/// the free coordinates solve a linear system.
fn box_distance<const D: usize>(
    h: &SMatrix<f64, D, D>,
    bounds: [[f64; D]; 2],
    x: &SVector<f64, D>,
) -> f64 {
    let mut best = f64::INFINITY;
    for face in 0..3_usize.pow(D as u32) {
        let state: [usize; D] = std::array::from_fn(|i| face / 3_usize.pow(i as u32) % 3);
        // The rows of the free coordinates are (H(y − x))ᵢ = 0, the other rows are yᵢ = bound.
        let mut matrix = *h;
        let mut right = h * x;
        for i in (0..D).filter(|&i| state[i] < 2) {
            matrix.row_mut(i).fill(0.0);
            matrix[(i, i)] = 1.0;
            right[i] = bounds[state[i]][i];
        }
        let inverse = nalgebra::DMatrix::from_fn(D, D, |i, j| matrix[(i, j)]).try_inverse();
        let inverse = inverse.expect("blocks of a definite matrix");
        let y = SMatrix::<f64, D, D>::from_fn(|i, j| inverse[(i, j)]) * right;
        if (0..D).all(|i| (bounds[0][i] - 1e-12..=bounds[1][i] + 1e-12).contains(&y[i])) {
            best = best.min((y - x).dot(&(h * (y - x))));
        }
    }
    best
}

/// Under an oblique metric the nearest point is on another face than the nearest point in the
/// Euclidean sense.
#[test]
fn points_round_an_oblique_box() {
    let h = matrix![1.0, 0.9, 0.0; 0.9, 1.0, 0.2; 0.0, 0.2, 0.5];
    let metric = Constant::new(h).expect("positive definite");
    let bounds = [[-1.0; 3], [1.0, 2.0, 0.5]];
    for k in 0..40 {
        let t = f64::from(k);
        let x = vector![(1.7 * t).sin(), (2.3 * t).cos(), (0.9 * t + 1.0).sin()] * 5.0;
        let inside = (0..3).all(|i| (bounds[0][i]..=bounds[1][i]).contains(&x[i]));
        assert!(!inside, "5 times a vector of size 1 is outside");
        let cuboid = AxisBox::from_corners(bounds[0], bounds[1]).expect("in order");
        let ends = between(cuboid, point(x));
        for n in [1, 24] {
            // The eigenvalues range from 0.06 to 1.92.
            let minimum = solve(&metric, &ends, n, 32.0);
            assert_close(minimum.energy, box_distance(&h, bounds, &x), 1e-13);
        }
    }
}

#[test]
fn a_point_beside_and_beyond_a_segment() {
    let h = matrix![2.0, -0.7; -0.7, 1.0];
    let metric = Constant::new(h).expect("positive definite");
    let (a, b) = (vector![-1.0, 0.0], vector![2.0, 1.0]);
    let v = b - a;
    for x in [vector![0.0, 3.0], vector![-4.0, 1.0], vector![7.0, 7.0], vector![1.0, -2.0]] {
        let s = (v.dot(&(h * (x - a))) / v.dot(&(h * v))).clamp(0.0, 1.0);
        let y = a + v * s;
        let segment = Segment::new(a, b).expect("finite");
        for n in [1, 2, 33] {
            let minimum = solve(&metric, &between(segment.clone(), point(x)), n, 5.0);
            assert_close(minimum.energy, (x - y).dot(&(h * (x - y))), 4e-15);
        }
    }
}

/// For two balls under a constant metric, the normals at the two contacts are `±H` times the chord.
/// The derivative of the projection to the tiny ball is about `1e-6`.
#[test]
fn a_large_and_a_tiny_ball_obey_the_law_of_normals() {
    let h = matrix![5.0, 1.0; 1.0, 0.5];
    let metric = Constant::new(h).expect("positive definite");
    let (c, e) = (vector![0.0, 0.0], vector![3.0, 1.5]);
    for (r, tiny) in [(1.0, 0.5), (1.0, 1e-6), (2.0, 1e-8)] {
        for n in [1, 2, 40] {
            // The eigenvalues are 0.28 and 5.2.
            let minimum = solve(&metric, &between(ball(c, r), ball(e, tiny)), n, 20.0);
            let (x, y) = (minimum.sequence.first(), minimum.sequence.last());
            let covector = h * (y - x);
            let unit = covector.normalize();
            // The problem is convex, so it is enough that the normals agree. A tangential
            // displacement changes the energy only by (tiny · angle)², which explains its bound.
            assert!((x - (c + unit * r)).norm() < 1e-6);
            assert!((y - (e - unit * tiny)).norm() < 1e-6 * tiny.max(1e-2));
        }
    }
}

/// No step is taken. A straight line meets the wall obliquely, with momentum `(3, 4)`. The
/// component along the wall is `4`, and the energy is 25 instead of 9.
#[test]
fn residual_and_decrement_of_an_oblique_end() {
    let metric = euclidean::<2>();
    for n in [1, 2, 20] {
        let start = straight([0.0, 0.0], [3.0, 4.0], n);
        let options = Options { iterations: 0, ..only(start) };
        let ends = between(point([0.0, 0.0]), half_space([1.0, 0.0], 3.0));
        let minimum = minimise(&metric, &ends, Rule::TRAPEZOIDAL, n, &options).expect("a metric");
        assert_eq!(minimum.stop, Stop::IterationLimit);
        assert_close(minimum.residual, 4.0 / 5.0, 1e-13);
        // The margin of the Newton matrix is 1e-8 times its regulariser.
        assert_close(minimum.decrement, 16.0 / 25.0, 1e-7);
    }
}

/// Seen from inside, the wall is curved towards the ball, so the two curvatures have opposite
/// signs.
#[test]
fn a_ball_inside_a_sphere_goes_to_the_nearest_wall() {
    let metric = euclidean::<2>();
    let hollow = Sphere::new([0.0, 0.0], 3.0).expect("a radius");
    for n in [1, 2, 40] {
        let minimum = solve(&metric, &between(ball([0.5, 0.5], 1.0), hollow.clone()), n, 1.0);
        let d = 2.0 - 0.5_f64.hypot(0.5);
        assert_close(minimum.energy, d * d, 1e-14);
    }
}
