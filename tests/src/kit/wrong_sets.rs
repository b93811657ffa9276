//! Closed sets that lie: each is rejected, by the law that it breaks, with the numbers.

use tautline::{Ball, Interval, Sphere};
use tautline_kit::{Fault, SetCase, prelude::*, set};

fn region() -> Region<2> {
    Region::cell([-4.0, -4.0], [4.0, 4.0])
}

/// The unit circle, with one thing said of it that is not so.
#[derive(Clone, Copy, Debug, Default)]
struct Circle {
    /// Its nearest points are turned by this angle.
    turned: f64,
    /// This much is missing of its radius.
    missing: f64,
    /// This much is missing of the radius of its enclosing ball.
    tight: f64,
    /// It says that it is convex.
    convex: bool,
    /// Its derivative is off by this much in one entry.
    off: f64,
    /// It has a seed in its middle.
    seed: bool,
    /// Its proved members are this far beside.
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

/// Fails unless the law is broken by the set; returns the two sides of its inequality.
#[track_caller]
fn broken(circle: Circle, id: &str) -> [f64; 2] {
    let report = verify_set(&circle, &region(), &Effort::default());
    let outcome = report.of(id).expect("a law");
    match outcome.failure.as_ref().map(|failure| &failure.fault) {
        Some(&Fault::Broken { left, right, .. }) => [left, right],
        _ => panic!("{report}"),
    }
}

#[test]
fn the_circle_itself_passes() {
    let report = verify_set(&Circle::default(), &region(), &Effort::default());
    assert!(report.holds(), "{report}");
}

/// One degree off: the projections lie in the set and stay there, but others are nearer.
#[test]
fn nearest_points_beside_the_nearest_are_refused() {
    let turned = 1_f64.to_radians();
    let [left, right] = broken(Circle { turned, ..Circle::default() }, "no_member_is_nearer");
    assert!(left > right);
}

#[test]
fn a_radius_that_misses_one_percent_is_refused() {
    let circle = Circle { missing: 0.015, ..Circle::default() };
    let [left, right] = broken(circle, "radius_bounds_the_members");
    assert_eq!(right, 1.485);
    // There is no lie to tell of a radius that is one.
    let case = SetCase::new(&circle, region(), Effort::default());
    let note = set::refuses_a_smaller_radius(&case).note;
    assert_eq!(note.as_deref(), Some("the claim itself does not hold"));
    assert!(left > right && left <= 1.5 + 1e-12);
}

#[test]
fn an_enclosing_ball_that_misses_one_percent_is_refused() {
    let circle = Circle { tight: 0.01, ..Circle::default() };
    let [left, right] = broken(circle, "enclosing_ball_holds_the_members");
    assert_eq!(right, 0.99);
    assert!(left > right && left <= 1.0 + 1e-12);
}

#[test]
fn a_circle_is_not_convex() {
    let circle = Circle { convex: true, ..Circle::default() };
    let [left, right] = broken(circle, "a_claim_of_convexity_is_true");
    assert!(left > right);
}

#[test]
fn a_derivative_that_is_off_by_one_thousandth_is_refused() {
    let circle = Circle { off: 1e-3, ..Circle::default() };
    let [left, right] = broken(circle, "derivative_is_that_of_the_projection");
    assert!((left - right - 1e-3).abs() <= 1e-5);
}

#[test]
fn proved_members_that_are_a_billionth_beside_are_refused() {
    let circle = Circle { beside: 1e-9, ..Circle::default() };
    let [left, right] = broken(circle, "proved_members_are_nearest_members");
    assert!(left > right && left < 1.01e-9, "{left} {right}");
}

#[test]
fn a_seed_that_is_no_member_is_refused() {
    let circle = Circle { seed: true, ..Circle::default() };
    assert_eq!(broken(circle, "seeds_and_pieces_belong_to_the_set"), [1.0, 0.0]);
}

/// NaN on one side of a line, where a solver may never look.
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
    let outcome = set::outputs_are_finite(&SetCase::new(&Torn, region(), Effort::default()));
    let failure = outcome.failure.expect("it fails");
    let Fault::Broken { left, point, .. } = failure.fault else { panic!("{failure}") };
    // Shrunk to the first step beyond the line.
    assert!(left.is_nan() && point == [3.0 + 8.0 / 65536.0, -4.0], "{point:?}");
}

/// The law that a set breaks, of those about one thing.
#[track_caller]
fn law<S: ClosedSet<2>>(set: &S, id: fn(&SetCase<'_, S, 2>) -> Outcome) -> &'static str {
    match id(&SetCase::new(set, region(), Effort::default())).failure.expect("it fails").fault {
        Fault::Broken { law, .. } => law,
        fault => panic!("{fault}"),
    }
}

/// A ball of radius 100, in which the region lies: no sample of it is longer than 6.
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
    let wrong = Large(Some(50.0));
    assert_eq!(law(&wrong, set::radius_bounds_the_members), "|member| ≤ radius");
    for radius in [Some(100.0), None] {
        let right = Large(radius);
        let case = SetCase::new(&right, region(), Effort::default());
        assert!(set::radius_bounds_the_members(&case).holds());
    }
}

/// Two points `(±half, 0)`, as a set that says of itself what it is told to.
#[derive(Clone, Copy, Debug)]
struct Pair {
    half: f64,
    /// It says that it is convex.
    convex: bool,
    /// The right point is a seed, and the nearest of no other place.
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

/// No sample is sent to the right point, though half of them are nearer to it: it is known as a
/// seed alone.
#[test]
fn a_seed_that_is_nearer_is_a_member_that_is_nearer() {
    let pair = Pair { half: 1.03, convex: false, forgets: true };
    let case = SetCase::new(&pair, region(), Effort::default());
    let failure = set::no_member_is_nearer(&case).failure.expect("it fails");
    let Fault::Broken { law, other, .. } = failure.fault else { panic!("{failure}") };
    assert_eq!(law, "|x − P(x)| ≤ |x − member|");
    assert_eq!(other.as_deref(), Some([1.03, 0.0].as_slice()));
    assert!(set::seeds_and_pieces_belong_to_the_set(&case).holds());
    let right = Pair { forgets: false, ..pair };
    let case = SetCase::new(&right, region(), Effort::default());
    assert!(set::no_member_is_nearer(&case).holds());
}

/// So near to each other that samples in different cells are farther apart, and that angles are
/// obtuse up to rounding: `(x − P(x))·(q − P(x))` is `2 half²` at most, far below what is granted.
#[test]
fn the_middle_of_two_points_is_no_member() {
    let pair = Pair { half: 1e-8, convex: true, forgets: false };
    let found = law(&pair, set::a_claim_of_convexity_is_true);
    assert_eq!(found, "the middle of two members is a member");
    // Far from each other, it is the nearest points that give it away.
    let pair = Pair { half: 2.5, ..pair };
    assert_eq!(law(&pair, set::a_claim_of_convexity_is_true), "|P(x) − P(y)| ≤ |x − y|");
}
