//! What each part of a solve costs, on the six problems on which solvers are compared, beside the
//! limit: the same Newton pass written by hand for one metric.
//!
//! `cargo bench --bench speed -- P1 100000` for one problem and one `N`.

mod limit;
mod limit_space;
mod problems;
mod race;

use std::hint::black_box;

use limit::{Conformal, Plane};
use limit_space::Space;
use problems::{Case, bent, p1, p2, p3, p4, p5, p6};
use race::Race;
use tautline::{Metric, Rule, Trapezoidal, energy_gradient};
use tautline_discretizations::QuadraticModel;

const SIZES: [usize; 4] = [1_000, 10_000, 100_000, 1_000_000];

/// What to measure.
struct Wanted(Vec<String>);

impl Wanted {
    fn wants(&self, problem: &str, n: usize) -> bool {
        let n = n.to_string();
        let (names, numbers): (Vec<_>, Vec<_>) =
            self.0.iter().partition(|word| word.starts_with('P'));
        (names.is_empty() || names.iter().any(|&name| name == problem))
            && (numbers.is_empty() || numbers.iter().any(|&number| *number == n))
    }
}

/// Measures one problem; `limit` adds what is written by hand.
fn measure<M: Metric<D>, const D: usize>(
    wanted: &Wanted,
    case: &Case<M, D>,
    limit: impl for<'a> Fn(&mut Race<'a>, &'a [[f64; D]]),
) {
    let options = case.options();
    for n in SIZES.into_iter().filter(|&n| wanted.wants(case.name, n)) {
        let metric = case.problem.metric();
        let short = case.problem.solve_with(Trapezoidal, 64, &options).expect("a metric");
        let line = bent([short.sequence().first(), short.sequence().last()], n);
        let points: Vec<[f64; D]> = line.points().iter().map(|&x| x.into()).collect();
        let line_again = line.clone();
        let mut race = Race::default();
        limit(&mut race, &points);
        race.add("energy", || Trapezoidal.energy(metric, black_box(&line)));
        race.add("gradient", || energy_gradient(Trapezoidal, metric, black_box(&line)));
        let mut model = QuadraticModel::default();
        race.add("assembly", move || {
            model.expand(Trapezoidal, metric, black_box(&line_again));
            model.energy
        });
        let mut workspace = Workspace::default();
        race.add("newton step", move || {
            newton_step(&mut workspace, metric, ends, Trapezoidal, black_box(&line_again))
        });
        race.add("solve", || case.problem.solve_with(Trapezoidal, black_box(n), &options));
        let times = race.run();
        let by_hand = |name| {
            let limit = times.iter().find(|(found, _)| *found == name);
            limit.map_or(f64::NAN, |(_, time)| time.as_secs_f64())
        };
        for (name, time) in &times {
            let limit =
                by_hand(if *name == "assembly" { "assembly by hand" } else { "newton by hand" });
            let seconds = time.as_secs_f64();
            println!(
                "{},{D},{n},{name},{:.1},{:.2}",
                case.name,
                1e9 * seconds / n as f64,
                seconds / limit
            );
        }
    }
}

fn none<const D: usize>(_: &mut Race<'_>, _: &[[f64; D]]) {}

fn plane<'a>(
    race: &mut Race<'a>,
    line: &'a [[f64; 2]],
    metric: impl Fn([f64; 2]) -> Conformal + Copy + 'a,
) {
    let mut assembled = Plane::new(line.len() - 1);
    race.add("assembly by hand", move || assembled.assemble(black_box(line), metric));
    let mut solved = Plane::new(line.len() - 1);
    race.add("newton by hand", move || {
        let energy = solved.assemble(black_box(line), metric);
        solved.solve();
        energy
    });
}

fn space<'a>(race: &mut Race<'a>, line: &'a [[f64; 3]]) {
    let mut assembled = Space::new(line.len() - 1);
    race.add("assembly by hand", move || assembled.assemble(black_box(line)));
    let mut solved = Space::new(line.len() - 1);
    race.add("newton by hand", move || {
        let energy = solved.assemble(black_box(line));
        solved.solve();
        energy
    });
}

fn main() {
    let words = std::env::args().skip(1).filter(|word| !word.starts_with('-'));
    let wanted = Wanted(words.collect());
    println!("problem,d,n,what,nanoseconds_per_node,ratio_to_limit");
    measure(&wanted, &p1(), |race, line| plane(race, line, limit::valleys));
    measure(&wanted, &p2(), |race, line| plane(race, line, limit::bump));
    measure(&wanted, &p3(), space);
    measure(&wanted, &p4(), none);
    measure(&wanted, &p5(), none);
    measure(&wanted, &p6(), none);
}
