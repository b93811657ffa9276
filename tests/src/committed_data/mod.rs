//! Checks what the project claims about the data in its repository, on the files themselves.
//!
//! The figures and tables drawn from these files therefore show what these tests have checked. Only
//! the checks that kill the mutants compute anything.

mod asymptotics;
mod certified_distances;
mod convergence;
mod corpus;
mod counterexample;
mod dimension;
mod losses;
mod methods;
mod mutants;
mod overestimation;
mod quantities;
mod rates;
mod sandwich;
mod speeds;
mod tightness;

use std::collections::HashMap;

/// A file of comma-separated values; lines at its top that begin with `#` are skipped.
struct Table {
    columns: HashMap<String, usize>,
    rows: Vec<csv::StringRecord>,
}

impl Table {
    fn read(path: &str) -> Self {
        let path = format!("{}/../paper/{path}", env!("CARGO_MANIFEST_DIR"));
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_path(&path)
            .unwrap_or_else(|error| panic!("{path}: {error}"));
        let header = reader.headers().expect("a header").clone();
        let columns = header.iter().enumerate().map(|(k, name)| (name.to_owned(), k)).collect();
        let rows = reader.records().map(|row| row.expect("as many cells as columns")).collect();
        Self { columns, rows }
    }

    fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|record| Row { table: self, record })
    }

    /// Returns the first row with these cells.
    #[track_caller]
    fn row(&self, cells: &[(&str, &str)]) -> Row<'_> {
        let mut found = self.rows().filter(|row| cells.iter().all(|(k, v)| row.text(k) == *v));
        found.next().unwrap_or_else(|| panic!("no row with {cells:?}"))
    }

    #[track_caller]
    fn assert_columns(&self, names: &str) {
        for name in names.split_whitespace() {
            assert!(self.columns.contains_key(name), "there is no column {name}");
        }
    }
}

#[derive(Clone, Copy)]
struct Row<'a> {
    table: &'a Table,
    record: &'a csv::StringRecord,
}

impl<'a> Row<'a> {
    fn text(&self, column: &str) -> &'a str {
        let index = self.table.columns.get(column);
        &self.record[*index.unwrap_or_else(|| panic!("there is no column {column}"))]
    }

    fn number(&self, column: &str) -> f64 {
        let text = self.text(column);
        text.parse().unwrap_or_else(|_| panic!("{text:?} in {column} is no number"))
    }

    fn n(&self) -> usize {
        self.text("n").parse().expect("N is a natural number")
    }
}
