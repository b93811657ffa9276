//! The commands of a console block, and their answers.

use std::{
    env,
    ffi::OsString,
    io::Read,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

/// The first words of commands that a block may run. All but the first come with every Unix.
const ALLOWED: [&str; 6] = ["tautline", "cat", "echo", "grep", "head", "ls"];

/// A line that stands for any lines of an answer.
const ANY_LINES: &str = "…";

/// A command of a block with its printed answer, and what it answers now.
#[derive(Debug)]
pub(crate) struct Exchange {
    command: String,
    printed: Vec<String>,
    answer: Vec<String>,
}

/// The commands of a block, run.
#[derive(Debug)]
pub(crate) struct Transcript {
    exchanges: Vec<Exchange>,
}

/// Returns the path of the program `tautline`.
#[expect(
    clippy::unnecessary_wraps,
    reason = "the runner is also tested with a program that is missing"
)]
pub(crate) fn tautline() -> Result<PathBuf, String> {
    Ok(PathBuf::from(env!("CARGO_BIN_EXE_tautline")))
}

/// Runs the commands of a block in `folder`, with `tautline` first on the path.
///
/// # Errors
///
/// The text of a block begins with a command. A command must be an allowed one and succeed, unless
/// `echo $?` follows it.
pub(crate) fn run(
    text: &str,
    folder: &Path,
    tautline: fn() -> Result<PathBuf, String>,
) -> Result<Transcript, String> {
    let mut exchanges = exchanges(text)?;
    let path = path(&tautline()?)?;
    let mut status = 0;
    for index in 0..exchanges.len() {
        let next = exchanges.get(index + 1).map(|next| next.command.clone());
        let exchange = &mut exchanges[index];
        (exchange.answer, status) = answer(&exchange.command, status, folder, &path)?;
        if status != 0 && next.as_deref() != Some("echo $?") {
            return Err(format!(
                "`{}` ends with code {status}, and no `echo $?` follows:\n{}",
                exchange.command,
                exchange.answer.join("\n")
            ));
        }
    }
    Ok(Transcript { exchanges })
}

/// Reads the commands and their printed answers.
fn exchanges(text: &str) -> Result<Vec<Exchange>, String> {
    let mut exchanges: Vec<Exchange> = Vec::new();
    for line in text.lines() {
        if let Some(command) = line.strip_prefix("$ ") {
            let first = command.split_whitespace().next().unwrap_or_default();
            if !ALLOWED.contains(&first) {
                return Err(format!("`{command}` does not begin with {}", ALLOWED.join(", ")));
            }
            let command = command.trim_end().to_owned();
            exchanges.push(Exchange { command, printed: Vec::new(), answer: Vec::new() });
        } else {
            let last = exchanges.last_mut().ok_or("the block does not begin with `$ `")?;
            last.printed.push(line.trim_end().to_owned());
        }
    }
    if exchanges.is_empty() { Err("there is no command".to_owned()) } else { Ok(exchanges) }
}

/// Returns the search path with the folder of the program in front.
fn path(program: &Path) -> Result<OsString, String> {
    let folder = program.parent().unwrap_or(Path::new("."));
    let others = env::var_os("PATH").unwrap_or_default();
    let all = [folder.to_owned()].into_iter().chain(env::split_paths(&others));
    env::join_paths(all).map_err(|error| error.to_string())
}

/// Runs a command in the shell, and returns what it writes to either stream, without spaces at the
/// ends of lines, and its exit code. `before` is the exit code of the command before, for `$?`.
fn answer(
    command: &str,
    before: i32,
    folder: &Path,
    path: &OsString,
) -> Result<(Vec<String>, i32), String> {
    let failed = |error: std::io::Error| format!("`{command}` did not start: {error}");
    let (mut reader, writer) = std::io::pipe().map_err(failed)?;
    let mut child = {
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("(exit {before}); {command}")]);
        shell.current_dir(folder).env("PATH", path).env_remove("TAUTLINE_BLESS");
        shell.stdin(Stdio::null()).stdout(writer.try_clone().map_err(failed)?).stderr(writer);
        shell.spawn().map_err(failed)?
        // The shell's copies of the writer are dropped here, so that reading ends with the child.
    };
    let mut bytes = Vec::new();
    reader.read_to_end(&mut bytes).map_err(failed)?;
    let status = child.wait().map_err(failed)?;
    let code = status.code().ok_or_else(|| format!("`{command}` was stopped: {status}"))?;
    let text = String::from_utf8(bytes).map_err(|_| format!("`{command}` answers no text"))?;
    Ok((text.lines().map(|line| line.trim_end().to_owned()).collect(), code))
}

impl Exchange {
    fn agrees(&self) -> bool {
        matches(&self.printed, &self.answer)
    }
}

impl Transcript {
    /// Returns whether every answer is the printed one.
    pub(crate) fn agrees(&self) -> bool {
        self.exchanges.iter().all(Exchange::agrees)
    }

    /// Returns the block with the answers of now where they differ.
    pub(crate) fn as_answered(&self) -> String {
        let mut text = String::new();
        for exchange in &self.exchanges {
            text.push_str(&format!("$ {}\n", exchange.command));
            let lines = if exchange.agrees() { &exchange.printed } else { &exchange.answer };
            for line in lines {
                text.push_str(line);
                text.push('\n');
            }
        }
        text
    }

    /// Returns the answers that differ, as printed and as they are now.
    pub(crate) fn differences(&self) -> String {
        let differing = self.exchanges.iter().filter(|exchange| !exchange.agrees());
        let all = differing.map(|exchange| {
            let (printed, answer) = (exchange.printed.join("\n"), exchange.answer.join("\n"));
            format!(
                "`{}` answers\n{answer}\nand the guide has\n{printed}\nTAUTLINE_BLESS=1 writes the \
                 answer into the page",
                exchange.command
            )
        });
        all.collect::<Vec<_>>().join("\n\n")
    }
}

/// Returns whether `answer` is what is printed, where `…` alone on a line stands for any lines.
fn matches(printed: &[String], answer: &[String]) -> bool {
    match printed.split_first() {
        None => answer.is_empty(),
        Some((first, rest)) if first == ANY_LINES => {
            (0..=answer.len()).any(|skipped| matches(rest, &answer[skipped..]))
        }
        Some((first, rest)) => {
            answer.split_first().is_some_and(|(line, lines)| line == first && matches(rest, lines))
        }
    }
}
