//! Distances agree with reference values that were computed independently (`golden.csv`).

use nalgebra::SVector;
use tautline_metrics::{KnownDistance, gallery::*};

/// Parses the numbers of a field, which are separated by blanks.
fn numbers<const K: usize>(field: &str) -> [f64; K] {
    let numbers = field.split_whitespace().map(|number| number.parse().expect("a number"));
    numbers.collect::<Vec<f64>>().try_into().expect("as many numbers as needed")
}

/// Asserts that the distance of the metric agrees with that of a row to its relative tolerance, in
/// both directions.
fn agrees<const D: usize>(row: &[&str], metric: impl KnownDistance<D>) {
    let [x, y] = [row[2], row[3]].map(|point| SVector::<f64, D>::from(numbers(point)));
    let [[distance], [tolerance]] = [row[4], row[5]].map(numbers);
    for found in [metric.distance(&x, &y), metric.distance(&y, &x)] {
        let found = found.expect("a pair with a known distance");
        assert!((found - distance).abs() <= tolerance * distance, "{row:?}: {found}");
    }
    // Rounding, not more.
    assert!(0.0 < tolerance && tolerance <= 1e-14, "{row:?}");
}

#[test]
#[should_panic = "1.000001"]
fn another_distance_does_not_agree() {
    let flat = Constant::<1>::new([[1.0]].into()).expect("definite");
    agrees("constant,1,0,1,1.000001,1e-14,no".split(',').collect::<Vec<_>>().as_slice(), flat);
}

#[test]
fn distances_have_their_reference_values() {
    let rows = include_str!("golden.csv").lines().skip(1);
    assert_eq!(rows.clone().count(), 20);
    for row in rows.map(|line| line.split(',').collect::<Vec<_>>()) {
        let two = || numbers::<2>(row[1]).into();
        let dimension = row[2].split_whitespace().count();
        match (row[0], dimension) {
            ("constant", _) => {
                let [a, b, c, d] = numbers(row[1]);
                agrees(&row, Constant::<2>::new([[a, b], [c, d]].into()).expect("definite"));
            }
            ("shear", _) => agrees(&row, made(Shear::new, two())),
            ("swirl", _) => agrees(&row, made(Swirl::new, two())),
            ("ramp", _) => agrees(&row, made(Ramp::new, two())),
            ("corrugated", 1) => agrees::<1>(&row, made(Corrugated::new, two())),
            ("corrugated", _) => agrees::<2>(&row, made(Corrugated::new, two())),
            ("hyperbolic", _) => agrees::<2>(&row, Hyperbolic),
            ("sphere", _) => agrees::<2>(&row, Sphere),
            ("valleys", _) => agrees::<2>(&row, Valleys),
            ("lens", _) => agrees::<2>(&row, made(Lens::new, two())),
            ("hill", _) => agrees::<2>(&row, made(Hill::new, two())),
            ("bump", _) => agrees::<2>(&row, made(Bump::new, two())),
            ("fisher", _) => {
                let [rim] = numbers(row[1]);
                agrees(&row, GaussianFisherPatch::new(rim).expect("a rim"));
            }
            (metric, _) => panic!("{metric}"),
        }
    }
}

fn made<M>(new: fn(f64, f64) -> Result<M, GalleryError>, (first, second): (f64, f64)) -> M {
    new(first, second).expect("in range")
}

/// The metric does not depend on `x₂`, and neither does any bit of its distances.
#[test]
fn distances_over_the_valleys_keep_their_bits_under_a_shift() {
    let [one, shifted] = [0.0, 1.0].map(|shift| {
        let [x, y] = [[2.0, 1.5 + shift], [0.0, shift]].map(SVector::<f64, 2>::from);
        Valleys.distance(&x, &y).expect("known")
    });
    assert_eq!(one, shifted);
}
