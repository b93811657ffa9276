//! The constants of a file: of its metric, in its region, with what is known of each.

use tautline_problem::{ConstantAnswer, ConstantsAnswer, Float, Question};

fn found(section: &str) -> ConstantsAnswer {
    let metric = "dimension = 2\n[metric]\ncost = \"2 - cos(x1)\"\n";
    Question::read(&format!("{metric}[certify]\n{section}\n"))
        .expect("a problem")
        .constants()
        .expect("sought")
}

/// With `f = 2 − cos x` the constants are the extremes of `f²`, `f²`, `2 f f′` and `2 (f′² + f f″)`.
#[test]
fn constants_are_the_extremes_in_the_region() {
    let f = |x: f64| 2.0 - x.cos();
    let slope = |x: f64| 2.0 * f(x) * x.sin();
    // f²′ is greatest where 2 cos x − cos 2x = 0: cos x = (1 − √3)/2.
    let steepest = (0.5 - 0.75_f64.sqrt()).acos();
    for (section, region, exact) in [
        ("", "all of space", [1.0, 9.0, slope(steepest), 6.0]),
        (
            "within = { ball = { centre = [0, 5], radius = 1 } }",
            "the ball of radius 1 about [0.0, 5.0]",
            // f²″ is 2 + 4 c (1 − c) with c = cos x, and c is above 1/2.
            [1.0, f(1.0).powi(2), slope(1.0), 2.0 + 4.0 * 1_f64.cos() * (1.0 - 1_f64.cos())],
        ),
        (
            "within = { box = { lower = [1, -1], upper = [2, 7] } }",
            "the box from [1.0, -1.0] to [2.0, 7.0]",
            [f(1.0).powi(2), f(2.0).powi(2), slope(steepest), 3.0],
        ),
    ] {
        let found = found(section);
        assert!(found.are_proved());
        assert_eq!(found.region, region);
        let names: Vec<&str> = found.constants.iter().map(|it| it.name.as_str()).collect();
        assert_eq!(names, ["c1", "c2", "L_H", "M_H"]);
        for (constant, exact) in found.constants.iter().zip(exact) {
            let [lower, upper] = [&constant.lower, &constant.upper].map(|bound| {
                let bound = bound.as_ref().expect("a bound");
                assert_eq!(bound, &Float::from(bound.value));
                bound.value
            });
            // The exact one is rounded.
            let rounding = 1e-14 * exact;
            let is_held = lower <= exact + rounding && exact <= upper + rounding;
            assert!(is_held && upper - lower <= 2e-3 * exact, "{section} {constant:?} {exact}");
            assert!(constant.proved && constant.reason.is_none() && constant.is_known());
            assert_eq!(constant.at.as_ref().map(Vec::len), Some(2), "{constant:?}");
        }
        // What is attained somewhere is between the bounds.
        let at = |k: usize| found.constants[k].at.as_ref().expect("a point")[0];
        assert!((f(at(0)).powi(2) / exact[0] - 1.0).abs() < 2e-3, "{found:?}");
        assert!((f(at(1)).powi(2) / exact[1] - 1.0).abs() < 2e-3, "{found:?}");
    }
}

/// What is proved before the budget is spent is told, with the reason, and is wider.
#[test]
fn a_budget_that_is_spent_leaves_bounds_and_a_reason() {
    let found = found("boxes = 3\ntolerance = 1e-9");
    assert!(!found.are_proved());
    for (constant, exact) in found.constants.iter().zip([1.0, 9.0, 4.4, 6.0]) {
        if constant.proved {
            continue;
        }
        assert!(constant.reason.as_ref().is_some_and(|why| why.contains("box")), "{constant:?}");
        let value = |bound: &Option<Float>| bound.as_ref().map(|bound| bound.value);
        let (lower, upper) = (value(&constant.lower), value(&constant.upper));
        // That of L_H is a little more than 4.4.
        assert!(lower.is_none_or(|lower| lower <= exact + 0.01), "{constant:?}");
        assert!(upper.is_none_or(|upper| exact <= upper), "{constant:?}");
        assert!(constant.at.is_none());
    }
    assert!(found.constants.iter().any(|constant| !constant.proved && constant.upper.is_some()));
}

/// A lower bound on the eigenvalues has to be positive; of the others an upper bound is enough.
#[test]
fn a_constant_is_known_by_the_bound_that_theorems_use() {
    let with = |name: &str, lower: Option<f64>, upper: Option<f64>| ConstantAnswer {
        name: name.to_owned(),
        bounds: "",
        proved: false,
        lower: lower.map(Float::from),
        upper: upper.map(Float::from),
        at: None,
        reason: None,
    };
    for (name, lower, upper, known) in [
        ("c1", Some(0.5), Some(1.0), true),
        ("c1", Some(0.0), Some(1.0), false),
        ("c1", Some(-1.0), Some(1.0), false),
        ("c1", None, Some(1.0), false),
        ("c1", Some(0.5), None, false),
        ("c2", None, Some(1.0), true),
        ("L_H", Some(0.0), Some(1.0), true),
        ("M_H", Some(0.5), None, false),
    ] {
        assert_eq!(with(name, lower, upper).is_known(), known, "{name} {lower:?} {upper:?}");
    }
    let proved = |proved| ConstantAnswer { proved, ..with("c1", Some(1.0), Some(1.0)) };
    let all = |flags: [bool; 2]| {
        let constants = flags.map(proved).to_vec();
        ConstantsAnswer { region: String::new(), if_it_settles: false, constants }.are_proved()
    };
    assert_eq!([[true; 2], [true, false], [false, true]].map(all), [true, false, false]);
}
