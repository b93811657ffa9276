//! Straight sequences, and sequences that are refused.

use nalgebra::{SVector, vector};

use super::{LARGEST_N, PointSequence, SequenceError};

#[test]
fn a_straight_sequence_is_equidistant_and_ends_exactly() {
    let line = PointSequence::straight([0.1, 0.2], [0.7, -0.3], 7).expect("finite");
    assert_eq!(line.n().get(), 7);
    assert_eq!((line.first(), line.last()), (&vector![0.1, 0.2], &vector![0.7, -0.3]));
    // Differences of coordinates below 1 are multiplied by 7, so rounding is about 7 ε.
    assert!(line.differences().all(|beta| (beta - vector![0.6, -0.5]).amax() < 1e-14));
    approx::assert_relative_eq!(line.k3(), 0.61_f64.sqrt(), max_relative = 1e-14);
}

/// For one in five of these sequences, `a + t (b − a)` would miss `b` by a rounding.
#[test]
fn straight_sequences_always_end_exactly() {
    for k in 1..1000 {
        let wave = |j: i32| (f64::from(k) * f64::from(j).sqrt()).sin();
        let (a, b) = (vector![wave(2), 1e3 * wave(3)], vector![wave(5), 1e-3 * wave(7)]);
        let line = PointSequence::straight(a, b, 1 + k as usize % 9).expect("finite");
        assert_eq!((line.first(), line.last()), (&a, &b));
    }
    // The difference of these ends overflows.
    let wide = PointSequence::straight([-f64::MAX], [f64::MAX], 4).expect("finite");
    assert_eq!(wide.points()[2], vector![0.0]);
}

/// If there is one jump, `β = N (b − a)` occurs once, so `K₃ = √N |b − a|`.
#[test]
fn k3_of_one_jump_is_sqrt_n() {
    let mut points = vec![vector![0.0]; 4];
    points.push(vector![3.0]);
    let jump = PointSequence::new(points).expect("finite");
    assert_eq!(jump.k3(), 6.0);
    assert_eq!(jump.clone().into_points(), jump.points());
}

/// In dimension 0 any number of points takes no memory.
#[test]
fn more_chords_than_rounding_allows_are_refused() {
    let too_many = |n| Err(SequenceError::TooManySubintervals { n });
    let points = |n: usize| PointSequence::new(vec![SVector::<f64, 0>::zeros(); n + 1]);
    let exactly =
        PointSequence::straight([0.0], [1.0], 5).map(|line| line.into_points().capacity());
    assert_eq!(exactly, Ok(6));
    assert_eq!(points(LARGEST_N).map(|line| line.n().get()), Ok(LARGEST_N));
    assert_eq!(points(LARGEST_N + 1).map(|_| ()), too_many(LARGEST_N + 1));
    // The points would take 8 or 512 bytes each, but nothing is allocated.
    for n in [LARGEST_N + 1, 1_000_000_000, usize::MAX - 1, usize::MAX] {
        assert_eq!(PointSequence::straight([0.0], [1.0], n).map(|_| ()), too_many(n));
        let line = PointSequence::straight([0.0; 64], [1.0; 64], n);
        assert_eq!(line.map(|_| ()), too_many(n));
    }
    assert_eq!(LARGEST_N as f64, f64::EPSILON.powf(-0.5));
}

#[test]
fn the_extent_is_the_largest_coordinate_wherever_it_is() {
    for count in 2..=5 {
        for (index, coordinate) in (0..count).flat_map(|i| (0..2).map(move |j| (i, j))) {
            let mut points = vec![vector![1.0, -2.0]; count];
            points[index][coordinate] = -3.0;
            let extent = PointSequence::new(points).map(|sequence| sequence.extent());
            assert_eq!(extent, Ok(3.0), "{index} of {count}");
        }
    }
}

#[test]
fn bad_points_are_reported_by_index() {
    assert_eq!(
        PointSequence::straight([0.0], [1.0], 0),
        Err(SequenceError::NoSubinterval { points: 1 })
    );
    assert_eq!(PointSequence::<2>::new(vec![]), Err(SequenceError::NoSubinterval { points: 0 }));
    let error = PointSequence::new(vec![vector![0.0, 0.0], vector![0.0, f64::NAN]]);
    assert!(matches!(error, Err(SequenceError::NotFinite { index: 1, coordinate: 1, .. })));
    assert!(PointSequence::straight([0.0], [f64::INFINITY], 2).is_err());
    let one = PointSequence::new(vec![vector![1.0]]);
    assert_eq!(one, Err(SequenceError::NoSubinterval { points: 1 }));
    assert!(PointSequence::new(vec![vector![1.0]; 2]).is_ok());
    // The defect is at any place among an even or an odd number of points.
    for count in 2..=5 {
        for (index, coordinate) in (0..count).flat_map(|i| (0..3).map(move |j| (i, j))) {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut points = vec![vector![1.0, -2.0, 3.0]; count];
                points[index][coordinate] = bad;
                let Err(SequenceError::NotFinite { index: i, coordinate: j, value }) =
                    PointSequence::new(points)
                else {
                    panic!("{bad} at {index}")
                };
                assert_eq!((i, j, value.to_bits()), (index, coordinate, bad.to_bits()));
            }
        }
    }
    // The first of several defects is reported, wherever it is.
    let bad = f64::NEG_INFINITY;
    for (index, coordinate) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
        let mut points = vec![vector![0.0, 0.0, 0.0]; 3];
        points[index][coordinate] = bad;
        for later in coordinate + 1..3 {
            points[index][later] = f64::NAN;
        }
        for later in index + 1..3 {
            points[later] = vector![f64::NAN, f64::NAN, f64::NAN];
        }
        let error = SequenceError::NotFinite { index, coordinate, value: bad };
        assert_eq!(PointSequence::new(points), Err(error));
    }
}
