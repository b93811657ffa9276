//! Mutants: deliberately wrong variants of the library, to which the suite is put.

mod enclosures;
mod formula;
mod mutant;
mod paper;
pub(crate) mod programs;
mod sharper;
pub(crate) mod solver;
mod theorems;

use tautline::Constants;

pub use mutant::Mutant;

use crate::subject::{Bounds, GENUINE, Program};

impl Mutant {
    /// Returns the bounds and constants with its mistake, if it is one of theirs.
    pub(crate) fn bounds(self) -> Bounds {
        let mut bounds = GENUINE;
        paper::replace(self, &mut bounds);
        sharper::replace(self, &mut bounds);
        theorems::replace(self, &mut bounds);
        enclosures::replace(self, &mut bounds);
        bounds
    }

    /// Returns the programs in which it is wrong; the others are the library's.
    pub(crate) const fn programs(self) -> &'static [Program] {
        match self {
            Mutant::RulesExchanged => &[
                Program::DiscreteEnergy,
                Program::DiscreteLength,
                Program::EnergyGradient,
                Program::Minimise,
            ],
            Mutant::TrueTrapezoid => {
                &[Program::DiscreteEnergy, Program::DiscreteLength, Program::Minimise]
            }
            Mutant::EnergyHalved | Mutant::LastChordLost => &[Program::DiscreteEnergy],
            Mutant::RootLost => &[Program::DiscreteLength],
            Mutant::QuadratureOfOneNode | Mutant::QuadratureByEnds => &[Program::CurveEnergy],
            Mutant::LengthFromEnergy => &[Program::CurveLength],
            Mutant::MeanForgotten => &[Program::K3],
            Mutant::GradientReversed | Mutant::MetricFrozen => &[Program::EnergyGradient],
            Mutant::ChristoffelSign | Mutant::ChristoffelDoubled => &[Program::Christoffel],
            Mutant::NotProjected => &[Program::Project],
            Mutant::EndRelaxed
            | Mutant::StopsEarly
            | Mutant::NotOptimised
            | Mutant::NotRefined
            | Mutant::LocalForGlobal
            | Mutant::OperandsSwapped
            | Mutant::ConstantsMerged
            | Mutant::ConstantsShortened
            | Mutant::SineForCosine
            | Mutant::PowerOfStepLost
            | Mutant::StepBesideRead
            | Mutant::EntryTakenForZero
            | Mutant::ProductRuleHalved
            | Mutant::LaneLost
            | Mutant::RegisterStale => &[Program::Minimise],
            Mutant::LipschitzTooSmall | Mutant::LipschitzDoubled => &[Program::Constants],
            Mutant::RegionOfC2 => &[Program::Competitors],
            _ => &[],
        }
    }
}

/// Constants with another `L_H`.
fn with_l_h(constants: Constants, factor: f64) -> Constants {
    constants.times([1.0, 1.0, factor, 1.0]).expect("a multiple of a finite constant")
}
