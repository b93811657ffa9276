//! Makes the figures and tables of the paper: see [`paper::command`].

use std::process::ExitCode;

fn main() -> ExitCode {
    match paper::command::run(std::env::args().skip(1)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            paper::said::say(format!("error: {failure}"));
            ExitCode::FAILURE
        }
    }
}
