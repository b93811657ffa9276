//! Changed numbers at nodes.

use tautline_check::{CheckError, Level, Region};

use super::BASE;
use crate::{
    helpers::{lower, point, several_levels},
    wave::Wave,
};

#[test]
fn one_value_larger_or_smaller_by_a_thousandth_proves_less() {
    let mut weaker = 0;
    for (level, node) in BASE.nodes_on_the_geodesic() {
        for (function, change) in [(0, 1e-3), (0, -1e-3), (1, 1e-3), (1, -1e-3)] {
            let changed = BASE.with_values(level, |values| values[function][node] += change);
            let checked = changed.expect("finite").check();
            BASE.assert_true(&checked);
            weaker += usize::from(level == 3 && lower(&checked) < BASE.proved.lower);
        }
    }
    assert!(weaker > 9, "only {weaker} changes of the last level proved less");
}

/// None of these can be written into a level.
#[test]
fn values_that_are_not_finite_are_refused() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = BASE.with_values(1, |values| values[1][7] = value).map(|_| ());
        let is_named = matches!(refused, Err(CheckError::NotFinite { level: 1, node: 7, .. }));
        assert!(is_named, "{refused:?}");
    }
}

/// Intermediate results overflow, and an unknown bound drops no cube.
#[test]
fn huge_values_prove_nothing_false_and_drop_no_cube_of_the_geodesic() {
    for (level, node) in BASE.nodes_on_the_geodesic().into_iter().step_by(4) {
        for value in [1e300, -1e300, f64::MAX, f64::MIN] {
            for function in [0, 1] {
                let changed = BASE.with_values(level, |values| values[function][node] = value);
                BASE.assert_true(&changed.expect("finite").check());
            }
        }
    }
    for value in [1e300, f64::MAX, 0.0] {
        let changed = BASE.with_values(3, |values| values.iter_mut().for_each(|v| v.fill(value)));
        BASE.assert_true(&changed.expect("finite").check());
    }
}

#[test]
fn a_missing_value_is_refused() {
    for function in [0, 1] {
        let refused = BASE.with_values(2, |values| values[function].truncate(40)).map(|_| ());
        assert!(matches!(refused, Err(CheckError::Values { level: 2, .. })), "{refused:?}");
    }
}

/// The numbers of another order of the nodes.
#[test]
fn values_in_another_order_prove_nothing_false() {
    for level in 0..4 {
        let reversed =
            BASE.with_values(level, |values| values.iter_mut().for_each(|v| v.reverse()));
        BASE.assert_true(&reversed.expect("finite").check());
        let rotated =
            BASE.with_values(level, |values| values.iter_mut().for_each(|v| v.rotate_left(1)));
        BASE.assert_true(&rotated.expect("finite").check());
        let swapped = BASE.with_values(level, |values| values.swap(0, 1));
        BASE.assert_true(&swapped.expect("finite").check());
    }
}

/// `ε ≥ λ_min(H)`, where a test that forgets it has negative squares of gradients.
#[test]
fn cubes_that_are_too_large_for_the_vertex_test_prove_nothing_false() {
    let wave = Wave::new(0.6, 3.0);
    let ends = [[0.05, 0.03], [1.95, 0.03]];
    let (x, y) = (ends[0].into(), ends[1].into());
    let d = wave.distance(&x, &y);
    for exponent in [-1, 0, 1] {
        let certificate = several_levels(
            wave.formula(),
            ends.map(point),
            1.2 * d,
            Region::Declared { c1: 0.15 },
            &[exponent],
            [&|z| 5.0 * wave.distance(&x, z), &|z| 5.0 * wave.distance(&y, z)],
        );
        let proved = certificate.check().expect("nothing is missing");
        assert!(proved.lower <= d, "side 2^{exponent}: {} > {d}", proved.lower);
    }
}

/// A level whose numbers are those of another level.
#[test]
fn values_of_another_level_prove_nothing_false() {
    for level in [1, 2] {
        let mut certificate = BASE.certificate.clone();
        let cubes = certificate.levels[level].cubes().clone();
        let count = cubes.nodes().len();
        let other = certificate.levels[0].values().clone();
        let values = other.map(|values| values.into_iter().cycle().take(count).collect());
        certificate.levels[level] = Level::new(level, cubes, values).expect("finite");
        BASE.assert_true(&certificate.check());
    }
}
