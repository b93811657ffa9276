//! The relative accuracy of what is proved or estimated.

use pyo3::PyResult;

use crate::error::ProblemError;

/// Returns a relative accuracy that is in the range that it has in problem files.
pub(crate) fn accuracy(tolerance: f64) -> PyResult<f64> {
    if tolerance > 0.0 && tolerance < 1.0 {
        return Ok(tolerance);
    }
    let message =
        format!("the tolerance {tolerance:?} is out of range; expected a number between 0 and 1");
    Err(ProblemError::new_err(message))
}
