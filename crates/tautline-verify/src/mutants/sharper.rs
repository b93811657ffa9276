//! The mistakes of the mutants in the sharper bounds.

use std::num::NonZeroUsize;

use tautline::{
    Constants,
    bounds::{BoundError, Computed, Enclosure, PaperRule, Setting, Spread},
};

use super::{Mutant, mutations};
use crate::{Library, Subject};

pub(super) fn k2_sharp(mutant: Option<Mutant>, setting: Setting) -> f64 {
    let genuine = Library.k2_sharp(setting);
    match mutant {
        Some(Mutant::OmegaHalved) => genuine * 0.5 / setting.omega(),
        _ => genuine,
    }
}

pub(super) fn cubic_gap(
    mutant: Option<Mutant>,
    constants: Constants,
    rule: PaperRule,
    cube: f64,
    n: NonZeroUsize,
) -> f64 {
    let rule = match mutant {
        Some(Mutant::LeftCubeHalved) => PaperRule::Trapezoidal,
        _ => rule,
    };
    Library.cubic_gap(constants, rule, cube, n)
}

pub(super) fn quartic_gap(
    mutant: Option<Mutant>,
    constants: Constants,
    fourth: f64,
    n: NonZeroUsize,
) -> Option<f64> {
    let genuine = Library.quartic_gap(constants, fourth, n);
    match mutant {
        Some(Mutant::CurvatureGapHalved) => genuine.map(|gap| 0.5 * gap),
        _ => genuine,
    }
}

pub(super) fn greatest_speed(
    mutant: Option<Mutant>,
    constants: Constants,
    energy: f64,
    rho: f64,
    n: NonZeroUsize,
) -> f64 {
    match mutant {
        Some(Mutant::ResidualForgotten) => Library.greatest_speed(constants, energy, 0.0, n),
        Some(Mutant::SpeedChangeForgotten) => energy.sqrt() + rho / constants.c1().sqrt(),
        _ => Library.greatest_speed(constants, energy, rho, n),
    }
}

pub(super) fn squared_length(
    mutant: Option<Mutant>,
    constants: Constants,
    rule: PaperRule,
    e: f64,
    n: NonZeroUsize,
) -> f64 {
    let genuine = Library.squared_length(constants, rule, e, n);
    match mutant {
        Some(Mutant::LengthGapHalved) => 0.5 * (genuine + e),
        _ => genuine,
    }
}

pub(super) fn spread(
    mutant: Option<Mutant>,
    setting: Setting,
    rule: PaperRule,
    n: NonZeroUsize,
    surplus: f64,
) -> Spread {
    let genuine = Library.spread(setting, rule, n, surplus);
    match mutant {
        Some(Mutant::VarianceHalved) => Spread { variance: 0.5 * genuine.variance, ..genuine },
        _ => genuine,
    }
}

pub(super) fn theorem_a_minimum_gap(
    mutant: Option<Mutant>,
    setting: Setting,
    rule: PaperRule,
    n: NonZeroUsize,
) -> f64 {
    let genuine = Library.theorem_a_minimum_gap(setting, rule, n);
    match (mutant, rule) {
        (Some(Mutant::LeftCeilingHalved), PaperRule::LeftEndpoint) => 0.5 * genuine,
        _ => genuine,
    }
}

pub(super) fn theorem_a_polyline_gap(
    mutant: Option<Mutant>,
    setting: Setting,
    rule: PaperRule,
    n: NonZeroUsize,
) -> f64 {
    match mutant {
        Some(Mutant::SpeedsOfTheoremAEqual) => {
            mutations::theorem_a_gap_of_equal_speeds(setting, rule, n)
        }
        _ => Library.theorem_a_polyline_gap(setting, rule, n),
    }
}

pub(super) fn theorem_c_deficit(
    mutant: Option<Mutant>,
    setting: Setting,
    rule: PaperRule,
    n: NonZeroUsize,
) -> f64 {
    let genuine = Library.theorem_c_deficit(setting, rule, n);
    match mutant {
        Some(Mutant::DeficitHalved) => 0.5 * genuine,
        _ => genuine,
    }
}

pub(super) fn theorem_d_minimum_gap(
    mutant: Option<Mutant>,
    setting: Setting,
    n: NonZeroUsize,
) -> Option<f64> {
    let genuine = Library.theorem_d_minimum_gap(setting, n)?;
    match mutant {
        Some(Mutant::SecondVariationHalved) => {
            let half = setting.bend().powi(2) / (24.0 * (n.get() as f64).powi(2));
            Some((genuine - setting.distance().powi(2) * half).max(0.5 * genuine))
        }
        _ => Some(genuine),
    }
}

pub(super) fn theorem_d_polyline_gap(
    mutant: Option<Mutant>,
    setting: Setting,
    n: NonZeroUsize,
) -> Option<f64> {
    let genuine = Library.theorem_d_polyline_gap(setting, n);
    match mutant {
        Some(Mutant::FourthPowerHalved) => genuine.map(|gap| 0.5 * gap),
        _ => genuine,
    }
}

pub(super) fn enclose(
    mutant: Option<Mutant>,
    constants: Constants,
    dimension: usize,
    computed: &Computed,
) -> Result<Enclosure, BoundError> {
    let genuine = Library.enclose(constants, dimension, computed)?;
    Ok(match mutant {
        Some(Mutant::CeilingForgotten) if genuine.assumes_global_minimum => {
            Enclosure { lower: computed.discrete_energy, ..genuine }
        }
        _ => genuine,
    })
}

pub(super) fn convexity_modulus(
    mutant: Option<Mutant>,
    constants: Constants,
    rule: PaperRule,
    greatest: f64,
    n: NonZeroUsize,
) -> Option<f64> {
    let constants = match mutant {
        Some(Mutant::SlopeForgotten) => mutations::with_l_h(constants, 0.0),
        _ => constants,
    };
    Library.convexity_modulus(constants, rule, greatest, n)
}
