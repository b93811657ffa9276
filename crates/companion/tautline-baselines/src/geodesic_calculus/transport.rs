//! `parallel_transport`: Schild's ladder along a sequence of points.

use nalgebra::SVector;
use tautline::{Metric, PointSequence};

use super::{
    CalculusError,
    step::{extend_at, midpoint_at},
};
use crate::not_finite::finite;

/// Returns the vector `u` at the first point of `path`, transported in parallel to its last point
/// by Schild's ladder, in `ℓ`.
///
/// The vector is divided by `N`. On each chord from `x` to `y` a geodesic parallelogram carries the
/// point `p = x + u/N` on: with the discrete [`midpoint`](super::midpoint) `c` of `p` and `y`, the
/// chord from `x` to `c` is [`extended`](super::extend) to `q`, and the next vector is `N (q − y)`
/// (M. Rumpf, B. Wirth, Variational time discretization of geodesic calculus, IMA J. Numer. Anal.
/// 35 (2015)). If the points sample a smooth curve at equal times, the error is
/// `O(1/N)`, since `u/N` as a chord differs from `u/N` as a velocity by `O(1/N²)`.
///
/// # Errors
///
/// [`CalculusError::NotFinite`] for the vector; [`CalculusError::LeavesTheDomain`] and
/// [`CalculusError::NoConvergence`] with the number of the chord.
pub fn parallel_transport<const D: usize>(
    metric: &impl Metric<D>,
    path: &PointSequence<D>,
    u: &SVector<f64, D>,
) -> Result<SVector<f64, D>, CalculusError> {
    finite("vector", u)?;
    let n = path.n().get() as f64;
    let mut small = u / n;
    for (step, pair) in path.points().windows(2).enumerate() {
        let centre = midpoint_at(metric, &(pair[0] + small), &pair[1], step)?;
        // The errors of the second chord of the diagonal have the number of this chord.
        let corner =
            extend_at(metric, &pair[0], &centre, step + 1).map_err(|error| at(error, step))?;
        small = corner - pair[1];
    }
    Ok(small * n)
}

/// Gives an error the number of a chord.
fn at(error: CalculusError, step: usize) -> CalculusError {
    match error {
        CalculusError::LeavesTheDomain { source, .. } => {
            CalculusError::LeavesTheDomain { step, source }
        }
        CalculusError::NoConvergence { correction, .. } => {
            CalculusError::NoConvergence { step, correction }
        }
        other => other,
    }
}
