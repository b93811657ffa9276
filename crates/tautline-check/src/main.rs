//! Checks a certificate: `tautline-check FILE`. Exit codes: 0 proved, 1 refused, 2 not read.

use std::{
    io::{self, Write},
    process::ExitCode,
};

use tautline_check::AnyCertificate;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file] = &arguments[..] else {
        eprintln!("usage: tautline-check FILE");
        return ExitCode::from(2);
    };
    let text = match std::fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) => {
            eprintln!("{file}: {error}");
            return ExitCode::from(2);
        }
    };
    match AnyCertificate::read(&text).and_then(|certificate| certificate.check()) {
        Ok(verdict) => {
            // A reader that has seen enough closes the pipe.
            match write!(io::stdout(), "{}{verdict}", verdict.statement) {
                Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                    eprintln!("{file}: proved, but not written: {error}");
                    ExitCode::from(2)
                }
                _ => ExitCode::SUCCESS,
            }
        }
        Err(error) => {
            eprintln!("{file}: refused: {error}");
            ExitCode::from(1)
        }
    }
}
