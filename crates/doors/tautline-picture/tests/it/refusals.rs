//! What cannot be drawn is refused, with the number to change.

use tautline_picture::portrait::{Corridor, Cubes, Portrait, PortraitError};

use crate::shapes::{ball, point};

fn identity(_: &[f64]) -> Option<Vec<f64>> {
    Some(vec![1.0, 0.0, 0.0, 1.0])
}

#[track_caller]
fn assert_refused(portrait: Portrait<'_>, words: &str) {
    let error = portrait.draw().expect_err(words).to_string();
    assert!(error.contains(words), "{error:?} lacks {words:?}");
}

#[test]
fn vectors_need_a_finite_coordinate_for_each_dimension() {
    let good = Portrait::new(2, &identity);
    assert_refused(good, "neither a curve, a set nor a window");
    assert_refused(Portrait::new(0, &identity), "dimension");
    let short = [vec![0.0, 0.0], vec![1.0]];
    assert_refused(Portrait { curve: &short, ..good }, "point 1 of the curve has 1 coordinates");
    let nan = [vec![vec![0.0, f64::NAN]]];
    assert_refused(Portrait { others: &nan, ..good }, "coordinate 1 of point 0");
    let space = [point(&[0.0, 1.0]), ball(&[0.0, 0.0, 0.0], 1.0)];
    for ends in [[&space[..], &[]], [&space[..1], &space[1..]]] {
        assert_refused(Portrait { ends, ..good }, "a ball has 3 coordinates");
    }
}

#[test]
fn a_corridor_needs_whole_places_a_positive_side_and_ordered_bounds() {
    let refused = |side, places: &[i32], bounds, words| {
        let levels = [Cubes { side, places: places.to_vec() }];
        let corridor = Some(Corridor { levels: &levels, bounds });
        assert_refused(Portrait { corridor, ..Portrait::new(2, &identity) }, words);
    };
    refused(0.5, &[0, 1, 2], [1.0, 2.0], "the last cube has 1 coordinates");
    refused(-0.5, &[0, 1], [1.0, 2.0], "the side of a cube is -0.5");
    refused(0.5, &[0, 1], [2.0, 1.0], "the lower bound is 2");
    refused(0.5, &[0, 1], [0.0, f64::INFINITY], "the upper bound is inf");
}

#[test]
fn windows_need_an_inside() {
    let of =
        |x: [f64; 2]| Portrait { window: Some([x, [0.0, 1.0]]), ..Portrait::new(2, &identity) };
    for (side, words) in [
        ([1.0, 1.0], "1 to 1 along x1"),
        ([2.0, 1.0], "2 to 1 along x1"),
        ([0.0, f64::INFINITY], "0 to inf"),
        ([1e9, 1e9 + 1e-6], "1e-11"),
        ([-1e300, 1e300], "1e290"),
    ] {
        assert_refused(of(side), words);
    }
}

#[test]
fn coordinates_must_exist_and_differ() {
    let of = |coordinates| Portrait {
        coordinates: Some(coordinates),
        window: Some([[0.0, 1.0]; 2]),
        ..Portrait::new(2, &identity)
    };
    assert!(of([1, 0]).draw().is_ok());
    assert_refused(of([0, 2]), "0 and 2 cannot be drawn");
    assert_refused(of([1, 1]), "two of 0 to 1");
}

#[test]
fn a_gram_matrix_of_the_wrong_size_is_refused() {
    let small = |_: &[f64]| Some(vec![1.0]);
    let portrait = Portrait { window: Some([[0.0, 1.0]; 2]), ..Portrait::new(2, &small) };
    let error = portrait.draw().expect_err("one entry");
    assert!(matches!(error, PortraitError::Gram { length: 1, dimension: 2, .. }), "{error}");
}
