//! `Bounds` and `Constants`: what is proved of a distance and of a metric.

use std::num::NonZeroUsize;

use crate::{claims::Claims, error::ProblemError};
use pyo3::{prelude::*, types::PyType};
use tautline::bounds::{self, Setting};

use tautline_problem::{self as problem, BallAnswer, ConstantAnswer, GlobalMinimum, UsedConstants};

/// c1, c2, L_H, and M_H or None.
pub(crate) type FourConstants = (f64, f64, f64, Option<f64>);

/// The bound of Theorem 1.1 on E - d² for the curve of a global minimiser of n chords, trapezoidal rule.
///
/// constants are c1, c2, L_H, and M_H or None, or what `Metric.constants` returns; d is the distance or an upper bound on it.
#[pyfunction]
#[pyo3(name = "theorem_1_1_excess")]
pub(crate) fn theorem_1_1(constants: Claims, d: f64, dimension: usize, n: usize) -> PyResult<f64> {
    theorem(constants, d, dimension, n, bounds::theorem_1_1_excess)
}

/// The bound of Theorem 1.3 on E - d² for the curve of a global minimiser of n chords, left-endpoint rule.
///
/// constants are c1, c2, L_H, and M_H or None, or what `Metric.constants` returns; d is the distance or an upper bound on it.
#[pyfunction]
#[pyo3(name = "theorem_1_3_excess")]
pub(crate) fn theorem_1_3(constants: Claims, d: f64, dimension: usize, n: usize) -> PyResult<f64> {
    theorem(constants, d, dimension, n, bounds::theorem_1_3_excess)
}

fn theorem(
    Claims(constants): Claims,
    d: f64,
    dimension: usize,
    n: usize,
    bound: fn(Setting, NonZeroUsize) -> f64,
) -> PyResult<f64> {
    let setting = Setting::new(constants, d, dimension);
    let setting = setting.map_err(|error| ProblemError::new_err(error.to_string()))?;
    let n = NonZeroUsize::new(n).ok_or_else(|| ProblemError::new_err("n = 0 chords"))?;
    Ok(bound(setting, n))
}

/// Bounds on the distance.
#[pyclass(frozen, get_all, eq, module = "tautline_geodesics")]
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bounds {
    /// The lower bound.
    lower: f64,
    /// The upper bound.
    upper: f64,
    /// What the lower bound assumes of the curve: "proved" to be a global minimum, "assumed" to be
    /// one, "not needed", as it holds for all curves, or "refuted", where the lower bound does without.
    global_minimum: String,
    /// The statement that gives the lower bound.
    lower_by: String,
    /// What the upper bound is.
    upper_by: String,
    /// The constants c1, c2, L_H and M_H that were used; M_H may be None. None if the lower bound is that of
    /// a certificate, because none were proved.
    constants: Option<FourConstants>,
    /// Whether the constants are proved from the formula, or claimed.
    constants_proved: bool,
    /// The centre and the radius of the ball in which they hold; None if that is all of space.
    within: Option<(Vec<f64>, f64)>,
}

impl From<problem::Bounds> for Bounds {
    fn from(bounds: problem::Bounds) -> Self {
        let used = bounds.constants;
        Self {
            lower: bounds.lower.value,
            upper: bounds.upper.value,
            global_minimum: match bounds.global_minimum {
                GlobalMinimum::Proved => "proved",
                GlobalMinimum::NotNeeded => "not needed",
                GlobalMinimum::Assumed => "assumed",
                GlobalMinimum::Refuted => "refuted",
            }
            .to_owned(),
            lower_by: bounds.lower_by,
            upper_by: bounds.upper_by,
            constants_proved: used.as_ref().is_some_and(|used| used.proved),
            constants: used
                .as_ref()
                .map(|&UsedConstants { c1, c2, l_h, m_h, .. }| (c1, c2, l_h, m_h)),
            within: used
                .and_then(|used| used.within)
                .map(|BallAnswer { centre, radius }| (centre, radius)),
        }
    }
}

/// What bounds are made of.
type BoundsParts =
    (f64, f64, String, String, String, Option<FourConstants>, bool, Option<(Vec<f64>, f64)>);

#[pymethods]
impl Bounds {
    #[new]
    #[expect(clippy::too_many_arguments, reason = "one for each attribute")]
    #[pyo3(signature = (
        lower, upper, global_minimum, lower_by, upper_by, constants, constants_proved, within
    ))]
    fn new(
        lower: f64,
        upper: f64,
        global_minimum: String,
        lower_by: String,
        upper_by: String,
        constants: Option<FourConstants>,
        constants_proved: bool,
        within: Option<(Vec<f64>, f64)>,
    ) -> Self {
        Self {
            lower,
            upper,
            global_minimum,
            lower_by,
            upper_by,
            constants,
            constants_proved,
            within,
        }
    }

    /// Another process makes them again from their attributes.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, BoundsParts) {
        let Self { lower, upper, constants, constants_proved, .. } = *slf.get();
        let Self { global_minimum, lower_by, upper_by, within, .. } = slf.get().clone();
        let parts =
            (lower, upper, global_minimum, lower_by, upper_by, constants, constants_proved, within);
        (slf.get_type(), parts)
    }

    fn __repr__(&self) -> String {
        let Self { lower, upper, global_minimum, .. } = self;
        format!("<tautline.Bounds: {lower:?} to {upper:?}, global minimum {global_minimum}>")
    }
}

/// A constant of a metric: bounds on its best value.
#[pyclass(frozen, get_all, eq, module = "tautline_geodesics")]
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Constant {
    /// c1, c2, L_H or M_H.
    name: String,
    /// What it bounds.
    bounds: String,
    /// Whether the two numbers are within the wanted accuracy.
    proved: bool,
    /// A proved lower bound on the best constant; None if there is none.
    pub(crate) lower: Option<f64>,
    /// A proved upper bound on the best constant; None if there is none.
    pub(crate) upper: Option<f64>,
    /// A point where it is nearly attained; None if there is none.
    at: Option<Vec<f64>>,
    /// Why it is not proved; None if it is.
    reason: Option<String>,
}

impl From<ConstantAnswer> for Constant {
    fn from(constant: ConstantAnswer) -> Self {
        let ConstantAnswer { name, bounds, proved, lower, upper, at, reason } = constant;
        let [lower, upper] = [lower, upper].map(|bound| bound.map(|bound| bound.value));
        Self { name, bounds: bounds.to_owned(), proved, lower, upper, at, reason }
    }
}

/// What a constant is made of.
type ConstantParts =
    (String, String, bool, Option<f64>, Option<f64>, Option<Vec<f64>>, Option<String>);

#[pymethods]
impl Constant {
    #[new]
    #[pyo3(signature = (name, bounds, proved, lower, upper, at, reason))]
    fn new(
        name: String,
        bounds: String,
        proved: bool,
        lower: Option<f64>,
        upper: Option<f64>,
        at: Option<Vec<f64>>,
        reason: Option<String>,
    ) -> Self {
        Self { name, bounds, proved, lower, upper, at, reason }
    }

    /// Another process makes it again from its attributes.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, ConstantParts) {
        let Self { name, bounds, proved, lower, upper, at, reason } = slf.get().clone();
        (slf.get_type(), (name, bounds, proved, lower, upper, at, reason))
    }

    fn __repr__(&self) -> String {
        let shown = |bound: Option<f64>| bound.map_or("unknown".to_owned(), |x| format!("{x:?}"));
        let (lower, upper) = (shown(self.lower), shown(self.upper));
        format!("<tautline.Constant {}: {lower} to {upper}>", self.name)
    }
}
