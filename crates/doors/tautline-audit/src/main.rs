//! The program `tautline-audit`, which `tautline audit` runs.

use std::{
    fs,
    io::{self, IsTerminal, Read, Write},
    path::{Path, PathBuf},
    process::ExitCode,
    time::Duration,
};

use clap::Parser;
use tautline_audit::{AuditError, Document, Effort, Verdict, audit, audit_schema, markdown, text};
use tautline_problem::{Diagnostic, Question};

/// Tests the metric of a problem file, and its constants, against every law of the kit.
///
/// Exit codes: 0 all laws hold, 1 a law fails or was not tried, 2 bad input.
#[derive(Debug, Parser)]
#[command(
    name = "tautline-audit",
    bin_name = "tautline audit",
    version,
    after_help = "\
Example:
  $ tautline examples wrong_constants --to .
  $ tautline audit wrong_constants.toml
names the false constant, with the point and the direction that refute it."
)]
struct Arguments {
    /// The problem file, of which the metric, [certify] and [audit] count; - reads standard input.
    #[arg(required_unless_present = "schema")]
    file: Option<PathBuf>,
    /// Print one JSON document; --schema describes it.
    #[arg(long, conflicts_with = "markdown")]
    json: bool,
    /// Print Markdown.
    #[arg(long)]
    markdown: bool,
    /// The number of random samples for each law, in place of that of the file.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    cases: Option<u32>,
    /// The seed of the samples, in place of that of the file.
    #[arg(long)]
    seed: Option<u64>,
    /// Stop after this many seconds, with what is known by then.
    #[arg(long, value_name = "SECONDS", default_value = "20", value_parser = seconds, allow_negative_numbers = true)]
    time_limit: Duration,
    /// Print the JSON schema of a report.
    #[arg(long)]
    schema: bool,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "expected a number of seconds".to_owned())?;
    match Duration::try_from_secs_f64(seconds) {
        Ok(limit) if !limit.is_zero() => Ok(limit),
        _ => Err("expected a positive number of seconds".to_owned()),
    }
}

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
enum ProgramError {
    #[error("{0}")]
    BadFile(String),
    #[error("error: {path}: {error}", path = path.display())]
    File { path: PathBuf, error: io::Error },
    #[error("error: {0}")]
    BadEnvironment(tautline_kit::ChanceError),
    #[error("error: {0}")]
    NotDone(String),
    /// Nobody reads the output any more, as after `head`.
    #[error("")]
    Unread,
}

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        // Help that cannot be printed is no success.
        Err(usage) => {
            let code = u8::try_from(usage.exit_code()).unwrap_or(2);
            return ExitCode::from(if usage.print().is_err() { code.max(1) } else { code });
        }
    };
    match run(&arguments) {
        Ok(code) => code,
        // There is nobody to tell.
        Err(ProgramError::Unread) => ExitCode::from(1),
        Err(error) => {
            // Nobody may listen: the exit code says what counts.
            let _ = writeln!(io::stderr(), "{error}");
            ExitCode::from(if matches!(error, ProgramError::NotDone(_)) { 1 } else { 2 })
        }
    }
}

fn run(arguments: &Arguments) -> Result<ExitCode, ProgramError> {
    let Some(path) = arguments.file.as_deref().filter(|_| !arguments.schema) else {
        print(&json(&audit_schema())?)?;
        return Ok(ExitCode::SUCCESS);
    };
    // The kit reads the same variables and would panic.
    tautline_kit::Chance::read().map_err(ProgramError::BadEnvironment)?;
    let (name, file) = read(path)?;
    let explain = |diagnostic: &Diagnostic| {
        let coloured = io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
        ProgramError::BadFile(diagnostic.render(&name, &file, coloured))
    };
    // The files of a problem on standard input are found from the folder in which the command runs.
    let folder = path.parent().filter(|_| path != Path::new("-")).unwrap_or(Path::new(""));
    let mut open = |file: &str| fs::read(folder.join(file)).map_err(|error| error.to_string());
    let question =
        Question::read_with(&file, &mut open).map_err(|diagnostic| explain(&diagnostic))?;
    let Arguments { cases, seed, time_limit, .. } = *arguments;
    let audit =
        audit(&question, Effort { cases, seed, time_limit }).map_err(|error| match error {
            AuditError::BadInput(diagnostic) => explain(&diagnostic),
            error => ProgramError::NotDone(error.to_string()),
        })?;
    let code = ExitCode::from(u8::from(audit.verdict != Verdict::Holds));
    print(&match (arguments.json, arguments.markdown) {
        (true, _) => json(&Document::from(audit))?,
        (_, true) => markdown(&audit),
        _ => text(&audit),
    })?;
    Ok(code)
}

/// Returns the name of a file in messages, and its text.
fn read(path: &Path) -> Result<(String, String), ProgramError> {
    let is_input = path == Path::new("-");
    let name = if is_input { "standard input".into() } else { path.display().to_string() };
    let mut text = String::new();
    let read = if is_input {
        io::stdin().read_to_string(&mut text).map(|_| ())
    } else {
        fs::read_to_string(path).map(|read| text = read)
    };
    match read {
        Ok(()) => Ok((name, text)),
        Err(error) => Err(ProgramError::File { path: PathBuf::from(name), error }),
    }
}

fn json(value: &impl serde::Serialize) -> Result<String, ProgramError> {
    let json = serde_json::to_string_pretty(value);
    Ok(json.map_err(|error| ProgramError::NotDone(error.to_string()))? + "\n")
}

/// Prints a text.
fn print(text: &str) -> Result<(), ProgramError> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Err(ProgramError::Unread),
        Err(error) => Err(ProgramError::File { path: "standard output".into(), error }),
        Ok(()) => Ok(()),
    }
}
