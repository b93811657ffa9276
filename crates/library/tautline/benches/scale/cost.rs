//! `Cost`: the time and the memory of a computation.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The number of runs. It is smaller if the runs take longer than `PATIENCE`.
const RUNS: usize = 5;
const PATIENCE: Duration = Duration::from_secs(20);

/// The cost of a computation.
pub(crate) struct Cost<T> {
    /// The shortest time of all runs, in seconds.
    pub(crate) seconds: f64,
    /// The peak of additional memory during the first run.
    pub(crate) bytes: usize,
    /// The result of the first run.
    pub(crate) result: T,
}

/// Runs a computation several times.
pub(crate) fn cost<T>(mut run: impl FnMut() -> T) -> Cost<T> {
    let mut timed = || {
        let begun = Instant::now();
        let result = black_box(run());
        (begun.elapsed(), result)
    };
    MEMORY.reset_peak_usage();
    let before = MEMORY.current_usage();
    let (mut least, result) = timed();
    let bytes = MEMORY.peak_usage() - before;
    let mut total = least;
    for _ in 1..RUNS {
        if total >= PATIENCE {
            break;
        }
        let (time, _) = timed();
        total += time;
        least = least.min(time);
    }
    Cost { seconds: least.as_secs_f64(), bytes, result }
}
