//! The signs of costs and speeds, which the metric, made of their squares, does not show.

use std::ops::Range;

use tautline::{
    Batch, Batches, Formula, Kind, PointSequence, Prepared, SVector, Short, formula::Form,
};
use tautline_picture::portrait::Cubes;

use crate::{
    Diagnostic, Question,
    file::metric::MetricFile,
    formula::{formula_of, squared_in},
};

impl Question {
    /// Refuses a cost or a speed that is negative at a point of a curve or in the middle of a
    /// chord.
    pub(crate) fn check_sign<const D: usize>(
        &self,
        sequence: &PointSequence<D>,
    ) -> Result<(), Diagnostic> {
        for Squared { name, place, phi, .. } in self.squared()? {
            let least = least_entry(&Prepared::new(&phi), sequence);
            if let Some((x, value)) = least.filter(|(_, value)| *value < 0.0) {
                let message = format!("the {name} is {value} at {:?}", x.as_slice());
                return Err(Diagnostic::new(message, place).label("expected a positive function"));
            }
        }
        Ok(())
    }

    /// Says where a cost or a speed is negative in some cubes, at one of their corners or in the middle of
    /// one, and what this means. There is no metric where a cost or a speed is 0, unless the cost is in a
    /// term of a sum. So a curve on which it is positive does not get there, and bounds are true of these
    /// curves.
    pub(crate) fn negative_in<const D: usize>(
        &self,
        cubes: &Cubes,
    ) -> Result<Option<String>, Diagnostic> {
        let corner = |place: &[i32]| SVector::<f64, D>::from_fn(|i, _| f64::from(place[i]));
        let offsets: Vec<SVector<f64, D>> = (0..1_usize << D)
            .map(|corner| SVector::from_fn(|i, _| f64::from(u8::from(corner >> i & 1 == 1))))
            .chain([SVector::from_element(0.5)])
            .collect();
        let points: Vec<SVector<f64, D>> = cubes
            .places
            .chunks_exact(D)
            .flat_map(|place| offsets.iter().map(move |by| (corner(place) + by) * cubes.side))
            .collect();
        for Squared { name, is_term, phi, .. } in self.squared()? {
            let least = least_at(&Prepared::new(&phi), &points);
            if let Some((x, value)) = least.filter(|(_, value)| *value < 0.0) {
                let (value, x) = (Short(value), x.as_slice());
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
    fn squared<const D: usize>(&self) -> Result<Vec<Squared<D>>, Diagnostic> {
        let (problem, numbers, tables) = (&self.problem, self.numbers(), &self.tables);
        let mut found = Vec::new();
        for (part, is_term) in parts(problem.metric.get_ref()) {
            let (name, text, phi) = match part {
                MetricFile::Cost(text) => ("cost", text, None),
                MetricFile::Speed(text) => ("speed", text, None),
                MetricFile::Formula(text) => {
                    match squared_in::<D>(text, problem, &numbers, tables)? {
                        Some((Form::Speed, phi)) => ("speed", text, Some(phi)),
                        Some((_, phi)) => ("cost", text, Some(phi)),
                        None => continue,
                    }
                }
                _ => continue,
            };
            let phi = phi.map_or_else(
                // The entries of φ I are the function itself.
                || formula_of(&MetricFile::Phi(text.clone()), problem, &numbers, tables, None),
                Ok,
            )?;
            found.push(Squared { name, place: text.span(), is_term, phi });
        }
        Ok(found)
    }
}

/// A cost or a speed in a metric.
struct Squared<const D: usize> {
    /// Cost or speed.
    name: &'static str,
    place: Range<usize>,
    /// Whether it is in a term of a sum, which is a metric where the cost is 0.
    is_term: bool,
    /// The function itself: `φ I`.
    phi: Formula<D>,
}

/// Returns the least value of the first entry of `H` at the points of a sequence and in the middles of
/// its chords, and where it is.
pub(crate) fn least_entry<const D: usize>(
    metric: &dyn Batches<D>,
    sequence: &PointSequence<D>,
) -> Option<(SVector<f64, D>, f64)> {
    let middles = sequence.chords().map(|(x, d)| x + d * 0.5);
    let points: Vec<SVector<f64, D>> = sequence.points().iter().copied().chain(middles).collect();
    least_at(metric, &points)
}

/// Returns the least value of the first entry of `H` at some points, and where it is.
fn least_at<const D: usize>(
    metric: &dyn Batches<D>,
    points: &[SVector<f64, D>],
) -> Option<(SVector<f64, D>, f64)> {
    // The first unit vector e has eᵀ H e = H₁₁.
    let mut unit = SVector::<f64, D>::zeros();
    unit[0] = 1.0;
    let mut batch = Batch::new(metric, Kind::Square, 1, points.len());
    let mut least = None;
    for points in points.chunks(batch.lanes()) {
        let mut inputs = batch.inputs(points.len());
        points.iter().enumerate().for_each(|(lane, x)| inputs.set(lane, x, &unit));
        // The result is whether H is a metric, which its sign says too.
        let _ = batch.evaluate(points.len());
        let values = batch.row(batch.layout().square[0]);
        let values = points.iter().copied().zip(values.iter().copied());
        least = least.into_iter().chain(values).min_by(|(_, a), (_, b)| a.total_cmp(b));
    }
    least
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
