//! The laws of a closed set.
//!
//! One function a law, of the name that its test has in [`set_suite!`](crate::set_suite).

mod laws;
mod liar;

use tautline::ClosedSet;

use super::{Effort, Outcome, Region, Report};

/// A closed set, where to look, and for how long.
///
/// The region should reach beyond the set, or beyond its boundary if it is unbounded.
#[derive(Clone, Copy, Debug)]
pub struct SetCase<'a, S, const D: usize> {
    set: &'a S,
    region: Region<D>,
    effort: Effort,
}

impl<'a, S: ClosedSet<D>, const D: usize> SetCase<'a, S, D> {
    /// A closed set and the region from which points are sent to it.
    pub fn new(set: &'a S, region: Region<D>, effort: Effort) -> Self {
        Self { set, region, effort }
    }
}

/// The laws, one a row: its name, what it says, and the function that tries it.
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
            a_claim_of_convexity_is_true, "|P(x) − P(y)| ≤ |x − y|, middles are members",
                laws::convex;
            derivative_is_that_of_the_projection, "DP is symmetric, and the limit of differences",
                laws::derivative;
            seeds_and_pieces_belong_to_the_set, "seeds are members, pieces make up the set",
                laws::seeds_and_pieces;
            proved_members_are_nearest_members, "a box about a member lies in the set, near x",
                laws::proved_members;
            refuses_a_nearest_point_of_another_place, "P(x + s) in place of P(x) is refused",
                liar::beside;
            refuses_a_nearest_point_outside, "(x + P(x))/2 in place of P(x) is refused",
                liar::halfway;
            refuses_a_smaller_radius, "0.9 radius is refused, if it is attained",
                liar::small_radius;
            refuses_a_smaller_enclosing_ball, "0.9 of its radius is refused, if it is attained",
                liar::small_ball;
            refuses_a_wrong_derivative, "2 DP in place of DP is refused",
                liar::derivative;
            refuses_a_member_that_is_none, "a box beside P(x) is refused",
                liar::member;
        }
    };
}

/// One function a law, their names, and all of them in a row.
macro_rules! functions {
    ({} $($id:ident, $law:literal, $run:expr;)*) => {
        $(
            #[doc = concat!("Tries the law `", stringify!($id), "`: `", $law, "`.")]
            pub fn $id<S: ClosedSet<D>, const D: usize>(case: &SetCase<'_, S, D>) -> Outcome {
                let run: fn(&SetCase<'_, S, D>) -> super::report::LawResult = $run;
                Outcome::new(stringify!($id), $law, run(case))
            }
        )*

        /// The names of all laws, in the order of a report.
        pub const LAWS: &[&str] = &[$(stringify!($id)),*];

        /// Tries all laws on a closed set.
        pub fn verify_set<S: ClosedSet<D>, const D: usize>(
            set: &S,
            region: &Region<D>,
            effort: &Effort,
        ) -> Report {
            let case = SetCase::new(set, *region, *effort);
            Report { outcomes: vec![$($id(&case)),*] }
        }
    };
}

__set_laws! { [functions] {} }
