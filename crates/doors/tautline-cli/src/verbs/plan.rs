//! `tautline plan`.

use std::process::ExitCode;

use tautline_problem::sweep::Runner;

use crate::{
    arguments::Plan,
    draft::Draft,
    error::CommandError,
    paths::check_paths,
    plan_file::{PlanFile, explained},
    write::print,
};

/// Writes the table of problems of a sweep, or the problem file of one of them.
pub(crate) fn plan(arguments: &Plan) -> Result<ExitCode, CommandError> {
    let PlanFile { plan, read, .. } = PlanFile::open(&arguments.file)?;
    check_paths(arguments.output.as_slice(), &read)?;
    if let Some(id) = arguments.problem {
        if id >= plan.count() {
            let message = format!("--problem {id}: the ids end before {}", plan.count());
            return Err(CommandError::BadArgument(message));
        }
        print(&plan.problem(id))?;
        return Ok(ExitCode::SUCCESS);
    }
    let name = arguments.file.display().to_string();
    let lines = |ids| plan.lines(ids).map_err(|error| explained(&name, error));
    let Some(path) = &arguments.output else {
        print(&plan.head())?;
        for ids in Runner::pieces(0..plan.count()) {
            print(&lines(ids)?)?;
        }
        return Ok(ExitCode::SUCCESS);
    };
    let mut draft = Draft::of(path)?;
    draft.write(plan.head())?;
    for ids in Runner::pieces(0..plan.count()) {
        draft.write(&lines(ids)?)?;
    }
    draft.finish()?;
    print(&format!("wrote {} with {} problems\n", path.display(), plan.count()))?;
    Ok(ExitCode::SUCCESS)
}
