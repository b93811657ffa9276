//! `Certificate` and `Verdict`: proved bounds on a distance.

use std::path::PathBuf;

use pyo3::{prelude::*, types::PyType};
use tautline::check::AnyCertificate;
use tautline_problem::CertifiedAnswer;

use crate::{error::NotCertified, pool::pool};

/// Proved bounds on the distance. No curve between the sets is shorter than lower.
#[pyclass(frozen, get_all, eq, module = "tautline_geodesics")]
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Certificate {
    /// No curve between the sets is shorter.
    lower: f64,
    /// The proved length of a curve between the sets.
    upper: f64,
    /// (upper - lower)/upper.
    gap: f64,
    /// Whether the gap is as small as wanted.
    reached: bool,
    /// Why the search ended.
    ended: String,
    /// The number of cubes that hold every shortest curve, and their side.
    corridor: (usize, f64),
    /// The certificate, which `check` and `tautline check` read; empty if the sets touch, up to rounding.
    text: String,
}

impl From<CertifiedAnswer> for Certificate {
    fn from(answer: CertifiedAnswer) -> Self {
        Self {
            lower: answer.lower.value,
            upper: answer.upper.value,
            gap: answer.gap.value,
            reached: answer.reached,
            ended: answer.ended.to_owned(),
            corridor: (answer.corridor_cubes, answer.corridor_side.value),
            text: answer.certificate,
        }
    }
}

#[pymethods]
impl Certificate {
    #[new]
    #[pyo3(signature = (lower, upper, gap, reached, ended, corridor, text))]
    fn new(
        lower: f64,
        upper: f64,
        gap: f64,
        reached: bool,
        ended: String,
        corridor: (usize, f64),
        text: String,
    ) -> Self {
        Self { lower, upper, gap, reached, ended, corridor, text }
    }

    /// Another process makes it again from its attributes.
    #[expect(clippy::type_complexity, reason = "the attributes in their order")]
    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> (Bound<'py, PyType>, (f64, f64, f64, bool, String, (usize, f64), String)) {
        let Self { lower, upper, gap, reached, ended, corridor, text } = slf.get().clone();
        (slf.get_type(), (lower, upper, gap, reached, ended, corridor, text))
    }

    /// Writes the certificate to a file, which appears once it is complete.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let path = py.import("pathlib")?.call_method1("Path", (path,))?;
        py.import("tautline_geodesics._draft")?.call_method1("write", (path, &self.text))?;
        Ok(())
    }

    fn __repr__(&self) -> String {
        let Self { lower, upper, gap, ended, .. } = self;
        let reached =
            if self.reached { "reached".to_owned() } else { format!("not reached: {ended}") };
        format!(
            "<tautline.Certificate: the distance is between {lower:?} and {upper:?}, \
             gap {gap:.1e}, {reached}>"
        )
    }
}

/// What a certificate proves.
#[pyclass(frozen, get_all, eq, module = "tautline_geodesics")]
#[derive(Clone, Debug, PartialEq)]
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
    #[new]
    #[pyo3(signature = (statement, lower, upper, declared))]
    fn new(statement: String, lower: f64, upper: Option<f64>, declared: Option<f64>) -> Self {
        Self { statement, lower, upper, declared }
    }

    /// Another process makes it again from its attributes.
    #[expect(clippy::type_complexity, reason = "the attributes in their order")]
    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> (Bound<'py, PyType>, (String, f64, Option<f64>, Option<f64>)) {
        let Self { statement, lower, upper, declared } = slf.get().clone();
        (slf.get_type(), (statement, lower, upper, declared))
    }

    fn __repr__(&self) -> String {
        let upper = self.upper.map_or("None".to_owned(), |upper| format!("{upper:?}"));
        format!("<tautline.Verdict: lower = {:?}, upper = {upper}>", self.lower)
    }
}

/// Proves the two numbers of a certificate again. Trusts none in the text.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, text: &str) -> PyResult<Verdict> {
    let pool = pool(py)?;
    let checked =
        py.detach(|| pool.install(|| AnyCertificate::read(text).and_then(|read| read.check())));
    let verdict = checked.map_err(|error| NotCertified::new_err(format!("refused: {error}")))?;
    let (statement, lower) = (verdict.statement, verdict.lower);
    Ok(Verdict { statement, lower, upper: verdict.upper, declared: verdict.declared })
}
