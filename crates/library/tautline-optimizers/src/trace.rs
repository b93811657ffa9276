//! `Trace`: a record of the iterates of a search, and its time limit.

use std::ops::ControlFlow;

use tautline_discretizations::PointSequence;

use crate::Iterate;

/// A record of the iterates of a search, with the time of each.
///
/// It is a [`Watcher`](crate::Watcher) of any method, and can end it after a time limit. The library
/// has no clock: the caller brings one that returns seconds since the search began.
///
/// ```
/// use std::time::Instant;
/// use tautline_discretizations::Rule;
/// use tautline_formula::Prepared;
/// use tautline_metrics::gallery::Valleys;
/// use tautline_optimizers::{Options, SolveError, Trace, Workspace, minimise_watched};
/// use tautline_sets::Ends;
///
/// let metric = Prepared::new(Valleys);
/// let ends = Ends::points([0.0, 0.0], [4.0, 1.0])?;
/// let options = Options::default();
/// let begun = Instant::now();
/// let mut clock = || begun.elapsed().as_secs_f64();
/// let mut trace = Trace::new(&mut clock);
/// let mut memory = Workspace::default();
/// let minimum =
///     minimise_watched(&mut memory, &metric, &ends, Rule::TRAPEZOIDAL, 64, &options, &mut |iterate| {
///         trace.record(iterate)
///     })?;
/// let last = trace.entries().last().expect("an iterate");
/// assert_eq!(last.n, 64);
/// assert!(last.energy >= minimum.energy && last.residual < 1e-6);
///
/// // A limit of no time at all ends the search at the first iterate, which is kept.
/// let mut trace = Trace::with_limit(&mut clock, 0.0);
/// let ended =
///     minimise_watched(&mut memory, &metric, &ends, Rule::TRAPEZOIDAL, 64, &options, &mut |iterate| {
///         trace.record(iterate)
///     });
/// assert!(matches!(ended, Err(SolveError::Interrupted { .. })));
/// assert!(trace.best().is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Trace<'c, const D: usize> {
    clock: &'c mut dyn FnMut() -> f64,
    limit: f64,
    entries: Vec<Entry>,
    last: Option<PointSequence<D>>,
    best: Option<(f64, PointSequence<D>)>,
}

/// An iterate in a [`Trace`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Entry {
    /// The number of chords `N`.
    pub n: usize,
    /// The number of steps of the local search before this iterate, from its start on this grid.
    pub iteration: usize,
    /// The discrete energy, in `m²`.
    pub energy: f64,
    /// The [residual](crate::Minimum::residual).
    pub residual: f64,
    /// The largest distance by which a coordinate of a point moved since the iterate before, in `ℓ`,
    /// or infinity for the first iterate from a start or on a grid.
    pub step: f64,
    /// The time since the search began, in seconds.
    pub seconds: f64,
}

impl<'c, const D: usize> Trace<'c, D> {
    /// Returns an empty record with this clock.
    pub fn new(clock: &'c mut dyn FnMut() -> f64) -> Self {
        Self::with_limit(clock, f64::INFINITY)
    }

    /// Returns an empty record that ends the search at the first iterate after `seconds` on its
    /// clock.
    pub fn with_limit(clock: &'c mut dyn FnMut() -> f64, seconds: f64) -> Self {
        Self { clock, limit: seconds, entries: Vec::new(), last: None, best: None }
    }

    /// Records an iterate, and says whether there is time for another.
    pub fn record(&mut self, iterate: &Iterate<'_, D>) -> ControlFlow<()> {
        let &Iterate { iteration, energy, residual, sequence, .. } = iterate;
        let (seconds, n) = ((self.clock)(), sequence.n().get());
        let before = self.last.as_ref().filter(|before| iteration > 0 && before.n().get() == n);
        let step = before.map_or(f64::INFINITY, |before| {
            let moves = sequence.coordinates().iter().zip(before.coordinates());
            moves.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
        });
        self.entries.push(Entry { n, iteration, energy, residual, step, seconds });
        self.last = Some(sequence.clone());
        // Energies on different grids are not comparable, and without a metric they mean nothing.
        let has_metric = energy >= 0.0 && residual < f64::INFINITY;
        let is_better = has_metric
            && match &self.best {
                Some((lowest, best)) => {
                    best.n().get() < n || (best.n().get() == n && energy < *lowest)
                }
                None => true,
            };
        if is_better {
            self.best = Some((energy, sequence.clone()));
        }
        // A NaN from the clock ends the search.
        if seconds < self.limit { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    /// Returns the iterates so far, in their order.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Returns the energy, in `m²`, and the points of the lowest iterate on the finest grid so far
    /// that has a residual, or `None` before the first one.
    #[must_use]
    pub fn best(&self) -> Option<(f64, &PointSequence<D>)> {
        self.best.as_ref().map(|(energy, sequence)| (*energy, sequence))
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use nalgebra::vector;
    use tautline_discretizations::PointSequence;

    use super::Trace;
    use crate::Iterate;

    #[test]
    fn a_trace_has_steps_times_and_the_lowest_iterate_of_the_finest_grid() {
        let mut time = 0.0;
        let mut clock = || {
            time += 1.0;
            time
        };
        let mut trace = Trace::with_limit(&mut clock, 8.5);
        let bent = |n: usize, bend: f64| {
            let at = |k: usize| vector![k as f64, if k == 1 { bend } else { 0.0 }];
            PointSequence::new((0..=n).map(at).collect()).expect("finite")
        };
        let mut record = |iteration, energy, n, bend| {
            let sequence = &bent(n, bend);
            let (residual, residual_floor) = (0.5, 0.0);
            trace.record(&Iterate { iteration, energy, residual, residual_floor, sequence })
        };
        // A start, two steps of which the second goes up, another start, a finer grid, on which an
        // iterate without a metric comes first, and a coarse grid again.
        let answers = [
            record(0, 9.0, 2, 1.0),
            record(1, 3.0, 2, 0.25),
            record(2, 4.0, 2, -0.25),
            record(0, 2.5, 2, -0.25),
            record(0, f64::NAN, 4, 0.0),
            record(0, -1.0, 4, 0.0),
            record(0, 5.0, 4, 0.5),
            record(1, 6.0, 4, 0.0),
            record(0, 1.0, 2, 0.0),
        ];
        assert_eq!(answers[..8], [ControlFlow::Continue(()); 8]);
        assert_eq!(answers[8], ControlFlow::Break(()));
        let steps: Vec<_> = trace.entries().iter().map(|entry| entry.step).collect();
        let (none, infinity) = ([f64::INFINITY; 4], f64::INFINITY);
        assert_eq!(steps[..3], [infinity, 0.75, 0.5]);
        assert_eq!((&steps[3..7], steps[7], steps[8]), (&none[..], 0.5, infinity));
        let seconds: Vec<_> = trace.entries().iter().map(|entry| entry.seconds).collect();
        assert_eq!(seconds, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
        assert_eq!(trace.best(), Some((5.0, &bent(4, 0.5))));
    }

    #[test]
    fn a_clock_that_is_no_number_ends_the_search() {
        let mut clock = || f64::NAN;
        let mut trace = Trace::with_limit(&mut clock, 1.0);
        let sequence = &PointSequence::straight([0.0], [1.0], 2).expect("finite");
        let (iteration, energy, residual, residual_floor) = (0, 1.0, 0.5, 0.0);
        let iterate = Iterate { iteration, energy, residual, residual_floor, sequence };
        assert_eq!(trace.record(&iterate), ControlFlow::Break(()));
    }
}
