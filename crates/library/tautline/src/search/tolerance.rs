//! The grids on the way to a tolerance.

use std::ops::ControlFlow;

use tautline_discretizations::{Integral, PointSequence};
use tautline_formula::Prepare;
use tautline_optimizers::{Estimate, Options, Scope, Starts, Stop};

use crate::{Problem, TautLine};

/// The relative error of a length that rounding leaves, so that no grid reaches less.
pub const LEAST_TOLERANCE: f64 = 1e-13;

/// The grid from which a tolerance is judged: that of a problem without a tolerance, so that the
/// search meets the same minima.
pub(crate) const FIRST_GRID: usize = 256;

/// The finest grid that is tried for a tolerance, times the number of coordinates. Twice as many
/// chords gain nothing: what remains of the error of smooth metrics is rounding.
const FINEST_GRID: usize = 1 << 22;

/// Up to this grid a search that failed is tried on a finer one.
const PATIENCE: usize = 2048;

/// How much finer the next grid is at most if little is known of the error of the length.
const BLIND: f64 = 4.0;

/// By how much the error of an extrapolation may exceed its estimate, as the kit allows too.
const OPTIMISM: f64 = 10.0;

/// Follows a line to finer grids until the relative error of its length is at most `tolerance`, by
/// extrapolation, or until finer grids do not help. `coarser` is told of each line before the last, and may
/// end this.
pub(crate) fn refined<M: Prepare<D>, const D: usize>(
    problem: &Problem<M, D>,
    mut line: TautLine<M, D>,
    tolerance: f64,
    options: &Options<D>,
    coarser: &mut dyn FnMut(&TautLine<M, D>) -> ControlFlow<()>,
) -> TautLine<M, D> {
    let converged = |line: &TautLine<M, D>| line.minimum().stop == Stop::Converged;
    let (mut options, mut failures, mut last_converged) = (options.clone(), 0, None);
    loop {
        // A search that fails twice on fine grids fails on finer ones.
        let n = line.sequence().n().get();
        failures = if converged(&line) { 0 } else { failures + 1 };
        if failures >= 2 && n >= PATIENCE {
            break;
        }
        let mut starts = vec![line.sequence().clone()];
        let finer = line.finer_grid(tolerance).or_else(|| {
            // On a finer grid a minimum that is shorter should have less energy too.
            starts.push(line.shorter_minimum()?.sequence().clone());
            Some(2 * n)
        });
        let finer = finer.map(|finer| finer.min(FINEST_GRID / line.sequence().dimension()));
        let Some(finer) = finer.filter(|&finer| finer > n) else { break };
        if coarser(&line).is_break() {
            break;
        }
        options.starts = also(options.starts, starts);
        // The first grid was the place to look.
        options.scope = Scope::Local;
        // Without a finer line, the coarser one misses the tolerance, and says so.
        let Ok(finer) = problem.solve_with(line.rule(), finer, &options) else { break };
        let before = std::mem::replace(&mut line, finer);
        if converged(&before) {
            last_converged = Some(before);
        }
    }
    if converged(&line) { line } else { last_converged.unwrap_or(line) }
}

/// Returns starts with further ones. What was found on a coarse grid is then not lost on a finer one,
/// which has other coarse grids of its own.
pub(crate) fn also<const D: usize>(starts: Starts<D>, found: Vec<PointSequence<D>>) -> Starts<D> {
    let only = matches!(starts, Starts::Only(_));
    let mut given = match starts {
        Starts::Also(given) | Starts::Only(given) => given,
        _ => Vec::new(),
    };
    given.extend(found);
    if only { Starts::Only(given) } else { Starts::Also(given) }
}

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Returns the number of chords of the next grid on the way to a tolerance, or `None` if the relative
    /// error of the length, as a distance, is at most `tolerance`, by extrapolation.
    pub(crate) fn finer_grid(&self, tolerance: f64) -> Option<usize> {
        let finer = factor(&self.length(), self.distance_squared_estimate(), tolerance)?;
        // A conversion to an integer saturates.
        Some((finer * self.sequence().n().get() as f64).ceil() as usize)
    }

    /// Returns whether the relative error of the length, as a distance, is at most `tolerance`, by
    /// extrapolation: an estimate, not a bound. That no other minimum is shorter is assumed.
    #[must_use]
    pub fn is_within(&self, tolerance: f64) -> bool {
        // NaN is no tolerance.
        tolerance > 0.0 && self.finer_grid(tolerance).is_none()
    }
}

/// Returns by how much finer the next grid should be, or `None` if the relative error of the length
/// is at most `tolerance`, given an estimate of its square.
fn factor(length: &Integral, estimate: Option<Estimate>, tolerance: f64) -> Option<f64> {
    if length.value == 0.0 {
        return None;
    }
    let Some(estimate) = estimate.filter(|estimate| estimate.value > 0.0) else {
        return Some(BLIND);
    };
    // The excess falls like 1/N². It is a guess only if the estimate is less certain.
    let excess = (length.value * length.value - estimate.value).abs();
    let doubt = OPTIMISM * estimate.error + 2.0 * length.value * length.error;
    let error = (excess + doubt) / (2.0 * estimate.value);
    let finer = (1.1 * error / tolerance).sqrt().max(1.5);
    // An error that is no number is none that a tolerance allows.
    let reached = error <= tolerance;
    (!reached).then_some(if doubt > excess { finer.min(BLIND) } else { finer })
}

#[cfg(test)]
mod tests {
    use tautline_discretizations::Integral;
    use tautline_optimizers::Estimate;

    use super::{BLIND, OPTIMISM, factor};

    /// Returns the factor for the length 2, of which the square and the errors are given.
    fn finer(square: f64, error: f64, of_length: f64, tolerance: f64) -> Option<f64> {
        let length = Integral { value: 2.0, error: of_length };
        factor(&length, Some(Estimate { value: square, error }), tolerance)
    }

    /// A relative error of the length is an error of its square, divided by 8.
    #[test]
    fn the_excess_and_both_errors_count() {
        assert_eq!(finer(4.0, 0.0, 0.0, 1e-6), None);
        assert_eq!(finer(4.0 - 0.9 * 8e-6, 0.0, 0.0, 1e-6), None);
        for (square, error, of_length) in [
            (4.0 - 1.1 * 8e-6, 0.0, 0.0),
            // The estimate is no less wrong above the length.
            (4.0 + 1.1 * 8e-6, 0.0, 0.0),
            (4.0, 1.1 * 8e-6 / OPTIMISM, 0.0),
            (4.0, 0.0, 1.1 * 2e-6),
        ] {
            // A little finer does not pay off.
            assert_eq!(finer(square, error, of_length, 1e-6), Some(1.5));
        }
        assert_eq!(finer(4.0, 0.9 * 8e-6 / OPTIMISM, 0.0, 1e-6), None);
        assert_eq!(finer(4.0, 0.0, 0.9 * 2e-6, 1e-6), None);
    }

    #[test]
    fn an_uncertain_estimate_does_not_lead_far() {
        let certain = finer(4.0 - 8e-2, 0.0, 0.0, 1e-6).expect("finer");
        // The excess falls by the square of the factor.
        assert!((102.0..110.0).contains(&certain), "{certain}");
        assert_eq!(finer(4.0 - 8e-2, 8e-2, 0.0, 1e-6), Some(BLIND));
        let length = Integral { value: 2.0, error: 0.0 };
        assert_eq!(factor(&length, None, 1e-6), Some(BLIND));
        assert_eq!(factor(&Integral::default(), None, 1e-6), None);
    }
}
