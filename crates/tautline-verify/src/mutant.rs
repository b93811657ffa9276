//! `Mutant`: the library with one deliberate mistake.

use std::num::NonZeroUsize;

use nalgebra::{SMatrix, SVector};
use tautline::{
    Bounded, ClosedSet, Constants, Curvature, Ends, Integral, LeftEndpoint, Metric, MetricError,
    Minimum, Options, PointSequence, Rule, SolveError, Starts, Stop, Trapezoidal, TrueTrapezoid,
    bounds::Setting,
};

use crate::{Library, Subject, mutations};

/// A deliberately wrong variant of the library: a suite of tests that lets one pass is not worth
/// its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mutant {
    /// The two rules are exchanged, in energies, gradients and solver.
    RulesExchanged,
    /// The trapezoidal rule takes the mean of `H` at both ends.
    TrueTrapezoid,
    /// A factor ½ in the discrete energy.
    EnergyHalved,
    /// The discrete energy leaves out the last chord.
    LastChordLost,
    /// The discrete length is taken without its square root.
    RootLost,
    /// `E(γᵖˡ)` by one node a chord.
    QuadratureOfOneNode,
    /// `E(γᵖˡ)` by the ends of each chord.
    QuadratureByEnds,
    /// `L(γᵖˡ)` is taken for `E(γᵖˡ)^{1/2}`.
    LengthFromEnergy,
    /// `K₃` without the mean over the chords.
    MeanForgotten,
    /// The gradient with the wrong sign.
    GradientReversed,
    /// The gradient without the derivative of `H`.
    MetricFrozen,
    /// Christoffel symbols with a sign exchanged in the last term.
    ChristoffelSign,
    /// Christoffel symbols without the factor ½.
    ChristoffelDoubled,
    /// The nearest-point map leaves points where they are.
    NotProjected,
    /// The solver lets the first point out of its set by a millionth.
    EndRelaxed,
    /// The solver stops after one step and says that it converged.
    StopsEarly,
    /// The solver returns the straight line and says that it converged.
    NotOptimised,
    /// The solver returns the interpolation of a minimiser of half as many chords.
    NotRefined,
    /// The solver returns the local minimum nearest to the straight line.
    LocalForGlobal,
    /// `L_H` is claimed 10 % too small.
    LipschitzTooSmall,
    /// `L_H` is claimed twice too large: nothing is wrong then, but the bounds are loosened.
    LipschitzDoubled,
    /// `c₁` and `c₂` are exchanged in `K_{1,g}`.
    ConstantsExchanged,
    /// `K_{1,g} = d/c₁`, without the root.
    RootOfC1Forgotten,
    /// `K_{2,g}` without `D²`.
    DimensionForgotten,
    /// `K_{2,g}` with `D` for `D²`.
    DimensionOnce,
    /// `C_tra(N)` without its cross term.
    CrossTermLost,
    /// `C_tra(N)` with `1/N` for `1/N²`.
    SecondOrderForgotten,
    /// `C_tra♯` with `K₁²` for `K₁³`.
    PowerOfK1Lost,
    /// `K̄_{3,g}` without the distance.
    DistanceForgotten,
    /// `K̄_{4,g}` is taken for `K̄_{3,g}`.
    K4IsK3,
    /// Proposition 7.9 without the factor ¼.
    QuarterLost,
    /// Proposition 7.9 with `K₃²` for `K₃³`.
    PowerOfK3Lost,
    /// Proposition 7.9 with `1/N` for `1/√N`: true of equal speeds only.
    RootOfNForgotten,
    /// Proposition 8.1 with the factor ¼ for ½.
    HalfOfRuleGap,
    /// Proposition 8.2 with the factor ¼ for ½.
    HalfOfLeftGap,
    /// The `C` of Theorem 1.1 without `C_tra♯`.
    SharpForgotten,
    /// The `C` of Theorem 1.3 without the cube of `K̄_{4,g}`.
    LastCubeForgotten,
}

impl Mutant {
    /// All of them: discretizations, sets, solver, constants, bounds.
    pub const ALL: [Mutant; 37] = [
        Mutant::RulesExchanged,
        Mutant::TrueTrapezoid,
        Mutant::EnergyHalved,
        Mutant::LastChordLost,
        Mutant::RootLost,
        Mutant::QuadratureOfOneNode,
        Mutant::QuadratureByEnds,
        Mutant::LengthFromEnergy,
        Mutant::MeanForgotten,
        Mutant::GradientReversed,
        Mutant::MetricFrozen,
        Mutant::ChristoffelSign,
        Mutant::ChristoffelDoubled,
        Mutant::NotProjected,
        Mutant::EndRelaxed,
        Mutant::StopsEarly,
        Mutant::NotOptimised,
        Mutant::NotRefined,
        Mutant::LocalForGlobal,
        Mutant::LipschitzTooSmall,
        Mutant::LipschitzDoubled,
        Mutant::ConstantsExchanged,
        Mutant::RootOfC1Forgotten,
        Mutant::DimensionForgotten,
        Mutant::DimensionOnce,
        Mutant::CrossTermLost,
        Mutant::SecondOrderForgotten,
        Mutant::PowerOfK1Lost,
        Mutant::DistanceForgotten,
        Mutant::K4IsK3,
        Mutant::QuarterLost,
        Mutant::PowerOfK3Lost,
        Mutant::RootOfNForgotten,
        Mutant::HalfOfRuleGap,
        Mutant::HalfOfLeftGap,
        Mutant::SharpForgotten,
        Mutant::LastCubeForgotten,
    ];

    /// Returns what is wrong with it, in a few words.
    #[must_use]
    pub fn mistake(self) -> &'static str {
        match self {
            Mutant::RulesExchanged => "the two rules exchanged",
            Mutant::TrueTrapezoid => "H averaged over the ends of a chord",
            Mutant::EnergyHalved => "a factor 1/2 in the discrete energy",
            Mutant::LastChordLost => "the last chord left out",
            Mutant::RootLost => "no square root in the discrete length",
            Mutant::QuadratureOfOneNode => "one node a chord in E(γᵖˡ)",
            Mutant::QuadratureByEnds => "the ends of a chord in E(γᵖˡ)",
            Mutant::LengthFromEnergy => "L(γᵖˡ) = √E(γᵖˡ)",
            Mutant::MeanForgotten => "K₃ without the mean",
            Mutant::GradientReversed => "the gradient reversed",
            Mutant::MetricFrozen => "the gradient without DH",
            Mutant::ChristoffelSign => "a wrong sign in Γ",
            Mutant::ChristoffelDoubled => "no factor 1/2 in Γ",
            Mutant::NotProjected => "points not projected",
            Mutant::EndRelaxed => "an end point 10⁻⁶ off its set",
            Mutant::StopsEarly => "one Newton step",
            Mutant::NotOptimised => "the straight line for a minimiser",
            Mutant::NotRefined => "the minimiser of half as many chords",
            Mutant::LocalForGlobal => "a local minimum for the global one",
            Mutant::LipschitzTooSmall => "L_H 10 % too small",
            Mutant::LipschitzDoubled => "L_H twice too large",
            Mutant::ConstantsExchanged => "c₁ and c₂ exchanged in K_{1,g}",
            Mutant::RootOfC1Forgotten => "K_{1,g} = d/c₁",
            Mutant::DimensionForgotten => "K_{2,g} without D²",
            Mutant::DimensionOnce => "K_{2,g} with D for D²",
            Mutant::CrossTermLost => "C_tra(N) without 4c₂K₁K₂/N",
            Mutant::SecondOrderForgotten => "C_tra(N) with 4c₂K₂²/N",
            Mutant::PowerOfK1Lost => "C_tra♯ with K₁² for K₁³",
            Mutant::DistanceForgotten => "K̄_{3,g} without d",
            Mutant::K4IsK3 => "K̄_{4,g} = K̄_{3,g}",
            Mutant::QuarterLost => "7.9 without the factor 1/4",
            Mutant::PowerOfK3Lost => "7.9 with K₃² for K₃³",
            Mutant::RootOfNForgotten => "7.9 with N for √N",
            Mutant::HalfOfRuleGap => "8.1 with 1/4 for 1/2",
            Mutant::HalfOfLeftGap => "8.2 with 1/4 for 1/2",
            Mutant::SharpForgotten => "C of Theorem 1.1 without C_tra♯",
            Mutant::LastCubeForgotten => "C of Theorem 1.3 without K̄_{4,g}³",
        }
    }
}

/// Whether `R` reads the metric as the trapezoidal rule of the paper does.
fn is_trapezoidal<R: Rule>() -> bool {
    R::NODES == Trapezoidal::NODES
}

impl Subject for Mutant {
    fn discrete_energy<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        let genuine = Library.discrete_energy(rule, metric, sequence);
        match self {
            Mutant::RulesExchanged if is_trapezoidal::<R>() => {
                LeftEndpoint.energy(metric, sequence)
            }
            Mutant::RulesExchanged => Trapezoidal.energy(metric, sequence),
            Mutant::TrueTrapezoid if is_trapezoidal::<R>() => {
                TrueTrapezoid.energy(metric, sequence)
            }
            Mutant::EnergyHalved => 0.5 * genuine,
            Mutant::LastChordLost => mutations::without_last_chord(rule, metric, sequence),
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
            Mutant::RootLost => rule.energy(metric, sequence) / sequence.n().get() as f64,
            Mutant::RulesExchanged if is_trapezoidal::<R>() => {
                LeftEndpoint.length(metric, sequence)
            }
            Mutant::RulesExchanged => Trapezoidal.length(metric, sequence),
            Mutant::TrueTrapezoid if is_trapezoidal::<R>() => {
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
            Mutant::RulesExchanged if is_trapezoidal::<R>() => {
                Library.energy_gradient(LeftEndpoint, metric, sequence)
            }
            Mutant::RulesExchanged => Library.energy_gradient(Trapezoidal, metric, sequence),
            Mutant::GradientReversed => {
                let gradient = Library.energy_gradient(rule, metric, sequence);
                gradient.into_iter().map(|slope| -slope).collect()
            }
            Mutant::MetricFrozen => mutations::frozen_gradient(rule, metric, sequence),
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
            Mutant::QuadratureOfOneNode => exact(Trapezoidal.energy(metric, sequence)),
            Mutant::QuadratureByEnds => exact(TrueTrapezoid.energy(metric, sequence)),
            _ => Library.curve_energy(metric, sequence),
        }
    }

    fn curve_length<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        match self {
            Mutant::LengthFromEnergy => {
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
            Mutant::MeanForgotten => genuine * (sequence.n().get() as f64).sqrt(),
            _ => genuine,
        }
    }

    fn christoffel<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
    ) -> Result<[SMatrix<f64, D, D>; D], MetricError> {
        match self {
            Mutant::ChristoffelSign => mutations::christoffel_with_wrong_sign(metric, x),
            Mutant::ChristoffelDoubled => {
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
            Mutant::NotProjected => *x,
            _ => Library.project(set, x),
        }
    }

    fn minimise<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        ends: &Ends<D>,
        n: usize,
    ) -> Result<Minimum<D>, SolveError> {
        let believed = |mut minimum: Minimum<D>| {
            (minimum.stop, minimum.curvature) = (Stop::Converged, Curvature::PositiveDefinite);
            minimum
        };
        let with = |starts, iterations| {
            let options = Options { starts, iterations };
            tautline::minimise(metric, ends, rule, n, &options).map(believed)
        };
        match self {
            Mutant::RulesExchanged if is_trapezoidal::<R>() => {
                Library.minimise(LeftEndpoint, metric, ends, n)
            }
            Mutant::RulesExchanged => Library.minimise(Trapezoidal, metric, ends, n),
            Mutant::TrueTrapezoid if is_trapezoidal::<R>() => {
                Library.minimise(TrueTrapezoid, metric, ends, n)
            }
            Mutant::StopsEarly => with(Starts::Automatic, 1),
            Mutant::NotOptimised => {
                let mut minimum = believed(Library.minimise(rule, metric, ends, n)?);
                minimum.sequence = mutations::straightened(&minimum.sequence);
                minimum.energy = rule.energy(metric, &minimum.sequence);
                Ok(minimum)
            }
            Mutant::NotRefined => {
                let mut minimum = Library.minimise(rule, metric, ends, n.div_ceil(2))?;
                minimum.sequence = mutations::resampled(&minimum.sequence, n);
                minimum.energy = rule.energy(metric, &minimum.sequence);
                Ok(minimum)
            }
            Mutant::LocalForGlobal => {
                let line = Library.minimise(rule, metric, ends, n)?.sequence;
                with(Starts::Only(vec![mutations::straightened(&line)]), 200)
            }
            Mutant::EndRelaxed => {
                let mut minimum = Library.minimise(rule, metric, ends, n)?;
                minimum.sequence = mutations::first_point_moved(&minimum.sequence, 1e-6);
                Ok(minimum)
            }
            _ => Library.minimise(rule, metric, ends, n),
        }
    }

    fn constants<const D: usize>(&self, metric: &impl Bounded<D>) -> Constants {
        let genuine = Library.constants(metric);
        match self {
            Mutant::LipschitzTooSmall => mutations::with_l_h(genuine, 0.9),
            Mutant::LipschitzDoubled => mutations::with_l_h(genuine, 2.0),
            _ => genuine,
        }
    }

    fn k1_g(&self, setting: Setting) -> f64 {
        let constants = setting.constants();
        match self {
            Mutant::ConstantsExchanged => setting.distance() / constants.c2().sqrt(),
            Mutant::RootOfC1Forgotten => setting.distance() / constants.c1(),
            _ => Library.k1_g(setting),
        }
    }

    fn k2_g(&self, setting: Setting) -> f64 {
        let (genuine, dimension) = (Library.k2_g(setting), setting.dimension() as f64);
        match self {
            Mutant::DimensionForgotten => genuine / dimension / dimension,
            Mutant::DimensionOnce => genuine / dimension,
            _ => genuine,
        }
    }

    fn c_tra(&self, constants: Constants, k1: f64, k2: f64, n: NonZeroUsize) -> f64 {
        let (genuine, count) = (Library.c_tra(constants, k1, k2, n), n.get() as f64);
        match self {
            Mutant::CrossTermLost => genuine - 4.0 * constants.c2() * k1 * k2 / count,
            Mutant::SecondOrderForgotten => Library.c_tra_sharp(constants, k1, k2) / count,
            _ => genuine,
        }
    }

    fn c_tra_sharp(&self, constants: Constants, k1: f64, k2: f64) -> f64 {
        let genuine = Library.c_tra_sharp(constants, k1, k2);
        match self {
            Mutant::PowerOfK1Lost => genuine + constants.l_h() * (k1.powi(2) - k1.powi(3)),
            Mutant::CrossTermLost => genuine - 4.0 * constants.c2() * k1 * k2,
            _ => genuine,
        }
    }

    fn k3_bar_g(&self, setting: Setting) -> f64 {
        let genuine = Library.k3_bar_g(setting);
        match self {
            Mutant::DistanceForgotten => {
                (genuine.powi(2) - Library.k1_g(setting).powi(2)).max(0.0).sqrt()
            }
            _ => genuine,
        }
    }

    fn k4_bar_g(&self, setting: Setting) -> f64 {
        match self {
            Mutant::K4IsK3 => Library.k3_bar_g(setting),
            _ => Library.k4_bar_g(setting),
        }
    }

    fn polyline_gap_trapezoidal(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        let genuine = Library.polyline_gap_trapezoidal(constants, k3, n);
        match self {
            Mutant::QuarterLost => 4.0 * genuine,
            Mutant::PowerOfK3Lost => genuine / k3,
            Mutant::RootOfNForgotten => genuine / (n.get() as f64).sqrt(),
            _ => genuine,
        }
    }

    fn rule_gap(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        let genuine = Library.rule_gap(constants, k3, n);
        if *self == Mutant::HalfOfRuleGap { 0.5 * genuine } else { genuine }
    }

    fn polyline_gap_left(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        let genuine = Library.polyline_gap_left(constants, k3, n);
        if *self == Mutant::HalfOfLeftGap { 0.5 * genuine } else { genuine }
    }

    fn theorem_1_1_constant(&self, setting: Setting) -> f64 {
        let genuine = Library.theorem_1_1_constant(setting);
        match self {
            Mutant::SharpForgotten => {
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
            Mutant::LastCubeForgotten => {
                let cube = Library.k4_bar_g(setting).powi(3);
                (genuine - 0.5 * setting.constants().l_h() * cube).max(0.0)
            }
            _ => genuine,
        }
    }
}
