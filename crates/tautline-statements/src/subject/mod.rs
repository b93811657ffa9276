//! `Subject`: the implementation under test, the library's or a mutant's.

mod asked;
mod bounds;

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicU64, Ordering};

use nalgebra::{SMatrix, SVector};
use tautline::{
    AnyMetric, Bounded, ClosedSet, Constants, Ends, Integral, Interpolation, Metric, MetricError,
    Minimum, Options, PointSequence, Rule, SolveError,
    bounds::{LocalityError, PaperRule, Region, competitors},
    christoffel, energy_gradient, minimise,
};

pub use asked::Asked;
pub use bounds::Bounds;
pub(crate) use bounds::GENUINE;

use crate::mutants::{Mutant, programs, solver};

/// The programs by which a statement is evaluated: discrete energies, reconstructions, solver,
/// constants and bounds.
///
/// It is [the library](LIBRARY), or the library with one thing changed: what a suite of tests says of such
/// a variant shows what the suite is worth. Bounds and constants are a [table](Bounds), of which entries
/// are replaced; programs that are generic in the dimension make the mistake of a [`Mutant`].
///
/// Units: those of the functions that are called.
#[derive(Debug)]
pub struct Subject {
    bounds: Bounds,
    /// Wrong in its [programs](Mutant::programs), where it has any.
    mistake: Option<Mutant>,
    /// What has been asked so far, as bits of [`Asked`].
    asked: AtomicU64,
}

/// The library itself.
pub static LIBRARY: Subject = Subject::with(Bounds::LIBRARY);

/// The programs that are generic in the dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Program {
    DiscreteEnergy,
    DiscreteLength,
    DiscreteSpeeds,
    EnergyGradient,
    CurveEnergy,
    CurveLength,
    K3,
    Christoffel,
    Project,
    Minimise,
    Constants,
    Competitors,
}

const _: () = assert!((Program::Competitors as usize) < Asked::PROGRAMS);

impl Subject {
    /// Returns the library with these bounds and constants.
    #[must_use]
    pub const fn with(bounds: Bounds) -> Self {
        Self { bounds, mistake: None, asked: AtomicU64::new(0) }
    }

    /// Returns what has been asked since the last time.
    #[must_use]
    pub fn take_asked(&self) -> Asked {
        Asked(self.asked.swap(0, Ordering::Relaxed))
    }

    /// Returns what is not the library's.
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
        // Threads that share the library would wait for each other's writes.
        if self.asked.load(Ordering::Relaxed) & asked.0 == 0 {
            self.asked.fetch_or(asked.0, Ordering::Relaxed);
        }
    }

    /// The mistake in this program, if there is one.
    fn mistake(&self, program: Program) -> Option<Mutant> {
        self.note(|asked| asked.add(program));
        self.mistake.filter(|mutant| mutant.programs().contains(&program))
    }
}

impl From<Mutant> for Subject {
    /// The library with the mistake of the mutant.
    fn from(mutant: Mutant) -> Self {
        Self { mistake: Some(mutant), ..Self::with(mutant.bounds()) }
    }
}

impl Subject {
    /// Returns the discrete energy of a sequence, in `m²`.
    pub fn discrete_energy<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        match self.mistake(Program::DiscreteEnergy) {
            None => rule.energy(metric, sequence),
            Some(mutant) => {
                programs::discrete_energy(mutant, rule, &AnyMetric::new(metric), sequence)
            }
        }
    }

    /// Returns the discrete length of a sequence, in `m`.
    pub fn discrete_length<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        match self.mistake(Program::DiscreteLength) {
            None => rule.length(metric, sequence),
            Some(mutant) => {
                programs::discrete_length(mutant, rule, &AnyMetric::new(metric), sequence)
            }
        }
    }

    /// Returns the discrete speeds of the chords, in `m`.
    pub fn discrete_speeds<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<f64> {
        self.note(|asked| asked.add(Program::DiscreteSpeeds));
        rule.speeds(metric, sequence)
    }

    /// Returns `∂E_N/∂xₙ` for all `N + 1` points, in `m²/ℓ`.
    pub fn energy_gradient<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<SVector<f64, D>> {
        match self.mistake(Program::EnergyGradient) {
            None => energy_gradient(rule, metric, sequence).1,
            Some(mutant) => {
                programs::energy_gradient(mutant, rule, &AnyMetric::new(metric), sequence)
            }
        }
    }

    /// Returns the energy `E(γᵖˡ)` of the reconstruction, in `m²`.
    pub fn curve_energy<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        match self.mistake(Program::CurveEnergy) {
            None => Interpolation::new(sequence).energy(metric),
            Some(mutant) => programs::curve_energy(mutant, &AnyMetric::new(metric), sequence),
        }
    }

    /// Returns the length `L(γᵖˡ)` of the reconstruction, in `m`.
    pub fn curve_length<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        match self.mistake(Program::CurveLength) {
            None => Interpolation::new(sequence).length(metric),
            Some(_) => programs::length_from_energy(&AnyMetric::new(metric), sequence),
        }
    }

    /// Returns `K₃`, the root mean square of the differences, in `ℓ`.
    pub fn k3<const D: usize>(&self, sequence: &PointSequence<D>) -> f64 {
        match self.mistake(Program::K3) {
            None => sequence.k3(),
            Some(_) => programs::k3_without_mean(sequence),
        }
    }

    /// Returns the Christoffel symbols at a point, in `1/ℓ`.
    ///
    /// # Errors
    ///
    /// As [`christoffel`].
    pub fn christoffel<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
    ) -> Result<[SMatrix<f64, D, D>; D], MetricError> {
        match self.mistake(Program::Christoffel) {
            None => christoffel(metric, x),
            Some(mutant) => programs::christoffel_symbols(mutant, &AnyMetric::new(metric), x),
        }
    }

    /// Returns the nearest point of a set, in `ℓ`.
    pub fn project<const D: usize>(
        &self,
        set: &dyn ClosedSet<D>,
        x: &SVector<f64, D>,
    ) -> SVector<f64, D> {
        match self.mistake(Program::Project) {
            None => set.project(x),
            Some(_) => *x,
        }
    }

    /// Returns the discrete minimiser that the solver finds from its own starts.
    ///
    /// # Errors
    ///
    /// As [`minimise`].
    pub fn minimise<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        ends: &Ends<D>,
        n: usize,
    ) -> Result<Minimum<D>, SolveError> {
        self.minimise_with(rule, metric, ends, n, &Options::default())
    }

    /// Returns the discrete minimiser that the solver finds with these options.
    ///
    /// # Errors
    ///
    /// As [`minimise`].
    pub fn minimise_with<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        ends: &Ends<D>,
        n: usize,
        options: &Options<D>,
    ) -> Result<Minimum<D>, SolveError> {
        match self.mistake(Program::Minimise) {
            None => minimise(metric, ends, rule, n, options),
            Some(mutant) => {
                solver::minimise_with(mutant, rule, &AnyMetric::new(metric), ends, n, options)
            }
        }
    }

    /// Returns what a metric claims of itself.
    pub fn constants<const D: usize>(&self, metric: &impl Bounded<D>) -> Constants {
        let genuine = metric.constants();
        self.mistake(Program::Constants)
            .map_or(genuine, |mutant| programs::constants(mutant, genuine))
    }

    /// Returns the region of Proposition S.8, outside of which no competitor comes.
    ///
    /// # Errors
    ///
    /// As [`competitors`].
    pub fn competitors<E>(
        &self,
        dimension: usize,
        rule: PaperRule,
        n: NonZeroUsize,
        upper: f64,
        constants_within: impl FnMut(f64) -> Result<Constants, E>,
    ) -> Result<Region, LocalityError<E>> {
        let genuine = competitors(dimension, rule, n, upper, constants_within)?;
        Ok(match self.mistake(Program::Competitors) {
            None => genuine,
            Some(_) => programs::region_of_c2(genuine),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Asked, Subject};
    use crate::Mutant;

    /// An entry too many would put a mutant to checks that cannot see it; one too few, a mutant that is the
    /// library.
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
        assert_eq!(Subject::with(super::GENUINE).replaced(), Asked::default());
    }
}
