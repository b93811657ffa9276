//! `Spline`: an array as a function.

use std::{any::Any, sync::Arc};

use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods, ToPyArray};
use pyo3::{prelude::*, types::PyType};
use tautline::{FineSpline, Interval, SplineError, Table};
use tautline_any::Given;

use crate::error::ProblemError;

/// A tensor product of cubic B-splines on one to three axes, as a function of an index along each axis.
#[pyclass(frozen, from_py_object, module = "tautline_geodesics._tautline")]
#[derive(Clone, Debug)]
pub(crate) struct Spline {
    pub(crate) spline: Arc<tautline::Spline>,
    /// Whether there are three coefficients from one sample to the next, and not one.
    is_fine: bool,
}

impl Spline {
    /// Returns the function that a text calls.
    pub(crate) fn table(&self) -> Arc<dyn Table> {
        let spline = Arc::clone(&self.spline);
        if self.is_fine { Arc::new(FineSpline::of(spline)) } else { spline }
    }
}

impl From<FineSpline> for Spline {
    fn from(fine: FineSpline) -> Self {
        Self { spline: Arc::clone(fine.spline()), is_fine: true }
    }
}

impl From<tautline::Spline> for Spline {
    fn from(spline: tautline::Spline) -> Self {
        Self { spline: Arc::new(spline), is_fine: false }
    }
}

fn refused(error: &SplineError) -> PyErr {
    ProblemError::new_err(error.to_string())
}

/// Returns the tables that a formula calls, in the order of their first calls.
pub(crate) fn called(given: &Given) -> PyResult<Vec<Spline>> {
    let spline = |table: &Arc<dyn Table>| {
        let table: Arc<dyn Any + Send + Sync> = Arc::clone(table) as _;
        let spline = table.downcast().map_err(|_| ProblemError::new_err("a table is no array"))?;
        Ok(Spline { spline, is_fine: false })
    };
    given.tables().iter().map(spline).collect()
}

#[pymethods]
impl Spline {
    #[new]
    fn new(
        py: Python<'_>,
        values: PyReadonlyArrayDyn<'_, f64>,
        kind: &str,
    ) -> PyResult<Self> {
        let (shape, values) = (values.shape().to_vec(), values.to_vec()?);
        let made = py.detach(|| match kind {
            "monotone" => FineSpline::monotone(&shape, values).map(Self::from),
            "cubic" => tautline::Spline::interpolating(&shape, values).map(Self::from),
            "coefficients at thirds" => tautline::Spline::new(&shape, values)
                .map(|spline| Self { is_fine: true, ..Self::from(spline) }),
            _ => tautline::Spline::new(&shape, values).map(Self::from),
        });
        made.map_err(|error| refused(&error))
    }

    /// Splines through the entries of symmetric matrices, an array of shape (…, m) with the entries on and
    /// above the diagonal, row by row: one for each entry. They are positive definite between the samples.
    #[staticmethod]
    fn matrices(
        py: Python<'_>,
        values: PyReadonlyArrayDyn<'_, f64>,
        size: usize,
    ) -> PyResult<Vec<Self>> {
        let shape = &values.shape()[..values.ndim() - 1];
        let values = values.to_vec()?;
        let made = py.detach(|| FineSpline::monotone_matrices(shape, size, values));
        let splines = made.map_err(|error| refused(&error))?;
        Ok(splines.into_iter().map(Self::from).collect())
    }

    /// Another process makes it again from its coefficients.
    #[expect(clippy::type_complexity, reason = "a type and its arguments")]
    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyType>, (Bound<'py, PyArrayDyn<f64>>, &'static str))> {
        let kind = if slf.get().is_fine { "coefficients at thirds" } else { "smoothing" };
        Ok((slf.get_type(), (slf.get().coefficients(slf.py())?, kind)))
    }

    /// The number of samples along each axis.
    #[getter]
    fn shape(&self) -> Vec<usize> {
        let spline = &self.spline;
        if self.is_fine { FineSpline::of(Arc::clone(spline)).shape() } else { spline.shape().to_vec() }
    }

    /// The coefficients.
    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.spline.coefficients().to_pyarray(py).reshape(self.spline.shape().to_vec())
    }

    /// The value at a point.
    fn value(&self, u: Vec<f64>) -> f64 {
        self.table().value(&u, [0; 3])
    }

    /// Proved bounds on the values, over all of space.
    fn range(&self) -> (f64, f64) {
        let range: Interval = self.spline.range([0; 3]);
        (range.lo(), range.hi())
    }

    fn __repr__(&self) -> String {
        format!("<tautline.Spline of shape {:?}>", self.shape())
    }
}
