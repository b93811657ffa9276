//! Work with a time limit, and with signs of progress on a terminal.

use std::{
    io::{self, IsTerminal},
    ops::ControlFlow,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, Ordering},
        mpsc::{self, RecvTimeoutError, Sender},
    },
    thread,
    time::{Duration, Instant},
};

use indicatif::{ProgressBar, ProgressStyle};
use tautline_problem::{
    Progress, Watch,
    decimal::{shortly_down, shortly_up},
    distance,
};

use crate::error::CommandError;

/// The stack of the thread that works: matrices in twelve dimensions lie on it.
const STACK: usize = 64 << 20;

/// How often the line on the terminal is renewed.
const TICK: Duration = Duration::from_millis(100);

/// The digits of what is proved so far.
const DIGITS: usize = 5;

/// How long a proof may take to end once time has run out. A round of boxes takes less.
const GRACE: Duration = Duration::from_secs(1);

/// Knows how far a proof has come, and ends it when time runs out.
#[derive(Debug, Default)]
pub(crate) struct Clock {
    is_over: AtomicBool,
    progress: Mutex<Option<String>>,
}

impl Watch for Clock {
    fn goes_on(&self, Progress { quantity, boxes, bound, value }: Progress) -> bool {
        let (least, most) = if bound < value { (bound, value) } else { (value, bound) };
        let (least, most) = (shortly_down(least, DIGITS), shortly_up(most, DIGITS));
        self.shows(format!("proving {quantity}: {least} to {most} after {boxes} boxes"))
    }
}

impl Clock {
    /// Returns whether a search for a certificate goes on to its next level.
    pub(crate) fn next_level(&self, progress: distance::Progress) -> ControlFlow<()> {
        let distance::Progress { cubes, lower, upper, .. } = progress;
        let (lower, upper) = (shortly_down(lower, DIGITS), shortly_up(upper, DIGITS));
        let goes_on =
            self.shows(format!("proving the distance: {lower} to {upper} after {cubes} cubes"));
        if goes_on { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    /// Takes the description of what is being proved. Returns whether there is time left.
    fn shows(&self, progress: String) -> bool {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner) = Some(progress);
        !self.is_over.load(Ordering::Relaxed)
    }

    /// Describes what is being proved.
    fn progress(&self) -> Option<String> {
        self.progress.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

/// Returns what the work reports last: its result, or what it reported before time ran out; `None`
/// if that is nothing. Once time has run out, proofs end with what they have. Other work goes on
/// until the program ends.
pub(crate) fn timed<T: Send + 'static>(
    limit: Option<Duration>,
    doing: &'static str,
    work: impl FnOnce(&Sender<T>, &Clock) -> T + Send + 'static,
) -> Result<Option<T>, CommandError> {
    let (sender, reports) = mpsc::channel();
    let clock = Arc::new(Clock::default());
    let watched = Arc::clone(&clock);
    let start = Instant::now();
    let thread = thread::Builder::new().stack_size(STACK).spawn(move || {
        let result = work(&sender, &watched);
        // Nobody listens any more once time has run out.
        let _ = sender.send(result);
    });
    let thread = thread.map_err(|error| CommandError::NotDone(error.to_string()))?;
    let spinner = spinner(doing);
    let mut last = None;
    loop {
        let left = limit.map_or(TICK, |limit| limit.saturating_sub(start.elapsed()));
        match reports.recv_timeout(left.min(TICK)) {
            Ok(report) => last = Some(report),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                if thread.join().is_err() {
                    return Err(CommandError::NotDone("the computation failed".to_owned()));
                }
                break;
            }
        }
        if let Some(progress) = clock.progress() {
            spinner.set_message(progress);
        }
        if limit.is_some_and(|limit| start.elapsed() >= limit) {
            clock.is_over.store(true, Ordering::Relaxed);
            let end = Instant::now() + GRACE;
            while let Ok(report) =
                reports.recv_timeout(end.saturating_duration_since(Instant::now()))
            {
                last = Some(report);
            }
            break;
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
    spinner.enable_steady_tick(TICK);
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
