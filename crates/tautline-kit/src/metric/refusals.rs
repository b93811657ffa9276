//! What has to be refused: samples that are wrong on purpose.

use std::cell::Cell;

use nalgebra::{SMatrix, SVector};
use tautline::{
    Bounded, ClosedSet, Ends, HalfSpace, Options, Point, PointSequence, SetError, Trapezoidal,
    minimise,
};
use tautline_statements::AnyBounded;

use super::{
    case::Case,
    claims::{Found, search},
    problems::Posed,
};
use crate::{
    Claim, Failure, Fault,
    report::{LawResult, Tried},
};

impl Claim {
    /// The lie that is told of it: `c₁` five percent too large, `c₂` as much too small, `L_H` and
    /// `M_H` ten percent too small.
    fn lie(self) -> f64 {
        match self {
            Claim::C1 => 1.05,
            Claim::C2 => 0.95,
            Claim::LH | Claim::MH => 0.9,
        }
    }
}

/// Tells a lie about one constant, and fails if nobody notices.
///
/// If the claim itself is looser than the lie, the lie is true in this region, and there is
/// nothing to refuse; the looseness is noted.
pub(super) fn lie<const D: usize>(case: &Case<'_, D>, constant: Claim) -> LawResult {
    let found = match search(case, constant) {
        Ok(Some(found)) => found,
        Ok(None) => return Ok(Tried::cases(0).with_note("not claimed")),
        // It has a law of its own.
        Err(Failure { fault: Fault::Lie(_), .. }) => {
            return Ok(Tried::cases(0).with_note("the claim itself does not hold"));
        }
        Err(failure) => return Err(failure),
    };
    let factor = constant.lie();
    let looseness = factor.max(1.0 / factor);
    // Beyond this the lie would have to be noticed by its last digits.
    if !(found.overestimation < 1.0 + 0.9 * (looseness - 1.0)) {
        let overestimation = found.overestimation;
        return Ok(Tried::cases(0).with_note(if overestimation.is_finite() {
            format!("not sharp in this region: looseness {overestimation:.3}")
        } else {
            "constant here: there is no lie to tell".to_owned()
        }));
    }
    let Some(constants) = constant.scaled(&case.metric.constants(), factor) else {
        return Ok(Tried::cases(0).with_note("the lie contradicts c1 ≤ c2"));
    };
    // Other samples than those by which the claim was found to be sharp.
    let effort = case.effort.with_seed(case.effort.seed.wrapping_add(1));
    let liar = case.claiming(constants, effort);
    verdict(found, search(&liar, constant).map_err(|failure| failure.fault))
        .map_err(|fault| Failure { fault, sample: None, seed: case.effort.seed })
}

/// Judges the search for a lie: it has to end with that lie.
fn verdict(truth: Found, search: Result<Option<Found>, Fault>) -> Result<Tried, Fault> {
    match search {
        Err(Fault::Lie(_)) => {
            Ok(Tried { overestimation: truth.overestimation, ..Tried::cases(truth.cases) })
        }
        _ => Err(Fault::NotRefused { what: "a wrong constant" }),
    }
}

/// Counts the refusals, and fails at the first thing that is not refused.
fn refused<const D: usize>(case: &Case<'_, D>, what: &'static str, refusals: &[bool]) -> LawResult {
    if refusals.iter().all(|&refused| refused) {
        Ok(Tried::cases(refusals.len() as u64))
    } else {
        let fault = Fault::NotRefused { what };
        Err(Failure { fault, sample: None, seed: case.effort.seed })
    }
}

/// Points and curves with a coordinate that is no number.
pub(super) fn nan_points<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let good = case.region.at(&SVector::repeat(0.5));
    let refusals: Vec<bool> = (0..D)
        .flat_map(|i| [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(|value| (i, value)))
        .map(|(i, value)| {
            let mut bad = good;
            bad[i] = value;
            PointSequence::new(vec![good, bad]).is_err()
                && Ends::points(good, bad).is_err()
                && Ends::points(bad, good).is_err()
        })
        .collect();
    refused(case, "a point that is not finite", &refusals)
}

/// `N = 0`.
pub(super) fn no_subinterval<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let [a, b] = [0.25, 0.75].map(|fraction| case.region.at(&SVector::repeat(fraction)));
    let ends = Posed::between(a, b).ends();
    let solved = ends
        .map(|ends| minimise(&&case.metric, &ends, Trapezoidal, 0, &Options::default()).is_ok());
    let refusals = [solved == Ok(false), PointSequence::straight(a, b, 0).is_err()];
    refused(case, "N = 0", &refusals)
}

/// Two half-spaces: Proposition 7.1 wants one of the sets bounded.
pub(super) fn two_unbounded_sets<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let half_space = |sign: f64| -> Result<HalfSpace<D>, SetError> {
        let normal = SVector::from_fn(|i, _| if i == 0 { sign } else { 0.0 });
        HalfSpace::at_least(normal, case.region.size())
    };
    let ends = half_space(1.0).and_then(|right| Ends::new(half_space(-1.0)?, right));
    refused(case, "a pair of unbounded sets", &[ends.is_err()])
}

/// The empty set, which has no nearest points.
#[derive(Clone, Copy, Debug)]
struct Empty;

impl<const D: usize> ClosedSet<D> for Empty {
    fn project(&self, _: &SVector<f64, D>) -> SVector<f64, D> {
        SVector::repeat(f64::NAN)
    }

    fn projection_derivative(&self, _: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        SMatrix::zeros()
    }

    fn radius(&self) -> Option<f64> {
        Some(0.0)
    }
}

/// A problem to which one of the sets is empty.
pub(super) fn empty_set<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let point = || Point::new(case.region.at(&SVector::repeat(0.5)));
    let refusals = [
        point().and_then(|point| Ends::new(Empty, point)).is_err(),
        point().and_then(|point| Ends::new(point, Empty)).is_err(),
    ];
    refused(case, "an empty set", &refusals)
}

/// `H` with an entry that is NaN on one side of the middle of the region.
#[derive(Clone, Copy, Debug)]
struct Torn<'a, const D: usize> {
    metric: &'a AnyBounded<'a, D>,
    from: f64,
}

impl<const D: usize> tautline::Metric<D> for Torn<'_, D> {
    fn gram<S: tautline::Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let mut h = self.metric.gram(x);
        // √ of a negative number right of the middle; 0 · √ elsewhere.
        h[(0, 0)] += (-x[0] + self.from).sqrt() * 0.0;
        h
    }
}

impl<const D: usize> Bounded<D> for Torn<'_, D> {
    fn constants(&self) -> tautline::Constants {
        self.metric.constants()
    }
}

/// The same formula where half of the region is outside of its domain.
pub(super) fn nan_metric<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let from = case.region.at(&SVector::repeat(0.5))[0];
    let torn = Torn { metric: &case.metric, from };
    let torn = Case::new(&torn, case.region, case.effort);
    let found = Cell::new(false);
    if let Err(Failure { fault: Fault::Metric(_), .. }) =
        super::formula::finite_and_symmetric(&torn)
    {
        found.set(true);
    }
    refused(case, "a metric that is NaN in half of the region", &[found.get()])
}

#[cfg(test)]
mod tests {
    use tautline::gallery::Valleys;
    use tautline_statements::WithConstants;

    use super::{Found, lie, refused, verdict};
    use crate::{Claim, Effort, Fault, Lie, Region, metric::Case};

    fn case(metric: &impl tautline::Bounded<2>) -> Case<'_, 2> {
        Case::new(metric, Region::cell([0.0, 0.0], [6.3, 6.3]), Effort::default())
    }

    #[test]
    fn a_lie_that_nobody_notices_is_a_fault() {
        let found = || Found { cases: 7, overestimation: 1.0 };
        let lie = Lie {
            constant: Claim::C2,
            claimed: 1.0,
            found: 1.1,
            point: vec![0.0],
            direction: vec![1.0],
            other: None,
        };
        assert!(verdict(found(), Err(lie.into())).is_ok_and(|tried| tried.cases == 7));
        let another = Fault::NoSample { why: "none".to_owned() };
        for search in [Ok(Some(found())), Ok(None), Err(another)] {
            let refused = Fault::NotRefused { what: "a wrong constant" };
            assert_eq!(verdict(found(), search), Err(refused));
        }
    }

    #[test]
    fn one_thing_that_is_not_refused_is_a_fault() {
        assert!(refused(&case(&Valleys), "it", &[true, true]).is_ok_and(|tried| tried.cases == 2));
        let failure = refused(&case(&Valleys), "it", &[true, false, true]).expect_err("the second");
        assert_eq!(failure.fault, Fault::NotRefused { what: "it" });
    }

    /// Half of `L_H`: the law about `L_H` fails, and there is no other lie to tell.
    #[test]
    fn no_lie_is_told_of_a_claim_that_does_not_hold() {
        let claimed = tautline::Bounded::<2>::constants(&Valleys);
        let constants = Claim::LH.scaled(&claimed, 0.5).expect("in order");
        let tried = lie(&case(&WithConstants { metric: Valleys, constants }), Claim::LH);
        let note = tried.expect("a note").note;
        assert_eq!(note.as_deref(), Some("the claim itself does not hold"));
    }
}
