//! `tautline run`.

use std::{
    fs,
    io::{ErrorKind, IsTerminal},
    ops::Range,
    path::Path,
    process::ExitCode,
    time::{Duration, Instant},
};

use indicatif::ProgressBar;
use tautline_problem::sweep::{Block, BlockError, BlockWriter, Plan, Runner, plain};

use crate::{
    arguments::Run,
    draft::Draft,
    error::CommandError,
    paths::{check_folder, check_paths},
    plan_file::{PlanFile, explained},
    write::{print, say, write},
};

/// Solves a block of problems, unless its results are there.
pub(crate) fn run(arguments: &Run) -> Result<ExitCode, CommandError> {
    let mut file = PlanFile::open(&arguments.plan)?;
    let name = arguments.plan.display().to_string();
    let ids = arguments.shard.ids(file.plan.count());
    let path = arguments.to.join(arguments.shard.file_name());
    let written: Vec<_> = [&path].into_iter().chain(&arguments.times).collect();
    check_paths(&written, &file.read)?;
    if is_finished(&path, &file.plan, ids.clone())? {
        print(&format!("{} is complete already\n", path.display()))?;
        return Ok(ExitCode::SUCCESS);
    }
    let failed = |error| CommandError::File { path: arguments.to.clone(), error };
    fs::create_dir_all(&arguments.to).map_err(failed)?;
    if let Some(times) = &arguments.times {
        check_folder(times)?;
    }
    let begin = Instant::now();
    let plan = file.plan.clone();
    let explain = |error| explained(&name, error);
    let runner = Runner::new(&plan, arguments.threads).map_err(explain)?;
    let mut draft = Draft::of(&path)?;
    let (mut writer, head) = BlockWriter::of_plan(&plan, ids.clone()).map_err(explain)?;
    draft.write(&head)?;
    let count = ids.end - ids.start;
    let bar = if std::io::stderr().is_terminal() {
        ProgressBar::new(count)
    } else {
        ProgressBar::hidden()
    };
    let (mut doubtful, mut failed) = (0, 0);
    for ids in Runner::pieces(ids.clone()) {
        file.check(ids.clone())?;
        let rows = runner.rows(ids.clone()).map_err(explain)?;
        (doubtful, failed) = (doubtful + rows.doubtful, failed + rows.failed);
        draft.write(writer.rows(rows.text))?;
        bar.inc(ids.end - ids.start);
    }
    draft.write(writer.end())?;
    draft.finish()?;
    bar.finish_and_clear();
    let time = begin.elapsed();
    if let Some(path) = &arguments.times {
        write(path, row_of_times(ids, failed, time, runner.threads()).as_bytes())?;
    }
    say(summary(count, [doubtful, failed], time, runner.threads()));
    print(&format!("wrote {}\n", path.display()))?;
    Ok(ExitCode::SUCCESS)
}

/// Returns whether a file has these results. Results that are incomplete count as none.
fn is_finished(path: &Path, plan: &Plan, ids: Range<u64>) -> Result<bool, CommandError> {
    let text = match fs::read_to_string(path) {
        Ok(text) => plain(&text).into_owned(),
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(false),
        Err(error) => return Err(CommandError::File { path: path.to_owned(), error }),
    };
    match Block::read(&text) {
        Ok(block) if plan.has(&block.head, ids) => Ok(true),
        Ok(_) => {
            let path = path.display();
            let message =
                format!("{path} has results of another plan or version; choose another folder");
            Err(CommandError::BadArgument(message))
        }
        Err(error @ BlockError::NoResults { .. }) => {
            let message = format!("{}: {error}; it is left as it is", path.display());
            Err(CommandError::BadArgument(message))
        }
        Err(_) => Ok(false),
    }
}

/// Returns how many problems were solved, and how fast.
fn summary(count: u64, [doubtful, failed]: [u64; 2], time: Duration, threads: usize) -> String {
    let seconds = time.as_secs_f64();
    let solved = count - doubtful - failed;
    format!(
        "{solved} solved, {doubtful} doubtful, {failed} failed; {seconds:.2} s, {:.0} a second on {threads} \
         threads",
        count as f64 / seconds
    )
}

/// Returns a table of one row: what the shard took. The memory is the most at a time, in kilobytes, where
/// the system tells.
fn row_of_times(ids: Range<u64>, failed: u64, time: Duration, threads: usize) -> String {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let peak = peak.and_then(|rest| rest.split_whitespace().next()).unwrap_or_default();
    let (Range { start, end }, seconds) = (ids, time.as_secs_f64());
    format!(
        "first_id,problems,failed,seconds,threads,peak_kilobytes\n{start},{},{failed},{seconds:.3},{threads},\
         {peak}\n",
        end - start
    )
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::{row_of_times, summary};

    #[test]
    fn a_summary_counts_every_problem_once() {
        let said = summary(10, [3, 2], Duration::from_secs(4), 7);
        assert!(said.starts_with("5 solved, 3 doubtful, 2 failed; 4.00 s, "), "{said}");
        assert!(said.ends_with(" a second on 7 threads"), "{said}");
    }

    #[test]
    fn the_row_of_times_is_that_of_the_shard() {
        let table = row_of_times(30..47, 2, Duration::from_millis(1500), 4);
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines[0], "first_id,problems,failed,seconds,threads,peak_kilobytes");
        assert!(lines.len() == 2 && lines[1].starts_with("30,17,2,1.500,4,"), "{table}");
    }
}
