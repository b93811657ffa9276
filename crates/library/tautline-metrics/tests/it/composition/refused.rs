//! Every bad part is refused with its name and its number.

use nalgebra::{SMatrix, matrix, vector};
use tautline_metrics::{
    HypothesisError,
    composition::{AffinePullback, CompositionError, Scaled},
    gallery::Valleys,
};

fn stretches(matrix: SMatrix<f64, 2, 2>) -> (f64, f64) {
    match AffinePullback::new(Valleys, matrix, [0.0, 0.0]).expect_err("a bad matrix") {
        CompositionError::Hypothesis(HypothesisError::NotStretches { smin, smax }) => (smin, smax),
        other => panic!("{other}"),
    }
}

#[test]
fn a_factor_must_be_positive() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        match Scaled::new(Valleys, bad).expect_err("a bad factor") {
            CompositionError::Hypothesis(HypothesisError::NotAFactor { factor }) => {
                assert_eq!(factor.to_bits(), bad.to_bits());
            }
            other => panic!("{other}"),
        }
    }
    let message = Scaled::new(Valleys, -2.0).expect_err("negative").to_string();
    assert_eq!(message, "the factor -2 of a metric must be positive and finite");
}

#[test]
fn a_map_must_have_finite_entries() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = |matrix, shift: [f64; 2]| match AffinePullback::new(Valleys, matrix, shift)
            .expect_err("a bad entry")
        {
            CompositionError::NotFinite { name, value } => (name, value.to_bits()),
            other => panic!("{other}"),
        };
        let matrix = refused(matrix![1.0, 0.0; bad, 1.0], [0.0, 0.0]);
        assert_eq!(matrix, ("entry of the matrix", bad.to_bits()));
        let shift = refused(SMatrix::identity(), [0.0, bad]);
        assert_eq!(shift, ("entry of the shift", bad.to_bits()));
    }
}

#[test]
fn a_map_must_be_invertible() {
    assert_eq!(stretches(matrix![0.0, 0.0; 0.0, 0.0]), (0.0, 0.0));
    let (smin, smax) = stretches(matrix![1.0, 2.0; 2.0, 4.0]);
    assert!(smin <= 0.0 && (smax - 5.0).abs() < 1e-13, "{smin} {smax}");
    // The matrix is invertible, but this is not certain.
    let (smin, _) = stretches(matrix![1.0, 0.0; 0.0, 1e-16]);
    assert!(smin <= 0.0, "{smin}");
    // The squares of these entries overflow or underflow, although the map is a similarity.
    for scale in [1e300, 1e-300] {
        let map = matrix![0.6, -0.8; 0.8, 0.6] * scale;
        let pulled = AffinePullback::new(Valleys, map, [0.0, 0.0]).expect("invertible");
        let image = pulled.image(&(vector![1.0, 0.0] / scale));
        assert!((image - vector![0.6, 0.8]).norm() < 1e-15);
    }
    let (_, smax) = stretches(SMatrix::from_element(f64::MAX));
    assert_eq!(smax, f64::INFINITY);
}
