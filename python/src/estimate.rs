//! `Estimate`: a number with an estimate of its error.

use pyo3::{
    basic::CompareOp,
    prelude::*,
    types::{PyFloat, PyIterator, PyTuple, PyType},
};
use tautline_problem::Estimated;

/// A number, and an estimate of its error: `value, error = estimate`.
///
/// The error of the length of a curve is that of the quadrature along this curve, not how far the
/// shortest curve is from it: `Curve.extrapolated` estimates the distance, with an error of its own.
///
/// It is compared, rounded, and written with a format as its number is. Two estimates are equal if both
/// parts are.
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

    fn __format__<'py>(slf: &Bound<'py, Self>, spec: &str) -> PyResult<Bound<'py, PyAny>> {
        match spec {
            "" => Ok(slf.str()?.into_any()),
            _ => slf.get().number(slf.py()).call_method1("__format__", (spec,)),
        }
    }

    #[pyo3(signature = (ndigits=None))]
    fn __round__<'py>(&self, py: Python<'py>, ndigits: Option<i32>) -> PyResult<Bound<'py, PyAny>> {
        self.number(py).call_method1("__round__", (ndigits,))
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyTuple::new(py, [self.value, self.error])?.try_iter()
    }

    fn __hash__(&self, py: Python<'_>) -> PyResult<isize> {
        self.number(py).hash()
    }

    fn __richcmp__<'py>(
        &self,
        other: &Bound<'py, PyAny>,
        operation: CompareOp,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = other.py();
        let number = match other.cast::<Self>() {
            Ok(other) => {
                let same = self.error == other.get().error;
                match operation {
                    CompareOp::Eq if !same => {
                        return Ok(false.into_pyobject(py)?.to_owned().into_any());
                    }
                    CompareOp::Ne if !same => {
                        return Ok(true.into_pyobject(py)?.to_owned().into_any());
                    }
                    _ => other.get().number(py).into_any(),
                }
            }
            Err(_) => other.clone(),
        };
        let real = py.import("numbers")?.getattr("Real")?;
        if !number.is_instance(&real)? {
            return Ok(py.NotImplemented().into_bound(py));
        }
        self.number(py).rich_compare(number, operation)
    }

    fn __repr__(&self) -> String {
        format!("Estimate(value={:?}, error={:.1e})", self.value, self.error)
    }
}

impl Estimate {
    fn number<'py>(&self, py: Python<'py>) -> Bound<'py, PyFloat> {
        PyFloat::new(py, self.value)
    }
}

impl From<Estimated> for Estimate {
    fn from(Estimated { value, error }: Estimated) -> Self {
        Self { value, error }
    }
}
