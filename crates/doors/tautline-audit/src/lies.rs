//! The false claims that the outcomes of laws show.

use std::cmp::Ordering;

use tautline::{CertifyError, Metric, MetricError, RayleighQuotient, check_gram};
use tautline_kit::{Claim, Fault};
use tautline_statements::VerifyError;

use crate::{answer::Lie, region::point, words::number};

/// The name of a claim that `H` is a metric.
pub(crate) const METRIC: &str = "H";

/// Returns the false claims that a fault shows.
pub(crate) fn shown_by<const D: usize>(metric: &impl Metric<D>, fault: &Fault) -> Vec<Lie> {
    match fault {
        Fault::Lie(lie) if lie.found.is_nan() => {
            let error = check_gram(metric, &point(&lie.point)).err();
            error.and_then(|error| of_the_metric(metric, &error)).into_iter().collect()
        }
        Fault::Lie(lie) => {
            let told = Lie {
                point: Some(lie.point.clone()),
                direction: Some(lie.direction.clone()),
                other: lie.other.as_ref().map(|other| other.to_vec()),
                ..of_a_constant(lie.constant, lie.claimed, lie.found, lie.formula())
            };
            if is_rounding(metric, lie.constant, lie.claimed, &lie.point) {
                return Vec::new();
            }
            if lie.constant == Claim::C1 && !(lie.found > 0.0) {
                // The lower bound is wrong since there is none.
                let indefinite = indefinite(metric, &lie.point);
                return indefinite.into_iter().chain([told]).collect();
            }
            vec![told]
        }
        Fault::Refuted { claim, claimed, bound } => {
            vec![of_a_constant(*claim, *claimed, *bound, claim.formula())]
        }
        Fault::Metric(error) | Fault::Unevaluated(VerifyError::Metric(error)) => {
            of_the_metric(metric, error).into_iter().collect()
        }
        Fault::Unproved(
            CertifyError::NotPositiveDefinite { point, .. } | CertifyError::Undefined { point },
        ) => indefinite(metric, point).into_iter().collect(),
        _ => Vec::new(),
    }
}

fn of_a_constant(claim: Claim, claimed: f64, found: f64, formula: &str) -> Lie {
    Lie {
        about: claim.name(),
        claim: format!("{} = {}", claim.name(), number(claimed)),
        claimed: Some(claimed),
        found: found.is_finite().then_some(found),
        formula: formula.to_owned(),
        point: None,
        direction: None,
        other: None,
    }
}

fn of_the_metric<const D: usize>(metric: &impl Metric<D>, error: &MetricError) -> Option<Lie> {
    match error {
        MetricError::NotPositiveDefinite { point, .. } => indefinite(metric, point),
        MetricError::NotFinite { point: at, row, column, entry } => Some(Lie {
            about: METRIC,
            claim: "H(x) is finite".to_owned(),
            claimed: None,
            found: None,
            formula: format!("the entry ({}, {}) of H(x) is {entry}", row + 1, column + 1),
            point: Some(at.clone()),
            direction: None,
            other: None,
        }),
        MetricError::NotSymmetric { point: at, row, column, above, below } => Some(Lie {
            about: METRIC,
            claim: "H(x) is symmetric".to_owned(),
            claimed: Some(0.0),
            found: Some(above - below),
            formula: format!("the entry ({}, {}) of H(x) − Hᵀ(x)", row + 1, column + 1),
            point: Some(at.clone()),
            direction: None,
            other: None,
        }),
        _ => None,
    }
}

/// Returns whether a claim about the eigenvalues of `H` fails in `f64` only: intervals do not show that it
/// is wrong at this point.
fn is_rounding<const D: usize>(
    metric: &impl Metric<D>,
    claim: Claim,
    claimed: f64,
    at: &[f64],
) -> bool {
    let Some([least, greatest]) = RayleighQuotient::extreme(metric, &point::<D>(at)) else {
        return false;
    };
    // Intervals that say nothing excuse nothing.
    if least.value.is_undefined() {
        return false;
    }
    match claim {
        Claim::C1 => !(least.value.hi() < claimed),
        Claim::C2 => !(greatest.value.lo() > claimed),
        Claim::LH | Claim::MH => false,
    }
}

/// Returns what is wrong with a metric at a point where its least eigenvalue is proved not to be positive,
/// with the eigenvector; `None` if it may be positive or is not finite.
pub(crate) fn indefinite<const D: usize>(metric: &impl Metric<D>, at: &[f64]) -> Option<Lie> {
    let [least, _] = RayleighQuotient::extreme(metric, &point::<D>(at))?;
    (least.value.hi() <= 0.0).then(|| Lie {
        about: METRIC,
        claim: "wᵀ H(x) w > 0".to_owned(),
        claimed: Some(0.0),
        found: Some(least.value.hi()),
        formula: Claim::C1.formula().to_owned(),
        point: Some(at.to_vec()),
        direction: Some(point::<D>(&least.direction).normalize().as_slice().to_vec()),
        other: None,
    })
}

/// Adds a false claim. Of each kind only the worst is kept.
pub(crate) fn add(lies: &mut Vec<Lie>, new: Lie) {
    match lies.iter_mut().find(|old| old.about == new.about && old.claim == new.claim) {
        Some(old) if worse(&new, old) => *old = new,
        Some(_) => {}
        None => lies.push(new),
    }
    // What is not a metric comes first.
    lies.sort_by_key(|lie| (lie.about != METRIC, lie.about));
}

/// A difference quotient exceeds a derivative by more than this factor only if `H` jumps.
const JUMP: f64 = 1.001;

/// Returns whether a lie is worse than another one about the same claim. One with a point is, and
/// one about a derivative is worse than one about a difference quotient, which is never larger.
fn worse(new: &Lie, old: &Lie) -> bool {
    if new.point.is_some() != old.point.is_some() {
        return new.point.is_some();
    }
    match (&new.other, &old.other) {
        (None, Some(_)) => return !exceeds(old, new, JUMP),
        (Some(_), None) => return exceeds(new, old, JUMP),
        _ => {}
    }
    let order = new.found.partial_cmp(&old.found);
    let is_from_below = matches!(new.about, "c1" | METRIC);
    order == Some(if is_from_below { Ordering::Less } else { Ordering::Greater })
}

fn exceeds(a: &Lie, b: &Lie, factor: f64) -> bool {
    matches!((a.found, b.found), (Some(a), Some(b)) if a > factor * b)
}
