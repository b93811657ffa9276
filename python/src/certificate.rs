//! `Certificate` and `Verdict`: proved bounds on a distance.

use std::path::PathBuf;

use pyo3::prelude::*;
use tautline::check::AnyCertificate;
use tautline_problem::CertifiedAnswer;

use crate::error::NotCertified;

/// Proved bounds on the distance. No curve between the sets is shorter than lower.
#[pyclass(frozen, module = "tautline")]
#[derive(Debug)]
pub(crate) struct Certificate {
    answer: CertifiedAnswer,
}

impl From<CertifiedAnswer> for Certificate {
    fn from(answer: CertifiedAnswer) -> Self {
        Self { answer }
    }
}

#[pymethods]
impl Certificate {
    /// No curve between the sets is shorter.
    #[getter]
    fn lower(&self) -> f64 {
        self.answer.lower.value
    }

    /// The proved length of a curve between the sets.
    #[getter]
    fn upper(&self) -> f64 {
        self.answer.upper.value
    }

    /// (upper - lower)/upper.
    #[getter]
    fn gap(&self) -> f64 {
        self.answer.gap.value
    }

    /// Whether the gap is as small as wanted.
    #[getter]
    fn reached(&self) -> bool {
        self.answer.reached
    }

    /// Why the search ended.
    #[getter]
    fn ended(&self) -> &'static str {
        self.answer.ended
    }

    /// The number of cubes that hold every shortest curve, and their side.
    #[getter]
    fn corridor(&self) -> (usize, f64) {
        (self.answer.corridor_cubes, self.answer.corridor_side.value)
    }

    /// The certificate, which `check` and `tautline check` read; empty if the sets touch.
    #[getter]
    fn text(&self) -> &str {
        &self.answer.certificate
    }

    /// Writes the certificate to a file.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        Ok(std::fs::write(path, &self.answer.certificate)?)
    }

    fn __repr__(&self) -> String {
        format!(
            "<tautline.Certificate: the distance is between {:?} and {:?}>",
            self.lower(),
            self.upper()
        )
    }
}

/// What a certificate proves.
#[pyclass(frozen, get_all, module = "tautline")]
#[derive(Debug)]
pub(crate) struct Verdict {
    /// The metric and the sets, as the certificate states them.
    statement: String,
    /// No curve between the sets is shorter.
    lower: f64,
    /// The proved length of a curve between the sets; None without a curve.
    upper: Option<f64>,
    /// A constant c1 with H >= c1 I everywhere, if that is a hypothesis; None otherwise.
    declared: Option<f64>,
}

#[pymethods]
impl Verdict {
    fn __repr__(&self) -> String {
        format!("<tautline.Verdict: lower = {:?}, upper = {:?}>", self.lower, self.upper)
    }
}

/// Proves the two numbers of a certificate again. Trusts none in the text.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, text: &str) -> PyResult<Verdict> {
    let checked = py.detach(|| AnyCertificate::read(text).and_then(|read| read.check()));
    let verdict = checked.map_err(|error| NotCertified::new_err(format!("refused: {error}")))?;
    let (statement, lower) = (verdict.statement, verdict.lower);
    Ok(Verdict { statement, lower, upper: verdict.upper, declared: verdict.declared })
}
