//! Section 6: the minimum of the energy is the square of the distance.
//!
//! Here for curves that are nobody's minimiser: interpolations of random point sequences.

use std::fmt::Debug;

use proptest::prelude::*;
use tautline::{Bounded, Interpolation, PointSequence};

use crate::{
    families::{
        Known, constant, constant_ball_half_space, points, ramp, separable, separable_boxes, shear,
        shear_ball_half_plane, valleys_across, valleys_along, valleys_ball_half_space,
    },
    random::{at_most, for_all, sequence},
};

/// Moves the ends of random sequences into the sets, and compares `d² ≤ L² ≤ E`.
#[track_caller]
fn no_curve_is_shorter<M: Bounded<D> + Debug, const D: usize>(
    seed: u64,
    family: impl Strategy<Value = Known<M, D>>,
) {
    for_all(seed, 96, (family, sequence(4.0)), |(known, sequence)| {
        let mut points = sequence.into_points();
        let last = points.len() - 1;
        points[0] = known.ends.first().project(&points[0]);
        points[last] = known.ends.second().project(&points[last]);
        let sequence = PointSequence::new(points).expect("finite");
        let curve = Interpolation::new(&sequence);
        let (energy, length) = (curve.energy(&known.metric), curve.length(&known.metric));
        // d is a difference of two numbers up to 20 with some 4 roundings each, 2e-14 in all, and
        // at least 0.03: d² has a relative error below 2e-12. A dozen roundings a chord.
        let slack = 2e-12 * energy.value + energy.error + 2.0 * length.value * length.error;
        at_most("d² ≤ L(γ)²", known.distance.powi(2), length.value.powi(2), slack)?;
        at_most("L(γ)² ≤ E(γ)", length.value.powi(2), energy.value, slack)
    });
}

/// Proposition 6.1, between two points.
#[test]
fn prop_6_1_no_curve_between_points_has_less_energy_than_d2() {
    no_curve_is_shorter(6101, points(constant::<3>()));
    no_curve_is_shorter(6102, points(shear()));
    no_curve_is_shorter(6103, points(separable::<3>()));
    no_curve_is_shorter(6104, points(ramp()));
    no_curve_is_shorter(6105, valleys_along());
    no_curve_is_shorter(6106, valleys_across::<2>());
}

/// Proposition 6.3, between two sets.
#[test]
fn prop_6_3_no_curve_between_sets_has_less_energy_than_d2() {
    no_curve_is_shorter(6301, constant_ball_half_space::<3>());
    no_curve_is_shorter(6302, shear_ball_half_plane());
    no_curve_is_shorter(6303, separable_boxes::<2>());
    no_curve_is_shorter(6304, valleys_ball_half_space());
}

/// Straight lines attain the distance of a constant metric: the one case without excess.
#[test]
fn prop_6_1_is_attained_by_a_straight_line() {
    for_all(6110, 96, (points(constant::<3>()), 1..40_usize), |(known, n)| {
        let origin = Default::default();
        let [a, b] = [known.ends.first(), known.ends.second()].map(|set| set.project(&origin));
        let line = PointSequence::straight(a, b, n).expect("finite");
        let energy = Interpolation::new(&line).energy(&known.metric).value;
        let d2 = known.distance.powi(2);
        // As above.
        prop_assert!((energy - d2).abs() <= 2e-12 * d2, "{energy} is not {d2}");
        Ok(())
    });
}
