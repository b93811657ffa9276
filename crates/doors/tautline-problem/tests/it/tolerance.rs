//! Lengths to a tolerance.

use tautline::Point;
use tautline_any::{Given, Request, Shape};
use tautline_problem::{Answer, Grid, Question};

/// Light in water whose speed changes from 1 to 2 within a tenth.
const LAYERS: &str = "\
metric = { speed = \"1.5 + 0.5*tanh(x2/0.05)\" }
from = { point = [0, -1] }
to = { point = [2, 1] }
";

fn answer(file: &str, tolerance: f64) -> Answer {
    let file = format!("{file}[solve]\ntolerance = {tolerance:e}\n[certify]\nbound = false\n");
    let question = Question::read(&file).expect("a problem");
    question.solve(&mut |_| ()).expect("solved")
}

/// Returns `∫ f` over `[-1, 1]` by Simpson's rule. The layers are a fortieth wide, which is 1000 steps.
fn integral(f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: i32 = 40_000;
    let h = 2.0 / f64::from(STEPS);
    let weight = |i: i32| match i {
        0 | STEPS => 1.0,
        _ if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    (0..=STEPS).map(|i| weight(i) * f(-1.0 + h * f64::from(i))).sum::<f64>() * h / 3.0
}

/// Returns the travel time in [`LAYERS`] by Snell's law: `sin/speed = p` is constant along a ray.
fn travel_time() -> f64 {
    let speed = |y: f64| 1.5 + 0.5 * (y / 0.05).tanh();
    let cosine = |p: f64, y: f64| (1.0 - (p * speed(y)).powi(2)).sqrt();
    let across = |p: f64| integral(|y| p * speed(y) / cosine(p, y));
    let (mut low, mut high) = (0.0, 0.499);
    for _ in 0..60 {
        let p = 0.5 * (low + high);
        if across(p) < 2.0 { low = p } else { high = p }
    }
    integral(|y| 1.0 / (speed(y) * cosine(low, y)))
}

/// On coarse grids the error of the extrapolation is far above the tolerance.
#[test]
fn a_tolerance_is_kept_across_a_thin_layer() {
    let time = travel_time();
    assert!((time - 2.011_381_962_5).abs() < 1e-10, "{time}");
    for tolerance in [1e-4, 1e-6, 1e-9] {
        let found = answer(LAYERS, tolerance);
        let error = found.length.value / time - 1.0;
        assert!(error.abs() < tolerance, "{error:e} with {} chords", found.n);
        assert_eq!(found.within_tolerance, Some(true));
    }
}

/// On 256 chords the wall is between the nodes, and there is no estimate to go by.
#[test]
fn a_line_that_is_not_resolved_is_refined() {
    let wall = "metric = { cost = \"1 + 5*exp(-(x1 - 0.0031)^2*1e5)\" }\n\
                from = { point = [-2] }\nto = { point = [2] }\n";
    // 4 + 5 √(π 10⁻⁵)
    let distance = 4.0 + 5.0 * (std::f64::consts::PI * 1e-5).sqrt();
    let found = answer(wall, 1e-6);
    let estimate = found.extrapolated.expect("several grids");
    let error = estimate.value / distance - 1.0;
    assert!(found.resolved && found.n > 256 && error.abs() < 1e-6, "{error:e}, {}", found.n);
}

#[test]
fn ends_that_touch_are_within_any_tolerance() {
    let touching = "metric = { phi = \"1 + x1^2\" }\nfrom = { point = [1, 1] }\n\
                    to = { ball = { centre = [0, 1], radius = 1 } }\n";
    let found = answer(touching, 1e-12);
    assert_eq!((found.length.value, found.within_tolerance), (0.0, Some(true)));
    assert_eq!((found.search.stop, found.search.converged), ("the sets touch", true));
}

/// The solver reports the curve of each coarser grid. It looks for other minima on the last one only.
#[test]
fn the_solver_reports_each_grid_on_the_way_to_the_tolerance() {
    let hill = "metric = { cost = \"1 + 2*exp(-(x1^2 + x2^2))\" }\n\
                from = { point = [-2, -0.2] }\nto = { point = [2, -0.2] }\n\
                solve = { tolerance = 1e-8 }\n";
    let mut told = Vec::new();
    let question = Question::read(hill).expect("a problem");
    let last = question.solve(&mut |answer| told.push(answer.clone())).expect("solved");
    let [coarser @ .., finest] = &told[..] else { panic!("nothing was told") };
    assert!(!coarser.is_empty() && told.is_sorted_by(|a, b| a.n < b.n));
    for answer in coarser {
        assert_eq!((answer.within_tolerance, answer.other_minima.len()), (Some(false), 0));
    }
    assert_eq!((finest.within_tolerance, finest.other_minima.len()), (Some(true), 1));
    assert!(finest.bounds.is_none() && finest.no_bounds.is_some() && last.bounds.is_some());
    assert_eq!(finest.curve, last.curve);
}

/// Without steps the search fails on every grid. A few finer ones are tried.
#[test]
fn a_search_that_fails_misses_the_tolerance() {
    let hill = "metric = { cost = \"1 + 2*exp(-(x1^2 + x2^2))\" }\n\
                from = { point = [-2, -0.2] }\nto = { point = [2, -0.2] }\n\
                solve = { tolerance = 1e-8, steps = 0 }\n";
    let answer = Question::read(hill).expect("a problem").solve(&mut |_| ()).expect("a line");
    assert_eq!((answer.n, answer.within_tolerance), (4096, Some(false)));
    assert_eq!((answer.extrapolated, answer.search.converged), (None, false));
}

/// The wall is between all nodes of the rule and of the quadrature. Only the bound sees it.
#[test]
fn a_length_below_its_proved_bound_is_not_resolved() {
    let wall = "metric = { cost = \"1 + 1e4*exp(-((x1-0.1234)/0.00001)^2)\" }\n\
                from = { point = [0] }\nto = { point = [1] }\nsolve = { tolerance = 1e-12 }\n";
    let answer = Question::read(wall).expect("a problem").solve(&mut |_| ()).expect("a line");
    let upper = answer.bounds.expect("proved").upper.value;
    // 1 + 0.1 √π
    let distance = 1.0 + 0.1 * std::f64::consts::PI.sqrt();
    assert!(answer.length.value < 1.01 && (upper / distance - 1.0).abs() < 1e-6, "{upper}");
    assert_eq!((answer.resolved, answer.extrapolated), (false, None));
    assert_eq!(answer.within_tolerance, Some(false));
}

/// The wall has a door, which some grids find and others miss. What 256 chords find is not lost.
#[test]
fn a_minimum_of_a_coarse_grid_is_kept_on_finer_ones() {
    let wall = "metric = { cost = \"1 + 20*exp(-(x1/0.3)^2)*(1 - exp(-((x2 - 2)/0.2)^2))\" }\n\
                from = { point = [-1, 0] }\nto = { point = [1, 0] }\n";
    let found = answer(wall, 1e-6);
    assert!((found.length.value - 5.246_17).abs() < 1e-4, "{}", found.length.value);
    let mut question = Question::read(wall).expect("a problem");
    question.without_bounds();
    // The finer grid alone misses the door, or this would show nothing.
    question.set_grid(Grid::Chords(found.n)).expect("a grid");
    let alone = question.solve(&mut |_| ()).expect("a line");
    assert!(found.n > 256 && alone.length.value > 12.0, "{} chords", found.n);
}

/// On a coarse grid the rule prefers a curve that is 0.07 % longer than another one.
#[test]
fn a_shorter_minimum_is_followed_to_finer_grids() {
    let hills = "metric = { cost = \"1 + 4*exp(-2*(x1^2+x2^2)) + 3*exp(-1e6*(x1-0.0125)^2 - 4*(x2+1)^2)\" }\n\
                 from = { point = [-1.5, -0.0003] }\nto = { point = [1.5, -0.0003] }\n";
    let found = answer(hills, 0.01);
    let error = found.length.value / 4.723_23 - 1.0;
    assert!(error.abs() < 1e-3 && found.resolved, "{error:e}, {} chords", found.n);
    assert_eq!(found.within_tolerance, Some(true));
}

/// The way above the hill is longer. A search that starts there alone stays there on every grid; one that
/// starts there too does not.
#[test]
fn the_only_starts_are_the_only_ones_on_finer_grids() {
    let above = "starts = [[[-1.5, -0.1], [0, 1], [1.5, -0.1]]]\n";
    let hill = |solve: &str| {
        let file = format!(
            "metric = {{ cost = \"1 + 2*exp(-(x1^2 + x2^2))\" }}\nfrom = {{ point = [-1.5, -0.1] }}\n\
             to = {{ point = [1.5, -0.1] }}\n[certify]\nbound = false\n[solve]\n{solve}"
        );
        Question::read(&file).expect("a problem")
    };
    let is_above = |answer: &Answer| answer.curve[answer.curve.len() / 2][1] > 0.0;
    let only = hill(&format!("tolerance = 1e-8\nonly_these_starts = true\n{above}"));
    let mut told = Vec::new();
    let long = only.solve(&mut |answer| told.push(answer.clone())).expect("solved");
    assert_eq!((long.within_tolerance, long.other_minima.len()), (Some(true), 0));
    // On the first grid, on finer ones, and on the last one.
    assert!(told.len() > 1 && told.iter().all(is_above) && is_above(&long));
    let also = hill(&format!("tolerance = 1e-8\n{above}")).solve(&mut |_| ()).expect("solved");
    assert!(!is_above(&also) && also.length.value < long.length.value * (1.0 - 1e-3));
    assert_eq!(also.other_minima.len(), 1);
    // The same, given as values.
    let given = Given::parse("cost(1 + 2*exp(-(x1^2 + x2^2)))", 2, &[], &[]).expect("a formula");
    let ends = [-1.5, 1.5].map(|x| [Shape::Point(Point::from_slice(&[x, -0.1]).expect("finite"))]);
    for (only_these_starts, answer) in [(true, &long), (false, &also)] {
        let starts = vec![vec![vec![-1.5, -0.1], vec![0.0, 1.0], vec![1.5, -0.1]]];
        let grid = Grid::Tolerance(1e-8);
        let request = Request { grid, starts, only_these_starts, ..Request::default() };
        let curve = given.solve([&ends[0], &ends[1]], &request).expect("solved");
        assert_eq!(curve.points(), answer.curve.concat());
    }
}
