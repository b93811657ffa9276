//! `Bounds` and `Constants`: what is proved of a distance and of a metric.

use pyo3::prelude::*;
use tautline_problem::{self as problem, BallAnswer, ConstantAnswer, GlobalMinimum, UsedConstants};

/// Bounds on the distance.
#[pyclass(frozen, get_all, module = "tautline")]
#[derive(Debug)]
pub(crate) struct Bounds {
    /// The lower bound.
    lower: f64,
    /// The upper bound.
    upper: f64,
    /// What the lower bound assumes of the curve: "proved" to be a global minimum, "assumed" to be
    /// one, "not needed", or "refuted", where the lower bound does without.
    global_minimum: &'static str,
    /// The statement that gives the lower bound.
    lower_by: String,
    /// What the upper bound is.
    upper_by: String,
    /// The constants c1, c2, L_H and M_H that were used; M_H may be None.
    constants: (f64, f64, f64, Option<f64>),
    /// Whether the constants are proved from the formula, or claimed.
    constants_proved: bool,
    /// The centre and the radius of the ball in which they hold; None if that is all of space.
    within: Option<(Vec<f64>, f64)>,
}

impl From<problem::Bounds> for Bounds {
    fn from(bounds: problem::Bounds) -> Self {
        let UsedConstants { c1, c2, l_h, m_h, proved, within } = bounds.constants;
        Self {
            lower: bounds.lower.value,
            upper: bounds.upper.value,
            global_minimum: match bounds.global_minimum {
                GlobalMinimum::Proved => "proved",
                GlobalMinimum::NotNeeded => "not needed",
                GlobalMinimum::Assumed => "assumed",
                GlobalMinimum::Refuted => "refuted",
            },
            lower_by: bounds.lower_by,
            upper_by: bounds.upper_by,
            constants: (c1, c2, l_h, m_h),
            constants_proved: proved,
            within: within.map(|BallAnswer { centre, radius }| (centre, radius)),
        }
    }
}

#[pymethods]
impl Bounds {
    fn __repr__(&self) -> String {
        let Self { lower, upper, global_minimum, .. } = self;
        format!("<tautline.Bounds: {lower:?} to {upper:?}, global minimum {global_minimum}>")
    }
}

/// A constant of a metric: bounds on its best value.
#[pyclass(frozen, get_all, module = "tautline")]
#[derive(Debug)]
pub(crate) struct Constant {
    /// c1, c2, L_H or M_H.
    name: String,
    /// What it bounds.
    bounds: &'static str,
    /// Whether the two numbers are within the wanted accuracy.
    proved: bool,
    /// A proved lower bound on the best constant; None if there is none.
    lower: Option<f64>,
    /// A proved upper bound on the best constant; None if there is none.
    upper: Option<f64>,
    /// A point where it is nearly attained; None if there is none.
    at: Option<Vec<f64>>,
    /// Why it is not proved; None if it is.
    reason: Option<String>,
}

impl From<ConstantAnswer> for Constant {
    fn from(constant: ConstantAnswer) -> Self {
        let ConstantAnswer { name, bounds, proved, lower, upper, at, reason } = constant;
        let [lower, upper] = [lower, upper].map(|bound| bound.map(|bound| bound.value));
        Self { name, bounds, proved, lower, upper, at, reason }
    }
}

#[pymethods]
impl Constant {
    fn __repr__(&self) -> String {
        let shown = |bound: Option<f64>| bound.map_or("unknown".to_owned(), |x| format!("{x:?}"));
        let (lower, upper) = (shown(self.lower), shown(self.upper));
        format!("<tautline.Constant {}: {lower} to {upper}>", self.name)
    }
}
