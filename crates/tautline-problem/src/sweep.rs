//! `Sweep`: which parameters of a file vary, and the question for given values of them.

use crate::{Diagnostic, Question, reading::axes::axes};

/// What varies in a sweep: its problems are all combinations of the values of its axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// The axes, in the order of the file. There is at least one.
    pub axes: Vec<Axis>,
    /// The number of random draws for each combination of the other values.
    pub draws: u64,
    /// The seed of the random draws.
    pub seed: u64,
}

/// Parameters that vary together, and their values.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The names of the parameters.
    pub names: Vec<String>,
    /// Their values.
    pub values: Values,
}

/// The values of an axis; all are finite.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// For each value of the axis a number for each of its parameters. There is at least one.
    List(Vec<Vec<f64>>),
    /// Equally spaced numbers. `count` is at least 2, or 1 where `from` is `to`.
    Grid {
        /// The first number.
        from: f64,
        /// The last number.
        to: f64,
        /// How many there are.
        count: u64,
    },
    /// Random numbers in an interval, one for each problem.
    Uniform {
        /// The lower end.
        least: f64,
        /// The upper end.
        most: f64,
    },
}

impl Question {
    /// Returns what varies in a sweep, if the file has such a section.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] with the place in the file.
    pub fn sweep(&self) -> Result<Option<Sweep>, Diagnostic> {
        let Some(sweep) = &self.problem.sweep else { return Ok(None) };
        if let Some(limit) = &self.problem.solve.time_limit {
            return Err(Diagnostic::new("a time limit in a sweep", limit.span())
                .label("results would depend on the machine")
                .help("steps limits a search on any machine alike"));
        }
        axes(sweep, &self.problem, &self.numbers()).map(Some)
    }

    /// Returns the question with other values of some parameters of the file, as if they stood there.
    /// Parameters that are written with them change too. The file is not parsed again.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] if numbers of the file are wrong for these values. Names that are no parameters
    /// are ignored.
    pub fn with_parameters(&self, values: &[(&str, f64)]) -> Result<Self, Diagnostic> {
        let (grid, bound) = (self.grid, self.bound);
        let question =
            Self::evaluated(self.file.clone(), self.problem.clone(), self.tables.clone(), values)?;
        Ok(Self { grid, bound, ..question })
    }

    /// Returns the text of the file with other values of some parameters, which are written so that they
    /// read back exactly. Comments and the rest remain as they are.
    #[must_use]
    pub fn file_with(&self, values: &[(&str, f64)]) -> String {
        let mut file = self.file.to_string();
        let parameters = self.problem.parameters.iter();
        let mut places: Vec<_> = parameters
            .filter_map(|(name, text)| {
                let (_, value) = values.iter().find(|(found, _)| found == name.get_ref())?;
                Some((text.span(), value))
            })
            .collect();
        // From the end, so that the places before remain right.
        places.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
        for (span, value) in places {
            file.replace_range(span, &format!("{value:?}"));
        }
        file
    }
}
