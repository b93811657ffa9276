//! Section 8: the left-endpoint rule.

use std::{fmt::Debug, num::NonZeroUsize};

use proptest::prelude::*;
use tautline::{
    Bounded, Interpolation, LeftEndpoint, Rule, Trapezoidal,
    bounds::{polyline_gap_left, rule_gap},
    gallery::Valleys,
};

use crate::{
    families::{ramp, separable, shear},
    one_step::{Incline, constants, mean_cube, one_step},
    random::{at_most, for_all, sequence},
};

#[track_caller]
fn gaps_are_bounded<M: Bounded<D> + Debug, const D: usize>(
    seed: u64,
    metrics: impl Strategy<Value = M>,
) {
    for_all(seed, 256, (metrics, sequence(3.0)), |(metric, sequence)| {
        let energy = Interpolation::new(&sequence).energy(&metric);
        let left = LeftEndpoint.energy(&metric, &sequence);
        let trapezoidal = Trapezoidal.energy(&metric, &sequence);
        // Sums of the same size, a dozen roundings a term.
        let slack = energy.error + 1e-13 * (energy.value + left + trapezoidal);
        let constants = metric.constants();
        let (n, k3) = (sequence.n(), sequence.k3());
        let sharp = constants.l_h() / (2.0 * n.get() as f64) * mean_cube(&sequence);
        let between = (left - trapezoidal).abs();
        at_most("|E_l,N − E_tra,N| ≤ L_H mean|β|³ / 2N", between, sharp, slack)?;
        let gap = (energy.value - left).abs();
        at_most("|E(γᵖˡ) − E_l,N| ≤ L_H mean|β|³ / 2N", gap, sharp, slack)?;
        // Proposition 7.8; sums of powers, a dozen roundings a term.
        let (first, second) = (rule_gap(constants, k3, n), polyline_gap_left(constants, k3, n));
        at_most("L_H mean|β|³ / 2N ≤ L_H K₃³ / 2√N (8.1)", sharp, first, 1e-13 * first)?;
        at_most("L_H mean|β|³ / 2N ≤ L_H K₃³ / 2√N (8.2)", sharp, second, 1e-13 * second)
    });
}

/// Propositions 8.1 and 8.2, and the bounds by the mean cube that their proofs pass.
#[test]
fn props_8_1_and_8_2_bound_the_gaps_of_random_sequences() {
    gaps_are_bounded(8101, shear());
    gaps_are_bounded(8102, separable::<1>());
    gaps_are_bounded(8103, separable::<3>());
    gaps_are_bounded(8104, ramp());
    gaps_are_bounded::<_, 2>(8105, Just(Valleys));
}

/// Equality in both for every `N`: one step up the incline. `E_l,N = 2N`, the others are
/// `N (2 + L/2)`, and down the incline with the opposite signs.
#[test]
fn props_8_1_and_8_2_are_attained_by_the_incline() {
    for_all(8110, 256, (1..300_usize, 0.0..1.0, 0.1..10.0), |(n, at, l_h): (_, f64, _)| {
        let sequence = one_step(n, (at * n as f64) as usize);
        let metric = Incline { l_h };
        let left = LeftEndpoint.energy(&metric, &sequence);
        let trapezoidal = Trapezoidal.energy(&metric, &sequence);
        let energy = Interpolation::new(&sequence).energy(&metric);
        let count = n as f64;
        // Numbers of size N (2 + L), some ten roundings.
        let rounding = 1e-14 * count * (2.0 + l_h) + energy.error;
        prop_assert!((left - 2.0 * count).abs() <= rounding, "E_l,N = {left}");
        prop_assert!((trapezoidal - count * (2.0 + 0.5 * l_h)).abs() <= rounding);
        let (n, k3) = (NonZeroUsize::new(n).expect("positive"), sequence.k3());
        let first = rule_gap(constants(l_h), k3, n);
        let gap = trapezoidal - left;
        prop_assert!((gap - first).abs() <= 2.0 * rounding, "8.1: gap {gap}, bound {first}");
        let second = polyline_gap_left(constants(l_h), k3, n);
        let gap = energy.value - left;
        prop_assert!((gap - second).abs() <= 2.0 * rounding, "8.2: gap {gap}, bound {second}");
        let sharp = l_h / (2.0 * count) * mean_cube(&sequence);
        prop_assert!((gap - sharp).abs() <= 2.0 * rounding, "gap {gap}, sharp bound {sharp}");
        Ok(())
    });
}

/// The left rule is not symmetric: backwards over the incline it is as much too large as it was
/// too small, and the trapezoidal rule is the same both ways.
#[test]
fn the_left_rule_reads_the_point_where_a_chord_begins() {
    let up = one_step(3, 1);
    let mut points = up.clone().into_points();
    points.reverse();
    let down = tautline::PointSequence::new(points).expect("finite");
    let metric = Incline { l_h: 4.0 };
    // All are small integers.
    assert_eq!(
        (LeftEndpoint.energy(&metric, &up), LeftEndpoint.energy(&metric, &down)),
        (6.0, 18.0)
    );
    assert_eq!(
        (Trapezoidal.energy(&metric, &up), Trapezoidal.energy(&metric, &down)),
        (12.0, 12.0)
    );
}
