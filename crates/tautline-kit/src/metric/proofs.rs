//! The constants of a metric in every point of the region, by branch and bound.

use nalgebra::SVector;
use tautline::{
    Bounded, CertifyError, Domain, Metric, Quantity,
    certify::{Accuracy, Cell, certify},
};

use super::{Case, claims::judge, extreme::Extreme};
use crate::{
    Claim, Failure, Fault, Proof, Standing,
    report::{LawResult, Tried},
};

impl Claim {
    fn quantity(self) -> Quantity {
        match self {
            Claim::C1 => Quantity::C1,
            Claim::C2 => Quantity::C2,
            Claim::LH => Quantity::LH,
            Claim::MH => Quantity::MH,
        }
    }

    /// To one percent, with so many boxes as take a fraction of a second: the derivatives cost
    /// more.
    fn accuracy(self, dimension: usize) -> Accuracy {
        let budget = match self {
            Claim::C1 | Claim::C2 => 20_000,
            Claim::LH => 6_000,
            Claim::MH => 2_000,
        };
        let budget = if dimension <= 2 { budget } else { budget / 4 };
        Accuracy { tolerance: 1e-2, budget }
    }

    /// What the claim is about at a point where it is known to be `attained`, in the best direction
    /// that is found from the axes.
    fn at<const D: usize>(
        self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        attained: f64,
    ) -> Extreme<D> {
        let axes = (0..D).map(|i| SVector::from_fn(|k, _| if k == i { 1.0 } else { 0.0 }));
        let worst = axes
            .map(|axis: SVector<f64, D>| self.measure(metric, x, &axis))
            .reduce(|a, b| if self.worse(b.value, a.value) { b } else { a });
        let mut found =
            worst.unwrap_or(Extreme { value: attained, point: *x, direction: SVector::zeros() });
        if self.worse(attained, found.value) {
            found.value = attained;
        }
        found
    }
}

/// Encloses each constant over the region, from the formula of the metric.
///
/// A claim that the bounds contradict is refused with the point, from where an ascent makes the
/// most of it. Where the claim is on the right side of both bounds it is proved; between them, it
/// is right as far as they are apart. Where the boxes do not suffice the bounds that were reached
/// still prove or refute, without a point, and between them nothing is decided; in more than three
/// dimensions, and of a formula that cannot be recorded, nothing is tried: the standing of each
/// constant says which.
pub(super) fn constants<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let (metric, region) = (&case.metric, &case.region);
    let constants = metric.constants();
    let claimed = |claim: Claim| Some((claim, claim.of(&constants)?));
    let claims = Claim::ALL.into_iter().filter_map(claimed);
    let unrecorded = metric.metric.formula().err();
    if D > 3 || unrecorded.is_some() {
        let standings = claims.map(|(claim, _)| Standing { claim, proof: Proof::NotTried });
        let tried = match unrecorded {
            Some(error) => Tried::cases(0).with_note(error.to_string()),
            None => Tried::cases(0),
        };
        return Ok(Tried { standings: standings.collect(), ..tried });
    }
    let failure = |fault| Failure { fault, sample: None, seed: case.effort.seed };
    let corner = |share| region.at(&SVector::repeat(share));
    let cell = Cell::new(corner(0.0), corner(1.0));
    let domain = Domain::cell(cell.map_err(|error| failure(Fault::Unproved(error)))?);
    let mut tried = Tried::cases(0);
    for (claim, claimed) in claims {
        let found = match certify(metric, claim.quantity(), &domain, claim.accuracy(D)) {
            Ok(found) => found,
            Err(CertifyError::BudgetSpent { lower, upper, .. }) => {
                let (proved, refuted, bound) = match claim {
                    Claim::C1 => (claimed <= lower, claimed > upper, upper),
                    _ => (upper <= claimed, claimed < lower, lower),
                };
                if refuted {
                    return Err(failure(Fault::Refuted { claim, claimed, bound }));
                }
                let proof = if proved { Proof::Proved } else { Proof::NotDecided };
                tried.standings.push(Standing { claim, proof });
                continue;
            }
            Err(error) => return Err(failure(Fault::Unproved(error))),
        };
        let (attained, proved) = match claim {
            Claim::C1 => (found.upper, claimed <= found.lower),
            _ => (found.lower, found.upper <= claimed),
        };
        let top = claim.climb(metric, region, claim.at(metric, &found.at, attained));
        let overestimation =
            judge(claim, &constants, claimed, &top).map_err(|lie| failure(lie.into()))?;
        tried.cases += found.boxes as u64;
        tried.overestimation = tried.overestimation.min(overestimation);
        let percent = 100.0 * (found.looseness() - 1.0);
        let proof = if proved { Proof::Proved } else { Proof::RightTo { percent } };
        tried.standings.push(Standing { claim, proof });
    }
    Ok(tried)
}
