//! The constants that an audit uses: claimed in the file, or proved.

use tautline::Constants;
use tautline_kit::{Claim, Region};
use tautline_problem::{
    BallAnswer, ConstantAnswer, ConstantsAnswer, Failure, Question, UsedConstants,
    decimal::{shortly_down, shortly_up},
};

use crate::{answer::Standing, region::largest_ball, words::DIGITS};

/// A ball: its centre and its radius.
pub(crate) type BallOf = (Vec<f64>, f64);

/// Constants that are proved.
pub(crate) struct Proved {
    pub(crate) constants: Constants,
    /// Whether they hold only if the metric settles.
    pub(crate) if_it_settles: bool,
    /// The ball in which they hold; `None` if that is all of space.
    pub(crate) ball: Option<BallOf>,
    pub(crate) standings: Vec<Standing>,
}

/// Why nothing is proved.
pub(crate) enum Unproved {
    /// The file is wrong.
    BadFile(Failure),
    /// The formula is not known to be a metric at a point.
    At { point: Vec<f64>, reason: String },
    /// Another reason.
    Reason(String),
}

/// Proves constants: in the region of the file; or else on all of space; or else in the largest
/// ball in the box of the samples.
pub(crate) fn prove<const D: usize>(
    question: &Question,
    region: &Region<D>,
) -> Result<Proved, Unproved> {
    let mut question = question.clone();
    let ball = question.ball_of_constants();
    match proved(&question, ball.clone()) {
        Err(Unproved::Reason(everywhere)) if ball.is_none() => {
            let (centre, radius) = largest_ball(region);
            let within = question.prove_within_ball(&centre, radius);
            within.map_err(|wrong| Unproved::BadFile(Failure::BadInput(wrong)))?;
            let ball = question.ball_of_constants();
            proved(&question, ball).map_err(|unproved| match unproved {
                Unproved::Reason(reason) if reason != everywhere => {
                    Unproved::Reason(format!("on all of space: {everywhere}. In a ball: {reason}"))
                }
                other => other,
            })
        }
        other => other,
    }
}

fn proved(question: &Question, ball: Option<BallOf>) -> Result<Proved, Unproved> {
    let answer = question.constants().map_err(|failure| match failure {
        Failure::NotComputed(reason) => Unproved::Reason(reason),
        bad_input => Unproved::BadFile(bad_input),
    })?;
    let ConstantsAnswer { region, if_it_settles, constants: found } = &answer;
    let undefined = found.iter().find(|constant| is_refuted(constant));
    if let Some(ConstantAnswer { at: Some(point), reason: Some(reason), .. }) = undefined {
        return Err(Unproved::At { point: point.clone(), reason: reason.clone() });
    }
    let of = |claim: Claim| found.iter().find(|constant| constant.name == claim.name());
    // A bound is valid even if the boxes ran out before it was sharp.
    let bound = |claim: Claim| {
        let constant = of(claim)?;
        let bound = if claim == Claim::C1 { &constant.lower } else { &constant.upper };
        bound.as_ref().map(|bound| bound.value)
    };
    let [c1, c2, l_h, m_h] = Claim::ALL.map(bound);
    let why = || {
        let reasons = found.iter().filter_map(|constant| constant.reason.as_deref());
        Unproved::Reason(reasons.collect::<Vec<_>>().join("; "))
    };
    let (Some(c1), Some(c2), Some(l_h)) = (c1, c2, l_h) else { return Err(why()) };
    let mut constants = Constants::new(c1, c2, l_h).map_err(|_| why())?;
    if let Some(sharper) = m_h.and_then(|m_h| constants.with_m_h(m_h).ok()) {
        constants = sharper;
    }
    let standings = Claim::ALL.into_iter().filter_map(|claim| {
        let (constant, bound) = (of(claim)?, bound(claim));
        let is_lower = claim == Claim::C1;
        let round = if is_lower { shortly_down } else { shortly_up };
        let bound = bound.map(|bound| round(bound, DIGITS));
        let proof = match (bound, &constant.reason) {
            (Some(bound), None) => format!("{bound} proved from the formula"),
            (Some(bound), Some(reason)) => format!("{bound} proved, but not sharp: {reason}"),
            (None, reason) => reason.clone().unwrap_or_else(|| "not proved".to_owned()),
        };
        Some(Standing { constant: claim.name(), proof, within: region.clone() })
    });
    let if_it_settles = *if_it_settles;
    Ok(Proved { constants, ball, if_it_settles, standings: standings.collect() })
}

/// Returns whether the formula fails at a point, so that no bound on the constant exists.
fn is_refuted(constant: &ConstantAnswer) -> bool {
    !constant.proved
        && constant.lower.is_none()
        && constant.upper.is_none()
        && constant.at.is_some()
}

/// Returns constants with the place where they hold.
pub(crate) fn used(constants: Constants, proved: bool, ball: Option<&BallOf>) -> UsedConstants {
    let within =
        ball.map(|(centre, radius)| BallAnswer { centre: centre.clone(), radius: *radius });
    UsedConstants::new(constants, proved, within)
}
