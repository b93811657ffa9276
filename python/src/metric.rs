//! `Program`: a metric as a recorded formula.

use std::{collections::HashMap, sync::Arc};

use numpy::{
    IntoPyArray, PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use rayon::prelude::*;
use tautline::{Point, Rule, Scope, SetError, Table};
use tautline_any::{
    self as value, Found, Given, Grid, IF_IT_SETTLES, Nodes, Proofs, Request, Shape,
};

use crate::{
    accuracy::accuracy,
    black_box::Callback,
    bounds::Constant,
    curve::{Curve, unless},
    error::{NotCertified, ProblemError, SignError, raised},
    interruptible::interruptible,
    pool::{self, pool},
    set::Set,
    sign::Sign,
    table::{Spline, called},
    text::message,
};

/// A metric on R^dimension as a recorded formula, compiled to programs once.
#[pyclass(frozen, module = "tautline_geodesics")]
#[derive(Clone)]
pub(crate) struct Program {
    pub(crate) given: Given,
    /// What the metric calls, if it is a black box.
    callback: Option<Arc<Callback>>,
    /// What must be positive, if it is a cost or a speed.
    pub(crate) sign: Option<Sign>,
}

/// How problems are to be solved, as a dictionary with these keys.
#[derive(Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Options {
    n: usize,
    /// In place of n.
    tolerance: Option<f64>,
    rule: String,
    starts: Vec<Vec<Vec<f64>>>,
    only_these_starts: bool,
    scope: String,
    /// The first node, the corner at which the nodes end, and their spacing.
    lattice: Option<(Vec<f64>, Vec<f64>, Vec<f64>)>,
    /// The most homotopy classes of paths along it.
    classes: usize,
    steps: Option<usize>,
    threads: Option<usize>,
}

/// The number of problems that are solved before Ctrl-C is looked for.
const BLOCK: usize = 4096;

#[pymethods]
impl Program {
    #[new]
    #[pyo3(signature = (text, dimension, parameters=None, tables=None, skipped=0, sign=None))]
    fn new(
        text: &str,
        dimension: usize,
        parameters: Option<HashMap<String, f64>>,
        tables: Option<HashMap<String, Spline>>,
        skipped: usize,
        sign: Option<(String, String)>,
    ) -> PyResult<Self> {
        let mut parameters: Vec<(String, f64)> =
            parameters.unwrap_or_default().into_iter().collect();
        parameters.sort_by(|a, b| a.0.cmp(&b.0));
        let parameters: Vec<(&str, f64)> =
            parameters.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let mut tables: Vec<(String, Spline)> = tables.unwrap_or_default().into_iter().collect();
        tables.sort_by(|a, b| a.0.cmp(&b.0));
        let tables: Vec<(&str, Arc<dyn Table>)> = tables
            .iter()
            .map(|(name, table)| (name.as_str(), table.table()))
            .collect();
        let given = Given::parse(text, dimension, &parameters, &tables);
        let given = given.map_err(|error| ProblemError::new_err(message(&error, text, skipped)))?;
        let sign = sign.map(|(name, text)| {
            let phi = Given::parse(&text, dimension, &parameters, &tables);
            let phi = phi.map_err(|error| ProblemError::new_err(message(&error, &text, 0)))?;
            Ok::<_, PyErr>(Sign::of(name, phi))
        });
        Ok(Self { given, callback: None, sign: sign.transpose()?.flatten() })
    }

    /// A metric by functions of an array of points of shape (m, D): H of shape (m, D, D), and
    /// optionally its derivatives, or those along vectors, an array of shape (m, D).
    #[staticmethod]
    fn black_box(
        dimension: usize,
        gram: Py<PyAny>,
        derivatives: [Option<Py<PyAny>>; 4],
        step: f64,
    ) -> PyResult<Self> {
        let [first, second, first_along, second_along] = derivatives;
        let along = [first_along, second_along];
        let callback = Arc::new(Callback::new(dimension, [Some(gram), first, second], along));
        let given = Given::black_box(callback.clone(), dimension, step);
        Ok(Self {
            given: given.map_err(|error| raised(&error))?,
            callback: Some(callback),
            sign: None,
        })
    }

    /// The dimension D.
    #[getter]
    fn dimension(&self) -> usize {
        self.given.dimension()
    }

    /// The goal with those of its translates by multiples of the period that come near to the start.
    fn periodic(&self, start: &Set, goal: &Set, period: Vec<f64>) -> PyResult<Set> {
        let pieces = self.given.periodic([&start.pieces, &goal.pieces], &period);
        Ok(Set { pieces: pieces.map_err(|error| ProblemError::new_err(error.to_string()))? })
    }

    /// The tables that the text calls table1, table2, ….
    #[getter]
    fn tables(&self) -> PyResult<Vec<Spline>> {
        called(&self.given)
    }

    /// The steps of the formula. Two metrics are the same program if these texts and their tables are
    /// equal. None for a black box.
    #[getter]
    fn text(&self) -> Option<String> {
        self.given.text()
    }

    /// H at the rows of an array of shape (m, D), an array of shape (m, D, D).
    fn gram<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let [m, d] = [x.shape()[0], x.shape()[1]];
        let mut entries = Vec::with_capacity(m * d * d);
        for row in x.as_array().rows() {
            let point = row.to_vec();
            let h = self.given.gram(&point).map_err(|error| raised(&error))?;
            self.unless_raised()?;
            // Given column by column.
            entries.extend((0..d * d).map(|n| h[n % d * d + n / d]));
        }
        entries.into_pyarray(py).reshape([m, d, d])
    }

    /// The constants c1, c2, L_H and M_H within a ball or a box, or on all of space; and where they
    /// hold.
    fn constants(
        &self,
        py: Python<'_>,
        within: Option<Set>,
        tolerance: f64,
        boxes: Option<usize>,
    ) -> PyResult<(Vec<Constant>, String)> {
        if within.as_ref().is_some_and(|set| set.pieces.len() != 1) {
            return Err(ProblemError::new_err("constants hold in a ball or a box, not in a union"));
        }
        let proofs = Proofs { claimed: None, tolerance: Some(accuracy(tolerance)?), boxes };
        let given = self.given.clone();
        let found = interruptible(py, move |stopped| {
            let within = within.as_ref().and_then(|set| set.pieces.first());
            given.constants(within, &proofs, &unless(stopped))
        })?;
        let found = found.map_err(|error| raised(&error))?;
        if found.if_it_settles {
            let why = format!(
                "no constants on all of space: they hold only {IF_IT_SETTLES}, which \
                               nothing proves; name a ball or a box within which they hold"
            );
            return Err(NotCertified::new_err(why));
        }
        Ok((found.constants.into_iter().map(Constant::from).collect(), found.region))
    }

    fn solve(&self, py: Python<'_>, start: &Set, goal: &Set, options: Options) -> PyResult<Curve> {
        let request = self.request(options)?;
        let found = if self.callback.is_some() {
            // Its functions run in the thread that calls, and look for Ctrl-C.
            py.detach(|| self.given.solve([&start.pieces, &goal.pieces], &request))
        } else {
            let (given, start, goal) = (self.given.clone(), start.clone(), goal.clone());
            let request = request.clone();
            interruptible(py, move |stopped| {
                given.solve_until(stopped, [&start.pieces, &goal.pieces], &request)
            })?
        };
        self.unless_raised()?;
        let curve = found.map_err(|error| raised(&error))?;
        let Some(wrong) = self.wrong_sign(&curve) else { return Ok(curve.into()) };
        let ends: [&[Shape]; 2] = [&start.pieces, &goal.pieces];
        let positive = py.detach(|| self.where_positive(ends, &request));
        positive.map_or_else(|| Err(SignError::new_err(wrong)), |curve| Ok(curve.into()))
    }

    /// Curves between the rows of two arrays of shape (m, D), as (curves, messages): a curve or None,
    /// and None or why there is no curve.
    #[expect(clippy::type_complexity, reason = "a pair of lists")]
    fn solve_batch(
        &self,
        py: Python<'_>,
        starts: PyReadonlyArray2<'_, f64>,
        goals: PyReadonlyArray2<'_, f64>,
        options: Options,
    ) -> PyResult<(Vec<Option<Curve>>, Vec<Option<String>>)> {
        if starts.shape() != goals.shape() {
            let message = format!(
                "starts have the shape {:?}, and goals {:?}",
                starts.shape(),
                goals.shape()
            );
            return Err(ProblemError::new_err(message));
        }
        let rows = |array: &PyReadonlyArray2<'_, f64>| -> Vec<Result<[Shape; 1], SetError>> {
            let row = |row: numpy::ndarray::ArrayView1<'_, f64>| {
                Ok([Shape::Point(Point::from_slice(&row.to_vec())?)])
            };
            array.as_array().rows().into_iter().map(row).collect()
        };
        let (starts, goals) = (rows(&starts), rows(&goals));
        let threads = options.threads;
        let request = self.request(options)?;
        // A row that is no point does not affect the others.
        let refused = |error: &SetError| error.to_string();
        let pairs = starts.iter().zip(&goals).map(|(start, goal)| {
            let (start, goal) = (start.as_ref().map_err(refused)?, goal.as_ref().map_err(refused)?);
            Ok([&start[..], &goal[..]])
        });
        let ends: Vec<Result<[&[Shape]; 2], String>> = pairs.collect();
        let pool = threads.map_or_else(|| pool(py), pool::threads)?;
        let mut found = Vec::with_capacity(ends.len());
        for block in ends.chunks(BLOCK) {
            let solved = || {
                let points: Vec<_> = block.iter().filter_map(|ends| ends.clone().ok()).collect();
                let curves = self.given.solve_all(&points, &request).into_par_iter();
                let checked = |(curve, &ends)| self.checked(curve, ends, &request);
                curves.zip(&points).map(checked).collect::<Vec<_>>()
            };
            let mut solved = py.detach(|| pool.install(solved)).into_iter();
            let curve = |ends: &Result<_, String>| match ends {
                Ok(_) => solved.next(),
                Err(wrong) => Some(Err(wrong.clone())),
            };
            found.extend(block.iter().filter_map(curve));
            self.unless_raised()?;
            py.check_signals()?;
        }
        let messages = found.iter().map(|found| found.as_ref().err().cloned()).collect();
        Ok((found.into_iter().map(|found| found.ok().map(Curve::from)).collect(), messages))
    }

    /// The lengths of curves, NaN where there is none, and how many of the curves are doubtful: not
    /// resolved, not converged, or longer than another minimum that was met.
    fn lengths<'py>(
        &self,
        py: Python<'py>,
        curves: Vec<Option<Py<Curve>>>,
        threads: Option<usize>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, usize)> {
        let curves: Vec<Option<Curve>> =
            curves.iter().map(|curve| Some(curve.as_ref()?.get().clone())).collect();
        let length = |curve: &Option<Curve>| {
            let Some(Curve { curve, .. }) = curve else { return (f64::NAN, false) };
            (curve.length().value, !curve.doubts().is_empty())
        };
        let pool = threads.map_or_else(|| pool(py), pool::threads)?;
        let found: Vec<(f64, bool)> =
            py.detach(|| pool.install(|| curves.par_iter().map(length).collect()));
        self.unless_raised()?;
        let doubtful = found.iter().filter(|(_, is_doubtful)| *is_doubtful).count();
        let lengths: Vec<f64> = found.into_iter().map(|(length, _)| length).collect();
        Ok((lengths.into_pyarray(py), doubtful))
    }

    fn __repr__(&self) -> String {
        format!("<tautline.Program in {} dimensions>", self.given.dimension())
    }
}

impl Program {
    /// Raises the exception of the functions of a black box.
    fn unless_raised(&self) -> PyResult<()> {
        self.callback.as_ref().and_then(|callback| callback.raised()).map_or(Ok(()), Err)
    }

    /// Says that the cost or the speed is negative on a curve.
    fn wrong_sign(&self, curve: &value::Curve) -> Option<String> {
        self.sign.as_ref().and_then(|sign| sign.wrong(curve).ok()?)
    }

    /// Returns a curve between two sets on which the cost or the speed is positive: a search that refuses
    /// steps to where it is not.
    fn where_positive(&self, ends: [&[Shape]; 2], request: &Request) -> Option<Arc<value::Curve>> {
        let positive = self.given.where_positive(&[&self.sign.as_ref()?.phi])?;
        let curve = positive.solve(ends, request).ok()?;
        self.wrong_sign(&curve).is_none().then_some(curve)
    }

    /// Returns a curve between two sets, or why there is none.
    fn checked(
        &self,
        found: Found,
        ends: [&[Shape]; 2],
        request: &Request,
    ) -> Result<Arc<value::Curve>, String> {
        let curve = found.map_err(|error| error.to_string())?;
        match self.wrong_sign(&curve) {
            None => Ok(curve),
            Some(wrong) => self.where_positive(ends, request).ok_or(wrong),
        }
    }

    fn request(&self, options: Options) -> PyResult<Request> {
        let Options {
            n,
            tolerance,
            rule,
            starts,
            only_these_starts,
            scope,
            lattice,
            classes,
            steps,
            threads,
        } = options;
        let grid = tolerance.map_or(Grid::Chords(n), Grid::Tolerance);
        let nodes = |(lower, upper, spacing)| Nodes { lower, upper, spacing, classes };
        let lattice = lattice.map(nodes);
        let Some(rule) = Rule::named(&rule) else {
            let names = Rule::NAMES.map(|name| format!("'{name}'")).join(", ");
            let message = format!("{rule:?} is no rule; the rules are {names}");
            return Err(ProblemError::new_err(message));
        };
        let Some(scope) = Scope::named(&scope) else {
            let names = Scope::NAMES.map(|name| format!("'{name}'")).join(", ");
            let message = format!("{scope:?} is no scope; the scopes are {names}");
            return Err(ProblemError::new_err(message));
        };
        let default = Request::default();
        // Python runs one thread at a time.
        let own = if self.callback.is_some() { 1 } else { default.threads };
        let (steps, threads) = (steps.unwrap_or(default.steps), threads.unwrap_or(own));
        Ok(Request { rule, grid, starts, only_these_starts, scope, lattice, steps, threads })
    }
}
