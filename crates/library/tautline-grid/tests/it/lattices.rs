//! Boxes and spacings that are a lattice, and those that are none.

use tautline_grid::{GraphPathError, Lattice};

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
        // All axes count, with all digits up to 2^53.
        ([0.0, 0.0], [1e9, 1e9], 1e-3, "a lattice of 1.000000000002e24 nodes; at most 8388608"),
        ([0.0, 0.0], [9999.0, 999.0], 1.0, "a lattice of 10000000 nodes; at most 8388608"),
        ([0.0, 0.0], [10_000_000.0, 0.0], 1.0, "a lattice of 10000001 nodes; at most 8388608"),
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

/// The last axis varies fastest. Beyond the box there is no node, on either side of any axis.
#[test]
fn nodes_places_and_points_belong_together() {
    let lattice = Lattice::<3>::with_spacings([0.0, -1.0, 2.0], [1.0, 2.0, 2.5], [0.5, 1.0, 0.5]);
    let lattice = lattice.expect("a lattice");
    assert_eq!((lattice.counts(), lattice.nodes()), ([3, 4, 2], 24));
    let mut node = 0;
    for i in 0..3 {
        for j in 0..4 {
            for k in 0..2 {
                let place = [i, j, k];
                assert_eq!(lattice.place(node), place);
                let point = [0.5 * i as f64, j as f64 - 1.0, 2.0 + 0.5 * k as f64];
                assert_eq!(lattice.point(node).as_slice(), point);
                assert_eq!(lattice.neighbour(&place, &[0, 0, 0]), Some(node));
                // Steps along one axis are 8, 2 and 1 nodes apart.
                for (axis, apart) in [(0, 8), (1, 2), (2, 1)] {
                    for step in [-2, -1, 1, 2] {
                        let mut offset = [0; 3];
                        offset[axis] = step;
                        let there = place[axis] as isize + step;
                        let is_inside = (0..[3, 4, 2][axis]).contains(&there);
                        let other = node as isize + apart * step;
                        let expected = is_inside.then_some(other as usize);
                        assert_eq!(lattice.neighbour(&place, &offset), expected, "{place:?}");
                    }
                }
                node += 1;
            }
        }
    }
}
