//! Bad input ends with exit code 2 and a message that names it.

use crate::program::{run, run_on};

const METRIC: &str = "dimension = 2\n[metric]\nphi = \"2 + sin(x1)\"\n";

#[track_caller]
fn refused(arguments: &[&str], input: &str, message: &str) {
    let ran = run_on(arguments, input);
    assert_eq!((ran.code, &*ran.out), (2, ""), "{}", ran.err);
    assert!(ran.err.contains(message), "{}", ran.err);
}

#[test]
fn a_wrong_file_is_refused_with_its_place() {
    let wrong = METRIC.replace("sin", "sine");
    refused(&["-"], &wrong, "standard input:3:12");
    refused(&["-"], &format!("{METRIC}[audit]\ncases = 0\n"), "no samples");
    let region = "[audit]\nregion = { lower = [0, 1], upper = [1, 1] }\n";
    refused(&["-"], &format!("{METRIC}{region}"), "an empty region");
    let claims = "[certify.constants]\nc1 = 2\nc2 = 1\nl_h = 1\n";
    refused(&["-"], &format!("{METRIC}{claims}"), "standard input:5:6");
}

/// The laws are compiled for each dimension.
#[test]
fn a_metric_in_thirteen_dimensions_is_refused() {
    let ran = run_on(&["-"], &METRIC.replace("dimension = 2", "dimension = 13"));
    assert_eq!(ran.out, "");
    assert!(ran.err.contains("audits run in up to 12 dimensions, not 13"), "{}", ran.err);
}

#[test]
fn a_missing_file_is_named() {
    refused(&["no/such.toml"], "", "no/such.toml");
}

#[test]
fn wrong_arguments_are_refused() {
    refused(&[], "", "<FILE>");
    refused(&["-", "--cases", "0"], METRIC, "--cases");
    refused(&["-", "--time-limit", "-1"], METRIC, "--time-limit");
    refused(&["-", "--time-limit", "nan"], METRIC, "positive number of seconds");
    refused(&["-", "--json", "--markdown"], METRIC, "--markdown");
}

#[test]
fn help_shows_an_example() {
    let ran = run(&["--help"]);
    assert!(ran.code == 0 && ran.out.contains("$ tautline audit wrong_constants.toml"));
}
