//! Each mutant as a subject: the one method that is wrong.

use std::num::NonZeroUsize;

use nalgebra::{SMatrix, SVector};
use tautline::{
    Bounded, ClosedSet, Constants, Ends, Integral, LeftEndpoint, Metric, MetricError, Minimum,
    Options, PointSequence, Rule, SolveError, Trapezoidal, TrueTrapezoid,
    bounds::{
        BetweenPoints, Bound, BoundError, Computed, Enclosure, LocalityError, PaperRule, Region,
        Setting, Spread,
    },
};

use super::{Mutant, enclosures, mutations, sharper, solver, solver::is_trapezoidal, theorems};
use crate::{Library, Subject};

/// The library with the mistake of a mutant; with none, the library.
impl Subject for Option<Mutant> {
    fn discrete_energy<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        let genuine = Library.discrete_energy(rule, metric, sequence);
        match self {
            Some(Mutant::RulesExchanged) if is_trapezoidal::<R>() => {
                LeftEndpoint.energy(metric, sequence)
            }
            Some(Mutant::RulesExchanged) => Trapezoidal.energy(metric, sequence),
            Some(Mutant::TrueTrapezoid) if is_trapezoidal::<R>() => {
                TrueTrapezoid.energy(metric, sequence)
            }
            Some(Mutant::EnergyHalved) => 0.5 * genuine,
            Some(Mutant::LastChordLost) => mutations::without_last_chord(rule, metric, sequence),
            _ => genuine,
        }
    }

    fn discrete_length<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        match self {
            // Σ dᵀHd over the chords d.
            Some(Mutant::RootLost) => rule.energy(metric, sequence) / sequence.n().get() as f64,
            Some(Mutant::RulesExchanged) if is_trapezoidal::<R>() => {
                LeftEndpoint.length(metric, sequence)
            }
            Some(Mutant::RulesExchanged) => Trapezoidal.length(metric, sequence),
            Some(Mutant::TrueTrapezoid) if is_trapezoidal::<R>() => {
                TrueTrapezoid.length(metric, sequence)
            }
            _ => Library.discrete_length(rule, metric, sequence),
        }
    }

    fn energy_gradient<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<SVector<f64, D>> {
        match self {
            Some(Mutant::RulesExchanged) if is_trapezoidal::<R>() => {
                Library.energy_gradient(LeftEndpoint, metric, sequence)
            }
            Some(Mutant::RulesExchanged) => Library.energy_gradient(Trapezoidal, metric, sequence),
            Some(Mutant::GradientReversed) => {
                let gradient = Library.energy_gradient(rule, metric, sequence);
                gradient.into_iter().map(|slope| -slope).collect()
            }
            Some(Mutant::MetricFrozen) => mutations::frozen_gradient(rule, metric, sequence),
            _ => Library.energy_gradient(rule, metric, sequence),
        }
    }

    fn curve_energy<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        let exact = |value| Integral { value, error: 0.0 };
        match self {
            Some(Mutant::QuadratureOfOneNode) => exact(Trapezoidal.energy(metric, sequence)),
            Some(Mutant::QuadratureByEnds) => exact(TrueTrapezoid.energy(metric, sequence)),
            _ => Library.curve_energy(metric, sequence),
        }
    }

    fn curve_length<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        match self {
            Some(Mutant::LengthFromEnergy) => {
                let energy = Library.curve_energy(metric, sequence);
                let value = energy.value.sqrt();
                Integral { value, error: 0.5 * energy.error / value }
            }
            _ => Library.curve_length(metric, sequence),
        }
    }

    fn k3<const D: usize>(&self, sequence: &PointSequence<D>) -> f64 {
        let genuine = Library.k3(sequence);
        match self {
            Some(Mutant::MeanForgotten) => genuine * (sequence.n().get() as f64).sqrt(),
            _ => genuine,
        }
    }

    fn christoffel<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
    ) -> Result<[SMatrix<f64, D, D>; D], MetricError> {
        match self {
            Some(Mutant::ChristoffelSign) => mutations::christoffel_with_wrong_sign(metric, x),
            Some(Mutant::ChristoffelDoubled) => {
                Ok(Library.christoffel(metric, x)?.map(|symbols| symbols * 2.0))
            }
            _ => Library.christoffel(metric, x),
        }
    }

    fn project<const D: usize>(
        &self,
        set: &dyn ClosedSet<D>,
        x: &SVector<f64, D>,
    ) -> SVector<f64, D> {
        match self {
            Some(Mutant::NotProjected) => *x,
            _ => Library.project(set, x),
        }
    }

    fn minimise_with<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        ends: &Ends<D>,
        n: usize,
        options: &Options<D>,
    ) -> Result<Minimum<D>, SolveError> {
        solver::minimise_with(*self, rule, metric, ends, n, options)
    }

    fn constants<const D: usize>(&self, metric: &impl Bounded<D>) -> Constants {
        let genuine = Library.constants(metric);
        match self {
            Some(Mutant::LipschitzTooSmall) => mutations::with_l_h(genuine, 0.9),
            Some(Mutant::LipschitzDoubled) => mutations::with_l_h(genuine, 2.0),
            _ => genuine,
        }
    }

    fn k1_g(&self, setting: Setting) -> f64 {
        let constants = setting.constants();
        match self {
            Some(Mutant::ConstantsExchanged) => setting.distance() / constants.c2().sqrt(),
            Some(Mutant::RootOfC1Forgotten) => setting.distance() / constants.c1(),
            _ => Library.k1_g(setting),
        }
    }

    fn k2_g(&self, setting: Setting) -> f64 {
        let (genuine, dimension) = (Library.k2_g(setting), setting.dimension() as f64);
        match self {
            Some(Mutant::DimensionForgotten) => genuine / dimension / dimension,
            Some(Mutant::DimensionOnce) => genuine / dimension,
            _ => genuine,
        }
    }

    fn c_tra(&self, constants: Constants, k1: f64, k2: f64, n: NonZeroUsize) -> f64 {
        let (genuine, count) = (Library.c_tra(constants, k1, k2, n), n.get() as f64);
        match self {
            Some(Mutant::CrossTermLost) => genuine - 4.0 * constants.c2() * k1 * k2 / count,
            Some(Mutant::SecondOrderForgotten) => Library.c_tra_sharp(constants, k1, k2) / count,
            _ => genuine,
        }
    }

    fn c_tra_sharp(&self, constants: Constants, k1: f64, k2: f64) -> f64 {
        let genuine = Library.c_tra_sharp(constants, k1, k2);
        match self {
            Some(Mutant::PowerOfK1Lost) => genuine + constants.l_h() * (k1.powi(2) - k1.powi(3)),
            Some(Mutant::CrossTermLost) => genuine - 4.0 * constants.c2() * k1 * k2,
            _ => genuine,
        }
    }

    fn k3_bar_g(&self, setting: Setting) -> f64 {
        let genuine = Library.k3_bar_g(setting);
        match self {
            Some(Mutant::DistanceForgotten) => {
                (genuine.powi(2) - Library.k1_g(setting).powi(2)).max(0.0).sqrt()
            }
            _ => genuine,
        }
    }

    fn k4_bar_g(&self, setting: Setting) -> f64 {
        match self {
            Some(Mutant::K4IsK3) => Library.k3_bar_g(setting),
            _ => Library.k4_bar_g(setting),
        }
    }

    fn polyline_gap_trapezoidal(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        let genuine = Library.polyline_gap_trapezoidal(constants, k3, n);
        match self {
            Some(Mutant::QuarterLost) => 4.0 * genuine,
            Some(Mutant::PowerOfK3Lost) => genuine / k3,
            Some(Mutant::RootOfNForgotten) => genuine / (n.get() as f64).sqrt(),
            _ => genuine,
        }
    }

    fn rule_gap(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        let genuine = Library.rule_gap(constants, k3, n);
        if *self == Some(Mutant::HalfOfRuleGap) { 0.5 * genuine } else { genuine }
    }

    fn polyline_gap_left(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        let genuine = Library.polyline_gap_left(constants, k3, n);
        if *self == Some(Mutant::HalfOfLeftGap) { 0.5 * genuine } else { genuine }
    }

    fn theorem_1_1_constant(&self, setting: Setting) -> f64 {
        let genuine = Library.theorem_1_1_constant(setting);
        match self {
            Some(Mutant::SharpForgotten) => {
                let constants = setting.constants();
                let (k1, k2) = (Library.k1_g(setting), Library.k2_g(setting));
                genuine - Library.c_tra_sharp(constants, k1, k2)
            }
            _ => genuine,
        }
    }

    fn theorem_1_3_constant(&self, setting: Setting) -> f64 {
        let genuine = Library.theorem_1_3_constant(setting);
        match self {
            Some(Mutant::LastCubeForgotten) => {
                let cube = Library.k4_bar_g(setting).powi(3);
                (genuine - 0.5 * setting.constants().l_h() * cube).max(0.0)
            }
            _ => genuine,
        }
    }

    fn k2_sharp(&self, setting: Setting) -> f64 {
        sharper::k2_sharp(*self, setting)
    }

    fn cubic_gap(&self, constants: Constants, rule: PaperRule, cube: f64, n: NonZeroUsize) -> f64 {
        sharper::cubic_gap(*self, constants, rule, cube, n)
    }

    fn quartic_gap(&self, constants: Constants, fourth: f64, n: NonZeroUsize) -> Option<f64> {
        sharper::quartic_gap(*self, constants, fourth, n)
    }

    fn greatest_speed(&self, constants: Constants, energy: f64, rho: f64, n: NonZeroUsize) -> f64 {
        sharper::greatest_speed(*self, constants, energy, rho, n)
    }

    fn greatest_difference(&self, constants: Constants, k3: f64, rho: f64) -> f64 {
        sharper::greatest_difference(*self, constants, k3, rho)
    }

    fn difference_step(&self, constants: Constants, greatest: f64, n: NonZeroUsize) -> f64 {
        let genuine = Library.difference_step(constants, greatest, n);
        if *self == Some(Mutant::StepHalved) { 0.5 * genuine } else { genuine }
    }

    fn squared_length(
        &self,
        constants: Constants,
        rule: PaperRule,
        e: f64,
        n: NonZeroUsize,
    ) -> f64 {
        sharper::squared_length(*self, constants, rule, e, n)
    }

    fn spread(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize, surplus: f64) -> Spread {
        sharper::spread(*self, setting, rule, n, surplus)
    }

    fn sharp_spread(&self, setting: Setting, n: NonZeroUsize, surplus: f64) -> Option<Spread> {
        sharper::sharp_spread(*self, setting, n, surplus)
    }

    fn theorem_a_minimum_gap(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        theorems::theorem_a_minimum_gap(*self, setting, rule, n)
    }

    fn theorem_a_polyline_gap(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        theorems::theorem_a_polyline_gap(*self, setting, rule, n)
    }

    fn theorem_b_minimum_gap(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        theorems::theorem_b_minimum_gap(*self, setting, n)
    }

    fn theorem_b_polyline_gap(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        theorems::theorem_b_polyline_gap(*self, setting, n)
    }

    fn theorem_c_deficit(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        theorems::theorem_c_deficit(*self, setting, rule, n)
    }

    fn theorem_c_polyline_gap(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        theorems::theorem_c_polyline_gap(*self, setting, rule, n)
    }

    fn theorem_c_length_excess(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        theorems::theorem_c_length_excess(*self, setting, rule, n)
    }

    fn theorem_d_minimum_gap(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        theorems::theorem_d_minimum_gap(*self, setting, n)
    }

    fn theorem_d_polyline_gap(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        theorems::theorem_d_polyline_gap(*self, setting, n)
    }

    fn theorem_d_length_excess(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        theorems::theorem_d_length_excess(*self, setting, n)
    }

    fn theorem_d_deficit(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        let genuine = Library.theorem_d_deficit(setting, n);
        let half = *self == Some(Mutant::DeficitOfTheoremDHalved);
        if half { genuine.map(|lost| 0.5 * lost) } else { genuine }
    }

    fn least_length_excess(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> Bound {
        theorems::least_length_excess(*self, setting, rule, n)
    }

    fn enclose(
        &self,
        constants: Constants,
        dimension: usize,
        computed: &Computed,
    ) -> Result<Enclosure, BoundError> {
        enclosures::enclose(*self, constants, dimension, computed)
    }

    fn convexity_modulus(
        &self,
        constants: Constants,
        rule: PaperRule,
        greatest: f64,
        n: NonZeroUsize,
    ) -> Option<f64> {
        enclosures::convexity_modulus(*self, constants, rule, greatest, n)
    }

    fn strict_convexity(
        &self,
        constants: Constants,
        dimension: usize,
        computed: &BetweenPoints,
    ) -> Option<f64> {
        enclosures::strict_convexity(*self, constants, dimension, computed)
    }

    fn competitors<E>(
        &self,
        dimension: usize,
        rule: PaperRule,
        n: NonZeroUsize,
        upper: f64,
        within: impl FnMut(f64) -> Result<Constants, E>,
    ) -> Result<Region, LocalityError<E>> {
        let genuine = Library.competitors(dimension, rule, n, upper, within)?;
        Ok(enclosures::region(*self, genuine))
    }
}
