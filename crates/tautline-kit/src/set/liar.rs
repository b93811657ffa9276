//! Sets that lie: what the laws have to refuse.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline::{ClosedSet, Interval};

use super::{SetCase, laws};
use crate::{
    Failure, Fault,
    report::{LawResult, Tried},
};

/// What a [`Liar`] says that is not so.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Lie {
    /// The nearest point is that of a place beside, this far along the first axis.
    NearestBeside(f64),
    /// The nearest point lies halfway.
    Halfway,
    /// The radius is this many times what it is.
    Radius(f64),
    /// The radius of the enclosing ball is this many times what it is.
    Ball(f64),
    /// The derivative is twice what it is.
    Derivative,
    /// A box that contains a member lies this far along the first axis from where it should.
    MemberBeside(f64),
}

/// A set that lies about one thing.
#[derive(Clone, Copy, Debug)]
struct Liar<'a, S> {
    set: &'a S,
    lie: Lie,
}

impl<S: ClosedSet<D>, const D: usize> ClosedSet<D> for Liar<'_, S> {
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        let p = self.set.project(x);
        match self.lie {
            Lie::NearestBeside(by) if p != *x => {
                let mut beside = *x;
                beside[0] += by;
                self.set.project(&beside)
            }
            Lie::Halfway => (p + x) * 0.5,
            _ => p,
        }
    }

    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        let derivative = self.set.projection_derivative(x);
        if self.lie == Lie::Derivative { derivative * 2.0 } else { derivative }
    }

    fn radius(&self) -> Option<f64> {
        match self.lie {
            Lie::Radius(factor) => self.set.radius().map(|radius| radius * factor),
            _ => self.set.radius(),
        }
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        let (centre, radius) = self.set.enclosing_ball()?;
        match self.lie {
            Lie::Ball(factor) => Some((centre, radius * factor)),
            _ => Some((centre, radius)),
        }
    }

    fn is_convex(&self) -> bool {
        self.set.is_convex()
    }

    fn pieces(&self) -> &[Arc<dyn ClosedSet<D>>] {
        self.set.pieces()
    }

    fn seeds(&self) -> Vec<SVector<f64, D>> {
        self.set.seeds()
    }

    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        let mut member = self.set.member_near(x)?;
        if let Lie::MemberBeside(by) = self.lie {
            member[0] += Interval::point(by);
        }
        Some(member)
    }
}

/// A law of closed sets.
type Law<S, const D: usize> = fn(&SetCase<'_, S, D>) -> LawResult;

/// Puts a lie to the laws that should notice it.
fn refused<'a, S: ClosedSet<D>, const D: usize>(
    case: &SetCase<'a, S, D>,
    lie: Lie,
    what: &'static str,
    laws: &[Law<Liar<'a, S>, D>],
) -> LawResult {
    let set = Liar { set: case.set, lie };
    let liar = SetCase { set: &set, region: case.region, effort: case.effort };
    if laws.iter().any(|law| law(&liar).is_err()) {
        Ok(Tried::cases(1))
    } else {
        let fault = Fault::NotRefused { what };
        Err(Failure { fault, sample: None, seed: case.effort.seed })
    }
}

/// The projections of the samples of a region: whether they differ from the samples, and from
/// each other.
fn seen<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> (bool, bool) {
    let at = |fraction: f64| case.region.at(&SVector::repeat(fraction));
    let points = [0.0, 0.25, 0.5, 0.75, 1.0].map(at);
    let members = points.map(|x| case.set.project(&x));
    let outside = points.iter().zip(&members).any(|(x, p)| x != p);
    let apart = members.iter().any(|p| (p - members[0]).norm() > 1e-3 * case.region.size());
    (outside, apart)
}

/// A nearest point that is that of another place.
pub(super) fn beside<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let by = 0.25 * case.region.size();
    let moves = (1..=32).any(|k| {
        // Off the diagonal: k/32 times 1, 3, 5, …, without whole parts.
        let odd = |i: usize, _| (f64::from(k) / 32.0 * (2 * i + 1) as f64).fract();
        let x = case.region.at(&SVector::from_fn(odd));
        let mut y = x;
        y[0] += by;
        let (p, q) = (case.set.project(&x), case.set.project(&y));
        p != x && (x - q).norm() - (x - p).norm() > 1e-6 * case.region.size()
    });
    if !moves {
        return Ok(Tried::cases(0).with_note("the nearest points do not change"));
    }
    let what = "a nearest point of another place";
    refused(case, Lie::NearestBeside(by), what, &[laws::nearest, laws::idempotent])
}

/// A nearest point that is not in the set.
pub(super) fn halfway<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    if !seen(case).0 {
        return Ok(Tried::cases(0).with_note("the set contains the region"));
    }
    refused(case, Lie::Halfway, "a nearest point outside of the set", &[laws::idempotent])
}

/// A radius that is ten percent too small, if it is attained to five.
pub(super) fn small_radius<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let said = case.set.radius();
    small(case, said, laws::radius, Lie::Radius(0.9), "a radius that is too small", laws::radius)
}

/// An enclosing ball that is ten percent too small, if it is attained to five.
pub(super) fn small_ball<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    let said = case.set.enclosing_ball().map(|(_, radius)| radius);
    small(case, said, laws::ball, Lie::Ball(0.9), "a ball that is too small", laws::ball)
}

/// A radius that is too small, as `said`, where its `law` holds and is attained.
fn small<'a, S: ClosedSet<D>, const D: usize>(
    case: &SetCase<'a, S, D>,
    said: Option<f64>,
    law: Law<S, D>,
    lie: Lie,
    what: &'static str,
    refusing: Law<Liar<'a, S>, D>,
) -> LawResult {
    let Ok(tried) = law(case) else {
        // It has a law of its own.
        return Ok(Tried::cases(0).with_note("the claim itself does not hold"));
    };
    if !(tried.overestimation < 1.05) {
        let note = match said {
            None => "unbounded, it says".to_owned(),
            Some(_) if tried.overestimation == f64::INFINITY => "the radius is 0".to_owned(),
            Some(_) => format!("not attained: looseness {:.3}", tried.overestimation),
        };
        return Ok(Tried::cases(0).with_note(note));
    }
    refused(case, lie, what, &[refusing])
}

/// A derivative that is twice too large, if it is not zero.
pub(super) fn derivative<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    if !seen(case).1 {
        return Ok(Tried::cases(0).with_note("the nearest points do not change"));
    }
    let none = (0..5).all(|k| {
        let x = case.region.at(&SVector::repeat(f64::from(k) * 0.25));
        case.set.projection_derivative(&x).amax() == 0.0
    });
    if none {
        return Ok(Tried::cases(0).with_note("the derivative is zero"));
    }
    refused(case, Lie::Derivative, "a wrong derivative", &[laws::derivative])
}

/// A box that is said to contain a member, a millionth of the region beside where one is.
pub(super) fn member<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> LawResult {
    if case.set.member_near(&case.region.at(&SVector::repeat(0.5))).is_none() {
        return Ok(Tried::cases(0).with_note("it proves no members"));
    }
    let lie = Lie::MemberBeside(1e-6 * case.region.size());
    refused(case, lie, "a member that is none", &[laws::proved_members])
}
