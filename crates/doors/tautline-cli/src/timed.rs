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

#[cfg(test)]
mod tests {
    use std::{
        ops::ControlFlow,
        sync::{Mutex, atomic::Ordering},
        thread,
        time::Duration,
    };

    use tautline_problem::{Progress, Question, Watch, distance};

    use super::{Clock, seconds, timed};

    /// Returns what a proof reports, of any of its quantities.
    fn report() -> Progress {
        let file = "dimension = 1\n[metric]\nphi = \"2 + sin(x1)\"\n";
        let seen = Mutex::new(None);
        let watch = |progress: Progress| {
            *seen.lock().expect("no panic") = Some(progress);
            true
        };
        Question::read(file).expect("a file").constants_watched(&watch).expect("sought");
        let seen = *seen.lock().expect("no panic");
        Progress { boxes: 12, ..seen.expect("a report") }
    }

    /// The order of its two numbers shows which quantity a proof is about: `c₁` is proved from
    /// below, the others from above. Both ends are rounded outwards: a third and two thirds are no decimals.
    #[test]
    fn progress_is_printed_outwards() {
        let (third, two) = (1.0 / 3.0, 2.0 / 3.0);
        let report = report();
        for (bound, value) in [(third, two), (two, third)] {
            let clock = Clock::default();
            assert!(clock.goes_on(Progress { bound, value, ..report }));
            let said = clock.progress().expect("progress");
            assert!(said.contains(": 0.33333 to 0.66667 after 12 boxes"), "{said}");
        }
        let clock = Clock::default();
        let level = distance::Progress { levels: 2, cubes: 34, lower: third, upper: two };
        assert_eq!(clock.next_level(level), ControlFlow::Continue(()));
        let said = clock.progress().expect("progress");
        assert_eq!(said, "proving the distance: 0.33333 to 0.66667 after 34 cubes");
        // Once time has run out, both searches end.
        clock.is_over.store(true, Ordering::Relaxed);
        assert_eq!(clock.next_level(level), ControlFlow::Break(()));
        assert!(!clock.goes_on(report));
    }

    /// What was reported last is the result, also if the work ends because time has run out.
    #[test]
    fn the_last_report_counts() {
        let done = timed(None, "working", |report, _| {
            let _ = report.send(1);
            2
        });
        assert!(matches!(done, Ok(Some(2))));
        let level = distance::Progress { levels: 1, cubes: 1, lower: 0.0, upper: 1.0 };
        let ended = timed(Some(Duration::from_millis(20)), "working", move |report, clock| {
            let _ = report.send(1);
            while clock.next_level(level).is_continue() {
                thread::sleep(Duration::from_millis(1));
            }
            2
        });
        assert!(matches!(ended, Ok(Some(2))));
    }

    #[test]
    fn a_time_limit_is_a_positive_number_of_seconds() {
        assert!(matches!(seconds(None), Ok(None)));
        assert!(matches!(seconds(Some(1.5)), Ok(Some(limit)) if limit.as_millis() == 1500));
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-30] {
            assert!(seconds(Some(wrong)).is_err(), "{wrong}");
        }
    }
}
