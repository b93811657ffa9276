//! Files that claim too much, and metrics that are none.

use std::f64::consts::{FRAC_PI_2, PI};

use serde_json::Value;

use crate::program::{file, numbers, run, run_on, with_status};

/// The ascents of the kit find the extreme of a smooth formula to about a millionth.
const FOUND: f64 = 1e-5;

/// A point of a smooth extreme is then known to about the root of that.
const NEAR: f64 = 1e-2;

struct Lie {
    audit: Value,
    claimed: f64,
    found: f64,
    point: Vec<f64>,
    direction: Vec<f64>,
}

/// Audits a file that must lie about one thing alone, within 20 seconds.
fn lie(name: &str, about: &str) -> Lie {
    let start = std::time::Instant::now();
    let ran = run(&[&file(name), "--json"]);
    assert!(start.elapsed().as_secs_f64() < 20.0);
    let audit = ran.json();
    assert_eq!((ran.code, audit["verdict"].as_str()), (1, Some("lies")), "{}", ran.out);
    let lies = audit["lies"].as_array().expect("an array");
    assert!(lies.len() == 1 && lies[0]["about"] == about, "{lies:?}");
    let number = |name: &str| lies[0][name].as_f64().expect("a number");
    let [point, direction] = ["point", "direction"].map(|name| numbers(&lies[0][name]));
    let norm = direction.iter().map(|x| x * x).sum::<f64>();
    assert!((norm - 1.0).abs() < 1e-12, "{direction:?}");
    Lie { claimed: number("claimed"), found: number("found"), point, direction, audit }
}

/// Returns the distance of a number from the nearest multiple of another.
fn from_multiple(x: f64, of: f64) -> f64 {
    (x - (x / of).round() * of).abs()
}

/// `H = 2.2 I`, and all claims are true; doubles compute eigenvalues from 0.2 to 4.2. A law may fail, since
/// laws compute in doubles, but no claim is said to be false.
#[test]
fn rounding_is_no_lie() {
    for (metric, claims) in [
        (
            "phi = \"2.2 + 1e16*(sin(x1)^2 + cos(x1)^2 - 1)\"",
            "c1 = 2.1, c2 = 2.3, l_h = 0, m_h = 0",
        ),
        ("phi = \"2.2 + (x1 + 1e16) - 1e16\"", "c1 = 2.1, c2 = 3.3, l_h = 1, m_h = 0"),
    ] {
        let file = format!(
            "dimension = 2\n[metric]\n{metric}\n[certify]\nconstants = {{ {claims} }}\n\
             [audit]\nregion = {{ lower = [0.1, 0], upper = [0.9, 1] }}\n"
        );
        let audit = run_on(&["-", "--json", "--cases", "16"], &file).json();
        let lies = audit["lies"].as_array().expect("an array");
        let about = |name: &str| lies.iter().filter(|lie| lie["about"] == name).count();
        assert_eq!([about("H"), about("c1"), about("c2")], [0, 0, 0], "{lies:?}");
    }
}

#[test]
fn a_lipschitz_constant_that_is_a_tenth_too_small_is_named() {
    let lie = lie("wrong_l_h", "L_H");
    assert_eq!(lie.claimed, 3.963);
    // The derivative of (2 − cos x)² is 2 (2 − cos x) sin x, and largest where 2 cos x = cos 2x.
    let x = lie.point[0];
    assert!((lie.found - 4.403_669_475).abs() < FOUND, "{}", lie.found);
    assert!((lie.found - (2.0 * (2.0 - x.cos()) * x.sin()).abs()).abs() < 1e-12);
    assert!((2.0 * x.cos() - (2.0 * x).cos()).abs() < NEAR, "{x}");
    assert_eq!([lie.direction[0].abs(), lie.direction[1]], [1.0, 0.0]);
    // Statements with this hypothesis are not blamed on the paper.
    assert!(with_status(&lie.audit, "false_hypothesis").contains(&"theorem_1_1"));
    assert!(with_status(&lie.audit, "fails").contains(&"no_constant_is_refuted"));
}

#[test]
fn a_least_eigenvalue_that_is_a_tenth_too_large_is_named_in_twelve_dimensions() {
    let lie = lie("wrong_c1", "c1");
    assert!(lie.claimed == 1.1 && (lie.found - 1.0).abs() < FOUND, "{}", lie.found);
    let (x3, x12) = (lie.point[2], lie.point[11]);
    assert!((lie.found - (2.0 + x3.cos() * x12.cos())).abs() < 1e-12);
    assert!(from_multiple(x3, PI) < NEAR && from_multiple(x12, PI) < NEAR, "{x3} {x12}");
}

#[test]
fn a_largest_eigenvalue_between_the_axes_is_named() {
    let lie = lie("wrong_c2", "c2");
    assert!(lie.claimed == 2.7 && (lie.found - 3.0).abs() < FOUND, "{}", lie.found);
    assert!(from_multiple(lie.point[0] - FRAC_PI_2, PI) < NEAR, "{:?}", lie.point);
    // wᵀ H(x) w = 2 + 2 w₁ w₂ sin x₁
    let product = lie.direction[0] * lie.direction[1] * lie.point[0].sin();
    assert!((2.0 + 2.0 * product - lie.found).abs() < 1e-12);
}

#[test]
fn a_second_derivative_along_a_diagonal_is_named_in_four_dimensions() {
    let lie = lie("wrong_m_h", "M_H");
    assert!(lie.claimed == 3.6 && (lie.found - 4.0).abs() < FOUND, "{}", lie.found);
    for w in &lie.direction {
        assert!((w.abs() - 0.5).abs() < NEAR && w * lie.direction[0] > 0.0, "{:?}", lie.direction);
    }
    let sum: f64 = lie.point.iter().sum();
    assert!((sum.sin().abs() - 1.0).abs() < FOUND, "{sum}");
    // L_H and the constants of the paper are right: nothing else fails.
    assert_eq!(with_status(&lie.audit, "fails"), ["m_h_bounds_the_second_derivative"]);
}

#[test]
fn an_indefinite_spot_is_named_with_its_eigenvector() {
    let lie = lie("wrong_indefinite", "H");
    assert_eq!(lie.claimed, 0.0);
    assert!((lie.found + 0.05).abs() < FOUND, "{}", lie.found);
    assert!((lie.point[0] - 1.0).abs() < NEAR && (lie.point[1] - 0.5).abs() < NEAR);
    assert!((lie.direction[0] + lie.direction[1]).abs() < 1e-12, "{:?}", lie.direction);
    let why = lie.audit["no_constants"].as_str().expect("a reason");
    assert_eq!(why, "H is not a metric in the region");
    assert!(with_status(&lie.audit, "not_tried").contains(&"theorem_1_1"));
}

/// The matrix is indefinite around the origin, far from the box of the samples.
#[test]
fn an_indefinite_spot_outside_the_samples_is_found_by_the_proof() {
    let metric = "dimension = 2\n[metric]\nupper = [[1, \"1.5*exp(-x1^2 - x2^2)\"], [1]]\n";
    let region = "[audit]\nregion = { lower = [2, 2], upper = [3, 3] }\n";
    let ran = run_on(&["-", "--json"], &format!("{metric}{region}"));
    let audit = ran.json();
    assert_eq!((ran.code, audit["verdict"].as_str()), (1, Some("lies")), "{}", ran.out);
    let lie = &audit["lies"][0];
    let [x, w] = ["point", "direction"].map(|name| numbers(&lie[name]));
    let bump = 1.5 * (-x[0] * x[0] - x[1] * x[1]).exp();
    let found = lie["found"].as_f64().expect("a number");
    assert!(bump > 1.0 && (found - (1.0 - bump)).abs() < 1e-14, "{found}");
    assert!((w[0] + w[1]).abs() < 1e-12, "{w:?}");
}

/// `H` jumps by 1 at the line `x₁ = 0`: only a difference quotient shows it.
#[test]
fn a_jump_is_shown_by_two_points() {
    let file = "dimension = 2\n[metric]\nphi = \"3 + x1/(2*sqrt(x1^2))\"\n\
                [certify.constants]\nc1 = 2.5\nc2 = 3.5\nl_h = 1\n\
                [audit]\nregion = { lower = [-1.1, -1], upper = [1, 1.2] }\n";
    let audit = run_on(&["-", "--json"], file).json();
    let lies = audit["lies"].as_array().expect("an array");
    let lie = lies.iter().find(|lie| lie["about"] == "L_H").expect("a lie");
    let [x, y] = ["point", "other"].map(|name| numbers(&lie[name]));
    assert!(x[0] * y[0] <= 0.0, "{x:?} {y:?}");
}

/// The root is undefined on the left of the box.
#[test]
fn a_box_where_the_formula_is_undefined_is_named() {
    let metric = "dimension = 2\n[metric]\nphi = \"2 + sqrt(x1)\"\n";
    let region = "[audit]\nregion = { lower = [-1, -1], upper = [1, 1] }\n";
    let claims = "[certify.constants]\nc1 = 2\nc2 = 4\nl_h = 1\n";
    for claims in [claims, ""] {
        let ran = run_on(&["-"], &format!("{metric}{claims}{region}"));
        assert_eq!(ran.code, 1, "{}", ran.err);
        let said = "H is not a metric: the entry (1, 1) of H(x) is NaN at x = (-";
        let line = ran.out.lines().find(|line| line.contains(said)).expect(&ran.out);
        assert!(line.contains("name a region without this point"), "{line}");
    }
}
