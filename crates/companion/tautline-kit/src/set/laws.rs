//! The laws of a closed set, each checked on random samples.

use std::cell::Cell;

use nalgebra::SVector;
use tautline::Interval;
use tautline_statements::extreme_eigenvalues;

use super::Case;
use crate::{
    Fault,
    margin::IDLE,
    region::directions,
    report::{LawResult, Tried},
};

/// The cubes from which points are projected are larger than the region by these factors, so that
/// the projections include members outside the region.
const FAR: [f64; 3] = [1.0, 8.0, 512.0];

/// The step of the differences of `P`, relative to the longest edge. It is a power of two.
const STEP: f64 = 1.0 / 131_072.0;

/// `P` counts as smooth at a point if its forward and backward difference quotients differ by at
/// most this number. Their difference is about `h |D²P|`. The error of the central difference is
/// then `h² |D³P|/6`, which is far below `OFF` if `|D³P|` is of the size of `|D²P|²` or `|D²P|/ℓ`.
const SMOOTH: f64 = 1e-3;

/// The accuracy of a central difference of a smooth `P`. It covers the truncation error (see above)
/// and the rounding `ε |x|/h` of points of the size of the region.
const OFF: f64 = 1e-5;

impl<const D: usize> Case<'_, D> {
    /// Returns the rounding error of a coordinate of `P(x)`, which is a hundred roundings of
    /// numbers of the size of `x`, of the region, and of `P(x)`.
    fn rounding(&self, points: &[&SVector<f64, D>]) -> f64 {
        let size = points.iter().map(|x| x.norm()).fold(self.region.reach(), f64::max);
        64.0 * (D as f64).sqrt() * f64::EPSILON * size
    }

    /// Checks a law at the projections of near and far points.
    fn at_members(
        &self,
        law: impl Fn(&SVector<f64, D>, &SVector<f64, D>) -> Result<f64, Fault>,
    ) -> LawResult {
        FAR.into_iter().try_fold(Tried::cases(0), |tried, far| {
            let samples = (self.region.points(), directions::<D>());
            Ok(tried.and(self.effort.for_all(samples, |(x, w)| {
                let y = x + w * (self.region.reach() * (far - 1.0));
                law(&y, &self.set.project(&y))
            })?))
        })
    }
}

/// Returns the rounding error of the entries of `DP`, which are at most 1 and have about `D²`
/// roundings each.
const fn derivative_rounding(dimension: usize) -> f64 {
    64.0 * (dimension * dimension) as f64 * f64::EPSILON
}

/// Checks that `P(x)` and `DP(x)` are finite, and that repeated calls return the same `P(x)`.
pub(super) fn finite<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.at_points(|x| {
        let (p, point) = (case.set.project(x), x.as_slice());
        Fault::unless_at_most("|P(x)| < ∞", [p.norm(), f64::MAX], 0.0, point)?;
        let off = (case.set.project(x) - p).norm();
        Fault::unless_zero("P(x) is the same each time", off, 0.0, point)?;
        // The sum is NaN if an entry is NaN.
        let size = case.set.projection_derivative(x).abs().sum();
        Fault::unless_at_most("|DP(x)| < ∞", [size, f64::MAX], 0.0, point)?;
        Ok(f64::INFINITY)
    })
}

/// Checks `P(P(x)) = P(x)`.
pub(super) fn idempotent<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.at_points(|x| {
        let p = case.set.project(x);
        let moved = (case.set.project(&p) - p).norm();
        Fault::unless_zero("P(P(x)) = P(x)", moved, case.rounding(&[x, &p]), x.as_slice())
    })
}

/// Checks that no member is nearer to `x` than `P(x)`. The members compared are the seeds and
/// `P(y)` for an arbitrary `y`, for a `y` near `x`, near `P(x)`, or near their midpoint.
pub(super) fn nearest<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let samples = (case.region.pairs(), directions::<D>(), 1..=12_i32);
    case.effort.for_all(samples, |([x, y], w, halvings)| {
        let p = case.set.project(x);
        let step = case.region.size() * 0.5_f64.powi(*halvings);
        let others = [*y, x + w * step, p + w * step, (x + p) * 0.5 + w * step];
        let others = others.into_iter().chain(case.set.seeds());
        others.map(|other| case.set.project(&other)).try_fold(f64::INFINITY, |least: f64, q| {
            let pair = [(x - p).norm(), (x - q).norm()];
            let granted = case.rounding(&[x, &p, &q]);
            let law = "|x − P(x)| ≤ |x − member|";
            let found = Fault::unless_at_most(law, pair, granted, x.as_slice());
            Ok(least.min(found.map_err(|fault| fault.with_member(q.as_slice()))?))
        })
    })
}

/// Checks that the norm of a member does not exceed the radius.
pub(super) fn radius<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let Some(radius) = case.set.radius() else { return Ok(Tried::none("claims no bound")) };
    case.at_members(|y, member| {
        let granted = case.rounding(&[y, member]);
        Fault::unless_at_most("|member| ≤ radius", [member.norm(), radius], granted, y.as_slice())
    })
}

/// Checks that no member lies outside the enclosing ball.
pub(super) fn ball<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let Some((centre, radius)) = case.set.enclosing_ball() else {
        return Ok(Tried::none("claims no bound"));
    };
    case.at_members(|y, member| {
        let granted = case.rounding(&[y, member, &centre]);
        let away = (member - centre).norm();
        Fault::unless_at_most("|member − centre| ≤ radius", [away, radius], granted, y.as_slice())
    })
}

/// Checks a set that claims to be convex: `P` does not expand, the angles between `x − P(x)` and
/// the directions from `P(x)` into the set are at least right angles, the midpoint of two members
/// is a member, the eigenvalues of `DP` lie in `[0, 1]`, and there are no seeds.
pub(super) fn convex<const D: usize>(case: &Case<'_, D>) -> LawResult {
    if !case.set.is_convex() {
        return Ok(Tried::none("claims no convexity"));
    }
    let seeds = case.set.seeds();
    let first = seeds.first().map_or(&[][..], |seed| seed.as_slice());
    Fault::unless_zero("a convex set has no seeds", seeds.len() as f64, 0.0, first)
        .map_err(|fault| case.effort.failure(fault))?;
    case.effort.for_all(case.region.pairs(), |[x, y]| {
        let (p, q) = (case.set.project(x), case.set.project(y));
        let (point, granted) = (x.as_slice(), case.rounding(&[x, y, &p, &q]));
        let pair = [(p - q).norm(), (x - y).norm()];
        let overestimation =
            Fault::unless_at_most("|P(x) − P(y)| ≤ |x − y|", pair, granted, point)?;
        let angle = (x - p).dot(&(q - p));
        // The error of each factor is the rounding times the size of the other factor.
        let lengths = (x - p).norm() + (q - p).norm();
        let law = "(x − P(x))·(member − P(x)) ≤ 0";
        Fault::unless_at_most(law, [angle, 0.0], granted * (lengths + granted), point)
            .map_err(|fault| fault.with_member(q.as_slice()))?;
        let middle = (p + q) * 0.5;
        let off = (case.set.project(&middle) - middle).norm();
        let law = "the midpoint of two members is a member";
        Fault::unless_zero(law, off, granted, middle.as_slice())?;
        let (low, high) = extreme_eigenvalues(&case.set.projection_derivative(x));
        let granted = derivative_rounding(D);
        Fault::unless_at_most("0 ≤ eigenvalues of DP(x)", [-low, 0.0], granted, point)?;
        Fault::unless_at_most("eigenvalues of DP(x) ≤ 1", [high, 1.0], granted, point)?;
        Ok(overestimation)
    })
}

/// Checks that `DP` is symmetric, and that it is the derivative of `P` where `P` is smooth.
pub(super) fn derivative<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let step = case.region.size() * STEP;
    let smooth = Cell::new(0_u64);
    let tried = case.at_points(|x| {
        let derivative = case.set.projection_derivative(x);
        let skew = (derivative - derivative.transpose()).norm();
        Fault::unless_zero("|DP(x) − DP(x)ᵀ| = 0", skew, derivative_rounding(D), x.as_slice())?;
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
            let granted = OFF + case.rounding(&[x, &p]) / step;
            let law = "|DP(x) eⱼ − its central difference| = O(h²)";
            Fault::unless_zero(law, off, granted, x.as_slice())?;
        }
        Ok(f64::INFINITY)
    })?;
    if smooth.get() == 0 && tried.cases > 0 {
        let why = "P is smooth at none of the samples".to_owned();
        return Err(case.effort.failure(Fault::NoSample { why }));
    }
    Ok(tried.with_note(format!("smooth at {} of them", smooth.get())))
}

/// Checks that seeds are members, and that the nearest member of a union is the nearest member of
/// one of its pieces.
pub(super) fn seeds_and_pieces<const D: usize>(case: &Case<'_, D>) -> LawResult {
    for seed in case.set.seeds() {
        let off = (case.set.project(&seed) - seed).norm();
        let granted = case.rounding(&[&seed]);
        Fault::unless_zero("a seed is a member", off, granted, seed.as_slice())
            .map_err(|fault| case.effort.failure(fault))?;
    }
    case.at_points(|x| {
        let p = case.set.project(x);
        let pieces = case.set.pieces().into_iter();
        let nearest =
            pieces.map(|piece| (piece.project(x) - x).norm()).fold(f64::INFINITY, f64::min);
        if nearest == f64::INFINITY {
            return Ok(IDLE);
        }
        let law = "the nearest piece is as near as the union";
        let off = (nearest - (p - x).norm()).abs();
        Fault::unless_zero(law, off, case.rounding(&[x, &p]), x.as_slice())
    })
}

/// Checks that the box that is claimed to contain a member is as small as rounding, lies in the set
/// up to rounding, and is as near to `x` as `P(x)`. The author of the set must prove that the box
/// contains a member, since no sample can decide it.
pub(super) fn proved_members<const D: usize>(case: &Case<'_, D>) -> LawResult {
    if case.set.member_near(&case.on_diagonal(0.5)).is_none() {
        return Ok(Tried::none("proves no members"));
    }
    case.at_points(|x| {
        let p = case.set.project(x);
        let granted = case.rounding(&[x, &p]);
        for y in [x, &p] {
            let (near, point) = (case.set.member_near(y), y.as_slice());
            let near = near.unwrap_or_else(|| SVector::repeat(Interval::UNDEFINED));
            let width = near.map(|side| side.width()).norm();
            Fault::unless_zero("a box about a member, of no width", width, granted, point)?;
            let middle = near.map(|side| side.midpoint());
            let off = (case.set.project(&middle) - middle).norm();
            Fault::unless_zero("|P(y) − y| = 0 in a box about a member", off, granted, point)?;
            let pair = [(y - middle).norm(), (y - case.set.project(y)).norm()];
            let law = "|x − box about a member| ≤ |x − P(x)|";
            Fault::unless_at_most(law, pair, granted, point)?;
        }
        Ok(f64::INFINITY)
    })
}
