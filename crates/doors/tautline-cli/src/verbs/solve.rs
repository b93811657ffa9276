//! `tautline solve`.

use std::process::ExitCode;

use tautline_problem::{Answer, Failure, Grid, LARGEST_N, LEAST_TOLERANCE};

use crate::{
    arguments::Solve,
    error::CommandError,
    paths::check_paths,
    problem::ProblemText,
    report,
    timed::{seconds, timed},
    write::{check_pictures, json, print, write_picture},
};

/// Solves the problem of a file, prints the answer, and draws it.
pub(crate) fn solve(arguments: &Solve) -> Result<ExitCode, CommandError> {
    check_pictures(&arguments.plot)?;
    let limit = seconds(arguments.time_limit)?;
    let mut problem = ProblemText::read(&arguments.file)?;
    check_paths(&arguments.plot, &problem.read)?;
    let grid = match (arguments.n, arguments.tolerance) {
        (Some(0), _) => return Err(CommandError::BadArgument("-n 0: no chord".to_owned())),
        (Some(n), _) if n > LARGEST_N => {
            let message = format!("-n {n}: expected at most {LARGEST_N} chords");
            return Err(CommandError::BadArgument(message));
        }
        (Some(n), _) => Some(Grid::Chords(n)),
        (None, Some(tolerance)) if tolerance > LEAST_TOLERANCE && tolerance < 1.0 => {
            Some(Grid::Tolerance(tolerance))
        }
        (None, Some(tolerance)) => {
            let message =
                format!("a tolerance of {tolerance:e} is not between {LEAST_TOLERANCE:e} and 1");
            return Err(CommandError::BadArgument(message));
        }
        (None, None) => None,
    };
    if let Some(grid) = grid {
        let set = problem.question.set_grid(grid);
        set.map_err(|refused| problem.explain(Failure::BadInput(refused)))?;
    }
    if arguments.no_bounds {
        problem.question.without_bounds();
    }
    let limit = limit.or(problem.question.time_limit());
    let answer = solved(&problem, limit)?;
    let text = if arguments.json { json(&answer)? } else { report::answer(&answer) };
    // The pictures do not depend on who reads the answer.
    let printed = print(&text);
    for path in &arguments.plot {
        let picture = problem.question.picture(Some(&answer));
        write_picture(path, &picture.map_err(|failure| problem.explain(failure))?)?;
    }
    printed?;
    Ok(if is_done(&answer) { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// Returns whether an answer is what was asked for.
fn is_done(answer: &Answer) -> bool {
    answer.doubts.is_empty() && answer.no_bounds.is_none()
}

/// Returns the answer, or the part that is known when time runs out.
pub(crate) fn solved(
    problem: &ProblemText,
    limit: Option<std::time::Duration>,
) -> Result<Answer, CommandError> {
    let question = problem.question.clone();
    let reported = timed(limit, "solving", move |report, clock| {
        let mut solved = |answer: &Answer| {
            // Nobody listens any more once time has run out.
            let _ = report.send(Ok(answer.clone()));
        };
        question.solve_watched(&mut solved, clock, &mut |progress| clock.next_level(progress))
    })?;
    let too_late = || Failure::NotComputed("no curve was found within the time limit".to_owned());
    reported.unwrap_or_else(|| Err(too_late())).map_err(|failure| problem.explain(failure))
}

#[cfg(test)]
mod tests {
    use tautline_problem::{Answer, Doubt, Question};

    use super::is_done;

    #[test]
    fn everything_that_was_asked_for_counts() {
        let file = "[metric]\nphi = 1\n[from]\npoint = [0]\n[to]\npoint = [1]\n";
        let answer = Question::read(file).expect("a problem").solve(&mut |_| ()).expect("a line");
        assert!(is_done(&answer));
        let changes: [fn(&mut Answer); 2] = [
            |answer| answer.doubts.push((&Doubt::NotConverged).into()),
            |answer| answer.no_bounds = Some("not finished".to_owned()),
        ];
        for change in changes {
            let mut changed = answer.clone();
            change(&mut changed);
            assert!(!is_done(&changed));
        }
        assert!(is_done(&Answer { within_tolerance: Some(true), ..answer }));
    }
}
