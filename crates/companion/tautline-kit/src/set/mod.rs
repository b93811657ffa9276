//! The laws of a closed set.
//!
//! There is one function per law, with the same name as its test in
//! [`set_suite!`](crate::set_suite).

mod laws;
mod mutants;

use nalgebra::SVector;
use tautline::ClosedSet;

use super::{Effort, Fault, Region, Report, report::LawResult};

/// A closed set, the region to sample, and the effort.
///
/// The region should reach beyond the set, or beyond its boundary if the set is unbounded.
#[derive(Clone, Copy, Debug)]
pub struct SetCase<'a, S, const D: usize> {
    set: &'a S,
    region: Region<D>,
    effort: Effort,
}

impl<'a, S: ClosedSet<D>, const D: usize> SetCase<'a, S, D> {
    /// Returns the case of a closed set and the region from which points are projected to it.
    pub fn new(set: &'a S, region: Region<D>, effort: Effort) -> Self {
        Self { set, region, effort }
    }

    fn erased(&self) -> Case<'a, D> {
        Case { set: self.set, region: self.region, effort: self.effort }
    }
}

/// The case that the laws use. The type of the set is erased, so that the laws are compiled once.
#[derive(Clone, Copy)]
struct Case<'a, const D: usize> {
    set: &'a dyn ClosedSet<D>,
    region: Region<D>,
    effort: Effort,
}

impl<const D: usize> Case<'_, D> {
    fn at_points(&self, law: impl Fn(&SVector<f64, D>) -> Result<f64, Fault>) -> LawResult {
        self.effort.for_all(self.region.points(), law)
    }

    /// Returns a point on the diagonal of the region.
    fn on_diagonal(&self, fraction: f64) -> SVector<f64, D> {
        self.region.at(&SVector::repeat(fraction))
    }
}

/// The laws, one per row: its name, its content, and the function that checks it.
#[doc(hidden)]
#[macro_export]
macro_rules! __set_laws {
    ([$($callback:tt)*] $context:tt) => {
        $($callback)*! { $context
            outputs_are_finite, "P(x) and DP(x) are finite, and the same each time",
                laws::finite;
            projection_is_idempotent, "P(P(x)) = P(x)",
                laws::idempotent;
            no_member_is_nearer, "|x − P(x)| ≤ |x − member|",
                laws::nearest;
            radius_bounds_the_members, "|member| ≤ radius",
                laws::radius;
            enclosing_ball_holds_the_members, "|member − centre| ≤ radius of the enclosing ball",
                laws::ball;
            a_claim_of_convexity_is_true, "|P(x) − P(y)| ≤ |x − y|, midpoints are members",
                laws::convex;
            derivative_is_that_of_the_projection, "DP is symmetric, and the limit of differences",
                laws::derivative;
            seeds_and_pieces_belong_to_the_set, "seeds are members, pieces make up the set",
                laws::seeds_and_pieces;
            proved_members_are_nearest_members, "a box about a member lies in the set, near x",
                laws::proved_members;
            refuses_a_nearest_point_of_another_place, "P(x + s) in place of P(x) is refused",
                mutants::beside;
            refuses_a_nearest_point_outside, "(x + P(x))/2 in place of P(x) is refused",
                mutants::halfway;
            refuses_a_smaller_radius, "0.9 radius is refused, if it is attained",
                mutants::small_radius;
            refuses_a_smaller_enclosing_ball, "0.9 of its radius is refused, if it is attained",
                mutants::small_ball;
            refuses_a_wrong_derivative, "2 DP in place of DP is refused",
                mutants::derivative;
            refuses_a_member_that_is_none, "a box beside P(x) is refused",
                mutants::member;
        }
    };
}

__set_laws! {
    [super::laws::functions]
    { [S: ClosedSet<D>, const D: usize] SetCase<'_, S, D>, SetCase::erased }
}

/// Checks all laws of a closed set.
pub fn verify_set<S: ClosedSet<D>, const D: usize>(
    set: &S,
    region: &Region<D>,
    effort: &Effort,
) -> Report {
    verify(&SetCase::new(set, *region, *effort))
}
