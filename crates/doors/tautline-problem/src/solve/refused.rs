//! Why there is no metric along any curve.

use tautline::{Known, MetricError, Shape, SolveError};

use crate::{Diagnostic, Failure, Question, formula::formula_of};

impl Question {
    /// Returns the failure of a search.
    pub(super) fn failure(&self, metric: &Known, error: &SolveError) -> Failure {
        let SolveError::Metric(defect) = error else {
            return Failure::NotComputed(error.to_string());
        };
        let in_obstacle = match defect {
            MetricError::NotFinite { point, .. } => self.in_obstacle(metric, point),
            _ => None,
        };
        let place = self.problem.metric.get_ref().span();
        let place = place.unwrap_or(self.problem.metric.span());
        Failure::BadInput(in_obstacle.unwrap_or(Diagnostic::new(error.to_string(), place)))
    }

    /// Explains why there is no metric at a point, if that is due to the obstacles alone.
    fn in_obstacle(&self, metric: &Known, point: &[f64]) -> Option<Diagnostic> {
        let regions = self.problem.obstacles.as_ref()?.get_ref().regions.span();
        let (file, numbers) = (self.problem.metric.get_ref(), self.numbers());
        let (problem, tables) = (&self.problem, &self.tables);
        let without = formula_of(file, problem, &numbers, tables, self.dimension, None).ok()?;
        if !are_finite(&without.gram_at(point)) {
            return None;
        }
        for piece in self.ends.iter().flatten().flatten() {
            if let Shape::Point(point) = &piece.shape
                && let x = point.position_slice()
                && !are_finite(&metric.gram(x))
            {
                let place = piece.places.first().cloned().unwrap_or(regions);
                return Some(
                    Diagnostic::new(format!("the point {x:?} is in an obstacle"), place)
                        .label("expected a point outside of all regions"),
                );
            }
        }
        Some(
            Diagnostic::new(
                format!("every search runs into an obstacle, such as at {point:?}"),
                regions,
            )
            .help("name a way round it: a polygon as starts in [solve], or a lattice"),
        )
    }
}

fn are_finite(gram: &[f64]) -> bool {
    gram.iter().all(|h| h.is_finite())
}
