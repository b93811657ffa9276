//! `tautline certify`.

use std::{ops::ControlFlow, path::Path, process::ExitCode, time::Instant};

use tautline_problem::{CertifiedAnswer, Failure, decimal::rounded_up, distance::Wanted};

use crate::{
    arguments::Certify,
    error::CommandError,
    paths::{check_folder, check_paths},
    problem::ProblemText,
    report,
    timed::{seconds, timed},
    write::{check_pictures, json, print, write, write_picture},
};

/// A level takes at most about this many times as long as the one before.
const NEXT: u32 = 3;

/// Searches for a certificate of the distance of a file, writes it, and draws it.
pub(crate) fn certify(arguments: &Certify) -> Result<ExitCode, CommandError> {
    check_pictures(&arguments.plot)?;
    let gap = arguments.gap;
    if !(gap > 0.0 && gap < 1.0) {
        let message = format!("a gap of {gap:e} is not between 0 and 1");
        return Err(CommandError::BadArgument(message));
    }
    if arguments.output.as_deref() == Some(Path::new("-")) {
        let message = "-o -: the certificate needs a file of its own".to_owned();
        return Err(CommandError::BadArgument(message));
    }
    let limit = seconds(arguments.time_limit)?;
    if let Some(path) = &arguments.output {
        check_folder(path)?;
    }
    let problem = ProblemText::read(&arguments.file)?;
    let written: Vec<_> = arguments.output.iter().chain(&arguments.plot).collect();
    check_paths(&written, &problem.read)?;
    let limit = limit.or(problem.question.time_limit());
    let question = problem.question.clone();
    let wanted = Wanted { gap, cubes: arguments.cubes };
    let found = timed(limit, "certifying", move |_, _| {
        let start = Instant::now();
        let mut last = start;
        question.certify(wanted, &mut |_| {
            // The next level has to end in time too.
            let needed = NEXT * last.elapsed();
            last = Instant::now();
            match limit {
                Some(limit) if start.elapsed() + needed > limit => ControlFlow::Break(()),
                _ => ControlFlow::Continue(()),
            }
        })
    })?;
    let too_late = || Failure::NotComputed("nothing was proved within the time limit".to_owned());
    let found = found.unwrap_or_else(|| Err(too_late()));
    let found = found.map_err(|failure| problem.explain(failure))?;
    match &arguments.output {
        Some(path) if found.certificate.is_empty() => {
            let message = format!("{}: {}", path.display(), without_certificate(&found));
            return Err(CommandError::NotDone(message));
        }
        Some(path) => write(path, found.certificate.as_bytes())?,
        None => {}
    }
    let text = if arguments.json { json(&found)? } else { report::certified(&found) };
    // The pictures do not depend on who reads the answer.
    let printed = print(&text);
    for path in &arguments.plot {
        let picture = problem.question.certified_picture(&found);
        write_picture(path, &picture.map_err(|failure| problem.explain(failure))?)?;
    }
    printed?;
    Ok(if found.reached { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// Says why there is no certificate to write.
fn without_certificate(found: &CertifiedAnswer) -> String {
    if found.upper.value == 0.0 {
        return "a distance of 0 has no certificate".to_owned();
    }
    let upper = rounded_up(found.upper.value);
    format!("no certificate: {}, and the distance is at most {upper}", found.ended)
}
