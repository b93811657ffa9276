//! Metrics with obstacles.

use pyo3::prelude::*;
use tautline_any::Region;

use crate::{
    error::raised,
    metric::Program,
    set::Set,
    table::{Spline, called},
};

/// A set, or a function that is negative in the region.
#[derive(FromPyObject)]
pub(crate) enum Obstacle {
    /// The pieces of a set.
    Set(Set),
    /// An expression.
    Text(String),
    /// The function `f` as the metric `f I`.
    Function(Py<Program>),
}

/// The steps of a formula, the tables that it calls by their names, and the name and the steps of a cost
/// or a speed that is to be positive.
type Parts = (String, Vec<(String, Spline)>, Option<(String, String)>);

/// The parts of a metric with obstacles.
#[pyfunction]
pub(crate) fn avoiding(
    program: &Program,
    obstacles: Vec<Obstacle>,
    margin: f64,
) -> PyResult<Parts> {
    let regions: Vec<Region> = obstacles
        .into_iter()
        .flat_map(|obstacle| match obstacle {
            Obstacle::Set(set) => set.pieces.iter().cloned().map(Region::Set).collect(),
            Obstacle::Text(text) => vec![Region::Negative(text)],
            Obstacle::Function(f) => vec![Region::NegativeOf(f.get().given.clone())],
        })
        .collect();
    let given = program.given.avoiding(&regions, margin).map_err(|error| raised(&error))?;
    // The cost calls the tables of its square in the same order, and the distances call none.
    let sign = program.sign.as_ref().and_then(|sign| Some((sign.name.clone(), sign.phi.text()?)));
    let tables = called(&given)?.into_iter().enumerate();
    let tables = tables.map(|(k, table)| (format!("table{}", k + 1), table)).collect();
    Ok((given.text().unwrap_or_default(), tables, sign))
}
