//! Metrics with obstacles.

use std::{any::Any, sync::Arc};

use pyo3::prelude::*;
use tautline_problem::value::Region;

use crate::{
    error::{ProblemError, raised},
    metric::Program,
    set::Set,
    table::Spline,
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
    let mut tables = Vec::new();
    for (k, table) in given.tables().iter().enumerate() {
        let table: Arc<dyn Any + Send + Sync> = Arc::clone(table) as _;
        let Ok(spline) = table.downcast::<tautline::Spline>() else {
            return Err(ProblemError::new_err("a table is no array"));
        };
        tables.push((format!("table{}", k + 1), Spline { spline }));
    }
    Ok((given.text().unwrap_or_default(), tables))
}
