//! How long a solve takes, and the report that the comparison reads.

use std::{fs, path::Path, sync::OnceLock, time::Instant};

use tautline::SVector;

/// A sample repeats the solve for at least so long, in seconds: the clock of the system advances
/// in steps of up to 4 ms, which is then 2 % at most.
const SAMPLE: f64 = 0.2;

/// A solve that takes longer than this, in seconds, is not repeated: five of them are within the
/// limit of the comparison, which is one for the whole process.
const PATIENCE: f64 = 5.0;

/// The seconds of one solve, and its result.
pub(crate) struct Timed<T> {
    /// The median of three samples.
    pub(crate) seconds: f64,
    /// What the first solve returned.
    pub(crate) result: T,
}

/// Solves once, then in three samples.
pub(crate) fn time<T>(mut solve: impl FnMut() -> T) -> Timed<T> {
    println!("phase=solve");
    let start = cpu_time();
    let result = solve();
    let first = cpu_time() - start;
    if first > PATIENCE {
        return Timed { seconds: first, result };
    }
    // The count is found by doubling, so that the clock is not read after every solve.
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

/// The time that the processor has spent on this thread, in seconds; elapsed time where the
/// system does not tell.
pub(crate) fn cpu_time() -> f64 {
    static BEGIN: OnceLock<Instant> = OnceLock::new();
    let begin = BEGIN.get_or_init(Instant::now);
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| begin.elapsed().as_secs_f64(), |nanoseconds| nanoseconds * 1e-9)
}

/// Prints what the comparison wants to know, and writes the points, `D` numbers each, in the
/// order of the bytes of this machine.
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
