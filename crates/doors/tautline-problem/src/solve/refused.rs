//! Why there is no metric along any curve.

use tautline::{AnySet, Known, MetricError, Rule, Shape, Short, SolveError, are_gram};

use crate::{Diagnostic, Failure, Question, formula::formula_of, reading::shape::Piece};

/// How far beside an end an end is advised, as a part of the way.
const BESIDE: f64 = 1e-3;

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
        Failure::BadInput(in_obstacle.unwrap_or_else(|| {
            let diagnostic = Diagnostic::new(error.to_string(), place);
            match self.beside_an_end(metric, defect) {
                Some(help) => diagnostic.help(help),
                None => diagnostic,
            }
        }))
    }

    /// Advises what to do about an end that is a point without a metric.
    fn beside_an_end(&self, metric: &Known, defect: &MetricError) -> Option<String> {
        let (MetricError::NotFinite { point, .. } | MetricError::NotPositiveDefinite { point, .. }) =
            defect
        else {
            return None;
        };
        let [from, to] = self.ends.as_ref()?;
        let sides = [("[from]", from, to), ("[to]", to, from)];
        sides.into_iter().find_map(|(name, own, other)| {
            let [Piece { shape: Shape::Point(end), .. }] = &own[..] else { return None };
            let end = end.position_slice();
            if end != point {
                return None;
            }
            if let MetricError::NotFinite { entry, .. } = defect {
                let is_node = self.rule != Rule::TRAPEZOIDAL && entry.is_infinite();
                let advice = "the trapezoidal rule has no node at an end, from where the length may be finite";
                return is_node.then(|| advice.to_owned());
            }
            let mut toward = end.to_vec();
            other.first()?.shape.project(&mut toward);
            let beside = end.iter().zip(toward).map(|(a, b)| a + BESIDE * (b - a));
            let beside: Vec<f64> = beside.collect();
            let is_there = are_gram(&metric.gram(&beside), end.len());
            let beside: Vec<String> = beside.into_iter().map(|x| Short(x).to_string()).collect();
            is_there
                .then(|| format!("leave out the end, such as by {name} at [{}]", beside.join(", ")))
        })
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
