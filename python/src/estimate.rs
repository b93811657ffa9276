//! `Estimate`: a number with an estimate of its error.

use pyo3::{prelude::*, types::PyType};
use tautline_problem::Estimated;

/// A number, and an estimate of its error.
#[pyclass(frozen, get_all, module = "tautline")]
#[derive(Clone, Debug)]
pub(crate) struct Estimate {
    /// The number.
    value: f64,
    /// The estimated error.
    error: f64,
}

#[pymethods]
impl Estimate {
    #[new]
    #[pyo3(signature = (value, error))]
    fn new(value: f64, error: f64) -> Self {
        Self { value, error }
    }

    /// Another process makes it again from its attributes.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, (f64, f64)) {
        (slf.get_type(), (slf.get().value, slf.get().error))
    }

    fn __float__(&self) -> f64 {
        self.value
    }

    fn __repr__(&self) -> String {
        format!("Estimate(value={:?}, error={:.1e})", self.value, self.error)
    }
}

impl From<Estimated> for Estimate {
    fn from(Estimated { value, error }: Estimated) -> Self {
        Self { value, error }
    }
}
