//! The mistakes of the mutants in Lemma S.4, in Theorems A to D, and in the least of their bounds.

use std::num::NonZeroUsize;

use tautline::bounds::{Bound, PaperRule, Setting};

use super::Mutant;
use crate::{Library, Subject};

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
        Some(Mutant::SpeedsOfTheoremAEqual) => gap_of_equal_speeds(setting, rule, n),
        _ => Library.theorem_a_polyline_gap(setting, rule, n),
    }
}

pub(super) fn theorem_b_minimum_gap(
    mutant: Option<Mutant>,
    setting: Setting,
    n: NonZeroUsize,
) -> Option<f64> {
    let genuine = Library.theorem_b_minimum_gap(setting, n)?;
    match mutant {
        Some(Mutant::SampledTermHalved) => {
            let count = n.get() as f64;
            let half = setting.bend() * setting.delta() / (6.0 * count * count);
            Some((genuine - setting.distance().powi(2) * half).max(0.5 * genuine))
        }
        _ => Some(genuine),
    }
}

pub(super) fn theorem_b_polyline_gap(
    mutant: Option<Mutant>,
    setting: Setting,
    n: NonZeroUsize,
) -> Option<f64> {
    let genuine = Library.theorem_b_polyline_gap(setting, n)?;
    match mutant {
        Some(Mutant::StationaryFourthHalved) => Some(0.5 * genuine),
        Some(Mutant::SquareOfSpeedLost) => {
            let e = ceiling(setting, Library.theorem_b_minimum_gap(setting, n)?);
            let count = n.get() as f64;
            let greatest = (count * e).sqrt().min(e.sqrt() + setting.delta() * e);
            Some(genuine / greatest)
        }
        _ => Some(genuine),
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

pub(super) fn theorem_c_polyline_gap(
    mutant: Option<Mutant>,
    setting: Setting,
    rule: PaperRule,
    n: NonZeroUsize,
) -> f64 {
    match mutant {
        // With m₃ = e^{3/2}: as for Theorem A.
        Some(Mutant::SpeedsOfTheoremCEqual) => gap_of_equal_speeds(setting, rule, n),
        _ => Library.theorem_c_polyline_gap(setting, rule, n),
    }
}

pub(super) fn theorem_c_length_excess(
    mutant: Option<Mutant>,
    setting: Setting,
    rule: PaperRule,
    n: NonZeroUsize,
) -> f64 {
    let genuine = Library.theorem_c_length_excess(setting, rule, n);
    let above = Library.theorem_a_minimum_gap(setting, rule, n);
    match mutant {
        Some(Mutant::LengthOfTheoremCHalved) => 0.5 * (above + genuine),
        Some(Mutant::PowerOfTheoremCLost) => {
            above + (genuine - above) / ceiling(setting, above).sqrt()
        }
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

pub(super) fn theorem_d_length_excess(
    mutant: Option<Mutant>,
    setting: Setting,
    n: NonZeroUsize,
) -> Option<f64> {
    let genuine = Library.theorem_d_length_excess(setting, n)?;
    match mutant {
        Some(Mutant::LengthOfTheoremDHalved) => {
            Some(0.5 * (genuine + Library.theorem_d_minimum_gap(setting, n)?))
        }
        _ => Some(genuine),
    }
}

pub(super) fn least_length_excess(
    mutant: Option<Mutant>,
    setting: Setting,
    rule: PaperRule,
    n: NonZeroUsize,
) -> Bound {
    let rule = match mutant {
        Some(Mutant::LeastOfTheOtherRule) => PaperRule::Trapezoidal,
        _ => rule,
    };
    Library.least_length_excess(setting, rule, n)
}

/// `e` from `d² (e − 1)`; 1 between ends that touch.
fn ceiling(setting: Setting, gap: f64) -> f64 {
    let d2 = setting.distance().powi(2);
    if d2 > 0.0 { 1.0 + gap / d2 } else { 1.0 }
}

/// `d² (kδ/N) e^{3/2}`.
fn gap_of_equal_speeds(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let e = ceiling(setting, Library.theorem_a_minimum_gap(setting, rule, n));
    let k = rule.mean_distance();
    setting.distance().powi(2) * k * setting.delta() / n.get() as f64 * e.powf(1.5)
}
