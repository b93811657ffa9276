//! A metric with constants on balls only, tested on one of these balls.

use std::num::NonZeroUsize;

use nalgebra::SVector;
use tautline::{
    Constants, LocalError, LocallyBounded,
    bounds::{LocalityError, competitors},
};
use tautline_statements::{PaperRule, WithConstants};

use super::MetricCase;
use crate::{Effort, Region};

impl<M: LocallyBounded<D>, const D: usize> MetricCase<WithConstants<M>, D> {
    /// Returns the case of a metric with constants on balls, on one of these balls.
    ///
    /// All laws use the constants of the ball and samples from the largest cube in it. The ends of
    /// problems are so close to its centre that no competitor leaves the ball (Proposition S.8).
    ///
    /// # Errors
    ///
    /// [`LocalityError`] if the metric has no constants on the ball, or if competitors could leave
    /// it however close to the centre the ends are.
    pub fn within(
        metric: M,
        centre: impl Into<SVector<f64, D>>,
        radius: f64,
        effort: Effort,
    ) -> Result<Self, LocalityError<LocalError>> {
        let centre = centre.into();
        let refused = |reason| LocalityError::NoConstants { radius, reason };
        let constants = metric.constants_within(&centre, radius).map_err(refused)?;
        let cube = |half: f64| {
            let edge = SVector::repeat(half);
            let cube = Region::new(centre - edge, centre + edge);
            // The cube has no edges, or it is not finite.
            cube.map_err(|_| LocalityError::Escapes { radius, reach: radius })
        };
        let half = radius / (D as f64).sqrt();
        // The ends are moved closer to the centre until no competitor can leave the ball.
        let mut shares = (0..=10).map(|k| 0.5_f64.powi(k));
        let Some(share) = shares.find(|share| reach(constants, D, share * half) <= radius) else {
            let reach = reach(constants, D, half * 0.5_f64.powi(10));
            return Err(LocalityError::Escapes { radius, reach });
        };
        let case = Self::new(WithConstants { metric, constants }, cube(half)?, effort);
        Ok(Self { ends: cube(share * half)?, ..case })
    }
}

/// Returns how far a competitor may get from the centre if the ends lie in the cube of this
/// half-width.
fn reach(constants: Constants, dimension: usize, half: f64) -> f64 {
    let diagonal = half * (dimension as f64).sqrt();
    // The farthest point of a bounded set is the mirror image of one end, reflected in the other.
    let end = 3.0 * diagonal;
    let upper = constants.c2().sqrt() * 2.0 * diagonal;
    let from_end = PaperRule::BOTH.map(|rule| {
        // The largest energy that a competitor may have decreases with N.
        let everywhere = |_| Ok::<_, LocalError>(constants);
        let region = competitors(dimension, rule, NonZeroUsize::MIN, upper, everywhere);
        region.map_or(f64::INFINITY, |region| region.radius)
    });
    end + from_end[0].max(from_end[1])
}
