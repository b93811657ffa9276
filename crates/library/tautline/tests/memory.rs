//! The peak memory of a solve.
//!
//! A separate binary with one test, since the counting allocator is global.

use std::f64::consts::PI;

use peak_alloc::PeakAlloc;
use tautline::{
    Ends, Metric, Options, PointSequence, Prepared, Problem, Rule, Starts,
    gallery::{Bump, Valleys},
};
use tautline_formula::Kind;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The bytes per point of a solve with `n` chords that starts from a straight line.
fn bytes_per_point<M: Metric<D>, const D: usize>(
    metric: M,
    [from, to]: [[f64; D]; 2],
    n: usize,
) -> f64 {
    let problem = Problem::new(metric, Ends::points(from, to).expect("finite"));
    let start = PointSequence::straight(from, to, 16).expect("finite");
    let options = Options { starts: Starts::Only(vec![start]), ..Options::default() };
    MEMORY.reset_peak_usage();
    let before = MEMORY.current_usage();
    let line = problem.solve_with(Rule::TRAPEZOIDAL, n, &options).expect("a metric");
    let bytes = MEMORY.peak_usage() - before;
    assert!(line.minimum().is_local_minimum());
    bytes as f64 / n as f64
}

/// The bytes of the registers of all programs of a metric, which the thread keeps: 128 numbers
/// each, and two to work with.
fn registers<M: Metric<2>>(metric: M) -> f64 {
    let prepared = Prepared::new(metric);
    let kinds = [Kind::Square, Kind::Checked, Kind::Momentum, Kind::Contraction];
    let counts = kinds.map(|kind| prepared.size(kind).expect("a program")[1] + 2);
    (counts.iter().sum::<usize>() * 128 * 8) as f64
}

/// [`tautline::minimise`] states these numbers.
#[test]
fn a_solve_stores_one_newton_step_and_on_fine_grids_little_more_than_its_points() {
    let bump = Bump::new(4.0, 0.5).expect("valid");
    for (n, bound) in [
        // 2D² + 2D = 12 numbers for a Newton step on the finest grid, its points included; and at
        // most seven lists of points on coarser grids, with an eighth of the points: three that are
        // kept, and those that make the next start.
        (8_000, 12.0 * 8.0 + 7.0 * 16.0 / 8.0),
        // The points; a step and seven lists on a grid with a sixteenth of the points.
        (100_000, 16.0 + (12.0 * 8.0 + 7.0 * 16.0) / 16.0),
    ] {
        let p1 = bytes_per_point(Valleys, [[0.0, 0.0], [4.0 * PI, 0.0]], n);
        let p2 = bytes_per_point(bump, [[-1.5, 0.05], [1.5, -0.1]], n);
        for (bytes, registers) in [(p1, registers(Valleys)), (p2, registers(bump))] {
            let bound = bound + registers / n as f64;
            // The result alone takes two numbers a point.
            assert!(16.0 < bytes && bytes <= bound, "N = {n}: {bytes} bytes a point");
        }
    }
}
