//! Problems as values: the same curves as from files, and errors with the numbers.

mod many_dimensions;

use std::{
    ops::ControlFlow,
    sync::{Arc, atomic::AtomicBool},
};

use tautline::{
    Ball, CertificateError, Constants, GraphPathError, HalfSpace, Point, RecordError, Rule, Sphere,
    certify, distance::Wanted,
};
use tautline_any::{
    Given, GivenError, Grid, Nodes, Proofs, Region, Request, RequestError, Shape, Values,
};
use tautline_problem::Question;

const HILL: &str = "cost(1 + 4*exp(-2*(x1^2 + x2^2)))";

fn point(x: &[f64]) -> [Shape; 1] {
    [Shape::Point(Point::from_slice(x).expect("finite"))]
}

fn ball(centre: &[f64], r: f64) -> Shape {
    Shape::Ball(Ball::from_slice(centre, r).expect("a radius"))
}

fn hill() -> Given {
    Given::parse(HILL, 2, &[], &[]).expect("a formula")
}

/// Bit for bit, for each rule.
#[test]
fn a_curve_of_values_is_that_of_a_file() {
    for &rule in Rule::ALL {
        let name = rule.name();
        let file = format!(
            "[metric]\ncost = \"1 + 4*exp(-2*(x1^2 + x2^2))\"\n[from]\npoint = [-1.5, 0.05]\n[to]\n\
             ball = {{ centre = [1.5, -0.1], radius = 0.25 }}\n[solve]\nrule = \"{name}\"\nn = 64\n\
             [certify]\nbound = false\n"
        );
        let answer = Question::read(&file).expect("a file").solve(&mut |_| ()).expect("solved");
        let ball = [ball(&[1.5, -0.1], 0.25)];
        let request = Request { rule, grid: Grid::Chords(64), ..Request::default() };
        let curve = hill().solve([&point(&[-1.5, 0.05]), &ball], &request).expect("solved");
        assert_eq!(curve.points(), answer.curve.concat());
        assert_eq!(curve.length(), answer.length);
        assert_eq!(curve.search(), answer.search);
        assert_eq!(curve.extrapolated(), answer.extrapolated);
        assert_eq!((curve.rule(), curve.dimension()), (rule, 2));
        assert_eq!(curve.other_minima().len(), answer.other_minima.len());
    }
}

#[test]
fn a_tolerance_of_values_is_that_of_a_file() {
    let file = "[metric]\ncost = \"1 + 4*exp(-2*(x1^2 + x2^2))\"\n[from]\npoint = [-1.5, 0.05]\n\
                [to]\npoint = [1.5, -0.1]\n[solve]\ntolerance = 1e-9\n[certify]\nbound = false\n";
    let answer = Question::read(file).expect("a file").solve(&mut |_| ()).expect("solved");
    let with = |grid| {
        let request = Request { grid, ..Request::default() };
        hill().solve([&point(&[-1.5, 0.05]), &point(&[1.5, -0.1])], &request)
    };
    let curve = with(Grid::Tolerance(1e-9)).expect("solved");
    assert_eq!((curve.points(), curve.length()), (answer.curve.concat(), answer.length));
    assert!(answer.n > 256 && answer.within_tolerance == Some(true) && curve.is_within(1e-9));
    let coarse = with(Grid::Chords(answer.n / 4)).expect("solved");
    assert!(!coarse.is_within(1e-9) && coarse.is_within(1e-7) && !coarse.is_within(f64::NAN));
    for tolerance in [0.0, 1e-14, 1.0, f64::NAN] {
        let refused = with(Grid::Tolerance(tolerance)).expect_err("no tolerance").to_string();
        assert!(refused.contains("must be at least 1e-13 and less than 1"), "{refused}");
    }
}

/// A flag ends a search. While it is false, it changes no bit.
#[test]
fn a_flag_ends_a_search() {
    let (from, to) = (point(&[-1.5, 0.05]), point(&[1.5, -0.1]));
    for grid in [Grid::Chords(64), Grid::Tolerance(1e-9)] {
        let request = Request { grid, ..Request::default() };
        let until = |ended| {
            let flag = Arc::new(AtomicBool::new(ended));
            hill().solve_until(&flag, [&from, &to], &request)
        };
        let alone = hill().solve([&from, &to], &request).expect("solved");
        assert_eq!(until(false).expect("solved").points(), alone.points());
        let ended = until(true).expect_err("ended").to_string();
        assert!(ended.contains("ended"), "{ended}");
    }
}

/// An error in one problem does not move the curves of the others.
#[test]
fn many_problems_have_the_curves_of_single_ones() {
    let ends: [&[f64]; 4] = [&[-1.5, 0.05], &[0.0, 0.0, 0.0], &[0.0, 1.5], &[0.3, 0.2]];
    let ends = ends.map(point);
    let goal = point(&[1.5, -0.1]);
    let pairs: Vec<[&[Shape]; 2]> = ends.iter().map(|end| [&end[..], &goal[..]]).collect();
    let request = Request { grid: Grid::Chords(32), threads: 1, ..Request::default() };
    let all = hill().solve_all(&pairs, &request);
    assert!(matches!(all[1], Err(GivenError::Coordinates { .. })), "{:?}", all[1]);
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
    let walls = [[1.0, 0.0], [0.0, 1.0]]
        .map(|normal| [Shape::HalfSpace(HalfSpace::from_slice(&normal, -2.0).expect("a normal"))]);
    let starts = vec![vec![vec![0.0, 0.0], vec![1.0]]];
    let odd = Request { starts, ..Request::default() };
    let cases = [
        (solve([&ends[0], &space], &request), "a point has 3 coordinates in 2 dimensions"),
        (solve([&walls[0], &walls[1]], &request), "both end sets are unbounded"),
        (solve([&ends[0], &[]], &request), "the second set has no pieces"),
        (solve([&ends[0], &ends[1]], &odd), "a point of a start has 1 coordinates"),
        (
            solve([&ends[0], &ends[1]], &Request { grid: Grid::Chords(0), ..request.clone() }),
            "N = 0",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.contains(expected), "{found}, not {expected}");
    }
    let refused = |text, dimension| Given::parse(text, dimension, &[], &[]).expect_err("refused");
    for dimension in [0, 257] {
        assert_eq!(refused("1 I", dimension), GivenError::Dimension { dimension });
    }
    assert!(matches!(refused("cost(sine(x1))", 1), GivenError::Text(_)));
    assert!(hill().gram(&[1.0]).is_err());
}

/// The text of a formula is read as the same formula.
#[test]
fn a_metric_is_its_text() {
    let given = hill();
    let read = Given::parse(&given.text().expect("a formula"), 2, &[], &[]).expect("a formula");
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
        let request = Request { grid: Grid::Chords(n), ..Request::default() };
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

/// What is proved of a metric given as a value is what is proved of a file, number by number.
#[test]
fn bounds_and_constants_are_those_of_a_file() {
    let file = "[metric]\ncost = \"2 - cos(x1)\"\n[from]\npoint = [0, 0]\n[to]\npoint = [1, 0.5]\n\
                [solve]\nn = 128\n[certify]\nwithin = { ball = { centre = [0, 0], radius = 3 } }\n";
    let question = Question::read(file).expect("a file");
    let answer = question.solve(&mut |_| ()).expect("solved");
    let valleys = Given::parse("cost(2 - cos(x1))", 2, &[], &[]).expect("a formula");
    let ends = [point(&[0.0, 0.0]), point(&[1.0, 0.5])];
    let request = Request { grid: Grid::Chords(128), ..Request::default() };
    let curve = valleys.solve([&ends[0], &ends[1]], &request).expect("solved");
    let (watch, proofs) = (|_: certify::Progress| true, Proofs::default());
    let go_on = &mut |_| ControlFlow::Continue(());
    assert_eq!(curve.bounds(&proofs, &watch, go_on).ok(), answer.bounds);
    let ball = ball(&[0.0, 0.0], 3.0);
    let found = valleys.constants(Some(&ball), &proofs, &watch).expect("sought");
    assert_eq!(found, question.constants().expect("sought"));
    assert_ne!(found, valleys.constants(None, &proofs, &watch).expect("sought"));
    // Claimed constants are used, and looser.
    let claimed = Constants::new(1.0, 9.0, 5.0).expect("constants");
    let loose = Proofs { claimed: Some(claimed), ..proofs };
    let loose = curve.bounds(&loose, &watch, go_on).expect("bounds");
    assert!(loose.rests_on_claims() && loose.lower.value <= answer.length.value);
}

#[test]
fn what_cannot_be_proved_is_said() {
    let (watch, proofs) = (|_: certify::Progress| true, Proofs::default());
    let go_on = &mut |_| ControlFlow::Continue(());
    let constants = |metric: &Given, within: Option<&Shape>| {
        metric.constants(within, &proofs, &watch).map(|_| ()).expect_err("refused").to_string()
    };
    let black_box = Given::black_box(Arc::new(Hill), 2, 1e-3).expect("a step");
    let growing = Given::parse("phi(1 + x1^2)", 1, &[], &[]).expect("a formula");
    let sphere = Shape::Sphere(Sphere::from_slice(&[0.0; 2], 1.0).expect("a radius"));
    let line = ball(&[0.0], 1.0);
    let large = Given::parse("1 I", 13, &[], &[]).expect("a formula");
    for (metric, within, message) in [
        (&black_box, None, "by its values only"),
        (&growing, None, "name a ball or a box"),
        (&hill(), Some(&sphere), "a ball or a box, not"),
        (&hill(), Some(&line), "1 coordinates in 2 dimensions"),
        (&large, None, "in up to 12 dimensions"),
    ] {
        let said = constants(metric, within);
        assert!(said.contains(message), "{said}");
    }
    let ends = [point(&[-1.5, 0.05]), point(&[1.5, -0.1])];
    let ends = [&ends[0][..], &ends[1][..]];
    let curve = black_box.solve(ends, &Request::default()).expect("solved");
    let said = curve.bounds(&proofs, &watch, go_on).expect_err("refused");
    assert!(said.contains("by its values only"), "{said}");
}

/// No theorem is about this rule. A certificate needs none, and no constants.
#[test]
fn a_certificate_takes_the_place_of_a_theorem() {
    let (watch, go_on) = (|_: certify::Progress| true, &mut |_| ControlFlow::Continue(()));
    let ends = [point(&[-1.5, 0.05]), point(&[1.5, -0.1])];
    let request = Request { rule: Rule::TRUE_TRAPEZOID, ..Request::default() };
    let curve = hill().solve([&ends[0], &ends[1]], &request).expect("solved");
    let bounds = curve.bounds(&Proofs::default(), &watch, go_on).expect("a certificate");
    assert_eq!((bounds.lower_by.as_str(), bounds.constants.as_ref()), ("a certificate", None));
    // The distance is 4.675271172 to ten digits, by extrapolation.
    let d = 4.675_271_17;
    assert!(bounds.lower.value < d && bounds.lower.value > d * (1.0 - 1e-3), "{bounds:?}");
    assert!(bounds.upper.value > d && bounds.upper.value <= curve.length().value * 1.000_001);
    // Claims are about theorems, which take the minimum of a rule of the paper.
    let claimed = Constants::new(1.0, 25.0, 50.0).expect("constants");
    let proofs = Proofs { claimed: Some(claimed), ..Proofs::default() };
    let bounds = curve.bounds(&proofs, &watch, &mut |_| ControlFlow::Continue(()));
    let bounds = bounds.expect("by claims");
    assert!(bounds.rests_on_claims() && bounds.lower.value <= d, "{bounds:?}");
    assert!(bounds.upper.value > d && bounds.upper.value <= curve.length().value * 1.000_001);
}

/// On a straight line the least value may be at an end, inside, or in the middle of a chord.
#[test]
fn the_least_entry_along_a_curve_is_that_of_all_points_and_middles() {
    let flat = Given::parse("1 I", 2, &[], &[]).expect("a formula");
    let ends = [point(&[0.0, 0.0]), point(&[1.0, 0.5])];
    for n in [1, 2, 7, 64, 301] {
        let request = Request { grid: Grid::Chords(n), ..Request::default() };
        let curve = flat.solve([&ends[0], &ends[1]], &request).expect("solved");
        let points: Vec<Vec<f64>> = curve.points().chunks(2).map(<[f64]>::to_vec).collect();
        let middle = |pair: &[Vec<f64>]| {
            let coordinates = pair[0].iter().zip(&pair[1]);
            coordinates.map(|(a, b)| a + 0.5 * (b - a)).collect::<Vec<f64>>()
        };
        let all: Vec<Vec<f64>> =
            points.iter().cloned().chain(points.windows(2).map(middle)).collect();
        for text in ["phi(3 - x1)", "phi(3 + x1)", "phi(1 + (x1 - 0.5)^2)", "phi(x2 - 3)"] {
            let metric = Given::parse(text, 2, &[], &[]).expect("a formula");
            let first = |x: &[f64]| metric.gram(x).expect("two coordinates")[0];
            let (value, at) = metric.least_entry_along(&curve).expect("a curve").expect("points");
            let least = all.iter().map(|x| first(x.as_slice())).fold(f64::INFINITY, f64::min);
            // Programs may round in another way.
            assert!((value - least).abs() < 1e-14, "{text}, N = {n}: {value} {least}");
            assert!((first(at.as_slice()) - value).abs() < 1e-14, "{text}, N = {n}: {at:?}");
        }
    }
    let line = Given::parse("1 I", 1, &[], &[]).expect("a formula");
    let curve = flat.solve([&ends[0], &ends[1]], &Request::default()).expect("solved");
    let refused = line.least_entry_along(&curve);
    assert!(matches!(refused, Err(GivenError::Coordinates { found: 2, dimension: 1, .. })));
}

/// `(1 + Σ (m/δ)²) H`: with every region once, and nothing inside any of them.
#[test]
fn a_metric_with_obstacles_is_multiplied_by_their_factor() {
    let metric = Given::parse("phi(1 + x1^2)", 2, &[], &[]).expect("a formula");
    let regions = [
        Region::Set(ball(&[1.0, -2.0], 0.5)),
        Region::Set(Shape::HalfSpace(HalfSpace::from_slice(&[0.0, 2.0], -6.0).expect("a normal"))),
        Region::Negative("x1 + 4".to_owned()),
    ];
    let avoiding = metric.avoiding(&regions, 0.3).expect("obstacles");
    for x in [[0.5, 1.0_f64], [-3.5, -2.5], [1.5, -1.5]] {
        let ball = (x[0] - 1.0_f64).hypot(x[1] + 2.0) - 0.5;
        let terms = [ball, x[1] + 3.0, x[0] + 4.0].map(|away| (0.3 / away).powi(2));
        let exact = (1.0 + terms.iter().sum::<f64>()) * (1.0 + x[0] * x[0]);
        let found = avoiding.gram(&x).expect("two coordinates");
        // The logarithm and its exponential round relative to the exponent.
        assert!((found[0] / exact - 1.0).abs() < 1e-13, "{x:?}: {found:?} {exact}");
        assert_eq!([found[1], found[2], found[3]], [0.0, 0.0, found[0]]);
    }
    for inside in [[1.0, -2.25], [0.0, -4.0], [-5.0, 0.0]] {
        assert!(!avoiding.gram(&inside).expect("two coordinates")[0].is_finite(), "{inside:?}");
    }
    // No region knows the distance from another one.
    for name in ["obstacle1", "u1", "u2"] {
        let hidden = [regions[0].clone(), Region::Negative(format!("{name} + 9"))];
        let refused = metric.avoiding(&hidden, 0.3).map(|_| ()).expect_err("an unknown name");
        assert!(refused.to_string().contains(&format!("unknown name {name}")), "{refused}");
    }
    let none = metric.avoiding(&[], 0.3).expect("no obstacles");
    assert_eq!(none.gram(&[0.5, 1.0]), metric.gram(&[0.5, 1.0]));
}

#[test]
fn what_is_no_obstacle_is_refused() {
    let metric = Given::parse("1 I", 2, &[], &[]).expect("a formula");
    let obstacle = |radius: f64| Region::Set(ball(&[1.0, -2.0], radius));
    for margin in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = metric.avoiding(&[obstacle(1.0)], margin).map(|_| ());
        assert!(matches!(refused, Err(GivenError::Margin { .. })), "{refused:?}");
    }
    let sphere = Sphere::from_slice(&[0.0, 0.0], 1.0).expect("a radius");
    // The second region counts too.
    for region in [obstacle(0.0), Region::Set(Shape::Sphere(sphere))] {
        let refused = metric.avoiding(&[obstacle(1.0), region], 0.3).map(|_| ());
        assert!(matches!(refused, Err(GivenError::NoInside { .. })), "{refused:?}");
    }
    let space = Region::Set(ball(&[0.0; 3], 1.0));
    let refused = metric.avoiding(&[space], 0.3).map(|_| ());
    assert!(matches!(refused, Err(GivenError::Coordinates { found: 3, dimension: 2, .. })));
    let black_box = Given::black_box(Arc::new(Hill), 2, 1e-3).expect("a step");
    let refused = black_box.avoiding(&[obstacle(1.0)], 0.3).map(|_| ());
    assert!(matches!(refused, Err(GivenError::NoFormula)), "{refused:?}");
}

/// The nodes may be as far apart along each axis as they like; the corners and the spacings have as many
/// numbers as there are axes.
#[test]
fn a_lattice_has_a_spacing_for_each_axis() {
    let wall = "cost(1 + 100*exp(-(x1/0.1)^2)*(1 - exp(-((x2 - 3)/0.3)^2)))";
    let metric = Given::parse(wall, 2, &[], &[]).expect("a formula");
    let ends = [point(&[-1.0, 0.0]), point(&[1.0, 0.0])];
    let with = |spacing: &[f64], upper: &[f64], grid: Grid| {
        let (lower, upper, spacing) = (vec![-2.0, -1.0], upper.to_vec(), spacing.to_vec());
        let lattice = Some(Nodes { lower, upper, spacing, classes: 1 });
        metric.solve([&ends[0], &ends[1]], &Request { grid, lattice, ..Request::default() })
    };
    let chords = Grid::Chords(512);
    let length = with(&[0.05, 0.1], &[2.0, 4.0], chords).expect("a way").length().value;
    // √40 is the way to the gap and back, without the wall.
    assert!((6.3..7.0).contains(&length), "{length}");
    for (spacing, upper) in [(&[0.1; 3][..], &[2.0, 4.0][..]), (&[0.1][..], &[2.0][..])] {
        let refused = with(spacing, upper, chords).map(|_| ());
        assert!(matches!(
            refused,
            Err(GivenError::Request(RequestError::Lattice(GraphPathError::Coordinates {
                dimension: 2,
                ..
            })))
        ));
    }
    let both = with(&[0.1], &[2.0, 4.0], Grid::Tolerance(1e-3)).map(|_| ());
    assert!(
        matches!(both, Err(GivenError::Request(RequestError::LatticeAndTolerance))),
        "{both:?}"
    );
}

/// Without starts of its own a search that has only these has none.
#[test]
fn a_search_with_no_start_at_all_is_refused() {
    let request = Request { only_these_starts: true, ..Request::default() };
    let found = hill().solve([&point(&[-1.5, 0.0]), &point(&[1.5, 0.0])], &request);
    assert!(found.is_err(), "{found:?}");
}
