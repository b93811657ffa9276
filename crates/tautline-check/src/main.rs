//! Checks a certificate: `tautline-check FILE`. Exit codes: 0 proved, 1 refused, 2 not read.

use std::process::ExitCode;

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
            print!("{}{verdict}", verdict.statement);
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{file}: refused: {error}");
            ExitCode::from(1)
        }
    }
}
