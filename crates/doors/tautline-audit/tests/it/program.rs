//! Runs the program.

use std::{
    io::Write,
    process::{Command, Stdio},
};

use serde_json::Value;

/// What the program printed, and how it ended.
pub(crate) struct Ran {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Ran {
    pub(crate) fn json(&self) -> Value {
        let error = format!("not one document: {} {}", self.out, self.err);
        serde_json::from_str(&self.out).expect(&error)
    }
}

/// Runs the program with these arguments.
pub(crate) fn run(arguments: &[&str]) -> Ran {
    run_on(arguments, "")
}

/// Runs the program with these arguments and this standard input.
pub(crate) fn run_on(arguments: &[&str], input: &str) -> Ran {
    let mut program = Command::new(env!("CARGO_BIN_EXE_tautline-audit"));
    // The expected numbers are those of the default seed.
    program.env_remove("TAUTLINE_SEED").env_remove("TAUTLINE_CASES");
    let program = program.args(arguments).stdin(Stdio::piped());
    let child = program.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = child.expect("the program starts");
    let mut stdin = child.stdin.take().expect("a pipe");
    // A program that refuses its arguments does not read.
    let _ = stdin.write_all(input.as_bytes());
    drop(stdin);
    let output = child.wait_with_output().expect("the program ends");
    let [out, err] = [output.stdout, output.stderr].map(String::from_utf8);
    let (out, err) = (out.expect("text"), err.expect("text"));
    Ran { code: output.status.code().expect("an exit code"), out, err }
}

/// Returns the path of a problem file of the tests.
pub(crate) fn file(name: &str) -> String {
    format!("{}/tests/files/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

/// Returns the numbers of an array.
pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    let numbers = value.as_array().expect("an array").iter();
    numbers.map(|x| x.as_f64().expect("a number")).collect()
}

/// Returns the laws with this status.
pub(crate) fn with_status<'v>(audit: &'v Value, status: &str) -> Vec<&'v str> {
    let laws = audit["laws"].as_array().expect("an array").iter();
    let laws = laws.filter(|law| law["status"] == status);
    laws.map(|law| law["law"].as_str().expect("a name")).collect()
}
