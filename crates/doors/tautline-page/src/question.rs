//! `Question`: a metric on the plane, two points, and the number of chords between them.

use tautline::{
    Ends, Formula, Interpolation, Metric, MetricError, PointSequence, Problem, Request, Short,
    TautLine,
    formula::{Form, Part},
};

use crate::Complaint;

/// The most chords that a page may ask for: a picture shows no more.
const MOST_CHORDS: u32 = 4096;

/// The most characters of a formula: its derivatives are found while the reader waits.
const MOST_CHARACTERS: usize = 2000;

/// A metric on the plane, two points, and the number of chords of the curve between them.
#[derive(Clone, Debug)]
pub struct Question {
    problem: Problem<Formula<2>, 2>,
    /// The function `f` of a metric that is `cost(f)` or `speed(f)`, as `f I`, and which of the two it is.
    squared: Option<(Form, Formula<2>)>,
    chords: usize,
}

impl Question {
    /// Reads the formula, and poses the problem.
    ///
    /// # Errors
    ///
    /// [`Complaint`] if the formula is broken, with its place, or longer than 2000 characters; if a
    /// coordinate is not finite; if
    /// the number of chords is 0 or exceeds 4096.
    pub fn new(
        formula: &str,
        from: [f64; 2],
        to: [f64; 2],
        chords: u32,
    ) -> Result<Self, Complaint> {
        if !(1..=MOST_CHORDS).contains(&chords) {
            let most = format!("{chords} chords: a page draws between 1 and {MOST_CHORDS}");
            return Err(Complaint::about(&most));
        }
        let metric = read(formula)?;
        let ends = Ends::points(from, to).map_err(|error| Complaint::about(&error))?;
        let squared = Formula::squared_in(&[], &[], &[], Part { text: formula, id: 0 });
        let squared = squared.map_err(|error| Complaint::about_text(formula, &error.error))?;
        Ok(Self { problem: Problem::new(metric, ends), squared, chords: chords as usize })
    }

    /// Solves the problem, as a file without further options does.
    ///
    /// # Errors
    ///
    /// [`Complaint`] if the solver finds no curve, for instance because the metric is not positive
    /// definite, or if a cost or a speed is negative at a point of the curve or in the middle of a chord.
    pub fn line(&self) -> Result<TautLine<Formula<2>, 2>, Complaint> {
        let request = Request::chords(self.chords);
        let line = self.problem.answer(&request).map_err(|error| Complaint::about(&error))?;
        let Err(negative) = self.check_sign(line.sequence()) else { return Ok(line) };
        // The search may have stepped over a pole. A second one refuses steps to where f is not positive.
        let functions: Vec<_> = self.squared.iter().map(|(_, f)| f.clone()).collect();
        let positive = self.problem.metric().where_positive(&functions).ok();
        let ends = self.problem.ends().clone();
        let line = positive.and_then(|metric| Problem::new(metric, ends).answer(&request).ok());
        line.filter(|line| self.check_sign(line.sequence()).is_ok()).ok_or(negative)
    }

    /// The square does not show the sign.
    fn check_sign(&self, sequence: &PointSequence<2>) -> Result<(), Complaint> {
        let Some((form, f)) = &self.squared else { return Ok(()) };
        let name = if *form == Form::Speed { "speed" } else { "cost" };
        let middles = sequence.chords().map(|(x, d)| x + d * 0.5);
        let mut points = sequence.points().iter().copied().chain(middles);
        let negative = points.find_map(|x| {
            let value = f.gram(&x)[(0, 0)];
            (value < 0.0).then(|| (value, x.as_slice().to_vec()))
        });
        // Between these points, where a quadrature would look.
        let on_a_chord = || match Interpolation::new(sequence).check(f) {
            Err(MetricError::NotPositiveDefinite { point, eigenvalue }) if eigenvalue < 0.0 => {
                Some((eigenvalue, point))
            }
            _ => None,
        };
        let Some((value, x)) = negative.or_else(on_a_chord) else { return Ok(()) };
        Err(Complaint::about(&format!("the {name} is {} at {x:?}", Short(value))))
    }
}

/// Reads a metric on the plane.
pub(crate) fn read(formula: &str) -> Result<Formula<2>, Complaint> {
    let count = formula.chars().count();
    if count > MOST_CHARACTERS {
        let most = format!("{count} characters: a page reads at most {MOST_CHARACTERS}");
        return Err(Complaint::about(&most));
    }
    Formula::parse(formula, &[]).map_err(|error| Complaint::about_text(formula, &error))
}

#[cfg(test)]
mod tests {
    use super::Question;

    #[test]
    fn a_question_without_an_answer_is_refused_in_words() {
        let refused = |formula: &str, x: f64, chords| {
            let asked = Question::new(formula, [x, 0.0], [1.0, 0.0], chords);
            asked.and_then(|it| it.line()).expect_err("refused").message
        };
        assert!(refused("1 I", 0.0, 0).contains("0 chords"));
        assert!(refused("1 I", 0.0, u32::MAX).contains("4294967295 chords"));
        assert!(refused("1 I", f64::NAN, 8).contains("NaN"));
        assert!(refused("(x1 - 0.25) I", 0.0, 8).contains("not positive definite"));
        let long = format!("({}1) I", "1 + ".repeat(500));
        assert!(refused(&long, 0.0, 8).contains("2005 characters"));
        assert!(refused("ln(x1) I", -1.0, 8).contains("finite"));
        assert!(refused("cost(-2 - cos(x1))", 0.0, 8).contains("the cost is -3 at [0.0, 0.0]"));
        assert!(refused("f = -2; speed(f)", 0.0, 8).contains("the speed is -2 at"));
        let square = Question::new("(-2 - cos(x1))^2 I", [0.0, 0.0], [1.0, 0.0], 8);
        assert!(square.and_then(|it| it.line()).is_ok());
    }
}
