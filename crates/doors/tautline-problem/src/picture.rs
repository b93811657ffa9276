//! The picture of a problem and its answer.

use tautline::{ANY, Shape};
use tautline_picture::{
    Scene,
    portrait::{Corridor, Portrait, PortraitError},
};

use crate::{Answer, CertifiedAnswer, Diagnostic, Failure, Question};

impl Question {
    /// Returns the picture of the metric, the sets and the curves, if there are any.
    ///
    /// # Errors
    ///
    /// [`Failure::BadInput`] if the formula is wrong, [`Failure::NotComputed`] if there is nothing
    /// to draw.
    pub fn picture(&self, answer: Option<&Answer>) -> Result<Scene, Failure> {
        let others = answer.into_iter().flat_map(|answer| &answer.other_minima);
        let others: Vec<Vec<Vec<f64>>> = others.map(|other| other.curve.clone()).collect();
        let curve = answer.map_or(&[][..], |answer| &answer.curve);
        self.drawn(curve, &others, None)
    }

    /// Returns the picture of the metric, the sets, the curves, and the cubes that hold every shortest
    /// curve.
    ///
    /// # Errors
    ///
    /// As for [`picture`](Question::picture).
    pub fn certified_picture(&self, answer: &CertifiedAnswer) -> Result<Scene, Failure> {
        let bounds = [answer.lower.value, answer.upper.value];
        let corridor = Corridor { levels: &answer.corridor, bounds };
        // Sets that touch have no corridor, and nothing is proved.
        let corridor = (!answer.corridor.is_empty()).then_some(corridor);
        self.drawn(&answer.curve, &answer.other_minima, corridor)
    }

    fn drawn(
        &self,
        curve: &[Vec<f64>],
        others: &[Vec<Vec<f64>>],
        corridor: Option<Corridor<'_>>,
    ) -> Result<Scene, Failure> {
        let gram = self.gram()?;
        let ends = self.ends.as_ref().map(|ends| {
            ends.each_ref().map(|end| end.iter().map(|piece| piece.shape.clone()).collect())
        });
        let ends: [Vec<Shape<ANY>>; 2] = ends.unwrap_or_default();
        let portrait = Portrait {
            ends: [&ends[0], &ends[1]],
            curve,
            others,
            corridor,
            coordinates: self.view.coordinates,
            field: self.view.field,
            window: self.view.window,
            ..Portrait::new(self.dimension, &*gram)
        };
        portrait.draw().map_err(|error: PortraitError| Failure::NotComputed(error.to_string()))
    }

    /// Returns the function `x ↦ H(x)`, column by column.
    fn gram(&self) -> Result<Gram, Diagnostic> {
        let formula = self.any_formula()?;
        Ok(Box::new(move |x| (x.len() == formula.dimension()).then(|| formula.gram_at(x))))
    }
}

/// A function from points to matrices, column by column.
type Gram = Box<dyn Fn(&[f64]) -> Option<Vec<f64>>>;
