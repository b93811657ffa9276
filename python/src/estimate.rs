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
/// It is compared, rounded, written with a format, and calculated with as its number is: a sum or a product
/// is a float, without the error. Two estimates are equal if both parts are.
#[pyclass(frozen, get_all, module = "tautline_geodesics")]
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

    /// Returns the number as an array without axes, so that functions of `NumPy` take it.
    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__<'py>(
        &self,
        py: Python<'py>,
        dtype: Option<&Bound<'py, PyAny>>,
        copy: Option<bool>,
    ) -> PyResult<Bound<'py, PyAny>> {
        // The array is new in any case.
        let _ = copy;
        py.import("numpy")?.call_method1("asarray", (self.value, dtype))
    }

    fn __add__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.before("add", other)
    }

    fn __radd__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.after("add", other)
    }

    fn __sub__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.before("sub", other)
    }

    fn __rsub__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.after("sub", other)
    }

    fn __mul__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.before("mul", other)
    }

    fn __rmul__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.after("mul", other)
    }

    fn __truediv__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.before("truediv", other)
    }

    fn __rtruediv__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.after("truediv", other)
    }

    fn __pow__<'py>(
        &self,
        other: &Bound<'py, PyAny>,
        modulo: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        // As for a float, there is no modulus.
        let _ = modulo;
        self.before("pow", other)
    }

    fn __neg__(&self) -> f64 {
        -self.value
    }

    fn __abs__(&self) -> f64 {
        self.value.abs()
    }

    fn __repr__(&self) -> String {
        format!("Estimate(value={:?}, error={:.1e})", self.value, self.error)
    }
}

impl Estimate {
    /// Applies an operation of Python to the number and another one.
    fn before<'py>(
        &self,
        operation: &str,
        other: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let operator = other.py().import("operator")?;
        match other.cast::<Self>() {
            Ok(other) => operator.call_method1(operation, (self.value, other.get().value)),
            Err(_) => operator.call_method1(operation, (self.value, other)),
        }
    }

    /// Applies an operation to another number and this one.
    fn after<'py>(
        &self,
        operation: &str,
        other: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        other.py().import("operator")?.call_method1(operation, (other, self.value))
    }

    fn number<'py>(&self, py: Python<'py>) -> Bound<'py, PyFloat> {
        PyFloat::new(py, self.value)
    }
}

impl From<Estimated> for Estimate {
    fn from(Estimated { value, error }: Estimated) -> Self {
        Self { value, error }
    }
}
