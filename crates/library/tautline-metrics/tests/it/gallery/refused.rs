//! Every bad parameter is refused with its name, its number and its range.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_metrics::{MetricError, gallery::*};

/// The requirement on a parameter, and numbers that violate it.
type Clause = (&'static str, &'static [f64]);

pub(crate) const FINITE: Clause = ("be finite", &[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
pub(crate) const POSITIVE: Clause =
    ("be positive and finite", &[0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
const NONNEGATIVE: Clause =
    ("be nonnegative and finite", &[-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
const BELOW_ONE: Clause =
    ("lie strictly between -1 and 1", &[1.0, -1.0, 1.5, f64::NAN, f64::INFINITY]);

/// Asserts that every `build` refuses the bad numbers of the clause with a message that contains
/// the name and the number.
#[track_caller]
pub(crate) fn refused<const K: usize>(
    (clause, bad): Clause,
    name: &str,
    build: impl Fn(f64) -> [Option<GalleryError>; K],
) {
    for &value in bad {
        for (k, error) in build(value).into_iter().enumerate() {
            let error = error.unwrap_or_else(|| panic!("{k}: {name} = {value} passes"));
            assert_eq!(error.to_string(), format!("{name} = {value} must {clause}"), "{k}");
        }
    }
}

#[test]
fn waves_need_amplitudes_and_wave_numbers() {
    refused(BELOW_ONE, "amplitude", |bad| {
        [Ramp::new(bad, 1.0).err(), Separable::new([0.5, bad], [1.0, 1.0]).err()]
    });
    refused(POSITIVE, "wave number", |bad| {
        [
            Ramp::new(0.5, bad).err(),
            Shear::new(0.5, bad).err(),
            EggCrate::new(0.5, bad).err(),
            Corrugated::new(0.5, bad).err(),
            Separable::new([0.5, 0.5], [1.0, bad]).err(),
        ]
    });
    refused(FINITE, "amplitude", |bad| {
        [Shear::new(bad, 1.0).err(), EggCrate::new(bad, 1.0).err(), Corrugated::new(bad, 1.0).err()]
    });
}

#[test]
fn profiles_need_heights_and_widths() {
    let obstacles = |centre: [f64; 2], height, width| {
        let good = Obstacle { centre: vector![0.0, 1.0], height: 1.0, width: 1.0 };
        SoftObstacles::new(vec![good, Obstacle { centre: centre.into(), height, width }]).err()
    };
    refused(POSITIVE, "width", |bad| {
        [
            Lens::new(1.0, bad).err(),
            Bump::new(1.0, bad).err(),
            Hill::new(1.0, bad).err(),
            obstacles([0.0, 1.0], 1.0, bad),
            Swirl::new(1.0, bad).err(),
            TwoChannels::new(1.0, 1.0, bad).err(),
        ]
    });
    refused(POSITIVE, "cell", |bad| [Checkerboard::new(1.0, bad).err()]);
    refused(POSITIVE, "offset", |bad| [TwoChannels::new(1.0, bad, 1.0).err()]);
    refused(NONNEGATIVE, "height", |bad| {
        [
            Lens::new(bad, 1.0).err(),
            Bump::new(bad, 1.0).err(),
            obstacles([0.0, 1.0], bad, 1.0),
            Checkerboard::new(bad, 1.0).err(),
            TwoChannels::new(bad, 1.0, 1.0).err(),
        ]
    });
    refused(FINITE, "height", |bad| [Hill::new(bad, 1.0).err()]);
    refused(FINITE, "angle", |bad| [Swirl::new(bad, 1.0).err()]);
    refused(FINITE, "coordinate of a centre", |bad| [obstacles([0.0, bad], 1.0, 1.0)]);
    assert!(Hill::new(-1.0, 1.0).is_ok(), "a hollow");
    assert!(Lens::new(0.0, 1.0).is_ok(), "the Euclidean plane");
    assert!(SoftObstacles::<2>::new(vec![]).is_ok(), "the Euclidean plane");
}

#[test]
fn directions_need_finite_entries() {
    let good = vector![1.0, 0.0];
    let projection = |wave_vector, direction| {
        SineProjections::new(vec![SineProjection { wave_vector, direction }]).err()
    };
    refused(FINITE, "entry of a wave vector", |bad| [projection(vector![0.0, bad], good)]);
    refused(FINITE, "entry of a direction", |bad| [projection(good, vector![0.0, bad])]);
    refused(FINITE, "entry of the wave vector", |bad| {
        [RotatingAnisotropy::new([1.0, 2.0], [0.0, bad]).err()]
    });
    refused(POSITIVE, "eigenvalue", |bad| {
        [[bad, 1.0], [1.0, bad]].map(|values| RotatingAnisotropy::new(values, good).err())
    });
}

#[test]
fn arms_need_a_positive_definite_inertia() {
    refused(FINITE, "A", |bad| [TwoLinkArm::new(bad, 1.0, 1.0).err()]);
    refused(FINITE, "B", |bad| [TwoLinkArm::new(3.0, bad, 1.0).err()]);
    refused(POSITIVE, "C", |bad| [TwoLinkArm::new(3.0, 1.0, bad).err()]);
    // C (A − C) − B² is 1 · 1 − 1 and 1 · 1 − 4.
    for (b, determinant) in [(1.0, 0.0), (-2.0, -3.0)] {
        let error = TwoLinkArm::new(2.0, b, 1.0).expect_err("singular when stretched");
        assert_eq!(error, GalleryError::SingularArm { determinant });
        let message = format!(
            "C (A - C) - B² = {determinant}, the determinant of the inertia of the stretched arm, \
             must be positive"
        );
        assert_eq!(error.to_string(), message);
    }
    let link = Link { mass: 1.0, length: 1.0, centre: 0.5, inertia: 0.1 };
    let arm = |first, second| TwoLinkArm::from_links(first, second).err();
    refused(NONNEGATIVE, "mass", |mass| {
        [arm(Link { mass, ..link }, link), arm(link, Link { mass, ..link })]
    });
    refused(NONNEGATIVE, "length", |length| [arm(Link { length, ..link }, link)]);
    refused(NONNEGATIVE, "centre", |centre| [arm(Link { centre, ..link }, link)]);
    refused(NONNEGATIVE, "inertia", |inertia| [arm(Link { inertia, ..link }, link)]);
    // The second link has neither mass nor inertia, so C = 0.
    let nothing = Link { mass: 0.0, inertia: 0.0, ..link };
    assert_eq!(arm(link, nothing), Some(GalleryError::NotPositive { name: "C", value: 0.0 }));
}

#[test]
fn patches_need_a_radius_in_their_range() {
    for value in [0.0, -1.0, 1e-60, 1e60, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (error, name, high) in [
            (SpherePatch::new(value).err(), "radius", 1e50),
            (HyperbolicPatch::new(value).err(), "radius", 0.86),
            (GaussianFisherPatch::new(value).err(), "rim", 260.0),
        ] {
            let message =
                format!("{name} = {value:?} must lie strictly between 1e-50 and {high:?}");
            assert_eq!(error.expect("out of range").to_string(), message);
        }
    }
    assert!(HyperbolicPatch::new(0.86).is_err() && HyperbolicPatch::new(0.859).is_ok());
    assert!(GaussianFisherPatch::new(260.0).is_err() && GaussianFisherPatch::new(259.0).is_ok());
    assert!(SpherePatch::new(1e-50).is_err() && SpherePatch::new(1e50).is_err());
    assert!(SpherePatch::new(1e-49).is_ok() && SpherePatch::new(1e49).is_ok());
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
    for indefinite in [matrix![1.0, 2.0; 2.0, 1.0], matrix![1.0, 1.0; 1.0, 1.0]] {
        let error = refused(indefinite);
        assert!(matches!(error, MetricError::NotPositiveDefinite { .. }), "{error}");
    }
    // The matrix is positive definite, but one eigenvalue is below the rounding of the other.
    let error = Constant::new(matrix![1.0, 0.0; 0.0, 1e-16]).expect_err("no certain c1");
    assert!(matches!(error, GalleryError::Constants(_)), "{error}");
}

/// The square of a width of `1.4·10¹⁵⁴` overflows, and a lens of infinite width is no lens.
#[test]
fn widths_whose_squares_are_no_numbers_are_refused() {
    for width in [1e-170, 1.4e154] {
        for (name, error) in [
            ("lens", Lens::new(1.0, width).err()),
            ("bump", Bump::new(1.0, width).err()),
            ("hill", Hill::new(1.0, width).err()),
            ("swirl", Swirl::new(1.0, width).err()),
            ("two channels", TwoChannels::new(1.0, 1.0, width).err()),
        ] {
            let is_named = matches!(error, Some(GalleryError::OutOfRange { name: "width", .. }));
            assert!(is_named, "{name}: {error:?}");
        }
    }
}

/// Each parameter is valid on its own, but together they make a constant overflow; no constant may
/// be infinite.
#[test]
fn constants_that_overflow_are_refused() {
    let one = |x: f64| SVector::<f64, 1>::new(x);
    for (name, error) in [
        ("lens", Lens::new(1e300, 1e-100).err()),
        ("bump", Bump::new(1e300, 1.0).err()),
        ("hill", Hill::new(1e300, 1.0).err()),
        ("shear", Shear::new(1e200, 1.0).err()),
        ("ramp", Ramp::new(0.5, 1e200).err()),
        ("swirl", Swirl::new(1e200, 1.0).err()),
        ("egg crate", EggCrate::new(1e200, 1.0).err()),
        ("corrugated", Corrugated::new(1.0, 1e200).err()),
        ("checkerboard", Checkerboard::new(1e300, 1e-300).err()),
        ("two channels", TwoChannels::new(1e300, 1.0, 1e-100).err()),
        ("separable", Separable::new(one(0.5), one(1e200)).err()),
        ("rotating anisotropy", RotatingAnisotropy::new([1.0, 2.0], [1e200, 0.0]).err()),
    ] {
        assert!(matches!(error, Some(GalleryError::Constants(_))), "{name}: {error:?}");
    }
}
