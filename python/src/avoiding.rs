//! Metrics with obstacles.

use pyo3::prelude::*;
use tautline_problem::value::Region;

use crate::{
    error::raised,
    metric::Program,
    set::Set,
    table::{Spline, called},
};

/// A set, or an expression that is negative in the region.
#[derive(FromPyObject)]
pub(crate) enum SetOrText {
    /// The pieces of a set.
    Set(Set),
    /// The expression.
    Text(String),
}

/// The steps of the formula of a metric with obstacles, and the tables that it calls by their names.
#[pyfunction]
pub(crate) fn avoiding(
    program: &Program,
    obstacles: Vec<SetOrText>,
    margin: f64,
) -> PyResult<(String, Vec<(String, Spline)>)> {
    let regions: Vec<Region> = obstacles
        .into_iter()
        .flat_map(|obstacle| match obstacle {
            SetOrText::Set(set) => set.pieces.iter().cloned().map(Region::Set).collect(),
            SetOrText::Text(text) => vec![Region::Negative(text)],
        })
        .collect();
    let given = program.given.avoiding(&regions, margin).map_err(|error| raised(&error))?;
    let tables = called(&given)?.into_iter().enumerate();
    let tables = tables.map(|(k, table)| (format!("table{}", k + 1), table)).collect();
    Ok((given.text().unwrap_or_default(), tables))
}
