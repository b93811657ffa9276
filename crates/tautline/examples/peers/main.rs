//! Tautline in the comparison with other programs: solves one problem and reports its time.
//!
//! Called by `cargo xtask peers`, once for each problem and `N`:
//!
//! ```console
//! $ cargo run --release -p tautline --example peers -- P2 1000 target/points
//! ```

mod measurement;
mod problems;

use std::{env, path::PathBuf};

use measurement::{cpu_time, report, time};
use problems::{Peer, pose};
use tautline::{Ends, Metric, Options, PointSequence, Problem, Starts, Trapezoidal};

/// Tautline from the straight line alone, as everybody else in the comparison.
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
        let options = Options { starts: Starts::Only(vec![start]), ..Options::default() };
        println!("version={}\nset_up={}", env!("CARGO_PKG_VERSION"), cpu_time());
        let timed = time(|| problem.solve_with(Trapezoidal, n, &options));
        let line = timed.result.as_ref().map_err(ToString::to_string)?;
        let minimum = line.minimum();
        let stop = format!("{:?}, {:?}", minimum.stop, minimum.curvature);
        report(&timed, minimum.iterations, &stop, minimum.sequence.points(), &self.points)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [problem, n, points] = arguments.as_slice() else {
        return Err("usage: peers PROBLEM N FILE".into());
    };
    pose(problem, n.parse()?, Tautline { points: points.into() })
}
