//! Proposition S.8: a region that contains every competitor, for metrics whose constants hold on
//! bounded regions only.

use std::num::NonZeroUsize;

use tautline_metrics::{Constants, Short};

use super::ceiling;
use crate::{BoundError, PaperRule, Setting};

/// A region that contains every competitor, with the constants on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// The radius, in `ℓ`, as [`competitors`], [`competitors_within`] or [`shrink`] defines it.
    pub radius: f64,
    /// The constants of the metric on this region.
    pub constants: Constants,
}

/// The reason why no region was found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LocalityError<E> {
    /// The metric has no constants on a region of this radius.
    #[error("no constants within {} of the bounded end: {reason}", Short(*radius))]
    NoConstants {
        /// The radius, in `ℓ`.
        radius: f64,
        /// The error of the metric.
        reason: E,
    },
    /// Competitors might leave every region that was tried, because `√c₁` decreases faster than the
    /// radius increases.
    #[error(
        "by the constants within {} of the bounded end, as short a curve could go as far as {}: no \
         region is known to contain the shortest one",
        Short(*radius), Short(*reach)
    )]
    Escapes {
        /// The largest radius that was tried, in `ℓ`.
        radius: f64,
        /// The distance from the bounded end that a competitor could reach, given the constants on
        /// the region of that radius, in `ℓ`.
        reach: f64,
    },
    /// The bound on the distance or the dimension is invalid.
    #[error(transparent)]
    Bound(BoundError),
}

/// The factor by which a radius exceeds the least sufficient one.
const MARGIN: f64 = 1.01;

/// The greatest number of smaller regions, and the part of the radius that the next one must save.
const STEPS: usize = 12;
const SAVED: f64 = 0.02;

/// Finds a region that contains every competitor: every minimal geodesic and every sequence with
/// `E_N ≤ d² e` (Proposition S.8). It contains all points within its radius of the bounded end.
///
/// While it stays in the region, a curve or a sequence of energy `E` is within `√(E/c₁)` of the
/// bounded end. So a radius `R` is enough if the constants on the region satisfy
///
/// ```text
/// d̄ √e  <  √c₁ R,        e = e(d̄) of Lemma S.4
/// ```
///
/// for an upper bound `d̄` on the distance. Theorems A to D then hold with these constants for the
/// minimisers of `E_N` among the sequences in the region.
///
/// - `upper`: `d̄`, in `m`, the length of a curve between the ends, for example of `γᵖˡ`.
/// - `constants_within`: returns the constants on the convex hull of the points within a given
///   distance of the bounded end, or an error.
///
/// Needs: constants that hold on each region. Overestimation: if they do not improve on a larger
/// region, the radius is within 1 % of the least sufficient one, unless `√c₁ R` has a flat piece
/// there; `constants_within` may be called with radii up to 1 % larger than the result. If `upper`
/// is 0, the radius is 0.
///
/// # Errors
///
/// [`LocalityError`] if the metric has no constants, if competitors might escape, if `upper` is
/// negative, infinite or NaN, or if `dimension` is 0.
pub fn competitors<E>(
    dimension: usize,
    rule: PaperRule,
    n: NonZeroUsize,
    upper: f64,
    constants_within: impl FnMut(f64) -> Result<Constants, E>,
) -> Result<Region, LocalityError<E>> {
    competitors_within(dimension, rule, n, upper, |length| length, constants_within)
}

/// Finds a region like [`competitors`], among regions of any shape that grow with a radius.
///
/// - `radius_for`: returns the radius of a region that no curve of a given Euclidean length from
///   set to set can leave, as far as its parts in the region show. It must increase. For a ball
///   about the middle `m` of two points `x`, `y` it is `½ (length + |x − y|)`: a curve that leaves
///   the ball has a part from `x` to its boundary and another one from the boundary to `y`.
///
/// # Errors
///
/// The errors of [`competitors`].
pub fn competitors_within<E>(
    dimension: usize,
    rule: PaperRule,
    n: NonZeroUsize,
    upper: f64,
    radius_for: impl Fn(f64) -> f64,
    mut constants_within: impl FnMut(f64) -> Result<Constants, E>,
) -> Result<Region, LocalityError<E>> {
    let (mut radius, mut first) = (radius_for(0.0), f64::INFINITY);
    let (mut tried, mut last) = (0.0, 0.0);
    // The radius increases by at least 1 % each time, which is up to 2100 times. At nine decades
    // beyond the first reach, c₁ has decreased by eighteen decades, and the bounds are worthless.
    while radius <= 1e9 * first {
        let constants = constants_within(radius)
            .map_err(|reason| LocalityError::NoConstants { radius, reason })?
            .on_a_region();
        let setting = Setting::new(constants, upper, dimension).map_err(LocalityError::Bound)?;
        let reach = radius_for(reach(setting, rule, n));
        if reach < radius || upper == 0.0 {
            return Ok(Region { radius, constants });
        }
        first = first.min(reach);
        (tried, last) = (radius, reach);
        let next = MARGIN * reach;
        if !(next > radius && next.is_finite()) {
            break;
        }
        radius = next;
    }
    Err(LocalityError::Escapes { radius: tried, reach: last })
}

/// Returns smaller and smaller regions that contain every competitor, given one that contains them
/// (Proposition S.8, second stage). The last one is the smallest, and the list may be empty.
///
/// In a region that they do not leave, competitors are no longer than [`reach`] says. Between the
/// points `x` and `y` they lie in the ellipsoid `|z − x| + |z − y| ≤ d̄ √e/√c₁`, hence in the ball
/// of *half* this radius about the middle of the two points. On that ball `c₁` is larger, so that
/// competitors are still shorter, and again.
///
/// - `outer`: the given region. It may have another shape; its radius is only compared.
/// - `radius_for`: returns the radius of a region that contains every curve of a given Euclidean
///   length from set to set. It must increase.
/// - `constants_within`: returns the constants on the region of a given radius, or an error, which
///   ends the list.
///
/// Needs: constants that hold on each region. Overestimation: a radius exceeds the one of
/// `radius_for` by 1 %. The last region is within a few percent of the smallest that repetition
/// can reach.
#[must_use]
pub fn shrink<E>(
    dimension: usize,
    rule: PaperRule,
    n: NonZeroUsize,
    upper: f64,
    outer: Region,
    radius_for: impl Fn(f64) -> f64,
    mut constants_within: impl FnMut(f64) -> Result<Constants, E>,
) -> Vec<Region> {
    let radius_by = |constants| {
        let setting = Setting::new(constants, upper, dimension).ok()?;
        Some(radius_for(reach(setting, rule, n)))
    };
    let mut regions: Vec<Region> = Vec::new();
    let mut last = outer;
    for _ in 0..STEPS {
        let Some(radius) = radius_by(last.constants).map(|radius| MARGIN * radius) else { break };
        if !(radius < (1.0 - SAVED) * last.radius) {
            break;
        }
        let Ok(constants) = constants_within(radius) else { break };
        let constants = constants.on_a_region();
        // Constants that are only known to some accuracy may be worse on a smaller region.
        if !radius_by(constants).is_some_and(|least| least < radius) {
            break;
        }
        last = Region { radius, constants };
        regions.push(last);
    }
    regions
}

/// Bounds the distance of a competitor from the bounded end, in `ℓ`, by `d̄ √e/√c₁`, where `d̄` is
/// the distance of `setting` (Proposition S.8). It bounds the Euclidean length of a competitor. The
/// constants must hold at least that far from the bounded end.
///
/// Overestimation: the bound is attained in the limit `H → c₁ I`.
#[must_use]
pub fn reach(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let surplus = ceiling::least(setting, rule, n);
    setting.distance() * (1.0 + surplus).sqrt() / setting.constants().c1().sqrt()
}

#[cfg(test)]
mod tests {
    use super::{LocalityError, Region, competitors, competitors_within, shrink};
    use std::{convert::Infallible, num::NonZeroUsize};

    use crate::{
        BoundError, Constants, PaperRule,
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
        assert!(
            matches!(error, LocalityError::NoConstants { reason, .. } if reason >= 1.0),
            "{error}"
        );
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
            assert!(
                matches!(error, LocalityError::Bound(BoundError::NotADistance { .. })),
                "{error}"
            );
        }
        let error = competitors(0, TRA, N, 1.0, sphere).expect_err("no dimension");
        assert_eq!(error, LocalityError::Bound(BoundError::NoDimension));
    }
}
