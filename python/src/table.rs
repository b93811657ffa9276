//! `Spline`: an array as a function.

use std::{any::Any, sync::Arc};

use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods, ToPyArray};
use pyo3::{prelude::*, types::PyType};
use tautline::{Interval, Table};
use tautline_any::Given;

use crate::error::ProblemError;

/// A tensor product of cubic B-splines on one to three axes, in grid units.
#[pyclass(frozen, from_py_object, module = "tautline._tautline")]
#[derive(Clone, Debug)]
pub(crate) struct Spline {
    pub(crate) spline: Arc<tautline::Spline>,
}

/// Returns the tables that a formula calls, in the order of their first calls.
pub(crate) fn called(given: &Given) -> PyResult<Vec<Spline>> {
    let spline = |table: &Arc<dyn Table>| {
        let table: Arc<dyn Any + Send + Sync> = Arc::clone(table) as _;
        let spline = table.downcast().map_err(|_| ProblemError::new_err("a table is no array"))?;
        Ok(Spline { spline })
    };
    given.tables().iter().map(spline).collect()
}

#[pymethods]
impl Spline {
    #[new]
    fn new(
        py: Python<'_>,
        values: PyReadonlyArrayDyn<'_, f64>,
        interpolate: bool,
    ) -> PyResult<Self> {
        let (shape, values) = (values.shape().to_vec(), values.to_vec()?);
        let made = py.detach(|| match interpolate {
            true => tautline::Spline::interpolating(&shape, values),
            false => tautline::Spline::new(&shape, values),
        });
        let spline = made.map_err(|error| ProblemError::new_err(error.to_string()))?;
        Ok(Self { spline: Arc::new(spline) })
    }

    /// Another process makes it again from its coefficients.
    #[expect(clippy::type_complexity, reason = "a type and its arguments")]
    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyType>, (Bound<'py, PyArrayDyn<f64>>, bool))> {
        Ok((slf.get_type(), (slf.get().coefficients(slf.py())?, false)))
    }

    /// The number of coefficients along each axis.
    #[getter]
    fn shape(&self) -> Vec<usize> {
        self.spline.shape().to_vec()
    }

    /// The coefficients.
    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.spline.coefficients().to_pyarray(py).reshape(self.spline.shape().to_vec())
    }

    /// A partial derivative of these orders at a point, in grid units.
    fn value(&self, u: Vec<f64>, orders: [u8; 3]) -> f64 {
        self.spline.value(&u, orders)
    }

    /// Proved bounds on a partial derivative of these orders, over all of space.
    fn range(&self, orders: [u8; 3]) -> (f64, f64) {
        let range: Interval = self.spline.range(orders);
        (range.lo(), range.hi())
    }

    fn __repr__(&self) -> String {
        format!("<tautline.Spline of shape {:?}>", self.spline.shape())
    }
}
