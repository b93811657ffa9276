//! Mistakes in Propositions S.6 to S.9.

use std::f64::consts::FRAC_PI_2;

use tautline::{
    Constants,
    bounds::{self, BetweenPoints, Enclosure, Setting},
};

use super::{Mutant, with_l_h};
use crate::replaceable::Bounds;

pub(super) fn replace(mutant: Mutant, table: &mut Bounds) {
    match mutant {
        Mutant::CeilingForgotten => {
            table.enclose = |constants, dimension, computed| {
                let genuine = bounds::enclose(constants, dimension, computed)?;
                let assumes = genuine.assumes_global_minimum;
                let lower = if assumes { computed.discrete_energy } else { genuine.lower };
                Ok(Enclosure { lower, ..genuine })
            };
        }
        Mutant::SlopeForgotten => {
            table.convexity_modulus = |constants, rule, greatest, n| {
                bounds::convexity_modulus(with_l_h(constants, 0.0), rule, greatest, n)
            };
            table.strict_convexity = |constants, dimension, computed| {
                bounds::strict_convexity(with_l_h(constants, 0.0), dimension, computed)
            };
        }
        Mutant::CurvatureOfConvexityForgotten => {
            table.convexity_modulus = |constants, rule, greatest, n| {
                bounds::convexity_modulus(without_m_h(constants), rule, greatest, n)
            };
            table.strict_convexity = |constants, dimension, computed| {
                bounds::strict_convexity(without_m_h(constants), dimension, computed)
            };
        }
        Mutant::CompetitorsForgotten => {
            table.strict_convexity = |constants, _, computed| {
                let &BetweenPoints { rule, n, greatest_difference, .. } = computed;
                let modulus = bounds::convexity_modulus(constants, rule, greatest_difference, n)?;
                let left = (computed.residual / wave(computed)).powi(2) / (4.0 * modulus);
                (modulus > 0.0).then_some(computed.discrete_energy - left)
            };
        }
        Mutant::PoincareOfCurves => {
            table.strict_convexity = |constants, dimension, computed| {
                let genuine = bounds::strict_convexity(constants, dimension, computed)?;
                let left = computed.discrete_energy - genuine;
                Some(computed.discrete_energy - left * (wave(computed) / FRAC_PI_2).powi(2))
            };
        }
        Mutant::GapOfConvexityForgotten => {
            table.convex_excess = |constants, dimension, computed| {
                let &BetweenPoints { rule, n, length, residual, .. } = computed;
                let sampled = sampled(constants, dimension, computed)?;
                let greatest = computed.greatest_difference.max(length / constants.c1().sqrt());
                let modulus = bounds::convexity_modulus(constants, rule, greatest, n)?;
                let left = (residual / wave(computed)).powi(2) / (4.0 * modulus);
                (modulus > 0.0).then_some(sampled + left)
            };
        }
        Mutant::ResidualOfConvexityForgotten => {
            table.convex_excess = |constants, dimension, computed| {
                let stationary = BetweenPoints { residual: 0.0, ..*computed };
                bounds::convex_excess(constants, dimension, &stationary)
            };
        }
        Mutant::SampledEnergyHalved => {
            table.convex_excess = |constants, dimension, computed| {
                let genuine = bounds::convex_excess(constants, dimension, computed)?;
                Some(genuine - 0.5 * sampled(constants, dimension, computed)?)
            };
        }
        Mutant::LengthOfC2 => {
            table.reach = |setting, rule, n| {
                let constants = setting.constants();
                bounds::reach(setting, rule, n) * (constants.c1() / constants.c2()).sqrt()
            };
        }
        _ => {}
    }
}

/// Returns the `P` of Proposition S.9.
fn sampled(constants: Constants, dimension: usize, computed: &BetweenPoints) -> Option<f64> {
    let setting = Setting::new(constants, computed.length, dimension).ok()?;
    bounds::sampled_excess(setting, computed.n)
}

/// Returns `N sin(π/2N)`.
fn wave(computed: &BetweenPoints) -> f64 {
    let count = computed.n.get() as f64;
    count * (FRAC_PI_2 / count).sin()
}

fn without_m_h(constants: Constants) -> Constants {
    constants.times([1.0, 1.0, 1.0, 0.0]).expect("a multiple of a finite constant")
}
