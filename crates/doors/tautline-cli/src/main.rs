//! The command `tautline`.

mod arguments;
mod draft;
mod error;
mod paths;
mod plan_file;
mod problem;
mod report;
mod timed;
mod verbs;
mod write;

use std::process::ExitCode;

use clap::Parser;

use arguments::{Arguments, Verb};
use error::CommandError;

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        // Help that cannot be printed is no success.
        Err(usage) => {
            let code = u8::try_from(usage.exit_code()).unwrap_or(2);
            return ExitCode::from(if usage.print().is_err() { code.max(1) } else { code });
        }
    };
    let done = match arguments.verb {
        Verb::Solve(arguments) => verbs::solve::solve(&arguments),
        Verb::Constants(arguments) => verbs::constants::constants(&arguments),
        Verb::Certify(arguments) => verbs::certify::certify(&arguments),
        Verb::Check(arguments) => verbs::check::check(&arguments),
        Verb::Audit(arguments) => verbs::audit::audit(&arguments),
        Verb::Plot(arguments) => verbs::plot::plot(&arguments),
        Verb::Plan(arguments) => verbs::plan::plan(&arguments),
        Verb::Run(arguments) => verbs::run::run(&arguments),
        Verb::Merge(arguments) => verbs::merge::merge(&arguments),
        Verb::Schema(arguments) => verbs::schema::schema(&arguments),
        Verb::Examples(arguments) => verbs::examples::examples(&arguments),
        Verb::Completions(arguments) => verbs::completions::completions(&arguments),
    };
    match done {
        Ok(code) => code,
        Err(error) => {
            if !matches!(error, CommandError::Unread) {
                write::say(&error);
            }
            error.code()
        }
    }
}
