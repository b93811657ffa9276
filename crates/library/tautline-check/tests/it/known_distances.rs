//! Distances that are known in closed form.

use nalgebra::{SMatrix, SVector, vector};
use tautline_chance::{Random, cases, seed};
use tautline_check::{Certificate, CheckError, Cubes, Region};
use tautline_formula::Formula;
use tautline_metrics::gallery::Constant;
use tautline_sets::{Ball, HalfSpace, Shape};

use crate::{
    helpers::{flood, formula, keeps, level, levels_from, one_level, point, proved},
    wave::Wave,
};

fn constant<const D: usize>(fixed: u64) {
    let mut random = Random(seed(fixed));
    for _ in 0..cases(5) {
        let a: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| random.between(-0.4, 0.4));
        let h = a.transpose() * a + SMatrix::identity();
        let [x, y]: [SVector<f64, D>; 2] =
            std::array::from_fn(|_| SVector::from_fn(|_, _| random.between(-1.0, 1.0)));
        let v = y - x;
        let d = (v.transpose() * h * v)[0].sqrt();
        let p = h * v / d;
        let formula = Formula::record(&Constant::new(h).expect("definite")).expect("no branches");
        let hi = 1.001 * d;
        let region = Region::Tubes { radius: 0.51 * hi / 0.9, c1: 0.9 };
        let sets = [point(x.into()), point(y.into())];
        let exponent = (d / 4.0).log2().floor() as i32;
        let certificate = one_level(
            formula,
            sets,
            hi,
            region,
            exponent,
            [&|z| p.dot(&(z - x)), &|z| p.dot(&(y - z))],
        );
        let proved = proved(&certificate);
        // The distance itself is computed with an error of a few roundings.
        assert!(proved.lower <= d * (1.0 + 1e-15) && proved.lower >= d * (1.0 - 1e-13));
    }
}

/// Linear functions are the distances, up to rounding.
#[test]
fn constant_metrics_lose_only_rounding() {
    constant::<1>(1);
    constant::<2>(2);
    constant::<3>(3);
    constant::<4>(4);
}

/// A gradient with its entries in another order has another norm here, but not under a conformal
/// metric.
#[test]
fn pull_backs_with_random_linear_parts_are_enclosed() {
    let mut random = Random(seed(5));
    for _ in 0..cases(4) {
        let wave = Wave::random(&mut random, 30.0);
        let ends: [SVector<f64, 2>; 2] =
            [0, 1].map(|_| vector![random.between(-0.5, 0.5), random.between(-0.5, 0.5)]);
        let (x, y) = (ends[0], ends[1]);
        let d = wave.distance(&x, &y);
        let hi = 1.01 * d;
        let (phi, psi) = (wave.calibration([x, y], 0.5 * d), wave.calibration([y, x], 0.5 * d));
        let near = |z: &SVector<f64, 2>| phi(z).min(psi(z)) < 0.55 * d;
        let from = |exponent: i32| {
            levels_from(
                flood(exponent, &x, near),
                wave.formula(),
                [point(x.into()), point(y.into())],
                hi,
                Region::ExitTwo,
                &[exponent, exponent - 1],
                [&phi, &psi],
            )
        };
        // Where the least eigenvalue is small, the exit test needs small cubes.
        let largest = (d / 12.0).log2().floor() as i32;
        let certificate = (0..4).find_map(|finer| from(largest - finer).ok());
        let certificate = certificate.unwrap_or_else(|| panic!("{wave:?} {x} {y}"));
        let proved = proved(&certificate);
        assert!(proved.lower <= d * (1.0 + 1e-14), "{wave:?} {x} {y}");
        assert!(proved.lower >= 0.85 * d, "{} of {d}: {:?} {wave:?}", proved.lower, proved.levels);
        assert!(keeps(&proved, &wave.geodesic(ends, 100)), "{wave:?} {x} {y}");
    }
}

/// The arc from `x` to `y` on the unit sphere, in stereographic coordinates.
fn arc<const D: usize>(x: &SVector<f64, D>, y: &SVector<f64, D>) -> f64 {
    let scale = ((1.0 + x.norm_squared()) * (1.0 + y.norm_squared())).sqrt();
    2.0 * ((x - y).norm() / scale).asin()
}

#[test]
fn the_sphere_is_enclosed_by_its_own_exit_test() {
    let sphere = formula::<2>("4/sqr(1 + x1^2 + x2^2) I");
    let (x, y) = (vector![-0.5, 0.2], vector![0.6, 0.4]);
    let d = arc(&x, &y);
    let places = (-18..18).flat_map(|i| (-18..18).map(move |j| [i, j])).collect();
    let cubes = Cubes::new(-3, places).expect("in range");
    let level = level(0, &cubes, [&|z| arc(&x, z), &|z| arc(&y, z)]);
    let sets = [point(x.into()), point(y.into())];
    let certificate = |region| {
        let (formula, sets, levels) = (sphere.clone(), sets.clone(), vec![level.clone()]);
        Certificate { formula, sets, hi: 1.001 * d, region, curve: None, levels }
    };
    let proved = proved(&certificate(Region::ExitTwo));
    assert!(proved.lower <= d && proved.lower >= 0.8 * d, "{} of {d}", proved.lower);
    // One-sided, the way past infinity counts as short.
    let refused = certificate(Region::ExitOne).check();
    assert!(matches!(refused, Err(CheckError::Exit { .. })), "{refused:?}");
}

/// From a ball to a half-space, the levels begin at the largest value on the ball.
#[test]
fn between_sets_the_values_count_from_the_sets_on() {
    let from = Shape::Ball(Ball::new([0.1, -0.2], 0.5).expect("a ball"));
    let to = Shape::HalfSpace(HalfSpace::at_least([1.0, 0.0], 2.0).expect("a half-space"));
    let d = 1.4;
    let certificate = one_level(
        formula::<2>("1 I"),
        [from, to],
        1.001 * d,
        Region::Tubes { radius: 1.5, c1: 0.99 },
        -4,
        [&|x| x[0], &|x| -x[0]],
    );
    let proved = proved(&certificate);
    assert!(proved.lower <= d && proved.lower >= 0.99 * d, "{} of {d}", proved.lower);
}

/// A ridge with a low end, left out of the cubes: the short way leads around it.
#[test]
fn a_box_that_short_curves_leave_fails_its_exit_test() {
    let ridge = formula::<2>("(1 + 400*exp(-sqr(x1/0.3) - x2^4)) I");
    let places: Vec<_> = (-12..12).flat_map(|i| (-4..4).map(move |j| [i, j])).collect();
    let cubes = Cubes::new(-3, places).expect("in range");
    // About the distance along the axis.
    let along = |s: f64| s + 5.3 * (1.0 + (s / 0.3).tanh());
    let (from, to) = (along(-1.0), along(1.0));
    let levels = vec![level(0, &cubes, [&|x| along(x[0]) - from, &|x| to - along(x[0])])];
    for region in [Region::ExitOne, Region::ExitTwo] {
        let certificate = Certificate {
            formula: ridge.clone(),
            sets: [point([-1.0, 0.0]), point([1.0, 0.0])],
            hi: 10.0,
            region,
            curve: None,
            levels: levels.clone(),
        };
        let refused = certificate.check();
        assert!(matches!(refused, Err(CheckError::Exit { .. })), "{refused:?}");
    }
}
