//! Takes part in the comparison with other programs: Tautline solves one problem and reports the
//! time.
//!
//! `cargo xtask peers` calls it once for each problem and `N`:
//!
//! ```console
//! $ cargo run --release -p tautline --example peers -- P2 1000 target/points
//! ```

mod measurement;
mod problems;

use std::{env, path::PathBuf};

use measurement::{cpu_time, report, time};
use problems::{Peer, pose};
use tautline::{Ends, Metric, Options, PointSequence, Problem, Rule, SolveError, Starts};

/// Solves with Tautline from the straight line alone, like every other program.
struct Tautline {
    points: PathBuf,
}

impl Peer for Tautline {
    fn solve<M: Metric<D>, const D: usize>(
        self,
        metric: M,
        ends: Ends<D>,
        start: PointSequence<D>,
    ) -> Result<(), Box<dyn std::error::Error>> {
        let n = start.n().get();
        let problem = Problem::new(metric, ends);
        let options = options(start);
        println!("version={}\nset_up={}", env!("CARGO_PKG_VERSION"), cpu_time());
        let timed = time(|| problem.solve_with(Rule::TRAPEZOIDAL, n, &options));
        let line = timed.result.as_ref().map_err(ToString::to_string)?;
        let minimum = line.minimum();
        let stop = format!("{:?}, {:?}", minimum.stop, minimum.curvature);
        report(&timed, minimum.iterations, &stop, minimum.sequence.points(), &self.points)
    }
}

/// Returns options with one start and one thread, since each program runs on one processor.
fn options<const D: usize>(start: PointSequence<D>) -> Options<D> {
    Options { starts: Starts::Only(vec![start]), threads: 1, ..Options::default() }
}

/// Extrapolates the squared distance, on the first grid that is accurate enough.
struct Distance {
    reference: f64,
    error: f64,
}

impl Peer for Distance {
    fn solve<M: Metric<D>, const D: usize>(
        self,
        metric: M,
        ends: Ends<D>,
        start: PointSequence<D>,
    ) -> Result<(), Box<dyn std::error::Error>> {
        let problem = Problem::new(metric, ends);
        let options = options(start);
        let estimate = |n| {
            let line = problem.solve_with(Rule::TRAPEZOIDAL, n, &options)?;
            Ok::<_, SolveError>(line.distance_squared_estimate())
        };
        println!("version={}\nset_up={}", env!("CARGO_PKG_VERSION"), cpu_time());
        // Extrapolation needs two grids.
        for n in (5..16).flat_map(|power| [3 << power, 4 << power]) {
            let found = estimate(n)?.map_or(f64::INFINITY, |estimate| estimate.value);
            if (found / self.reference - 1.0).abs() <= self.error {
                let timed = time(|| estimate(n));
                println!("energy={found}\nstop=N = {n}\nseconds={}", timed.seconds);
                return Ok(());
            }
        }
        Err("no grid is accurate enough".into())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match *arguments.as_slice() {
        [problem, "distance", reference, error] => {
            let distance = Distance { reference: reference.parse()?, error: error.parse()? };
            pose(problem, 1, distance)
        }
        [problem, n, points] => pose(problem, n.parse()?, Tautline { points: points.into() }),
        _ => Err("usage: peers PROBLEM N FILE, or peers PROBLEM distance REFERENCE ERROR".into()),
    }
}
