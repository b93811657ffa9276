//! `Augmented`: the primal-dual augmented Lagrangian, and a step that lowers it.

use nalgebra::SVector;
use tautline::{ChordModel, LinearModel, PointSequence};

use crate::descent::{
    chord_models::chord_models,
    constrained::equality::{Contact, Equality, contacts},
    dynamic_programming::{Policy, SHORTEST},
    search::{Here, ROUNDING, SUFFICIENT, Search},
};

/// An iterate: inner points and their multipliers `λₙ`.
pub(crate) struct At<const D: usize> {
    /// The sequence with its energy and the gradient of the Lagrangian `E_N + Σ λₙ c(xₙ)`.
    pub(crate) here: Here<D>,
    pub(crate) contacts: Vec<Contact<D>>,
    pub(crate) multipliers: Vec<f64>,
}

impl<const D: usize> At<D> {
    /// Adds the constraint with its multipliers to a point of a descent.
    pub(crate) fn new(
        constraint: &impl Equality<D>,
        mut here: Here<D>,
        multipliers: Vec<f64>,
    ) -> Self {
        let contacts = contacts(constraint, &here.sequence);
        push(&mut here.model, &contacts, &multipliers);
        Self { here, contacts, multipliers }
    }

    /// Returns the largest `|c(xₙ)|`.
    pub(crate) fn violation(&self) -> f64 {
        let sizes = self.contacts.iter().map(|contact| contact.value.abs());
        // A NaN is no small violation.
        sizes.fold(0.0, |most, size| if size <= most || f64::is_nan(most) { most } else { size })
    }
}

/// Adds the forces `Σ wₙ ∇c(xₙ)` to a gradient.
fn push<const D: usize>(model: &mut LinearModel, contacts: &[Contact<D>], weights: &[f64]) {
    for (gradient, (contact, weight)) in
        model.gradient_mut()[1..].iter_mut().zip(contacts.iter().zip(weights))
    {
        *gradient += contact.slope * *weight;
    }
}

/// The estimates `λₙᵉ` of the multipliers and the penalty parameter `μ`: together they define
///
/// ```text
/// M(x, λ) = E_N(x) + Σₙ (λₙᵉ cₙ + cₙ²/2μ + μ (πₙ − λₙ)²/2),   πₙ = λₙᵉ + cₙ/μ
/// ```
///
/// Its minimum over `x` and `λ` is that of the augmented Lagrangian over `x`, with `λ = π`.
pub(crate) struct Augmented {
    pub(crate) centre: Vec<f64>,
    /// In the square of the unit of the constraint over `m²`.
    pub(crate) parameter: f64,
}

/// A step of points and multipliers.
pub(crate) struct Step<const D: usize> {
    points: Vec<SVector<f64, D>>,
    multipliers: Vec<f64>,
    /// The decrease of the quadratic model of `M`, in `m²`.
    pub(crate) decrease: f64,
}

impl Augmented {
    /// Returns `πₙ − λₙ`.
    fn gaps<const D: usize>(&self, at: &At<D>) -> Vec<f64> {
        let all = at.contacts.iter().zip(self.centre.iter().zip(&at.multipliers));
        all.map(|(contact, (centre, multiplier))| {
            contact.value / self.parameter + (centre - multiplier)
        })
        .collect()
    }

    /// Returns the residuals with the multipliers `λ` and with `π`, in one unit: both are small where
    /// `M` is stationary.
    pub(crate) fn residuals<const D: usize>(&self, search: &Search<'_, D>, at: &At<D>) -> [f64; 2] {
        let Here { sequence, model } = &at.here;
        let mut other = Here { sequence: sequence.clone(), model: model.clone() };
        push(&mut other.model, &at.contacts, &self.gaps(at));
        [search.residual(&at.here), search.residual(&other)]
    }

    /// Returns the models of the chords of `M` once the multipliers are eliminated, point by point:
    /// the gradient is that with `π`, and the second derivatives are those of the Lagrangian at `λ`
    /// with `∇cₙ∇cₙᵀ/μ` added. `None` if there is no metric at a node.
    pub(crate) fn chords<const D: usize>(
        &self,
        search: &mut Search<'_, D>,
        at: &At<D>,
    ) -> Option<Vec<ChordModel<D>>> {
        search.evaluations += 1;
        let mut chords = chord_models(search.metric, search.rule.nodes(), &at.here.sequence)?;
        for (chord, (contact, (multiplier, gap))) in
            chords.iter_mut().zip(at.contacts.iter().zip(at.multipliers.iter().zip(self.gaps(at))))
        {
            let Contact { slope, bend, .. } = contact;
            chord.gradient[1] += slope * (multiplier + gap);
            chord.hessian[1] += bend * *multiplier + slope * slope.transpose() / self.parameter;
        }
        Some(chords)
    }

    /// Returns the step of Newton's method for the conditions `∇E + Σ λₙ∇cₙ = 0` and
    /// `cₙ + μ (λₙᵉ − λₙ) = 0`, with `shift` added to the second derivatives with respect to each
    /// point; `None` if the model has no minimum.
    pub(crate) fn step<const D: usize>(
        &self,
        at: &At<D>,
        chords: &[ChordModel<D>],
        shift: f64,
    ) -> Option<Step<D>> {
        let policy = Policy::new(chords, shift)?;
        let (points, gaps) = (policy.displacements(), self.gaps(at));
        let along = at.contacts.iter().zip(&points);
        let pairs = gaps.iter().zip(along);
        let multipliers = pairs
            .map(|(gap, (contact, moved))| gap + contact.slope.dot(moved) / self.parameter)
            .collect();
        let gaps: f64 = gaps.iter().map(|gap| gap * gap).sum();
        let decrease = policy.decrease + 0.5 * self.parameter * gaps;
        Some(Step { points, multipliers, decrease })
    }

    /// Returns `M − E_N` at values of the constraint and multipliers.
    fn added(&self, values: impl Iterator<Item = f64>, multipliers: &[f64]) -> f64 {
        let terms = values.zip(self.centre.iter().zip(multipliers));
        terms
            .map(|(value, (centre, multiplier))| {
                let push = value / self.parameter;
                let gap = push + (centre - multiplier);
                value * (centre + 0.5 * push) + 0.5 * self.parameter * gap * gap
            })
            .sum()
    }

    /// Returns the error of `M` that rounding causes: that of its terms, and that of the values of
    /// the constraint times `∂M/∂cₙ = 2πₙ − λₙ`.
    pub(crate) fn rounding<const D: usize>(&self, at: &At<D>) -> f64 {
        let all = at.contacts.iter().zip(self.centre.iter().zip(&at.multipliers));
        let of_terms = all.map(|(contact, (centre, multiplier))| {
            let size = contact.value.abs();
            let push = size / self.parameter;
            let weight = 2.0 * (centre.abs() + push) + multiplier.abs();
            // What the gap rounds to, where the constraint holds and multipliers do not.
            let gap = push + (centre - multiplier).abs();
            weight * (size * ROUNDING + contact.rounding)
                + ROUNDING * 0.5 * self.parameter * gap * gap
        });
        at.here.energy() * ROUNDING + of_terms.sum::<f64>()
    }

    /// Takes a step, all of it or less, until `M` falls enough.
    pub(crate) fn follow<const D: usize>(
        &self,
        search: &mut Search<'_, D>,
        constraint: &impl Equality<D>,
        at: &At<D>,
        step: &Step<D>,
    ) -> Option<At<D>> {
        let values = at.contacts.iter().map(|contact| contact.value);
        let before = at.here.energy() + self.added(values, &at.multipliers);
        let rounding = self.rounding(at);
        let mut scale = 1.0;
        while scale >= SHORTEST {
            let points = at.here.moved(&step.points, scale);
            let steps = at.multipliers.iter().zip(&step.multipliers);
            let multipliers: Vec<f64> = steps.map(|(old, step)| old + step * scale).collect();
            let values = points[1..].iter().map(|x| constraint.value(x));
            let added = self.added(values, &multipliers);
            // The quadratic model falls by (2s − s²) times the decrease of the whole step.
            let promised = (2.0 * scale - scale * scale) * step.decrease;
            // A part that is negligible is no remedy for a step that does not descend.
            if scale < 1.0 && promised <= rounding {
                return None;
            }
            if let Some(energy) = search.energy(&points)
                && energy + added <= before + rounding - SUFFICIENT * promised
                && let Ok(sequence) = PointSequence::new(points)
            {
                // A positive energy does not yet mean that there is a metric.
                let there = search.at(sequence);
                if there.model.is_metric {
                    return Some(At::new(constraint, there, multipliers));
                }
            }
            scale *= 0.5;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use nalgebra::vector;
    use tautline::{Iterate, PointSequence, Prepared, Rule, gallery::Valleys};

    use super::{At, Augmented};
    use crate::descent::{
        Limits,
        constrained::equality::{Equality, tests::Circle},
        search::Search,
    };

    /// Along a step `p` of Newton's method with the matrix `B` the function `M` has the slope
    /// `−pᵀBp`, twice the decrease of its model, whatever the shift. A central difference of step `h
    /// = 10⁻⁴` has the error `h²/6` times a third derivative below 10⁴.
    #[test]
    fn the_decrease_is_that_of_the_function() {
        let metric = Prepared::new(Valleys);
        let points =
            vec![vector![1.0, 0.0], vector![0.9, 0.8], vector![-0.3, 0.7], vector![-1.0, 0.0]];
        let start = PointSequence::new(points).expect("finite");
        let watch = &mut |_: &Iterate<'_, 2>| ControlFlow::Continue(());
        let limits = Limits::default();
        let (mut search, here) =
            Search::begin(&metric, Rule::TRAPEZOIDAL, start, &limits, watch).expect("a metric");
        let at = At::new(&Circle, here, vec![0.7, -0.4]);
        let augmented = Augmented { centre: vec![-0.2, 0.5], parameter: 0.3 };
        let chords = augmented.chords(&mut search, &at).expect("a metric");
        for shift in [10.0, 100.0] {
            let step = augmented.step(&at, &chords, shift).expect("definite");
            let mut along = |scale: f64| {
                let points = at.here.moved(&step.points, scale);
                let steps = at.multipliers.iter().zip(&step.multipliers);
                let multipliers: Vec<f64> = steps.map(|(old, step)| old + step * scale).collect();
                let values = points[1..].iter().map(|x| Circle.value(x));
                let added = augmented.added(values, &multipliers);
                search.energy(&points).expect("a metric") + added
            };
            let slope = (along(1e-4) - along(-1e-4)) / 2e-4;
            let expected = -2.0 * step.decrease;
            assert!((slope - expected).abs() < 2e-5, "{slope} {expected}");
            assert!(expected < -1.0, "{expected}");
        }
    }

    /// Where a step promises more than it achieves, at any of its parts, it is no step: here the decrease of
    /// its model is claimed to be a million times as large.
    #[test]
    fn a_step_that_promises_too_much_is_not_taken() {
        let metric = Prepared::new(Valleys);
        let points = vec![vector![1.0, 0.0], vector![0.2, 0.9], vector![-1.0, 0.0]];
        let start = PointSequence::new(points).expect("finite");
        let watch = &mut |_: &Iterate<'_, 2>| ControlFlow::Continue(());
        let limits = Limits::default();
        let (mut search, here) =
            Search::begin(&metric, Rule::TRAPEZOIDAL, start, &limits, watch).expect("a metric");
        let at = At::new(&Circle, here, vec![0.0]);
        let augmented = Augmented { centre: vec![0.0], parameter: 0.3 };
        let chords = augmented.chords(&mut search, &at).expect("a metric");
        let mut step = augmented.step(&at, &chords, 10.0).expect("definite");
        assert!(augmented.follow(&mut search, &Circle, &at, &step).is_some());
        step.decrease *= 1e6;
        assert!(augmented.follow(&mut search, &Circle, &at, &step).is_none());
    }
}
