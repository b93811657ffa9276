//! The corpus: random problems over the gallery, and how the solver ends on each.

mod metrics;
mod outcome;
mod sets;

use tautline::{
    LeftEndpoint, Options, PointSequence, Problem, SVector, SolveError, Starts, Trapezoidal,
};
use tautline_verify::adversary::SplitMix;

use crate::Failure;

pub use metrics::{Beside, Drawn};
pub use outcome::{End, Search};
pub use sets::{Kind, Pair};

/// The seed of all problems.
pub const SEED: u64 = 6;

/// The largest number of subintervals, a power of two.
const LARGEST: usize = 4096;

/// The first `count` problems of the corpus: more of them begin with the same.
#[must_use]
pub fn corpus(count: usize) -> Vec<Case> {
    let mut seeds = SplitMix::new(SEED);
    (0..count).map(|index| Case { index, seed: seeds.bits() }).collect()
}

/// One of the problems, not drawn yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Case {
    index: usize,
    seed: u64,
}

/// What a problem is, and how the searches for its solution ended.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The place of the problem in the corpus, from 0 on.
    pub index: usize,
    /// The metric.
    pub metric: &'static str,
    /// The dimension `D`.
    pub dimension: usize,
    /// What the two sets are.
    pub ends: [Kind; 2],
    /// Whether the rule is the trapezoidal one, and not the left-endpoint rule.
    pub trapezoidal: bool,
    /// The number of subintervals `N`.
    pub n: usize,
    /// The solution from the default starts.
    pub default: Search,
    /// That from one straight line alone, for each pair of pieces of the sets.
    pub straight: Search,
}

impl Case {
    /// Draws the problem and solves it.
    ///
    /// `D` is one of 1 to 8 and equally often each, the rule either; `N` is log-uniform in
    /// 1 to 4096.
    ///
    /// # Errors
    ///
    /// None: what is drawn is admissible. That the solver refuses is part of the outcome.
    pub fn outcome(self) -> Result<Outcome, Failure> {
        let mut random = SplitMix::new(self.seed);
        match random.below(8) {
            0 => self.of_dimension::<1>(random),
            1 => self.of_dimension::<2>(random),
            2 => self.of_dimension::<3>(random),
            3 => self.of_dimension::<4>(random),
            4 => self.of_dimension::<5>(random),
            5 => self.of_dimension::<6>(random),
            6 => self.of_dimension::<7>(random),
            _ => self.of_dimension::<8>(random),
        }
    }

    fn of_dimension<const D: usize>(self, mut random: SplitMix) -> Result<Outcome, Failure> {
        let (metric, reach) = Drawn::<D>::new(&mut random)?;
        let Pair { ends, kinds } = Pair::<D>::new(&mut random, reach)?;
        // An octave, then a number of it: by integers, which are the same on every machine.
        let octave = 1 << random.below(LARGEST.ilog2() as usize);
        let n = octave + random.below(octave + 1);
        let trapezoidal = random.below(2) == 0;
        let name = metric.name();
        let first = ends.first().project(&SVector::zeros());
        let straight = PointSequence::straight(first, ends.second().project(&first), n)?;
        let problem = Problem::new(metric, ends);
        let search = |starts| -> Result<Search, SolveError> {
            let options = Options { starts, threads: 1, ..Options::default() };
            Ok(if trapezoidal {
                Search::new(problem.solve_with(Trapezoidal, n, &options)?.minimum())
            } else {
                Search::new(problem.solve_with(LeftEndpoint, n, &options)?.minimum())
            })
        };
        Ok(Outcome {
            index: self.index,
            metric: name,
            dimension: D,
            ends: kinds,
            trapezoidal,
            n,
            default: search(Starts::Automatic).unwrap_or_else(Search::refused),
            straight: search(Starts::Only(vec![straight])).unwrap_or_else(Search::refused),
        })
    }
}
