//! The mistakes of the mutants in Lemmas S.1, S.2, S.3 and S.5.

use std::num::NonZeroUsize;

use tautline::{
    Constants,
    bounds::{PaperRule, Setting, Spread},
};

use super::Mutant;
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

pub(super) fn greatest_difference(
    mutant: Option<Mutant>,
    constants: Constants,
    k3: f64,
    rho: f64,
) -> f64 {
    let genuine = Library.greatest_difference(constants, k3, rho);
    match mutant {
        Some(Mutant::MomentumGrowthHalved) => {
            genuine - 0.25 * constants.l_h() * k3 * k3 / constants.c1()
        }
        _ => genuine,
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
    moments(mutant, Library.spread(setting, rule, n, surplus), n, surplus)
}

pub(super) fn sharp_spread(
    mutant: Option<Mutant>,
    setting: Setting,
    n: NonZeroUsize,
    surplus: f64,
) -> Option<Spread> {
    Some(moments(mutant, Library.sharp_spread(setting, n, surplus)?, n, surplus))
}

/// The mistakes in the moments.
fn moments(mutant: Option<Mutant>, genuine: Spread, n: NonZeroUsize, surplus: f64) -> Spread {
    let Spread { variance, deviation, .. } = genuine;
    let (e, count) = (1.0 + surplus, n.get() as f64);
    match mutant {
        Some(Mutant::VarianceHalved) => Spread { variance: 0.5 * variance, ..genuine },
        Some(Mutant::SkewnessForgotten) => {
            let cube = e.powf(1.5) + 1.5 * e.sqrt() * variance;
            Spread { cube: cube.min(genuine.cube), ..genuine }
        }
        Some(Mutant::KurtosisForgotten) => {
            let fourth = e * e + 4.0 * e * variance + 4.0 * e.sqrt() * deviation * variance;
            Spread { fourth: fourth.min(count * e * e), ..genuine }
        }
        _ => genuine,
    }
}
