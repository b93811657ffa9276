//! Proposition S.8: a ball that contains every competitor, for metrics with constants on balls
//! only.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use super::ceiling;
use crate::{BoundError, PaperRule, Setting};

/// A region that contains every competitor, and the constants that hold on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// `R`, in `ℓ`: the region holds all points within this distance of the bounded end.
    pub radius: f64,
    /// The constants of the metric there.
    pub constants: Constants,
}

/// Why no region was found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LocalityError<E> {
    /// The metric has no constants on a region of this radius.
    #[error("no constants within {radius} of the bounded end (Proposition S.8): {reason}")]
    NoConstants {
        /// The radius, in `ℓ`.
        radius: f64,
        /// What the metric says.
        reason: E,
    },
    /// Competitors might leave every region that was tried: `√c₁` falls faster than the radius
    /// grows.
    #[error(
        "within {radius} of the bounded end a competitor could go as far as {reach}: \
         no region holds them all (Proposition S.8)"
    )]
    Escapes {
        /// The largest radius that was tried, in `ℓ`.
        radius: f64,
        /// How far a competitor could go there, in `ℓ`.
        reach: f64,
    },
    /// The bound of the distance is no distance, or there is no dimension.
    #[error(transparent)]
    Bound(BoundError),
}

/// Finds a region outside of which no competitor comes (Proposition S.8): neither a minimal
/// geodesic, nor a sequence with `E_N ≤ d² e`.
///
/// As long as it is inside, a curve or a sequence with the energy `E` is no further from the
/// bounded end than `√(E/c₁)`. So a radius `R` will do if, with the constants on that region,
///
/// ```text
/// d̄ √e  <  √c₁ R,        e = e(d̄) of Lemma S.4
/// ```
///
/// for an upper bound `d̄` of the distance. Theorems A to D then hold with these constants, for the
/// minimisers of `E_N` among the sequences in the region.
///
/// - `upper`: `d̄`, in `m`, the length of a curve between the ends, such as `γᵖˡ`;
/// - `constants_within`: the constants on the convex hull of the points within a distance of the
///   bounded end, which may refuse.
///
/// Needs: constants that are no better on a larger region. Overestimation: the radius is within 1 %
/// of the least that will do, if `√c₁ R` has no flat piece there; radii up to 1 % larger than that
/// are asked for. If `upper` is 0, the region is that of the radius 0.
///
/// # Errors
///
/// [`LocalityError`] where the metric has no constants, where competitors might escape, and where
/// `upper` is no distance or `dimension` is 0.
pub fn competitors<E>(
    dimension: usize,
    rule: PaperRule,
    n: NonZeroUsize,
    upper: f64,
    mut constants_within: impl FnMut(f64) -> Result<Constants, E>,
) -> Result<Region, LocalityError<E>> {
    let (mut radius, mut first, mut last) = (0.0_f64, f64::INFINITY, 0.0_f64);
    // Each round is 1 % larger than the last at least. Nine decades beyond the reach at the end
    // itself c₁ has fallen by eighteen, and what is left of the bounds is worth nothing.
    while radius <= 1e9 * first {
        let constants = constants_within(radius)
            .map_err(|reason| LocalityError::NoConstants { radius, reason })?
            .on_a_region();
        let setting = Setting::new(constants, upper, dimension).map_err(LocalityError::Bound)?;
        let reach = reach(setting, rule, n);
        if reach < radius || upper == 0.0 {
            return Ok(Region { radius, constants });
        }
        first = first.min(reach);
        last = reach;
        let next = 1.01 * reach;
        if !(next > radius && next.is_finite()) {
            break;
        }
        radius = next;
    }
    Err(LocalityError::Escapes { radius, reach: last })
}

/// Returns how far from the bounded end a competitor can be, in `ℓ`, if the constants hold that far
/// and further (Proposition S.8): `d̄ √e/√c₁`, with the distance of `setting` for `d̄`.
///
/// Overestimation: none as `H → c₁ I`.
#[must_use]
pub fn reach(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let surplus = ceiling::least(setting, rule, n);
    setting.distance() * (1.0 + surplus).sqrt() / setting.constants().c1().sqrt()
}

#[cfg(test)]
mod tests {
    use super::{LocalityError, competitors};
    use crate::{BoundError, Constants, PaperRule};
    use std::{convert::Infallible, num::NonZeroUsize};

    const N: NonZeroUsize = NonZeroUsize::new(100).expect("positive");
    const TRA: PaperRule = PaperRule::Trapezoidal;

    /// `4/(1 + r²)²` on the ball of radius `r` about 0: `c₁` there, `c₂ = 4`, and the slope is
    /// steepest at `1/√5`.
    fn sphere(radius: f64) -> Result<Constants, Infallible> {
        let c1 = 4.0 / (1.0 + radius * radius).powi(2);
        let r = radius.min(1.0 / 5_f64.sqrt());
        Ok(Constants::new(c1, 4.0, 16.0 * r / (1.0 + r * r).powi(3)).expect("in order"))
    }

    #[test]
    fn the_region_holds_what_the_constants_on_it_let_go() {
        for upper in [0.0, 0.1, 0.5, 0.8] {
            let region = competitors(2, TRA, N, upper, sphere).expect("near enough");
            let reach = upper / region.constants.c1().sqrt();
            assert!(reach <= region.radius, "{region:?}");
            assert!(region.radius <= 1.05 * reach, "{region:?}");
            assert_eq!(region.constants, sphere(region.radius).expect("a ball").on_a_region());
        }
    }

    /// `√c₁ R = 2R/(1 + R²) ≤ 1`: too far for this argument, and it says so.
    #[test]
    fn a_distance_that_would_need_the_antipode_is_refused() {
        let error = competitors(2, TRA, N, 1.01, sphere).expect_err("too far");
        assert!(matches!(error, LocalityError::Escapes { reach, .. } if reach > 1.0), "{error}");
    }

    /// With one chord `e` counts: `H ≥ 1` with `L_H = 2` and `d̄ = 1` has `δ = 2`, so that a
    /// competitor may go as far as `√2` by `1 + δ/2`, `M_H` or not, and as far as `√2` by
    /// `1 + δ/4 + δ²/8`.
    #[test]
    fn what_a_sequence_may_spend_counts() {
        let flat = Constants::new(1.0, 100.0, 2.0).and_then(|c| c.with_m_h(0.0)).expect("in order");
        let within = |_| Ok::<_, Infallible>(flat);
        for rule in PaperRule::BOTH {
            let region = competitors(2, rule, NonZeroUsize::MIN, 1.0, within).expect("bounded");
            assert!((2_f64.sqrt()..1.03 * 2_f64.sqrt()).contains(&region.radius), "{region:?}");
        }
        // With four chords 1 + δ/8, and the second variation: 1 + 9·(25/16/12 + ½/√360)/16.
        let four = NonZeroUsize::new(4).expect("positive");
        let left = competitors(2, PaperRule::LeftEndpoint, four, 1.0, within).expect("bounded");
        assert!((1.25_f64.sqrt()..1.03 * 1.25_f64.sqrt()).contains(&left.radius), "{left:?}");
        let tra = competitors(2, TRA, four, 1.0, within).expect("bounded");
        let e = 1.0 + 9.0 * (25.0 / 192.0 + 0.5 / 360_f64.sqrt()) / 16.0;
        assert!((e.sqrt()..1.03 * e.sqrt()).contains(&tra.radius), "{tra:?}");
    }

    /// Constants within a radius are those of a region, whoever returns them: of an isotropic
    /// metric without `M_H` beyond it one chord may spend `1 + δ/4 + δ²/24`, where all of space
    /// would leave `1 + δ/4` and less than that, as there is no incline without an end.
    #[test]
    fn constants_within_a_radius_are_not_taken_for_those_of_all_of_space() {
        let incline = Constants::new(1.0, 1e6, 6.0).and_then(|c| c.with_m_h(0.0));
        let incline = incline.expect("in order").isotropic();
        for given in [incline, incline.on_a_region()] {
            let within = |_| Ok::<_, Infallible>(given);
            let region = competitors(2, TRA, NonZeroUsize::MIN, 1.0, within).expect("bounded");
            // δ = 6: 1 + 3/2 + 3/2 by the first order, and 1 + 9·(16/12 + 6/√360) by the other.
            assert!((2.0..1.03 * 2.0).contains(&region.radius), "{region:?}");
            assert!(region.constants.is_local());
        }
    }

    #[test]
    fn a_metric_may_refuse_a_radius() {
        let disc = |radius: f64| {
            if radius < 1.0 {
                Ok(Constants::new(4.0, 1e9, 1.0).expect("in order"))
            } else {
                Err(radius)
            }
        };
        let region = competitors(2, TRA, N, 1.0, disc).expect("inside");
        assert!((0.5..0.52).contains(&region.radius), "{region:?}");
        let error = competitors(2, TRA, N, 2.0, disc).expect_err("on the boundary");
        assert!(
            matches!(error, LocalityError::NoConstants { reason, .. } if reason >= 1.0),
            "{error}"
        );
    }

    /// Beyond the largest number nothing is asked.
    #[test]
    fn a_reach_beyond_all_numbers_is_an_escape() {
        let within = |radius: f64| {
            assert!(radius.is_finite());
            Ok::<_, Infallible>(Constants::new(1e-300, 1.0, 0.0).expect("in order"))
        };
        let error = competitors(2, TRA, N, 1e200, within).expect_err("out of range");
        assert!(matches!(error, LocalityError::Escapes { reach: f64::INFINITY, .. }), "{error}");
    }

    #[test]
    fn what_is_no_distance_is_refused() {
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
