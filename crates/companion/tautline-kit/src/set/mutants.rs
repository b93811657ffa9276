//! Sets with one mistake, which the laws must refuse.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline::{ClosedSet, Interval};

use super::{Case, laws};
use crate::{
    Fault,
    report::{LawResult, Tried},
};

/// The mistake in a [`Mutant`].
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mistake {
    /// The nearest point is computed for a point that is this far away along the first axis.
    NearestBeside(f64),
    /// The nearest point is replaced by the point halfway to it.
    Halfway,
    /// The radius is multiplied by this factor.
    Radius(f64),
    /// The radius of the enclosing ball is multiplied by this factor.
    Ball(f64),
    /// The derivative is doubled.
    Derivative,
    /// The box around a member is moved by this distance along the first axis.
    MemberBeside(f64),
}

/// A set with one mistake.
#[derive(Clone, Copy, Debug)]
struct Mutant<'a, const D: usize> {
    set: &'a dyn ClosedSet<D>,
    mistake: Mistake,
}

impl<const D: usize> ClosedSet<D> for Mutant<'_, D> {
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        let p = self.set.project(x);
        match self.mistake {
            Mistake::NearestBeside(by) if p != *x => {
                let mut beside = *x;
                beside[0] += by;
                self.set.project(&beside)
            }
            Mistake::Halfway => (p + x) * 0.5,
            _ => p,
        }
    }

    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        let derivative = self.set.projection_derivative(x);
        if self.mistake == Mistake::Derivative { derivative * 2.0 } else { derivative }
    }

    fn radius(&self) -> Option<f64> {
        let factor = if let Mistake::Radius(factor) = self.mistake { factor } else { 1.0 };
        self.set.radius().map(|radius| radius * factor)
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        let factor = if let Mistake::Ball(factor) = self.mistake { factor } else { 1.0 };
        self.set.enclosing_ball().map(|(centre, radius)| (centre, radius * factor))
    }

    fn is_convex(&self) -> bool {
        self.set.is_convex()
    }

    fn pieces(&self) -> Vec<Arc<dyn ClosedSet<D>>> {
        self.set.pieces()
    }

    fn seeds(&self) -> Vec<SVector<f64, D>> {
        self.set.seeds()
    }

    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        let mut member = self.set.member_near(x)?;
        if let Mistake::MemberBeside(by) = self.mistake {
            member[0] += Interval::point(by);
        }
        Some(member)
    }
}

type Law<const D: usize> = fn(&Case<'_, D>) -> LawResult;

/// Fails unless one of the laws refuses the mutant.
fn refused<const D: usize>(
    case: &Case<'_, D>,
    mistake: Mistake,
    what: &'static str,
    laws: &[Law<D>],
) -> LawResult {
    let mutant = Mutant { set: case.set, mistake };
    let mutated = Case { set: &mutant, ..*case };
    if laws.iter().any(|law| law(&mutated).is_err()) {
        Ok(Tried::cases(1))
    } else {
        Err(case.effort.failure(Fault::NotRefused { what }))
    }
}

/// Returns five points on the diagonal of the region with their projections.
fn projected<const D: usize>(case: &Case<'_, D>) -> [[SVector<f64, D>; 2]; 5] {
    [0.0, 0.25, 0.5, 0.75, 1.0].map(|fraction| {
        let x = case.on_diagonal(fraction);
        [x, case.set.project(&x)]
    })
}

/// Checks that the nearest point for another point is refused.
pub(super) fn beside<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let by = 0.25 * case.region.size();
    let moves = (1..=32).any(|k| {
        // The points lie off the diagonal: their coordinates are the fractional parts of k/32 times
        // 1, 3, 5, ….
        let odd = |i: usize, _| (f64::from(k) / 32.0 * (2 * i + 1) as f64).fract();
        let x = case.region.at(&SVector::from_fn(odd));
        let mut y = x;
        y[0] += by;
        let (p, q) = (case.set.project(&x), case.set.project(&y));
        p != x && (x - q).norm() - (x - p).norm() > 1e-6 * case.region.size()
    });
    if !moves {
        return Ok(Tried::none("the nearest points do not change"));
    }
    let what = "a nearest point of another place";
    refused(case, Mistake::NearestBeside(by), what, &[laws::nearest, laws::idempotent])
}

/// Checks that a nearest point outside the set is refused.
pub(super) fn halfway<const D: usize>(case: &Case<'_, D>) -> LawResult {
    if projected(case).iter().all(|[x, p]| x == p) {
        return Ok(Tried::none("the set contains the region"));
    }
    refused(case, Mistake::Halfway, "a nearest point outside of the set", &[laws::idempotent])
}

/// Checks that a radius ten percent too small is refused, if the claimed one is attained to within
/// five percent.
pub(super) fn small_radius<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let bounded = case.set.radius().is_some();
    small(case, bounded, Mistake::Radius(0.9), "a radius that is too small", laws::radius)
}

/// Checks that an enclosing ball ten percent too small is refused, if the claimed one is attained
/// to within five percent.
pub(super) fn small_ball<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let bounded = case.set.enclosing_ball().is_some();
    small(case, bounded, Mistake::Ball(0.9), "a ball that is too small", laws::ball)
}

fn small<const D: usize>(
    case: &Case<'_, D>,
    bounded: bool,
    mistake: Mistake,
    what: &'static str,
    law: Law<D>,
) -> LawResult {
    // If the claim itself is false, the law for it already fails.
    let Ok(tried) = law(case) else { return Ok(Tried::none("the claim itself does not hold")) };
    if tried.overestimation < 1.05 {
        return refused(case, mistake, what, &[law]);
    }
    Ok(Tried::none(match tried.overestimation {
        _ if !bounded => "claims no bound".to_owned(),
        f64::INFINITY => "the radius is 0".to_owned(),
        overestimation => format!("not attained: overestimation {overestimation:.3}"),
    }))
}

/// Checks that a derivative twice too large is refused, if it is not zero.
pub(super) fn derivative<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let seen = projected(case);
    let apart = |[_, p]: &[SVector<f64, D>; 2]| (p - seen[0][1]).norm() > 1e-3 * case.region.size();
    if !seen.iter().any(apart) {
        return Ok(Tried::none("the nearest points do not change"));
    }
    if seen.iter().all(|[x, _]| case.set.projection_derivative(x).amax() == 0.0) {
        return Ok(Tried::none("the derivative is zero"));
    }
    refused(case, Mistake::Derivative, "a wrong derivative", &[laws::derivative])
}

/// Checks that a box around a member that is off by a millionth of the region is refused.
pub(super) fn member<const D: usize>(case: &Case<'_, D>) -> LawResult {
    if case.set.member_near(&case.on_diagonal(0.5)).is_none() {
        return Ok(Tried::none("proves no members"));
    }
    let mistake = Mistake::MemberBeside(1e-6 * case.region.size());
    refused(case, mistake, "a member that is none", &[laws::proved_members])
}
