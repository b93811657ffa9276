//! The distances of problems: either known to the metric, or extrapolated from a fine grid.

use nalgebra::SVector;
use tautline::{Bounded, Ends, Options, Rule, Starts, extrapolate, minimise};
use tautline_statements::{AnyBounded, Known, Reconstruction, VerifyError};

use super::{case::Case, problems::Posed};

/// The fine grid from which a distance is extrapolated, using the grids 8, 32 and 128 as well.
const REFERENCE: usize = 512;

impl<'m, const D: usize> Case<'m, D> {
    /// Returns the problem with its distance, which is exact if the metric knows it and is
    /// otherwise extrapolated from a fine grid.
    ///
    /// The error of an estimate is taken as ten times the last change made by the extrapolation,
    /// plus `10⁻¹³` for rounding. Curves from other grids that may be `shorter` serve as starts on
    /// the fine grid.
    pub(super) fn known(
        &self,
        posed: &Posed<D>,
        shorter: &[Reconstruction<D>],
    ) -> Result<Known<&AnyBounded<'m, D>, D>, VerifyError> {
        let metric = &self.metric;
        if let (Some(distance), Some([a, b])) = (&self.distance, posed.points())
            && let Some(distance) = distance(&a, &b)
        {
            return Ok(self.exact([a, b], posed.ends()?, distance));
        }
        if !shorter.is_empty() {
            return estimated(metric, posed.ends()?, shorter);
        }
        let estimate = self.solved.distances.recall(posed, || {
            let known = estimated(metric, posed.ends()?, &[])?;
            Ok([known.distance, known.distance_error])
        })?;
        self.with_distance(posed, estimate)
    }

    /// Returns the problem with a distance that was found before, and with its error bound.
    pub(super) fn with_distance(
        &self,
        posed: &Posed<D>,
        [distance, distance_error]: [f64; 2],
    ) -> Result<Known<&AnyBounded<'m, D>, D>, VerifyError> {
        Ok(Known { metric: &self.metric, ends: posed.ends()?, distance, distance_error })
    }

    /// Returns two points with the distance that the metric knows, as in [`Known::between`].
    pub(super) fn exact(
        &self,
        [a, b]: [SVector<f64, D>; 2],
        ends: Ends<D>,
        distance: f64,
    ) -> Known<&AnyBounded<'m, D>, D> {
        let metric = &self.metric;
        let size = (a.norm() + b.norm()) * metric.constants().c2().sqrt();
        Known { metric, ends, distance, distance_error: 16.0 * f64::EPSILON * size }
    }
}

/// Returns the problem with a distance extrapolated from a fine grid, see [`Case::known`].
pub(super) fn estimated<M: Bounded<D>, const D: usize>(
    metric: M,
    ends: Ends<D>,
    shorter: &[Reconstruction<D>],
) -> Result<Known<M, D>, VerifyError> {
    let starts = match shorter {
        [] => Starts::Automatic,
        _ => Starts::Also(shorter.iter().map(|seen| seen.minimum.sequence.clone()).collect()),
    };
    let options = Options { starts, ..Options::default() };
    let minimum = minimise(&metric, &ends, Rule::TRAPEZOIDAL, REFERENCE, &options)?;
    let unknown = VerifyError::NotConverged {
        n: REFERENCE,
        stop: minimum.stop,
        curvature: minimum.curvature,
    };
    let Some(estimate) = extrapolate(&minimum.levels, 2) else { return Err(unknown) };
    if !(estimate.value > 0.0) {
        return Err(unknown);
    }
    let distance = estimate.value.sqrt();
    let error = 10.0 * estimate.error + 1e-13 * estimate.value;
    Ok(Known { metric, ends, distance, distance_error: error / (2.0 * distance) })
}
