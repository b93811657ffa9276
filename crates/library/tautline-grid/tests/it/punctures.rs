//! Punctures, and the words of curves past them.

use nalgebra::{SVector, vector};
use tautline_formula::Plain;
use tautline_grid::{Lattice, Punctures};
use tautline_metrics::gallery::{Obstacle, SoftObstacles};
use tautline_sets::{Ends, HalfSpace, Point};

/// The rays of punctures in a row go up. A corner exactly above a puncture belongs to the right: a polygon
/// that goes on past it has the letter of the chord, one that turns back on the left crosses the ray to and
/// fro, and one that turns back on the right never does.
#[test]
fn a_corner_above_a_puncture_keeps_its_letter() {
    let row = [[0.0, 0.0], [1.0, 0.5], [2.0, -0.5]];
    let word = |corners: &[SVector<f64, 2>]| {
        Punctures::new(row.to_vec()).expect("points").word(corners).letters().to_vec()
    };
    let (left, right) = (vector![-1.0, 1.0], vector![3.0, 1.0]);
    assert_eq!(word(&[left, right]), [1, 2, 3]);
    assert_eq!(word(&[right, left]), [-3, -2, -1]);
    for (k, [x, _]) in row.into_iter().enumerate() {
        let (above, higher) = (vector![x, 1.0], vector![x, 3.0]);
        assert_eq!(word(&[left, above, right]), [1, 2, 3]);
        assert_eq!(word(&[left, above, higher, right]), [1, 2, 3]);
        assert_eq!(word(&[right, above, left]), [-3, -2, -1]);
        let [before, behind] = [vector![x - 0.5, 1.0], vector![x + 0.5, 1.0]];
        let letter = k as i32 + 1;
        assert_eq!(word(&[before, above]), [letter]);
        assert_eq!(word(&[above, before]), [-letter]);
        assert_eq!(word(&[before, above, before]), []);
        assert_eq!(word(&[above, behind]), []);
        assert_eq!(word(&[behind, above]), []);
        // Below the puncture there is no ray.
        assert_eq!(word(&[vector![x - 0.5, -1.0], vector![x, -1.0], vector![x + 0.5, -1.0]]), []);
    }
}

/// A chord crosses a ray where it meets its line, and not where its middle is: the middles of these chords
/// are on the other side of the height of the puncture.
#[test]
fn a_steep_chord_crosses_a_ray_where_it_meets_its_line() {
    let puncture = Punctures::new(vec![[0.0, 0.0]]).expect("a point");
    let word = |a, b| puncture.word::<2>(&[a, b]).letters().to_vec();
    let near = -0.1;
    assert_eq!(word(vector![near, 9.0], vector![9.0, -10.0]), [1]);
    assert_eq!(word(vector![near, -9.0], vector![9.0, 10.0]), []);
    assert_eq!(word(vector![9.0, -10.0], vector![near, 9.0]), [-1]);
    assert_eq!(word(vector![9.0, 10.0], vector![near, -9.0]), []);
}

/// The first of many punctures have the words that they have alone, but for the direction of the rays: they
/// tell the same curves apart, and letters name none but them.
#[test]
fn the_first_punctures_tell_what_they_tell_alone() {
    let points = vec![[0.4, 0.9], [-0.7, -0.2], [0.1, -0.8], [-0.3, 0.5], [0.8, -0.4]];
    let first = Punctures::new(points.clone()).expect("points").first(2);
    let alone = Punctures::new(points[..2].to_vec()).expect("points");
    assert_eq!(first.points(), alone.points());
    let through =
        |y: f64, z: f64| [vector![-3.0, 0.0], vector![-0.7, y], vector![0.4, z], vector![3.0, 0.1]];
    let curves = [[-1.0, -1.0], [-1.0, 2.0], [1.0, -1.0], [1.0, 2.0], [1.5, 2.5], [-2.0, -0.5]];
    let curves = curves.map(|[y, z]| through(y, z));
    for a in &curves {
        let word = first.word(a);
        assert!(word.letters().iter().all(|letter| letter.abs() <= 2), "{word}");
        for b in &curves {
            assert_eq!(first.word(b) == word, alone.word(b) == alone.word(a), "{word}");
        }
    }
}

/// The members to which curves are prolonged are those nearest to the mean of the punctures, not to their
/// sum: here the point `(4, 1)` of the half-plane above them.
#[test]
fn curves_are_prolonged_to_the_points_nearest_to_the_mean_of_the_punctures() {
    let punctures = Punctures::new(vec![[3.0, 0.0], [4.0, 0.0], [5.0, 0.0]]).expect("points");
    let roof = HalfSpace::at_least([0.0, 1.0], 1.0).expect("a half-plane");
    let ends = Ends::new(roof, Point::new([4.0, -3.0]).expect("finite")).expect("bounded");
    // From the left end of the roof down, and back below the punctures.
    let corners = [vector![2.0, 1.0], vector![2.0, -1.0], vector![4.5, -1.0]];
    assert_eq!(punctures.word_between(&ends, &corners).letters(), [-2, -1]);
    assert!(punctures.word(&corners).letters().is_empty());
}

/// In space the peaks are those half way up, and a prominence is that of the scale `(det H)^{1/2D}`, which is
/// `√(1 + height)` for a hill `(1 + height) I` in any dimension.
#[test]
fn a_prominence_means_the_same_in_any_dimension() {
    fn found<const D: usize>(prominence: f64) -> Vec<[f64; 2]> {
        // Half way up a box that begins at 0 in the further coordinates.
        let centre = SVector::from_fn(|i, _| if i < 2 { 0.05 } else { 0.5 });
        let hill = Obstacle { centre, height: 3.0, width: 0.25 };
        let metric = SoftObstacles::<D>::new(vec![hill]).expect("a hill");
        let lower = SVector::from_fn(|i, _| if i < 2 { -1.2 } else { 0.0 });
        let upper = SVector::from_fn(|i, _| if i < 2 { 1.2 } else { 1.0 });
        let lattice = Lattice::with_spacings(lower, upper, SVector::from_element(0.05));
        let lattice = lattice.expect("a box");
        let peaks = Punctures::peaks(&Plain::new(&metric), &lattice, prominence);
        peaks.expect("a prominence").points().to_vec()
    }
    // The top is a node, of the scale 2, and the boundary is 4.6 widths away: 3 e^{−10} is negligible.
    for (prominence, count) in [(1.99, 1), (2.01, 0)] {
        let counts = [found::<2>(prominence).len(), found::<3>(prominence).len()];
        assert_eq!(counts, [count; 2], "{prominence}");
    }
    let [[x, y]] = found::<3>(1.5)[..] else { panic!("one hill") };
    assert!((x - 0.05).abs() < 1e-12 && (y - 0.05).abs() < 1e-12, "{x} {y}");
}
