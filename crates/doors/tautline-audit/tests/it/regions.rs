//! Where samples are drawn, and where constants hold.

use crate::program::{numbers, run_on};

/// Returns the box of the samples of a metric, and why it is this one.
fn region(rest: &str) -> ([Vec<f64>; 2], String) {
    // Few samples: this is not about the laws.
    let ran = run_on(&["-", "--json", "--cases", "1"], &format!("dimension = 2\n{rest}"));
    let audit = ran.json();
    let region = &audit["region"];
    let corners = ["lower", "upper"].map(|end| numbers(&region[end]));
    (corners, region["why"].as_str().expect("a text").to_owned())
}

const METRIC: &str =
    "[metric]\nphi = \"2 + x1^2\"\n[certify.constants]\nc1 = 2\nc2 = 99\nl_h = 99\n";

const SETS: &str = "[from]\npoint = [0, 0]\n[to]\npoint = [4, 2]\n";

#[test]
fn the_box_of_the_file_comes_first() {
    let audit = "[audit]\nregion = { lower = [0, 1], upper = [2, 3] }\n";
    let ([low, high], why) = region(&format!("{METRIC}{SETS}{audit}"));
    assert_eq!((low, high, &*why), (vec![0.0, 1.0], vec![2.0, 3.0], "[audit] region"));
}

#[test]
fn without_a_box_the_sets_give_one_with_a_margin() {
    let ([low, high], _) = region(&format!("{METRIC}{SETS}"));
    assert_eq!((low, high), (vec![-1.0, -1.0], vec![5.0, 3.0]));
}

#[test]
fn without_sets_the_box_is_said_to_be_arbitrary() {
    let ([low, high], why) = region(METRIC);
    assert_eq!((low, high), (vec![-1.0, -1.0], vec![1.0, 1.0]));
    assert!(why.contains("neither"), "{why}");
}

#[test]
fn a_period_is_sampled_whole() {
    let metric = "[metric]\nphi = \"2 + sin(x1)\"\n[certify.constants]\nc1 = 1\nc2 = 3\nl_h = 1\n";
    let ([low, high], why) = region(&format!("{metric}{SETS}"));
    assert_eq!(why, "one period of the formula");
    // The period is rounded up.
    assert!(low[0] == 0.0 && (high[0] - std::f64::consts::TAU).abs() < 1e-14);
    assert_eq!((low[1], high[1]), (-1.0, 3.0));
}

/// Of a metric with rational parts nothing is known farther out than 2¹⁰⁰. Here it is 2 there, and
/// about 2³⁰⁰ near `x₁ = 2¹⁵⁰`.
#[test]
fn what_is_proved_only_if_the_metric_settles_is_said_to_be_so() {
    let settles = "; proved on all of space, if the metric settles within a distance of 2^100";
    for (phi, if_it_settles) in
        [("2 + (x1*2^-150)^2/(1 + 2^-600*x1^4)", true), ("2 + 1/(2 + cos(x1))", false)]
    {
        let file = format!(
            "dimension = 1\n[metric]\nphi = \"{phi}\"\n[audit]\n\
             region = {{ lower = [0], upper = [2] }}\n"
        );
        let audit = run_on(&["-", "--json", "--cases", "4"], &file).json();
        let constants = &audit["constants"];
        assert!(constants["proved"] == true && constants["within"].is_null(), "{constants}");
        assert_eq!(constants["if_it_settles"], if_it_settles, "{phi}");
        let text = run_on(&["-", "--cases", "4"], &file).out;
        assert_eq!(text.contains(settles), if_it_settles, "{text}");
    }
}

/// The metric grows without bound, so that it has constants in a ball only.
#[test]
fn constants_that_are_not_global_are_proved_in_the_largest_ball_of_the_box() {
    let file = "dimension = 2\n[metric]\nphi = \"2 + x1^2\"\n[audit]\n\
                region = { lower = [0, 0], upper = [2, 1] }\n";
    let audit = run_on(&["-", "--json", "--cases", "4"], file).json();
    let constants = &audit["constants"];
    let within = &constants["within"];
    assert_eq!(
        (numbers(&within["centre"]), within["radius"].as_f64()),
        (vec![1.0, 0.5], Some(0.5))
    );
    // In this ball x₁ is between ½ and 3/2.
    let c2 = constants["c2"].as_f64().expect("a number");
    assert!((4.25..4.26).contains(&c2), "{c2}");
    // The formula itself is tried in the whole box.
    let why = audit["region"]["why"].as_str().expect("a text");
    assert!(why.ends_with("for the laws of the formula, the box (0, 0) to (2, 1)"), "{why}");
}

#[test]
fn in_twelve_dimensions_constants_are_proved_and_tried() {
    let file = "dimension = 12\n[metric]\nphi = \"3 + sin(x1)*cos(x12)\"\n";
    let ran = run_on(&["-", "--json", "--cases", "16"], file);
    let audit = ran.json();
    assert!(audit["no_constants"].is_null() && audit["constants"]["c1"].as_f64() == Some(2.0));
    assert!(crate::program::with_status(&audit, "fails").is_empty(), "{audit}");
    // Least and largest eigenvalue are 2 and 4.
    let measured = audit["measured"].as_array().expect("an array");
    for (found, exact) in measured.iter().zip([2.0, 4.0]) {
        assert!((found["value"].as_f64().expect("a number") - exact).abs() < 1e-5, "{found}");
    }
}

#[test]
fn where_a_formula_is_too_long_nothing_is_proved_but_the_formula_is_tried() {
    let sum = (1..=12).map(|i| format!("sin({i}*x{i})")).collect::<Vec<_>>().join(" + ");
    let outputs: Vec<String> =
        (1..=12).map(|k| format!("\"x{k} + tanh({k}*({sum}))/9\"")).collect();
    let file = format!("dimension = 12\n[metric]\npullback = [{}]\n", outputs.join(", "));
    // To record the formula takes most of the usual time limit on a busy machine.
    let ran = run_on(&["-", "--json", "--cases", "16", "--time-limit", "300"], &file);
    let audit = ran.json();
    assert_eq!((ran.code, audit["verdict"].as_str()), (1, Some("incomplete")));
    let why = audit["no_constants"].as_str().expect("a reason");
    assert!(why.contains("in 12 dimensions constants are proved from formulas of up to 720 steps"));
    assert_eq!(crate::program::with_status(&audit, "holds").len(), 3);
}
