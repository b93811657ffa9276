//! `tautline constants`.

use std::process::ExitCode;

use tautline_problem::Failure;

use crate::{
    arguments::Constants,
    error::CommandError,
    problem::ProblemText,
    report,
    timed::{seconds, timed},
    write::{json, print},
};

/// Proves the constants of the metric of a file.
pub(crate) fn constants(arguments: &Constants) -> Result<ExitCode, CommandError> {
    let limit = seconds(arguments.time_limit)?;
    let problem = ProblemText::read(&arguments.file)?;
    let limit = limit.or(problem.question.time_limit());
    let question = problem.question.clone();
    let proved = timed(limit, "proving", move |_, clock| question.constants_watched(clock))?;
    let too_late = || Failure::NotComputed("nothing was proved within the time limit".to_owned());
    let proved = proved.unwrap_or_else(|| Err(too_late()));
    let proved = proved.map_err(|failure| problem.explain(failure))?;
    let text = if arguments.json { json(&proved)? } else { report::proved_constants(&proved) };
    print(&text)?;
    Ok(if proved.are_proved() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}
