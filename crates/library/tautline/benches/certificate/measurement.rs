//! `Measured`: the rows of one problem.

use std::{
    error::Error,
    ops::ControlFlow,
    time::{Duration, Instant},
};

use tautline::{
    Ends, Metric, Options, PointSequence, Problem, Rule,
    check::AnyCertificate,
    distance::{Ended, Found, Progress, Wanted},
};

use crate::problems::Peer;

/// The number of chords, which is that of `tautline certify` for a file that has no other.
const CHORDS: usize = 256;

/// A computation that takes less is run `RUNS` times, and the least time counts.
const SHORT: Duration = Duration::from_secs(1);
const RUNS: usize = 5;

/// The most cubes of all levels: in the plane those of `tautline certify`, in space fewer, since a level
/// with as many takes minutes.
const CUBES: [usize; 2] = [2_000_000, 250_000];

/// A search that takes longer goes no further than the level that it is at.
const PATIENCE: Duration = Duration::from_secs(120);

/// A problem that is measured for each wanted gap.
pub(crate) struct Measured<'g> {
    pub(crate) problem: &'static str,
    pub(crate) gaps: &'g [f64],
    /// The distance, if it is known.
    pub(crate) d: Option<f64>,
}

/// Returns the least time of a computation, in seconds, and its first result.
fn least<T, E>(mut run: impl FnMut() -> Result<T, E>) -> Result<(f64, T), E> {
    let mut timed = || {
        let begun = Instant::now();
        run().map(|result| (begun.elapsed(), result))
    };
    let (mut least, result) = timed()?;
    if least < SHORT {
        for _ in 1..RUNS {
            least = least.min(timed()?.0);
        }
    }
    Ok((least.as_secs_f64(), result))
}

/// Searches as `tautline certify` does, from the automatic starts.
fn search<M: Metric<D>, const D: usize>(
    metric: &M,
    ends: &Ends<D>,
    gap: f64,
) -> Result<Found<D>, Box<dyn Error>> {
    let begun = Instant::now();
    let mut patience = |_: Progress| {
        if begun.elapsed() > PATIENCE { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let options = Options { threads: 1, ..Options::default() };
    let line =
        Problem::new(metric, ends.clone()).solve_with(Rule::TRAPEZOIDAL, CHORDS, &options)?;
    let wanted = Wanted { gap, cubes: CUBES[usize::from(D > 2)] };
    Ok(line.certificate_with(wanted, &mut patience)?)
}

impl Peer for Measured<'_> {
    /// Prints a row for each gap, with empty cells if there is no certificate. The searches do not use
    /// the start.
    ///
    /// # Errors
    ///
    /// Also if the distance is known, and does not lie between the two bounds.
    fn solve<M: Metric<D>, const D: usize>(
        self,
        metric: M,
        ends: Ends<D>,
        _start: PointSequence<D>,
    ) -> Result<(), Box<dyn Error>> {
        let Self { problem, gaps, d } = self;
        for wanted in gaps {
            let (seconds, found) = match least(|| search(&metric, &ends, *wanted)) {
                Ok(found) => found,
                Err(error) => {
                    println!("{problem},{D},{wanted:e},,,,,,");
                    eprintln!("{problem}, gap {wanted:e}: no certificate: {error}");
                    continue;
                }
            };
            let cubes: usize = found.proved.levels.iter().map(|(cubes, _)| cubes).sum();
            let text = found.certificate.to_string();
            let read = AnyCertificate::read(&text)?;
            let (checker_seconds, verdict) = least(|| read.check())?;
            let (lo, hi) = (verdict.lower, verdict.upper.ok_or("no curve")?);
            if let Some(d) = d {
                // A distance in closed form is computed with a few roundings.
                let rounding = 8.0 * f64::EPSILON * d;
                if !(lo <= d + rounding && d - rounding <= hi) {
                    return Err(format!("the distance {d} is not in [{lo}, {hi}]").into());
                }
            }
            let gap = (hi - lo) / hi;
            println!(
                "{problem},{D},{wanted:e},{gap:.3e},{seconds:.3},{cubes},{lo},{hi},\
                 {checker_seconds:.3}"
            );
            let reached = if found.ended == Ended::Reached { "reached" } else { "not reached" };
            eprintln!("{problem}, gap {wanted:e}: {reached} ({:?})", found.ended);
        }
        Ok(())
    }
}
