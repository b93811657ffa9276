//! Balls of competitors on the sphere, and where there are none.

use super::{LocalityError, Region, competitors, competitors_within, reach, reach_outward, shrink};
use std::{convert::Infallible, num::NonZeroUsize};

use crate::{
    BoundError, Constants, PaperRule, Setting,
    by_hand::{constants, n, with_m_h},
};

const N: NonZeroUsize = NonZeroUsize::new(100).expect("positive");
const TRA: PaperRule = PaperRule::Trapezoidal;

/// Returns the constants of `H = 4/(1 + |x|²)² I` on the ball of radius `r` about 0. The slope
/// of `H` is steepest at `1/√5`.
fn sphere(radius: f64) -> Result<Constants, Infallible> {
    let c1 = 4.0 / (1.0 + radius * radius).powi(2);
    let r = radius.min(1.0 / 5_f64.sqrt());
    Ok(constants(c1, 4.0, 16.0 * r / (1.0 + r * r).powi(3)))
}

#[test]
fn the_region_contains_the_reach_of_its_constants() {
    for upper in [0.0, 0.1, 0.5, 0.8] {
        let region = competitors(2, TRA, N, upper, sphere).expect("near enough");
        let reach = upper / region.constants.c1().sqrt();
        assert!(reach <= region.radius, "{region:?}");
        assert!(region.radius <= 1.05 * reach, "{region:?}");
        assert_eq!(region.constants, sphere(region.radius).expect("a ball").on_a_region());
    }
}

/// On this metric `√c₁ R = 2R/(1 + R²) ≤ 1`.
#[test]
fn a_distance_above_one_is_an_escape_on_the_sphere() {
    let error = competitors(2, TRA, N, 1.01, sphere).expect_err("too far");
    let LocalityError::Escapes { radius, reach } = error else { panic!("{error}") };
    // The last radius that was tried, so that the next one would have been a little more.
    assert!(reach > 1.0 && radius <= reach, "{error}");
}

/// `H ≥ 1` with `L_H = 2` and `d̄ = 1` has `δ = 2`. With one chord a competitor may be as far
/// away as `√2`: `e = 1 + δ/2` for the left endpoint, and `e = 1 + δ/4 + δ²/8` for the
/// trapezoidal rule.
#[test]
fn the_surplus_of_the_energy_extends_the_reach() {
    let flat = with_m_h(1.0, 100.0, 2.0, 0.0);
    let within = |_| Ok::<_, Infallible>(flat);
    for rule in PaperRule::BOTH {
        let region = competitors(2, rule, NonZeroUsize::MIN, 1.0, within).expect("bounded");
        assert!((2_f64.sqrt()..1.03 * 2_f64.sqrt()).contains(&region.radius), "{region:?}");
    }
    // With four chords, e = 1 + δ/8, and by the second variation
    // e = 1 + 9·(25/16/12 + ½/√360)/16.
    let left = competitors(2, PaperRule::LeftEndpoint, n(4), 1.0, within).expect("bounded");
    assert!((1.25_f64.sqrt()..1.03 * 1.25_f64.sqrt()).contains(&left.radius), "{left:?}");
    let tra = competitors(2, TRA, n(4), 1.0, within).expect("bounded");
    let e = 1.0 + 9.0 * (25.0 / 192.0 + 0.5 / 360_f64.sqrt()) / 16.0;
    assert!((e.sqrt()..1.03 * e.sqrt()).contains(&tra.radius), "{tra:?}");
}

/// Constants within a radius are treated as constants on a region, even if they are not marked
/// as local. On a region, with one chord, `e = 1 + δ/4 + δ²/24` for an isotropic metric with
/// `M_H = 0`; on all of space `G` would be 0.
#[test]
fn constants_within_a_radius_are_those_of_a_region() {
    let incline = with_m_h(1.0, 1e6, 6.0, 0.0).isotropic();
    for given in [incline, incline.on_a_region()] {
        let within = |_| Ok::<_, Infallible>(given);
        let region = competitors(2, TRA, NonZeroUsize::MIN, 1.0, within).expect("bounded");
        // For δ = 6, 1 + 3/2 + 3/2 is less than 1 + 9·(16/12 + 6/√360), the second variation's
        // value.
        assert!((2.0..1.03 * 2.0).contains(&region.radius), "{region:?}");
        assert!(region.constants.is_local());
    }
}

/// Between the points at the distance `s` on both sides of the origin `√c₁ = 2/(1 + R²)`, and
/// `d̄ = 4 arctan s`. With `ρ = d̄ (1 + R²)/2` the first stage needs `½ (ρ + 2s) < R`, and the
/// second one only `½ ρ < R`. Along the line the surplus of the energy is below 10⁻⁴.
#[test]
fn the_second_stage_halves_the_radius_on_the_sphere() {
    // The smaller root of a R² − R + a + s = 0.
    let root = |a: f64, s: f64| (1.0 - (1.0 - 4.0 * a * (a + s)).sqrt()) / (2.0 * a);
    for s in [0.1_f64, 0.2, 0.3] {
        let (d, n) = (4.0 * s.atan(), n(1000));
        let first = competitors_within(2, TRA, n, d, |l| 0.5 * (l + 2.0 * s), sphere);
        let first = first.expect("near");
        let least = root(0.25 * d, s);
        assert!((least..1.02 * least).contains(&first.radius), "{first:?} {least}");
        let regions = shrink(2, TRA, n, d, first, |length| 0.5 * length, sphere);
        // The ball of the diameter d̄ on the sphere.
        let least = root(0.25 * d, 0.0);
        let last = regions.last().expect("smaller");
        // With the factor 1.01 it is the root for 1.01 d̄, and the last step saved too little.
        assert!((least..1.06 * least).contains(&last.radius), "{last:?} {least}");
        let radii: Vec<f64> = [first].iter().chain(&regions).map(|at| at.radius).collect();
        assert!(radii.windows(2).all(|pair| pair[1] < 0.98 * pair[0]), "{radii:?}");
    }
}

/// The same holds on smaller regions. With `M_H = 0` on all of space `G` would be 0, and the reach
/// `√(5/2)` for `δ = 6` and one chord, instead of 2.
#[test]
fn constants_on_a_smaller_region_are_those_of_a_region() {
    let incline = with_m_h(1.0, 1e6, 6.0, 0.0).isotropic();
    let outer = Region { radius: 9.0, constants: incline.on_a_region() };
    for given in [incline, incline.on_a_region()] {
        let within = |_| Ok::<_, Infallible>(given);
        let one = NonZeroUsize::MIN;
        let regions = shrink(2, TRA, one, 1.0, outer, |length| length, within);
        let [region] = regions[..] else { panic!("{regions:?}") };
        assert!((2.0..1.03 * 2.0).contains(&region.radius), "{region:?}");
        assert!(region.constants.is_local(), "{region:?}");
    }
}

/// Only competitors that are shorter than the radius are known to stay. With `H = I` and `d̄ = 1` the
/// reach is 1, so here every region begins with the radius 2 that its competitors might touch.
#[test]
fn a_region_that_competitors_may_touch_is_not_enough() {
    let flat = |_| Ok::<_, Infallible>(constants(1.0, 1.0, 0.0));
    let at_least = |least: f64| move |length: f64| length.max(least);
    let region = competitors_within(2, TRA, N, 1.0, at_least(2.0), flat).expect("bounded");
    assert_eq!(region.radius, 1.01 * 2.0);
    // A radius that starts above the reach is enough at once.
    let wide = |length: f64| if length == 0.0 { 2.0 } else { 2.0_f64.next_down() };
    let region = competitors_within(2, TRA, N, 1.0, wide, flat).expect("bounded");
    assert_eq!(region.radius, 2.0);
    // On the smaller region `√c₁` is smaller by a little, and competitors reach its border.
    let outer = Region { radius: 2.0, constants: constants(1.0, 1.0, 0.0) };
    let step = |border: f64| move |length: f64| if length <= 1.0 { 1.0 } else { border };
    let worse = |_| Ok::<_, Infallible>(constants(0.999, 1.0, 0.0));
    let regions = |border: f64| shrink(2, TRA, N, 1.0, outer, step(border), worse);
    assert!(regions(1.01).is_empty(), "{:?}", regions(1.01));
    assert_eq!(regions(1.01_f64.next_down()).len(), 1);
}

/// A region that does not save enough, lacks constants or has worse ones ends the list.
#[test]
fn a_region_that_is_no_better_is_left_out() {
    let flat = |_| Ok::<_, f64>(constants(4.0, 4.0, 0.0));
    let outer = Region { radius: 0.6, constants: constants(4.0, 4.0, 0.0) };
    let halved = |length: f64| 0.5 * length;
    let regions = shrink(2, TRA, N, 1.0, outer, halved, flat);
    assert_eq!(regions.iter().map(|at| at.radius).collect::<Vec<_>>(), [1.01 * 0.25]);
    let near = Region { radius: 0.257, ..outer };
    assert!(shrink(2, TRA, N, 1.0, near, halved, flat).is_empty());
    assert!(shrink(2, TRA, N, 1.0, outer, halved, Err::<Constants, f64>).is_empty());
    let worse = |_| Ok::<_, f64>(constants(3.9, 4.0, 0.0));
    assert!(shrink(2, TRA, N, 1.0, outer, halved, worse).is_empty());
    assert!(shrink(2, TRA, N, f64::NAN, outer, halved, flat).is_empty());
}

#[test]
fn a_metric_may_have_no_constants_on_a_region() {
    let disc = |radius: f64| {
        if radius < 1.0 { Ok(constants(4.0, 1e9, 1.0)) } else { Err(radius) }
    };
    let region = competitors(2, TRA, N, 1.0, disc).expect("inside");
    assert!((0.5..0.52).contains(&region.radius), "{region:?}");
    let error = competitors(2, TRA, N, 2.0, disc).expect_err("on the boundary");
    assert!(matches!(error, LocalityError::NoConstants { reason, .. } if reason >= 1.0), "{error}");
}

/// `constants_within` is never called with an infinite radius.
#[test]
fn an_infinite_reach_is_an_escape() {
    let within = |radius: f64| {
        assert!(radius.is_finite());
        Ok::<_, Infallible>(constants(1e-300, 1.0, 0.0))
    };
    let error = competitors(2, TRA, N, 1e200, within).expect_err("out of range");
    assert!(matches!(error, LocalityError::Escapes { reach: f64::INFINITY, .. }), "{error}");
}

#[test]
fn invalid_numbers_are_errors() {
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let error = competitors(2, TRA, N, bad, sphere).expect_err("no distance");
        assert!(matches!(error, LocalityError::Bound(BoundError::NotADistance { .. })), "{error}");
    }
    let error = competitors(0, TRA, N, 1.0, sphere).expect_err("no dimension");
    assert_eq!(error, LocalityError::Bound(BoundError::NoDimension));
}

/// On a metric with equal constants the reach is `d/√c₁`. It is squared exactly, as the sum of a
/// double and its rounding error.
#[test]
fn the_reach_is_rounded_up() {
    let mut nearest_fails = 0;
    for (c1, d) in (2..200_u8).flat_map(|c1| (1..10_u8).map(move |d| (c1, d))) {
        let (c1, d) = (f64::from(c1), f64::from(d));
        let setting = Setting::new(constants(c1, 400.0, 0.0), d, 2).expect("valid");
        let is_below = |q: f64| {
            let square = q * q;
            square.mul_add(c1, -(d * d)) + q.mul_add(q, -square) * c1 < 0.0
        };
        for rule in PaperRule::BOTH {
            let found = reach_outward(setting, rule, n(2));
            // Fewer than ten roundings.
            let most = d / c1.sqrt() * (1.0 + 4e-15);
            assert!(!is_below(found) && found <= most, "{c1} {d}: {found:e}");
            nearest_fails += usize::from(is_below(reach(setting, rule, n(2))));
        }
    }
    assert!(nearest_fails > 500, "{nearest_fails}");
}
