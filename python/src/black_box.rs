//! `Callback`: a metric by a Python function of many points.

use std::sync::{Mutex, MutexGuard, PoisonError};

use numpy::{IntoPyArray, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use tautline_any::Values;

use crate::error::ProblemError;

/// Functions of an array of points of shape (m, D), which return H or its derivatives.
pub(crate) struct Callback {
    pub(crate) dimension: usize,
    /// H, its first and its second derivatives.
    pub(crate) functions: [Option<Py<PyAny>>; 3],
    /// The first and the second derivatives along a vector.
    pub(crate) along: [Option<Py<PyAny>>; 2],
    /// The first exception of a function.
    raised: Mutex<Option<PyErr>>,
}

impl Callback {
    pub(crate) fn new(
        dimension: usize,
        functions: [Option<Py<PyAny>>; 3],
        along: [Option<Py<PyAny>>; 2],
    ) -> Self {
        Self { dimension, functions, along, raised: Mutex::default() }
    }

    /// Returns the first exception of a function, and forgets it.
    pub(crate) fn raised(&self) -> Option<PyErr> {
        self.kept().take()
    }

    /// Calls a function of the points, and of a vector for each point if there is one. After an exception
    /// all numbers are NaN, so that the search ends.
    fn call(&self, order: usize, x: &[f64], v: Option<&[f64]>) -> Option<Vec<f64>> {
        let function = match v {
            None => self.functions[order].as_ref()?,
            Some(_) => self.along[order - 1].as_ref()?,
        };
        let axes = if v.is_some() { 2 } else { 2 + order };
        let numbers = x.len() * self.dimension.pow(axes as u32 - 1);
        let nothing = || Some(vec![f64::NAN; numbers]);
        if self.kept().is_some() {
            return nothing();
        }
        // The lock is free: a thread that waits for it must not hold the interpreter.
        let found = Python::attach(|py| {
            py.check_signals()?;
            let array = |x: &[f64]| {
                x.to_vec().into_pyarray(py).reshape([x.len() / self.dimension, self.dimension])
            };
            let points = array(x)?;
            let values = match v {
                None => function.call1(py, (points,))?,
                Some(v) => function.call1(py, (points, array(v)?))?,
            };
            self.checked(values.into_bound(py), order, axes, x.len() / self.dimension)
        });
        match found {
            Ok(values) => Some(values),
            Err(error) => {
                self.kept().get_or_insert(error);
                nothing()
            }
        }
    }

    fn kept(&self) -> MutexGuard<'_, Option<PyErr>> {
        self.raised.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the numbers of what a function returned at `m` points, with so many axes of the dimension.
    fn checked(
        &self,
        values: Bound<'_, PyAny>,
        order: usize,
        axes: usize,
        m: usize,
    ) -> PyResult<Vec<f64>> {
        let what = ["H", "the first derivative", "the second derivative"][order];
        let values =
            values.py().import("tautline_geodesics._convert")?.call_method1("returned", (values, what))?;
        let values = values.cast_into::<PyArrayDyn<f64>>()?;
        let mut shape = vec![m];
        shape.extend(std::iter::repeat_n(self.dimension, axes));
        if values.shape() != shape {
            let message =
                format!("{what} has the shape {:?} at {m} points, not {shape:?}", values.shape());
            return Err(ProblemError::new_err(message));
        }
        Ok(values.to_vec()?)
    }
}

impl Values for Callback {
    fn gram(&self, x: &[f64]) -> Vec<f64> {
        self.call(0, x, None).unwrap_or_default()
    }

    fn first(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.call(1, x, None)
    }

    fn second(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.call(2, x, None)
    }

    fn is_along(&self) -> bool {
        self.along[0].is_some()
    }

    fn first_along(&self, x: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        self.call(1, x, Some(v))
    }

    fn second_along(&self, x: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        self.call(2, x, Some(v))
    }
}
