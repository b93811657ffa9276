//! The table of a plan: its head with the sweep file, and a row for each problem.

use std::{fmt::Write, ops::Range};

use super::{Plan, PlanError, hash::DIGITS, line_ends::without_mark};
use crate::{Open, no_file};

/// How the table begins.
const TITLE: &str = "# tautline plan 1";
const HASH: &str = "# hash ";
const COUNT: &str = "# problems ";
/// Before each line of the sweep file.
const FILE: &str = "#|";

impl Plan {
    /// Reads a sweep file, or the table of a plan with all its rows. No tables of numbers are read from
    /// other files.
    ///
    /// # Errors
    ///
    /// [`PlanError`].
    pub fn of_text(text: &str) -> Result<Self, PlanError> {
        Self::of_text_with(text, &mut no_file)
    }

    /// Reads a sweep file, or the table of a plan with all its rows. `open` returns the bytes of a file
    /// with numbers, or why it cannot be read.
    ///
    /// # Errors
    ///
    /// [`PlanError`].
    pub fn of_text_with(text: &str, open: &mut Open<'_>) -> Result<Self, PlanError> {
        if !TableHead::begins(text) {
            return Self::read_with(text, open);
        }
        let (mut head, mut lines) = (TableHead::default(), text.lines());
        let plan = loop {
            if let Some(plan) = head.line(lines.next().unwrap_or_default(), open)? {
                break plan;
            }
        };
        (0..=plan.count()).try_for_each(|id| plan.check_line(id, lines.next()))?;
        Ok(plan)
    }

    /// Returns the head of the table: comments with the hash and the sweep file, and the names of the
    /// columns.
    #[must_use]
    pub fn head(&self) -> String {
        let mut head = format!("{TITLE}\n{HASH}{}\n{COUNT}{}\n", self.hash(), self.count());
        for line in self.file().split('\n') {
            let blank = if line.is_empty() { "" } else { " " };
            // Writing to a string does not fail.
            let _ = writeln!(head, "{FILE}{blank}{line}");
        }
        head + &self.columns() + "\n"
    }

    /// Returns the names of the columns.
    pub(crate) fn columns(&self) -> String {
        ["id"]
            .into_iter()
            .chain(self.names().iter().map(String::as_str))
            .collect::<Vec<_>>()
            .join(",")
    }

    /// Returns the row of a problem: its id and its parameters, without a line break. Each number is the
    /// shortest decimal that is read as this number.
    #[must_use]
    pub fn line(&self, id: u64) -> String {
        let mut line = id.to_string();
        for value in self.row(id) {
            // Writing to a string does not fail.
            let _ = write!(line, ",{value:?}");
        }
        line
    }

    /// Returns the rows of a block of problems, each with a line break.
    ///
    /// # Errors
    ///
    /// [`PlanError::Ids`].
    pub fn lines(&self, ids: Range<u64>) -> Result<String, PlanError> {
        self.check(&ids)?;
        Ok(ids.map(|id| self.line(id) + "\n").collect())
    }

    /// Compares the row of a table with that of the plan. `None` stands for the end of the table, which
    /// is right after the last problem.
    ///
    /// # Errors
    ///
    /// [`PlanError::Line`].
    pub fn check_line(&self, id: u64, found: Option<&str>) -> Result<(), PlanError> {
        let expected = (id < self.count()).then(|| self.line(id));
        if expected.as_deref() == found {
            return Ok(());
        }
        let (found, expected) =
            (found.unwrap_or_default().to_owned(), expected.unwrap_or_default());
        Err(PlanError::Line { what: format!("the row of problem {id}"), found, expected })
    }
}

/// The head of a table, read line by line.
#[derive(Clone, Debug, Default)]
pub struct TableHead {
    /// The number of lines so far.
    lines: usize,
    hash: String,
    count: String,
    file: Vec<String>,
}

impl TableHead {
    /// Returns whether a text begins as the table of a plan does.
    #[must_use]
    pub fn begins(text: &str) -> bool {
        without_mark(text).lines().next() == Some(TITLE)
    }

    /// Takes the next line, without its line break. Returns the plan once the head is complete; the
    /// lines that follow are the rows. `open` returns the bytes of a file with numbers, or why it cannot
    /// be read.
    ///
    /// # Errors
    ///
    /// [`PlanError`] if this is no plan, or the head was changed.
    pub fn line(&mut self, line: &str, open: &mut Open<'_>) -> Result<Option<Plan>, PlanError> {
        self.lines += 1;
        let number = self.lines;
        let expected =
            |expected: &str| PlanError::NoPlan { line: number, expected: expected.to_owned() };
        let after = |begin: &str| line.strip_prefix(begin).ok_or_else(|| expected(begin));
        match number {
            1 if without_mark(line) == TITLE => return Ok(None),
            1 => return Err(expected(TITLE)),
            2 => self.hash = after(HASH)?.to_owned(),
            3 => self.count = after(COUNT)?.to_owned(),
            _ if line.starts_with(FILE) => {
                let rest = after(FILE)?;
                self.file.push(rest.strip_prefix(' ').unwrap_or(rest).to_owned());
            }
            _ => return self.plan(line, open).map(Some),
        }
        Ok(None)
    }

    /// Returns the plan, if the head is as the plan would write it.
    fn plan(&self, columns: &str, open: &mut Open<'_>) -> Result<Plan, PlanError> {
        if self.hash.len() != DIGITS {
            let expected = format!("{HASH}and {DIGITS} digits");
            return Err(PlanError::NoPlan { line: 2, expected });
        }
        let plan = Plan::read_with(&self.file.join("\n"), open)?;
        if self.hash != plan.hash() {
            let (written, computed) = (self.hash.clone(), plan.hash().to_owned());
            return Err(PlanError::Hash { written, computed });
        }
        let count = plan.count().to_string();
        for (what, found, expected) in [
            ("the number of problems", self.count.as_str(), count),
            ("the line of the columns", columns, plan.columns()),
        ] {
            if found != expected {
                let (what, found) = (what.to_owned(), found.to_owned());
                return Err(PlanError::Line { what, found, expected });
            }
        }
        Ok(plan)
    }
}
