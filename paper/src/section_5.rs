//! The counterexample of Section 5: the valleys, from `(0, 0)` to `(4π, 0)`.
//!
//! Since `f = 2 − cos x₁ ≥ 1`, every discrete length is at least `Σ |xₙ₊₁ − xₙ| ≥ 4π`. Equality
//! holds if and only if the points run monotonically along `[0, 4π] × {0}` and the rule evaluates
//! `f` at points with `f = 1` on every chord that is not zero.

use std::f64::consts::{PI, TAU};

use tautline::{Ends, PointSequence, Problem, SVector, SequenceError, SetError, gallery::Valleys};

use crate::data::Tolerance;

/// The end points of the counterexample.
pub const ENDS: [[f64; 2]; 2] = [[0.0, 0.0], [2.0 * TAU, 0.0]];

/// The distance `8π` between them, since `u = 2x₁ − sin x₁` has `|∇u| = f`.
pub const DISTANCE: f64 = 8.0 * PI;

/// The minimum `4π` of both discrete lengths, for every `N`.
pub const DISCRETE_LENGTH: f64 = 4.0 * PI;

/// Lengths are at most 25, computed to rounding accuracy.
pub(crate) const LENGTH: Tolerance = Tolerance::relative(1e-11);

/// Returns the problem of the counterexample.
pub(crate) fn problem() -> Result<Problem<Valleys, 2>, SetError> {
    Ok(Problem::new(Valleys, Ends::points(ENDS[0], ENDS[1])?))
}

/// Returns all `N (N + 1) / 2` minimisers of the left-endpoint length. They are nondecreasing
/// sequences in the valleys `0, 2π, 4π`, each determined by where it leaves the first and the
/// second valley.
pub fn left_minimisers(n: usize) -> impl Iterator<Item = Vec<f64>> {
    (1..=n).flat_map(move |leave| (leave..=n).map(move |arrive| (leave, arrive))).map(
        move |(leave, arrive)| {
            let valley = |k: usize| usize::from(k >= leave) + usize::from(k >= arrive);
            (0..=n).map(|k| valley(k) as f64 * TAU).collect()
        },
    )
}

/// Returns all `N` minimisers of the trapezoidal length. Each has one jump from `0` to `4π`, on
/// which the rule evaluates `f` in the valley at the middle.
pub fn trapezoidal_minimisers(n: usize) -> impl Iterator<Item = Vec<f64>> {
    (1..=n).map(move |at| jump(n, at))
}

/// Returns the minimiser that jumps in the middle.
pub(crate) fn middle_jump(n: usize) -> Vec<f64> {
    jump(n, n / 2 + 1)
}

fn jump(n: usize, at: usize) -> Vec<f64> {
    (0..=n).map(|k| if k < at { 0.0 } else { 2.0 * TAU }).collect()
}

/// Returns the sequence with these values of `x₁`, and with `x₂ = 0`.
///
/// # Errors
///
/// If there are fewer than two points.
pub fn along_the_axis(x1: &[f64]) -> Result<PointSequence<2>, SequenceError> {
    PointSequence::new(x1.iter().map(|&x| SVector::from([x, 0.0])).collect())
}

/// Returns every sequence of `n + 1` points between the ends whose inner points lie on the grid
/// `x₁ ∈ {−π, −π/2, 0, …, 5π}`, `x₂ ∈ {−1, 0}`.
#[must_use]
pub fn grid_sequences(n: usize) -> Vec<Vec<SVector<f64, 2>>> {
    let grid: Vec<SVector<f64, 2>> = (-2..=10)
        .flat_map(|k| [-1.0, 0.0].map(|x2| SVector::from([f64::from(k) * 0.5 * PI, x2])))
        .collect();
    let mut sequences = vec![vec![SVector::from(ENDS[0])]];
    for _ in 1..n {
        sequences = sequences
            .iter()
            .flat_map(|sequence| {
                grid.iter().map(|point| {
                    let mut longer = sequence.clone();
                    longer.push(*point);
                    longer
                })
            })
            .collect();
    }
    sequences.iter_mut().for_each(|sequence| sequence.push(SVector::from(ENDS[1])));
    sequences
}
