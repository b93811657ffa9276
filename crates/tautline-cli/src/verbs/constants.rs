//! `tautline constants`.

use std::process::ExitCode;

use tautline_problem::Failure;

use crate::{
    arguments::Constants,
    error::CommandError,
    problem::ProblemText,
    report,
    timed::{seconds, timed},
    write::print,
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
    if arguments.json {
        let json = serde_json::to_string_pretty(&proved);
        let json = json.map_err(|error| CommandError::NotDone(error.to_string()))?;
        print(&format!("{json}\n"))?;
    } else {
        print(&report::proved_constants(&proved))?;
    }
    Ok(if proved.are_proved() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}
