//! The corpus: random problems from the gallery, and the outcome of the solver on each.

mod metrics;
mod outcome;
mod sets;

use std::{hint::black_box, time::Instant};

use tautline::{Ends, Formula, Options, PointSequence, Problem, Rule, SVector, SolveError, Starts};
use tautline_checks::adversary::SplitMix;

use crate::Failure;

pub use metrics::{Beside, Drawn};
pub use outcome::{End, Search};
pub use sets::{Kind, Pair};

/// The seed of all problems.
pub const SEED: u64 = 6;

/// The largest number of subintervals, a power of two.
const LARGEST: usize = 4096;

/// Returns the first `count` problems of the corpus.
#[must_use]
pub fn corpus(count: usize) -> Vec<Case> {
    let mut seeds = SplitMix::new(SEED);
    (0..count).map(|index| Case { index, seed: seeds.bits() }).collect()
}

/// One of the problems, before its data are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Case {
    index: usize,
    seed: u64,
}

/// A problem whose data have been drawn.
struct Drawing<const D: usize> {
    metric: Drawn<D>,
    ends: Ends<D>,
    kinds: [Kind; 2],
    n: usize,
    rule: Rule,
}

/// Draws the dimension, and calls a function for it.
macro_rules! in_its_dimension {
    ($case:ident.$function:ident($($argument:expr),*)) => {{
        let mut random = SplitMix::new($case.seed);
        match random.below(8) {
            0 => $case.$function::<1>(random, $($argument),*),
            1 => $case.$function::<2>(random, $($argument),*),
            2 => $case.$function::<3>(random, $($argument),*),
            3 => $case.$function::<4>(random, $($argument),*),
            4 => $case.$function::<5>(random, $($argument),*),
            5 => $case.$function::<6>(random, $($argument),*),
            6 => $case.$function::<7>(random, $($argument),*),
            _ => $case.$function::<8>(random, $($argument),*),
        }
    }};
}

/// A problem, and how the searches for its solution ended.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The index of the problem in the corpus, from 0.
    pub index: usize,
    /// The metric.
    pub metric: &'static str,
    /// The dimension `D`.
    pub dimension: usize,
    /// The kinds of the two sets.
    pub ends: [Kind; 2],
    /// The rule, one of the two of the paper.
    pub rule: Rule,
    /// The number of subintervals `N`.
    pub n: usize,
    /// The search from the default starts.
    pub default: Search,
    /// The search that starts only from one straight line for each pair of pieces of the sets.
    pub straight: Search,
}

impl Case {
    /// Draws the problem and solves it.
    ///
    /// `D` is uniform in 1 to 8, both rules are equally likely, and `N` is log-uniform in 1 to
    /// 4096.
    ///
    /// # Errors
    ///
    /// There are none: the drawn data are admissible, and a refusal of the solver is an outcome.
    pub fn outcome(self) -> Result<Outcome, Failure> {
        in_its_dimension!(self.outcome_in())
    }

    /// Draws the problem, and times its solution from the default starts for each of these numbers
    /// of subintervals. Returns the smallest time of several runs, in seconds.
    ///
    /// It runs on one thread and reuses memory. The metric is a recorded formula, which takes
    /// longer at a single point than a compiled one.
    ///
    /// # Errors
    ///
    /// There are none: the parameters are admissible. A refusal of the solver is timed as well.
    pub fn seconds(self, ns: &[usize], runs: usize) -> Result<Vec<f64>, Failure> {
        in_its_dimension!(self.seconds_in(ns, runs))
    }

    fn draw<const D: usize>(self, mut random: SplitMix) -> Result<Drawing<D>, Failure> {
        let (metric, reach) = Drawn::<D>::new(&mut random)?;
        let Pair { ends, kinds } = Pair::<D>::new(&mut random, reach)?;
        // An octave is drawn first, then a number in it: integers are the same on every machine.
        let octave = 1 << random.below(LARGEST.ilog2() as usize);
        let n = octave + random.below(octave + 1);
        let rule = if random.below(2) == 0 { Rule::TRAPEZOIDAL } else { Rule::LEFT_ENDPOINT };
        Ok(Drawing { metric, ends, kinds, n, rule })
    }

    fn seconds_in<const D: usize>(
        self,
        random: SplitMix,
        ns: &[usize],
        runs: usize,
    ) -> Result<Vec<f64>, Failure> {
        let Drawing { metric, ends, rule, .. } = self.draw::<D>(random)?;
        let problem = Problem::new(metric.formula, ends);
        let options = Options { threads: 1, ..Options::default() };
        let mut least = vec![f64::INFINITY; ns.len()];
        // The values of `N` take turns, so that other load on the machine affects all of them
        // alike.
        for _ in 0..runs {
            for (least, &n) in least.iter_mut().zip(ns) {
                let begin = Instant::now();
                let _ = black_box(search(&problem, rule, n, &options));
                *least = least.min(begin.elapsed().as_secs_f64());
            }
        }
        Ok(least)
    }

    fn outcome_in<const D: usize>(self, random: SplitMix) -> Result<Outcome, Failure> {
        let Drawing { metric, ends, kinds, n, rule } = self.draw::<D>(random)?;
        let name = metric.name;
        let first = ends.first().project(&SVector::zeros());
        let straight = PointSequence::straight(first, ends.second().project(&first), n)?;
        let problem = Problem::new(metric.formula, ends);
        let from = |starts| {
            let options = Options { starts, threads: 1, ..Options::default() };
            search(&problem, rule, n, &options).unwrap_or_else(Search::refused)
        };
        Ok(Outcome {
            index: self.index,
            metric: name,
            dimension: D,
            ends: kinds,
            rule,
            n,
            default: from(Starts::Automatic),
            straight: from(Starts::Only(vec![straight])),
        })
    }
}

fn search<const D: usize>(
    problem: &Problem<Formula<D>, D>,
    rule: Rule,
    n: usize,
    options: &Options<D>,
) -> Result<Search, SolveError> {
    Ok(Search::new(problem.solve_with(rule, n, options)?.minimum()))
}
