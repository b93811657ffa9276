//! `Curve`: a computed curve.

use core::ops::ControlFlow;
use std::sync::{
    Arc, OnceLock,
    atomic::{AtomicBool, Ordering},
};

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::{exceptions::PyTypeError, prelude::*};
use tautline::{certify, distance::Wanted};
use tautline_any::{self as value, Proofs};

use crate::{
    accuracy::accuracy,
    bounds::Bounds,
    certificate::Certificate,
    claims::Claims,
    error::{NotCertified, uncertified},
    estimate::Estimate,
    interruptible::interruptible,
};

/// Goes on until the flag is set.
pub(crate) fn unless(stopped: &AtomicBool) -> impl Fn(certify::Progress) -> bool + Sync {
    move |_| !stopped.load(Ordering::Relaxed)
}

fn flow(stopped: &AtomicBool) -> ControlFlow<()> {
    if stopped.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// A computed shortest curve: a local minimiser of the discrete energy, joined up linearly.
#[pyclass(frozen, module = "tautline_geodesics")]
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub(crate) curve: Arc<value::Curve>,
    /// The length of a shorter minimum, once it was looked for.
    shorter: Arc<OnceLock<Option<f64>>>,
    /// The doubts, once they were asked for.
    doubts: Arc<OnceLock<Vec<String>>>,
}

impl From<Arc<value::Curve>> for Curve {
    fn from(curve: Arc<value::Curve>) -> Self {
        Self { curve, shorter: Arc::default(), doubts: Arc::default() }
    }
}

#[pymethods]
impl Curve {
    /// The points from the first set to the second, an array of shape (n + 1, D).
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (points, dimension) = (self.curve.points(), self.curve.dimension());
        let rows = points.len() / dimension;
        points.into_pyarray(py).reshape([rows, dimension])
    }

    /// The point of the curve at t, clamped to [0, 1], an array of shape (D,).
    fn at<'py>(&self, py: Python<'py>, t: f64) -> Bound<'py, PyArray1<f64>> {
        self.curve.at(t).into_pyarray(py)
    }

    /// The energies of the local minima that were found on the coarsest grid, lowest first.
    #[getter]
    fn local_minima<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.curve.local_minima().into_pyarray(py)
    }

    /// The number of chords.
    #[getter]
    fn n(&self) -> usize {
        self.curve.points().len() / self.curve.dimension() - 1
    }

    /// The length of this curve: an upper bound on the distance. Its error is that of the quadrature along
    /// this curve, not how far the shortest curve is from it; see `extrapolated`.
    #[getter]
    fn length(&self) -> Estimate {
        self.curve.length().into()
    }

    /// The energy of this curve: an upper bound on the squared distance, up to the error of its quadrature.
    #[getter]
    fn energy(&self) -> Estimate {
        self.curve.energy().into()
    }

    /// The energy of the points by the rule, on either side of the squared distance.
    #[getter]
    fn discrete_energy(&self) -> f64 {
        self.curve.discrete_energy()
    }

    /// The distance by extrapolation over several grids: the best estimate, with an error that says how
    /// far the distance is from it. No bound. None if there is a single grid, or the curve is not
    /// converged and resolved.
    #[getter]
    fn extrapolated(&self) -> Option<Estimate> {
        self.curve.extrapolated().map(Estimate::from)
    }

    /// The speeds of the chords, an array of shape (n,).
    #[getter]
    fn speeds<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.curve.speeds().into_pyarray(py)
    }

    /// Whether the search converged to a strict local minimum, or the sets touch, up to rounding.
    #[getter]
    fn converged(&self) -> bool {
        self.curve.search().converged
    }

    /// Why the search stopped.
    #[getter]
    fn stop(&self) -> &'static str {
        self.curve.search().stop
    }

    /// The Hessian of the discrete energy at the result, in words.
    #[getter]
    fn hessian(&self) -> String {
        self.curve.search().hessian
    }

    /// The number of Newton steps of all searches together.
    #[getter]
    fn newton_steps(&self) -> usize {
        self.curve.search().newton_steps
    }

    /// The rule of numerical integration.
    #[getter]
    fn rule(&self) -> &'static str {
        self.curve.rule().name()
    }

    /// The residual of the discrete geodesic equation, relative to the momentum.
    #[getter]
    fn residual(&self) -> f64 {
        self.curve.search().residual
    }

    /// Whether the chords resolve the metric.
    #[getter]
    fn resolved(&self) -> bool {
        self.curve.is_resolved()
    }

    /// Whether the relative error of the length, as a distance, is at most `tolerance`, by extrapolation:
    /// an estimate, not a bound.
    fn is_within(&self, tolerance: f64) -> bool {
        self.curve.is_within(tolerance)
    }

    /// Other local minima that were met, shortest first.
    #[getter]
    fn other_minima(&self, py: Python<'_>) -> Vec<Curve> {
        py.detach(|| self.curve.other_minima()).into_iter().map(Curve::from).collect()
    }

    /// The length of another local minimum that was met and is shorter; None if there is none.
    #[getter]
    fn shorter_minimum(&self, py: Python<'_>) -> Option<f64> {
        py.detach(|| *self.shorter.get_or_init(|| self.curve.shorter_minimum()))
    }

    /// Why the curve may not be a shortest one, in words: it is not resolved, another minimum is shorter,
    /// the search did not converge, or a black box jumps. Empty if no reason is known.
    #[getter]
    fn doubts(&self, py: Python<'_>) -> Vec<String> {
        py.detach(|| self.doubts.get_or_init(|| self.curve.doubts()).clone())
    }

    /// Bounds on the distance by the theorems of the paper, from constants that are proved, or claimed:
    /// (c1, c2, L_H, M_H), where M_H may be None, or what `Metric.constants` returns.
    #[pyo3(signature = (*, claimed=None, tolerance=1e-3, boxes=None))]
    fn bounds(
        &self,
        py: Python<'_>,
        claimed: Option<Claims>,
        tolerance: f64,
        boxes: Option<usize>,
    ) -> PyResult<Bounds> {
        let claimed = claimed.map(|Claims(constants)| constants);
        let proofs = Proofs { claimed, tolerance: Some(accuracy(tolerance)?), boxes };
        let curve = Arc::clone(&self.curve);
        let found = interruptible(py, move |stopped| {
            curve.bounds(&proofs, &unless(stopped), &mut |_| flow(stopped))
        })?;
        found.map(Bounds::from).map_err(NotCertified::new_err)
    }

    /// Searches for a certificate of the distance with a gap of at most (upper - lower)/upper.
    #[pyo3(signature = (gap=1e-3, *, cubes=2_000_000))]
    fn certificate(&self, py: Python<'_>, gap: f64, cubes: usize) -> PyResult<Certificate> {
        let curve = Arc::clone(&self.curve);
        let found = interruptible(py, move |stopped| {
            curve.certificate(Wanted { gap, cubes }, &mut |_| flow(stopped))
        })?;
        found.map(Certificate::from).map_err(|error| uncertified(&error))
    }

    /// A curve does not change, so that it is its own copy.
    fn __copy__(slf: Bound<'_, Self>) -> Bound<'_, Self> {
        slf
    }

    /// A curve does not change, so that it is its own copy.
    #[pyo3(signature = (memo, /))]
    fn __deepcopy__<'py>(slf: Bound<'py, Self>, memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        let _ = memo;
        slf
    }

    /// A curve holds the programs of its metric, which stay in their process.
    fn __reduce__(&self) -> PyResult<()> {
        Err(PyTypeError::new_err(
            "a curve cannot be sent to another process: return what you need of it, such as \
             `curve.points`, `float(curve.length)` or `curve.certificate()`",
        ))
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let (length, stop) = (self.curve.length().value, self.curve.search().stop);
        let doubts: String = self.doubts(py).iter().map(|doubt| format!(", {doubt}")).collect();
        format!("<tautline.Curve of length {length:?}, n = {}, {stop}{doubts}>", self.n())
    }
}
