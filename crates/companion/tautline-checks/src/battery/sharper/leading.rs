//! The leading terms of the bounds in Theorems A to D as `N → ∞`, as stated in `paper/SHARPER.md`.

use std::{f64::consts::PI, num::NonZeroUsize};

use tautline::{
    bounds::Setting,
    gallery::{Shear, Valleys},
};
use tautline_statements::{
    PaperRule,
    Statement::{LemmaS4, TheoremA, TheoremB, TheoremC, TheoremD},
    Subject,
};

use crate::battery::{
    harness::{Check, Order, Outcome, Trial, all, close},
    sharper::golden::setting,
};

pub(crate) const CHECKS: &[Check] = &[Order.check(
    "bounds_of_theorems_a_to_d_have_the_leading_terms_that_are_stated",
    &[LemmaS4, TheoremA, TheoremB, TheoremC, TheoremD],
    leading,
)];

/// A relative bound on the next terms. The largest is `√N v^{3/2} = (2kδ)^{3/2}/N` in `m₃`, which
/// is at most 2·10⁻⁵ for the `δ` here, since these are at most 111.
const NEXT: f64 = 1e-4;

fn leading(trial: &Trial<'_>) -> Outcome {
    let shear = Shear::new(0.5, 1.0)?;
    for setting in [
        setting(trial.subject, &Valleys, [4.0 * PI, 0.0])?,
        setting(trial.subject, &Valleys, [2.0, 1.5])?,
        setting(trial.subject, &shear, [2.0, 3.0])?,
    ] {
        of_first_order(trial.subject, setting)?;
        of_second_order(trial.subject, setting)?;
    }
    Ok(Default::default())
}

/// Returns a power of 2 so large that the next terms are small; `N²` is exact.
fn huge() -> (NonZeroUsize, f64) {
    let n = 1_usize << 26;
    (NonZeroUsize::new(n).expect("positive"), n as f64)
}

fn agree(pairs: &[(&str, f64, f64)]) -> Outcome {
    all(pairs.iter().map(|&(name, value, term)| close(name, value, term, NEXT * term)))
}

/// Compares `N` times the bounds, divided by `d²`, with the leading terms.
fn of_first_order(subject: &Subject, setting: Setting) -> Outcome {
    let (n, count) = huge();
    let (delta, scale) = (setting.delta(), count / setting.distance().powi(2));
    for rule in PaperRule::BOTH {
        let k = rule.mean_distance();
        agree(&[
            ("e − 1", scale * subject.theorem_a_minimum_gap(setting, rule, n), k * delta),
            (
                "Theorem A",
                scale * subject.theorem_a_polyline_gap(setting, rule, n),
                k * delta * (1.0 + delta),
            ),
            ("Theorem C", scale * subject.theorem_c_polyline_gap(setting, rule, n), k * delta),
            (
                "Theorem C, length",
                scale * subject.theorem_c_length_excess(setting, rule, n),
                2.0 * k * delta,
            ),
            ("Theorem C, below", scale * subject.theorem_c_deficit(setting, rule, n), k * delta),
        ])?;
    }
    Ok(Default::default())
}

/// Compares `N²` times the bounds, divided by `d²`, with the leading terms.
fn of_second_order(subject: &Subject, setting: Setting) -> Outcome {
    let (n, count) = huge();
    let scale = count * count / setting.distance().powi(2);
    let (delta, bend, mu) = (setting.delta(), setting.bend(), setting.mu().unwrap_or(f64::NAN));
    let scaled = |bound: Option<f64>| scale * bound.unwrap_or(f64::NAN);
    let bent = bend * bend / 12.0;
    agree(&[
        (
            "e₂ − 1",
            scaled(subject.theorem_b_minimum_gap(setting, n)),
            bend * delta / 3.0 + mu / 24.0,
        ),
        (
            "Theorem B",
            scaled(subject.theorem_b_polyline_gap(setting, n)),
            (1.0 + delta).powi(2) * mu / 24.0,
        ),
        ("ε − 1", scaled(subject.theorem_d_minimum_gap(setting, n)), bent + mu / 24.0),
        ("Theorem D", scaled(subject.theorem_d_polyline_gap(setting, n)), mu / 24.0),
        (
            "Theorem D, length",
            scaled(subject.theorem_d_length_excess(setting, n)),
            bent + mu / 12.0,
        ),
        ("Theorem D, below", scaled(subject.theorem_d_deficit(setting, n)), mu / 24.0),
    ])
}
