//! Checks a certificate: `tautline-check [--time-limit SECONDS] FILE`.
//!
//! Exit codes: 0 proved, 1 refused, 2 neither: not read, not written, or not checked in the time.

use std::{
    ffi::OsString,
    fmt::Display,
    io::{self, Write},
    process::ExitCode,
    time::{Duration, Instant},
};

use tautline_check::{AnyCertificate, CheckError};

fn main() -> ExitCode {
    // `args` panics at a name that is not Unicode.
    let words: Vec<OsString> = std::env::args_os().skip(1).collect();
    let (file, limit) = match &words[..] {
        [file] if !file.as_encoded_bytes().starts_with(b"-") => (file, None),
        [option, seconds, file] | [file, option, seconds] if option == "--time-limit" => {
            let number = seconds.to_str().and_then(|seconds| seconds.parse().ok());
            match number.and_then(|s| Duration::try_from_secs_f64(s).ok()) {
                Some(limit) => (file, Some(limit)),
                None => return ended(2, format_args!("{seconds:?} is no number of seconds")),
            }
        }
        _ => return ended(2, "usage: tautline-check [--time-limit SECONDS] FILE"),
    };
    let name = file.display();
    let begun = Instant::now();
    let text = match std::fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) => return ended(2, format_args!("{name}: {error}")),
    };
    let go_on = || limit.is_none_or(|limit| begun.elapsed() < limit);
    match AnyCertificate::read(&text).and_then(|certificate| certificate.check_while(&go_on)) {
        // A reader that has seen enough closes the pipe.
        Ok(verdict) => match write!(io::stdout(), "{}{verdict}", verdict.statement) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                ended(2, format_args!("{name}: proved, but not written: {error}"))
            }
            _ => ExitCode::SUCCESS,
        },
        Err(error @ CheckError::Stopped { .. }) => {
            ended(2, format_args!("{name}: not checked in the time: {error}"))
        }
        Err(error) => ended(1, format_args!("{name}: refused: {error}")),
    }
}

/// Tells why, if anybody listens, and returns the exit code.
fn ended(code: u8, why: impl Display) -> ExitCode {
    // `eprintln!` panics if nobody does.
    let _ = writeln!(io::stderr(), "{why}");
    ExitCode::from(code)
}
