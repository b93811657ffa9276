//! `Subject`: the implementation under test, the library or a mutant.

mod bounds;
mod programs;

use std::sync::atomic::{AtomicU64, Ordering};

use crate::{
    mutants::Mutant,
    replaceable::{Asked, Bounds, Program},
};

/// The implementation under test: discrete energies, reconstructions, solver, constants and bounds.
///
/// It is [the library](LIBRARY), or the library with one change, which a good test suite detects.
/// The change replaces entries in the [table of bounds](Bounds), or it is the mistake of a
/// [`Mutant`] in programs that are generic in the dimension.
///
/// All numbers have the units of the functions called.
#[derive(Debug)]
pub struct Subject {
    bounds: Bounds,
    /// The mutant whose mistake is made in its [programs](Mutant::programs), if any.
    mistake: Option<Mutant>,
    /// The programs called so far, as bits of [`Asked`].
    asked: AtomicU64,
}

/// The library itself.
pub static LIBRARY: Subject = Subject::with(Bounds::LIBRARY);

const _: () = assert!((Program::Competitors as usize) < Asked::PROGRAMS);

impl Subject {
    /// Returns the library with these bounds and constants.
    #[must_use]
    pub const fn with(bounds: Bounds) -> Self {
        Self { bounds, mistake: None, asked: AtomicU64::new(0) }
    }

    /// Returns the programs called since the last call of this method.
    #[must_use]
    pub fn take_asked(&self) -> Asked {
        Asked(self.asked.swap(0, Ordering::Relaxed))
    }

    /// Returns the programs that differ from the library's.
    #[must_use]
    pub fn replaced(&self) -> Asked {
        let mut replaced = self.bounds.replaced();
        for &program in self.mistake.map_or(&[][..], Mutant::programs) {
            replaced.add(program);
        }
        replaced
    }

    fn note(&self, add: impl Fn(&mut Asked)) {
        let mut asked = Asked::default();
        add(&mut asked);
        // Read first, because threads that share the library would otherwise wait for each other's
        // writes.
        if self.asked.load(Ordering::Relaxed) & asked.0 == 0 {
            self.asked.fetch_or(asked.0, Ordering::Relaxed);
        }
    }

    /// Notes the call of a program, and returns the mutant if its mistake is in this program.
    fn mistake(&self, program: Program) -> Option<Mutant> {
        self.note(|asked| asked.add(program));
        self.mistake.filter(|mutant| mutant.programs().contains(&program))
    }
}

impl From<Mutant> for Subject {
    /// Returns the library with the mistake of the mutant.
    fn from(mutant: Mutant) -> Self {
        Self { mistake: Some(mutant), ..Self::with(mutant.bounds()) }
    }
}

#[cfg(test)]
mod tests {
    use super::{Asked, Subject};
    use crate::{Mutant, replaceable::GENUINE};

    /// If a mutant declares an entry too many, checks are run that cannot see it. If it declares
    /// one too few, it passes.
    #[test]
    fn a_mutant_replaces_what_it_is_wrong_in_and_nothing_else() {
        for mutant in Mutant::ALL {
            let programs = mutant.programs();
            let entries = match mutant {
                _ if !programs.is_empty() => programs.len(),
                Mutant::CrossTermLost
                | Mutant::VarianceHalved
                | Mutant::SkewnessForgotten
                | Mutant::KurtosisForgotten
                | Mutant::SlopeForgotten
                | Mutant::CurvatureOfConvexityForgotten => 2,
                _ => 1,
            };
            let Asked(replaced) = Subject::from(mutant).replaced();
            assert_eq!(replaced.count_ones() as usize, entries, "{mutant:?}");
        }
        assert_eq!(Subject::with(GENUINE).replaced(), Asked::default());
    }
}
