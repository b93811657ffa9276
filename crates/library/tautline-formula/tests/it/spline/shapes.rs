//! What a spline is made from: errors, equality and the fingerprint.

use std::collections::{BTreeSet, HashSet};

use tautline_formula::spline::{Spline, SplineError};

const LARGE: f64 = f64::from_bits((1023 + 1000) << 52);

fn refused(shape: &[usize], numbers: &[f64]) -> SplineError {
    let error = Spline::new(shape, numbers.to_vec()).expect_err("no spline");
    let same = Spline::interpolating(shape, numbers.to_vec()).expect_err("no spline");
    assert_eq!(format!("{error:?}"), format!("{same:?}"));
    error
}

#[test]
fn invalid_shapes_are_errors_with_their_numbers() {
    let of = |shape: &[usize]| shape.to_vec();
    for shape in [&[][..], &[1, 1, 1, 1]] {
        assert_eq!(refused(shape, &[1.0]), SplineError::Axes { shape: of(shape) });
    }
    let shape = of(&[3, 0, 2]);
    assert_eq!(refused(&shape, &[]), SplineError::EmptyAxis { axis: 1, shape: shape.clone() });
    let shape = of(&[usize::MAX, 2]);
    assert_eq!(refused(&shape, &[]), SplineError::Overflow { shape: shape.clone() });
    let shape = of(&[2, 3]);
    let error = refused(&shape, &[0.0; 5]);
    assert_eq!(error, SplineError::Count { shape, expected: 6, found: 5 });
    assert_eq!(error.to_string(), "the shape [2, 3] needs 6 numbers, not 5");
    assert!(refused(&[], &[]).to_string().ends_with("[] has 0 axes; a spline has 1, 2 or 3"));
}

#[test]
fn invalid_numbers_are_errors_with_their_positions() {
    let mut numbers = [0.0; 12];
    numbers[7] = f64::INFINITY;
    let index = vec![1, 0, 1];
    let error = refused(&[2, 2, 3], &numbers);
    assert_eq!(error, SplineError::NotFinite { index: index.clone(), value: f64::INFINITY });
    numbers[7] = f64::NAN;
    let text = refused(&[2, 2, 3], &numbers).to_string();
    assert_eq!(text, "the number at [1, 0, 1] is NaN, which is not finite");
    numbers[7] = -LARGE.next_up();
    let error = refused(&[2, 2, 3], &numbers);
    assert_eq!(error, SplineError::TooLarge { index, value: -LARGE.next_up() });
    numbers[7] = LARGE;
    assert!(Spline::new(&[2, 2, 3], numbers.to_vec()).is_ok());
    // Interpolation makes a coefficient that is too large.
    let overshoot = Spline::interpolating(&[3], vec![-LARGE, LARGE, -LARGE]);
    assert!(matches!(overshoot, Err(SplineError::TooLarge { .. })), "{overshoot:?}");
}

#[test]
fn the_last_axis_is_the_fastest() {
    let spline = Spline::new(&[1, 2, 3], vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0]).expect("finite");
    assert_eq!(spline.shape(), [1, 2, 3]);
    for (j, x) in [(0, f64::NEG_INFINITY), (1, f64::INFINITY)] {
        for (k, y) in [(0, f64::NEG_INFINITY), (2, f64::INFINITY)] {
            let corner = f64::from(3 * j + k);
            assert_eq!(spline.value(&[0.0, x, y], [0; 3]), corner);
            assert_eq!(spline.coefficients()[(3 * j + k) as usize], corner);
        }
    }
}

#[test]
fn splines_are_equal_if_shape_and_bits_are() {
    let new =
        |shape: &[usize], numbers: &[f64]| Spline::new(shape, numbers.to_vec()).expect("fine");
    let numbers = [1.0, 2.0, 3.0, 0.0];
    let splines = [
        new(&[4], &numbers),
        new(&[1, 4], &numbers),
        new(&[4, 1], &numbers),
        new(&[2, 2], &numbers),
        new(&[1, 1, 4], &numbers),
        new(&[2, 2], &[1.0, 2.0, 3.0, -0.0]),
        new(&[2, 2], &[1.0, 2.0, 3.0f64.next_up(), 0.0]),
        new(&[2, 2], &[2.0, 1.0, 3.0, 0.0]),
    ];
    for (i, a) in splines.iter().enumerate() {
        for (j, b) in splines.iter().enumerate() {
            assert_eq!(a == b, i == j, "{a:?} {b:?}");
        }
        assert_eq!(*a, a.clone());
    }
    let prints: BTreeSet<u64> = splines.iter().map(Spline::fingerprint).collect();
    assert_eq!(prints.len(), splines.len());
    assert_eq!(splines.iter().cloned().collect::<HashSet<_>>().len(), splines.len());
    assert_eq!(splines[3], new(&[2, 2], &numbers));
}

/// The fingerprint is part of what others write down, so it never changes.
#[test]
fn the_fingerprint_is_the_same_everywhere() {
    let spline = Spline::new(&[2, 2], vec![1.0, -2.0, 0.5, 4.0]).expect("finite");
    assert_eq!(format!("{spline:?}"), "Spline([2, 2], cd981ab65a5f116b)");
}

#[test]
fn threads_can_share_a_spline() {
    fn shared<T: Send + Sync>(_: &T) {}
    shared(&Spline::new(&[1], vec![1.0]).expect("finite"));
}
