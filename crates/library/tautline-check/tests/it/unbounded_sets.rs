//! A point and a half-space: one tube instead of two, and values on an unbounded set.

use tautline_check::{CheckError, Region};
use tautline_sets::{HalfSpace, Shape};

use crate::helpers::{formula, one_level, point};

fn wall() -> Shape<2> {
    Shape::HalfSpace(HalfSpace::at_least([1.0, 0.0], 1.0).expect("a normal"))
}

/// With a second tube, half of the radius would do.
#[test]
fn a_single_tube_is_as_wide_as_the_curves_are_long() {
    let flat = formula::<2>("1.5625 I");
    let hi = 2.0;
    let proves = |sets: [&Shape<2>; 2], radius: f64| {
        Region::Tubes { radius, c1: 1.0 }.prove(&flat, sets, hi)
    };
    let (from, to, wall) = (point([0.0, 0.0]), point([1.0, 0.0]), wall());
    for sets in [[&from, &wall], [&wall, &from]] {
        assert_eq!(proves(sets, hi), Ok(()));
        let thin = CheckError::Tubes { radius: 0.99 * hi, c1: 1.0, hi };
        assert_eq!(proves(sets, 0.99 * hi), Err(thin));
    }
    assert_eq!(proves([&from, &to], 0.5 * hi), Ok(()));
    assert!(proves([&from, &to], 0.49 * hi).is_err());
}

/// The least and the greatest value on the part of a set in a simplex may be equal. The set meets the
/// simplex all the same; otherwise the distance, 1.25, would be proved to be at least 3.
#[test]
fn a_function_that_is_constant_on_a_set_proves_nothing_false() {
    let sets = [point([0.0, 0.0]), wall()];
    let region = Region::Tubes { radius: 3.0, c1: 1.0 };
    let certificate = one_level(formula("1.5625 I"), sets, 3.0, region, -2, [&|_| 0.0, &|_| 0.0]);
    let proved = certificate.check().expect("a region");
    assert_eq!(proved.lower, 0.0);
    assert!(!proved.corridor.places().is_empty());
}
