//! `PlanFile`: a plan in a file, or the sweep file from which it follows.

use std::{
    fs::File,
    io::{self, BufRead, BufReader, Lines},
    ops::Range,
    path::{Path, PathBuf},
};

use tautline_problem::sweep::{Plan, PlanError, TableHead};

use crate::{
    error::CommandError,
    problem::{bad_file, open},
};

/// A plan, and the rows of its table, if it is a table.
pub(crate) struct PlanFile {
    name: String,
    pub(crate) plan: Plan,
    /// The file, and those of its tables.
    pub(crate) read: Vec<PathBuf>,
    rows: Option<Lines<BufReader<File>>>,
    /// The id of the next row.
    next: u64,
}

impl PlanFile {
    /// Opens a table of problems, or a sweep file.
    pub(crate) fn open(path: &Path) -> Result<Self, CommandError> {
        let name = path.display().to_string();
        let failed = |error| CommandError::File { path: path.to_owned(), error };
        let explain = |error| explained(&name, error);
        let mut lines = BufReader::new(File::open(path).map_err(failed)?).lines();
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut read = vec![path.to_owned()];
        let mut open = |file: &str| open(folder, file, &mut read);
        let (mut head, mut begin) = (TableHead::default(), String::new());
        loop {
            let line = lines.next().transpose().map_err(failed)?;
            if begin.is_empty() && !line.as_deref().is_some_and(TableHead::begins) {
                let file = io::read_to_string(File::open(path).map_err(failed)?).map_err(failed)?;
                let plan = Plan::read_with(&file, &mut open).map_err(explain)?;
                return Ok(Self { name, plan, read, rows: None, next: 0 });
            }
            let line = line.unwrap_or_default();
            if let Some(plan) = head.line(&line, &mut open).map_err(explain)? {
                return Ok(Self { name, plan, read, rows: Some(lines), next: 0 });
            }
            begin = line;
        }
    }

    /// Compares rows of the table with those of the plan. Ids may only grow from one call to the next.
    pub(crate) fn check(&mut self, ids: Range<u64>) -> Result<(), CommandError> {
        let Some(rows) = &mut self.rows else { return Ok(()) };
        let failed = |error| CommandError::File { path: self.name.clone().into(), error };
        // After the last problem the table ends.
        let last = if ids.end == self.plan.count() { Some(ids.end) } else { None };
        for id in ids.chain(last) {
            let skipped = usize::try_from(id - self.next).unwrap_or(usize::MAX);
            let row = rows.nth(skipped).transpose().map_err(failed)?;
            self.next = id + 1;
            let checked = self.plan.check_line(id, row.as_deref());
            checked.map_err(|error| explained(&self.name, error))?;
        }
        Ok(())
    }
}

/// Returns an error of a plan, with the lines of the sweep file if it is wrong.
pub(crate) fn explained(name: &str, error: PlanError) -> CommandError {
    match error {
        PlanError::File { diagnostic, file } => bad_file(name, &file, &diagnostic),
        error @ PlanError::Threads { .. } => CommandError::NotDone(error.to_string()),
        error => CommandError::BadArgument(format!("{name}: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use std::{fs, path::Path};

    use super::PlanFile;

    const SWEEP: &str = "\
[parameters]
a = 1
[metric]
phi = \"a\"
[from]
point = [0]
[to]
point = [1]
[sweep.vary]
a = [1, 2, 3, 4, 5, 6]
";

    /// Each block looks at its own rows, and the last one at the end of the table.
    #[test]
    fn rows_are_compared_wherever_a_block_begins() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("plan");
        let write = |text: &str| fs::write(&path, text).expect("written");
        let open = |path: &Path| PlanFile::open(path).expect("a plan");
        write(SWEEP);
        let plan = open(&path).plan;
        let rows = plan.lines(0..6).expect("rows");
        let table = plan.head() + &rows;
        let blocks = [&[0..2, 2..6][..], &[1..3, 4..6], &[0..0, 5..6], &[0..3, 3..6]];
        // A sweep file has no rows to compare.
        for blocks in blocks {
            let mut file = open(&path);
            assert!(blocks.iter().all(|ids| file.check(ids.clone()).is_ok()));
        }
        write(&table);
        for blocks in blocks {
            let mut file = open(&path);
            assert!(blocks.iter().all(|ids| file.check(ids.clone()).is_ok()), "{blocks:?}");
        }
        // Row 4 is another one: only a block that has it sees that.
        write(&table.replace("4,5.0", "4,5.5"));
        let some = [&[0..2, 2..4][..], &[1..3, 4..5], &[3..3, 5..6]];
        for (blocks, is_seen) in some.into_iter().zip([false, true, false]) {
            let mut file = open(&path);
            let is_right = blocks.iter().all(|ids| file.check(ids.clone()).is_ok());
            assert_eq!(is_right, !is_seen, "{blocks:?}");
        }
        // A row too many, and one that is missing.
        for wrong in [format!("{table}6,7.0\n"), table.replace("5,6.0\n", "")] {
            write(&wrong);
            assert!(open(&path).check(0..5).is_ok() && open(&path).check(5..6).is_err(), "{wrong}");
        }
    }
}
