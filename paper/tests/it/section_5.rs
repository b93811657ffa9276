//! The constructed minimisers of Section 5, by brute force.

use tautline::{PointSequence, Rule, gallery::Valleys};

use paper::section_5::{
    DISCRETE_LENGTH, along_the_axis, grid_sequences, left_minimisers, trapezoidal_minimisers,
};

/// Section 5: the constructed sequences have length `4π` and the stated number.
#[test]
fn section_5_minimisers_have_length_4_pi() {
    for n in [1, 2, 3, 7, 20] {
        assert_eq!(left_minimisers(n).count(), n * (n + 1) / 2);
        assert_eq!(trapezoidal_minimisers(n).count(), n);
        // At most twenty chords of length 4π: rounding below 1e-13.
        for x1 in left_minimisers(n) {
            let line = along_the_axis(&x1).expect("finite");
            assert!((Rule::LEFT_ENDPOINT.length(&Valleys, &line) - DISCRETE_LENGTH).abs() < 1e-13);
        }
        for x1 in trapezoidal_minimisers(n) {
            let line = along_the_axis(&x1).expect("finite");
            assert!((Rule::TRAPEZOIDAL.length(&Valleys, &line) - DISCRETE_LENGTH).abs() < 1e-13);
        }
    }
}

/// Section 5 by brute force, on a grid with every place where `f = 1`, ridges and detours: no
/// sequence is shorter than `4π`, and as many attain it as were constructed.
#[test]
fn section_5_by_brute_force() {
    for n in 1..=4 {
        let (mut left, mut trapezoidal) = (0, 0);
        for points in grid_sequences(n) {
            let sequence = PointSequence::new(points).expect("finite");
            for (length, count) in [
                (Rule::LEFT_ENDPOINT.length(&Valleys, &sequence), &mut left),
                (Rule::TRAPEZOIDAL.length(&Valleys, &sequence), &mut trapezoidal),
            ] {
                // The next longer sequence is longer by far more than rounding.
                assert!(length >= DISCRETE_LENGTH - 1e-12);
                *count += usize::from(length < DISCRETE_LENGTH + 1e-12);
            }
        }
        assert_eq!((left, trapezoidal), (n * (n + 1) / 2, n), "N = {n}");
    }
}
