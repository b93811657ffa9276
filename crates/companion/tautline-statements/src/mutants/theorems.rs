//! Mistakes in Lemma S.4, Theorems A to D, and the least of their bounds.

use std::num::NonZeroUsize;

use tautline::bounds::{self, PaperRule, Setting, Spread};

use super::Mutant;
use crate::replaceable::Bounds;

pub(super) fn replace(mutant: Mutant, table: &mut Bounds) {
    match mutant {
        Mutant::LeftCeilingHalved => {
            table.theorem_a_minimum_gap = |setting, rule, n| {
                let genuine = bounds::theorem_a_minimum_gap(setting, rule, n);
                if rule == PaperRule::LeftEndpoint { 0.5 * genuine } else { genuine }
            };
        }
        Mutant::SpeedsOfTheoremAEqual => table.theorem_a_polyline_gap = gap_of_equal_speeds,
        Mutant::SampledTermHalved => {
            table.theorem_b_minimum_gap = |setting, n| {
                let genuine = bounds::theorem_b_minimum_gap(setting, n)?;
                let half = setting.bend() * setting.delta() / (6.0 * (n.get() as f64).powi(2));
                Some((genuine - setting.distance().powi(2) * half).max(0.5 * genuine))
            };
        }
        Mutant::StationaryFourthHalved => {
            table.theorem_b_polyline_gap =
                |setting, n| Some(0.5 * bounds::theorem_b_polyline_gap(setting, n)?);
        }
        Mutant::SquareOfSpeedLost => {
            table.theorem_b_polyline_gap = |setting, n| {
                let genuine = bounds::theorem_b_polyline_gap(setting, n)?;
                let e = ceiling(setting, bounds::theorem_b_minimum_gap(setting, n)?);
                let count = n.get() as f64;
                let greatest = (count * e).sqrt().min(e.sqrt() + setting.delta() * e);
                Some(genuine / greatest)
            };
        }
        Mutant::DeficitHalved => {
            table.theorem_c_deficit =
                |setting, rule, n| 0.5 * bounds::theorem_c_deficit(setting, rule, n);
        }
        // With m₃ = e^{3/2}, the bound has the same form as for Theorem A.
        Mutant::SpeedsOfTheoremCEqual => table.theorem_c_polyline_gap = gap_of_equal_speeds,
        Mutant::CapForgotten => {
            table.theorem_c_polyline_gap = |setting, rule, n| {
                let e = ceiling(setting, bounds::theorem_a_minimum_gap(setting, rule, n));
                let spread = Spread::of_first_order(setting, rule, n, e - 1.0);
                let Spread { variance, deviation, .. } = spread;
                let cube = e.powf(1.5) + 1.5 * e.sqrt() * variance + deviation * variance;
                gap_of_equal_speeds(setting, rule, n) * cube / e.powf(1.5)
            };
        }
        Mutant::LengthOfTheoremCHalved => {
            table.theorem_c_length_excess = |setting, rule, n| {
                let above = bounds::theorem_a_minimum_gap(setting, rule, n);
                0.5 * (above + bounds::theorem_c_length_excess(setting, rule, n))
            };
        }
        Mutant::PowerOfTheoremCLost => {
            table.theorem_c_length_excess = |setting, rule, n| {
                let above = bounds::theorem_a_minimum_gap(setting, rule, n);
                let beyond = bounds::theorem_c_length_excess(setting, rule, n) - above;
                above + beyond / ceiling(setting, above).sqrt()
            };
        }
        Mutant::SecondVariationHalved => {
            table.theorem_d_minimum_gap = |setting, n| {
                let genuine = bounds::theorem_d_minimum_gap(setting, n)?;
                let half = setting.bend().powi(2) / (24.0 * (n.get() as f64).powi(2));
                Some((genuine - setting.distance().powi(2) * half).max(0.5 * genuine))
            };
        }
        Mutant::FourthPowerHalved => {
            table.theorem_d_polyline_gap =
                |setting, n| Some(0.5 * bounds::theorem_d_polyline_gap(setting, n)?);
        }
        Mutant::LengthOfTheoremDHalved => {
            table.theorem_d_length_excess = |setting, n| {
                let genuine = bounds::theorem_d_length_excess(setting, n)?;
                Some(0.5 * (genuine + bounds::theorem_d_minimum_gap(setting, n)?))
            };
        }
        Mutant::DeficitOfTheoremDHalved => {
            table.theorem_d_deficit =
                |setting, n| Some(0.5 * bounds::theorem_d_deficit(setting, n)?);
        }
        Mutant::LeastOfTheOtherRule => {
            table.least_length_excess =
                |setting, _, n| bounds::least_length_excess(setting, PaperRule::Trapezoidal, n);
        }
        _ => {}
    }
}

/// Returns `e`, given `d² (e − 1)`, or 1 if the ends touch.
fn ceiling(setting: Setting, gap: f64) -> f64 {
    let d2 = setting.distance().powi(2);
    if d2 > 0.0 { 1.0 + gap / d2 } else { 1.0 }
}

/// Returns `d² (kδ/N) e^{3/2}`.
fn gap_of_equal_speeds(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let e = ceiling(setting, bounds::theorem_a_minimum_gap(setting, rule, n));
    let k = rule.mean_distance();
    setting.distance().powi(2) * k * setting.delta() / n.get() as f64 * e.powf(1.5)
}
