//! What has no certificate, and the error that says why.

use nalgebra::{SVector, matrix, vector};
use tautline_check::CheckError;
use tautline_distance::{DistanceError, Wanted};
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    attempt::attempt,
    flat::{at_least, formula, point},
};

fn refused<const D: usize>(
    formula: &Formula<D>,
    sets: &[Shape<D>; 2],
    curves: &[Vec<SVector<f64, D>>],
    gap: f64,
) -> DistanceError {
    match attempt(formula, sets, curves, Wanted { gap, cubes: 50_000 }) {
        Err(error) => error,
        Ok(found) => panic!("{:?}", found.proved.levels),
    }
}

#[test]
fn a_gap_is_between_0_and_1() {
    let flat = formula(&matrix![1.0, 0.0; 0.0, 1.0]);
    let sets = [point([0.0, 0.0]), point([1.0, 0.0])];
    for gap in [0.0, 1.0, -0.1, 2.0, f64::INFINITY, f64::NAN] {
        let error = refused(&flat, &sets, &[vec![vector![0.0, 0.0], vector![1.0, 0.0]]], gap);
        assert!(
            matches!(error, DistanceError::Gap { gap: found } if found.to_bits() == gap.to_bits()),
            "{error:?}"
        );
    }
}

#[test]
fn a_curve_runs_from_set_to_set_with_a_length() {
    let flat = formula(&matrix![1.0, 0.0; 0.0, 1.0]);
    let sets = [point([0.0, 0.0]), at_least([1.0, 0.0], 1.0)];
    let end = |curves: &[Vec<SVector<f64, 2>>]| match refused(&flat, &sets, curves, 0.1) {
        DistanceError::Curve(CheckError::CurveEnd { end }) => end,
        error => panic!("{error:?}"),
    };
    assert_eq!(end(&[]), "first");
    assert_eq!(end(&[vec![]]), "first");
    assert_eq!(end(&[vec![vector![0.0, 0.0]]]), "first");
    // Equal sets: a curve without length.
    let same = [point([0.0, 0.0]), point([0.0, 0.0])];
    let error = refused(&flat, &same, &[vec![vector![0.0, 0.0]; 2]], 0.1);
    assert_eq!(error, DistanceError::Length { length: 0.0 });
    // Over a place where the metric is undefined.
    let pole = Formula::<2>::parse("(1 + (1/x1)^0) I", &[]).expect("a formula");
    let around = [point([-1.0, 0.0]), point([1.0, 0.0])];
    let error = refused(&pole, &around, &[vec![vector![-1.0, 0.0], vector![1.0, 0.0]]], 0.1);
    assert_eq!(error, DistanceError::Curve(CheckError::CurveDomain { chord: 0 }));
}

#[test]
fn one_of_the_sets_is_bounded() {
    let flat = formula(&matrix![1.0, 0.0; 0.0, 1.0]);
    let curve = vec![vector![-1.0, 0.0], vector![1.0, 0.0]];
    let wall = at_least([1.0, 0.0], 1.0);
    let other = at_least([-1.0, 0.0], 1.0);
    // A union is unbounded if one of its pieces is.
    let mixed = Shape::Union(vec![point([-2.0, 0.0]), other.clone()]);
    for first in [other, mixed] {
        let error = refused(&flat, &[first, wall.clone()], std::slice::from_ref(&curve), 0.1);
        assert_eq!(error, DistanceError::Unbounded);
    }
}

/// Between antipodes of the sphere the way past infinity, which no cubes hold, is as short as the others.
#[test]
fn short_curves_that_leave_every_region_have_none() {
    let sphere = Formula::<2>::parse("4/sqr(1 + x1^2 + x2^2) I", &[]).expect("a formula");
    let line = |n: i32| vector![f64::from(n) / 100.0 - 1.0, 0.0];
    let curve: Vec<_> = (0..=200).map(line).collect();
    let error = refused(&sphere, &[point([-1.0, 0.0]), point([1.0, 0.0])], &[curve], 0.1);
    assert!(
        matches!(error, DistanceError::Region { hi, .. } if (hi - std::f64::consts::PI).abs() < 1e-3),
        "{error:?}"
    );
}

/// There the cubes would be smaller than the spacing of doubles.
#[test]
fn sets_too_far_from_the_origin_are_refused() {
    let flat = formula(&matrix![1.0, 0.2; 0.2, 1.0]);
    let (x, y) = (vector![1e12, 0.0], vector![1e12 + 1.0, 1.0]);
    let error = refused(&flat, &[point(x), point(y)], &[vec![x, y]], 0.1);
    assert!(
        matches!(
            error,
            DistanceError::Refused(CheckError::TooFar { .. } | CheckError::Place { .. })
        ),
        "{error:?}"
    );
}

#[test]
fn five_dimensions_have_no_checker() {
    let flat = formula(&nalgebra::SMatrix::<f64, 5, 5>::identity());
    let (x, y) = (SVector::from([0.0; 5]), SVector::from([1.0; 5]));
    let error = refused(&flat, &[point(x), point(y)], &[vec![x, y]], 0.1);
    assert_eq!(error, DistanceError::Refused(CheckError::Dimension { dimension: 5 }));
}
