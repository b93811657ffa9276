//! Regions that short curves can leave are refused.

use nalgebra::SVector;
use tautline_check::{CheckError, Place, Region};
use tautline_sets::{HalfSpace, Shape};

use crate::helpers::{Function, axis_box, formula, on_cubes, point, proves_at_most};

/// `H` falls from 1 to 0.38 between 2 and 4.
const STEP: &str = "1/(1 + (0.25*x1)^8) I";

/// At the distance 2.2 from the set 0 or 1, `H` is 0.86.
#[test]
fn the_constant_of_tubes_holds_up_to_their_boundary() {
    let sets = [point([0.0]), point([1.0])];
    let region = Region::Tubes { radius: 2.2, c1: 0.9 };
    let refused = region.prove(&formula::<1>(STEP), sets.each_ref(), 4.0);
    assert!(matches!(refused, Err(CheckError::Constant { .. })), "{refused:?}");
}

/// A pocket in which `H` falls to 0.1, at the distance 0.92 from the point 0 in the direction of a corner.
/// Most of the box around the tube there is beyond it.
#[test]
fn the_constant_of_tubes_holds_in_the_direction_of_corners() {
    let region = Region::Tubes { radius: 1.0, c1: 0.5 };
    let proves = |x: f64, y: f64| {
        let metric = format!("1 - 0.9*exp(-1000*((x1 - ({x:?}))^2 + (x2 - ({y:?}))^2)) I");
        region.prove(&formula::<2>(&metric), [&point([0.0, 0.0]), &point([9.0, 0.0])], 1.0)
    };
    for [x, y] in [[0.65, 0.65], [-0.65, 0.65], [0.65, -0.65], [-0.65, -0.65]] {
        let refused = proves(x, y);
        assert!(matches!(refused, Err(CheckError::Constant { .. })), "({x}, {y}): {refused:?}");
        // A pocket beyond the tube does not matter, though it is in the box.
        assert_eq!(proves(1.4 * x, 1.4 * y), Ok(()), "({x}, {y})");
    }
}

/// `(1 0; 5 1)` is no metric, though `(1 0; 0 1)` is.
#[test]
fn the_constant_of_tubes_is_that_of_a_symmetric_matrix() {
    let region = Region::Tubes { radius: 1.0, c1: 0.5 };
    let proves = |metric: &str| {
        region.prove(&formula::<2>(metric), [&point([0.0, 0.0]), &point([9.0, 0.0])], 0.5)
    };
    assert_eq!(proves("[1, 0; 5, 1]"), Err(CheckError::Halves { row: 0, column: 1 }));
    assert_eq!(proves("[1, 0; 0, 1]"), Ok(()));
}

#[test]
fn the_constant_of_tubes_holds_about_both_sets() {
    let (near, far) = (point([0.0]), point([3.0]));
    for sets in [[&near, &far], [&far, &near]] {
        let region = Region::Tubes { radius: 2.2, c1: 0.9 };
        let refused = region.prove(&formula::<1>(STEP), sets, 4.0);
        assert!(matches!(refused, Err(CheckError::Constant { .. })), "{refused:?}");
    }
}

/// A length is `√c₁` times the Euclidean one, not `c₁` times.
#[test]
fn the_width_of_tubes_is_measured_by_the_root_of_the_constant() {
    let sets = [point([0.0]), point([1.0])];
    let proves = |radius: f64| {
        Region::Tubes { radius, c1: 4.0 }.prove(&formula::<1>("5 I"), sets.each_ref(), 2.0)
    };
    assert!(matches!(proves(0.3), Err(CheckError::Tubes { .. })), "{:?}", proves(0.3));
    assert_eq!(proves(0.5), Ok(()));
    // Curves of length 3 reach as far as √4 (|x| + |x − 1|) < 3, from −¼ to 1¼.
    let cubes = Region::Declared { c1: 4.0 }.required(sets.each_ref(), 3.0, -3);
    let cubes = cubes.expect("a region");
    assert!((-2..10).all(|k| cubes.contains(&[k])), "{:?}", cubes.places());
}

/// A facet in the planes of two sides of a box lies in the box only if it is between all of them.
#[test]
fn a_facet_beside_a_box_counts() {
    // The second one touches the cube, and the third one holds half of a side.
    for lower in [[3.0, 3.0], [1.0, 1.0], [1.0, 0.5]] {
        let sets = [point([0.5, 0.5]), axis_box(lower, [10.0, 10.0])];
        let zero = [&|_: &SVector<f64, 2>| 0.0; 2];
        let found = on_cubes("1 I", sets, 100.0, Region::ExitOne, 0, &[[0, 0]], [zero[0], zero[1]]);
        assert!(matches!(found, Err(CheckError::Exit { .. })), "{lower:?}: {found:?}");
    }
}

/// With `φ = ψ = 0`, nothing tells that a curve does not leave the cube, and a short one does.
#[test]
fn a_curve_may_leave_in_each_dimension() {
    fn refused<const D: usize>() {
        let mut far = [0.5; D];
        far[D - 1] = 3.0;
        let sets = [point([0.5; D]), point(far)];
        let zero: Function<'_, D> = &|_| 0.0;
        let found = on_cubes("1 I", sets, 100.0, Region::ExitOne, 0, &[[0; D]], [zero, zero]);
        assert!(matches!(found, Err(CheckError::Exit { .. })), "{D}: {found:?}");
    }
    refused::<1>();
    refused::<2>();
    refused::<3>();
    refused::<4>();
}

/// The curve from 0 to 1.2 leaves the cubes near 0 and ends outside of those near 10.
#[test]
fn both_sets_lie_in_the_cubes_of_exit_two() {
    let sets = [point([0.0]), Shape::Union(vec![point([1.2]), point([10.0])])];
    let phi = |x: &SVector<f64, 1>| if x[0] > 5.0 { 100.0 } else { x[0].abs() };
    let psi = |x: &SVector<f64, 1>| if x[0] > 5.0 { (x[0] - 10.0).abs() } else { 100.0 };
    let places = [[-1], [0], [9], [10]];
    let refused = on_cubes("1 I", sets, 1.9, Region::ExitTwo, 0, &places, [&phi, &psi]);
    assert!(matches!(refused, Err(CheckError::Missing { .. })), "{refused:?}");
}

/// On the low side of the cube, `φ` is 0 at one end and larger at the other.
#[test]
fn the_least_value_on_a_facet_counts() {
    let sets = [point([0.25, 0.25]), point([0.25, -0.05])];
    let phi = |x: &SVector<f64, 2>| (x[0] + x[1] - 0.5) * 0.5_f64.sqrt();
    let found = on_cubes("1 I", sets, 0.35, Region::ExitOne, 0, &[[0, 0]], [&phi, &|_| 0.0]);
    proves_at_most(&found, 0.3);
}

/// `φ` is large on the sides of a tower, and small on its floor, through which short curves leave.
#[test]
fn every_low_side_counts_in_space() {
    let column = |i: i32, j: i32| (0..12).map(move |k| [i, j, k]);
    let places: Vec<Place<3>> = (0..9).flat_map(|at| column(at / 3, at % 3)).collect();
    let sets = [point([1.5, 1.5, 0.5]), point([1.5, 1.5, -0.3])];
    let phi = |x: &SVector<f64, 3>| 10.0 * (x[0] - 1.5).abs().max((x[1] - 1.5).abs()) + x[2] - 0.5;
    let flat = "[100, 0, 0; 0, 100, 0; 0, 0, 1]";
    let refused = on_cubes(flat, sets, 1.2, Region::ExitOne, 0, &places, [&phi, &|_| 0.0]);
    assert!(matches!(refused, Err(CheckError::Exit { .. })), "{refused:?}");
}

/// `φ` is 4 at one end of the first set and 2 in its middle. What counts is by how much it grows
/// beyond 4.
#[test]
fn an_exit_is_measured_from_the_largest_value_on_the_set() {
    let sets = [axis_box([0.0], [4.0]), point([6.2])];
    let phi = |x: &SVector<f64, 1>| if x[0] > 2.0 { x[0] } else { 4.0 - x[0] };
    let places: Vec<Place<1>> = (-6..6).map(|k| [k]).collect();
    let refused = on_cubes("1 I", sets, 2.5, Region::ExitOne, 0, &places, [&phi, &|_| 0.0]);
    assert!(matches!(refused, Err(CheckError::Exit { .. })), "{refused:?}");
}

/// The point 0 lies in the sides of two cubes, and both are required. Without them the only cube lies
/// in the second set, where no facet counts.
#[test]
fn cubes_that_touch_the_first_set_are_required() {
    let wall = Shape::HalfSpace(HalfSpace::at_least([1.0], 4.0).expect("a normal"));
    let sets = [point([0.0]), wall];
    let found = on_cubes("1 I", sets, 100.0, Region::ExitOne, 0, &[[5]], [&|_| 0.0, &|_| 0.0]);
    assert!(matches!(found, Err(CheckError::Missing { .. })), "{found:?}");
}

/// The only cube is near the second of two points.
#[test]
fn all_pieces_of_a_union_are_in_the_region() {
    let sets = [Shape::Union(vec![point([0.0]), point([100.0])]), point([101.0])];
    let region = Region::Declared { c1: 1.0 };
    let found = on_cubes("1 I", sets, 1.5, region, 0, &[[1000]], [&|_| 0.0, &|_| 0.0]);
    proves_at_most(&found, 1.0);
}

/// Where `hi > √c₁ n`, the nearest double to the product may be `hi` itself. Curves that are shorter than
/// `hi` may then be longer than `√c₁ n`: tubes of this width are too thin, and cubes at this distance are
/// required.
#[test]
fn the_width_of_regions_is_decided_to_the_last_digit() {
    let mut seen = 0;
    for (c1, n) in (2..200).flat_map(|c1| [1, 2, 3, 5, 7].map(|n| (c1, n))) {
        let square = f64::from(c1 * n * n);
        let hi = square.sqrt();
        // A fused operation is rounded once, which keeps its sign.
        if hi.mul_add(hi, -square) <= 0.0 {
            continue;
        }
        seen += 1;
        let (c1, far) = (f64::from(c1), f64::from(n));
        let sets = [point([0.0]), point([far])];
        let metric = formula::<1>(&format!("{} I", 2.0 * c1));
        for (to, radius) in [(sets[1].clone(), 0.5 * far), (wall(far), far)] {
            let tubes = Region::Tubes { radius, c1 }.prove(&metric, [&sets[0], &to], hi);
            assert!(matches!(tubes, Err(CheckError::Tubes { .. })), "{c1} {n}: {tubes:?}");
        }
        // Both cubes touch one set, and are at the distance n from the other.
        let cubes = Region::Declared { c1 }.required(sets.each_ref(), hi, 0).expect("bounded");
        assert!(cubes.contains(&[-1]) && cubes.contains(&[n]), "{c1} {n}: {:?}", cubes.places());
        let same = [&sets[0], &sets[0]];
        let cubes = Region::Declared { c1 }.required(same, 2.0 * hi, 0).expect("bounded");
        assert!(
            cubes.contains(&[n]) && cubes.contains(&[-n - 1]),
            "{c1} {n}: {:?}",
            cubes.places()
        );
    }
    assert!(seen > 100, "{seen}");
}

/// All that is at least as far as this.
fn wall(far: f64) -> Shape<1> {
    Shape::HalfSpace(HalfSpace::at_least([1.0], far).expect("a normal"))
}
