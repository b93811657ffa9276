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
    /// The first exception of a function.
    raised: Mutex<Option<PyErr>>,
}

impl Callback {
    pub(crate) fn new(dimension: usize, functions: [Option<Py<PyAny>>; 3]) -> Self {
        Self { dimension, functions, raised: Mutex::default() }
    }

    /// Returns the first exception of a function, and forgets it.
    pub(crate) fn raised(&self) -> Option<PyErr> {
        self.kept().take()
    }

    /// Calls a function. After an exception all numbers are NaN, so that the search ends.
    fn call(&self, order: usize, x: &[f64]) -> Option<Vec<f64>> {
        let function = self.functions[order].as_ref()?;
        let numbers = x.len() * self.dimension.pow(1 + order as u32);
        let nothing = || Some(vec![f64::NAN; numbers]);
        if self.kept().is_some() {
            return nothing();
        }
        // The lock is free: a thread that waits for it must not hold the interpreter.
        let found = Python::attach(|py| {
            py.check_signals()?;
            self.returned(py, function, order, x)
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

    fn returned(
        &self,
        py: Python<'_>,
        function: &Py<PyAny>,
        order: usize,
        x: &[f64],
    ) -> PyResult<Vec<f64>> {
        let (d, m) = (self.dimension, x.len() / self.dimension);
        let points = x.to_vec().into_pyarray(py).reshape([m, d])?;
        let what = ["H", "the first derivative", "the second derivative"][order];
        let values = function.call1(py, (points,))?;
        let values = py.import("tautline._convert")?.call_method1("returned", (values, what))?;
        let values = values.cast_into::<PyArrayDyn<f64>>()?;
        let mut shape = vec![m];
        shape.extend(std::iter::repeat_n(d, 2 + order));
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
        self.call(0, x).unwrap_or_default()
    }

    fn first(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.call(1, x)
    }

    fn second(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.call(2, x)
    }
}
