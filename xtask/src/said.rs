//! What is said and printed at the terminal. `println!` and `eprintln!` would panic if nobody reads.

use std::{
    fmt::Display,
    io::{self, Write},
};

/// Says something. Nobody may listen, which is no reason to stop.
pub(crate) fn say(message: impl Display) {
    let _ = writeln!(io::stderr(), "{message}");
}

/// Prints a line.
///
/// # Errors
///
/// If nobody reads it, or the output is full: what was asked for is not there.
pub(crate) fn print(line: impl Display) -> Result<(), String> {
    let mut out = io::stdout().lock();
    let printed = writeln!(out, "{line}").and_then(|()| out.flush());
    printed.map_err(|error| format!("standard output: {error}"))
}
