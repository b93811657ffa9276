//! `Layout`: a table as Markdown and as LaTeX.

/// A table with heads and cells, ready to be set.
///
/// Heads and cells are in a small common language: plain text, and mathematics between
/// dollars, which both formats understand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    caption: String,
    heads: Vec<&'static str>,
    rows: Vec<Vec<String>>,
    /// Rows before which a new group begins.
    groups: Vec<usize>,
}

impl Layout {
    /// Begins a table.
    #[must_use]
    pub fn new(caption: impl Into<String>, heads: &[&'static str]) -> Layout {
        Layout { caption: caption.into(), heads: heads.to_vec(), ..Layout::default() }
    }

    /// Adds a row.
    ///
    /// # Panics
    ///
    /// If it has not one cell for each head.
    pub fn push(&mut self, row: Vec<String>) {
        assert_eq!(row.len(), self.heads.len(), "one cell for each head");
        self.rows.push(row);
    }

    /// Begins a new group of rows.
    pub fn group(&mut self) {
        if !self.rows.is_empty() {
            self.groups.push(self.rows.len());
        }
    }

    /// Returns the table in Markdown.
    #[must_use]
    pub fn markdown(&self) -> String {
        let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
        // A bar inside of mathematics would end the cell.
        let escape = |cell: &str| cell.replace('|', "\\|");
        let mut text = format!("{}\n\n", self.caption);
        text += &line(self.heads.iter().map(|head| escape(head)).collect());
        text += &line(self.heads.iter().map(|_| "---:".to_owned()).collect());
        for row in &self.rows {
            text += &line(row.iter().map(|cell| escape(cell)).collect());
        }
        text
    }

    /// Returns the table for LaTeX, to be `\input` where the package `booktabs` is loaded.
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

/// Escapes what LaTeX would misread outside of mathematics.
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

/// Returns a number as mathematics: `1.23e-4` becomes `$1.23\cdot 10^{-4}$`, an empty cell or
/// NaN a dash.
#[must_use]
pub(super) fn scientific(value: f64, digits: usize) -> String {
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

#[cfg(test)]
mod tests {
    use super::{Layout, scientific};

    #[test]
    fn both_formats_hold_every_cell() {
        let mut layout = Layout::new("A caption", &["case", "$|x|$"]);
        layout.push(vec!["a_b".to_owned(), scientific(1.5e-7, 1)]);
        layout.group();
        layout.push(vec!["c".to_owned(), scientific(f64::NAN, 1)]);
        assert_eq!(
            layout.markdown(),
            "A caption\n\n| case | $\\|x\\|$ |\n| ---: | ---: |\n\
             | a_b | $1.5\\cdot 10^{-7}$ |\n| c | – |\n"
        );
        assert_eq!(
            layout.latex(),
            "% A caption\n\\begin{tabular}{rr}\n  \\toprule\n  case & $|x|$ \\\\\n  \\midrule\n  \
             a\\_b & $1.5\\cdot 10^{-7}$ \\\\\n  \\addlinespace\n  c & – \\\\\n  \
             \\bottomrule\n\\end{tabular}\n"
        );
    }

    #[test]
    fn numbers_of_size_one_have_no_exponent() {
        assert_eq!(scientific(2.5, 3), "$2.500$");
        assert_eq!(scientific(0.0, 3), "$0$");
        assert_eq!(scientific(-31.0, 1), "$-3.1\\cdot 10^{1}$");
    }
}
