//! Mistakes in Lemmas S.1, S.2, S.3 and S.5.

use std::num::NonZeroUsize;

use tautline::bounds::{self, PaperRule, Spread};

use super::Mutant;
use crate::replaceable::Bounds;

/// Applies a mistake to both spreads. It is a macro, since a function in the table cannot capture.
macro_rules! replace_moments {
    ($table:ident, $mistake:path) => {{
        $table.spread = |setting, rule, n, surplus| {
            $mistake(Spread::of_first_order(setting, rule, n, surplus), n, surplus)
        };
        $table.sharp_spread = |setting, n, surplus| {
            Some($mistake(Spread::of_second_order(setting, n, surplus)?, n, surplus))
        };
    }};
}

pub(super) fn replace(mutant: Mutant, table: &mut Bounds) {
    match mutant {
        Mutant::OmegaHalved => {
            table.k2_sharp = |setting| bounds::k2_sharp(setting) * 0.5 / setting.omega();
        }
        Mutant::LeftCubeHalved => {
            table.cubic_gap = |constants, _, cube, n| {
                bounds::cubic_gap(constants, PaperRule::Trapezoidal, cube, n)
            };
        }
        Mutant::CurvatureGapHalved => {
            table.quartic_gap = |constants, fourth, n| {
                bounds::quartic_gap(constants, fourth, n).map(|gap| 0.5 * gap)
            };
        }
        Mutant::ResidualForgotten => {
            table.greatest_speed =
                |constants, energy, _, n| bounds::greatest_speed(constants, energy, 0.0, n);
        }
        Mutant::SpeedChangeForgotten => {
            table.greatest_speed =
                |constants, energy, rho, _| energy.sqrt() + rho / constants.c1().sqrt();
        }
        Mutant::MomentumGrowthHalved => {
            table.greatest_difference = |constants, k3, rho| {
                let lost = 0.25 * constants.l_h() * k3 * k3 / constants.c1();
                bounds::greatest_difference(constants, k3, rho) - lost
            };
        }
        Mutant::StepHalved => {
            table.difference_step =
                |constants, greatest, n| 0.5 * bounds::difference_step(constants, greatest, n);
        }
        Mutant::LengthGapHalved => {
            table.squared_length =
                |constants, rule, e, n| 0.5 * (bounds::squared_length(constants, rule, e, n) + e);
        }
        Mutant::VarianceHalved => replace_moments!(table, half_the_variance),
        Mutant::SkewnessForgotten => replace_moments!(table, without_skewness),
        Mutant::KurtosisForgotten => replace_moments!(table, without_kurtosis),
        _ => {}
    }
}

fn half_the_variance(genuine: Spread, _: NonZeroUsize, _: f64) -> Spread {
    Spread { variance: 0.5 * genuine.variance, ..genuine }
}

fn without_skewness(genuine: Spread, _: NonZeroUsize, surplus: f64) -> Spread {
    let e = 1.0 + surplus;
    let cube = e.powf(1.5) + 1.5 * e.sqrt() * genuine.variance;
    Spread { cube: cube.min(genuine.cube), ..genuine }
}

fn without_kurtosis(genuine: Spread, n: NonZeroUsize, surplus: f64) -> Spread {
    let Spread { variance, deviation, .. } = genuine;
    let (e, count) = (1.0 + surplus, n.get() as f64);
    let fourth = e * e + 4.0 * e * variance + 4.0 * e.sqrt() * deviation * variance;
    Spread { fourth: fourth.min(count * e * e), ..genuine }
}
