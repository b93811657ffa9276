//! `Effort`: how long a kit looks.

use tautline_chance::Chance;

/// How many samples are drawn, how many problems solved, and the seed of all of them.
///
/// The same effort draws the same samples in every run. The [default](Effort::default) is the same
/// in every run too, unless the environment [asks for another](super::Chance::asked).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Random samples for each law.
    pub cases: u32,
    /// Local ascents towards each constant, from the best of the samples.
    pub ascents: usize,
    /// Problems that are posed for each theorem, each solved for every `N` of
    /// [`subintervals`](Effort::subintervals).
    pub problems: u32,
    /// The numbers of subintervals, from 1.
    pub subintervals: &'static [usize],
    /// The seed of all samples.
    pub seed: u64,
}

impl Effort {
    /// The default up to three dimensions. Above, half of the problems and fewer numbers of
    /// subintervals, since a solve costs `D³`.
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
}

impl Default for Effort {
    /// One or two seconds for a metric of two or three dimensions with `opt-level = 2`, and some 15
    /// in an unoptimised build: see [how to set it](crate#test-a-metric-of-your-own).
    ///
    /// As many samples and problems as `TAUTLINE_CASES` says, and another seed where `TAUTLINE_SEED`
    /// is set.
    ///
    /// # Panics
    ///
    /// If one of them is set to something else than a number.
    fn default() -> Self {
        Self::drawn_by(Chance::asked())
    }
}

impl Effort {
    fn drawn_by(chance: Chance) -> Self {
        Self {
            cases: chance.cases(256),
            ascents: 6,
            problems: chance.cases(12),
            subintervals: &[1, 2, 3, 8, 32],
            seed: chance.seed(1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Chance, Effort};

    #[test]
    fn seed_and_cases_are_those_that_were_asked_for() {
        let fixed = Effort::drawn_by(Chance::FIXED);
        assert_eq!((fixed.cases, fixed.problems, fixed.seed), (256, 12, 1));
        let chance = Chance::new(Some("7"), Some("3")).expect("numbers");
        let asked = Effort::drawn_by(chance);
        assert_eq!((asked.cases, asked.problems, asked.seed), (768, 36, chance.seed(1)));
        assert!(asked.seed != fixed.seed && asked.ascents == fixed.ascents);
    }
}
