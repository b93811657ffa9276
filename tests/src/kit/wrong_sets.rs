//! Each wrong closed set is refused by the law that it breaks, and the fault shows the numbers.

use tautline::{Ball, Interval, Sphere};
use tautline_kit::{Fault, SetCase, prelude::*, set};

use super::{broken, fault};

fn region() -> Region<2> {
    Region::cell([-4.0, -4.0], [4.0, 4.0])
}

/// The unit circle about `(½, 0)`, with the mistakes given by the fields; by default it has none.
#[derive(Clone, Copy, Debug, Default)]
struct Circle {
    /// The angle by which its nearest points are rotated.
    turned: f64,
    /// The amount by which its radius is too small.
    missing: f64,
    /// The amount by which the radius of its enclosing ball is too small.
    tight: f64,
    /// Whether it claims to be convex.
    convex: bool,
    /// The error in one entry of its derivative.
    off: f64,
    /// Whether it has a seed at its centre, which is not a member.
    seed: bool,
    /// The distance by which its proved members are moved.
    beside: f64,
}

impl Circle {
    fn circle() -> Sphere<2> {
        Sphere::new([0.5, 0.0], 1.0).expect("a radius")
    }
}

impl ClosedSet<2> for Circle {
    fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        let centre = SVector::from([0.5, 0.0]);
        let p = Self::circle().project(x);
        if p == *x || self.turned == 0.0 {
            return p;
        }
        let (sin, cos) = self.turned.sin_cos();
        let z = p - centre;
        centre + SVector::from([cos * z[0] - sin * z[1], sin * z[0] + cos * z[1]])
    }

    fn projection_derivative(&self, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        let mut derivative = Self::circle().projection_derivative(x);
        derivative[(0, 0)] += self.off;
        derivative
    }

    fn radius(&self) -> Option<f64> {
        Self::circle().radius().map(|radius| radius - self.missing)
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, 2>, f64)> {
        Self::circle().enclosing_ball().map(|(centre, radius)| (centre, radius - self.tight))
    }

    fn member_near(&self, x: &SVector<f64, 2>) -> Option<SVector<Interval, 2>> {
        let mut member = Self::circle().member_near(x)?;
        if self.beside != 0.0 {
            member[0] += Interval::point(self.beside);
        }
        Some(member)
    }

    fn is_convex(&self) -> bool {
        self.convex
    }

    fn seeds(&self) -> Vec<SVector<f64, 2>> {
        if self.seed { vec![[0.5, 0.0].into()] } else { Vec::new() }
    }
}

fn case<S: ClosedSet<2>>(set: &S) -> SetCase<'_, S, 2> {
    SetCase::new(set, region(), Effort::default())
}

#[test]
fn the_circle_itself_passes() {
    let report = verify_set(&Circle::default(), &region(), &Effort::default());
    assert!(report.holds(), "{report}");
}

/// Each mistake is refused by the law about it, and the two sides of the violated inequality show
/// the size of the mistake.
#[test]
fn mistakes_of_the_circle_are_refused() {
    type Sides = fn(f64, f64) -> bool;
    let circle = Circle::default();
    let mistakes: [(Circle, &str, Sides); 7] = [
        // One degree off: projected points lie in the set and stay fixed, but other members are
        // nearer.
        (Circle { turned: 1_f64.to_radians(), ..circle }, "no_member_is_nearer", |left, right| {
            left > right
        }),
        (Circle { missing: 0.015, ..circle }, "radius_bounds_the_members", |left, right| {
            right == 1.485 && left > right && left <= 1.5 + 1e-12
        }),
        (Circle { tight: 0.01, ..circle }, "enclosing_ball_holds_the_members", |left, right| {
            right == 0.99 && left > right && left <= 1.0 + 1e-12
        }),
        (Circle { convex: true, ..circle }, "a_claim_of_convexity_is_true", |left, right| {
            left > right
        }),
        (Circle { off: 1e-3, ..circle }, "derivative_is_that_of_the_projection", |left, right| {
            (left - right - 1e-3).abs() <= 1e-5
        }),
        (Circle { beside: 1e-9, ..circle }, "proved_members_are_nearest_members", |left, right| {
            left > right && left < 1.01e-9
        }),
        (Circle { seed: true, ..circle }, "seeds_and_pieces_belong_to_the_set", |left, right| {
            left == 1.0 && right == 0.0
        }),
    ];
    for (circle, id, expected) in mistakes {
        let report = verify_set(&circle, &region(), &Effort::default());
        let outcome = report.of(id).expect("a law");
        match outcome.failure.as_ref().map(|failure| &failure.fault) {
            Some(&Fault::Broken { left, right, .. }) if expected(left, right) => {}
            _ => panic!("{circle:?}: {report}"),
        }
    }
    let note = set::refuses_a_smaller_radius(&case(&Circle { missing: 0.015, ..circle })).note;
    assert_eq!(note.as_deref(), Some("the claim itself does not hold"));
}

/// The projection is NaN on one side of a line, where a solver may never look.
#[test]
fn a_projection_that_is_nan_is_refused() {
    #[derive(Clone, Copy, Debug)]
    struct Torn;
    impl ClosedSet<2> for Torn {
        fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
            if x[0] > 3.0 { SVector::repeat(f64::NAN) } else { SVector::zeros() }
        }
        fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
            SMatrix::zeros()
        }
        fn radius(&self) -> Option<f64> {
            Some(0.0)
        }
    }
    let fault = fault(set::outputs_are_finite(&case(&Torn)));
    let Fault::Broken { left, point, .. } = fault else { panic!("{fault}") };
    // The point is shrunk to the first step beyond the line.
    assert!(left.is_nan() && point == [3.0 + 8.0 / 65536.0, -4.0], "{point:?}");
}

/// The set is a ball of radius 100 that contains the region, so no sample has a norm larger than 6.
#[test]
fn a_radius_that_is_too_small_outside_of_the_region_is_refused() {
    #[derive(Clone, Copy, Debug)]
    struct Large(Option<f64>);
    impl ClosedSet<2> for Large {
        fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
            Ball::new([0.0, 0.0], 100.0).expect("a radius").project(x)
        }
        fn projection_derivative(&self, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
            Ball::new([0.0, 0.0], 100.0).expect("a radius").projection_derivative(x)
        }
        fn radius(&self) -> Option<f64> {
            self.0
        }
    }
    let wrong = set::radius_bounds_the_members(&case(&Large(Some(50.0))));
    assert_eq!(broken(wrong), "|member| ≤ radius");
    for radius in [Some(100.0), None] {
        assert!(set::radius_bounds_the_members(&case(&Large(radius))).holds());
    }
}

/// The two points `(±half, 0)`, with the mistakes given by the fields.
#[derive(Clone, Copy, Debug)]
struct Pair {
    half: f64,
    /// Whether it claims to be convex.
    convex: bool,
    /// Whether the right point is only a seed, to which nothing but itself is projected.
    forgets: bool,
}

impl ClosedSet<2> for Pair {
    fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        let right = if self.forgets { x[0] == self.half && x[1] == 0.0 } else { x[0] > 0.0 };
        SVector::from([if right { self.half } else { -self.half }, 0.0])
    }

    fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::zeros()
    }

    fn radius(&self) -> Option<f64> {
        Some(self.half)
    }

    fn is_convex(&self) -> bool {
        self.convex
    }

    fn seeds(&self) -> Vec<SVector<f64, 2>> {
        if self.forgets { vec![[self.half, 0.0].into()] } else { Vec::new() }
    }
}

/// No sample is projected to the right point, although half of the samples are nearer to it. The
/// kit knows the right point only as a seed.
#[test]
fn a_seed_that_is_nearer_is_a_member_that_is_nearer() {
    let pair = Pair { half: 1.03, convex: false, forgets: true };
    let nearer = fault(set::no_member_is_nearer(&case(&pair)));
    let Fault::Broken { law, other, .. } = nearer else { panic!("{nearer}") };
    assert_eq!(law, "|x − P(x)| ≤ |x − member|");
    assert_eq!(other.as_deref(), Some([1.03, 0.0].as_slice()));
    assert!(set::seeds_and_pieces_belong_to_the_set(&case(&pair)).holds());
    let right = Pair { forgets: false, ..pair };
    assert!(set::no_member_is_nearer(&case(&right)).holds());
}

/// The two points are closer together than any two samples in different cells, and the angles that
/// convexity requires to be obtuse are so up to rounding: `(x − P(x))·(q − P(x))` is at most
/// `2 half²`, far below the tolerance. Two points far apart break another law first.
#[test]
fn two_points_are_not_convex() {
    for (half, law) in
        [(1e-8, "the midpoint of two members is a member"), (2.5, "|P(x) − P(y)| ≤ |x − y|")]
    {
        let pair = Pair { half, convex: true, forgets: false };
        assert_eq!(broken(set::a_claim_of_convexity_is_true(&case(&pair))), law);
    }
}
