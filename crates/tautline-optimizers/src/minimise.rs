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
    /// Automatic starts, and 200 steps: a search that works takes less than 40.
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
/// where their order may change, and the grid beyond which only the lowest is.
const FOLLOWED: usize = 8;
const SETTLED: usize = 512;

/// Where the least energy rises by this factor from one grid to the next, the discrete minimisers
/// of the coarser one leapt over ridges that the finer one resolves, and need not lead to its lowest:
/// the starts are tried again.
const LEAP: f64 = 1.5;

/// From this grid on a search is expected to need no damping, and is tried without.
const FINE: usize = 64;

/// From so many grids the points are extrapolated, and none of them coarser than this.
const EXTRAPOLATED: usize = 3;
const COARSE: usize = 32;

/// Minima are different if their energies differ by more than this, relatively.
const DIFFERENT: f64 = 1e-9;

/// Returns the lowest discrete minimiser of `rule` between the sets `ends` that was found.
///
/// Every pair of pieces of the sets is tried from every start on the coarsest grid, which is the
/// only one for `n ≤ 64`; the best are carried to `n` chords over grids that refine by 4 to 16, two or
/// three Newton steps each, and none on the finest if the data are smooth and `n D²` is 32 768 or
/// more: the start is a minimiser to rounding there. Where
/// the energy rises by half from one of the coarse grids to the next, all starts are tried again. A
/// rule without nodes does not compile.
///
/// # Memory
///
/// At most `16D² + 16D` bytes for each point of the finest grid on which a Newton step is taken without
/// damping, four times as much if it has to be damped, and some tenth of that for coarser ones. Where the finest, of more than `32 768/D²` chords, needs none, its
/// points are all that it has: together less than 30 bytes a point for `D = 2`, and less than 20 from
/// `N = 10⁶` on, both measured on smooth metrics.
///
/// # Errors
///
/// [`SolveError::NoSubinterval`] if `n` is 0; [`SolveError::TooManySubintervals`] if no memory has
/// room for `n + 1` points; [`SolveError::Metric`] if the metric is not finite, symmetric and positive
/// definite at the nodes and both ends of every start, or of the result; [`SolveError::NoStart`] if
/// there is nothing to start from, [`SolveError::Sequence`] if points become infinite on the way.
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
    // An allocation has at most isize::MAX bytes; a Newton step takes 2D² + 2D numbers a point.
    if n >= isize::MAX as usize / (8 * (2 * D * D + 2 * D).max(1)) {
        return Err(SolveError::TooManySubintervals { n });
    }
    let pairs: Vec<_> = ends.pairs().collect();
    let pairs: Vec<_> = pairs.iter().map(|(first, second)| [&**first, &**second]).collect();
    for pair in &pairs {
        if let Some(x) = common_point(pair[0], pair[1]) {
            check_gram(metric, &x)?;
            return Ok(Minimum::at_common_point(x, n));
        }
    }
    let search = |ends| LocalSearch { metric, rule, ends, iterations: options.iterations };
    let intervals = if n <= DIRECT { LINE_DIRECT } else { LINE_COARSE };
    let mut steps = 0;
    let mut candidates: Vec<Candidate<'_, D>> = Vec::new();
    let mut refused: Option<SolveError> = None;
    let mut local_minima: Option<Vec<f64>> = None;
    for grid in grids(n) {
        candidates.truncate(if grid > SETTLED { 1 } else { FOLLOWED });
        for candidate in std::mem::take(&mut candidates) {
            let search = search(candidate.ends);
            let start = |memory| {
                candidate.start(grid, R::ERROR_EXPONENT, memory).map_err(SolveError::Sequence)
            };
            let mut in_vain = 0;
            let refined = (grid >= FINE).then(|| {
                let start = start(workspace.spare.take(grid + 1)).ok()?;
                search.refine(start, &candidate.found, workspace, &mut in_vain)
            });
            let found = match refined.flatten() {
                Some(found) => Ok(found),
                None => start(Vec::new()).and_then(|start| {
                    let found = search.run(start)?;
                    Ok(Found { iterations: in_vain + found.iterations, ..found })
                }),
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
        let unresolved = grid <= SETTLED && candidates.first().is_none_or(Candidate::leapt);
        if local_minima.is_none() || unresolved {
            for &pair in &pairs {
                let search = search(pair);
                for start in options.starts.between(metric, rule, pair, grid, intervals) {
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
        }
        local_minima.get_or_insert_with(|| {
            candidates.iter().filter(|c| !c.failed()).map(|c| c.found.energy).collect()
        });
    }
    let Some(Candidate { found, levels, iterations, .. }) = candidates.into_iter().next() else {
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
        own_iterations: iterations,
        levels,
        local_minima: local_minima.unwrap_or_default(),
    })
}

/// A local minimiser, the pieces it runs between and its energies on coarser grids.
struct Candidate<'a, const D: usize> {
    ends: [&'a dyn ClosedSet<D>; 2],
    found: Found<D>,
    /// The sequences on coarser grids, the finest last, as far as they are needed.
    coarser: Vec<PointSequence<D>>,
    levels: Vec<Level>,
    /// Newton steps so far.
    iterations: usize,
}

impl<'a, const D: usize> Candidate<'a, D> {
    fn new(ends: [&'a dyn ClosedSet<D>; 2], found: Found<D>) -> Self {
        let (levels, iterations) = (vec![level(&found)], found.iterations);
        Self { ends, levels, coarser: Vec::new(), iterations, found }
    }

    /// Goes over to the minimiser on the next grid; returns points on a coarser one which are not
    /// needed any more.
    fn refined(mut self, found: Found<D>) -> (Self, Option<PointSequence<D>>) {
        self.levels.push(level(&found));
        self.iterations += found.iterations;
        self.coarser.push(std::mem::replace(&mut self.found, found).sequence);
        let unused = self.coarser.len() >= EXTRAPOLATED;
        let unused = unused.then(|| self.coarser.remove(0));
        (self, unused)
    }

    /// Whether the energy has risen so much since the coarser grid that it was that of leaps.
    fn leapt(&self) -> bool {
        matches!(self.levels[..], [.., coarse, fine] if fine.energy > LEAP * coarse.energy)
    }

    fn failed(&self) -> bool {
        matches!(self.found.stop, Stop::Stalled | Stop::IterationLimit)
    }

    /// Where to start on the next grid of `n` chords.
    ///
    /// The points obey `x_N = x + a N⁻ᑫ + b N⁻²ᑫ + …` as the energies do, so that three grids tell
    /// where they go on the fourth, by a polynomial in `N⁻ᑫ`. What is left of the error is of the
    /// order of rounding on fine grids, and no Newton step is needed there.
    fn start(
        &self,
        n: usize,
        exponent: i32,
        memory: Vec<SVector<f64, D>>,
    ) -> Result<PointSequence<D>, SequenceError> {
        let sequence = &self.found.sequence;
        let here = sequence.n().get();
        let fine_enough = |coarser: &&PointSequence<D>| coarser.n().get() >= COARSE;
        let coarser: Vec<_> = self.coarser.iter().filter(fine_enough).collect();
        if coarser.is_empty() {
            return PointSequence::new(prolong_into(sequence, n, memory));
        }
        let power = |n: usize| (n as f64).powi(-exponent);
        // The weight of each in the polynomial of Lagrange through all.
        let grids: Vec<_> = coarser.iter().map(|c| c.n().get()).chain([here]).map(power).collect();
        let weight = |own: usize| {
            let others = grids.iter().enumerate().filter(|(other, _)| *other != own);
            others.map(|(_, h)| (power(n) - h) / (grids[own] - h)).product::<f64>()
        };
        let mut points = sequence.points().to_vec();
        for (own, coarser) in coarser.into_iter().enumerate() {
            let weight = weight(own);
            let before = prolong(coarser, here);
            let with = points.iter_mut().zip(sequence.points()).zip(&before);
            with.for_each(|((point, x), y)| *point += (y - x) * weight);
        }
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
    use crate::local_search::LocalSearch;

    /// How far the start with 3200 chords is from the minimiser, after a search on these grids.
    fn distance<R: Rule>(rule: R, grids: &[usize]) -> f64 {
        let ends = [[0.0, 0.0], [2.0, 1.5]].map(|x| Point::new(x).expect("finite"));
        let ends: [&dyn tautline_sets::ClosedSet<2>; 2] = [&ends[0], &ends[1]];
        let search = LocalSearch { metric: &Valleys, rule, ends, iterations: 50 };
        let solve = |n| {
            let line = PointSequence::straight([0.0, 0.0], [2.0, 1.5], n).expect("finite");
            search.run(line).expect("a metric")
        };
        let candidate = Candidate::new(ends, solve(grids[0]));
        let candidate = grids[1..].iter().fold(candidate, |c, &n| c.refined(solve(n)).0);
        let start = candidate.start(3200, R::ERROR_EXPONENT, Vec::new()).expect("finite");
        let fine = solve(3200).sequence;
        let pairs = start.points().iter().zip(fine.points());
        pairs.map(|(x, y)| (x - y).amax()).fold(0.0, f64::max)
    }

    /// The first term of the error is of second order for one rule and of first for the other, and
    /// the next of twice that: what is left is smaller by about the coarsest step or its square, for
    /// each grid more. Without the right power, or with the wrong sign, as much is left as there was.
    #[test]
    fn the_points_are_extrapolated_to_the_next_grid() {
        let one_by_one = [[800].as_slice(), &[200, 800], &[100, 200, 800], &[100, 100, 200, 800]];
        for [one, two, three, again] in [
            one_by_one.map(|grids| distance(Trapezoidal, grids)),
            one_by_one.map(|grids| distance(LeftEndpoint, grids)),
        ] {
            assert!(two < 0.1 * one, "{two:e} {one:e}");
            assert!(three < 0.1 * two, "{three:e} {two:e}");
            // No more than three are kept.
            assert_eq!(again, three);
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
