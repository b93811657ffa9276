//! The search for a discrete minimiser: several starts on a coarse grid, then finer grids.

use nalgebra::SVector;
use tautline_discretizations::{PointSequence, Rule, SequenceError};
use tautline_metrics::{Metric, check_gram};
use tautline_sets::{ClosedSet, Ends, common_point};

use crate::{
    Level, Minimum, SolveError, Starts, Stop, Workspace,
    local_search::{Found, LocalSearch},
    prolongation::{prolong, prolong_into},
};

/// How to search.
#[derive(Clone, Debug, PartialEq)]
pub struct Options<const D: usize> {
    /// Where to start.
    pub starts: Starts<D>,
    /// The number of Newton steps that a local search may take on one grid.
    pub iterations: usize,
}

impl<const D: usize> Default for Options<D> {
    /// Automatic starts, and 200 steps: a search that works takes less than 30.
    fn default() -> Self {
        Self { starts: Starts::Automatic, iterations: 200 }
    }
}

/// Up to so many chords everything is tried on the grid itself: there a discrete minimiser
/// may leap over a ridge, and which leaps save energy depends on the grid.
const DIRECT: usize = 64;

/// Otherwise the coarsest grid has at most this many chords: enough to tell the ways round an
/// obstacle apart, and few enough that a dozen starts cost less than one pass over a fine grid.
const COARSEST: usize = 32;

/// Intervals of the line on which leaps are looked for: on a grid that is refined later they
/// need not be known as well, since few survive.
const LINE_DIRECT: usize = 128;
const LINE_COARSE: usize = 48;

/// From one grid to the next, `N` grows at most by this factor: by the later ones on fine grids,
/// where what is prolonged is nearer.
const REFINEMENT: [usize; 3] = [4, 8, 16];
const FINER: [usize; 2] = [4096, 65_536];

/// How many different local minimisers of the coarsest grid are followed to the next ones,
/// where their order may change, and the grid from which on only the lowest is.
const FOLLOWED: usize = 8;
const SETTLED: usize = 512;

/// From this grid on a search is expected to need no damping, and is tried without.
const FINE: usize = 256;

/// The coarsest grid from which the points are extrapolated.
const EXTRAPOLATED: usize = 100;

/// Minima are different if their energies differ by more than this, relatively.
const DIFFERENT: f64 = 1e-9;

/// Returns the lowest discrete minimiser of `rule` between the sets `ends` that was found.
///
/// Every pair of pieces of the sets is tried from every start on the coarsest grid, which is the
/// only one for `n ≤ 64`; the best are carried to `n` chords over grids that refine by 4 to 16, two or
/// three Newton steps each, and none on the finest: the start is a minimiser to rounding there. A
/// rule without nodes does not compile.
///
/// # Errors
///
/// [`SolveError::NoSubinterval`] if `n` is 0; [`SolveError::Metric`] if the metric is not
/// finite, symmetric and positive definite at the nodes and both ends of every start, or of
/// the result.
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
    const { assert!(!R::NODES.is_empty(), "a rule reads the metric somewhere") };
    if n == 0 {
        return Err(SolveError::NoSubinterval);
    }
    let grids = grids(n);
    let intervals = if n <= DIRECT { LINE_DIRECT } else { LINE_COARSE };
    let mut steps = 0;
    let mut candidates: Vec<Candidate<'_, D>> = Vec::new();
    let mut refused: Option<SolveError> = None;
    let pairs: Vec<_> = ends.pairs().collect();
    for (first, second) in &pairs {
        let pair = [&**first, &**second];
        if let Some(x) = common_point(pair[0], pair[1]) {
            check_gram(metric, &x)?;
            return Ok(Minimum::at_common_point(x, n));
        }
        let search = LocalSearch { metric, rule, ends: pair, iterations: options.iterations };
        for start in options.starts.between(metric, rule, pair, grids[0], intervals) {
            match search.check(&start).and_then(|()| search.run(start)) {
                Ok(found) => {
                    steps += found.iterations;
                    candidates.push(Candidate::new(pair, found));
                }
                Err(error) => refused = refused.or(Some(error.into())),
            }
        }
    }
    lowest_first(&mut candidates);
    let local_minima: Vec<f64> =
        candidates.iter().filter(|c| !c.failed()).map(|c| c.found.energy).collect();
    for &grid in &grids[1..] {
        candidates.truncate(if grid > SETTLED { 1 } else { FOLLOWED });
        for candidate in std::mem::take(&mut candidates) {
            let search =
                LocalSearch { metric, rule, ends: candidate.ends, iterations: options.iterations };
            let start = |memory| {
                candidate.start(grid, R::ERROR_EXPONENT, memory).map_err(SolveError::Sequence)
            };
            let refined = (grid >= FINE).then(|| {
                let start = start(workspace.spare.take(grid + 1)).ok()?;
                search.refine(start, candidate.found.magnitude(), workspace)
            });
            let found = match refined.flatten() {
                Some(found) => Ok(found),
                None => start(Vec::new()).and_then(|start| Ok(search.run(start)?)),
            };
            match found {
                Ok(found) => {
                    steps += found.iterations;
                    let (candidate, unused) = candidate.refined(found);
                    unused.into_iter().for_each(|x| workspace.spare.give(x.into_points()));
                    candidates.push(candidate);
                }
                Err(error) => refused = refused.or(Some(error)),
            }
        }
        lowest_first(&mut candidates);
    }
    let Some(Candidate { found, levels, .. }) = candidates.into_iter().next() else {
        return Err(refused.unwrap_or(SolveError::NoStart));
    };
    Ok(Minimum {
        sequence: found.sequence,
        energy: found.energy,
        decrement: found.decrement,
        residual: found.residual,
        residual_floor: found.residual_floor,
        stop: found.stop,
        curvature: found.curvature,
        iterations: steps,
        levels,
        local_minima,
    })
}

/// A local minimiser, the pieces it runs between and its energies on coarser grids.
struct Candidate<'a, const D: usize> {
    ends: [&'a dyn ClosedSet<D>; 2],
    found: Found<D>,
    /// The sequence on the next coarser grid.
    coarser: Option<PointSequence<D>>,
    levels: Vec<Level>,
}

impl<'a, const D: usize> Candidate<'a, D> {
    fn new(ends: [&'a dyn ClosedSet<D>; 2], found: Found<D>) -> Self {
        Self { ends, levels: vec![level(&found)], coarser: None, found }
    }

    /// Goes over to the minimiser on the next grid; returns the points on the grid before the last,
    /// which are not needed any more.
    fn refined(mut self, found: Found<D>) -> (Self, Option<PointSequence<D>>) {
        self.levels.push(level(&found));
        let coarser = std::mem::replace(&mut self.found, found).sequence;
        let before = self.coarser.replace(coarser);
        (self, before)
    }

    fn failed(&self) -> bool {
        matches!(self.found.stop, Stop::Stalled | Stop::IterationLimit)
    }

    /// Where to start on the next grid of `n` chords.
    ///
    /// The points obey `x_N = x + c N⁻ᑫ + …` as the energies do, so that two grids tell where
    /// they go on the third. That saves a Newton step there, once the error of prolongation,
    /// of fourth order, is smaller than what is extrapolated.
    fn start(
        &self,
        n: usize,
        exponent: i32,
        memory: Vec<SVector<f64, D>>,
    ) -> Result<PointSequence<D>, SequenceError> {
        let sequence = &self.found.sequence;
        let Some(coarser) = self.coarser.as_ref().filter(|c| c.n().get() >= EXTRAPOLATED) else {
            return PointSequence::new(prolong_into(sequence, n, memory));
        };
        let power = |n: usize| (n as f64).powi(-exponent);
        let here = sequence.n().get();
        let ratio = (power(n) - power(here)) / (power(here) - power(coarser.n().get()));
        let before = prolong(coarser, here);
        let mut points: Vec<_> =
            sequence.points().iter().zip(&before).map(|(x, y)| x + (x - y) * ratio).collect();
        points[0] = self.ends[0].project(&points[0]);
        points[here] = self.ends[1].project(&points[here]);
        PointSequence::new(prolong_into(&PointSequence::new(points)?, n, memory))
    }
}

fn level<const D: usize>(found: &Found<D>) -> Level {
    Level { n: found.sequence.n().get(), energy: found.energy }
}

/// Sorts by energy, and keeps one of those that are the same. A search that did not converge
/// counts behind all that did: its energy is that of no minimiser.
fn lowest_first<const D: usize>(candidates: &mut Vec<Candidate<'_, D>>) {
    candidates.sort_by(|a, b| {
        a.failed().cmp(&b.failed()).then(a.found.energy.total_cmp(&b.found.energy))
    });
    candidates.dedup_by(|b, a| {
        a.failed() == b.failed()
            && (b.found.energy - a.found.energy).abs() <= DIFFERENT * a.found.energy.abs()
    });
}

/// The grids on the way to `n`, coarsest first.
fn grids(n: usize) -> Vec<usize> {
    let mut grids = vec![n];
    let mut grid = n;
    while n > DIRECT && grid > COARSEST {
        grid = grid.div_ceil(REFINEMENT[FINER.iter().filter(|&&finer| grid >= finer).count()]);
        grids.push(grid);
    }
    grids.reverse();
    grids
}

#[cfg(test)]
mod tests {
    use tautline_discretizations::{LeftEndpoint, PointSequence, Rule, Trapezoidal};
    use tautline_metrics::gallery::Valleys;
    use tautline_sets::Point;

    use super::{Candidate, grids};
    use crate::{local_search::LocalSearch, prolongation::prolong};

    /// How far the start on the third grid is from the minimiser, with extrapolation and without.
    fn distances<R: Rule>(rule: R) -> [f64; 2] {
        let ends = [[0.0, 0.0], [2.0, 1.5]].map(|x| Point::new(x).expect("finite"));
        let ends: [&dyn tautline_sets::ClosedSet<2>; 2] = [&ends[0], &ends[1]];
        let search = LocalSearch { metric: &Valleys, rule, ends, iterations: 50 };
        let solve = |n| {
            let line = PointSequence::straight([0.0, 0.0], [2.0, 1.5], n).expect("finite");
            search.run(line).expect("a metric")
        };
        let candidate = Candidate::new(ends, solve(200)).refined(solve(800)).0;
        let fine = solve(3200).sequence;
        let distance = |points: &[nalgebra::SVector<f64, 2>]| {
            points.iter().zip(fine.points()).map(|(x, y)| (x - y).amax()).fold(0.0, f64::max)
        };
        let start = candidate.start(3200, R::ERROR_EXPONENT, Vec::new()).expect("finite");
        [distance(start.points()), distance(&prolong(&candidate.found.sequence, 3200))]
    }

    /// The first term of the error is of second order for one rule and of first for the other;
    /// what is left is the next term, smaller by about the coarsest step or its square. Without
    /// the right power, or with the wrong sign, as much is left as there was.
    #[test]
    fn the_points_are_extrapolated_to_the_next_grid() {
        for [extrapolated, prolonged] in [distances(Trapezoidal), distances(LeftEndpoint)] {
            assert!(extrapolated < 0.1 * prolonged, "{extrapolated:e} {prolonged:e}");
        }
    }

    #[test]
    fn grids_end_at_n_and_begin_coarse() {
        assert_eq!(grids(1), [1]);
        assert_eq!(grids(64), [64]);
        assert_eq!(grids(65), [17, 65]);
        assert_eq!(grids(1000), [16, 63, 250, 1000]);
        assert_eq!(grids(10_000), [20, 79, 313, 1250, 10_000]);
        assert_eq!(grids(100_000), [13, 49, 196, 782, 6250, 100_000]);
    }
}
