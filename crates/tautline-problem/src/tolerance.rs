//! The grids on the way to a tolerance.

use tautline::{Formula, Rule, TautLine};

/// The grid from which a tolerance is judged: that of a problem without a tolerance, so that the
/// search meets the same minima.
pub(crate) const FIRST_GRID: usize = crate::question::CHORDS;

/// The finest grid that is tried for a tolerance, times the number of coordinates. Twice as many
/// chords gain nothing: what remains of the error of smooth metrics is rounding.
pub(crate) const FINEST_GRID: usize = 1 << 22;

/// Up to this grid a search that failed is tried on a finer one.
pub(crate) const PATIENCE: usize = 2048;

/// How much finer the next grid is at most if little is known of the error of the length.
const BLIND: f64 = 4.0;

/// By how much the error of an extrapolation may exceed its estimate, as the kit allows too.
const OPTIMISM: f64 = 10.0;

/// Returns the next grid, or `None` if the relative error of the length is at most `tolerance`, by
/// extrapolation.
pub(crate) fn finer_grid<R: Rule, const D: usize>(
    line: &TautLine<Formula<D>, R, D>,
    tolerance: f64,
) -> Option<usize> {
    let length = line.length();
    if length.value == 0.0 {
        return None;
    }
    let estimate = line.distance_squared_estimate().filter(|estimate| estimate.value > 0.0);
    let finer = estimate.map_or(Some(BLIND), |estimate| {
        // The excess falls like 1/N². It is a guess only if the estimate is less certain.
        let excess = (length.value * length.value - estimate.value).abs();
        let doubt = OPTIMISM * estimate.error + 2.0 * length.value * length.error;
        let error = (excess + doubt) / (2.0 * estimate.value);
        let finer = (1.1 * error / tolerance).sqrt().max(1.5);
        (error > tolerance).then_some(if doubt > excess { finer.min(BLIND) } else { finer })
    })?;
    // A conversion to an integer saturates.
    Some((finer * line.sequence().n().get() as f64).ceil() as usize)
}
