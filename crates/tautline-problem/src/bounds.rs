//! Bounds on the distance, for an answer.

use tautline::{
    CertifyError, Constants, Formula, LocalError, Metric, PointSequence, ProofError,
    RuleOfThePaper, SMatrix, SVector, Short, TautLine,
    bounds::{Enclosure, FromAbove, FromBelow, LocalityError},
    certify::Accuracy,
    is_gram,
};

use crate::{
    BallAnswer, Bounds, GlobalMinimum, Question, UsedConstants, constants::too_many_coordinates,
    dimension::LARGEST_PROVED_DIMENSION,
};

/// Returns bounds on the distance, or why there are none.
pub(crate) fn bounds<R: RuleOfThePaper, const D: usize>(
    question: &Question,
    line: &TautLine<Formula<D>, R, D>,
) -> Result<Bounds, String> {
    if let Some(claimed) = question.claimed {
        check_claims(claimed, line.metric(), line.sequence())?;
        let enclosure = line.enclosure_given(claimed).map_err(|error| error.to_string())?;
        if enclosure.lower > enclosure.upper {
            // The upper bound is the length of a curve, so a claim is wrong.
            let [lower, upper] = [enclosure.lower, enclosure.upper].map(f64::sqrt);
            return Err(format!(
                "the claimed constants are wrong: by them the distance is at least {lower}, but \
                 the curve has length {upper}; `tautline audit` finds which one is wrong"
            ));
        }
        return Ok(in_words(enclosure, UsedConstants::new(claimed, false, None)));
    }
    // The compiler decides.
    if const { D > LARGEST_PROVED_DIMENSION } {
        return Err(too_many_coordinates().to_string());
    }
    let accuracy = Accuracy { tolerance: question.accuracy, budget: question.boxes };
    let proof = line.prove(accuracy).map_err(|error| no_proof(&error))?;
    let within = proof
        .within
        .map(|ball| BallAnswer { centre: ball.centre().as_slice().to_vec(), radius: ball.r() });
    Ok(in_words(proof.enclosure, UsedConstants::new(proof.constants, true, within)))
}

/// Refuses claims about the eigenvalues of `H` that fail at a point of the curve.
fn check_claims<const D: usize>(
    claimed: Constants,
    metric: &Formula<D>,
    sequence: &PointSequence<D>,
) -> Result<(), String> {
    // A claim that is attained may fail by a rounding.
    let (c1, c2) = (claimed.c1() * (1.0 - ATTAINED), claimed.c2() * (1.0 + ATTAINED));
    let refuse = |name, claim: f64, x: &SVector<f64, D>, what| {
        let x = x.as_slice();
        Err(format!(
            "the claim {name} = {claim} is wrong: H({x:?}) has a {what} eigenvalue; \
             `tautline audit` tests all claims"
        ))
    };
    for x in sequence.points() {
        let h = metric.gram(x);
        let identity = SMatrix::<f64, D, D>::identity();
        if !is_gram(&(h - identity * c1)) {
            return refuse("c1", claimed.c1(), x, "smaller");
        }
        if !is_gram(&(identity * c2 - h)) {
            return refuse("c2", claimed.c2(), x, "larger");
        }
    }
    Ok(())
}

/// How far an eigenvalue may be beyond a claim, relative to it.
const ATTAINED: f64 = 1e-9;

/// Says why nothing is proved, and what may help.
fn no_proof(error: &ProofError) -> String {
    let more = "ends that are closer, more chords, or more `boxes` in [certify] may help";
    match error {
        ProofError::Constants(error @ CertifyError::BudgetSpent { .. }) => {
            format!("{error}; {more}")
        }
        ProofError::Competitors(LocalityError::NoConstants {
            reason: LocalError::NotProved { radius, reason },
            ..
        }) => {
            let radius = Short(*radius);
            format!("they need constants on a ball of radius {radius}, and {reason}; {more}")
        }
        ProofError::Competitors(error) => {
            format!("{error}; ends that are closer or more chords may help")
        }
        _ => error.to_string(),
    }
}

/// Turns bounds on the squared distance into bounds on the distance, rounded outwards.
fn in_words(enclosure: Enclosure, constants: UsedConstants) -> Bounds {
    let lower = enclosure.lower.max(0.0).sqrt();
    let lower = if lower > 0.0 { lower.next_down() } else { lower };
    let upper = enclosure.upper.sqrt();
    let upper = if upper > 0.0 { upper.next_up() } else { upper };
    let global_minimum = match (enclosure.is_not_global, enclosure.assumes_global_minimum) {
        (true, _) => GlobalMinimum::Refuted,
        (false, true) => GlobalMinimum::Assumed,
        (false, false) => GlobalMinimum::Proved,
    };
    let lower_by = match enclosure.from_below {
        FromBelow::Euclidean => "Proposition 3.3",
        FromBelow::Minimum => "Lemma S.4",
        _ => "nothing: a distance is not negative",
    };
    let upper_by = match enclosure.from_above {
        FromAbove::Length => "the length of the curve",
        FromAbove::Energy => "the root of the energy of the curve",
    };
    Bounds {
        lower: lower.into(),
        upper: upper.into(),
        global_minimum,
        constants,
        lower_by: lower_by.to_owned(),
        upper_by: upper_by.to_owned(),
    }
}
