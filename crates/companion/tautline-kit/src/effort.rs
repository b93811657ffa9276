//! `Effort`: how thoroughly the kit tests.

use tautline_chance::Chance;

use super::{Failure, Fault};

/// The number of samples to draw, the number of problems to solve, and the seed.
///
/// The same effort draws the same samples in every run. The [default](Effort::default) effort does
/// too, unless the environment [sets another seed](super::Chance::asked).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// The number of random samples for each law.
    pub cases: u32,
    /// The number of local ascents towards each constant, starting from the best of the samples.
    pub ascents: usize,
    /// The number of problems for each theorem. Each problem is solved for every `N` in
    /// [`subintervals`](Effort::subintervals).
    pub problems: u32,
    /// The numbers of subintervals, each at least 1.
    pub subintervals: &'static [usize],
    /// The seed of all samples.
    pub seed: u64,
}

impl Effort {
    /// Returns the default effort in up to three dimensions. In higher dimensions, where a solve
    /// costs `D³`, it has half as many problems and fewer numbers of subintervals.
    #[must_use]
    pub fn for_dimension(dimension: usize) -> Self {
        if dimension <= 3 {
            return Self::default();
        }
        let problems = Chance::asked().cases(6);
        Self { problems, subintervals: &[1, 2, 8], ..Self::default() }
    }

    /// Returns the effort with another seed.
    #[must_use]
    pub fn with_seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    fn drawn_by(chance: Chance) -> Self {
        Self {
            cases: chance.cases(256),
            ascents: 6,
            problems: chance.cases(12),
            subintervals: &[1, 2, 3, 8, 32],
            seed: chance.seed(1),
        }
    }

    /// Returns a failure that is not shown by a random sample.
    pub(crate) fn failure(&self, fault: impl Into<Fault>) -> Failure {
        Failure { fault: fault.into(), sample: None, seed: self.seed }
    }
}

impl Default for Effort {
    /// With this effort the tests of a metric in two or three dimensions take one or two seconds
    /// with `opt-level = 2`, and about 15 in an unoptimised build: see [how to set
    /// it](crate#test-a-metric-of-your-own).
    ///
    /// `TAUTLINE_CASES` multiplies the numbers of samples and problems; `TAUTLINE_SEED` changes the
    /// seed.
    ///
    /// # Panics
    ///
    /// If the value of one of these variables is not a number.
    fn default() -> Self {
        Self::drawn_by(Chance::asked())
    }
}

#[cfg(test)]
mod tests {
    use super::{Chance, Effort};

    #[test]
    fn the_environment_sets_seed_and_cases() {
        let fixed = Effort::drawn_by(Chance::FIXED);
        assert_eq!((fixed.cases, fixed.problems, fixed.seed), (256, 12, 1));
        let chance = Chance::new(Some("7"), Some("3")).expect("numbers");
        let asked = Effort::drawn_by(chance);
        assert_eq!((asked.cases, asked.problems, asked.seed), (768, 36, chance.seed(1)));
        assert!(asked.seed != fixed.seed && asked.ascents == fixed.ascents);
    }
}
