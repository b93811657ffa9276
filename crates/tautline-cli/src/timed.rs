//! Work with a time limit, and with a sign of life on a terminal.

use std::{
    io::{self, IsTerminal},
    sync::mpsc::{self, RecvTimeoutError, Sender},
    thread,
    time::{Duration, Instant},
};

use indicatif::{ProgressBar, ProgressStyle};

use crate::error::CommandError;

/// The stack of the thread that works: matrices in twelve dimensions lie on it.
const STACK: usize = 64 << 20;

/// Returns what the work reports last: its result, or what it reported before time ran out; `None`
/// if that is nothing. The work then goes on until the program ends.
pub(crate) fn timed<T: Send + 'static>(
    limit: Option<Duration>,
    doing: &'static str,
    work: impl FnOnce(&Sender<T>) -> T + Send + 'static,
) -> Result<Option<T>, CommandError> {
    let (sender, reports) = mpsc::channel();
    let start = Instant::now();
    let thread = thread::Builder::new().stack_size(STACK).spawn(move || {
        let result = work(&sender);
        // Nobody listens any more once time has run out.
        let _ = sender.send(result);
    });
    let thread = thread.map_err(|error| CommandError::NotDone(error.to_string()))?;
    let spinner = spinner(doing);
    let mut last = None;
    loop {
        let next = match limit {
            None => reports.recv().map_err(|_| RecvTimeoutError::Disconnected),
            Some(limit) => reports.recv_timeout(limit.saturating_sub(start.elapsed())),
        };
        match next {
            Ok(report) => last = Some(report),
            Err(RecvTimeoutError::Timeout) => break,
            Err(RecvTimeoutError::Disconnected) => {
                if thread.join().is_err() {
                    return Err(CommandError::NotDone("the computation failed".to_owned()));
                }
                break;
            }
        }
    }
    spinner.finish_and_clear();
    Ok(last)
}

/// Returns a line that moves, on a terminal.
fn spinner(doing: &'static str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let spinner = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        spinner.set_style(style);
    }
    spinner.set_message(doing);
    spinner.enable_steady_tick(Duration::from_millis(100));
    spinner
}

/// Checks a number of seconds.
pub(crate) fn seconds(limit: Option<f64>) -> Result<Option<Duration>, CommandError> {
    let Some(limit) = limit else { return Ok(None) };
    match Duration::try_from_secs_f64(limit) {
        Ok(limit) if !limit.is_zero() => Ok(Some(limit)),
        _ => Err(CommandError::BadArgument(format!("a time limit of {limit} seconds"))),
    }
}
