//! The laws of a closed set, each at one sample.

use nalgebra::SVector;
use tautline::{ClosedSet, Interval};
use tautline_statements::extreme_eigenvalues;

use super::SetCase;
use crate::{
    Failure, Fault,
    met::IDLE,
    region::directions,
    report::{LawResult, Tried},
    sampling::{CHEAP, for_all},
};

/// How much larger than the region the cubes are from which points are sent to the set: a set that
/// is larger than the region shows there.
const FAR: [f64; 3] = [1.0, 8.0, 512.0];

/// The step of the differences of `P`, relative to the longest edge; a power of two.
const STEP: f64 = 1.0 / 131_072.0;

/// A place counts as smooth if the differences of `P` to both sides differ by no more than this:
/// `h |D²P|`. The central difference is then off by `h² |D³P|/6`, which for `|D³P|` of the size of
/// `|D²P|²` or `|D²P|/ℓ` is far below `OFF`.
const SMOOTH: f64 = 1e-3;

/// Accuracy of a central difference of a smooth `P`: its truncation, above, and the rounding
/// `ε |x|/h` of points of the size of the region.
const OFF: f64 = 1e-5;

/// What rounding makes of a coordinate of `P(x)`: a hundred roundings of numbers of the size of
/// `x`, of the region, and of `P(x)`.
fn rounding<S: ClosedSet<D>, const D: usize>(
    case: &SetCase<'_, S, D>,
    points: &[&SVector<f64, D>],
) -> f64 {
    let size = points.iter().map(|x| x.norm()).fold(case.region.reach(), f64::max);
    64.0 * (D as f64).sqrt() * f64::EPSILON * size
}

/// `P(x)` is finite, and the same each time.
pub(super) fn finite<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let effort = &case.effort;
    for_all(effort, effort.cases, CHEAP, case.region.points(), |x| {
        let p = case.set.project(x);
        let size = p.norm();
        Fault::unless_at_most("|P(x)| < ∞", [size, f64::MAX], 0.0, x.as_slice())?;
        let off = (case.set.project(x) - p).norm();
        Fault::unless_at_most("P(x) is the same each time", [off, 0.0], 0.0, x.as_slice())?;
        let derivative = case.set.projection_derivative(x);
        let largest = derivative.iter().fold(0.0, |largest: f64, entry| {
            // `max` would drop a NaN.
            if largest.is_nan() || entry.abs() <= largest { largest } else { entry.abs() }
        });
        Fault::unless_at_most("|DP(x)| < ∞", [largest, f64::MAX], 0.0, x.as_slice())?;
        Ok(f64::INFINITY)
    })
}

/// `P(P(x)) = P(x)`.
pub(super) fn idempotent<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let effort = &case.effort;
    for_all(effort, effort.cases, CHEAP, case.region.points(), |x| {
        let p = case.set.project(x);
        let moved = (case.set.project(&p) - p).norm();
        Fault::unless_at_most(
            "P(P(x)) = P(x)",
            [moved, 0.0],
            rounding(case, &[x, &p]),
            x.as_slice(),
        )
    })
}

/// No member is nearer to `x` than `P(x)`: not `P(y)` for any other `y`, nor for a `y` near `x`,
/// near `P(x)`, or on the way from one to the other.
pub(super) fn nearest<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let effort = &case.effort;
    let samples = (case.region.pairs(), directions::<D>(), 1..=12_i32);
    for_all(effort, effort.cases, CHEAP, samples, |([x, y], w, halvings)| {
        let p = case.set.project(x);
        let step = case.region.size() * 0.5_f64.powi(*halvings);
        let others = [*y, x + w * step, p + w * step, (x + p) * 0.5 + w * step];
        others.iter().chain(&case.set.seeds()).try_fold(
            f64::INFINITY,
            |overestimation: f64, other| {
                let q = case.set.project(other);
                let pair = [(x - p).norm(), (x - q).norm()];
                let granted = rounding(case, &[x, &p, &q]);
                let law = "|x − P(x)| ≤ |x − member|";
                let found = Fault::unless_at_most(law, pair, granted, x.as_slice());
                Ok(overestimation.min(found.map_err(|fault| fault.with_member(q.as_slice()))?))
            },
        )
    })
}

/// No member is longer than the radius; the members are looked for far out, too.
pub(super) fn radius<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let Some(radius) = case.set.radius() else {
        return Ok(Tried::cases(0).with_note("unbounded, it says"));
    };
    members(case, |y, member| {
        let granted = rounding(case, &[y, member]);
        Fault::unless_at_most("|member| ≤ radius", [member.norm(), radius], granted, y.as_slice())
    })
}

/// No member is outside of the enclosing ball; the members are looked for far out, too.
pub(super) fn ball<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let Some((centre, radius)) = case.set.enclosing_ball() else {
        return Ok(Tried::cases(0).with_note("unbounded, it says"));
    };
    members(case, |y, member| {
        let granted = rounding(case, &[y, member, &centre]);
        let away = (member - centre).norm();
        Fault::unless_at_most("|member − centre| ≤ radius", [away, radius], granted, y.as_slice())
    })
}

/// A law at the projections of points near and far.
fn members<S: ClosedSet<D>, const D: usize>(
    case: &SetCase<'_, S, D>,
    law: impl Fn(&SVector<f64, D>, &SVector<f64, D>) -> Result<f64, Fault>,
) -> LawResult {
    let effort = &case.effort;
    let mut tried = Tried::cases(0);
    for far in FAR {
        let samples = (case.region.points(), directions::<D>());
        tried = tried.and(for_all(effort, effort.cases, CHEAP, samples, |(x, w)| {
            let y = x + w * (case.region.reach() * (far - 1.0));
            law(&y, &case.set.project(&y))
        })?);
    }
    Ok(tried)
}

/// A set that says it is convex: `P` does not expand, `x − P(x)` and the set make obtuse angles,
/// the middle of two members is a member, `DP` has its eigenvalues in `[0, 1]`, and there are no
/// seeds.
pub(super) fn convex<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let effort = &case.effort;
    if !case.set.is_convex() {
        return Ok(Tried::cases(0).with_note("not convex, as far as it says"));
    }
    if let Some(seed) = case.set.seeds().first() {
        let fault = Fault::Broken {
            law: "a convex set has no seeds",
            left: case.set.seeds().len() as f64,
            right: 0.0,
            granted: 0.0,
            point: seed.as_slice().to_vec(),
            other: None,
        };
        return Err(Failure { fault, sample: None, seed: effort.seed });
    }
    for_all(effort, effort.cases, CHEAP, case.region.pairs(), |[x, y]| {
        let (p, q) = (case.set.project(x), case.set.project(y));
        let granted = rounding(case, &[x, y, &p, &q]);
        let pair = [(p - q).norm(), (x - y).norm()];
        let overestimation =
            Fault::unless_at_most("|P(x) − P(y)| ≤ |x − y|", pair, granted, x.as_slice())?;
        let angle = (x - p).dot(&(q - p));
        // Each factor is off by the rounding, the other one of the size of the lengths.
        let lengths = (x - p).norm() + (q - p).norm();
        let law = "(x − P(x))·(member − P(x)) ≤ 0";
        Fault::unless_at_most(law, [angle, 0.0], granted * (lengths + granted), x.as_slice())
            .map_err(|fault| fault.with_member(q.as_slice()))?;
        let middle = (p + q) * 0.5;
        let off = (case.set.project(&middle) - middle).norm();
        let law = "the middle of two members is a member";
        Fault::unless_at_most(law, [off, 0.0], granted, middle.as_slice())?;
        let (low, high) = extreme_eigenvalues(&case.set.projection_derivative(x));
        // Entries up to 1 with D² roundings or so.
        let granted = 64.0 * (D * D) as f64 * f64::EPSILON;
        Fault::unless_at_most("0 ≤ eigenvalues of DP(x)", [-low, 0.0], granted, x.as_slice())?;
        Fault::unless_at_most("eigenvalues of DP(x) ≤ 1", [high, 1.0], granted, x.as_slice())?;
        Ok(overestimation)
    })
}

/// `DP` is symmetric, and the derivative of `P` where that is smooth.
pub(super) fn derivative<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let effort = &case.effort;
    let step = case.region.size() * STEP;
    let smooth = std::cell::Cell::new(0_u64);
    let tried = for_all(effort, effort.cases, CHEAP, case.region.points(), |x| {
        let derivative = case.set.projection_derivative(x);
        let skew = (derivative - derivative.transpose()).norm();
        let granted = 64.0 * (D * D) as f64 * f64::EPSILON;
        Fault::unless_at_most("|DP(x) − DP(x)ᵀ| = 0", [skew, 0.0], granted, x.as_slice())?;
        let p = case.set.project(x);
        let mut columns = Vec::with_capacity(D);
        for j in 0..D {
            let mut h = SVector::zeros();
            h[j] = step;
            let (right, left) = (case.set.project(&(x + h)), case.set.project(&(x - h)));
            if !(((right - p) - (p - left)).norm() <= SMOOTH * step) {
                return Ok(IDLE);
            }
            columns.push((right - left) / (2.0 * step));
        }
        smooth.set(smooth.get() + 1);
        for (j, column) in columns.iter().enumerate() {
            let off = (derivative.column(j) - column).norm();
            let granted = OFF + rounding(case, &[x, &p]) / step;
            let law = "|DP(x) eⱼ − its central difference| = O(h²)";
            Fault::unless_at_most(law, [off, 0.0], granted, x.as_slice())?;
        }
        Ok(f64::INFINITY)
    })?;
    if smooth.get() == 0 && tried.cases > 0 {
        let why = "P is smooth at none of the samples".to_owned();
        return Err(Failure { fault: Fault::NoSample { why }, sample: None, seed: effort.seed });
    }
    let note = format!("smooth at {} of them", smooth.get());
    Ok(tried.with_note(note))
}

/// Seeds are members, and the nearest member of a union is that of one of its pieces.
pub(super) fn seeds_and_pieces<S: ClosedSet<D>, const D: usize>(
    case: &SetCase<'_, S, D>,
) -> LawResult {
    let effort = &case.effort;
    let members = |point: &SVector<f64, D>| {
        let off = (case.set.project(point) - point).norm();
        let granted = rounding(case, &[point]);
        Fault::unless_at_most("a seed is a member", [off, 0.0], granted, point.as_slice())
    };
    for seed in case.set.seeds() {
        members(&seed).map_err(|fault| Failure { fault, sample: None, seed: effort.seed })?;
    }
    for_all(effort, effort.cases, CHEAP, case.region.points(), |x| {
        let p = case.set.project(x);
        let pieces = case.set.pieces().iter();
        let nearest =
            pieces.map(|piece| (piece.project(x) - x).norm()).fold(f64::INFINITY, f64::min);
        if nearest == f64::INFINITY {
            return Ok(IDLE);
        }
        let law = "the nearest piece is as near as the union";
        let off = (nearest - (p - x).norm()).abs();
        Fault::unless_at_most(law, [off, 0.0], rounding(case, &[x, &p]), x.as_slice())
    })
}

/// The box that is said to contain a member is as small as rounding, lies in the set up to
/// rounding, and as near to `x` as `P(x)`. That a member lies in it is the author's proof: no
/// sample decides that.
pub(super) fn proved_members<S: ClosedSet<D>, const D: usize>(
    case: &SetCase<'_, S, D>,
) -> LawResult {
    let effort = &case.effort;
    let at = |fraction: f64| case.region.at(&SVector::repeat(fraction));
    if case.set.member_near(&at(0.5)).is_none() {
        return Ok(Tried::cases(0).with_note("it proves no members"));
    }
    for_all(effort, effort.cases, CHEAP, case.region.points(), |x| {
        let p = case.set.project(x);
        for y in [x, &p] {
            let near = case.set.member_near(y);
            let near = near.unwrap_or_else(|| SVector::repeat(Interval::UNDEFINED));
            let granted = rounding(case, &[x, &p]);
            let width = near.map(|side| side.width()).norm();
            let law = "a box about a member, of no width";
            Fault::unless_at_most(law, [width, 0.0], granted, y.as_slice())?;
            let middle = near.map(|side| side.midpoint());
            let off = (case.set.project(&middle) - middle).norm();
            let law = "|P(y) − y| = 0 in a box about a member";
            Fault::unless_at_most(law, [off, 0.0], granted, y.as_slice())?;
            let pair = [(y - middle).norm(), (y - case.set.project(y)).norm()];
            let law = "|x − box about a member| ≤ |x − P(x)|";
            Fault::unless_at_most(law, pair, granted, y.as_slice())?;
        }
        Ok(f64::INFINITY)
    })
}
