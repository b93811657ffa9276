//! What a solve and a batch take, for the comparison with the same calls from Python.
//!
//! `cargo xtask python speed` calls it in turns with `python/checks/speed.py`:
//!
//! ```console
//! $ cargo run --release -p tautline --example beside_python -- 16 64 256
//! ```
//!
//! It prints the seconds of one solve for each number of chords, and then those of a batch of 10⁴
//! problems of 64 chords.

use std::{env, hint::black_box, sync::Arc, time::Instant};

use tautline::{Ends, Formula, Options, Prepared, Problem, Rule, solve_all};

/// A hill of four times the cost.
const HILL: &str = "cost(1 + 4*exp(-2*(x1^2 + x2^2)))";

/// The problems of the batch.
const PROBLEMS: usize = 10_000;

/// Runs of a solve, of which the median counts.
const RUNS: usize = 501;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let metric = Arc::new(Prepared::new(Formula::<2>::parse(HILL, &[])?));
    for n in env::args().skip(1) {
        let n: usize = n.parse()?;
        let problem = || {
            let ends = Ends::points([-1.5, 0.05], [1.5, -0.1])?;
            Problem::with_prepared(Arc::clone(&metric), ends)
                .solve(Rule::TRAPEZOIDAL, n)
                .map_err(Box::from)
        };
        let mut seconds = Vec::new();
        for _ in 0..RUNS {
            let start = Instant::now();
            let line: Result<_, Box<dyn std::error::Error>> = problem();
            // As from Python, which warns where the chords do not resolve the metric.
            black_box(line?.is_resolved());
            seconds.push(start.elapsed().as_secs_f64());
        }
        seconds.sort_by(f64::total_cmp);
        println!("solve {n} {:e}", seconds[RUNS / 2]);
    }
    let mut problems = Vec::new();
    for k in 0..PROBLEMS {
        // Points on two circles around the hill, as in the script.
        let (sin, cos) = (k as f64).sin_cos();
        let ends = Ends::points([-1.5 + 0.2 * cos, 0.2 * sin], [1.5 - 0.2 * sin, 0.2 * cos])?;
        problems.push(Problem::with_prepared(Arc::clone(&metric), ends));
    }
    let start = Instant::now();
    let lines = solve_all(&problems, Rule::TRAPEZOIDAL, 64, &Options::default());
    let mut sum = 0.0;
    for line in lines {
        sum += line?.minimum().energy;
    }
    println!("batch {PROBLEMS} {:e} {sum:e}", start.elapsed().as_secs_f64());
    Ok(())
}
