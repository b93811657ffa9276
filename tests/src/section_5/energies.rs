//! The discrete energies: the solver finds their global minima, and these converge to `d²`.
//!
//! On the valleys the search is one on the line: to set `x₂ = 0` everywhere leaves `H = f(x₁)² I`
//! where it is read and shortens the chords.

use std::f64::consts::{PI, TAU};

use tautline::{
    Bounded, Ends, Interpolation, LeftEndpoint, Metric, Options, PointSequence, Problem, Rule,
    SVector, Starts, Trapezoidal,
    gallery::{Ramp, Valleys},
};

use super::dynamic_programming::Line;

/// The grids on which dynamic programming is compared with the solver.
const GRIDS: [usize; 16] = [1, 2, 3, 4, 6, 8, 10, 12, 16, 18, 24, 33, 48, 64, 96, 128];

/// Solves for all of [`GRIDS`], and compares with the minima over sequences of grid points,
/// which `embed` places in the space of the problem.
///
/// - `E_N ≤` the minimum on the grid: no sequence of grid points is better;
/// - `E_N ≤` what the search makes of that sequence: neither is one close to it;
/// - `E_N ≥` the minimum on the grid less the grid's error, as it must.
///
/// All grids are tried before the test fails, so that its message has all that were missed.
#[track_caller]
fn solver_is_global<M: Metric<D>, R: Rule, const D: usize>(
    problem: &Problem<M, D>,
    rule: R,
    line: &Line<'_>,
    embed: impl Fn(f64) -> SVector<f64, D>,
) {
    let solved = GRIDS.map(|n| problem.solve(rule, n).expect("a metric").discrete_energy());
    let largest = solved.into_iter().fold(0.0, f64::max);
    let minima = line.minima(GRIDS[GRIDS.len() - 1], largest);
    let mut missed = Vec::new();
    for (n, energy) in GRIDS.into_iter().zip(solved) {
        let best = &minima[n - 1];
        let points = best.sequence.iter().map(|&x| embed(x)).collect();
        let start = PointSequence::new(points).expect("finite");
        // Energies are sums of up to 128 terms, a dozen roundings each; converged to 1e-15.
        let slack = 1e-13 * energy;
        let on_grid = rule.energy(problem.metric(), &start);
        assert!((on_grid - best.energy).abs() <= slack, "N = {n}: {on_grid}, {}", best.energy);
        let options = Options { starts: Starts::Only(vec![start]), ..Options::default() };
        let from_grid = problem.solve_with(rule, n, &options).expect("a metric").discrete_energy();
        if !(energy <= best.energy + slack && energy <= from_grid + slack) {
            missed.push(format!(
                "N = {n}: {energy} was found, but there are {} on the grid at {:.3?} and {from_grid} \
                 near it",
                best.energy, best.sequence
            ));
        }
        let lower = best.energy - best.grid_error;
        assert!(energy >= lower - slack, "N = {n}: {energy} is below {lower}");
    }
    assert!(missed.is_empty(), "not the global minimum:\n{}", missed.join("\n"));
}

fn valleys() -> Problem<Valleys, 2> {
    Problem::new(Valleys, Ends::points([0.0, 0.0], [2.0 * TAU, 0.0]).expect("finite"))
}

/// The valleys along the axis; the rule reads at the fraction `theta`.
pub(crate) fn axis(theta: f64) -> Line<'static> {
    Line {
        ends: [0.0, 2.0 * TAU],
        gram: &|x| (2.0 - x.cos()).powi(2),
        constants: Bounded::<2>::constants(&Valleys),
        theta,
        intervals: 800,
    }
}

#[track_caller]
fn valleys_are_solved_globally(rule: impl Rule, theta: f64) {
    solver_is_global(&valleys(), rule, &axis(theta), |x| SVector::from([x, 0.0]));
}

#[test]
fn section_5_the_solver_finds_the_global_minimum_of_the_trapezoidal_energy() {
    valleys_are_solved_globally(Trapezoidal, 0.5);
}

#[test]
fn section_5_the_solver_finds_the_global_minimum_of_the_left_endpoint_energy() {
    valleys_are_solved_globally(LeftEndpoint, 0.0);
}

/// The same on the line, where the metric is monotone and nothing is gained by jumps, both up
/// and down the ramp.
#[test]
fn the_solver_finds_the_global_minimum_on_a_ramp() {
    for amplitude in [0.5, -0.7] {
        let ramp = Ramp::new(amplitude, 1.5).expect("valid");
        let gram = |x: f64| ramp.gram(&SVector::from([x]))[(0, 0)];
        let line = |theta| Line {
            ends: [-1.0, 2.0],
            gram: &gram,
            constants: ramp.constants(),
            theta,
            intervals: 400,
        };
        let problem = Problem::new(ramp, Ends::points([-1.0], [2.0]).expect("finite"));
        let embed = |x: f64| SVector::from([x]);
        solver_is_global(&problem, Trapezoidal, &line(0.5), embed);
        solver_is_global(&problem, LeftEndpoint, &line(0.0), embed);
    }
}

/// One jump has the discrete energy `16π²N`, which is less than `d² = 64π²` for `N ≤ 3`, while the
/// curve has `72π²N`: at small `N` the minima of the discrete energies undershoot too.
#[test]
fn section_5_one_jump_undershoots_for_n_up_to_3() {
    let d2 = 64.0 * PI * PI;
    for n in 1..=8 {
        let points = (0..=n).map(|k| SVector::from([if k == 0 { 0.0 } else { 2.0 * TAU }, 0.0]));
        let jump = PointSequence::new(points.collect()).expect("finite");
        let (count, trapezoidal) = (n as f64, Trapezoidal.energy(&Valleys, &jump));
        approx::assert_relative_eq!(trapezoidal, 16.0 * PI * PI * count, max_relative = 1e-14);
        assert_eq!(trapezoidal < d2, n <= 3);
        let energy = Interpolation::new(&jump).energy(&Valleys).value;
        approx::assert_relative_eq!(energy, 72.0 * PI * PI * count, max_relative = 1e-14);
        let found = valleys().solve(Trapezoidal, n).expect("a metric").discrete_energy();
        assert!(found <= trapezoidal * (1.0 + 1e-14), "N = {n}: {found}");
    }
    // One chord leaves no choice.
    let found = valleys().solve(Trapezoidal, 1).expect("a metric");
    approx::assert_relative_eq!(found.discrete_energy(), 16.0 * PI * PI, max_relative = 1e-14);
}

/// `√E_N → 8π`, as the lengths do not. With `γ̇ = d/f` and `dt = f dx/d` the leading constants are
///
/// ```text
/// (1/12) ∫ γ̈ᵀHγ̈ dt = (d³/12) ∫ f′²/f³ dx = (d³/24) ∫ f″/f² dx = d³ π/18√3
/// N² (E_tra,N − d²) → −(d³/12) ∫ f″/f² dx = −d³ π/9√3,   ∫ cos x/(2 − cos x)² dx = 4π/3√3 on [0, 4π]
/// ```
#[test]
fn section_5_the_roots_of_the_energies_converge_to_the_distance() {
    let d2 = 64.0 * PI * PI;
    let scaled = |n: usize| {
        let line = valleys().solve(Trapezoidal, n).expect("a metric");
        [line.discrete_energy(), line.energy().value].map(|e| (n * n) as f64 * (e - d2))
    };
    // What another program measured at N = 256, to six decimals. Rounding: 2^16 times some ulp
    // of 632, 1e-13. The energy of the curve is not stationary: decrements of 1e-18 of 632 move
    // it by 2 (632e-18 · 0.024)^{1/2} = 8e-9, times 2^16.
    let [discrete, curve] = scaled(256);
    assert!((discrete + 3201.762884).abs() <= 1e-6, "{discrete}");
    assert!((curve - 1604.101685).abs() <= 6e-4, "{curve}");
    // Extrapolated once, the next term is (10/256)⁴ of it.
    let (coarse, fine) = (scaled(512), scaled(1024));
    let [discrete, curve] = [0, 1].map(|i| (4.0 * fine[i] - coarse[i]) / 3.0);
    let expected = (8.0 * PI).powi(3) * PI / (9.0 * 3_f64.sqrt());
    assert!((discrete + expected).abs() <= 1e-5 * expected, "{discrete}");
    assert!((curve - 0.5 * expected).abs() <= 1e-5 * expected, "{curve}");
    let root = valleys().solve(LeftEndpoint, 4096).expect("a metric").discrete_energy().sqrt();
    // Of order 2 too, by symmetry; some ten times the constant.
    assert!((root - 8.0 * PI).abs() <= 1e4 / (4096.0 * 4096.0), "{root}");
}
