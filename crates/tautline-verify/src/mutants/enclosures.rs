//! The mistakes of the mutants in Propositions S.6 to S.8.

use std::{f64::consts::FRAC_PI_2, num::NonZeroUsize};

use tautline::{
    Constants,
    bounds::{BetweenPoints, BoundError, Computed, Enclosure, PaperRule, Region},
};

use super::{Mutant, mutations};
use crate::{Library, Subject};

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
    Library.convexity_modulus(believed(mutant, constants), rule, greatest, n)
}

pub(super) fn strict_convexity(
    mutant: Option<Mutant>,
    constants: Constants,
    dimension: usize,
    computed: &BetweenPoints,
) -> Option<f64> {
    let genuine = Library.strict_convexity(believed(mutant, constants), dimension, computed);
    let &BetweenPoints { rule, n, discrete_energy, residual, greatest_difference, .. } = computed;
    let count = n.get() as f64;
    let wave = count * (FRAC_PI_2 / count).sin();
    match mutant {
        Some(Mutant::CompetitorsForgotten) => {
            let modulus = Library.convexity_modulus(constants, rule, greatest_difference, n)?;
            let left = (residual / wave).powi(2) / (4.0 * modulus);
            (modulus > 0.0).then_some(discrete_energy - left)
        }
        Some(Mutant::PoincareOfCurves) => {
            let left = discrete_energy - genuine?;
            Some(discrete_energy - left * (wave / FRAC_PI_2).powi(2))
        }
        _ => genuine,
    }
}

pub(super) fn region(mutant: Option<Mutant>, genuine: Region) -> Region {
    let constants = genuine.constants;
    match mutant {
        Some(Mutant::RegionOfC2) => {
            Region { radius: genuine.radius * (constants.c1() / constants.c2()).sqrt(), ..genuine }
        }
        _ => genuine,
    }
}

/// The constants of which convexity knows.
fn believed(mutant: Option<Mutant>, constants: Constants) -> Constants {
    match mutant {
        Some(Mutant::SlopeForgotten) => mutations::with_l_h(constants, 0.0),
        Some(Mutant::CurvatureOfConvexityForgotten) => {
            constants.times([1.0, 1.0, 1.0, 0.0]).expect("a multiple of a finite constant")
        }
        _ => constants,
    }
}
