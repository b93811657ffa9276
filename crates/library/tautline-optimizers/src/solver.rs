//! The algorithm that finds the lowest discrete minimiser between two sets.
//!
//! [`solve`] shows the whole algorithm, step by step; the functions below it are these steps, in
//! the same order. They build on `search/`: the [grids], the [starts](crate::Starts), Newton's
//! method [with damping](LocalSearch::run) on coarse grids and [without](LocalSearch::refine) on
//! fine ones, and a [candidate](Candidate) for each local minimiser that is followed from grid to
//! grid.

use tautline_discretizations::{ANY, LARGEST_N};
use tautline_sets::{AnySet, common_point_of};

use crate::{
    Minimum, Options, Other, SolveError, Starts, Workspace,
    newton::discrete_energy::DiscreteEnergy,
    search::{
        candidate::{Candidate, DIFFERENT, lowest_first},
        grids::{SMALL, grids},
        local_search::{Found, LocalSearch},
        others::lowest_different,
    },
    watch::Watch,
};

/// Returns the lowest minimiser that was found between some pairs of sets, on the grid of `n` chords.
pub(crate) fn solve(
    workspace: &mut Workspace,
    energy: &DiscreteEnergy<'_>,
    pieces: &[Pieces<'_>],
    n: usize,
    options: &Options<ANY>,
    watch: &dyn Watch,
) -> Result<Minimum<ANY>, SolveError> {
    check_size(energy.dimension(), n)?;
    if let Some(x) = pieces.iter().find_map(|[a, b]| common_point_of(*a, *b)) {
        energy.check_at(&x)?;
        return Ok(Minimum::at_common_point(&x, n));
    }
    let (ties, refused) = (Vec::new(), None);
    let mut search = Search { workspace, energy, options, n, watch, iterations: 0, ties, refused };
    let mut candidates = Vec::new();
    let (mut local_minima, mut left_behind) = (None, Vec::new());
    for grid in search.grids() {
        left_behind.extend(search.keep_the_lowest(&mut candidates, grid));
        search.follow_all(&mut candidates, grid);
        search.try_new_starts(&mut candidates, pieces, grid);
        search.check_watch(grid)?;
        local_minima.get_or_insert_with(|| converged_energies(&candidates));
    }
    let left_behind = search.catch_up(&mut candidates, left_behind);
    search.check_watch(n)?;
    let (lowest, rest) = search.lowest_with_a_metric(candidates)?;
    let rest = rest.into_iter().chain(left_behind);
    let mut others: Vec<_> = rest.filter_map(Candidate::into_other).collect();
    others.append(&mut search.ties);
    let is_defined = |other: &Other<ANY>| energy.check_between(&other.sequence).is_ok();
    let others = lowest_different(others, &lowest.found.sequence, &is_defined);
    Ok(lowest.into_minimum(search.iterations, local_minima.unwrap_or_default(), others))
}

/// A piece of each set. A curve runs from the first piece to the second.
type Pieces<'e> = [&'e dyn AnySet; 2];

/// Rejects an empty grid, and one that is too large.
fn check_size(dimension: usize, n: usize) -> Result<(), SolveError> {
    match n {
        0 => Err(SolveError::NoSubinterval),
        _ if n > LARGEST_N => Err(SolveError::TooManySubintervals { n }),
        _ => Workspace::check_points(dimension, n, 1),
    }
}

/// The state that all local searches share.
struct Search<'a> {
    workspace: &'a mut Workspace,
    energy: &'a DiscreteEnergy<'a>,
    options: &'a Options<ANY>,
    /// The number of chords of the finest grid.
    n: usize,
    watch: &'a dyn Watch,
    /// The number of Newton steps of all searches so far.
    iterations: usize,
    /// Local minimisers with the energy of another one.
    ties: Vec<Other<ANY>>,
    /// The reason why the first failed search failed. A lack of memory takes precedence.
    refused: Option<SolveError>,
}

/// Up to this number of chords the order of the local minimisers may change, and `FOLLOWED` of them
/// are followed. Beyond it only the lowest one is followed, unless another one turns out to be
/// lower on the finest grid.
const SETTLED: usize = 512;
const FOLLOWED: usize = 8;

/// From this number of chords on, a search should need no damping, and runs without it.
const FINE: usize = 64;

/// The numbers of intervals into which a line is divided to look for
/// [leaps](crate::search::line_minimum). A line costs one energy for each pair of its points, which
/// is as many evaluations as a search with a few thousand chords. More intervals would make small
/// grids slower than large ones. Which of several leaps saves most depends on the points of the
/// line. The finest grid therefore tries a second line as well, and the two lines together find at
/// least as much as one with twice as many intervals.
const LINES: [usize; 2] = [48, 64];

/// If the lowest energy on a small grid differs by this fraction from the lowest energy on half as
/// many chords, a minimiser leaps over ridges on one of the two grids. The search then looks for
/// leaps once more.
const UNSETTLED: f64 = 0.05;

impl<'a> Search<'a> {
    /// Returns the grids on the way to `n` chords. A small grid with given starts needs no other
    /// grid.
    fn grids(&self) -> Vec<usize> {
        match self.options.starts {
            Starts::OnTheGrid(_) => vec![self.n],
            Starts::Only(_) if self.n <= SMALL => vec![self.n],
            _ => grids(self.n),
        }
    }

    /// Keeps the candidates that are followed to `grid`. If only one is followed, it is the lowest
    /// along which the metric is defined, and the others are returned.
    fn keep_the_lowest<'e>(
        &self,
        candidates: &mut Vec<Candidate<'e>>,
        grid: usize,
    ) -> Vec<Candidate<'e>> {
        if grid > SETTLED && candidates.len() > 1 {
            let passes = |c: &Candidate<'_>| self.energy.check_between(&c.found.sequence).is_ok();
            let place = candidates.iter().position(passes).unwrap_or(0);
            candidates.swap(0, place);
        }
        candidates.truncate(FOLLOWED);
        let kept = if grid > SETTLED { candidates.len().min(1) } else { candidates.len() };
        candidates.drain(kept..).collect()
    }

    /// Follows those candidates too that were left behind, but are lower on the finest grid than the
    /// lowest one that was followed. If that one failed, or if there is no metric along it, every one
    /// counts as lower. Returns the rest.
    fn catch_up<'e>(
        &mut self,
        candidates: &mut Vec<Candidate<'e>>,
        left_behind: Vec<Candidate<'e>>,
    ) -> Vec<Candidate<'e>>
    where
        'a: 'e,
    {
        if left_behind.is_empty() {
            return left_behind;
        }
        let counts = |candidate: &Candidate<'e>| {
            !candidate.failed() && self.energy.check_between(&candidate.found.sequence).is_ok()
        };
        let lowest = candidates.first().filter(|lowest| counts(lowest));
        let bar = lowest.map_or(f64::INFINITY, |lowest| lowest.found.energy * (1.0 - DIFFERENT));
        let is_lower = |candidate: &Candidate<'e>| {
            counts(candidate) && {
                let start = candidate.start(self.n, self.energy, Vec::new()).ok();
                let energy = start.and_then(|start| self.energy.admissible(start.coordinates()));
                energy.is_some_and(|energy| energy < bar)
            }
        };
        let (lower, rest): (Vec<_>, _) = left_behind.into_iter().partition(is_lower);
        for candidate in lower {
            let coarse = candidate.clone();
            let followed = self.follow(candidate, self.n);
            if followed.as_ref().is_none_or(Candidate::failed) {
                // It is a minimum on its own grid.
                self.ties.extend(coarse.into_other());
            }
            candidates.extend(followed);
        }
        self.keep_ties(lowest_first(candidates));
        rest
    }

    /// Follows all candidates to `grid`, and sorts them.
    fn follow_all<'e>(&mut self, candidates: &mut Vec<Candidate<'e>>, grid: usize)
    where
        'a: 'e,
    {
        let coarser = std::mem::take(candidates).into_iter();
        *candidates = coarser.filter_map(|candidate| self.follow(candidate, grid)).collect();
        self.keep_ties(lowest_first(candidates));
    }

    /// Follows a local minimiser to a finer grid. On a fine grid it is followed without damping, if
    /// that converges.
    fn follow<'e>(&mut self, candidate: Candidate<'e>, grid: usize) -> Option<Candidate<'e>>
    where
        'a: 'e,
    {
        if self.watch.has_ended() {
            return None;
        }
        let search = self.between(candidate.ends);
        let start = |memory| candidate.start(grid, search.energy, memory);
        let mut in_vain = 0;
        let refined = (grid >= FINE).then(|| {
            let numbers = (grid + 1) * self.energy.dimension();
            let start = start(self.workspace.spare.take(numbers)).ok()?;
            search.refine(start, &candidate.found, self.workspace, &mut in_vain)
        });
        let found = refined.flatten().map_or_else(
            || {
                // If memory is short, the error reports what an undamped step needs.
                let dimension = self.energy.dimension();
                self.workspace.check_undamped(dimension, grid)?;
                Workspace::check_damped(dimension, grid)?;
                let found = search.run(start(Vec::new())?)?;
                Ok(Found { iterations: in_vain + found.iterations, ..found })
            },
            Ok,
        );
        let (candidate, unused) = candidate.refined(self.accept(found)?);
        unused.into_iter().for_each(|x| self.workspace.spare.give(x.into_coordinates()));
        Some(candidate)
    }

    /// Searches from all starts on the coarsest grid, and again where the energy has risen as after
    /// a leap. If the finest grid is small, it adds the starts that a coarser grid cannot replace.
    fn try_new_starts<'e>(
        &mut self,
        candidates: &mut Vec<Candidate<'e>>,
        pieces: &[Pieces<'e>],
        grid: usize,
    ) where
        'a: 'e,
    {
        let (finest, lowest) = (grid == self.n, candidates.first());
        let is_coarse = grid <= SETTLED || matches!(self.options.starts, Starts::OnTheGrid(_));
        let all = is_coarse && lowest.is_none_or(Candidate::leapt);
        let in_detail = finest && grid <= SMALL;
        if !all && !in_detail {
            return;
        }
        let unsettled = lowest.is_some_and(|candidate| candidate.has_changed_by(UNSETTLED));
        let lines: &[usize] = match (all, finest) {
            (true, true) => &LINES,
            (true, false) => &LINES[..1],
            (false, _) if unsettled => &LINES[..1],
            (false, _) => &[],
        };
        if let Err(error) = Workspace::check_damped(self.energy.dimension(), grid) {
            self.refused = Some(error);
            return;
        }
        for &ends in pieces {
            let search = self.between(ends);
            if self.watch.has_ended() {
                return;
            }
            for start in self.options.starts.between(self.energy, ends, grid, all, lines) {
                if self.watch.has_ended() {
                    return;
                }
                let check = search.check(&start).map_err(SolveError::Metric);
                let found = self.accept(check.and_then(|()| search.run(start)));
                candidates.extend(found.map(|found| Candidate::new(ends, found)));
            }
        }
        self.keep_ties(lowest_first(candidates));
    }

    /// Returns an error if the watcher has ended the solve.
    fn check_watch(&self, n: usize) -> Result<(), SolveError> {
        if self.watch.has_ended() { Err(SolveError::Interrupted { n }) } else { Ok(()) }
    }

    /// Keeps local minimisers that have the energy of another one, but run along another curve.
    fn keep_ties(&mut self, ties: Vec<Candidate<'_>>) {
        self.ties.extend(ties.into_iter().filter_map(Candidate::into_other));
    }

    fn between<'e>(&self, ends: Pieces<'e>) -> LocalSearch<'e>
    where
        'a: 'e,
    {
        let &Options { iterations, threads, .. } = self.options;
        LocalSearch { energy: self.energy, ends, iterations, threads, watch: self.watch }
    }

    /// Counts the steps of a search. If the energy is finite, the result of the search is returned;
    /// otherwise the error is kept.
    fn accept(&mut self, found: Result<Found, SolveError>) -> Option<Found> {
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

    /// Returns the lowest candidate along which the metric is defined, including between the nodes,
    /// and those above it.
    /// If there is none, the error is the defect of the lowest candidate, which is more informative
    /// than a refused start.
    fn lowest_with_a_metric<'e>(
        &mut self,
        candidates: Vec<Candidate<'e>>,
    ) -> Result<(Candidate<'e>, Vec<Candidate<'e>>), SolveError> {
        let mut defect = None;
        let mut candidates = candidates.into_iter();
        while let Some(candidate) = candidates.next() {
            match self.energy.check_between(&candidate.found.sequence) {
                Ok(()) => return Ok((candidate, candidates.collect())),
                Err(error) => defect = defect.or(Some(error)),
            }
        }
        let refused = defect.map(SolveError::Metric).or(self.refused.take());
        Err(refused.unwrap_or(SolveError::NoStart))
    }
}

/// Returns the energies of the candidates that converged.
fn converged_energies(candidates: &[Candidate<'_>]) -> Vec<f64> {
    candidates.iter().filter(|c| !c.failed()).map(|c| c.found.energy).collect()
}

#[cfg(test)]
mod tests;
