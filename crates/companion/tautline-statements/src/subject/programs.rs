//! The programs of a subject that are generic in the dimension.
//!
//! A mutant reads the metric through [`AnyMetric`], so that its code is compiled once for each
//! dimension, and not once for each metric.

use std::num::NonZeroUsize;

use nalgebra::{SMatrix, SVector};
use tautline::{
    AnyMetric, Bounded, ClosedSet, Constants, Ends, Integral, Interpolation, Metric, MetricError,
    Minimum, Options, PointSequence, Rule, SolveError,
    bounds::{LocalityError, PaperRule, Region, competitors},
    christoffel, energy_gradient, minimise,
};

use super::Subject;
use crate::{
    mutants::{
        Mutant,
        programs::{
            christoffel_with_wrong_sign, frozen_gradient, mistaken_rule, without_last_chord,
        },
        solver, with_l_h,
    },
    replaceable::Program,
};

impl Subject {
    /// Returns the discrete energy of a sequence, in `m²`.
    pub fn discrete_energy<const D: usize>(
        &self,
        rule: Rule,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        let Some(mutant) = self.mistake(Program::DiscreteEnergy) else {
            return rule.energy(metric, sequence);
        };
        let metric = &AnyMetric::new(metric);
        match mutant {
            Mutant::EnergyHalved => 0.5 * rule.energy(metric, sequence),
            Mutant::LastChordLost => without_last_chord(rule, metric, sequence),
            _ => mistaken_rule(mutant, rule).energy(metric, sequence),
        }
    }

    /// Returns the discrete length of a sequence, in `m`.
    pub fn discrete_length<const D: usize>(
        &self,
        rule: Rule,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        let Some(mutant) = self.mistake(Program::DiscreteLength) else {
            return rule.length(metric, sequence);
        };
        let metric = &AnyMetric::new(metric);
        match mutant {
            // This is Σ dᵀHd over the chords d.
            Mutant::RootLost => rule.energy(metric, sequence) / sequence.n().get() as f64,
            _ => mistaken_rule(mutant, rule).length(metric, sequence),
        }
    }

    /// Returns the discrete speeds of the chords, in `m`.
    pub fn discrete_speeds<const D: usize>(
        &self,
        rule: Rule,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<f64> {
        self.note(|asked| asked.add(Program::DiscreteSpeeds));
        rule.speeds(metric, sequence)
    }

    /// Returns `∂E_N/∂xₙ` for all `N + 1` points, in `m²/ℓ`.
    pub fn energy_gradient<const D: usize>(
        &self,
        rule: Rule,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<SVector<f64, D>> {
        let Some(mutant) = self.mistake(Program::EnergyGradient) else {
            return energy_gradient(rule, metric, sequence).1;
        };
        let metric = &AnyMetric::new(metric);
        match mutant {
            Mutant::GradientReversed => {
                energy_gradient(rule, metric, sequence).1.into_iter().map(|slope| -slope).collect()
            }
            Mutant::MetricFrozen => frozen_gradient(rule, metric, sequence),
            _ => energy_gradient(mistaken_rule(mutant, rule), metric, sequence).1,
        }
    }

    /// Returns the energy `E(γᵖˡ)` of the reconstruction, in `m²`.
    pub fn curve_energy<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        let Some(mutant) = self.mistake(Program::CurveEnergy) else {
            return Interpolation::new(sequence).energy(metric);
        };
        let metric = &AnyMetric::new(metric);
        let value = match mutant {
            Mutant::QuadratureOfOneNode => Rule::TRAPEZOIDAL.energy(metric, sequence),
            _ => Rule::TRUE_TRAPEZOID.energy(metric, sequence),
        };
        Integral { value, error: 0.0 }
    }

    /// Returns the length `L(γᵖˡ)` of the reconstruction, in `m`.
    pub fn curve_length<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        if self.mistake(Program::CurveLength).is_none() {
            return Interpolation::new(sequence).length(metric);
        }
        let energy = Interpolation::new(sequence).energy(&AnyMetric::new(metric));
        let value = energy.value.sqrt();
        Integral { value, error: 0.5 * energy.error / value }
    }

    /// Returns `K₃`, the root mean square of the differences, in `ℓ`.
    pub fn k3<const D: usize>(&self, sequence: &PointSequence<D>) -> f64 {
        match self.mistake(Program::K3) {
            None => sequence.k3(),
            Some(_) => sequence.k3() * (sequence.n().get() as f64).sqrt(),
        }
    }

    /// Returns the Christoffel symbols at a point, in `1/ℓ`.
    ///
    /// # Errors
    ///
    /// The errors of [`christoffel`].
    pub fn christoffel<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
    ) -> Result<[SMatrix<f64, D, D>; D], MetricError> {
        match self.mistake(Program::Christoffel) {
            None => christoffel(metric, x),
            Some(Mutant::ChristoffelDoubled) => {
                Ok(christoffel(&AnyMetric::new(metric), x)?.map(|symbols| symbols * 2.0))
            }
            Some(_) => christoffel_with_wrong_sign(&AnyMetric::new(metric), x),
        }
    }

    /// Returns the nearest point in a set, in `ℓ`.
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
    /// The errors of [`minimise`].
    pub fn minimise<const D: usize>(
        &self,
        rule: Rule,
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
    /// The errors of [`minimise`].
    pub fn minimise_with<const D: usize>(
        &self,
        rule: Rule,
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

    /// Returns the constants that a metric claims to have.
    pub fn constants<const D: usize>(&self, metric: &impl Bounded<D>) -> Constants {
        let genuine = metric.constants();
        match self.mistake(Program::Constants) {
            None => genuine,
            Some(Mutant::LipschitzTooSmall) => with_l_h(genuine, 0.9),
            Some(_) => with_l_h(genuine, 2.0),
        }
    }

    /// Returns the region of Proposition S.8, which no competitor leaves.
    ///
    /// # Errors
    ///
    /// The errors of [`competitors`].
    pub fn competitors<E>(
        &self,
        dimension: usize,
        rule: PaperRule,
        n: NonZeroUsize,
        upper: f64,
        constants_within: impl FnMut(f64) -> Result<Constants, E>,
    ) -> Result<Region, LocalityError<E>> {
        let mut region = competitors(dimension, rule, n, upper, constants_within)?;
        if self.mistake(Program::Competitors).is_some() {
            region.radius *= (region.constants.c1() / region.constants.c2()).sqrt();
        }
        Ok(region)
    }
}
