//! What is said and printed at the terminal. `println!` and `eprintln!` would panic if nobody reads.

use std::{
    fmt::Display,
    io::{self, Write},
};

use crate::Failure;

/// Says something. Nobody may listen, which is no reason to stop.
pub fn say(message: impl Display) {
    let _ = writeln!(io::stderr(), "{message}");
}

/// Prints a line.
///
/// # Errors
///
/// If nobody reads it, or the output is full: what was asked for is not there.
pub fn print(line: impl Display) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let printed = writeln!(out, "{line}").and_then(|()| out.flush());
    printed.map_err(|source| Failure::File { path: "standard output".into(), source })
}
