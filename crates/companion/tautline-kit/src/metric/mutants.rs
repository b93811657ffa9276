//! Wrong metrics and wrong input, which the library must refuse.

use nalgebra::{SMatrix, SVector};
use tautline::{
    Bounded, ClosedSet, Ends, HalfSpace, Metric, Options, Point, PointSequence, Rule, Scalar,
    minimise,
};
use tautline_statements::{AnyBounded, WithConstants};

use super::{
    case::Case,
    claims::{Found, search},
    formula,
};
use crate::{
    Claim, Failure, Fault,
    report::{LawResult, Tried},
};

impl Claim {
    /// Returns the factor by which the wrong constant is multiplied.
    fn mistake(self) -> f64 {
        match self {
            Claim::C1 => 1.05,
            Claim::C2 => 0.95,
            Claim::LH | Claim::MH => 0.9,
        }
    }
}

/// Makes one constant wrong, and fails if the search does not notice it.
///
/// If the overestimation of the claim itself exceeds the mistake, the wrong constant still holds in
/// this region, and there is nothing to refuse. A note says so.
pub(super) fn constant<const D: usize>(case: &Case<'_, D>, constant: Claim) -> LawResult {
    let found = match search(case, constant) {
        Ok(Some(found)) => found,
        Ok(None) => return Ok(Tried::none("not claimed")),
        // A separate law reports the false claim.
        Err(Failure { fault: Fault::Lie(_), .. }) => {
            return Ok(Tried::none("the claim itself does not hold"));
        }
        Err(failure) => return Err(failure),
    };
    let factor = constant.mistake();
    // If the mistake hardly exceeds the overestimation, it would only show in the last digits.
    if !(found.overestimation < 1.0 + 0.9 * (factor.max(1.0 / factor) - 1.0)) {
        return Ok(Tried::none(match found.overestimation {
            overestimation if overestimation.is_finite() => {
                format!("not sharp in this region: overestimation {overestimation:.3}")
            }
            _ => "constant here: no mistake shows".to_owned(),
        }));
    }
    let Some(constants) = constant.scaled(&case.metric.constants(), factor) else {
        return Ok(Tried::none("the mistake contradicts c1 ≤ c2"));
    };
    // The samples differ from those that showed the claim to be sharp.
    let effort = case.effort.with_seed(case.effort.seed.wrapping_add(1));
    let wrong = search(&case.claiming(constants, effort), constant);
    verdict(found, wrong.map_err(|failure| failure.fault))
        .map_err(|fault| case.effort.failure(fault))
}

/// Judges the search for a wrong constant, which must find the mistake.
fn verdict(truth: Found, search: Result<Option<Found>, Fault>) -> Result<Tried, Fault> {
    match search {
        Err(Fault::Lie(_)) => {
            Ok(Tried { overestimation: truth.overestimation, ..Tried::cases(truth.cases) })
        }
        _ => Err(Fault::NotRefused { what: "a wrong constant" }),
    }
}

/// Counts the refusals, and fails unless every case was refused.
fn refused<const D: usize>(case: &Case<'_, D>, what: &'static str, refusals: &[bool]) -> LawResult {
    if refusals.iter().all(|&refused| refused) {
        Ok(Tried::cases(refusals.len() as u64))
    } else {
        Err(case.effort.failure(Fault::NotRefused { what }))
    }
}

/// Checks that points and sequences with a coordinate that is not finite are refused.
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

/// Checks that `N = 0` is refused.
pub(super) fn no_subinterval<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let [a, b] = [0.25, 0.75].map(|fraction| case.region.at(&SVector::repeat(fraction)));
    let solved = Ends::points(a, b).map(|ends| {
        minimise(&&case.metric, &ends, Rule::TRAPEZOIDAL, 0, &Options::default()).is_ok()
    });
    let refusals = [solved == Ok(false), PointSequence::straight(a, b, 0).is_err()];
    refused(case, "N = 0", &refusals)
}

/// Checks that two half-spaces are refused, since Proposition 7.1 needs a bounded set.
pub(super) fn two_unbounded_sets<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let half_space = |sign: f64| {
        let normal = SVector::from_fn(|i, _| if i == 0 { sign } else { 0.0 });
        HalfSpace::<D>::at_least(normal, case.region.size())
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

/// Checks that a problem with an empty set is refused.
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

impl<const D: usize> Metric<D> for Torn<'_, D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let mut h = self.metric.gram(x);
        // To the right of the middle this is the root of a negative number, times 0.
        h[(0, 0)] += (-x[0] + self.from).sqrt() * 0.0;
        h
    }
}

/// Checks the same formula with half of the region outside its domain, which must be refused.
pub(super) fn nan_metric<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let from = case.region.at(&SVector::repeat(0.5))[0];
    let metric = Torn { metric: &case.metric, from };
    let torn = WithConstants { metric, constants: case.metric.constants() };
    let found = formula::finite_and_symmetric(&Case::new(&torn, case.region, case.effort));
    let is_found = matches!(found, Err(Failure { fault: Fault::Metric(_), .. }));
    refused(case, "a metric that is NaN in half of the region", &[is_found])
}

#[cfg(test)]
mod tests {
    use tautline::gallery::Valleys;
    use tautline_statements::WithConstants;

    use super::{Found, constant, refused, verdict};
    use crate::{Claim, Effort, Fault, Lie, Region, metric::Case};

    fn case(metric: &impl tautline::Bounded<2>) -> Case<'_, 2> {
        Case::new(metric, Region::cell([0.0, 0.0], [6.3, 6.3]), Effort::default())
    }

    #[test]
    fn an_unnoticed_mistake_is_a_fault() {
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
    fn one_missing_refusal_is_a_fault() {
        assert!(refused(&case(&Valleys), "it", &[true, true]).is_ok_and(|tried| tried.cases == 2));
        let failure = refused(&case(&Valleys), "it", &[true, false, true]).expect_err("the second");
        assert_eq!(failure.fault, Fault::NotRefused { what: "it" });
    }

    /// With half of `L_H` the law about `L_H` itself already fails.
    #[test]
    fn a_false_claim_is_not_made_worse() {
        let claimed = tautline::Bounded::<2>::constants(&Valleys);
        let constants = Claim::LH.scaled(&claimed, 0.5).expect("in order");
        let tried = constant(&case(&WithConstants { metric: Valleys, constants }), Claim::LH);
        let note = tried.expect("a note").note;
        assert_eq!(note.as_deref(), Some("the claim itself does not hold"));
    }
}
