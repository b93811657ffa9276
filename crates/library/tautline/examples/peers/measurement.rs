//! The time of a solve, and the report that the comparison reads.

use std::{fs, path::Path, sync::OnceLock, time::Instant};

use tautline::SVector;

/// The shortest duration of a sample, in seconds. The clock advances in steps of up to 4 ms, which
/// are at most 2 % of it.
const SAMPLE: f64 = 0.2;

/// The time in seconds above which a solve is not repeated. The comparison limits the whole process
/// to five times as long.
const PATIENCE: f64 = 5.0;

/// The seconds of one solve, and its result.
pub(crate) struct Timed<T> {
    /// The median of three samples.
    pub(crate) seconds: f64,
    /// What the first solve returned.
    pub(crate) result: T,
}

/// Solves once, and then repeatedly in three samples.
pub(crate) fn time<T>(mut solve: impl FnMut() -> T) -> Timed<T> {
    println!("phase=solve");
    let start = cpu_time();
    let result = solve();
    let first = cpu_time() - start;
    if first > PATIENCE {
        return Timed { seconds: first, result };
    }
    // The number of solves in a sample is found by doubling, so that the clock is not read after
    // every solve.
    let mut sample = |count: u32| {
        let start = cpu_time();
        (0..count).for_each(|_| drop(solve()));
        cpu_time() - start
    };
    let mut count = 1;
    while sample(count) < SAMPLE {
        count *= 2;
    }
    let mut samples = [0.0; 3].map(|_: f64| sample(count) / f64::from(count));
    samples.sort_by(f64::total_cmp);
    Timed { seconds: samples[1], result }
}

/// Returns the processor time of this thread, in seconds, or the elapsed time if the system does
/// not report it.
pub(crate) fn cpu_time() -> f64 {
    static BEGIN: OnceLock<Instant> = OnceLock::new();
    let begin = BEGIN.get_or_init(Instant::now);
    let statistics = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds =
        statistics.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| begin.elapsed().as_secs_f64(), |nanoseconds| nanoseconds * 1e-9)
}

/// Prints the report, and writes the points: `D` numbers for each, in native byte order.
pub(crate) fn report<T, const D: usize>(
    timed: &Timed<T>,
    iterations: impl std::fmt::Display,
    stop: &str,
    points: &[SVector<f64, D>],
    file: &Path,
) -> Result<(), Box<dyn std::error::Error>> {
    let bytes: Vec<u8> = points.iter().flatten().flat_map(|x| x.to_ne_bytes()).collect();
    fs::write(file, bytes)?;
    println!("iterations={iterations}\nstop={stop}\nseconds={}", timed.seconds);
    Ok(())
}
