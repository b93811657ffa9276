//! Problems as values: the same curves as from files, and errors with the numbers.

use std::{ops::ControlFlow, sync::Arc};

use tautline::{CertificateError, RecordError, distance::Wanted};
use tautline_problem::{
    Question,
    value::{Given, GivenError, Request, RuleName, Shape, Values},
};

const HILL: &str = "cost(1 + 4*exp(-2*(x1^2 + x2^2)))";

fn point(x: &[f64]) -> [Shape; 1] {
    [Shape::Point(x.to_vec())]
}

fn hill() -> Given {
    Given::parse(HILL, 2, &[]).expect("a formula")
}

/// Bit for bit, for each rule.
#[test]
fn a_curve_of_values_is_that_of_a_file() {
    let rules = [
        ("trapezoidal", RuleName::Trapezoidal),
        ("left_endpoint", RuleName::LeftEndpoint),
        ("true_trapezoid", RuleName::TrueTrapezoid),
    ];
    for (name, rule) in rules {
        let file = format!(
            "[metric]\ncost = \"1 + 4*exp(-2*(x1^2 + x2^2))\"\n[from]\npoint = [-1.5, 0.05]\n[to]\n\
             ball = {{ centre = [1.5, -0.1], radius = 0.25 }}\n[solve]\nrule = \"{name}\"\nn = 64\n\
             [certify]\nbound = false\n"
        );
        let answer = Question::read(&file).expect("a file").solve(&mut |_| ()).expect("solved");
        let ball = [Shape::Ball { centre: vec![1.5, -0.1], radius: 0.25 }];
        let request = Request { rule, n: 64, ..Request::default() };
        let curve = hill().solve([&point(&[-1.5, 0.05]), &ball], &request).expect("solved");
        assert_eq!(curve.points(), answer.curve.concat());
        assert_eq!(curve.length(), answer.length);
        assert_eq!(curve.search(), answer.search);
        assert_eq!(curve.extrapolated(), answer.extrapolated);
        assert_eq!((curve.rule(), curve.dimension()), (rule, 2));
        assert_eq!(curve.other_minima().len(), answer.other_minima.len());
    }
}

/// An error in one problem does not move the curves of the others.
#[test]
fn many_problems_have_the_curves_of_single_ones() {
    let ends = [[-1.5, 0.05], [f64::NAN, 0.0], [0.0, 1.5], [0.3, 0.2]].map(|x| point(&x));
    let goal = point(&[1.5, -0.1]);
    let pairs: Vec<[&[Shape]; 2]> = ends.iter().map(|end| [&end[..], &goal[..]]).collect();
    let request = Request { n: 32, threads: 1, ..Request::default() };
    let all = hill().solve_all(&pairs, &request);
    assert!(matches!(all[1], Err(GivenError::Set(_))), "{:?}", all[1]);
    for (found, pair) in all.iter().zip(&pairs).filter(|(found, _)| found.is_ok()) {
        let alone = hill().solve(*pair, &request).expect("solved");
        assert_eq!(found.as_ref().expect("solved").points(), alone.points());
    }
}

#[test]
fn a_certificate_of_a_curve_contains_the_distance() {
    let ends = [point(&[-1.5, 0.05]), point(&[1.5, -0.1])];
    let curve = hill().solve([&ends[0], &ends[1]], &Request::default()).expect("solved");
    let go_on = &mut |_| std::ops::ControlFlow::Continue(());
    let found = curve.certificate(Wanted::gap(1e-2), go_on).expect("a certificate");
    // d = 4.6752711724…
    let d = 4.675_271_172_4;
    assert!(found.reached && found.lower.value <= d && d <= found.upper.value);
}

#[test]
fn what_is_wrong_is_said_with_its_numbers() {
    let ends = [point(&[0.0, 0.0]), point(&[1.0, 0.0])];
    let solve = |ends: [&[Shape]; 2], request: &Request| {
        hill().solve(ends, request).map(|_| ()).expect_err("refused").to_string()
    };
    let request = Request::default();
    let space = point(&[1.0, 0.0, 0.0]);
    let ball = [Shape::Ball { centre: vec![2.0, 0.0], radius: -1.0 }];
    let flat = [Shape::Segment { from: vec![1.0, 0.0], to: vec![1.0] }];
    let starts = vec![vec![vec![0.0, 0.0], vec![1.0]]];
    let odd = Request { starts, ..Request::default() };
    let cases = [
        (solve([&ends[0], &space], &request), "a point has 3 coordinates in 2 dimensions"),
        (solve([&ends[0], &ball], &request), "-1"),
        (solve([&ends[0], &flat], &request), "a segment has 1 coordinates in 2 dimensions"),
        (solve([&ends[0], &[]], &request), "the second set has no pieces"),
        (solve([&ends[0], &ends[1]], &odd), "a point of a start has 1 coordinates"),
        (solve([&ends[0], &ends[1]], &Request { n: 0, ..request.clone() }), "N = 0"),
    ];
    for (found, expected) in cases {
        assert!(found.contains(expected), "{found}, not {expected}");
    }
    let refused = |text, dimension| Given::parse(text, dimension, &[]).expect_err("refused");
    for dimension in [0, 13] {
        assert_eq!(refused("1 I", dimension), GivenError::Dimension { dimension });
    }
    assert!(matches!(refused("cost(sine(x1))", 1), GivenError::Text(_)));
    assert!(hill().gram(&[1.0]).is_err());
}

/// The text of a formula is read as the same formula.
#[test]
fn a_metric_is_its_text() {
    let given = hill();
    let read = Given::parse(&given.text().expect("a formula"), 2, &[]).expect("a formula");
    assert_eq!(read.text(), given.text());
    assert_eq!(read.gram(&[0.3, -0.2]), given.gram(&[0.3, -0.2]));
    assert_eq!(given.gram(&[0.0, 0.0]), Ok(vec![25.0, 0.0, 0.0, 25.0]));
}

/// The hill by its values.
struct Hill;

impl Values for Hill {
    fn gram(&self, x: &[f64]) -> Vec<f64> {
        let at = |x: &[f64]| (1.0 + 4.0 * (-2.0 * (x[0] * x[0] + x[1] * x[1])).exp()).powi(2);
        x.chunks(2).flat_map(|x| [at(x), 0.0, 0.0, at(x)]).collect()
    }
}

/// Derivatives by differences have errors of 10⁻¹⁰: the energy of a minimiser does not see them.
#[test]
fn a_black_box_has_the_minimum_of_the_formula_and_no_certificate() {
    let ends = [point(&[-1.5, 0.05]), point(&[1.5, -0.1])];
    let ends = [&ends[0][..], &ends[1][..]];
    let black_box = Given::black_box(Arc::new(Hill), 2, 1e-3).expect("a step");
    for n in [32, 256] {
        let request = Request { n, ..Request::default() };
        let [found, expected] =
            [&black_box, &hill()].map(|metric| metric.solve(ends, &request).expect("solved"));
        assert!(found.search().converged, "{:?}", found.search());
        let (length, other) = (found.length().value, expected.length().value);
        assert!((length - other).abs() <= 1e-12 * other, "N = {n}: {length} {other}");
        let refused = found.certificate(Wanted::gap(0.1), &mut |_| ControlFlow::Continue(()));
        let reason = CertificateError::NotRecorded(RecordError::BlackBox);
        assert_eq!(refused.map(|_| ()), Err(reason));
    }
    assert_eq!((black_box.text(), black_box.dimension()), (None, 2));
    let refused = Given::black_box(Arc::new(Hill), 2, 0.0).map(|_| ());
    assert_eq!(refused, Err(GivenError::Step { step: 0.0 }));
}
