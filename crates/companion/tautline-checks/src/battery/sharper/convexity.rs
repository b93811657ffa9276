//! Proposition S.7: where it loses nothing, and where its convex set has to contain a minimiser
//! that is faster than the computed sequence.

use std::f64::consts::{FRAC_PI_2, PI};

use tautline::{
    Bounded, Constants, PointSequence,
    bounds::BetweenPoints,
    gallery::{Constant, Separable},
};
use tautline_statements::{
    Evidence, Known, LIBRARY, PaperRule, Reconstruction,
    Statement::{self, PropositionS7},
    Unit, VerifyError, WithConstants, discrete_energy, prop_s_7,
    witnesses::Polygonal,
};

use crate::battery::{
    harness::{Check, Failure, Outcome, Trial, Witness, for_rules},
    sharper::witnesses::NEAR,
};

const S7: &[Statement] = &[PropositionS7];

pub(crate) const CHECKS: &[Check] = &[
    Witness.check("prop_s_7_finds_the_minimum_under_a_constant_metric_from_a_wave", S7, wave),
    Witness.check("prop_s_7_is_attained_with_two_chords_on_opposite_slopes", S7, opposite_slopes),
    Witness.check("prop_s_7_is_attained_with_two_chords_about_crests", S7, crests),
    Witness.check(
        "prop_s_7_covers_a_minimiser_that_is_faster_than_the_straight_line",
        S7,
        competitors,
    ),
];

/// Returns a metric and two sequences on the line with `N = 2`. `H` has the slope `−L` at the first
/// midpoint and `L` at the second, where it is hardly more than `c₁`. If the middle point moves,
/// both differences and both values of `H` change, in opposite directions.
pub(crate) fn slopes(claimed: [f64; 3]) -> Result<(Claimed, [PointSequence<1>; 2]), VerifyError> {
    // This is half the width of the slopes.
    let w = 1e-3;
    let knots =
        [[0.25 - w, 1.0 + w], [0.25 + w, 1.0 - w], [0.75 - w, 1.0 - w], [0.75 + w, 1.0 + w]];
    let metric = Polygonal::new(&knots).expect("in order");
    let [c1, c2, l_h] = claimed;
    // Between its knots H is linear, except for the rounded corners.
    let constants = Constants::new(c1, c2, l_h)?.with_m_h(1e-9)?;
    let through = |x: f64| PointSequence::new([0.0, x, 1.0].map(|x| [x].into()).to_vec());
    Ok((WithConstants { metric, constants }, [through(0.5)?, through(0.5001)?]))
}

/// A polygonal metric with constants that hold where it is evaluated.
type Claimed = WithConstants<Polygonal>;

fn opposite_slopes(trial: &Trial<'_>) -> Outcome {
    let (metric, [x, y]) = slopes([1.0 - 1.1e-3, 1.0 + 1.1e-3, 1.0])?;
    let rule = PaperRule::Trapezoidal;
    let evidence = prop_s_7(trial.subject, &metric, rule, [&x, &y], 1.0)?;
    trial.one([evidence.claim_is_attained("σ ≤ the convexity of E from x to y", NEAR)?])
}

/// Under `H = 4` the energy is quadratic. For a straight line plus half a sine wave it exceeds its
/// minimum by `R²/(4σN² sin²(π/2N))` for both rules, since Poincaré's inequality is sharp for this
/// wave.
fn wave(trial: &Trial<'_>) -> Outcome {
    let metric = Constant::<1>::new([[4.0]].into()).expect("positive");
    for_rules([2, 5, 32], |rule, n| {
        let through = |by: f64| {
            let at = |k: usize| {
                let t = k as f64 / n as f64;
                let sine = if k == 0 || k == n { 0.0 } else { (PI * t).sin() };
                [t + by * sine].into()
            };
            PointSequence::new((0..=n).map(at).collect())
        };
        let both = [&through(0.1)?, &through(0.0)?];
        let found = prop_s_7(trial.subject, &metric, rule, both, 2.0)?;
        trial.one([found.claim_is_attained("E(x) − R²/4σN²sin² ≤ E(y)", 1.0 + 1e-9)?])
    })
}

/// `N = 2` on the line, with both midpoints on crests of `H = (1 + a sin kx)²`, 320 waves apart.
/// Where `ak² = 8`, half of the convexity `H − ½ M_H B²r²` is left, and `2L_H B r` is `4/k`. With
/// four times the height the crests are not minima: the energy is smaller on either side, and the
/// proposition must not claim anything.
fn crests(trial: &Trial<'_>) -> Outcome {
    let k = 4.0 * PI * 320.0;
    let first = FRAC_PI_2 / k - 0.25;
    let through = |by: f64| {
        let points = [first, first + 0.5 + by, first + 1.0].map(|x| [x].into());
        PointSequence::new(points.to_vec())
    };
    let half_convex = |part: f64, by: f64| -> Result<Evidence, VerifyError> {
        let metric = Separable::new([part / (k * k)], [k])?;
        let both = [&through(0.0)?, &through(by)?];
        prop_s_7(trial.subject, &metric, PaperRule::Trapezoidal, both, 1.0)
    };
    // The midpoints move by half of a tenth of a radian of the wave, and by one radian.
    let low = half_convex(8.0, 0.1 / k)?;
    let high = half_convex(32.0, 2.0 / k)?;
    trial.one([low.claim_is_attained("σ ≤ the convexity of E from x to y", NEAR)?, high])
}

/// In the trough of `H = (1 + 0.3 sin x)²` the minimiser is faster than the straight line. The
/// convex set has to contain both: its `σ`, computed from a residual, must not exceed the `σ` for
/// the `B` of both.
fn competitors(trial: &Trial<'_>) -> Outcome {
    let metric = Separable::new([0.3], [1.0])?;
    let [a, b] = [-1.6, -1.0];
    let known = Known::between(metric, [a], [b])?.expect("known");
    let constants = metric.constants();
    for_rules([16], |rule, n| {
        let straight = PointSequence::straight([a], [b], n)?;
        let seen = Reconstruction::observe(trial.subject, &known, rule, n)?;
        let speeds = seen.minimum.sequence.differences().map(|beta| beta.norm());
        let greatest = speeds.fold(0.0, f64::max);
        let energy = discrete_energy(trial.subject, rule, &metric, &straight);
        let computed = BetweenPoints {
            rule,
            n: seen.n,
            discrete_energy: energy,
            length: known.distance,
            greatest_difference: b - a,
            // The residual is so large that the excess that it allows is as large as the energy.
            residual: 1.0,
        };
        let silent = || Failure::new("Proposition S.7 says nothing of near points");
        let least = trial.subject.strict_convexity(constants, 1, &computed).ok_or_else(silent)?;
        let wave = n as f64 * (FRAC_PI_2 / n as f64).sin();
        let modulus = 1.0 / (4.0 * wave * wave * (energy - least));
        let covering = LIBRARY.convexity_modulus(constants, rule, greatest, seen.n);
        let covering = covering.ok_or_else(silent)?;
        trial.one([Evidence::of(PropositionS7)
            .given("x is slower than y", Unit::COORDINATE, [b - a, greatest], 0.0)
            // Rounding comes from a difference of numbers of the same size.
            .stated("σ ≤ that of both", Unit::GRAM, [modulus, covering], 1e-12 * covering)])
    })
}
