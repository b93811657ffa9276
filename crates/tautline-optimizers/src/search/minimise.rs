//! The search for a discrete minimiser: several starts on a coarse grid, then finer grids.

use tautline_discretizations::{LARGEST_N, PointSequence, Rule};
use tautline_formula::{Batches, Prepared};
use tautline_metrics::Metric;
use tautline_sets::{ClosedSet, Ends, common_point};

use crate::{
    Minimum, SolveError, Starts, Workspace,
    newton::discrete_energy::DiscreteEnergy,
    search::{
        candidate::{Candidate, lowest_first},
        grids::{SMALL, grids},
        local_search::{Found, LocalSearch},
    },
};

/// How to search.
#[derive(Clone, Debug, PartialEq)]
pub struct Options<const D: usize> {
    /// Where to start.
    pub starts: Starts<D>,
    /// The number of Newton steps that a local search may take on one grid.
    pub iterations: usize,
    /// The number of threads that may work on one problem; 0 counts as one, and of more than two only
    /// two are used.
    ///
    /// The second goes from the other end, in the undamped Newton steps on grids of `65 536/D²` chords or
    /// more and in four dimensions or more; up to three, one thread goes from both ends at once, which is
    /// faster. The result is the same, bit by bit, of a metric whose values depend on `x` alone. The
    /// second thread has 32 MB of stack: if a formula needs more, or many problems are solved at a time
    /// anyway, say 1.
    pub threads: usize,
}

impl<const D: usize> Default for Options<D> {
    /// Automatic starts; 200 steps, which are five times what a search that works takes on one grid; two
    /// threads.
    fn default() -> Self {
        Self { starts: Starts::Automatic, iterations: 200, threads: 2 }
    }
}

/// Intervals of the lines on which leaps are looked for. The chords between all pairs of points of a line
/// are as many evaluations as a search with a few thousand chords makes; with more intervals a solve with
/// few chords would take longer than one with many. Which of several leaps saves most is decided between
/// points of the line: where no other grid follows, another line with other points is tried, and both
/// together miss no more than one with twice as many intervals.
const LINES: [usize; 2] = [48, 64];

/// Where the least energy on a small grid differs by so much from that on the grid of half as many
/// chords, relatively, a minimiser leaps over ridges, or did: leaps are looked for once more.
const UNSETTLED: f64 = 0.05;

/// How many different local minimisers of the coarsest grid are followed to the next ones,
/// where their order may change, and the grid beyond which only the lowest is.
const FOLLOWED: usize = 8;
const SETTLED: usize = 512;

/// From this grid on a search is expected to need no damping, and is tried without.
const FINE: usize = 64;

/// Returns the lowest discrete minimiser of `rule` between the sets `ends` that was found.
///
/// Every pair of pieces of the sets is tried from every start on the coarsest grid, which is the only one
/// for `n ≤ 32`, and for `n ≤ 64` with starts of your own alone. The best are carried to `n` chords over
/// grids that refine by 2 up to `n = 64` and by 4 to 16 beyond, two or three Newton steps each, and none on
/// the finest if the data are smooth and `n D²` is 32 768 or more: the start is a minimiser to rounding
/// there. Where the energy rises by half from one of the coarse grids to the next, all starts are tried
/// again. A rule without nodes does not compile.
///
/// # Memory
///
/// At most `16D² + 24D` bytes for each point of the finest grid on which a Newton step is taken
/// without damping, four times as much if it has to be damped, and some tenth of that for coarser
/// ones. Where the finest, of `32 768/D²` chords or more, needs none, its points are all that it has:
/// together less than 30 bytes a point for `D = 2` at `N = 10⁵`, and less than 20 at `N = 10⁷`, both
/// measured on smooth metrics. Besides, some 1 kB for each [register](tautline_formula::Prepared::size) of a
/// program, which the thread keeps for the next.
///
/// # Errors
///
/// [`SolveError::NoSubinterval`] if `n` is 0; [`SolveError::TooManySubintervals`] if it is more than
/// [`LARGEST_N`]; [`SolveError::OutOfMemory`] if the system has no room for the points or a Newton step,
/// as far as it tells beforehand; [`SolveError::Metric`] if the metric is not finite, symmetric and
/// positive definite at the nodes and both ends of every start, or there and
/// [between](tautline_discretizations::Interpolation::check) along every result that was followed, one for
/// `n > 512`, of which the lowest that passes is returned; [`SolveError::NoStart`] if there is nothing to start from,
/// [`SolveError::Sequence`] if points become infinite on the way, [`SolveError::Energy`] if the energy of
/// every curve that was found is beyond the range of `f64`.
pub fn minimise<const D: usize, R: Rule>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: R,
    n: usize,
    options: &Options<D>,
) -> Result<Minimum<D>, SolveError> {
    minimise_in(&mut Workspace::default(), metric, ends, rule, n, options)
}

/// As [`minimise`], in memory that is kept: for many problems one after the other.
///
/// The result does not depend on what the workspace was used for before.
///
/// # Errors
///
/// As [`minimise`].
pub fn minimise_in<const D: usize, R: Rule>(
    workspace: &mut Workspace<D>,
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: R,
    n: usize,
    options: &Options<D>,
) -> Result<Minimum<D>, SolveError> {
    minimise_by_batches(workspace, &Prepared::new(metric), ends, rule, n, options)
}

/// As [`minimise_in`], for a metric by batches of places.
///
/// # Errors
///
/// As [`minimise`].
pub fn minimise_by_batches<const D: usize, R: Rule>(
    workspace: &mut Workspace<D>,
    metric: &dyn Batches<D>,
    ends: &Ends<D>,
    rule: R,
    n: usize,
    options: &Options<D>,
) -> Result<Minimum<D>, SolveError> {
    const { assert!(!R::NODES.is_empty(), "a rule reads the metric somewhere") };
    lowest(workspace, &DiscreteEnergy::new(rule, metric), ends, n, options)
}

/// Returns the lowest minimiser of an energy between the sets `ends` that was found.
fn lowest<const D: usize>(
    workspace: &mut Workspace<D>,
    energy: &DiscreteEnergy<'_, D>,
    ends: &Ends<D>,
    n: usize,
    options: &Options<D>,
) -> Result<Minimum<D>, SolveError> {
    if n == 0 {
        return Err(SolveError::NoSubinterval);
    }
    if n > LARGEST_N {
        return Err(SolveError::TooManySubintervals { n });
    }
    Workspace::<D>::check_points(n)?;
    let pairs: Vec<_> = ends.pairs().collect();
    let pairs: Vec<_> = pairs.iter().map(|(first, second)| [&**first, &**second]).collect();
    for pair in &pairs {
        if let Some(x) = common_point(pair[0], pair[1]) {
            energy.check_at(&x)?;
            return Ok(Minimum::at_common_point(x, n));
        }
    }
    let mut search = Search { workspace, energy, options, iterations: 0, refused: None };
    let mut candidates: Vec<Candidate<'_, D>> = Vec::new();
    let mut local_minima: Option<Vec<f64>> = None;
    let in_detail = n <= SMALL && matches!(options.starts, Starts::Only(_));
    for grid in if in_detail { vec![n] } else { grids(n) } {
        if grid > SETTLED && candidates.len() > 1 {
            // Only one of them is followed: one along which there is a metric.
            let passes = |c: &Candidate<'_, D>| energy.check_between(&c.found.sequence).is_ok();
            let place = candidates.iter().position(passes).unwrap_or(0);
            candidates.swap(0, place);
        }
        candidates.truncate(if grid > SETTLED { 1 } else { FOLLOWED });
        candidates = candidates.into_iter().filter_map(|c| search.follow(c, grid)).collect();
        lowest_first(&mut candidates);
        let unresolved = grid <= SETTLED && candidates.first().is_none_or(Candidate::leapt);
        let lines = if grid == n { &LINES[..] } else { &LINES[..1] };
        if local_minima.is_none() || unresolved {
            for &pair in &pairs {
                let starts = options.starts.between(energy, pair, grid, lines);
                search.search_from(starts, pair, &mut candidates);
            }
            lowest_first(&mut candidates);
        } else if grid == n && n <= SMALL {
            let lines = if candidates[0].has_changed_by(UNSETTLED) { &LINES[..1] } else { &[] };
            for &pair in &pairs {
                // What a coarser grid does not stand for.
                let starts = options.starts.in_detail(energy, pair, grid, lines);
                search.search_from(starts, pair, &mut candidates);
            }
            lowest_first(&mut candidates);
        }
        local_minima.get_or_insert_with(|| {
            candidates.iter().filter(|c| !c.failed()).map(|c| c.found.energy).collect()
        });
    }
    let Search { iterations, mut refused, .. } = search;
    let mut defect = None;
    let candidate = candidates.into_iter().find(|candidate| {
        let between = energy.check_between(&candidate.found.sequence);
        between.map_err(|error| defect.get_or_insert(error)).is_ok()
    });
    let Some(candidate) = candidate else {
        // That of the lowest result tells more than that of a start.
        refused = defect.map(SolveError::Metric).or(refused);
        return Err(refused.unwrap_or(SolveError::NoStart));
    };
    let Candidate { found, levels, iterations: own_iterations, .. } = candidate;
    Ok(Minimum {
        sequence: found.sequence,
        energy: found.energy,
        decrement: found.decrement,
        residual: found.residual,
        residual_floor: found.residual_floor,
        stop: found.stop,
        curvature: found.curvature,
        iterations,
        own_iterations,
        levels,
        local_minima: local_minima.unwrap_or_default(),
    })
}

/// What all local searches have in common.
struct Search<'a, const D: usize> {
    workspace: &'a mut Workspace<D>,
    energy: &'a DiscreteEnergy<'a, D>,
    options: &'a Options<D>,
    /// Newton steps of all searches so far.
    iterations: usize,
    /// Why the first one that failed did; one for which there was no memory goes before the others.
    refused: Option<SolveError>,
}

impl<'a, const D: usize> Search<'a, D> {
    fn between<'e>(&self, ends: [&'e dyn ClosedSet<D>; 2]) -> LocalSearch<'e, D>
    where
        'a: 'e,
    {
        let &Options { iterations, threads, .. } = self.options;
        LocalSearch { energy: self.energy, ends, iterations, threads }
    }

    /// Adds the steps of a search to the total, and returns its result if the energy is finite; else remembers
    /// why there is none.
    fn accept(&mut self, found: Result<Found<D>, SolveError>) -> Option<Found<D>> {
        let found = found.and_then(|found| {
            self.iterations += found.iterations;
            let energy = found.energy;
            if energy.is_finite() { Ok(found) } else { Err(SolveError::Energy { energy }) }
        });
        let refuse = |error| {
            if matches!(error, SolveError::OutOfMemory { .. }) {
                self.refused = Some(error);
            } else {
                self.refused.get_or_insert(error);
            }
        };
        found.map_err(refuse).ok()
    }

    /// Follows a local minimiser to a finer grid.
    fn follow<'e>(&mut self, candidate: Candidate<'e, D>, grid: usize) -> Option<Candidate<'e, D>>
    where
        'a: 'e,
    {
        let search = self.between(candidate.ends);
        let start = |memory| {
            let DiscreteEnergy { error_exponent, .. } = search.energy;
            candidate.start(grid, *error_exponent, search.energy.instruction_set(), memory)
        };
        let mut in_vain = 0;
        let refined = (grid >= FINE).then(|| {
            let start = start(self.workspace.spare.take(grid + 1)).ok()?;
            search.refine(start, &candidate.found, self.workspace, &mut in_vain)
        });
        let found = refined.flatten().map_or_else(
            || {
                // What would do for steps without damping is the number to tell, where that is missing.
                self.workspace.check_undamped(grid)?;
                Workspace::<D>::check_damped(grid)?;
                let found = search.run(start(Vec::new())?)?;
                Ok(Found { iterations: in_vain + found.iterations, ..found })
            },
            Ok,
        );
        let (candidate, unused) = candidate.refined(self.accept(found)?);
        unused.into_iter().for_each(|x| self.workspace.spare.give(x.into_points()));
        Some(candidate)
    }

    /// Searches from these starts between two pieces of the sets.
    fn search_from<'e>(
        &mut self,
        starts: Vec<PointSequence<D>>,
        ends: [&'e dyn ClosedSet<D>; 2],
        candidates: &mut Vec<Candidate<'e, D>>,
    ) where
        'a: 'e,
    {
        let search = self.between(ends);
        for start in starts {
            let found = search.check(&start).and_then(|()| search.run(start));
            let found = self.accept(found.map_err(SolveError::Metric));
            candidates.extend(found.map(|found| Candidate::new(ends, found)));
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, vector};
    use tautline_discretizations::{PointSequence, Rule, Trapezoidal};
    use tautline_formula::{InstructionSet, Prepared};
    use tautline_metrics::gallery::{Constant, Separable};
    use tautline_sets::{ClosedSet, Ends, Point};

    use super::{Candidate, Options, Search, minimise};
    use crate::{SolveError, Workspace, newton::discrete_energy::DiscreteEnergy};

    #[test]
    fn an_energy_beyond_the_range_of_f64_is_an_error() {
        let euclidean = Constant::new(SMatrix::identity()).expect("positive definite");
        let options = Options::default();
        let between = |far: f64, n: usize| {
            let ends = Ends::points([-far, 0.0], [far, far]).expect("finite");
            minimise(&euclidean, &ends, Trapezoidal, n, &options)
        };
        for n in [1, 8, 100] {
            assert!(between(1e150, n).expect("5e300").is_local_minimum());
            let error = between(1e155, n).expect_err("5e310");
            assert!(matches!(error, SolveError::Energy { .. }), "{error:?}");
        }
    }

    /// The minimiser with nine chords leaps over both ridges of this metric: from there, Newton's
    /// method without damping leads nowhere on the next grid, and its steps count all the same.
    #[test]
    fn steps_without_damping_that_led_nowhere_are_counted() {
        let ridges = Separable::new(vector![0.788, 0.0, 0.0], vector![1.663, 1.0, 1.0]);
        let ridges = ridges.expect("below one");
        let line = [[-2.866, 0.0, 0.0], [3.0, 0.0, 0.0]];
        let [a, b] = line.map(|x| Point::new(x).expect("finite"));
        let ends: [&dyn ClosedSet<3>; 2] = [&a, &b];
        let (workspace, options) = (&mut Workspace::default(), &Options::default());
        let batches = Prepared::new(&ridges);
        let energy = &DiscreteEnergy::new(Trapezoidal, &batches);
        let mut search = Search { workspace, energy, options, iterations: 0, refused: None };
        let local = search.between(ends);
        let coarse = || {
            let line = PointSequence::straight(line[0], line[1], 9).expect("finite");
            Candidate::new(ends, local.run(line).expect("a metric"))
        };
        let start = || {
            let exponent = <Trapezoidal as Rule>::ERROR_EXPONENT;
            coarse().start(129, exponent, InstructionSet::Widest, Vec::new()).expect("finite")
        };
        let mut in_vain = 0;
        let undamped = local.refine(start(), &coarse().found, search.workspace, &mut in_vain);
        assert!(undamped.is_none() && in_vain > 0);
        let damped = local.run(start()).expect("a metric").iterations;
        let candidate = search.follow(coarse(), 129).expect("a metric");
        assert_eq!(candidate.found.iterations, in_vain + damped);
        assert_eq!(search.iterations, in_vain + damped);
    }
}
