//! `Golden`: reference values from another program, in a table stored next to the checks.

use super::{Outcome, all, close};

/// One row of a table, with the names of its columns.
pub(crate) struct Golden(Vec<(&'static str, f64)>);

impl Golden {
    /// Reads the row of a problem from a CSV table with a header line; lines that begin with `#`
    /// are comments.
    pub(crate) fn of(table: &'static str, problem: &str) -> Self {
        let mut lines = table.lines().filter(|line| !line.starts_with('#'));
        let head = lines.next().expect("a head").split(',');
        let row = lines.map(|line| line.split(',')).find(|row| row.clone().next() == Some(problem));
        let row = row.unwrap_or_else(|| panic!("the table has no problem {problem}"));
        let columns = head.zip(row).skip(1);
        Self(columns.map(|(name, text)| (name, text.parse().expect("a number"))).collect())
    }

    /// Returns the number in a column.
    pub(crate) fn get(&self, column: &str) -> f64 {
        let found = self.0.iter().find(|(name, _)| *name == column);
        found.unwrap_or_else(|| panic!("the table has no column {column}")).1
    }

    /// Compares computed numbers with the columns, to within a relative `tolerance`.
    pub(crate) fn agrees(&self, computed: &[(&str, f64)], tolerance: f64) -> Outcome {
        all(computed.iter().map(|&(column, value)| {
            let expected = self.get(column);
            close(column, value, expected, tolerance * expected)
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::Golden;

    const TABLE: &str = "# a comment, with a comma\nproblem,c1,d\nplane,1.0,5.0\nline,2.0,2.5e-1\n";

    #[test]
    fn a_row_is_found_by_its_problem_and_read_by_its_columns() {
        let line = Golden::of(TABLE, "line");
        assert_eq!([line.get("c1"), line.get("d")], [2.0, 0.25]);
        assert!(line.agrees(&[("c1", 2.0), ("d", 0.25 + 1e-13)], 1e-12).is_ok());
        assert!(line.agrees(&[("c1", 2.0), ("d", 0.26)], 1e-12).is_err());
    }
}
