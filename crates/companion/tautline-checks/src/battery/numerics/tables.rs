//! Metrics with tables, beside the same metrics without.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline::{Ends, Metric, Rule, Scalar, Spline, Table};
use tautline_statements::Statement::{Theorem1_1, Theorem1_2};

use crate::battery::harness::{Check, Failure, Outcome, Reference, Trial};

pub(crate) const CHECKS: &[Check] = &[Reference.check(
    "a_table_of_linear_numbers_is_the_linear_cost",
    &[Theorem1_1, Theorem1_2],
    linear_numbers,
)];

/// The number of nodes along each axis.
const SHAPE: [usize; 2] = [10, 8];

/// The cost `1 + x₁/4 + x₂/16`.
fn cost<S: Scalar>(x: &SVector<S, 2>) -> S {
    x[0] / 4.0 + x[1] / 16.0 + 1.0
}

/// The cost, read from a table with two nodes to a unit.
struct Tabulated(Arc<dyn Table>);

impl Metric<2> for Tabulated {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let u = [x[0] * 2.0, x[1] * 2.0];
        SMatrix::from_diagonal_element(S::tabulated(&self.0, [0; 3], &u).sqr())
    }
}

/// The cost as a formula.
struct Written;

impl Metric<2> for Written {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element(cost(x).sqr())
    }
}

/// Cubic B-splines reproduce linear functions where all four of their pieces are nodes, here for
/// `½ ≤ x₁ ≤ 4` and `½ ≤ x₂ ≤ 3`. Both minimisers stay there.
fn linear_numbers(trial: &Trial<'_>) -> Outcome {
    let nodes = (0..SHAPE[0] * SHAPE[1]).map(|k| {
        let place = [k / SHAPE[1], k % SHAPE[1]].map(|along| along as f64 / 2.0);
        cost(&SVector::from(place))
    });
    let spline = Spline::new(&SHAPE, nodes.collect());
    let table = Arc::new(spline.map_err(|error| Failure::new(error.to_string()))?);
    let ends = Ends::points([1.0, 1.0], [3.5, 2.5])?;
    for n in [1, 6, 40] {
        let read =
            trial.subject.minimise(Rule::TRAPEZOIDAL, &Tabulated(table.clone()), &ends, n)?;
        let written = trial.subject.minimise(Rule::TRAPEZOIDAL, &Written, &ends, n)?;
        let pairs = read.sequence.points().iter().zip(written.sequence.points());
        let apart = pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        // Both searches end at rounding, 1e-15 of the gradient, which moves the points by up to the
        // condition of the Hessian, about N², times as much.
        if !((read.energy / written.energy - 1.0).abs() <= 1e-13 && apart <= 1e-11) {
            return Err(Failure::new(format!(
                "N = {n}: the energy {} of the table, {} of the formula; the points are {apart:e} apart",
                read.energy, written.energy
            )));
        }
    }
    Ok(Default::default())
}
