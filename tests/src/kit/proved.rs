//! Runs the kit on a formula alone, whose constants are proved. If they cannot be proved, exactly
//! one test fails.

use std::{env, process::Command};

use tautline_kit::prelude::*;

/// This variable is set in the process in which the formula is indefinite.
const INDEFINITE: &str = "TAUTLINE_TESTS_INDEFINITE";

// H(x) = (mean + cos x₁ sin x₂) I
struct Tray {
    mean: f64,
}
impl Metric<2> for Tray {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element(self.mean + x[0].cos() * x[1].sin())
    }
}
metric_suite!(tray: Certified::new(tray(), Accuracy::default()), dimension 2, in Region::cell([0.0, 0.0], [6.3, 6.3]));

fn tray() -> Tray {
    Tray { mean: if env::var_os(INDEFINITE).is_some() { 0.5 } else { 2.0 } }
}

/// Runs the whole suite once more in another process, in which exactly one of its tests fails.
#[test]
fn an_indefinite_metric_fails_once_with_the_point_and_advice() {
    let suite = "kit::proved::tray::";
    let output = Command::new(env::current_exe().expect("this program"))
        .arg(suite)
        .env(INDEFINITE, "")
        .output()
        .expect("it starts");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(!output.status.success(), "{said}");
    let passed = said.lines().filter(|line| line.ends_with("... ok")).count();
    let failed: Vec<_> = said.lines().filter(|line| line.ends_with("... FAILED")).collect();
    assert_eq!(failed, [format!("test {suite}the_metric_has_constants ... FAILED")], "{said}");
    assert!(passed > 50, "{said}");
    let reason = said.lines().find(|line| line.starts_with("no law of this suite is tried: "));
    let (_, point) = reason.and_then(|line| line.split_once("[")).expect("a point");
    let point: Vec<f64> = point
        .split([',', ']'])
        .take(2)
        .map(|number| number.trim().parse().expect("a number"))
        .collect();
    assert!(0.5 + point[0].cos() * point[1].sin() <= 0.0, "{point:?}: {said}");
    assert!(said.contains("Mend the formula at this point"), "{said}");
}
