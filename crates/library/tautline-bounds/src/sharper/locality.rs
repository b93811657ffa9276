//! Proposition S.8: a region that contains every competitor, for metrics whose constants hold on
//! bounded regions only.

use std::num::NonZeroUsize;

use tautline_metrics::{Constants, Short};
use tautline_scalar::Interval;

use super::ceiling;
use crate::{BoundError, PaperRule, Setting, number::Number};

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
        let reach = radius_for(reach_outward(setting, rule, n));
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
        Some(radius_for(reach_outward(setting, rule, n)))
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
    reach_in(setting, rule, n)
}

/// Returns a bound like that of [`reach`], rounded up to the last digit; infinite if a number overflows.
#[must_use]
pub fn reach_outward(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let reach = reach_in::<Interval>(setting, rule, n).above();
    if reach.is_nan() { f64::INFINITY } else { reach }
}

fn reach_in<T: Number>(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> T {
    let surplus: T = ceiling::least(setting, rule, n);
    let c1 = T::constant(setting.constants().c1());
    (surplus + 1.0).sqrt() * setting.distance() / c1.sqrt()
}

#[cfg(test)]
mod tests;
