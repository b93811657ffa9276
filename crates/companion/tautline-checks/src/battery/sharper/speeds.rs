//! Lemma S.3 where it loses little: sequences that bend as fast as possible, or that run away.

use tautline::PointSequence;
use tautline_statements::{
    PaperRule,
    Statement::LemmaS3,
    curves::Curve,
    lemma_s_3,
    witnesses::{Polygonal, Twist},
};

use crate::battery::{
    harness::{Check, Outcome, Trial, Witness, for_rules},
    sharper::witnesses::NEAR,
};

pub(crate) const CHECKS: &[Check] = &[
    Witness.check("lemma_s_3_is_attained_from_chord_to_chord_over_a_twist", &[LemmaS3], twist),
    Witness.check("lemma_s_3_is_nearly_attained_by_a_sequence_that_runs_away", &[LemmaS3], runaway),
];

/// The sequence has two chords of the geodesic that attains Lemma S.1.
fn twist(trial: &Trial<'_>) -> Outcome {
    let metric = Twist::<2>::new(1.0, 1.0, 2e-3)?;
    for_rules([2], |rule, n| {
        let sequence = metric.short_geodesic(1e-5).sample(n)?;
        let found = lemma_s_3(trial.subject, &metric, rule, &sequence)?;
        let claim = "|βₙ − βₙ₋₁| ≤ 3L_H B²/2Nc₁ + |ρₙ|/Nc₁";
        trial.one([found.claim_is_attained(claim, NEAR)?])
    })
}

/// Every chord has the slope `L_H = 1` at its middle, and between two chords `H` falls back to 1.
/// The momentum therefore grows all the way, by `βₙ − βₙ₋₁ = (h/4)(βₙ² + βₙ₋₁²)`, like
/// `1/(c − t/2)`. The construction starts from the last chord.
///
/// With `sₙ = hβₙ/4`, whose last value is 0.14, `Σ (sₙ² + sₙ₋₁²)` is the last `s` minus the first.
/// The lemma loses a part `s` of its second term. It also loses its first term, `K₃`, which is
/// `(2Ns)^{−1/2}` of the greatest difference.
fn runaway(trial: &Trial<'_>) -> Outcome {
    let n = 200;
    let mut last = 0.14_f64;
    let mut chords = vec![4.0 * last];
    while chords.len() < n {
        // The equation for the previous s is s + s² = r, with r = s − s² from the next one.
        let right = last * (1.0 - last);
        last = 2.0 * right / (1.0 + (1.0 + 4.0 * right).sqrt());
        chords.push(4.0 * last);
    }
    chords.reverse();
    let mut points = vec![0.0];
    for chord in &chords {
        points.push(points[points.len() - 1] + chord);
    }
    // This is half the width of a slope, a thousandth of the shortest chord.
    let w = 1e-3 * chords[0];
    let middles = points.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let knots: Vec<[f64; 2]> = middles.flat_map(|x| [[x - w, 1.0 - w], [x + w, 1.0 + w]]).collect();
    let metric = Polygonal::new(&knots).expect("in order");
    let sequence = PointSequence::new(points.into_iter().map(|x| [x].into()).collect())?;
    let found = lemma_s_3(trial.subject, &metric, PaperRule::Trapezoidal, &sequence);
    let claim = "max|βₙ| ≤ (c₂K₃ + ½L_H K₃² + mean|ρ|)/c₁";
    trial.one([found?.claim_is_attained(claim, 1.28)?])
}
