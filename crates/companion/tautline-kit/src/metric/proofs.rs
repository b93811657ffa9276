//! The constants of a metric over the whole region, enclosed by branch and bound.

use nalgebra::SVector;
use tautline::{
    Bounded, CertifyError, Domain, Metric, Quantity,
    certify::{Accuracy, Cell, certify},
    formula::Formula,
};

use super::{Case, claims::judge, extreme::Extreme};
use crate::{
    Claim, Fault, Proof, Standing,
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

    /// Returns an accuracy of one percent, with as many boxes as take a fraction of a second.
    /// Derivatives cost more per box.
    fn accuracy(self, dimension: usize) -> Accuracy {
        let budget = match self {
            Claim::C1 | Claim::C2 => 20_000,
            Claim::LH => 6_000,
            Claim::MH => 2_000,
        };
        let budget = if dimension <= 2 { budget } else { budget / 4 };
        Accuracy { tolerance: 1e-2, budget }
    }

    /// Returns the extreme at a point where the value `attained` is known, in the worst direction
    /// that is found when starting from the axes.
    fn at<const D: usize>(
        self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        attained: f64,
    ) -> Extreme<D> {
        let axes = (0..D).map(|i| SVector::from_fn(|k, _| if k == i { 1.0 } else { 0.0 }));
        let worst = self.worst(axes.map(|axis| self.measure(metric, x, &axis)));
        let unknown = Extreme { value: attained, point: *x, direction: SVector::zeros() };
        let mut found = worst.unwrap_or(unknown);
        if self.worse(attained, found.value) {
            found.value = attained;
        }
        found
    }
}

/// Encloses each constant over the region, from the formula of the metric.
///
/// A claim is proved if it is on the right side of both bounds, and right to within their
/// difference if it is between them. A claim that the bounds contradict is refused; the fault shows
/// the point to which an ascent from the box leads. If the boxes run out, the bounds reached so far
/// may still prove or refute the claim, but without a point. Nothing is tried in more than three
/// dimensions, or if the formula cannot be recorded or is not known to be symmetric. The standing of each constant says which of
/// these cases it was.
pub(super) fn constants<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let (metric, region) = (&case.metric, &case.region);
    let constants = metric.constants();
    let claimed = |claim: Claim| Some((claim, claim.of(&constants)?));
    let claims = Claim::ALL.into_iter().filter_map(claimed);
    let unrecorded = metric.metric.formula().and_then(Formula::symmetric).err();
    let is_recorded = unrecorded.is_none();
    let untried = || {
        let standings = claims.clone().map(|(claim, _)| Standing { claim, proof: Proof::NotTried });
        let tried = unrecorded.map_or(Tried::cases(0), |error| Tried::none(error.to_string()));
        Tried { standings: standings.collect(), ..tried }
    };
    // In more dimensions branch and bound takes too many boxes for a test.
    if D > 3 || !is_recorded {
        return Ok(untried());
    }
    let failure = |fault| case.effort.failure(fault);
    let corner = |share| region.at(&SVector::repeat(share));
    let cell = Cell::new(corner(0.0).as_slice(), corner(1.0).as_slice());
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
        let top = claim.climb(
            metric,
            region,
            claim.at(metric, &SVector::from_column_slice(&found.at), attained),
        );
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
