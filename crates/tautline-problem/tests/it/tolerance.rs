//! Lengths to a tolerance.

use tautline_problem::{Answer, Question};

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

/// On 128 chords the extrapolation is above the length, by far more than the tolerance.
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

/// On 128 chords the wall is between the nodes, and there is no estimate to go by.
#[test]
fn a_line_that_is_not_resolved_is_refined() {
    let wall = "metric = { cost = \"1 + 5*exp(-(x1 - 0.0031)^2*1e4)\" }\n\
                from = { point = [-2] }\nto = { point = [2] }\n";
    // 4 + 5 √π 10⁻²
    let distance = 4.0 + 0.05 * std::f64::consts::PI.sqrt();
    let found = answer(wall, 1e-6);
    let estimate = found.extrapolated.expect("several grids");
    let error = estimate.value / distance - 1.0;
    assert!(found.resolved && found.n > 128 && error.abs() < 1e-6, "{error:e}, {}", found.n);
}

#[test]
fn ends_that_touch_are_within_any_tolerance() {
    let touching = "metric = { phi = \"1 + x1^2\" }\nfrom = { point = [1, 1] }\n\
                    to = { ball = { centre = [0, 1], radius = 1 } }\n";
    let found = answer(touching, 1e-12);
    assert_eq!((found.length.value, found.within_tolerance), (0.0, Some(true)));
    assert_eq!((found.search.stop, found.search.converged), ("the sets touch", true));
}
