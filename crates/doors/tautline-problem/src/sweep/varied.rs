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
        let (asked_grid, bound) = (self.asked_grid, self.bound);
        let question =
            Self::evaluated(self.file.clone(), self.problem.clone(), self.tables.clone(), values)?;
        let grid = asked_grid.unwrap_or(question.grid);
        Ok(Self { grid, asked_grid, bound, ..question })
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

#[cfg(test)]
mod tests {
    use super::{Axis, Sweep, Values};
    use crate::{Grid, Question};

    const FILE: &str = "\
[parameters]
a = 1     # the first
long = \"2*a\"
b = \"a + 1\"
[metric]
phi = \"a*b^2 + long^2\"
[from]
point = [\"-a\", 0]
[to]
ball = { centre = [\"b\", 9], radius = \"long^2\" }
";

    /// A tolerance that depends on a parameter changes with it, unless another grid was set.
    #[test]
    fn a_tolerance_may_depend_on_a_parameter() {
        let file = FILE.replace("[metric]", "tol = 0.1\n[solve]\ntolerance = \"tol\"\n[metric]");
        let mut question = Question::read(&file).expect("a file");
        let other = question.with_parameters(&[("tol", 1e-9)]).expect("a file");
        assert_eq!((question.grid, other.grid), (Grid::Tolerance(0.1), Grid::Tolerance(1e-9)));
        question.set_grid(Grid::Chords(7)).expect("a grid");
        let other = question.with_parameters(&[("tol", 1e-9)]).expect("a file");
        let again = other.with_parameters(&[("tol", 1e-3)]).expect("a file");
        assert_eq!((other.grid, again.grid), (Grid::Chords(7), Grid::Chords(7)));
    }

    /// What is written is read back bit for bit, and what depends on it changes with it: other parameters,
    /// the metric and the sets.
    #[test]
    fn a_file_with_other_numbers_is_the_question_with_them() {
        let question = Question::read(FILE).expect("a file");
        for values in [
            vec![("a", 0.1 + 0.2)],
            vec![("b", -1.0 / 3.0)],
            vec![("b", 5e-324), ("a", -1e100)],
            vec![("a", -2.5), ("b", 1e-7), ("long", 123_456_789.0)],
            vec![("long", 2.5), ("other", 7.0)],
            Vec::new(),
        ] {
            let file = question.file_with(&values);
            let written = Question::read(&file).unwrap_or_else(|error| panic!("{file}: {error}"));
            let other = question.with_parameters(&values).expect("numbers");
            assert_eq!(other.parameters, written.parameters, "{file}");
            for (name, value) in values.iter().filter(|(name, _)| *name != "other") {
                let found = written.parameters.iter().find(|(found, _)| found == name);
                let bits = found.map(|(_, found)| found.to_bits());
                assert_eq!(bits, Some(value.to_bits()), "{file}");
            }
            assert_eq!(other.extents(), written.extents(), "{file}");
            let formula = |question: &Question| question.formula::<2>().expect("a formula");
            assert_eq!(formula(&other), formula(&written), "{file}");
            // Nothing else changes.
            assert_eq!(file.lines().count(), FILE.lines().count());
            assert!(file.contains("     # the first\n") && file.contains("ball = { centre = "));
        }
        assert_eq!(question.file_with(&[]), FILE);
        let other = question.with_parameters(&[("a", 3.0)]).expect("numbers");
        let named = |name: &str, value| (name.to_owned(), value);
        assert_eq!(other.parameters, [named("a", 3.0), named("long", 6.0), named("b", 4.0)]);
        assert_eq!(other.extents(), Some([vec![-32.0, -27.0], vec![40.0, 45.0]]));
    }

    #[test]
    fn each_axis_has_its_names_and_values_in_the_order_of_the_file() {
        let file = "dimension = 1\n[parameters]\nw = 5\nh = 0\na = 0\nb = 0\nc = 0\nd = 0\n\
                    [metric]\nphi = 1\n[sweep]\ndraws = 3\nseed = 7\n[sweep.vary]\n\
                    h = [1, \"2*w\", -3]\nd = { uniform = [-1, \"w\"] }\n\
                    \"b, a\" = [[1, 2], [\"w\", 4]]\nc = { from = \"w\", to = 0, count = 3 }\n";
        let axis = |names: &[&str], values| Axis {
            names: names.iter().map(|&name| name.to_owned()).collect(),
            values,
        };
        let list = |values: &[&[f64]]| Values::List(values.iter().map(|it| it.to_vec()).collect());
        let axes = vec![
            axis(&["h"], list(&[&[1.0], &[10.0], &[-3.0]])),
            axis(&["d"], Values::Uniform { least: -1.0, most: 5.0 }),
            axis(&["b", "a"], list(&[&[1.0, 2.0], &[5.0, 4.0]])),
            axis(&["c"], Values::Grid { from: 5.0, to: 0.0, count: 3 }),
        ];
        let sweep = Question::read(file).expect("a file").sweep().expect("a sweep");
        assert_eq!(sweep, Some(Sweep { axes, draws: 3, seed: 7 }));
    }
}
