//! Certificates of distances that are known, and of curves that are not the shortest.

use std::ops::ControlFlow;

use tautline::{
    Ball, CertificateError, Ends, Formula, HalfSpace, KnownDistance, Metric, Options, Point,
    PointSequence, Problem, Rule, Sphere, Starts,
    certify::Accuracy,
    check::{AnyCertificate, CheckError},
    distance::{DistanceError, Ended, Found, Wanted},
    formula::RecordError,
    gallery,
};

/// Returns what the checker proves of the certificate between two points, after it was written and
/// read.
fn bounds<const D: usize>(
    metric: impl Metric<D>,
    a: [f64; D],
    b: [f64; D],
    gap: f64,
) -> (f64, f64) {
    let ends = Ends::points(a, b).expect("finite");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 256).expect("solved");
    let found = line.certificate(gap).expect("a certificate");
    assert_eq!(found.ended, Ended::Reached);
    let read = AnyCertificate::read(&found.certificate.to_string()).expect("readable");
    let verdict = read.check().expect("proved");
    assert!(verdict.gap.expect("a curve") <= gap, "{verdict:?}");
    (verdict.lower, verdict.upper.expect("a curve"))
}

/// Isotropic and anisotropic metrics, in one, two and three dimensions.
#[test]
fn known_distances_lie_between_the_bounds() {
    fn check<M: KnownDistance<D>, const D: usize>(metric: M, a: [f64; D], b: [f64; D], gap: f64) {
        let d = metric.distance(&a.into(), &b.into()).expect("known");
        let (lower, upper) = bounds(metric, a, b, gap);
        // The known distance is rounded.
        let rounding = 1e-14 * d;
        assert!(lower <= d + rounding && d <= upper + rounding, "{lower} {d} {upper}");
    }
    check(gallery::Sphere, [-0.5, 0.2], [0.6, 0.4], 1e-5);
    check(gallery::Hyperbolic, [-0.3, 0.1], [0.4, 0.2], 1e-4);
    check(gallery::GaussianFisher, [0.0, 0.0], [0.5, 0.3], 1e-4);
    check(gallery::Shear::new(0.5, 1.0).expect("a wave number"), [0.0, 0.1], [1.5, 1.0], 1e-4);
    check(gallery::Sphere, [-0.3, 0.1, 0.0], [0.2, 0.2, 0.1], 2e-2);
    let valleys = Formula::<1>::parse("cost(2 - cos(x1))", &[]).expect("a formula");
    let (lower, upper) = bounds(valleys, [0.0], [3.0], 1e-6);
    // ∫ (2 − cos x) dx = 6 − sin 3.
    let d = 6.0 - 3.0_f64.sin();
    assert!(lower <= d && d <= upper, "{lower} {d} {upper}");
}

/// On the sphere, curves a little longer than the shortest one get near the far side, which is at
/// infinity: no region that reaches much farther has an end.
#[test]
fn ends_far_apart_on_the_sphere_have_a_certificate() {
    let (a, b) = ([-0.8, 0.3], [1.1, 0.6]);
    let d = gallery::Sphere.distance(&a.into(), &b.into()).expect("known");
    let (lower, upper) = bounds(gallery::Sphere, a, b, 1e-3);
    assert!(lower > 0.999 * d && lower <= d && d <= upper, "{lower} {d} {upper}");
}

/// The curve on the other side of the hill is a strict local minimum, 2 % longer than the shortest.
#[test]
fn a_longer_local_minimum_is_never_certified() {
    let hill = Formula::<2>::parse("cost(1 + 4*exp(-2*(x1^2 + x2^2)))", &[]).expect("a formula");
    let ends = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("finite");
    let problem = Problem::new(hill, ends);
    let points = [[-1.5, 0.05], [0.0, 1.2], [1.5, -0.1]].map(Into::into).to_vec();
    let start = PointSequence::new(points).expect("finite");
    let options = Options { starts: Starts::Only(vec![start]), ..Options::default() };
    let line = problem.solve_with(Rule::TRAPEZOIDAL, 512, &options).expect("solved");
    assert!((line.length().value - 4.773024).abs() < 1e-4);
    let wanted = Wanted { gap: 1e-3, cubes: 60_000 };
    let found = line.certificate_with(wanted, &mut |_| ControlFlow::Continue(()));
    let found = found.expect("a certificate");
    assert_ne!(found.ended, Ended::Reached);
    // d = 4.6752711724…
    assert!(found.proved.lower <= 4.675_271_173, "{}", found.proved.lower);
    assert!(found.proved.lower > 4.6, "{}", found.proved.lower);
}

/// Above the hill there is a thin ridge across the way, between two nodes of the rule, which prefers that
/// way. The certificate is that of the way below, which the search met too and which is shorter.
#[test]
fn the_curve_of_a_certificate_is_the_shortest_minimum() {
    let text = "hill = 4*exp(-2*(x1^2 + x2^2)); ridge = exp(-(x1/0.15)^2)*(1 + tanh(8*x2)); \
                cost(1 + hill + ridge)";
    let metric = Formula::<2>::parse(text, &[]).expect("a formula");
    let ends = Ends::points([-1.5, 0.1], [1.5, 0.1]).expect("finite");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
    let shortest = line.other_minima()[0].length().value;
    assert!(shortest < 0.99 * line.length().value, "{shortest} {}", line.length().value);
    // The chords are few enough for so large a gap.
    let found = line.certificate(0.9).expect("a certificate");
    // A proved length is known to one part in a thousand, or better.
    let upper = found.proved.upper.expect("a curve");
    assert!(upper < shortest * 1.002, "{upper} for {shortest}");
}

#[test]
fn a_ball_and_a_half_space_are_ends() {
    let ball = Ball::new([-2.0, 0.3], 0.5).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 2.0).expect("a normal");
    let hill = || Formula::<2>::parse("cost(1 + 4*exp(-2*(x1^2 + x2^2)))", &[]).expect("a formula");
    let mut lowers = Vec::new();
    for ends in [Ends::new(ball.clone(), wall.clone()), Ends::new(wall, ball)] {
        let line = Problem::new(hill(), ends.expect("bounded")).solve(Rule::TRAPEZOIDAL, 256);
        let found = line.expect("solved").certificate(1e-4).expect("a certificate");
        let proved = found.certificate.check().expect("proved");
        assert!(proved.upper.is_some_and(|upper| proved.lower > 0.9999 * upper));
        lowers.push(proved.lower);
    }
    // The distance is the same in both directions.
    assert!((lowers[0] / lowers[1] - 1.0).abs() < 1e-4);
}

#[test]
fn a_line_without_a_certificate_is_an_error() {
    let flat = || Formula::<2>::parse("1 I", &[]).expect("a formula");
    let ends = Ends::points([0.0, 0.0], [1.0, 0.0]).expect("finite");
    let line = Problem::new(flat(), ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
    for gap in [0.0, 1.0, f64::NAN] {
        let error = line.certificate(gap).expect_err("no such gap");
        assert!(matches!(error, CertificateError::Gap { .. }), "{error}");
    }
    let touching = Ends::points([1.0, 0.0], [1.0, 0.0]).expect("finite");
    let line = Problem::new(flat(), touching).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
    assert_eq!(line.certificate(0.1).map(|_| ()), Err(CertificateError::Touching));
    let sphere = Sphere::new([3.0, 0.0], 1.0).expect("a radius");
    let ends = Ends::new(Ball::new([0.0, 0.0], 0.5).expect("a radius"), sphere).expect("bounded");
    let line = Problem::new(flat(), ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
    assert_eq!(line.certificate(0.1).map(|_| ()), Err(CertificateError::NoShape { end: "second" }));
}

/// Returns a search between two points of the plane.
fn searched(gap: f64, cubes: usize, stop: bool) -> Found<2> {
    let metric = Formula::<2>::parse("sqr(2 - cos(x1)) I", &[]).expect("a formula");
    let ends = Ends::points([0.0, 0.0], [2.0, 1.0]).expect("finite");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let flow = if stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    line.certificate_with(Wanted { gap, cubes }, &mut |_| flow).expect("a certificate")
}

#[test]
fn a_search_ends_with_the_reason() {
    // A gap that is reached is reached, even if there is no time for more.
    for (gap, ended) in [(1e-6, Ended::Stopped), (0.5, Ended::Reached)] {
        let found = searched(gap, usize::MAX, true);
        assert_eq!((found.ended, found.certificate.levels.len()), (ended, 1), "{gap}");
    }
    // The limit is on all levels together.
    let all = searched(1e-5, usize::MAX, false);
    assert_eq!(all.ended, Ended::Reached);
    let cubes = |found: &Found<2>| found.proved.levels.iter().map(|(cubes, _)| cubes).sum();
    let limit: usize = cubes(&all);
    let found = searched(1e-5, limit - 1, false);
    assert_eq!((found.ended, cubes(&found) < limit), (Ended::TooManyCubes, true));
    assert_eq!(found.certificate.levels.len() + 1, all.certificate.levels.len());
}

/// Far from the origin, small cubes have no places of 32 bits. What was proved before is returned.
#[test]
fn a_search_far_from_the_origin_returns_what_it_has() {
    let ends = Ends::points([1e6], [1e6 + 1.0]).expect("finite");
    let metric = Formula::<1>::parse("sqr(2 - cos(x1)) I", &[]).expect("a formula");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let found = line.certificate(1e-9).expect("a certificate");
    assert_eq!(found.ended, Ended::TooFar);
    let proved = found.certificate.check().expect("proved");
    assert!(proved.gap().is_some_and(|gap| gap < 1e-2), "{:?}", proved.gap());
}

/// The feet of nodes on the geodesic are far from the nearest points of it.
#[test]
fn a_small_gap_is_reached_under_an_anisotropic_metric() {
    let shear = gallery::Shear::new(0.6, 3.0).expect("a wave number");
    let (a, b) = ([-0.5, -0.3], [0.5, 0.4]);
    let d = shear.distance(&a.into(), &b.into()).expect("known");
    let line = Problem::new(shear, Ends::points(a, b).expect("finite"));
    let found = line.solve(Rule::TRAPEZOIDAL, 256).expect("solved").certificate(1e-6);
    let found = found.expect("a certificate");
    assert_eq!(found.ended, Ended::Reached);
    let (lower, upper) = (found.proved.lower, found.proved.upper.expect("a curve"));
    assert!((1.0 - 1e-6) * d <= lower && lower <= d && d <= upper, "{lower} {d} {upper}");
}

/// Balls whose surfaces are `2⁻⁵¹` apart touch up to rounding. At a cost of 10¹⁵ their distance is
/// 0.444, and 0 is not claimed; where a double is a member of both, it is proved.
#[test]
fn sets_that_touch_up_to_rounding_are_not_said_to_touch() {
    let apart = 0.5_f64.powi(51);
    for scale in [1e15, 1.0, 1e-15, 1e140] {
        let line = |gap: f64| {
            let balls = [0.0, 2.0 + gap].map(|x| Ball::new([x, 0.0], 1.0).expect("finite"));
            let [first, second] = balls;
            let ends = Ends::new(first, second).expect("bounded");
            let metric = Formula::<2>::parse(&format!("{:?} I", scale * scale), &[]);
            Problem::new(metric.expect("a formula"), ends)
                .solve(Rule::TRAPEZOIDAL, 8)
                .expect("solved")
        };
        // The square of the scale is rounded by less than one part in 10¹⁵.
        let d = apart * scale * (1.0 - 1e-15);
        let touching = line(0.0);
        assert_eq!(touching.common_point(), Some([1.0, 0.0].into()));
        assert_eq!(touching.certificate(0.1).map(|_| ()), Err(CertificateError::Touching));
        assert_eq!((touching.length().value, touching.length().error), (0.0, 0.0));
        let nearly = line(apart);
        assert_eq!(nearly.common_point(), None);
        let length = nearly.length();
        assert!(length.value + length.error >= d, "{length:?} for {d}");
        match nearly.certificate(0.1) {
            Err(CertificateError::NearlyTouching { upper }) => {
                assert!(d <= upper && upper <= 10.0 * d, "{upper} for {d}");
            }
            Ok(found) => {
                let (lower, upper) = (found.proved.lower, found.proved.upper.expect("a curve"));
                assert!(lower <= d && d <= upper, "{lower} {upper} for {d}");
            }
            Err(error) => panic!("{error}"),
        }
        let proof = nearly.prove(Accuracy::default()).expect("proved").enclosure;
        assert!(proof.lower <= d * d && d * d <= proof.upper, "{proof:?}");
        // Points that are all the same are no minimum that bounds anything, and refute nothing.
        assert!(!proof.is_not_global && !proof.assumes_global_minimum, "{proof:?}");
    }
}

/// Both halves agree on the line and not beside it. A certificate has one of them, whether the ends are
/// apart, nearly equal or equal.
#[test]
fn a_matrix_with_two_halves_has_no_certificate() {
    for to in [1.0, 1.0_f64.next_up(), 1.5] {
        let metric = Formula::<2>::parse("[2, 0; x2, 2]", &[]).expect("a formula");
        let ends = Ends::points([1.0, 0.0], [to, 0.0]).expect("finite");
        let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
        let halves = RecordError::Halves { row: 0, column: 1 };
        let refused = line.certificate(0.1).map(|_| ());
        assert_eq!(refused, Err(CertificateError::NotRecorded(halves)), "{to}");
    }
}

/// Two points whose coordinates differ by an ulp are no common point.
#[test]
fn points_an_ulp_apart_do_not_touch() {
    let next = 1.0_f64.next_up();
    let metric = Formula::<1>::parse("1e30 I", &[]).expect("a formula");
    let line = |b: f64| {
        let ends = Ends::points([1.0], [b]).expect("finite");
        Problem::new(metric.clone(), ends).solve(Rule::TRAPEZOIDAL, 4).expect("solved")
    };
    let d = 1e15 * f64::EPSILON;
    let near = line(next);
    assert_eq!(near.common_point(), None);
    let found = near.certificate(0.5);
    match found {
        Err(CertificateError::NearlyTouching { upper }) => assert!(upper >= d * (1.0 - 1e-15)),
        Ok(found) => assert!(found.proved.lower <= d && d <= found.proved.upper.expect("a curve")),
        Err(error) => panic!("{error}"),
    }
    let length = near.length();
    assert!(length.value + length.error >= d * (1.0 - 1e-15), "{length:?}");
    assert!(line(1.0).common_point().is_some());
}

/// A common point proves the distance 0 only under a metric. In doubles this `H` is 0.5, exactly it is −0.4.
#[test]
fn a_common_point_without_a_metric_is_no_proof() {
    let formula = |text: &str| Formula::<1>::parse(text, &[]).expect("a formula");
    let line = |text: &str| {
        let ball = Ball::new([-1.0], 0.5).expect("a ball");
        let ends = Ends::new(Point::new([-0.9]).expect("finite"), ball).expect("bounded");
        Problem::new(formula(text), ends).solve(Rule::TRAPEZOIDAL, 4).expect("solved")
    };
    assert_eq!(line("0.5 I").common_point(), Some([-0.9].into()));
    let no_metric = line("(((x1 + 1e16) - 1e16) + 0.5) I");
    assert_eq!(no_metric.common_point(), None);
    // Nor is there a bound, and the reason is told.
    let refused = no_metric.certificate(0.1).map(|_| ());
    let reason = CheckError::CurveDomain { chord: 0 };
    assert_eq!(refused, Err(DistanceError::Curve(reason).into()));
}
