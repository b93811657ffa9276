//! `Plan`: the problems of a sweep.

use std::ops::Range;

use super::{PlanError, draw::unit, hash::Hash, plain, result_row::COLUMNS};
use crate::{Axis, Diagnostic, Open, Question, Sweep, Values, no_file};

/// The largest number of problems: ids beyond it are not exact as floating-point numbers.
pub(crate) const MOST: u64 = 1 << 53;

/// What the hash of a plan begins with. Another rule for the rows needs another number.
const RULE: &str = "tautline plan 1\n";

/// The problems of a sweep, numbered by ids from 0: every combination of the values of its axes, of
/// which the last varies fastest, and then the draws.
#[derive(Clone, Debug)]
pub struct Plan {
    file: String,
    pub(crate) question: Question,
    sweep: Sweep,
    names: Vec<String>,
    count: u64,
    hash: String,
}

impl Plan {
    /// Reads a sweep file: a problem file with a section `[sweep]`, whose tables stand in it.
    ///
    /// # Errors
    ///
    /// [`PlanError`], with the place in the file if the file is wrong.
    pub fn read(file: &str) -> Result<Self, PlanError> {
        Self::read_with(file, &mut no_file)
    }

    /// Reads a sweep file: a problem file with a section `[sweep]`. `open` returns the bytes of a file
    /// with numbers, or why it cannot be read. They are part of the hash. Line ends are not: those of the
    /// plan are [`plain`].
    ///
    /// # Errors
    ///
    /// [`PlanError`], with the place in the file if the file is wrong.
    pub fn read_with(file: &str, open: &mut Open<'_>) -> Result<Self, PlanError> {
        let file = &*plain(file);
        let wrong = |diagnostic: Diagnostic| PlanError::File { diagnostic, file: file.to_owned() };
        let mut hash = Hash::default();
        hash.add(RULE);
        hash.add(file);
        let mut question = Question::read_with(file, &mut |name| {
            let bytes = open(name)?;
            // With its length, the end of one file is not taken for the beginning of the next.
            hash.add(&format!("\n{}\n", bytes.len()));
            hash.add_bytes(&bytes);
            Ok(bytes)
        })
        .map_err(wrong)?;
        question.without_bounds();
        let missing = || Diagnostic {
            message: "the file has no section [sweep]".to_owned(),
            at: file.len()..file.len(),
            label: String::new(),
            help: Some("a section such as [sweep.vary] with height = [1, 2, 4]".to_owned()),
        };
        let sweep = question.sweep().and_then(|sweep| sweep.ok_or_else(missing)).map_err(wrong)?;
        if !question.has_ends() {
            let message = "[from] and [to] are missing".to_owned();
            let at = file.len()..file.len();
            return Err(wrong(Diagnostic { message, at, label: String::new(), help: None }));
        }
        // An expression that is wrong is wrong in every problem.
        question.programs(None).map_err(wrong)?;
        let names: Vec<String> = sweep.axes.iter().flat_map(|axis| axis.names.clone()).collect();
        if let Some(name) = names.iter().find(|name| **name == "id" || COLUMNS.contains(&&***name))
        {
            return Err(PlanError::Name { name: name.clone() });
        }
        let sizes = sweep.axes.iter().map(size).chain([sweep.draws]);
        let count = sizes.fold(1_u128, |count, size| count.saturating_mul(u128::from(size)));
        let count = u64::try_from(count)
            .ok()
            .filter(|&it| it <= MOST)
            .ok_or(PlanError::TooMany { count })?;
        Ok(Self { file: file.to_owned(), question, sweep, names, count, hash: hash.digits() })
    }

    /// Returns the number of problems.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Returns the hash: SHA-256 of the rule by which problems follow from a file, of the file, and of the
    /// files with its tables.
    #[must_use]
    pub fn hash(&self) -> &str {
        &self.hash
    }

    /// Returns the text of the sweep file.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Returns the names of the parameters that vary, in the order of the columns.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Returns the values of the parameters of a problem, in the order of [`names`](Plan::names).
    #[must_use]
    pub fn row(&self, id: u64) -> Vec<f64> {
        let mut rest = id / self.sweep.draws;
        let mut columns = Vec::new();
        for (index, axis) in self.sweep.axes.iter().enumerate().rev() {
            let size = size(axis);
            columns.push(match &axis.values {
                Values::List(entries) => entries[(rest % size) as usize].clone(),
                Values::Grid { to, .. } if rest % size == size - 1 => vec![*to],
                Values::Grid { from, to, .. } => {
                    vec![from + (to - from) * ((rest % size) as f64 / (size - 1) as f64)]
                }
                Values::Uniform { least, most } => {
                    let u = unit(self.sweep.seed, index as u64, id);
                    // Rounding must not leave the interval.
                    vec![(least + (most - least) * u).min(*most)]
                }
            });
            rest /= size;
        }
        columns.into_iter().rev().flatten().collect()
    }

    /// Returns the parameters of a problem by their names.
    pub(crate) fn parameters(&self, id: u64) -> Vec<(&str, f64)> {
        self.names.iter().map(String::as_str).zip(self.row(id)).collect()
    }

    /// Returns the problem file of a problem: the sweep file with the values of the parameters, written
    /// so that they read back exactly.
    #[must_use]
    pub fn problem(&self, id: u64) -> String {
        self.question.file_with(&self.parameters(id))
    }

    /// Refuses ids without a problem.
    pub(crate) fn check(&self, ids: &Range<u64>) -> Result<(), PlanError> {
        let &Range { start, end } = ids;
        if start <= end && end <= self.count {
            return Ok(());
        }
        Err(PlanError::Ids { start, end, count: self.count })
    }
}

/// Returns the number of values of an axis in the product; random ones are drawn for each problem.
fn size(axis: &Axis) -> u64 {
    match &axis.values {
        Values::List(entries) => entries.len() as u64,
        Values::Grid { count, .. } => *count,
        Values::Uniform { .. } => 1,
    }
}
