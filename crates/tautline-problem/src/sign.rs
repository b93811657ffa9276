//! The sign of a cost or a speed, which the metric, a square, does not show.

use tautline::{Metric, PointSequence, SVector};

use crate::{Diagnostic, Question, file::metric::MetricFile, formula::formula_of};

impl Question {
    /// Refuses a cost or a speed that is not positive at a point of a curve or in the middle of a
    /// chord.
    pub(crate) fn check_sign<const D: usize>(
        &self,
        sequence: &PointSequence<D>,
    ) -> Result<(), Diagnostic> {
        let (name, text) = match self.problem.metric.get_ref() {
            MetricFile::Cost(text) => ("cost", text),
            MetricFile::Speed(text) => ("speed", text),
            _ => return Ok(()),
        };
        // The entries of φ I are the function itself.
        let phi = MetricFile::Phi(text.clone());
        let phi = formula_of::<D>(&phi, &self.problem, &self.numbers())?;
        let middles = sequence.chords().map(|(x, d)| x + d * 0.5);
        let points = sequence.points().iter().copied().chain(middles);
        let values = points.map(|x: SVector<f64, D>| (x, phi.gram(&x)[(0, 0)]));
        let least = values.min_by(|(_, a), (_, b)| a.total_cmp(b));
        let Some((x, value)) = least.filter(|(_, value)| *value <= 0.0) else { return Ok(()) };
        let message = format!("the {name} is {value} at {:?}", x.as_slice());
        Err(Diagnostic::new(message, text.span()).label("expected a positive function"))
    }
}
