//! Options and results that are written as JSON and read again, with the feature `serde`.

use std::fmt::Debug;

use serde::{Serialize, de::DeserializeOwned};
use tautline::{
    AxisBox, Ball, Competitors, Constants, Convention, Ends, Estimate, HalfSpace, Integral,
    Minimum, Options, Point, PointSequence, Problem, Rule, Shape, Starts, SuggestedN,
    bounds::Enclosure, certify::Accuracy, gallery::Sphere, gallery::Valleys, leading_constants,
};

/// Writes a value, reads it, compares, and returns the text.
#[track_caller]
fn round_trip<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) -> String {
    let text = serde_json::to_string(value).expect("data");
    let read: T = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
    assert_eq!(&read, value, "{text}");
    text
}

/// Returns the message for a text that must not be read as a `T`.
#[track_caller]
fn refused<T: DeserializeOwned + Debug>(text: &str) -> String {
    serde_json::from_str::<T>(text).expect_err(text).to_string()
}

fn valleys() -> Problem<Valleys, 2> {
    let wall = HalfSpace::at_least([3.0, 0.1], 3.0).expect("a normal");
    let ends = Ends::new(Ball::new([0.1, 0.2], 0.3).expect("a radius"), wall).expect("bounded");
    Problem::new(Valleys, ends)
}

/// Every number of a solve comes back with the same bits.
#[test]
fn a_minimum_and_what_is_known_of_it_come_back() {
    let problem = valleys();
    let line = problem.solve(Rule::TRAPEZOIDAL, 64).expect("a line");
    let text = round_trip::<Minimum<2>>(line.minimum());
    assert!(text.contains(r#""stop":"Converged","curvature":"PositiveDefinite""#), "{text}");
    round_trip::<Integral>(&line.length());
    round_trip::<Estimate>(&line.distance_squared_estimate().expect("an estimate"));
    let enclosure: Enclosure = line.enclosure().expect("constants");
    round_trip(&enclosure);
    round_trip::<SuggestedN>(&line.suggest_n(1e-3).expect("constants"));
    round_trip(&leading_constants(&Valleys, line.ends(), line.minimum()).expect("smooth"));
    round_trip(&Convention::EnergyOver { time: 0.1 });
}

/// A sequence that was read is a start from which the search returns to the minimiser.
#[test]
fn a_search_starts_from_what_was_saved() {
    let problem = valleys();
    let line = problem.solve(Rule::LEFT_ENDPOINT, 64).expect("a line");
    let options = Options {
        starts: Starts::Only(vec![line.sequence().clone()]),
        iterations: 20,
        ..Options::default()
    };
    let text = round_trip(&options);
    let options: Options<2> = serde_json::from_str(&text).expect("options");
    let again = problem.solve_with(Rule::LEFT_ENDPOINT, 64, &options).expect("a line");
    let change = again.minimum().energy - line.minimum().energy;
    assert!(change.abs() <= 1e-12 * line.minimum().energy, "{change}");
}

#[test]
fn options_that_are_not_named_keep_their_defaults() {
    let options: Options<2> = serde_json::from_str(r#"{ "iterations": 50 }"#).expect("options");
    assert_eq!(options, Options { iterations: 50, ..Options::default() });
    let accuracy: Accuracy = serde_json::from_str(r#"{ "tolerance": 0.1 }"#).expect("options");
    assert_eq!(accuracy, Accuracy { tolerance: 0.1, ..Accuracy::default() });
    let message = refused::<Options<2>>(r#"{ "iteration": 50 }"#);
    assert!(message.contains("unknown field `iteration`"), "{message}");
}

#[test]
fn false_constants_are_refused() {
    let constants = Constants::new(1.0, 9.0, 5.0).expect("constants").on_a_region();
    round_trip(&constants);
    round_trip(&constants.with_m_h(0.1).expect("a bound").isotropic());
    let message = refused::<Constants>(r#"{ "c1": 2, "c2": 1, "l_h": 0 }"#);
    assert!(message.contains("c2 = 1 must be finite and at least c1 = 2"), "{message}");
    let message = refused::<Constants>(r#"{ "c1": 1, "c2": 1, "l_h": 0, "m_h": -1 }"#);
    assert!(message.contains("-1"), "{message}");
}

#[test]
fn points_that_make_no_sequence_are_refused() {
    let straight = PointSequence::straight([0.1, 0.2], [0.3, 0.7], 2).expect("points");
    assert_eq!(round_trip(&straight), "[[0.1,0.2],[0.2,0.44999999999999996],[0.3,0.7]]");
    let message = refused::<PointSequence<2>>("[[0, 1]]");
    assert!(message.contains("1 points make no subinterval"), "{message}");
    refused::<PointSequence<2>>("[[0, 1], [2]]");
    refused::<PointSequence<2>>("[[0, 1], [2, 3, 4]]");
}

/// The half-space has the normal as given, of another length than 1, which defines it exactly.
#[test]
fn sets_come_back_and_false_ones_are_refused() {
    let half_space = HalfSpace::new([3.0, 0.1], 0.7).expect("a normal");
    let text = round_trip(&half_space);
    assert_eq!(text, r#"{"normal":[3.0,0.1],"at_most":0.7}"#);
    let above: HalfSpace<2> =
        serde_json::from_str(r#"{"normal":[-3.0,-0.1],"at_least":-0.7}"#).expect("a half-space");
    assert_eq!(above, half_space);
    let read: HalfSpace<2> = serde_json::from_str(&text).expect("a half-space");
    assert_eq!(read.given(), half_space.given());
    let point = Point::new([0.1, 0.2]).expect("finite");
    let ball = Ball::new([0.1, 0.2], 0.3).expect("a radius");
    let corners = AxisBox::from_corners([0.1, 0.2], [0.3, 0.7]).expect("a box");
    round_trip(&Shape::Union(vec![
        Shape::Point(point),
        Shape::Ball(ball),
        Shape::AxisBox(corners),
        Shape::HalfSpace(half_space),
    ]));
    let message = refused::<Ball<2>>(r#"{ "centre": [0, 0], "radius": -1 }"#);
    assert!(message.contains("-1"), "{message}");
    let message = refused::<Ball<2>>(r#"{ "centre": [0, 0], "r": 1 }"#);
    assert!(message.contains("unknown field `r`"), "{message}");
    let message = refused::<Ball<2>>(r#"{ "centre": [0, 0] }"#);
    assert!(message.contains("missing field `radius`"), "{message}");
    refused::<AxisBox<1>>(r#"{ "lower": [1], "upper": [0] }"#);
    refused::<HalfSpace<2>>(r#"{ "normal": [0, 0], "at_most": 0 }"#);
    let message = refused::<HalfSpace<2>>(r#"{ "normal": [1, 0], "at_least": 0, "at_most": 1 }"#);
    assert!(message.contains("duplicate field `at_most`"), "{message}");
}

#[test]
fn competitors_come_back() {
    let ends = Ends::points([-0.1, 0.0], [0.1, 0.05]).expect("finite");
    let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 64).expect("a line");
    round_trip::<Competitors<2>>(&line.competitors().expect("near ends"));
}

/// JSON has no such numbers: they are written as `null`, and a `null` is not read as a number.
#[test]
fn a_number_that_is_not_finite_is_null_and_not_read() {
    let estimate = Estimate { value: f64::NAN, error: f64::INFINITY };
    let text = serde_json::to_string(&estimate).expect("data");
    assert_eq!(text, r#"{"value":null,"error":null}"#);
    let message = refused::<Estimate>(&text);
    assert!(message.contains("null"), "{message}");
}
