//! The laws about claimed constants, checked at random samples and by local ascents from the best
//! samples.

use std::cell::RefCell;

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric};

use super::{
    Case,
    extreme::{Extreme, norm},
};
use crate::{
    Claim, Failure, Fault, Lie,
    region::directions,
    report::{LawResult, Tried},
};

impl Claim {
    /// Returns the claimed value, or `None` if `M_H` is not claimed.
    #[must_use]
    pub fn of(self, constants: &Constants) -> Option<f64> {
        match self {
            Claim::C1 => Some(constants.c1()),
            Claim::C2 => Some(constants.c2()),
            Claim::LH => Some(constants.l_h()),
            Claim::MH => constants.m_h(),
        }
    }

    /// Returns the constants with this one multiplied by `factor`, if they are still valid.
    pub(super) fn scaled(self, constants: &Constants, factor: f64) -> Option<Constants> {
        let by = |constant| if self == constant { factor } else { 1.0 };
        constants.times(Claim::ALL.map(by)).ok()
    }

    /// Returns the rounding error of a value, in the unit of the constant.
    ///
    /// An entry of `H` has about a dozen roundings of terms of size `c₂`, and an eigenvalue has `D`
    /// times as many. Derivatives have more terms, which are of the size of the constants
    /// themselves.
    fn rounding<const D: usize>(self, constants: &Constants, claimed: f64) -> f64 {
        match self {
            Claim::C1 | Claim::C2 => 1e-14 * D as f64 * constants.c2(),
            Claim::LH | Claim::MH => 1e-12 * claimed,
        }
    }
}

/// A point, with the value of `H` there.
type Place<const D: usize> = (SVector<f64, D>, SMatrix<f64, D, D>);

/// The result of the search for the extreme value of one constant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// The number of samples.
    pub(super) cases: u64,
    /// The overestimation `claimed / found` (for `c₁`, `found / claimed`), a pure number. It is `∞`
    /// if no change of the metric was observed.
    pub(super) overestimation: f64,
}

/// Searches for the extreme value of one constant; returns `Ok(None)` if the constant is not
/// claimed.
pub(super) fn search<const D: usize>(
    case: &Case<'_, D>,
    constant: Claim,
) -> Result<Option<Found>, Failure> {
    case.solved.extremes.recall(&constant, || search_anew(case, constant))
}

fn search_anew<const D: usize>(
    case: &Case<'_, D>,
    constant: Claim,
) -> Result<Option<Found>, Failure> {
    let (metric, region, effort) = (&case.metric, &case.region, &case.effort);
    let constants = metric.constants();
    let Some(claimed) = constant.of(&constants) else { return Ok(None) };
    let judge = |found: &Extreme<D>| judge(constant, &constants, claimed, found);
    let seen: RefCell<Vec<Extreme<D>>> = RefCell::default();
    let random = effort.for_all((region.points(), directions::<D>()), |(x, w)| {
        let found = constant.measure(metric, x, w);
        seen.borrow_mut().push(found);
        judge(&found).map_err(Fault::from)
    });
    let mut starts = seen.into_inner();
    starts.sort_by(|a, b| {
        let (a, b) = (a.value, b.value);
        if constant == Claim::C1 { a.total_cmp(&b) } else { b.total_cmp(&a) }
    });
    starts.truncate(effort.ascents);
    let tops = starts.into_iter().map(|start| constant.climb(metric, region, start));
    let top = constant.worst(tops).map(|worst| judge(&worst));
    match (random, top) {
        (Ok(tried), top) => {
            let top = top.unwrap_or(Ok(f64::INFINITY)).map_err(|lie| effort.failure(lie))?;
            let overestimation = tried.overestimation.min(top);
            Ok(Some(Found { cases: tried.cases, overestimation }))
        }
        // The shrunk sample has short coordinates, and the top of the ascent has the extreme value.
        (Err(failure), Some(Err(lie))) => Err(Failure { fault: lie.into(), ..failure }),
        (Err(failure), _) => Err(failure),
    }
}

/// Returns the overestimation of a claim, given an extreme value, or an error if the claim is
/// false.
pub(super) fn judge<const D: usize>(
    constant: Claim,
    constants: &Constants,
    claimed: f64,
    &Extreme { value: found, point, direction }: &Extreme<D>,
) -> Result<f64, Lie> {
    let granted = constant.rounding::<D>(constants, claimed);
    let (holds, overestimation) = match constant {
        Claim::C1 => (claimed <= found + granted, found / claimed),
        // For a constant metric the quotient would be 0/0.
        _ if found == 0.0 => (found <= claimed + granted, f64::INFINITY),
        _ => (found <= claimed + granted, claimed / found),
    };
    if holds {
        return Ok(overestimation);
    }
    let [point, direction] = [point, direction].map(|x| x.as_slice().to_vec());
    Err(Lie { constant, claimed, found, point, direction, other: None })
}

/// Checks that one constant holds at random points and at the tops of local ascents.
pub(super) fn claim<const D: usize>(case: &Case<'_, D>, constant: Claim) -> LawResult {
    Ok(match search(case, constant)? {
        None => Tried::none("not claimed"),
        Some(Found { cases, overestimation }) => Tried { overestimation, ..Tried::cases(cases) },
    })
}

/// The largest number of times that a chord is halved. The halves get as short as `2⁻¹⁸` of the
/// longest edge; over this length a jump of `H` by `δ` has the quotient `2¹⁸ δ` per edge.
const HALVINGS: i32 = 18;

/// Checks `‖H(x) − H(y)‖ ≤ L_H |x − y|` for points far apart and close together.
///
/// The quotient of a chord is at most the larger of the quotients of its two halves. Keeping the
/// half with the larger quotient therefore never lowers it: it tends to a slope, or grows without
/// bound where `H` jumps.
pub(super) fn lipschitz<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let (c2, l_h) = (case.metric.constants().c2(), case.metric.constants().l_h());
    // The allowance covers the roundings of H(x) and of H(y), see `Claim::rounding`.
    let granted = 2e-14 * D as f64 * c2;
    let shortest = case.region.size() * 0.5_f64.powi(HALVINGS);
    let gram = |x: &SVector<f64, D>| case.metric.gram::<f64>(x);
    let quotient = |[x, y]: [&Place<D>; 2]| norm(&(x.1 - y.1)) / (x.0 - y.0).norm();
    case.effort.for_all(case.region.pairs(), |pair| {
        let mut overestimation = f64::INFINITY;
        let mut worst: Option<Lie> = None;
        let [mut x, mut y] = pair.map(|x| (x, gram(&x)));
        for _ in 0..=HALVINGS {
            let (found, step) = (quotient([&x, &y]), (x.0 - y.0).norm());
            if !(found * step <= l_h * step + granted) {
                // A NaN counts as the worst quotient.
                if worst.as_ref().is_none_or(|worst| !(found <= worst.found)) {
                    worst = Some(Lie {
                        constant: Claim::LH,
                        claimed: l_h,
                        found,
                        point: x.0.as_slice().to_vec(),
                        direction: ((y.0 - x.0) / step).as_slice().to_vec(),
                        other: Some(y.0.as_slice().into()),
                    });
                }
            } else if granted <= 0.01 * found * step {
                overestimation = overestimation.min(l_h / found);
            }
            if step <= 2.0 * shortest || found.is_nan() {
                break;
            }
            let middle = (x.0 + y.0) * 0.5;
            let middle = (middle, gram(&middle));
            if quotient([&x, &middle]) >= quotient([&middle, &y]) {
                y = middle;
            } else {
                x = middle;
            }
        }
        worst.map_or(Ok(overestimation), |lie| Err(lie.into()))
    })
}
