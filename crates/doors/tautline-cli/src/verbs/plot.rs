//! `tautline plot`.

use std::process::ExitCode;

use crate::{
    arguments::Plot,
    error::CommandError,
    paths::check_paths,
    problem::ProblemText,
    verbs::solve::solved,
    write::{check_pictures, write_picture},
};

/// Draws the problem of a file, with its curve if it has two sets.
pub(crate) fn plot(arguments: &Plot) -> Result<ExitCode, CommandError> {
    check_pictures(&arguments.pictures)?;
    let mut problem = ProblemText::read(&arguments.file)?;
    check_paths(&arguments.pictures, &problem.read)?;
    let has_curve = problem.question.has_ends() && !arguments.no_curve;
    problem.question.without_bounds();
    let limit = problem.question.time_limit();
    let answer = if has_curve { Some(solved(&problem, limit)?) } else { None };
    let picture = problem.question.picture(answer.as_ref());
    let picture = picture.map_err(|failure| problem.explain(failure))?;
    for path in &arguments.pictures {
        write_picture(path, &picture)?;
    }
    let converged = answer.is_none_or(|answer| answer.search.converged);
    Ok(if converged { ExitCode::SUCCESS } else { ExitCode::from(1) })
}
