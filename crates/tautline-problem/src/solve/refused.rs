//! Why there is no metric along any curve.

use tautline::{Metric, MetricError, SVector, Shape, SolveError};

use crate::{
    Diagnostic, Failure, Question, formula::formula_of, known::Known, reading::shape::vector,
};

impl Question {
    /// Returns the failure of a search.
    pub(super) fn failure<const D: usize>(&self, metric: &Known<D>, error: &SolveError) -> Failure {
        let SolveError::Metric(defect) = error else {
            return Failure::NotComputed(error.to_string());
        };
        let in_obstacle = match defect {
            MetricError::NotFinite { point, .. } => self.in_obstacle(metric, &vector(point)),
            _ => None,
        };
        let place = self.problem.metric.get_ref().span();
        let place = place.unwrap_or(self.problem.metric.span());
        Failure::BadInput(in_obstacle.unwrap_or(Diagnostic::new(error.to_string(), place)))
    }

    /// Explains why there is no metric at a point, if that is due to the obstacles alone.
    fn in_obstacle<const D: usize>(
        &self,
        metric: &Known<D>,
        point: &SVector<f64, D>,
    ) -> Option<Diagnostic> {
        let regions = self.problem.obstacles.as_ref()?.get_ref().regions.span();
        let (file, numbers) = (self.problem.metric.get_ref(), self.numbers());
        let without = formula_of::<D>(file, &self.problem, &numbers, &self.tables, None).ok()?;
        if !is_finite(&without, point) {
            return None;
        }
        for piece in self.ends.iter().flatten().flatten() {
            if let Shape::Point(point) = &piece.shape
                && let x = point.position_slice()
                && !is_finite(metric, &vector(x))
            {
                let place = piece.places.first().cloned().unwrap_or(regions);
                return Some(
                    Diagnostic::new(format!("the point {x:?} is in an obstacle"), place)
                        .label("expected a point outside of all regions"),
                );
            }
        }
        let x = point.as_slice();
        Some(
            Diagnostic::new(
                format!("every search runs into an obstacle, such as at {x:?}"),
                regions,
            )
            .help("name a way round it: a polygon as starts in [solve], or a lattice"),
        )
    }
}

fn is_finite<const D: usize>(metric: &impl Metric<D>, x: &SVector<f64, D>) -> bool {
    metric.gram(x).iter().all(|h| h.is_finite())
}
