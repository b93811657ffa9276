//! Problems in more dimensions than anything is compiled for.

use std::sync::Arc;

use tautline::{Ball, Point};
use tautline_any::{Given, GivenError, Grid, Nodes, Request, RequestError, Shape, Values};
use tautline_problem::{Diagnostic, Failure, Question};

/// Returns the file of a problem between the origin and a point that is away from it along the first and the
/// last coordinate. The metric depends on the first, so that the shortest curve bends in their plane.
fn file(dimension: usize, more: &str) -> String {
    let mut far = vec![0.0; dimension];
    (far[0], far[dimension - 1]) = (3.0, 2.0);
    let near = vec![0.0; dimension];
    format!(
        "[metric]\ncost = \"2 - cos(x1)\"\n[from]\npoint = {near:?}\n[to]\npoint = {far:?}\n{more}"
    )
}

#[test]
fn a_file_is_solved_in_256_dimensions_and_no_more() {
    for (dimension, n) in [(13, 64), (64, 16), (256, 2)] {
        let solved = |dimension| {
            let more = format!("[solve]\nn = {n}\n");
            let question = Question::read(&file(dimension, &more)).expect("a problem");
            question.solve(&mut |_| ()).expect("a curve")
        };
        let (answer, plane) = (solved(dimension), solved(2));
        assert_eq!((answer.dimension, answer.curve[0].len()), (dimension, dimension));
        assert!(answer.search.converged);
        // The curve is that in the plane: both are minima to rounding, where a length is flat.
        let [found, expected] = [&answer, &plane].map(|answer| answer.length.value);
        assert!((found - expected).abs() <= 1e-12 * expected, "{dimension}: {found} {expected}");
        // It is no straight line, whose length is √13/3 (6 − sin 3).
        let straight = 13.0_f64.sqrt() / 3.0 * (6.0 - 3.0_f64.sin());
        assert!(found < straight * (1.0 - 1e-3), "{dimension}: {found} {straight}");
        // Constants are proved in up to twelve dimensions.
        let reason = answer.no_bounds.expect("a reason");
        assert!(reason.contains("up to 12 dimensions"), "{reason}");
    }
    let refused = Question::read(&file(257, "")).expect_err("too many");
    assert_eq!(refused.message, "dimension 257");
}

/// The same metric by its formula and by its values.
#[test]
fn a_black_box_in_twenty_dimensions_leads_to_the_curve_of_its_formula() {
    struct Valleys;
    impl Values for Valleys {
        fn gram(&self, x: &[f64]) -> Vec<f64> {
            let matrix = |x: &[f64]| {
                let square = (2.0 - x[0].cos()).powi(2);
                (0..400).map(move |place| if place % 21 == 0 { square } else { 0.0 })
            };
            x.chunks(20).flat_map(matrix).collect()
        }
    }
    let formula = Given::parse("cost(2 - cos(x1))", 20, &[], &[]).expect("a formula");
    let values = Given::black_box(Arc::new(Valleys), 20, 1e-3).expect("a step");
    let mut far = [0.0; 20];
    (far[0], far[7]) = (3.0, 1.0);
    let from = [Shape::Point(Point::from_slice(&[0.0; 20]).expect("finite"))];
    let to = [Shape::Ball(Ball::from_slice(&far, 0.5).expect("a radius"))];
    let request = Request { grid: Grid::Chords(32), ..Request::default() };
    let [by_formula, by_values] =
        [&formula, &values].map(|metric| metric.solve([&from, &to], &request).expect("a curve"));
    assert!(by_formula.search().converged && by_values.search().converged);
    let [a, b] = [by_formula.length().value, by_values.length().value];
    // Both are minima of the same energy, which differences resolve to 10⁻¹⁰ or so.
    assert!((a - b).abs() <= 1e-9 * a, "{a} {b}");
    assert_eq!(values.gram(&far), formula.gram(&far));
    let refused = Given::black_box(Arc::new(Valleys), 33, 1e-3).map(|given| given.dimension());
    assert_eq!(refused, Err(GivenError::BlackBoxDimension { dimension: 33 }));
}

/// The curve is that of the plane, and so is the upper bound. The lower one may be smaller, since theorems
/// depend on the dimension.
#[test]
fn claimed_constants_give_bounds_in_any_dimension() {
    let bounds = |dimension: usize, c2: f64| {
        let more =
            format!("[solve]\nn = 64\n[certify]\nconstants = {{ c1 = 1, c2 = {c2}, l_h = 6 }}\n");
        let question = Question::read(&file(dimension, &more)).expect("a problem");
        question.solve(&mut |_| ()).expect("a curve")
    };
    let found = bounds(20, 9.0);
    let plane = bounds(2, 9.0).bounds.expect("bounds");
    let (length, bounds_in_20) = (found.length.value, found.bounds.expect("bounds"));
    let [lower, upper] = [bounds_in_20.lower.value, bounds_in_20.upper.value];
    assert!(
        lower > 0.0 && lower <= upper && (upper / length - 1.0).abs() < 1e-12,
        "{lower} {upper}"
    );
    assert!((upper / plane.upper.value - 1.0).abs() < 1e-12, "{upper} {plane:?}");
    assert!(lower <= plane.lower.value * (1.0 + 1e-12), "{lower} {plane:?}");
    let reason = bounds(20, 2.0).no_bounds.expect("a wrong claim");
    assert!(reason.contains("the claim c2 = 2 is wrong: H(["), "{reason}");
}

/// What is made for each dimension says up to which one.
#[test]
fn what_needs_fewer_dimensions_is_refused() {
    let reason = |more: &str| -> String {
        let question = Question::read(&file(20, more)).expect("a problem");
        match question.solve(&mut |_| ()) {
            Ok(answer) => answer.no_bounds.expect("no bounds"),
            Err(Failure::BadInput(Diagnostic { message, .. })) => message,
            Err(Failure::NotComputed(message)) => message,
        }
    };
    let proved = "[solve]\nn = 8\n";
    assert!(reason(proved).contains("up to 12 dimensions; claim c1"), "{}", reason(proved));
    let corners = |x: f64| vec![x; 20];
    let lattice = format!(
        "[solve]\nn = 8\nlattice = {{ lower = {:?}, upper = {:?}, spacing = 1 }}\n",
        corners(-1.0),
        corners(4.0)
    );
    assert!(reason(&lattice).contains("dimension 20; at most 4"), "{}", reason(&lattice));
    let gallery = file(20, "").replace("cost = \"2 - cos(x1)\"", "gallery = \"valleys\"");
    let refused = Question::read(&gallery).expect("a problem").solve(&mut |_| ());
    let message = refused.expect_err("a metric of the gallery").to_string();
    assert!(message.contains("up to 12 dimensions"), "{message}");
    let metric = Given::parse("cost(2 - cos(x1))", 20, &[], &[]).expect("a formula");
    let point = [Shape::Point(Point::from_slice(&[0.0; 20]).expect("finite"))];
    let nodes = Nodes { lower: corners(0.0), upper: corners(1.0), spacing: vec![0.5], classes: 1 };
    let request = Request { lattice: Some(nodes), grid: Grid::Chords(8), ..Request::default() };
    let refused = metric.solve([&point, &point], &request).expect_err("no lattice");
    assert!(matches!(refused, GivenError::Request(RequestError::Lattice(_))), "{refused}");
}

/// `3 + sin x₁ cos x₁₂` runs from 2 to 4; its gradient and its second derivatives are at most 1.
#[test]
fn constants_are_proved_in_twelve_dimensions() {
    let text = "dimension = 12\n[metric]\nphi = \"3 + sin(x1)*cos(x12)\"\n";
    let found = Question::read(text).expect("a metric").constants().expect("bounds");
    assert_eq!(found.region, "all of space");
    for (constant, best) in found.constants.iter().zip([2.0, 4.0, 1.0, 1.0]) {
        let [lower, upper] =
            [&constant.lower, &constant.upper].map(|bound| bound.as_ref().expect("a bound").value);
        assert!(lower <= best && best <= upper && upper <= 2.5 * lower, "{constant:?}");
    }
    let file = file(12, "[solve]\nn = 16\n");
    let bounds = Question::read(&file).expect("a problem").solve(&mut |_| ()).expect("a curve");
    let bounds = bounds.bounds.expect("proved constants");
    assert!(!bounds.rests_on_claims() && bounds.lower.value > 0.0, "{bounds:?}");
}

/// A decoder in twelve dimensions: 40 hidden units of each coordinate.
#[test]
fn a_long_formula_in_many_dimensions_is_refused_with_its_steps() {
    let unit = |k: usize| {
        let sum = (1..=12).map(|i| format!("{}*x{i}", (k * 7 + i * 5) % 11)).collect::<Vec<_>>();
        format!("\"tanh({})\"", sum.join(" + "))
    };
    let outputs: Vec<String> = (0..40).map(unit).collect();
    let text = format!(
        "dimension = 12\n[metric]\npullback = [{}]\n[certify]\nwithin = {{ ball = {{ centre = {:?}, \
         radius = 1 }} }}\n",
        outputs.join(", "),
        [0.0; 12]
    );
    let error = Question::read(&text).expect("a metric").constants().expect_err("too long");
    let message = error.to_string();
    assert!(message.contains("formulas of up to 720 steps, and this one has "), "{message}");
}
