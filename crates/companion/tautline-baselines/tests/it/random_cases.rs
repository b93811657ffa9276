//! Random points, and numbers at the edge of `f64`: what is found is a curve, or else an error.

use nalgebra::{SMatrix, SVector, vector};
use tautline::gallery::{Bump, Hyperbolic, Valleys};
use tautline::{Ends, KnownDistance, Metric, Scalar};
use tautline_baselines::collocation::{Collocation, CollocationError, collocate};
use tautline_baselines::geodesic_calculus::{
    CalculusError, discrete_exponential, discrete_geodesic, extend, midpoint,
};
use tautline_baselines::shooting::{
    Integration, Shooting, ShootingError, exponential, logarithm, shoot,
};
use tautline_chance::{Random, cases, seed};

use crate::problems::{shear, swirl};

/// No curve is shorter than the distance. A computed length is off by a relative `10⁻⁹`, as is
/// derived where the known distances are reached. Most pairs have one geodesic only, which both
/// methods find.
#[test]
fn no_geodesic_is_shorter_than_the_distance() {
    fn check(metric: &impl KnownDistance<2>, size: f64, random: &mut Random) {
        let (mut found, mut exact) = (0_u32, 0_u32);
        let cases = cases(20);
        for _ in 0..cases {
            let mut point = || [random.between(-size, size), random.between(-size, size)];
            let (x, y) = (point(), point());
            let d = metric.distance(&x.into(), &y.into()).expect("known");
            let ends = Ends::points(x, y).expect("finite");
            let shot = shoot(metric, &ends, &Shooting::default());
            let path = collocate(metric, &ends, &Collocation::default());
            let lengths =
                [shot.map(|shot| shot.geodesic.length()).ok(), path.map(|p| p.length).ok()];
            for length in lengths.into_iter().flatten() {
                assert!(length >= d * (1.0 - 1e-9), "{length} < {d} from {x:?} to {y:?}");
                found += 1;
                exact += u32::from(length <= d * (1.0 + 1e-9));
            }
        }
        // Under a flat metric, or one of negative curvature, there is no other geodesic.
        assert_eq!(found, exact);
        assert!(found >= 3 * cases / 2, "{found} curves in {cases} cases");
    }
    let mut random = Random(seed(1));
    check(&shear(), 2.0, &mut random);
    check(&swirl(), 1.0, &mut random);
    check(&Hyperbolic, 0.6, &mut random);
}

/// Squares of these numbers overflow or underflow. Every result is an error, or has its digits.
#[test]
fn energies_out_of_range_are_errors() {
    struct Flat;
    impl Metric<2> for Flat {
        fn gram<S: Scalar>(&self, _: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            SMatrix::identity()
        }
    }
    for size in [1e-300, 1e-170, 1e170, 1e300] {
        let ends = Ends::points([0.0, 0.0], [size, size]).expect("finite");
        let shot = shoot(&Flat, &ends, &Shooting::default());
        assert!(matches!(shot, Err(ShootingError::Energy { .. })), "{size}: {shot:?}");
        let path = collocate(&Flat, &ends, &Collocation::default());
        assert!(matches!(path, Err(CollocationError::Energy { .. })), "{size}: {path:?}");
    }
    for size in [1e-150, 1e150] {
        let ends = Ends::points([0.0, 0.0], [size, size]).expect("finite");
        // A few roundings of a product of two.
        let shot = shoot(&Flat, &ends, &Shooting::default()).expect("in range").geodesic.length();
        assert!((shot / (size * 2_f64.sqrt()) - 1.0).abs() < 1e-14, "{shot}");
        let path = collocate(&Flat, &ends, &Collocation::default()).expect("in range").length;
        assert!((path / (size * 2_f64.sqrt()) - 1.0).abs() < 1e-14, "{path}");
    }
}

/// Nothing panics, and what is returned is finite.
#[test]
fn extreme_numbers_do_not_panic() {
    fn check(metric: &impl Metric<2>) {
        let mut refused = 0;
        let sizes = [0.0, 5e-324, 1e-200, 1e-8, 1.0, 1e8, 1e200, f64::MAX];
        for a in sizes {
            for b in sizes {
                let (x, y) = (vector![a, -b], vector![-b, 0.5 * a]);
                let few = Integration { steps: 50, ..Integration::default() };
                if let Ok(geodesic) = exponential(metric, &x, &y, &few) {
                    assert!(geodesic.end().iter().all(|value| value.is_finite()));
                    assert!(geodesic.length().is_finite());
                }
                for point in [extend(metric, &x, &y), midpoint(metric, &x, &y)] {
                    assert!(point.is_err() || point.is_ok_and(|z| z.iter().all(|z| z.is_finite())));
                }
                if let Ok(path) = discrete_exponential(metric, &x, &y, 3) {
                    assert!(path.extent().is_finite());
                }
                let options = Shooting { integration: few, iterations: 3, velocity: None };
                let shot = logarithm(metric, &x, &y, &options);
                assert!(shot.is_err() || shot.is_ok_and(|v| v.iter().all(|v| v.is_finite())));
                let path = discrete_geodesic(metric, &x, &y, 3);
                assert!(path.is_err() || path.is_ok_and(|path| path.extent().is_finite()));
                // The largest numbers are too far from the origin for a pair of ends.
                let Ok(ends) = Ends::points(x, y) else {
                    let shot = logarithm(metric, &x, &y, &options);
                    assert!(matches!(shot, Err(ShootingError::Ends(_))), "{shot:?}");
                    let path = discrete_geodesic(metric, &x, &y, 3);
                    assert!(matches!(path, Err(CalculusError::Ends(_))), "{path:?}");
                    refused += 1;
                    continue;
                };
                if let Ok(shot) = shoot(metric, &ends, &options) {
                    assert!(shot.residual.is_finite() && shot.geodesic.length().is_finite());
                }
                let options =
                    Collocation { most_intervals: 64, iterations: 5, ..Collocation::default() };
                if let Ok(path) = collocate(metric, &ends, &options) {
                    assert!(path.length.is_finite() && path.residual.is_finite());
                }
            }
        }
        assert!(refused > 0);
    }
    check(&Valleys);
    check(&Hyperbolic);
    check(&Bump::new(4.0, 0.5).expect("a width"));
    check(&swirl());
}
