//! The command `tautline`.

mod arguments;
mod decimal;
mod draft;
mod error;
mod plan_file;
mod problem;
mod report;
mod timed;
mod verbs;
mod write;

use std::process::ExitCode;

use clap::Parser;

use arguments::{Arguments, Verb};

fn main() -> ExitCode {
    let done = match Arguments::parse().verb {
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
            eprintln!("{error}");
            error.code()
        }
    }
}
