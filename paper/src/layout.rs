//! `Layout`: a table as Markdown and as LaTeX.

/// A table with heads and cells, ready to be set.
///
/// Heads and cells are plain text with mathematics between dollar signs, which works in both
/// formats.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    caption: String,
    heads: Vec<&'static str>,
    rows: Vec<Vec<String>>,
    /// The rows before which a new group begins.
    groups: Vec<usize>,
    /// The key that the rows of the last group have in common.
    key: String,
}

impl Layout {
    /// Begins a table; `heads` are separated by `" & "`.
    #[must_use]
    pub fn new(caption: impl Into<String>, heads: &'static str) -> Layout {
        let heads = heads.split(" & ").collect();
        Layout { caption: caption.into(), heads, ..Layout::default() }
    }

    /// Adds a row.
    ///
    /// # Panics
    ///
    /// Unless there is one cell for each head.
    pub fn push(&mut self, row: impl IntoIterator<Item = String>) {
        let row: Vec<String> = row.into_iter().collect();
        assert_eq!(row.len(), self.heads.len(), "one cell for each head");
        self.rows.push(row);
    }

    /// Begins a new group of rows.
    pub fn group(&mut self) {
        if !self.rows.is_empty() {
            self.groups.push(self.rows.len());
        }
    }

    /// Begins a new group if `key` differs from the key of the previous rows, and returns whether
    /// it did.
    pub fn group_by(&mut self, key: &str) -> bool {
        let new = self.key != key;
        if new {
            key.clone_into(&mut self.key);
            self.group();
        }
        new
    }

    /// Returns the table in Markdown.
    #[must_use]
    pub fn markdown(&self) -> String {
        let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
        // A bar inside mathematics would end the cell.
        let escape = |cell: &str| cell.replace('|', "\\|");
        let mut text = format!("{}\n\n", self.caption);
        text += &line(self.heads.iter().map(|head| escape(head)).collect());
        text += &line(self.heads.iter().map(|_| "---:".to_owned()).collect());
        for row in &self.rows {
            text += &line(row.iter().map(|cell| escape(cell)).collect());
        }
        text
    }

    /// Returns the table for LaTeX. It can be included by `\input` if the package `booktabs` is
    /// loaded.
    #[must_use]
    pub fn latex(&self) -> String {
        let line = |cells: Vec<String>| format!("  {} \\\\\n", cells.join(" & "));
        let mut text = format!("% {}\n", self.caption);
        text += &format!("\\begin{{tabular}}{{{}}}\n  \\toprule\n", "r".repeat(self.heads.len()));
        text += &line(self.heads.iter().map(|head| escape_latex(head)).collect());
        text += "  \\midrule\n";
        for (k, row) in self.rows.iter().enumerate() {
            if self.groups.contains(&k) {
                text += "  \\addlinespace\n";
            }
            text += &line(row.iter().map(|cell| escape_latex(cell)).collect());
        }
        text += "  \\bottomrule\n\\end{tabular}\n";
        text
    }
}

/// Escapes what LaTeX would misread outside mathematics.
fn escape_latex(cell: &str) -> String {
    cell.split('$')
        .enumerate()
        .map(|(k, part)| {
            if k % 2 == 1 {
                format!("${part}$")
            } else {
                part.replace('_', "\\_").replace('%', "\\%").replace('&', "\\&")
            }
        })
        .collect()
}

/// Returns the text, or a dash if it is empty.
#[must_use]
pub fn or_dash(text: &str) -> String {
    if text.is_empty() { "–" } else { text }.to_owned()
}

/// Returns a number as mathematics: `1.23e-4` becomes `$1.23\cdot 10^{-4}$`. An empty cell or NaN
/// becomes a dash.
#[must_use]
pub fn scientific(value: f64, digits: usize) -> String {
    if value.is_nan() {
        return "–".to_owned();
    }
    if value == 0.0 {
        return "$0$".to_owned();
    }
    let text = format!("{value:.digits$e}");
    match text.split_once('e') {
        Some((mantissa, "0")) => format!("${mantissa}$"),
        Some((mantissa, exponent)) => format!("${mantissa}\\cdot 10^{{{exponent}}}$"),
        None => text,
    }
}
