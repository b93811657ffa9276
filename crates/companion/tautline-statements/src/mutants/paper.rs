//! Mistakes in the bounds and constants of the paper.

use tautline::bounds;

use super::Mutant;
use crate::replaceable::Bounds;

pub(super) fn replace(mutant: Mutant, table: &mut Bounds) {
    match mutant {
        Mutant::ConstantsExchanged => {
            table.k1_g = |setting| setting.distance() / setting.constants().c2().sqrt();
        }
        Mutant::RootOfC1Forgotten => {
            table.k1_g = |setting| setting.distance() / setting.constants().c1();
        }
        Mutant::DimensionForgotten => {
            table.k2_g = |setting| bounds::k2_g(setting) / (setting.dimension() as f64).powi(2);
        }
        Mutant::DimensionOnce => {
            table.k2_g = |setting| bounds::k2_g(setting) / setting.dimension() as f64;
        }
        Mutant::CrossTermLost => {
            table.c_tra = |constants, k1, k2, n| {
                let lost = 4.0 * constants.c2() * k1 * k2 / n.get() as f64;
                bounds::c_tra(constants, k1, k2, n) - lost
            };
            table.c_tra_sharp = |constants, k1, k2| {
                bounds::c_tra_sharp(constants, k1, k2) - 4.0 * constants.c2() * k1 * k2
            };
        }
        Mutant::SecondOrderForgotten => {
            table.c_tra =
                |constants, k1, k2, n| bounds::c_tra_sharp(constants, k1, k2) / n.get() as f64;
        }
        Mutant::PowerOfK1Lost => {
            table.c_tra_sharp = |constants, k1, k2| {
                let genuine = bounds::c_tra_sharp(constants, k1, k2);
                genuine + constants.l_h() * (k1.powi(2) - k1.powi(3))
            };
        }
        Mutant::DistanceForgotten => {
            table.k3_bar_g = |setting| {
                let square = bounds::k3_bar_g(setting).powi(2) - bounds::k1_g(setting).powi(2);
                square.max(0.0).sqrt()
            };
        }
        Mutant::K4IsK3 => table.k4_bar_g = bounds::k3_bar_g,
        Mutant::QuarterLost => {
            table.polyline_gap_trapezoidal =
                |constants, k3, n| 4.0 * bounds::polyline_gap_trapezoidal(constants, k3, n);
        }
        Mutant::PowerOfK3Lost => {
            table.polyline_gap_trapezoidal =
                |constants, k3, n| bounds::polyline_gap_trapezoidal(constants, k3, n) / k3;
        }
        Mutant::RootOfNForgotten => {
            table.polyline_gap_trapezoidal = |constants, k3, n| {
                bounds::polyline_gap_trapezoidal(constants, k3, n) / (n.get() as f64).sqrt()
            };
        }
        Mutant::HalfOfRuleGap => {
            table.rule_gap = |constants, k3, n| 0.5 * bounds::rule_gap(constants, k3, n);
        }
        Mutant::HalfOfLeftGap => {
            table.polyline_gap_left =
                |constants, k3, n| 0.5 * bounds::polyline_gap_left(constants, k3, n);
        }
        Mutant::SharpForgotten => {
            table.theorem_1_1_constant = |setting| {
                let (k1, k2) = (bounds::k1_g(setting), bounds::k2_g(setting));
                let lost = bounds::c_tra_sharp(setting.constants(), k1, k2);
                bounds::theorem_1_1_constant(setting) - lost
            };
        }
        Mutant::LastCubeForgotten => {
            table.theorem_1_3_constant = |setting| {
                let cube = bounds::k4_bar_g(setting).powi(3);
                let lost = 0.5 * setting.constants().l_h() * cube;
                (bounds::theorem_1_3_constant(setting) - lost).max(0.0)
            };
        }
        _ => {}
    }
}
