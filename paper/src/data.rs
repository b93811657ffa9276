//! `Data`: the numbers behind a figure or table, as they are printed.

use crate::Failure;

/// How the cells of a column are compared with the committed ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// The texts must be equal.
    Exact,
    /// `|a − b| ≤ relative · |b| + absolute`. Machines differ in the last bits of elementary
    /// functions, and in what the formulas make of these bits.
    Close {
        /// The relative part.
        relative: f64,
        /// The absolute part, in the unit of the column.
        absolute: f64,
    },
    /// Both numbers are nothing but rounding: they must be nonnegative and at most this.
    AtMost(f64),
    /// The cells are not compared. This is for values that may differ on another machine without
    /// being wrong, such as the place of a flat minimum.
    Free,
}

impl Tolerance {
    /// Returns the tolerance `|a − b| ≤ relative · |b|`.
    #[must_use]
    pub const fn relative(relative: f64) -> Tolerance {
        Tolerance::Close { relative, absolute: 0.0 }
    }
}

/// A column: its name and its tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    name: &'static str,
    tolerance: Tolerance,
}

/// A table of cells as they are printed, under a comment that says what they are.
///
/// Figures are drawn, and tables are set, from the printed cells. A picture therefore shows what
/// its data file says, and bits that are not printed cannot change it.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    columns: Vec<Column>,
    rows: Vec<Vec<String>>,
}

impl Data {
    /// Begins an empty table. Each entry names the columns with one tolerance, separated by spaces.
    #[must_use]
    pub fn new(columns: &[(&'static str, Tolerance)]) -> Data {
        let named = |&(names, tolerance): &(&'static str, Tolerance)| {
            names.split(' ').map(move |name| Column { name, tolerance })
        };
        Data { columns: columns.iter().flat_map(named).collect(), rows: Vec::new() }
    }

    /// Adds a row.
    ///
    /// # Panics
    ///
    /// Unless there is one cell for each column.
    pub fn push(&mut self, row: impl IntoIterator<Item = String>) {
        let row: Vec<String> = row.into_iter().collect();
        assert_eq!(row.len(), self.columns.len(), "one cell for each column");
        self.rows.push(row);
    }

    /// Returns the rows.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|cells| Row { columns: &self.columns, cells })
    }

    /// Returns the rows that have this text in a column.
    pub fn rows_with<'a>(&'a self, column: &str, text: &str) -> impl Iterator<Item = Row<'a>> {
        self.rows().filter(move |row| row.text(column) == text)
    }

    /// Returns the largest number in a column, or 1 if none exceeds 1.
    #[must_use]
    pub fn greatest(&self, column: &str) -> f64 {
        self.rows().map(|row| row.number(column)).fold(1.0, f64::max)
    }

    /// Returns the data file, under a comment with one line for each line of `comment`.
    ///
    /// # Errors
    ///
    /// If the writer fails, which does not happen in memory.
    pub fn to_csv(&self, comment: &str) -> Result<Vec<u8>, Failure> {
        let mut bytes = Vec::new();
        for line in comment.lines() {
            bytes.extend_from_slice(format!("# {line}\n").as_bytes());
        }
        let mut writer = csv::Writer::from_writer(bytes);
        let unwritten = |error: csv::Error| Failure::Data(error.to_string());
        writer.write_record(self.columns.iter().map(|column| column.name)).map_err(unwritten)?;
        for row in &self.rows {
            writer.write_record(row).map_err(unwritten)?;
        }
        writer.into_inner().map_err(|error| Failure::Data(error.to_string()))
    }

    /// Reads a file back, with the columns of `self`.
    ///
    /// # Errors
    ///
    /// If the columns differ, or if the bytes are not a data file.
    pub fn read(&self, bytes: &[u8]) -> Result<Data, Failure> {
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(bytes);
        let unread = |error: csv::Error| Failure::Data(error.to_string());
        let header = reader.headers().map_err(unread)?;
        if !header.iter().eq(self.columns.iter().map(|column| column.name)) {
            return Err(Failure::Differs(format!("the columns are {header:?}")));
        }
        let rows = reader
            .records()
            .map(|record| Ok(record.map_err(unread)?.iter().map(str::to_owned).collect()))
            .collect::<Result<_, Failure>>()?;
        Ok(Data { columns: self.columns.clone(), rows })
    }

    /// Compares the data with the committed data.
    ///
    /// # Errors
    ///
    /// Reports the first cell that differs by more than its tolerance.
    pub fn compare(&self, committed: &Data) -> Result<(), Failure> {
        if self.rows.len() != committed.rows.len() {
            let (ours, theirs) = (self.rows.len(), committed.rows.len());
            return Err(Failure::Differs(format!("{ours} rows, committed are {theirs}")));
        }
        for (k, (row, other)) in self.rows.iter().zip(&committed.rows).enumerate() {
            for ((cell, old), column) in row.iter().zip(other).zip(&self.columns) {
                if !agree(cell, old, column.tolerance) {
                    return Err(Failure::Differs(format!(
                        "row {}, column {}: computed {cell}, committed {old}",
                        k + 1,
                        column.name
                    )));
                }
            }
        }
        Ok(())
    }
}

fn agree(cell: &str, old: &str, tolerance: Tolerance) -> bool {
    if tolerance == Tolerance::Free || cell == old && !matches!(tolerance, Tolerance::AtMost(_)) {
        return true;
    }
    let (Ok(a), Ok(b)) = (cell.parse::<f64>(), old.parse::<f64>()) else {
        return cell == old;
    };
    match tolerance {
        Tolerance::Exact => false,
        Tolerance::Free => true,
        Tolerance::Close { relative, absolute } => (a - b).abs() <= relative * b.abs() + absolute,
        Tolerance::AtMost(limit) => (0.0..=limit).contains(&a) && (0.0..=limit).contains(&b),
    }
}

/// One row.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    columns: &'a [Column],
    cells: &'a [String],
}

impl<'a> Row<'a> {
    /// Returns the cell as it is printed.
    ///
    /// # Panics
    ///
    /// If there is no such column.
    #[must_use]
    pub fn text(&self, column: &str) -> &'a str {
        let index = self.columns.iter().position(|c| c.name == column);
        &self.cells[index.unwrap_or_else(|| panic!("no column {column}"))]
    }

    /// Returns the cells of several columns, separated by spaces.
    ///
    /// # Panics
    ///
    /// If one of the columns does not exist.
    #[must_use]
    pub fn texts(&self, columns: &str) -> Vec<String> {
        columns.split(' ').map(|column| self.text(column).to_owned()).collect()
    }

    /// Returns the numbers of two columns, as a point to be drawn.
    ///
    /// # Panics
    ///
    /// If one of the columns does not exist.
    #[must_use]
    pub fn point(&self, x: &str, y: &str) -> (f64, f64) {
        (self.number(x), self.number(y))
    }

    /// Returns the number in the cell, or NaN if the cell is empty.
    ///
    /// # Panics
    ///
    /// If there is no such column.
    #[must_use]
    pub fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or(f64::NAN)
    }
}
