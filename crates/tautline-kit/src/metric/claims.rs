//! The laws of a metric that claims constants: at random samples, and where they are looked for.

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
    sampling::{CHEAP, for_all},
};

impl Claim {
    /// Returns what is claimed; `None` for `M_H` if it is not.
    #[must_use]
    pub fn of(self, constants: &Constants) -> Option<f64> {
        match self {
            Claim::C1 => Some(constants.c1()),
            Claim::C2 => Some(constants.c2()),
            Claim::LH => Some(constants.l_h()),
            Claim::MH => constants.m_h(),
        }
    }

    /// Returns the claim with its number multiplied by `factor`, if it is one of the constants.
    pub(super) fn scaled(self, constants: &Constants, factor: f64) -> Option<Constants> {
        let by = |constant| if self == constant { factor } else { 1.0 };
        constants.times([Claim::C1, Claim::C2, Claim::LH, Claim::MH].map(by)).ok()
    }

    /// What rounding makes of a value, in the unit of the constant.
    ///
    /// An entry of `H` has a dozen roundings or so of terms of size `c₂`, an eigenvalue `D` times
    /// as many; derivatives have more terms, of the size of the constants themselves.
    fn rounding<const D: usize>(self, constants: &Constants, claimed: f64) -> f64 {
        match self {
            Claim::C1 | Claim::C2 => 1e-14 * D as f64 * constants.c2(),
            Claim::LH | Claim::MH => 1e-12 * claimed,
        }
    }
}

/// A point with `H` there.
type Place<const D: usize> = (SVector<f64, D>, SMatrix<f64, D, D>);

/// What was found of one constant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// How often the metric was measured at a sample.
    pub(super) cases: u64,
    /// The overestimation `claimed / found` (of `c₁`, `found / claimed`), a pure number; `∞` if the
    /// metric was not seen to change at all.
    pub(super) overestimation: f64,
}

/// Looks for the extreme value of one constant; `Ok(None)` if it is not claimed.
pub(super) fn search<const D: usize>(
    case: &Case<'_, D>,
    constant: Claim,
) -> Result<Option<Found>, Failure> {
    case.solved.extremes.recall(&constant, || look(case, constant))
}

fn look<const D: usize>(case: &Case<'_, D>, constant: Claim) -> Result<Option<Found>, Failure> {
    let (metric, region, effort) = (&case.metric, &case.region, &case.effort);
    let constants = metric.constants();
    let Some(claimed) = constant.of(&constants) else { return Ok(None) };
    let judge = |found: &Extreme<D>| judge(constant, &constants, claimed, found);
    let seen: RefCell<Vec<Extreme<D>>> = RefCell::default();
    let samples = (region.points(), directions::<D>());
    let random = for_all(effort, effort.cases, CHEAP, samples, |(x, w)| {
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
    let worst = tops.reduce(|a, b| if constant.worse(b.value, a.value) { b } else { a });
    match (random, worst) {
        (Ok(tried), None) => {
            Ok(Some(Found { cases: tried.cases, overestimation: tried.overestimation }))
        }
        (Ok(tried), Some(worst)) => match judge(&worst) {
            Ok(top) => Ok(Some(Found {
                cases: tried.cases,
                overestimation: tried.overestimation.min(top),
            })),
            Err(lie) => Err(Failure { fault: lie.into(), sample: None, seed: effort.seed }),
        },
        (Err(failure), None) => Err(failure),
        // The sample that was shrunk has short coordinates, the top of the ascent the right number.
        (Err(failure), Some(worst)) => Err(match judge(&worst) {
            Ok(_) => failure,
            Err(lie) => Failure { fault: lie.into(), ..failure },
        }),
    }
}

/// Returns the overestimation of a claim where something was found, or that it is a lie.
pub(super) fn judge<const D: usize>(
    constant: Claim,
    constants: &Constants,
    claimed: f64,
    found: &Extreme<D>,
) -> Result<f64, Lie> {
    let granted = constant.rounding::<D>(constants, claimed);
    let holds = match constant {
        Claim::C1 => claimed <= found.value + granted,
        _ => found.value <= claimed + granted,
    };
    if holds {
        Ok(overestimation(constant, claimed, found.value))
    } else {
        Err(lie(constant, claimed, found))
    }
}

fn overestimation(constant: Claim, claimed: f64, found: f64) -> f64 {
    match constant {
        Claim::C1 => found / claimed,
        // 0 / 0 for a constant metric.
        _ if found == 0.0 => f64::INFINITY,
        _ => claimed / found,
    }
}

fn lie<const D: usize>(constant: Claim, claimed: f64, found: &Extreme<D>) -> Lie {
    let Extreme { value, point, direction } = found;
    let [point, direction] = [point, direction].map(|x| x.as_slice().to_vec());
    Lie { constant, claimed, found: *value, point, direction, other: None }
}

/// Looks for a point where one constant does not hold.
pub(super) fn claim<const D: usize>(case: &Case<'_, D>, constant: Claim) -> LawResult {
    Ok(match search(case, constant)? {
        None => Tried::cases(0).with_note("not claimed"),
        Some(Found { cases, overestimation }) => Tried { overestimation, ..Tried::cases(cases) },
    })
}

/// How often a chord is halved at most: from the longest edge to its `2⁻¹⁸`-th part, over which a
/// jump of `H` by `δ` has a quotient of `2¹⁸ δ` an edge.
const HALVINGS: i32 = 18;

/// `‖H(x) − H(y)‖ ≤ L_H |x − y|` for points far apart and near each other.
///
/// The quotient of a chord is no more than the larger one of its halves, so that it never falls
/// where that half is taken: it climbs to a slope, or, where `H` jumps, without end.
pub(super) fn lipschitz<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let constants = case.metric.constants();
    let effort = &case.effort;
    // The roundings of H(x) and of H(y), see above.
    let granted = 2e-14 * D as f64 * constants.c2();
    let shortest = case.region.size() * 0.5_f64.powi(HALVINGS);
    let gram = |x: &SVector<f64, D>| case.metric.gram::<f64>(x);
    let quotient = |[x, y]: [&Place<D>; 2]| norm(&(x.1 - y.1)) / (x.0 - y.0).norm();
    for_all(effort, effort.cases, CHEAP, case.region.pairs(), |pair| {
        let mut overestimation = f64::INFINITY;
        let mut worst: Option<Lie> = None;
        let [mut x, mut y] = pair.map(|x| (x, gram(&x)));
        for _ in 0..=HALVINGS {
            let (found, step) = (quotient([&x, &y]), (x.0 - y.0).norm());
            if !(found * step <= constants.l_h() * step + granted) {
                // A NaN is as bad as it can be.
                if worst.as_ref().is_none_or(|worst| !(found <= worst.found)) {
                    worst = Some(Lie {
                        constant: Claim::LH,
                        claimed: constants.l_h(),
                        found,
                        point: x.0.as_slice().to_vec(),
                        direction: ((y.0 - x.0) / step).as_slice().to_vec(),
                        other: Some(y.0.as_slice().into()),
                    });
                }
            } else if granted <= 0.01 * found * step {
                overestimation = overestimation.min(constants.l_h() / found);
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
