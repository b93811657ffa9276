//! The exceptions.

use pyo3::{PyErr, create_exception, exceptions::PyValueError};
use tautline::{CertificateError, GraphPathError, RequestError, SolveError};
use tautline_any::GivenError;

create_exception!(
    tautline,
    ProblemError,
    PyValueError,
    "A set, a start, an option or a text is wrong; the message has the offending numbers."
);
create_exception!(
    tautline,
    MetricError,
    ProblemError,
    "The metric is not finite, symmetric and positive definite at a point of a curve."
);
create_exception!(
    tautline,
    SignError,
    MetricError,
    "The cost or the speed of a metric is negative at a point of a curve."
);
create_exception!(
    tautline,
    LatticeError,
    ProblemError,
    "The nodes of a lattice are not near the sets, or no path along them joins the sets."
);
create_exception!(
    tautline,
    NotCertified,
    PyValueError,
    "Nothing was proved: there is no certificate, or a certificate was refused."
);

/// Returns the exception of an error.
pub(crate) fn raised(error: &GivenError) -> PyErr {
    match error {
        GivenError::Request(RequestError::Solve(SolveError::Metric(_))) => {
            MetricError::new_err(error.to_string())
        }
        GivenError::Request(RequestError::Lattice(
            GraphPathError::FarFromEnd { .. } | GraphPathError::NotConnected,
        )) => LatticeError::new_err(error.to_string()),
        GivenError::Constants(_) => NotCertified::new_err(error.to_string()),
        _ => ProblemError::new_err(error.to_string()),
    }
}

/// Returns the exception of a search without a certificate.
pub(crate) fn uncertified(error: &CertificateError) -> PyErr {
    match error {
        CertificateError::Gap { .. } => ProblemError::new_err(error.to_string()),
        _ => NotCertified::new_err(error.to_string()),
    }
}
