//! Ends that touch: the solver returns no error, and every number is 0, up to what a contact is known.

use tautline::{
    AxisBox, Ball, Bounded, ClosedSet, Ends, FiniteSet, HalfSpace, Problem, Rule, Segment, Sphere,
    Stop,
    bounds::{Setting, theorem_1_1_excess, theorem_1_3_excess},
    gallery::Valleys,
};

#[track_caller]
fn everything_is_zero(rule: Rule, ends: &Ends<2>, n: usize) {
    let line = Problem::new(Valleys, ends.clone()).solve(rule, n).expect("touching is no error");
    let minimum = line.minimum();
    assert_eq!(minimum.stop, Stop::EndsTouch);
    assert!(minimum.is_local_minimum());
    assert_eq!(line.sequence().n().get(), n);
    for (name, value) in [
        ("discrete energy", line.discrete_energy()),
        ("energy", line.energy().value),
        ("length", line.length().value),
        ("residual", line.residual()),
        ("decrement", minimum.decrement),
        ("speed", line.speeds().into_iter().fold(0.0, f64::max)),
        ("K₃", line.sequence().k3()),
        ("estimate", line.distance_squared_estimate().map_or(0.0, |estimate| estimate.value)),
    ] {
        assert_eq!(value, 0.0, "{name} for N = {n}");
    }
    // A point that is a member of both sets up to rounding only may be 2 · √D (D + 4) ε |x| √tr H away
    // from them, with D = 2, |x| ≤ 2 and H ≤ 9 I.
    let contact = if line.common_point().is_some() { 0.0 } else { 2.0 * 6.0 * f64::EPSILON * 12.0 };
    let errors = [line.length().error, line.energy().error];
    assert!(errors[0] <= contact && errors[1] <= contact * contact, "{errors:?} for N = {n}");
    for set in [ends.first(), ends.second()] {
        let x = line.sequence().first();
        // The point has size 2, and the coordinates of the set have size 3.
        assert!((set.project(x) - x).amax() <= 4e-15, "{x} is not in both sets");
    }
}

#[track_caller]
fn touch(first: impl ClosedSet<2> + 'static, second: impl ClosedSet<2> + 'static) {
    let ends = Ends::new(first, second).expect("one is bounded");
    for n in [1, 2, 7, 200] {
        everything_is_zero(Rule::TRAPEZOIDAL, &ends, n);
        everything_is_zero(Rule::LEFT_ENDPOINT, &ends, n);
    }
}

#[test]
fn sets_that_touch_or_overlap_have_the_distance_0() {
    let ball = || Ball::new([1.0, 0.5], 1.0).expect("a radius");
    let wall = |offset| HalfSpace::at_least([1.0, 0.0], offset).expect("a normal");
    touch(ball(), wall(1.5));
    // The sets touch in exactly one point, since 1 + 1 = 2 has no rounding.
    touch(ball(), wall(2.0));
    touch(wall(2.0), ball());
    touch(ball(), Ball::new([3.0, 0.5], 1.0).expect("a radius"));
    touch(Sphere::new([1.0, 0.5], 1.0).expect("a radius"), wall(1.5));
    touch(
        AxisBox::new([0.0, 0.0], [1.0, 1.0]).expect("half-widths"),
        AxisBox::new([2.0, 1.5], [1.0, 1.0]).expect("half-widths"),
    );
    let crossing = |a, b| Segment::new(a, b).expect("finite");
    touch(crossing([-1.0, 0.0], [1.0, 0.0]), crossing([0.0, -1.0], [0.0, 1.0]));
    let points = |points: [[f64; 2]; 2]| FiniteSet::new(points).expect("two points");
    touch(points([[0.0, 0.0], [1.0, 2.0]]), points([[1.0, 2.0], [5.0, 5.0]]));
}

#[test]
fn a_point_has_the_distance_0_from_itself() {
    let ends = Ends::points([0.3, -0.7], [0.3, -0.7]).expect("finite");
    for n in [1, 2, 33] {
        everything_is_zero(Rule::TRAPEZOIDAL, &ends, n);
    }
}

#[test]
fn every_bound_is_0_for_the_distance_0() {
    let setting = Setting::new(Bounded::<2>::constants(&Valleys), 0.0, 2).expect("a distance");
    let n = 3.try_into().expect("positive");
    assert_eq!((theorem_1_1_excess(setting, n), theorem_1_3_excess(setting, n)), (0.0, 0.0));
}
