//! `Plan`: the problems of a sweep, solved block by block. Files are written in Python.

use std::{fs, ops::Range, path::PathBuf};

use numpy::{IntoPyArray, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use tautline_problem::sweep::{
    self, Block, BlockError, BlockWriter, PlanError, Runner, Shard, plain,
};

use crate::error::ProblemError;

/// The problems of a sweep: those of a sweep file, or of the table of a plan.
#[pyclass(frozen, module = "tautline_geodesics.sweep")]
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    plan: sweep::Plan,
    folder: PathBuf,
}

fn raised(error: impl std::fmt::Display) -> PyErr {
    ProblemError::new_err(error.to_string())
}

/// Returns an error of a plan, with the lines of the sweep file if it is wrong.
fn explained(error: PlanError) -> PyErr {
    match error {
        PlanError::File { diagnostic, file } => {
            raised(diagnostic.render("the sweep file", &file, false))
        }
        error => raised(error),
    }
}

#[pymethods]
impl Plan {
    /// Files with tables of numbers are found from the folder. With a hash, they are refused if they are
    /// others than those of this hash.
    #[new]
    #[pyo3(signature = (text, folder = PathBuf::new(), hash = None))]
    fn new(text: &str, folder: PathBuf, hash: Option<&str>) -> PyResult<Self> {
        let mut open = |file: &str| fs::read(folder.join(file)).map_err(|error| error.to_string());
        let plan = sweep::Plan::of_text_with(text, &mut open).map_err(explained)?;
        if let Some(written) = hash.filter(|&hash| hash != plan.hash()) {
            let (written, computed) = (written.to_owned(), plan.hash().to_owned());
            return Err(explained(PlanError::Hash { written, computed }));
        }
        Ok(Self { plan, folder })
    }

    /// The text of the sweep file.
    #[getter]
    fn file(&self) -> &str {
        self.plan.file()
    }

    /// SHA-256 of the sweep file, of the files with its tables, and of the rule by which problems follow.
    #[getter]
    fn hash(&self) -> &str {
        self.plan.hash()
    }

    /// The names of the parameters that vary.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.plan.names().to_vec()
    }

    /// The table of the plan as CSV; its head is the sweep file.
    #[getter]
    fn table(&self) -> PyResult<String> {
        let rows = self.plan.lines(0..self.plan.count()).map_err(raised)?;
        Ok(self.plan.head() + &rows)
    }

    /// The number of problems.
    fn __len__(&self) -> usize {
        self.plan.count() as usize
    }

    /// A plan is sent to another process as its sweep file, with the folder of its tables.
    fn __getnewargs__(&self) -> (String, PathBuf, String) {
        (self.plan.file().to_owned(), self.folder.clone(), self.plan.hash().to_owned())
    }

    /// The parameters of the problems from start to below end, an array of shape (end - start, m).
    fn rows<'py>(
        &self,
        py: Python<'py>,
        start: u64,
        end: u64,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.check(start, end)?;
        let rows: Vec<f64> = (start..end).flat_map(|id| self.plan.row(id)).collect();
        let shape = [(end - start) as usize, self.plan.names().len()];
        rows.into_pyarray(py).reshape(shape)
    }

    /// The problem file of one problem.
    fn problem(&self, id: u64) -> PyResult<String> {
        self.check(id, id.saturating_add(1))?;
        Ok(self.plan.problem(id))
    }

    /// The results of the problems from start to below end, as CSV with a hash.
    #[pyo3(signature = (start, end, threads=1))]
    fn solved(&self, py: Python<'_>, start: u64, end: u64, threads: usize) -> PyResult<String> {
        py.detach(|| Runner::new(&self.plan, threads)?.solved(start..end)).map_err(explained)
    }

    /// The rows of the results of some problems, in any order.
    #[pyo3(signature = (ids, threads=1))]
    fn lines(&self, py: Python<'_>, ids: Vec<u64>, threads: usize) -> PyResult<Vec<String>> {
        let mut lines = Vec::new();
        py.detach(|| {
            let runner = Runner::new(&self.plan, threads)?;
            for ids in runs(&ids) {
                lines.extend(runner.rows(ids)?.text.lines().map(str::to_owned));
            }
            Ok(())
        })
        .map_err(explained)?;
        Ok(lines)
    }

    /// The results of all problems from their rows in the order of the ids, as CSV with a hash.
    fn results(&self, lines: Vec<String>) -> PyResult<String> {
        let begun = BlockWriter::of_plan(&self.plan, 0..self.plan.count());
        let (mut writer, mut text) = begun.map_err(explained)?;
        text += &writer.rows(lines.iter().map(|line| line.clone() + "\n").collect());
        text += &writer.end();
        // The ids are those of the plan.
        Block::read(&text).map_err(raised)?;
        Ok(text)
    }

    fn __repr__(&self) -> String {
        let (count, hash) = (self.plan.count(), &self.plan.hash()[..8]);
        format!("<tautline.sweep.Plan of {count} problems, {hash}>")
    }
}

impl Plan {
    fn check(&self, start: u64, end: u64) -> PyResult<()> {
        let count = self.plan.count();
        if start <= end && end <= count {
            return Ok(());
        }
        Err(explained(PlanError::Ids { start, end, count }))
    }
}

/// Returns the ids as ranges of consecutive ones.
fn runs(ids: &[u64]) -> Vec<Range<u64>> {
    let mut runs: Vec<Range<u64>> = Vec::new();
    for &id in ids {
        match runs.last_mut() {
            Some(run) if run.end == id => run.end += 1,
            _ => runs.push(id..id.saturating_add(1)),
        }
    }
    runs
}

/// The first id of the k-th of n blocks, from 1, the end of its ids, and the name of its file.
#[pyfunction]
pub(crate) fn shard(k: u64, n: u64, count: u64) -> PyResult<(u64, u64, String)> {
    let shard = Shard::new(k, n).map_err(raised)?;
    let ids = shard.ids(count);
    Ok((ids.start, ids.end, shard.file_name()))
}

/// Whether a text has the results of these problems, complete and as they were written. Raises
/// ProblemError if it has other ones, or is something else.
#[pyfunction]
pub(crate) fn is_finished(plan: &Plan, results: &str, start: u64, end: u64) -> PyResult<bool> {
    match Block::read(&plain(results)) {
        Ok(block) if plan.plan.has(&block.head, start..end) => Ok(true),
        Ok(_) => Err(raised("the results are of another plan, of other ids or another version")),
        Err(error @ BlockError::NoResults { .. }) => Err(raised(error)),
        Err(_) => Ok(false),
    }
}

/// The results of all problems from those of blocks. Raises ProblemError with the ids that are missing or
/// doubled.
#[pyfunction]
pub(crate) fn merged(results: Vec<String>) -> PyResult<String> {
    let results: Vec<_> = results.iter().map(|text| plain(text)).collect();
    let blocks = results.iter().map(|text| Block::read(text)).collect::<Result<Vec<_>, _>>();
    sweep::merged(&blocks.map_err(raised)?).map_err(raised)
}
