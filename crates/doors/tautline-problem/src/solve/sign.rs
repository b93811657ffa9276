//! The signs of costs and speeds, which the metric, made of their squares, does not show.

use std::ops::Range;

use tautline::{ANY, Formula, Known, PointSequence, PreparedFormula, Short, formula::Form};
use tautline_any::{least_at, least_entry};
use tautline_picture::portrait::Cubes;

use crate::{
    Diagnostic, Question,
    file::metric::MetricFile,
    formula::{formula_of, squared_in},
};

impl Question {
    /// Refuses a cost or a speed that is negative at a point of a curve or in the middle of a
    /// chord.
    pub(crate) fn check_sign(&self, sequence: &PointSequence<ANY>) -> Result<(), Diagnostic> {
        for Squared { name, place, phi, .. } in self.squared()? {
            let least = least_entry(&PreparedFormula::new(phi), sequence);
            if let Some((value, x)) = least.filter(|(value, _)| *value < 0.0) {
                let message = format!("the {name} is {} at {x:?}", Short(value));
                return Err(Diagnostic::new(message, place).label("expected a positive function"));
            }
        }
        Ok(())
    }

    /// Returns the metric, undefined where a cost or a speed is not positive; `None` if it has neither.
    pub(crate) fn where_positive(&self, metric: &Known) -> Result<Option<Known>, Diagnostic> {
        let functions: Vec<_> = self.squared()?.into_iter().map(|squared| squared.phi).collect();
        let formula = metric.formula().ok().filter(|_| !functions.is_empty());
        Ok(formula.and_then(|formula| formula.where_positive(&functions).ok()).map(Known::from))
    }

    /// Says where a cost or a speed is negative in some cubes, at one of their corners or in the middle of
    /// one, and what this means. There is no metric where a cost or a speed is 0, unless the cost is in a
    /// term of a sum. So a curve on which it is positive does not get there, and bounds are true of these
    /// curves.
    pub(crate) fn negative_in(&self, cubes: &Cubes) -> Result<Option<String>, Diagnostic> {
        let d = self.dimension;
        let corner = |corner: usize| move |i: usize| f64::from(u8::from(corner >> i & 1 == 1));
        let offsets = (0..1_usize << d).map(|number| (0..d).map(corner(number)).collect());
        let offsets: Vec<Vec<f64>> = offsets.chain([vec![0.5; d]]).collect();
        let beside = |place: &[i32], by: &[f64]| -> Vec<f64> {
            place.iter().zip(by).map(|(&i, by)| (f64::from(i) + by) * cubes.side).collect()
        };
        let points: Vec<f64> = cubes
            .places
            .chunks_exact(d)
            .flat_map(|place| offsets.iter().flat_map(move |by| beside(place, by)))
            .collect();
        for Squared { name, is_term, phi, .. } in self.squared()? {
            let least = least_at(&PreparedFormula::new(phi), &points);
            if let Some((value, x)) = least.filter(|(value, _)| *value < 0.0) {
                let value = Short(value);
                let meaning = if is_term {
                    "the sum has its square there"
                } else {
                    "what is proved is about curves on which it is positive"
                };
                return Ok(Some(format!("the {name} is {value} at {x:?}; {meaning}")));
            }
        }
        Ok(None)
    }

    /// Returns the costs and the speeds in the metric.
    fn squared(&self) -> Result<Vec<Squared>, Diagnostic> {
        let (problem, numbers, tables) = (&self.problem, self.numbers(), &self.tables);
        let dimension = self.dimension;
        let mut found = Vec::new();
        for (part, is_term) in parts(problem.metric.get_ref()) {
            let (name, text, phi) = match part {
                MetricFile::Cost(text) => ("cost", text, None),
                MetricFile::Speed(text) => ("speed", text, None),
                MetricFile::Formula(text) => {
                    match squared_in(text, problem, &numbers, tables, dimension)? {
                        Some((Form::Speed, phi)) => ("speed", text, Some(phi)),
                        Some((_, phi)) => ("cost", text, Some(phi)),
                        None => continue,
                    }
                }
                _ => continue,
            };
            let phi = phi.map_or_else(
                // The entries of φ I are the function itself.
                || {
                    let phi = MetricFile::Phi(text.clone());
                    formula_of(&phi, problem, &numbers, tables, dimension, None)
                },
                Ok,
            )?;
            found.push(Squared { name, place: text.span(), is_term, phi });
        }
        Ok(found)
    }
}

/// A cost or a speed in a metric.
struct Squared {
    /// Cost or speed.
    name: &'static str,
    place: Range<usize>,
    /// Whether it is in a term of a sum, which is a metric where the cost is 0.
    is_term: bool,
    /// The function itself: `φ I`.
    phi: Formula<ANY>,
}

/// Returns the metrics of which a metric is made, and which of them are in a term of a sum.
fn parts(metric: &MetricFile) -> Vec<(&MetricFile, bool)> {
    match metric {
        MetricFile::Sum(metrics) => {
            let terms = metrics.get_ref().iter().flat_map(parts);
            terms.map(|(part, _)| (part, true)).collect()
        }
        MetricFile::Scaled(scaled) => parts(&scaled.metric),
        MetricFile::Product(blocks) => {
            blocks.get_ref().iter().flat_map(|block| parts(&block.metric)).collect()
        }
        metric => vec![(metric, false)],
    }
}
