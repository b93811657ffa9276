//! Measures the cost of each part of a solve on the six problems of the comparison. The cost is
//! relative to the limit: the same Newton pass written by hand for one metric.
//!
//! `cargo bench --package tautline --bench speed -- P1 100000` runs one problem and one `N`. All of
//! them make up `paper/tables/speed.csv`, which `cargo xtask bench` writes.

mod limit;
mod limit_space;
#[path = "../../examples/peers/problems.rs"]
mod problems;
mod race;

use std::{error::Error, f64::consts::PI, hint::black_box};

use limit::{Conformal, Plane};
use limit_space::Space;
use problems::{Peer, pose};
use race::Race;
use tautline::{
    Ends, Metric, Options, PointSequence, Prepared, Problem, Rule, SVector, Starts, Workspace,
    newton_step,
};
use tautline_discretizations::{LinearModel, QuadraticModel, admissible_energy};
use tautline_formula::{Formula, InstructionSet};
use tautline_optimizers::minimise_by_batches;

/// The number of lanes of [`Prepared::new`].
const LANES: usize = 128;

const PROBLEMS: [&str; 6] = ["P1", "P2", "P3", "P4", "P5", "P6"];
const SIZES: [usize; 5] = [64, 1_000, 10_000, 100_000, 1_000_000];

/// The largest number of doubles in a model, one gigabyte. Larger models are skipped.
const LARGEST: usize = 1 << 27;

/// Times every part on one problem.
struct Timing {
    name: &'static str,
}

impl Peer for Timing {
    fn solve<M: Metric<D>, const D: usize>(
        self,
        metric: M,
        ends: Ends<D>,
        start: PointSequence<D>,
    ) -> Result<(), Box<dyn Error>> {
        let n = start.n().get();
        if n * 2 * D * D > LARGEST {
            return Ok(());
        }
        let options =
            Options { starts: Starts::Only(vec![start]), threads: 1, ..Options::default() };
        let problem = Problem::new(metric, ends);
        let metric = problem.metric();
        let prepared = Prepared::new(metric);
        let line = bent(problem.solve_with(Rule::TRAPEZOIDAL, n, &options)?.sequence())?;
        let (first, second) = problem.ends().pairs().next().ok_or("ends have pieces")?;
        let (mut model, mut workspace) = (QuadraticModel::default(), Workspace::default());
        // This is how a processor without wider instructions computes.
        let baseline = Prepared::with(metric, InstructionSet::Baseline, LANES);
        let mut other_workspace = Workspace::default();
        let text = prepared.formula().ok_or("the formula has branches")?.to_string();
        let from_text = Problem::new(Formula::parse(&text, &[])?, problem.ends().clone());
        let mut race = Race::default();
        by_hand(self.name, &mut race, line.points());
        race.add("energy", || {
            admissible_energy(Rule::TRAPEZOIDAL.nodes(), &prepared, black_box(&line).coordinates())
        });
        race.add("gradient", || {
            LinearModel::by_batches(Rule::TRAPEZOIDAL.nodes(), &prepared, black_box(&line))
        });
        race.add("assembly", || {
            model.expand_by_batches(Rule::TRAPEZOIDAL.nodes(), &prepared, black_box(&line));
            model.energy
        });
        race.add("newton step", || {
            let ends = [&*first, &*second];
            let step =
                newton_step(&mut workspace, &prepared, ends, Rule::TRAPEZOIDAL, black_box(&line));
            step.expect("the Hessian is positive definite near a minimiser")
        });
        race.add("newton step by the instructions that all processors have", || {
            let (ends, line) = ([&*first, &*second], black_box(&line));
            let step = newton_step(&mut other_workspace, &baseline, ends, Rule::TRAPEZOIDAL, line);
            step.expect("the Hessian is positive definite near a minimiser")
        });
        race.add("solve", || problem.solve_with(Rule::TRAPEZOIDAL, black_box(n), &options));
        race.add("solve by the instructions that all processors have", || {
            let (workspace, ends) = (&mut Workspace::default(), problem.ends());
            minimise_by_batches(
                workspace,
                &baseline,
                ends,
                Rule::TRAPEZOIDAL,
                black_box(n),
                &options,
            )
        });
        race.add("solve of the formula as text", || {
            from_text.solve_with(Rule::TRAPEZOIDAL, black_box(n), &options)
        });
        let times = race.run();
        for (what, time) in &times {
            let limit = match *what {
                "assembly" => "assembly by hand",
                "solve of the formula as text" => "solve",
                _ => "newton step by hand",
            };
            let limit = times.iter().find(|(what, _)| *what == limit);
            let ratio = limit.map_or(String::new(), |(_, limit)| {
                format!("{:.2}", time.as_secs_f64() / limit.as_secs_f64())
            });
            let per_node = 1e9 * time.as_secs_f64() / n as f64;
            println!("{},{D},{n},{what},{per_node:.1},{ratio}", self.name);
        }
        Ok(())
    }
}

/// A curve like one in the middle of a search, close to a geodesic, for timing a pass over its
/// points.
fn bent<const D: usize>(
    line: &PointSequence<D>,
) -> Result<PointSequence<D>, tautline::SequenceError> {
    let n = line.n().get();
    let bend = |k: usize| 1e-3 * (PI * k as f64 / n as f64).sin();
    let points = line.points().iter().enumerate();
    PointSequence::new(points.map(|(k, x)| x.map(|x| x + bend(k))).collect())
}

/// Adds the passes that are written by hand for this problem, if there are any.
fn by_hand<const D: usize>(name: &str, race: &mut Race<'_>, line: &[SVector<f64, D>]) {
    let plane_line = || line.iter().map(|x| [x[0], x[1]]).collect();
    match name {
        "P1" => plane(race, plane_line(), limit::valleys),
        "P2" => plane(race, plane_line(), limit::bump),
        "P3" => space(race, line.iter().map(|x| [x[0], x[1], x[2]]).collect()),
        _ => {}
    }
}

fn plane<'a>(
    race: &mut Race<'a>,
    line: Vec<[f64; 2]>,
    metric: impl Fn([f64; 2]) -> Conformal + Copy + 'a,
) {
    let (mut assembled, points) = (Plane::new(line.len() - 1), line.clone());
    race.add("assembly by hand", move || assembled.assemble(black_box(&points), metric));
    let mut solved = Plane::new(line.len() - 1);
    race.add("newton step by hand", move || {
        let energy = solved.assemble(black_box(&line), metric);
        solved.solve();
        energy
    });
}

fn space(race: &mut Race<'_>, line: Vec<[f64; 3]>) {
    let (mut assembled, points) = (Space::new(line.len() - 1), line.clone());
    race.add("assembly by hand", move || assembled.assemble(black_box(&points)));
    let mut solved = Space::new(line.len() - 1);
    race.add("newton step by hand", move || {
        let energy = solved.assemble(black_box(&line));
        solved.solve();
        energy
    });
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).filter(|w| !w.starts_with('-')).collect();
    let (names, numbers): (Vec<_>, Vec<_>) = words.iter().partition(|word| word.starts_with('P'));
    let wanted =
        |words: &[&String], word: &str| words.is_empty() || words.iter().any(|w| *w == word);
    println!("problem,d,n,what,nanoseconds_per_node,ratio_to_limit");
    for name in PROBLEMS.into_iter().filter(|name| wanted(&names, name)) {
        for n in SIZES.into_iter().filter(|n| wanted(&numbers, &n.to_string())) {
            pose(name, n, Timing { name })?;
        }
    }
    Ok(())
}
