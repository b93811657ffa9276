//! Metrics for unit tests.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_formula::{Formula, spline::Spline};
use tautline_metrics::Metric;
use tautline_scalar::{Scalar, Table};

/// Returns the metric with this text.
pub(crate) fn parsed<const D: usize>(text: &str) -> Formula<D> {
    Formula::parse(text, &[]).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// Returns tables `t`, `h` and `f` with one, two and three axes of three coefficients each. Each is the
/// sum of the same function of each argument, that with the coefficients 1, 5 and 2.
pub(crate) fn tables() -> [(&'static str, Arc<dyn Table>); 3] {
    [("t", 1), ("h", 2), ("f", 3)].map(|(name, axes)| {
        let part = |place: usize, axis: u32| [1.0, 5.0, 2.0][place / 3_usize.pow(axis) % 3];
        let coefficient = |place| (0..axes).map(|axis| part(place, axis)).sum();
        let coefficients = (0..3_usize.pow(axes)).map(coefficient).collect();
        let table = Spline::new(&vec![3; axes as usize], coefficients).expect("a shape");
        (name, Arc::new(table) as Arc<dyn Table>)
    })
}

/// A ridge of height 100 that intervals never see: they are never equal to one half, so they follow
/// the other branch.
pub(crate) struct Branch;

impl Metric<1> for Branch {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        let ridge = x[0] == S::constant(0.5);
        SMatrix::from_element(if ridge { S::constant(100.0) } else { S::one() })
    }
}
