//! The time from a problem file to its answer, beside that of the same problem in Rust, in turns.
//!
//! `cargo bench --package tautline-problem` prints, for each problem and number of chords, the least
//! times of both in milliseconds, their ratio and their difference.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use tautline::{
    Ball, Ends, HalfSpace, Metric, Problem, Rule, SMatrix, SVector, Scalar, TautLine, gallery,
};
use tautline_problem::{Example, Grid, Question};

/// Runs of each side, and the time after which no further run begins.
const RUNS: usize = 200;
const LONGEST: Duration = Duration::from_secs(4);

struct Cost;
impl Metric<2> for Cost {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element((2.0 - x[0].cos()).sqr())
    }
}

fn main() {
    // Cargo passes `--bench`; a test run passes nothing, and measures nothing.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    println!("problem,n,file_ms,rust_ms,ratio,difference_ms");
    let walls = || {
        let ball = Ball::new([0.0, 0.0], 0.5).expect("a ball");
        Ends::new(ball, HalfSpace::at_least([1.0, 0.0], 3.0).expect("a wall")).expect("bounded")
    };
    let obstacle = |x: [f64; 2]| gallery::Obstacle { centre: x.into(), height: 12.0, width: 0.5 };
    let obstacles = [[1.0, 0.2], [2.6, 1.3], [2.9, -0.9], [4.3, 0.3]].map(obstacle);
    let far = || Ends::points([-0.5, 0.0], [5.5, 0.4]).expect("finite");
    let arm = || gallery::TwoLinkArm::new(4.0, 0.8, 1.0).expect("an arm");
    let arms = || Ends::points([0.0, 0.2], [std::f64::consts::PI / 2.0, 2.4]).expect("finite");
    for n in [64, 1000, 10_000] {
        compare("valleys", n, || Cost, walls);
        compare("robot_arm", n, arm, arms);
        let field = || gallery::SoftObstacles::<2>::new(obstacles.into()).expect("obstacles");
        compare("obstacles", n, field, far);
    }
}

/// Times both sides in turns, and prints the row.
fn compare<M: Metric<D>, const D: usize>(
    name: &str,
    n: usize,
    metric: impl Fn() -> M,
    ends: impl Fn() -> Ends<D>,
) {
    let file = Example::named(name).unwrap_or_else(|| panic!("no example {name}")).text;
    let mut least = [f64::INFINITY; 2];
    let begin = Instant::now();
    for _ in 0..RUNS {
        let start = Instant::now();
        let mut question = Question::read(file).expect("a problem");
        question.set_grid(Grid::Chords(n)).expect("a grid");
        question.without_bounds();
        let answer = question.solve(&mut |_| ()).expect("solved");
        least[0] = least[0].min(start.elapsed().as_secs_f64());
        let start = Instant::now();
        let line = Problem::new(metric(), ends()).solve(Rule::TRAPEZOIDAL, n).expect("solved");
        // What a file is answered with, but for the lists of points.
        let lengths = (line.length(), line.energy(), line.distance_squared_estimate());
        let others: Vec<_> = line.other_minima().iter().map(TautLine::length).collect();
        least[1] = least[1].min(start.elapsed().as_secs_f64());
        assert_eq!(answer.length.value.to_bits(), lengths.0.value.to_bits(), "{name}");
        black_box((answer, lengths, others));
        if begin.elapsed() > LONGEST {
            break;
        }
    }
    let [file, rust] = least.map(|seconds| 1e3 * seconds);
    println!("{name},{n},{file:.3},{rust:.3},{:.2},{:.3}", file / rust, file - rust);
}
