//! Boxes and spacings that are a lattice, and those that are none.

use tautline_lattice::{GraphPathError, Lattice};

/// Far from 0 the ends of a lattice are rounded more than its spacing.
#[test]
fn rounding_loses_no_node() {
    for origin in [1.0, 100.1, 1e4 + 0.3] {
        for spacing in [0.1, 0.2, 0.3, 0.7] {
            for steps in [3, 7, 100] {
                let last = origin + spacing * f64::from(steps);
                let lattice = Lattice::new([origin], [last], spacing).expect("a lattice");
                assert_eq!(lattice.nodes(), steps as usize + 1, "{origin} + {steps} of {spacing}");
            }
        }
    }
}

#[test]
fn what_is_no_lattice_is_refused() {
    let refused = |lower, upper, spacing| {
        Lattice::<2>::new(lower, upper, spacing).expect_err("no lattice").to_string()
    };
    for (lower, upper, spacing, says) in [
        ([0.0, 1.0], [1.0, 0.0], 0.1, "coordinate 2 of a lattice from 1 to 0"),
        ([0.0, 0.0], [1.0, 1.0], 0.0, "coordinate 1"),
        ([0.0, 0.0], [1.0, 1.0], -0.5, "coordinate 1"),
        ([0.0, 0.0], [1.0, 1.0], f64::INFINITY, "coordinate 1"),
        ([0.0, f64::NAN], [1.0, 1.0], 0.1, "coordinate 2"),
        ([f64::NEG_INFINITY, 0.0], [1.0, 1.0], 0.1, "coordinate 1"),
        ([0.0, 0.0], [1e30, 1.0], 1e-3, "nodes; at most"),
        ([0.0, 0.0], [1e9, 1e9], 1e-3, "e12 nodes; at most 8388608"),
    ] {
        assert!(
            refused(lower, upper, spacing).contains(says),
            "{}",
            refused(lower, upper, spacing)
        );
    }
    let error = Lattice::<5>::new([0.0; 5], [1.0; 5], 1.0);
    assert_eq!(error, Err(GraphPathError::Dimension { dimension: 5 }));
    // Ten steps of a tenth, which is a little more than a tenth.
    assert_eq!(Lattice::<2>::new([0.0, 0.0], [1.0, 1.0], 0.1).expect("a lattice").nodes(), 121);
}
