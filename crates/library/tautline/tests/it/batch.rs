//! Problems in a batch have the same results as one by one.

use std::{collections::HashSet, sync::Mutex, thread};

use rayon::ThreadPoolBuilder;
use tautline::{
    Ball, Ends, HalfSpace, Metric, Options, Problem, Rule, SMatrix, SVector, Scalar, SolveError,
    TautLine,
    gallery::{Bump, Hyperbolic},
    solve_all,
};

type Lines<M> = Vec<Result<TautLine<M, 2>, SolveError>>;

fn on_threads<M: Metric<2> + Send>(
    threads: usize,
    problems: &[Problem<M, 2>],
    rule: Rule,
    n: usize,
) -> Lines<M> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(|| solve_all(problems, rule, n, &Options::default()))
}

/// Everything that a search returns, printed: numbers print alike only if they have the same bits,
/// while equal ones may differ in the sign of a zero.
fn printed<M: Metric<2>>(lines: &Lines<M>) -> Vec<String> {
    let minima = lines.iter().map(|line| line.as_ref().map(TautLine::minimum));
    minima.map(|minimum| format!("{minimum:?}")).collect()
}

#[track_caller]
fn compare(rule: Rule, n: usize) {
    let bumps = [1.0, 2.0, 4.0].map(|height| Bump::new(height, 0.5).expect("valid"));
    let wall = HalfSpace::at_least([1.0, 0.0], 2.0).expect("a normal");
    let mut problems = Vec::new();
    for bump in bumps {
        for k in 0..4 {
            let y = 0.1 + 0.3 * f64::from(k);
            let points = Ends::points([-1.5, y], [1.5, -0.1]).expect("finite");
            let ball = Ball::new([-2.0, y], 0.5).expect("a radius");
            let sets = Ends::new(ball, wall.clone()).expect("one bounded");
            problems.extend([points, sets].map(|ends| Problem::new(bump, ends)));
        }
    }
    let one_by_one: Lines<_> = problems.iter().map(|problem| problem.solve(rule, n)).collect();
    let expected = printed(&one_by_one);
    assert!(
        one_by_one.iter().all(|line| line.as_ref().is_ok_and(|l| l.minimum().is_local_minimum()))
    );
    // All are different: none can take the place of another.
    for (k, line) in expected.iter().enumerate() {
        assert!(!expected[..k].contains(line), "{k}: {line}");
    }
    for threads in [1, 2, 5] {
        let found = on_threads(threads, &problems, rule, n);
        assert_eq!(printed(&found), expected, "{threads} threads");
        for (line, problem) in found.iter().flatten().zip(&problems) {
            assert_eq!(line.metric(), problem.metric());
        }
    }
}

/// On a single grid, and on grids that are refined in the memory of the previous problem.
#[test]
fn a_batch_has_the_results_of_its_problems_one_by_one() {
    compare(Rule::TRAPEZOIDAL, 32);
    compare(Rule::TRAPEZOIDAL, 1000);
    compare(Rule::LEFT_ENDPOINT, 300);
}

#[test]
fn an_error_stays_in_its_place() {
    // Every third end is outside the unit disc, where the metric is undefined.
    let end = |k: usize| if k % 3 == 1 { [0.0, 2.0] } else { [0.5, 0.01 * k as f64] };
    let pose = |k| Problem::new(&Hyperbolic, Ends::points([-0.5, 0.0], end(k)).expect("finite"));
    let problems: Vec<_> = (0..20).map(pose).collect();
    for threads in [1, 2] {
        let lines = on_threads(threads, &problems, Rule::TRAPEZOIDAL, 80);
        assert_eq!(lines.len(), problems.len());
        for (k, line) in lines.into_iter().enumerate() {
            match line {
                Ok(line) => {
                    assert!(k % 3 != 1, "{k}");
                    assert_eq!(line.sequence().last().as_slice(), end(k));
                }
                Err(error) => {
                    assert!(k % 3 == 1, "{k}: {error}");
                    assert!(matches!(error, SolveError::Metric(_)), "{k}: {error}");
                }
            }
        }
    }
}

#[test]
fn without_chords_every_problem_is_refused_and_no_problems_are_fine() {
    let ends = Ends::points([-0.5, 0.0], [0.5, 0.1]).expect("finite");
    let problems = vec![Problem::new(Hyperbolic, ends); 3];
    let lines = on_threads(2, &problems, Rule::TRAPEZOIDAL, 0);
    assert!(lines.len() == 3 && lines.iter().all(|l| matches!(l, Err(SolveError::NoSubinterval))));
    assert!(on_threads(2, &problems[..0], Rule::TRAPEZOIDAL, 10).is_empty());
}

/// The Euclidean metric, with a record of the threads that evaluate it: it compares numbers, so
/// that its formula is evaluated as compiled.
#[derive(Default)]
struct Asked(Mutex<HashSet<thread::ThreadId>>);

impl Metric<4> for Asked {
    fn gram<S: Scalar>(&self, x: &SVector<S, 4>) -> SMatrix<S, 4, 4> {
        let _ = x[0] == x[1];
        self.0.lock().expect("nobody panics").insert(thread::current().id());
        SMatrix::identity()
    }
}

/// On a grid for which a single problem would use two.
#[test]
fn each_problem_of_a_batch_has_one_thread() {
    let threads_of = |solve: fn(&[Problem<&Asked, 4>])| {
        let asked = Asked::default();
        let ends = Ends::points([0.0; 4], [1.0; 4]).expect("finite");
        let problems = vec![Problem::new(&asked, ends); 3];
        // `Problem::new` evaluates it too.
        asked.0.lock().expect("nobody panics").clear();
        solve(&problems);
        asked.0.into_inner().expect("nobody panics").len()
    };
    let batch = threads_of(|problems| {
        let pool = ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
        pool.install(|| solve_all(problems, Rule::TRAPEZOIDAL, 5000, &Options::default()));
    });
    assert_eq!(batch, 1);
    let alone = threads_of(|problems| {
        problems[0].solve(Rule::TRAPEZOIDAL, 5000).expect("a metric");
    });
    let processors = thread::available_parallelism().map_or(1, usize::from);
    assert_eq!(alone > 1, processors > 1);
}
