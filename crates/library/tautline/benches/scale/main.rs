//! Measures the largest solves on one machine, with time and memory per node: ten million nodes, 64
//! dimensions, and ten thousand problems in a batch.
//!
//! `cargo bench --package tautline --bench scale -- P1 batch` runs some of them. All of them make
//! up `paper/tables/scale.csv`, which `cargo xtask bench` writes.

mod cost;
#[path = "../../examples/peers/problems.rs"]
mod problems;

use std::{error::Error, thread};

use cost::{Cost, cost};
use problems::{Peer, pose};
use rayon::ThreadPoolBuilder;
use tautline::{
    Ends, Metric, Options, PointSequence, Problem, Rule, SVector, SolveError, Starts, TautLine,
    gallery::{Bump, SineProjection, SineProjections},
    solve_all,
};

/// Numbers of subintervals: of the long problems, the wide one, the widest, and the batch.
const LONG: usize = 10_000_000;
const WIDE: usize = 1000;
const WIDEST: usize = 100;
const SHORT: usize = 64;

/// The name of the wide problems.
const BY_GRAM: &str = "by gram";

/// The stack for the wide problems, in bytes.
const STACK: usize = 64 << 20;

/// The number of problems in the batch.
const BATCH: usize = 10_000;

/// The number of chords of the straight line from which a single problem starts.
const START: usize = 16;

/// A row of the table.
struct Row {
    problem: &'static str,
    n: usize,
    threads: usize,
    /// The time on one thread divided by the time on all threads and by the number of threads.
    efficiency: f64,
}

fn processors() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// The speed relative to the first run, which uses one thread, divided by the number of threads.
fn efficiency<T>(first: &mut Option<f64>, cost: &Cost<T>, threads: usize) -> f64 {
    *first.get_or_insert(cost.seconds) / (cost.seconds * threads as f64)
}

impl Row {
    fn print<M: Metric<D>, const D: usize>(
        &self,
        cost: Cost<Vec<Result<TautLine<M, D>, SolveError>>>,
    ) -> Result<(), Box<dyn Error>> {
        let Cost { seconds, bytes, result } = cost;
        let count = result.len();
        let (mut iterations, mut local_minima, mut over_floor) = (0, 0, 0.0_f64);
        for line in result {
            let line = line?;
            let minimum = line.minimum();
            iterations += minimum.iterations;
            local_minima += usize::from(minimum.is_local_minimum());
            over_floor = over_floor.max(minimum.residual / minimum.residual_floor);
        }
        let Self { problem, n, threads, efficiency } = self;
        let nodes = (count * n) as f64;
        println!(
            "{problem},{D},{n},{count},{local_minima},{threads},{:.1},{:.1},{:.1},{over_floor:.2},\
             {:.4},{efficiency:.2}",
            1e9 * seconds / nodes,
            bytes as f64 / nodes,
            iterations as f64 / count as f64,
            count as f64 / seconds,
        );
        Ok(())
    }
}

/// Solves one problem from the straight line, on one thread and then on more, up to `threads`.
struct Single {
    problem: &'static str,
    n: usize,
    threads: usize,
}

impl Peer for Single {
    fn solve<M: Metric<D>, const D: usize>(
        self,
        metric: M,
        ends: Ends<D>,
        start: PointSequence<D>,
    ) -> Result<(), Box<dyn Error>> {
        let Self { problem, n, threads } = self;
        let mut single = None;
        for threads in 1..=threads {
            // The problem is posed again, so that no memory from earlier solves is reused.
            let posed = Problem::new(&metric, ends.clone());
            let starts = Starts::Only(vec![start.clone()]);
            let options = Options { starts, threads, ..Options::default() };
            let cost = cost(|| vec![posed.solve_with(Rule::TRAPEZOIDAL, n, &options)]);
            Row { problem, n, threads, efficiency: efficiency(&mut single, &cost, threads) }
                .print(cost)?;
        }
        Ok(())
    }
}

/// Solves from `0` to `(1, …, 1)` under a metric of four terms, with all entries of `H`.
fn wide<const D: usize>(problem: &'static str, n: usize) -> Result<(), Box<dyn Error>> {
    // The terms are those of P5.
    let term = |k: f64| SineProjection {
        wave_vector: SVector::from_fn(|i, _| (0.7 * k + (i + 1) as f64).sin()),
        direction: SVector::from_fn(|i, _| 0.5 * (1.3 * k * (i + 1) as f64).cos()),
    };
    let metric = SineProjections::<D>::new([1.0, 2.0, 3.0, 4.0].map(term).to_vec())?;
    let (from, to) = ([0.0; D], [1.0; D]);
    let start = PointSequence::straight(from, to, START)?;
    let threads = processors().min(2);
    let (single, ends) = (Single { problem, n, threads }, Ends::points(from, to)?);
    single.solve(metric, ends, start)
}

/// Solves from the automatic starts, under the metric of P2, between points spread over the square
/// around the bump.
fn batch(problem: &'static str) -> Result<(), Box<dyn Error>> {
    let bump = Bump::new(4.0, 0.5)?;
    // Multiples of the powers of 1/ρ, where ρ³ = ρ + 1, taken modulo 1, fill the square evenly.
    let point = |k: usize| {
        [0.754_877_666_246_692_8, 0.569_840_290_998_053_3]
            .map(|share: f64| 3.0 * (share * k as f64).fract() - 1.5)
    };
    let posed: Result<Vec<_>, _> = (0..BATCH)
        .map(|k| Ends::points(point(2 * k), point(2 * k + 1)).map(|ends| Problem::new(bump, ends)))
        .collect();
    let (posed, options) = (posed?, Options::default());
    let mut single = None;
    for threads in [1, processors()] {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
        let cost = cost(|| pool.install(|| solve_all(&posed, Rule::TRAPEZOIDAL, SHORT, &options)));
        let efficiency = efficiency(&mut single, &cost, threads);
        Row { problem, n: SHORT, threads, efficiency }.print(cost)?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).filter(|w| !w.starts_with('-')).collect();
    let wanted = |word: &str| words.is_empty() || words.iter().any(|w| w == word);
    println!(
        "problem,d,n,problems,local_minima,threads,nanoseconds_per_node,bytes_per_node,iterations,\
         residual_over_floor,problems_per_second,efficiency"
    );
    for problem in ["P1", "P2"].into_iter().filter(|problem| wanted(problem)) {
        pose(problem, START, Single { problem, n: LONG, threads: 1 })?;
    }
    // This stack holds matrices of jets of this size.
    let wide = || -> Result<(), String> {
        if wanted(BY_GRAM) {
            wide::<32>(BY_GRAM, WIDE).map_err(|error| error.to_string())?;
            wide::<64>(BY_GRAM, WIDEST).map_err(|error| error.to_string())?;
        }
        Ok(())
    };
    thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, wide)?;
        Ok::<_, Box<dyn Error>>(thread.join().map_err(|_| "a panic")??)
    })?;
    if wanted("batch") {
        batch("batch")?;
    }
    Ok(())
}
