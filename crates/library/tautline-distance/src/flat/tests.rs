//! Signed distances, held against the nearest of many points of the boundary.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_chance::{Random, cases, seed};
use tautline_sets::{AxisBox, Ball, HalfSpace, Point, Shape};

use super::signed_distance;

/// Returns a matrix with eigenvalues between 1 and about 10.
fn random_metric<const D: usize>(random: &mut Random) -> SMatrix<f64, D, D> {
    let a: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| random.between(-1.5, 1.5));
    a.transpose() * a + SMatrix::identity()
}

/// The nearest of the samples of a boundary is not nearer than its nearest point, and one of them is at
/// most half a spacing away from that. The spacings are at most 1.6e-3, and the eigenvalues at most 10.
#[test]
fn in_the_plane_the_distance_is_that_of_the_nearest_point_of_the_boundary() {
    let mut random = Random(seed(11));
    for _ in 0..cases(60) {
        let h = random_metric::<2>(&mut random);
        let centre = vector![random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        let ball = Ball::new(centre, random.between(0.2, 1.0)).expect("a ball");
        let half = vector![random.between(0.1, 0.8), random.between(0.1, 0.8)];
        let side = AxisBox::from_corners(centre - half, centre + half).expect("corners");
        let x = centre + vector![random.between(-1.5, 1.5), random.between(-1.5, 1.5)];
        let of = |samples: &mut dyn Iterator<Item = SVector<f64, 2>>| {
            let lengths = samples.map(|y| (x - y).dot(&(h * (x - y))).sqrt());
            lengths.fold(f64::INFINITY, f64::min)
        };
        let turn = |n: i32| f64::from(n) / 4000.0;
        let circle = of(&mut (0..4000).map(|n| {
            let (sin, cos) = (std::f64::consts::TAU * turn(n)).sin_cos();
            centre + vector![cos, sin] * ball.r()
        }));
        let frame = of(&mut (0..=1000).flat_map(|n| {
            let s = 2.0 * f64::from(n) / 1000.0 - 1.0;
            [(s, 1.0), (s, -1.0), (1.0, s), (-1.0, s)]
                .map(|(a, b)| centre + vector![a * half[0], b * half[1]])
        }));
        for (shape, sampled, is_outside) in [
            (Shape::Ball(ball.clone()), circle, (x - centre).norm() > ball.r()),
            (Shape::AxisBox(side), frame, (0..2).any(|i| (x - centre)[i].abs() > half[i])),
        ] {
            let (found, y) = signed_distance(&shape, &h, &x).expect("definite");
            assert_eq!(found > 0.0, is_outside, "{shape:?} {x}");
            let d = found.abs();
            let spacing = 1.6e-3 * 10_f64.sqrt();
            assert!(
                d <= sampled + 1e-12 && sampled <= d + 0.5 * spacing,
                "{shape:?} {x}: {d} {sampled}"
            );
            assert!(((x - y).dot(&(h * (x - y))).sqrt() - d).abs() < 1e-12, "{shape:?} {x} {y}");
        }
    }
}

/// From the centre of a ball the shortest way out is the axis of the least eigenvalue.
#[test]
fn at_the_centre_of_a_ball_the_distance_is_minus_the_least_half_axis() {
    fn check<const D: usize>(random: &mut Random) {
        for _ in 0..20 {
            let h = random_metric::<D>(random);
            let ball = Shape::Ball(Ball::new([0.25; D], 0.5).expect("a ball"));
            let (found, _) =
                signed_distance(&ball, &h, &SVector::from([0.25; D])).expect("definite");
            let least = crate::hamiltonian::eigenvalues(&h).into_iter().reduce(f64::min);
            let exact = -0.5 * least.expect("not empty").sqrt();
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
    }
    let mut random = Random(seed(12));
    check::<1>(&mut random);
    check::<2>(&mut random);
    check::<3>(&mut random);
    check::<4>(&mut random);
    // On the axis of the greatest eigenvalue near the centre the nearest points lie to both sides.
    let ball = Shape::Ball(Ball::new([0.0, 0.0], 1.0).expect("a ball"));
    let (found, y) =
        signed_distance(&ball, &matrix![4.0, 0.0; 0.0, 1.0], &vector![0.1, 0.0]).expect("definite");
    // 4 (w − 0.1)² + 1 − w² is least at w = 2/15.
    let w: f64 = 0.4 / 3.0;
    assert!((y[0] - w).abs() < 1e-12, "{y}");
    assert!((found + (4.0 * (w - 0.1).powi(2) + 1.0 - w * w).sqrt()).abs() < 1e-12, "{found}");
}

/// A hyperplane at the Euclidean distance `t` has the distance `t/(nᵀh⁻¹n)^{1/2}`, on either side.
#[test]
fn the_distance_of_a_half_space_is_that_of_its_wall() {
    let h = matrix![2.0, 0.6; 0.6, 1.0];
    let wall = Shape::HalfSpace(HalfSpace::new([3.0, 4.0], 5.0).expect("a normal"));
    let dual = vector![0.6, 0.8].dot(&(h.try_inverse().expect("definite") * vector![0.6, 0.8]));
    for t in [-2.0, -0.1, 0.0, 0.3, 7.0] {
        let x = vector![0.6, 0.8] * (1.0 + t) + vector![-0.8, 0.6] * 3.0;
        let (found, _) = signed_distance(&wall, &h, &x).expect("definite");
        assert!((found - t / dual.sqrt()).abs() < 1e-12, "{found} {t}");
    }
}

/// Nearest to `x` beside a corner may be a point of a side, and beside a side it may be a corner.
#[test]
fn the_nearest_point_of_a_box_need_not_be_its_euclidean_projection() {
    let h = matrix![1.0, 0.9; 0.9, 1.0];
    let side = Shape::AxisBox(AxisBox::from_corners([-1.0, -1.0], [0.0, 0.0]).expect("corners"));
    // With y₂ = 0 the nearest y₁ is x₁ + 0.9 x₂, and with y₁ = 0 the nearest y₂ is x₂ + 0.9 x₁.
    let (_, y) = signed_distance(&side, &h, &vector![0.5, -0.2]).expect("definite");
    assert!((y - vector![0.0, 0.0]).norm() < 1e-12, "{y}");
    let (_, y) = signed_distance(&side, &h, &vector![-0.7, 0.1]).expect("definite");
    assert!((y - vector![-0.61, 0.0]).norm() < 1e-12, "{y}");
}

#[test]
fn without_a_metric_there_is_no_distance() {
    let x = vector![2.0, 0.1];
    let shapes = [
        Shape::Ball(Ball::new([0.0, 0.0], 1.0).expect("a ball")),
        Shape::AxisBox(AxisBox::from_corners([-1.0, -1.0], [0.0, 0.0]).expect("corners")),
        Shape::HalfSpace(HalfSpace::new([3.0, 4.0], 5.0).expect("a normal")),
        Shape::Point(Point::new([0.0, 0.0]).expect("finite")),
    ];
    for shape in shapes {
        for h in [SMatrix::from_element(f64::NAN), matrix![-1.0, 0.0; 0.0, -1.0]] {
            assert_eq!(signed_distance(&shape, &h, &x), None, "{shape:?} {h}");
        }
    }
}
