//! Every bad parameter is refused by name and number.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_metrics::{
    MetricError,
    gallery::{
        Bump, Checkerboard, Constant, Corrugated, EggCrate, GalleryError, Hill, Lens, Link,
        Obstacle, Ramp, RotatingAnisotropy, Separable, Shear, SineProjection, SineProjections,
        SoftObstacles, Swirl, TwoChannels, TwoLinkArm,
    },
};

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NOT_POSITIVE: [f64; 5] = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NEGATIVE: [f64; 4] = [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NOT_BELOW_ONE: [f64; 5] = [1.0, -1.0, 1.5, f64::NAN, f64::INFINITY];

/// The name and the number of a refused parameter, with the letter of its clause.
fn refused<T: std::fmt::Debug>(outcome: Result<T, GalleryError>) -> (char, &'static str, f64) {
    match outcome.expect_err("a bad parameter") {
        GalleryError::NotFinite { name, value } => ('f', name, value),
        GalleryError::NotPositive { name, value } => ('p', name, value),
        GalleryError::Negative { name, value } => ('n', name, value),
        GalleryError::NotBelowOne { name, value } => ('b', name, value),
        other => panic!("{other}"),
    }
}

/// Like `==`, but NaN is the same as NaN.
#[track_caller]
fn same(found: (char, &str, f64), clause: char, name: &str, value: f64) {
    assert_eq!((found.0, found.1), (clause, name));
    assert_eq!(found.2.to_bits(), value.to_bits(), "{} for {value}", found.2);
}

#[test]
fn waves_need_amplitudes_and_wave_numbers() {
    for bad in NOT_BELOW_ONE {
        same(refused(Ramp::new(bad, 1.0)), 'b', "amplitude", bad);
        let separable = Separable::new(vector![0.5, bad], vector![1.0, 1.0]);
        same(refused(separable), 'b', "amplitude", bad);
    }
    for bad in NOT_POSITIVE {
        same(refused(Ramp::new(0.5, bad)), 'p', "wave number", bad);
        same(refused(Shear::new(0.5, bad)), 'p', "wave number", bad);
        same(refused(EggCrate::new(0.5, bad)), 'p', "wave number", bad);
        same(refused(Corrugated::new(0.5, bad)), 'p', "wave number", bad);
        let separable = Separable::new(vector![0.5, 0.5], vector![1.0, bad]);
        same(refused(separable), 'p', "wave number", bad);
    }
    for bad in NOT_FINITE {
        same(refused(Shear::new(bad, 1.0)), 'f', "amplitude", bad);
        same(refused(EggCrate::new(bad, 1.0)), 'f', "amplitude", bad);
        same(refused(Corrugated::new(bad, 1.0)), 'f', "amplitude", bad);
    }
}

#[test]
fn profiles_need_heights_and_widths() {
    let centre = vector![0.0, 1.0];
    let obstacles = |height, width| {
        let good = Obstacle { centre, height: 1.0, width: 1.0 };
        SoftObstacles::new(vec![good, Obstacle { centre, height, width }])
    };
    for bad in NOT_POSITIVE {
        same(refused(Lens::new(1.0, bad)), 'p', "width", bad);
        same(refused(Bump::new(1.0, bad)), 'p', "width", bad);
        same(refused(Hill::new(1.0, bad)), 'p', "width", bad);
        same(refused(obstacles(1.0, bad)), 'p', "width", bad);
        same(refused(Swirl::new(1.0, bad)), 'p', "width", bad);
        same(refused(Checkerboard::new(1.0, bad)), 'p', "cell", bad);
        same(refused(TwoChannels::new(1.0, 1.0, bad)), 'p', "width", bad);
        same(refused(TwoChannels::new(1.0, bad, 1.0)), 'p', "offset", bad);
    }
    for bad in NEGATIVE {
        same(refused(Lens::new(bad, 1.0)), 'n', "height", bad);
        same(refused(Bump::new(bad, 1.0)), 'n', "height", bad);
        same(refused(obstacles(bad, 1.0)), 'n', "height", bad);
        same(refused(Checkerboard::new(bad, 1.0)), 'n', "height", bad);
        same(refused(TwoChannels::new(bad, 1.0, 1.0)), 'n', "height", bad);
    }
    for bad in NOT_FINITE {
        same(refused(Hill::new(bad, 1.0)), 'f', "height", bad);
        same(refused(Swirl::new(bad, 1.0)), 'f', "angle", bad);
        let obstacle = Obstacle { centre: vector![0.0, bad], height: 1.0, width: 1.0 };
        same(refused(SoftObstacles::new(vec![obstacle])), 'f', "coordinate of a centre", bad);
    }
    assert!(Hill::new(-1.0, 1.0).is_ok(), "a hollow");
    assert!(Lens::new(0.0, 1.0).is_ok(), "the Euclidean plane");
    assert!(SoftObstacles::<2>::new(vec![]).is_ok(), "the Euclidean plane");
}

#[test]
fn directions_need_finite_entries() {
    let good = vector![1.0, 0.0];
    for bad in NOT_FINITE {
        let entry = vector![0.0, bad];
        let projections = |wave_vector, direction| {
            SineProjections::new(vec![SineProjection { wave_vector, direction }])
        };
        same(refused(projections(entry, good)), 'f', "entry of a wave vector", bad);
        same(refused(projections(good, entry)), 'f', "entry of a direction", bad);
        let rotating = RotatingAnisotropy::new([1.0, 2.0], entry);
        same(refused(rotating), 'f', "entry of the wave vector", bad);
    }
    for bad in NOT_POSITIVE {
        same(refused(RotatingAnisotropy::new([bad, 1.0], good)), 'p', "eigenvalue", bad);
        same(refused(RotatingAnisotropy::new([1.0, bad], good)), 'p', "eigenvalue", bad);
    }
}

#[test]
fn arms_need_a_positive_definite_inertia() {
    for bad in NOT_FINITE {
        same(refused(TwoLinkArm::new(bad, 1.0, 1.0)), 'f', "A", bad);
        same(refused(TwoLinkArm::new(3.0, bad, 1.0)), 'f', "B", bad);
    }
    for bad in NOT_POSITIVE {
        same(refused(TwoLinkArm::new(3.0, 1.0, bad)), 'p', "C", bad);
    }
    // C (A − C) − B²: 1 · 1 − 1, and 1 · 1 − 4.
    for (b, determinant) in [(1.0, 0.0), (-2.0, -3.0)] {
        let error = TwoLinkArm::new(2.0, b, 1.0).expect_err("singular when stretched");
        assert_eq!(error, GalleryError::SingularArm { determinant });
    }
    let link = Link { mass: 1.0, length: 1.0, centre: 0.5, inertia: 0.1 };
    for bad in NEGATIVE {
        let arm = |first| refused(TwoLinkArm::from_links(first, link));
        same(arm(Link { mass: bad, ..link }), 'n', "mass", bad);
        same(arm(Link { length: bad, ..link }), 'n', "length", bad);
        same(arm(Link { centre: bad, ..link }), 'n', "centre", bad);
        same(arm(Link { inertia: bad, ..link }), 'n', "inertia", bad);
        let second = TwoLinkArm::from_links(link, Link { mass: bad, ..link });
        same(refused(second), 'n', "mass", bad);
    }
    // A second link without mass and inertia: C = 0.
    let nothing = Link { mass: 0.0, inertia: 0.0, ..link };
    same(refused(TwoLinkArm::from_links(link, nothing)), 'p', "C", 0.0);
}

#[test]
fn constant_needs_a_symmetric_positive_definite_matrix() {
    let refused = |a: SMatrix<f64, 2, 2>| match Constant::new(a).expect_err("a bad matrix") {
        GalleryError::Matrix(error) => error,
        other => panic!("{other}"),
    };
    let nan = refused(matrix![1.0, 0.0; 0.0, f64::NAN]);
    assert!(matches!(nan, MetricError::NotFinite { row: 1, column: 1, .. }), "{nan}");
    let lopsided = refused(matrix![2.0, 1.0; 0.5, 2.0]);
    assert!(matches!(lopsided, MetricError::NotSymmetric { above: 1.0, below: 0.5, .. }));
    let indefinite = refused(matrix![1.0, 2.0; 2.0, 1.0]);
    assert!(matches!(indefinite, MetricError::NotPositiveDefinite { .. }), "{indefinite}");
    let singular = refused(matrix![1.0, 1.0; 1.0, 1.0]);
    assert!(matches!(singular, MetricError::NotPositiveDefinite { .. }), "{singular}");
    // Positive definite, but with an eigenvalue that is lost beside the other.
    let error = Constant::new(matrix![1.0, 0.0; 0.0, 1e-16]).expect_err("no certain c1");
    assert!(matches!(error, GalleryError::Constants(_)), "{error}");
}

/// Parameters that are fine one by one, but not together: no constant may be infinite.
#[test]
fn constants_that_overflow_are_refused() {
    let overflows = |outcome: Option<GalleryError>| {
        assert!(matches!(outcome, Some(GalleryError::Constants(_))), "{outcome:?}");
    };
    overflows(Lens::new(1e300, 1e-300).err());
    overflows(Bump::new(1e300, 1.0).err());
    overflows(Hill::new(1e300, 1.0).err());
    overflows(Shear::new(1e200, 1.0).err());
    overflows(Ramp::new(0.5, 1e200).err());
    overflows(Swirl::new(1e200, 1.0).err());
    overflows(EggCrate::new(1e200, 1.0).err());
    overflows(Corrugated::new(1.0, 1e200).err());
    overflows(Checkerboard::new(1e300, 1e-300).err());
    overflows(TwoChannels::new(1e300, 1.0, 1e-300).err());
    overflows(Separable::new(SVector::<f64, 1>::new(0.5), SVector::<f64, 1>::new(1e200)).err());
    overflows(RotatingAnisotropy::new([1.0, 2.0], vector![1e200, 0.0]).err());
}

#[test]
fn the_messages_name_the_parameter_and_its_range() {
    let message = |error: Option<GalleryError>| error.expect("a bad parameter").to_string();
    assert_eq!(
        message(Ramp::new(-1.5, 1.0).err()),
        "amplitude = -1.5 must lie strictly between -1 and 1"
    );
    assert_eq!(message(Lens::new(1.0, 0.0).err()), "width = 0 must be positive and finite");
    assert_eq!(message(Bump::new(-2.0, 1.0).err()), "height = -2 must be nonnegative and finite");
    assert_eq!(message(Shear::new(f64::NAN, 1.0).err()), "amplitude = NaN must be finite");
    assert_eq!(
        message(TwoLinkArm::new(2.0, 2.0, 1.0).err()),
        "C (A - C) - B² = -3, the determinant of the inertia of the stretched arm, must be positive"
    );
}
