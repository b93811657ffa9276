//! Proposition 7.9: a discrete energy and the energy of the interpolation, for any sequence.

use std::{fmt::Debug, num::NonZeroUsize};

use proptest::prelude::*;
use tautline::{
    Bounded, Interpolation, Rule, Trapezoidal, bounds::polyline_gap_trapezoidal, gallery::Valleys,
};

use crate::{
    families::{ramp, separable, shear},
    one_step::{Tent, constants, mean_cube, one_step},
    random::{at_most, for_all, sequence},
};

#[track_caller]
fn gap_is_bounded<M: Bounded<D> + Debug, const D: usize>(
    seed: u64,
    metrics: impl Strategy<Value = M>,
) {
    for_all(seed, 256, (metrics, sequence(3.0)), |(metric, sequence)| {
        let energy = Interpolation::new(&sequence).energy(&metric);
        let discrete = Trapezoidal.energy(&metric, &sequence);
        let gap = (energy.value - discrete).abs();
        // Two sums of the same size, a dozen roundings a term.
        let slack = energy.error + 1e-13 * energy.value;
        let constants = metric.constants();
        let (n, k3) = (sequence.n(), sequence.k3());
        let sharp = constants.l_h() / (4.0 * n.get() as f64) * mean_cube(&sequence);
        at_most("|E(γᵖˡ) − E_tra,N| ≤ L_H mean|β|³ / 4N", gap, sharp, slack)?;
        let paper = polyline_gap_trapezoidal(constants, k3, n);
        // Proposition 7.8; both sides are sums of powers, a dozen roundings a term.
        at_most("L_H mean|β|³ / 4N ≤ L_H K₃³ / 4√N", sharp, paper, 1e-13 * paper)
    });
}

/// Proposition 7.9, and the bound by the mean cube of the differences that its proof passes.
#[test]
fn prop_7_9_bounds_the_gap_of_random_sequences() {
    gap_is_bounded(7901, shear());
    gap_is_bounded(7902, separable::<1>());
    gap_is_bounded(7903, separable::<3>());
    gap_is_bounded(7904, ramp());
    gap_is_bounded::<_, 2>(7905, Just(Valleys));
}

/// Equality for every `N`: one step over the tent. `E(γᵖˡ) = N (2 + L/4)`, `E_tra,N = 2N`.
///
/// Without it the tests above could pass for a bound that is many times too large, or for the
/// left rule in place of the trapezoidal one.
#[test]
fn prop_7_9_is_attained_by_the_tent() {
    for_all(7910, 256, (1..300_usize, 0.0..1.0, 0.1..10.0), |(n, at, l_h): (_, f64, _)| {
        let sequence = one_step(n, (at * n as f64) as usize);
        let metric = Tent { l_h };
        let discrete = Trapezoidal.energy(&metric, &sequence);
        let energy = Interpolation::new(&sequence).energy(&metric);
        let (count, bound) = (
            n as f64,
            polyline_gap_trapezoidal(
                constants(l_h),
                sequence.k3(),
                NonZeroUsize::new(n).expect("positive"),
            ),
        );
        // Numbers of size N (2 + L), some ten roundings.
        let rounding = 1e-14 * count * (2.0 + l_h) + energy.error;
        prop_assert!((discrete - 2.0 * count).abs() <= rounding, "E_tra,N = {discrete}");
        prop_assert!((energy.value - count * (2.0 + 0.25 * l_h)).abs() <= rounding);
        let gap = energy.value - discrete;
        prop_assert!((gap - bound).abs() <= 2.0 * rounding, "gap {gap}, bound {bound}");
        let sharp = l_h / (4.0 * count) * mean_cube(&sequence);
        prop_assert!((gap - sharp).abs() <= 2.0 * rounding, "gap {gap}, sharp bound {sharp}");
        Ok(())
    });
}
