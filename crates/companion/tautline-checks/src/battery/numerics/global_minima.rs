//! The theorems are about global minimisers, and on the line the solver finds these.

use nalgebra::SVector;
use tautline::{
    Bounded, Ends, Metric, Options, PointSequence, Rule, Starts,
    gallery::{Ramp, Valleys},
};
use tautline_statements::Statement::{self, Proposition7_1, Theorem1_1, Theorem1_3};

use crate::GridLine;
use crate::battery::harness::{Check, Failure, Outcome, Reference, Trial, all};

const TRAPEZOIDAL: &[Statement] = &[Theorem1_1, Proposition7_1];
const LEFT: &[Statement] = &[Theorem1_3, Proposition7_1];

pub(crate) const CHECKS: &[Check] = &[
    Reference.check(
        "section_5_the_solver_finds_the_global_minimum_of_the_trapezoidal_energy",
        TRAPEZOIDAL,
        |trial| over_the_valleys(trial, Rule::TRAPEZOIDAL, 0.5),
    ),
    Reference.check(
        "section_5_the_solver_finds_the_global_minimum_of_the_left_endpoint_energy",
        LEFT,
        |trial| over_the_valleys(trial, Rule::LEFT_ENDPOINT, 0.0),
    ),
    Reference.check(
        "the_solver_finds_the_global_minimum_on_a_ramp",
        &[Theorem1_1, Theorem1_3, Proposition7_1],
        on_a_ramp,
    ),
];

/// The grids on which dynamic programming is compared with the solver.
const GRIDS: [usize; 16] = [1, 2, 3, 4, 6, 8, 10, 12, 16, 18, 24, 33, 48, 64, 96, 128];

/// Solves on all of [`GRIDS`], and compares the minima with those over sequences of grid points,
/// which `embed` maps to the space of the problem.
///
/// - `E_N` does not exceed the minimum on the grid: no sequence of grid points is better.
/// - `E_N` does not exceed what a local search from that sequence finds: no sequence close to it is
///   better.
/// - `E_N` is at least the minimum on the grid minus the error of the grid.
///
/// The check tries all grids before it fails, so that its message lists all misses.
fn is_global<M: Metric<D>, const D: usize>(
    trial: &Trial<'_>,
    (metric, ends): (&M, &Ends<D>),
    rule: Rule,
    line: &GridLine<'_>,
    embed: impl Fn(f64) -> SVector<f64, D>,
) -> Outcome {
    let subject = trial.subject;
    let mut solved = Vec::new();
    for n in GRIDS {
        let minimum = subject.minimise(rule, metric, ends, n)?;
        solved.push(subject.discrete_energy(rule, metric, &minimum.sequence));
    }
    let largest = solved.iter().copied().fold(0.0, f64::max);
    let minima = line.minima(GRIDS[GRIDS.len() - 1], largest);
    let mut missed = Vec::new();
    for (n, energy) in GRIDS.into_iter().zip(solved) {
        let best = &minima[n - 1];
        let points = best.sequence.iter().map(|&x| embed(x)).collect();
        let start = PointSequence::new(points)?;
        // Energies are sums of up to 128 terms, each with a dozen roundings; they have converged to
        // 1e-15.
        let tolerance = 1e-13 * energy;
        let on_grid = subject.discrete_energy(rule, metric, &start);
        let options = Options { starts: Starts::Only(vec![start]), ..Options::default() };
        let near = subject.minimise_with(rule, metric, ends, n, &options);
        let near = near?.sequence;
        let near = subject.discrete_energy(rule, metric, &near);
        let lower = best.energy - best.grid_error;
        let same = (on_grid - best.energy).abs() <= tolerance;
        if !(same
            && energy <= best.energy + tolerance
            && energy <= near + tolerance
            && energy >= lower - tolerance)
        {
            missed.push(format!(
                "N = {n}: {energy} was found, but there are {} (by the rule {on_grid}) on the grid \
                 at {:.3?} and {near} near it; no sequence has less than {lower}",
                best.energy, best.sequence
            ));
        }
    }
    if missed.is_empty() {
        Ok(Default::default())
    } else {
        Err(Failure::new(format!("not the global minimum:\n{}", missed.join("\n"))))
    }
}

fn over_the_valleys(trial: &Trial<'_>, rule: Rule, theta: f64) -> Outcome {
    let line = GridLine::over_the_valleys(theta);
    let ends = Ends::points([line.ends[0], 0.0], [line.ends[1], 0.0])?;
    is_global(trial, (&Valleys, &ends), rule, &line, |x| SVector::from([x, 0.0]))
}

/// The line runs up or down a ramp, where the metric is monotone, so that jumps gain nothing.
fn on_a_ramp(trial: &Trial<'_>) -> Outcome {
    all([0.5, -0.7].map(|amplitude| {
        let ramp = Ramp::new(amplitude, 1.5).expect("valid");
        let gram = |x: f64| ramp.gram(&SVector::from([x]))[(0, 0)];
        let line = |theta| GridLine {
            ends: [-1.0, 2.0],
            gram: &gram,
            constants: ramp.constants(),
            theta,
            intervals: 400,
        };
        let ends = Ends::points([-1.0], [2.0])?;
        let embed = |x: f64| SVector::from([x]);
        all([
            is_global(trial, (&ramp, &ends), Rule::TRAPEZOIDAL, &line(0.5), embed),
            is_global(trial, (&ramp, &ends), Rule::LEFT_ENDPOINT, &line(0.0), embed),
        ])
    }))
}
