//! Random problems with a known distance, and statements about their computed minimisers.

use std::fmt::Debug;

use proptest::prelude::*;
use tautline::Bounded;
use tautline_statements::{Evidence, Known, PaperRule, Reconstruction, Subject, VerifyError};

use crate::battery::harness::{Outcome, Trial, all};
use crate::strategies::{
    constant, constant_ball_half_space, constant_finite_sets, gaussian_fisher_nearby,
    hyperbolic_nearby, points, ramp, separable, separable_box_half_space, separable_boxes, shear,
    shear_ball_half_plane, sphere_nearby, subintervals, valleys_across, valleys_along,
    valleys_ball_half_space,
};

/// Statements about a computed minimiser, in any dimension.
pub(crate) trait Question: Copy {
    /// Evaluates the statements.
    fn evidence<M: Bounded<D>, const D: usize>(
        self,
        subject: &Subject,
        known: &Known<M, D>,
        seen: &Reconstruction<D>,
    ) -> Result<Vec<Evidence>, VerifyError>;
}

/// Random problems, solved with one rule.
#[derive(Clone, Copy)]
pub(crate) struct Problems<Q> {
    pub(crate) rule: PaperRule,
    pub(crate) seed: u64,
    /// The number by which the numbers of cases below are divided.
    pub(crate) one_in: u32,
    pub(crate) question: Q,
}

impl<Q: Question> Problems<Q> {
    fn solved<M, const D: usize>(
        self,
        trial: &Trial<'_>,
        k: u64,
        cases: u32,
        problems: impl Strategy<Value = Known<M, D>> + 'static,
    ) -> Outcome
    where
        M: Bounded<D> + Clone + Debug + 'static,
    {
        let cases = cases / self.one_in;
        trial.for_all(self.seed + k, cases, (problems, subintervals()), |subject, (known, n)| {
            let seen = Reconstruction::observe(subject, &known, self.rule, n)?;
            self.question.evidence(subject, &known, &seen)
        })
    }

    /// Evaluates the statements on problems between two points.
    ///
    /// On the line, along the valleys and under a constant metric, all curves that do not turn back
    /// have the same length. Theorems 1.2 and 1.4 cannot fail there, so that there are only a few
    /// of these cases.
    pub(crate) fn between_points(self, trial: &Trial<'_>) -> Outcome {
        all([
            self.solved(trial, 0, 64, points(constant::<2>())),
            self.solved(trial, 1, 64, points(constant::<4>())),
            self.solved(trial, 2, 640, points(shear())),
            self.solved(trial, 3, 96, points(separable::<1>())),
            self.solved(trial, 4, 448, points(separable::<2>())),
            self.solved(trial, 5, 384, points(separable::<3>())),
            self.solved(trial, 6, 192, points(separable::<5>())),
            self.solved(trial, 7, 96, points(ramp())),
            self.solved(trial, 8, 64, valleys_along()),
            self.solved(trial, 9, 384, valleys_across::<2>()),
            self.solved(trial, 10, 128, valleys_across::<3>()),
        ])
    }

    /// Evaluates the statements on problems between two sets. Again there are only a few cases in
    /// which the geodesic runs along an axis.
    pub(crate) fn between_sets(self, trial: &Trial<'_>) -> Outcome {
        all([
            self.solved(trial, 0, 64, constant_ball_half_space::<2>()),
            self.solved(trial, 1, 64, constant_ball_half_space::<3>()),
            // For a constant metric the bounds are 0, so that only the nearest pair satisfies them.
            self.solved(trial, 2, 96, constant_finite_sets()),
            self.solved(trial, 3, 448, shear_ball_half_plane()),
            self.solved(trial, 4, 64, separable_box_half_space::<2>()),
            self.solved(trial, 5, 64, separable_box_half_space::<3>()),
            self.solved(trial, 6, 64, separable_boxes::<1>()),
            self.solved(trial, 7, 416, separable_boxes::<2>()),
            self.solved(trial, 8, 384, separable_boxes::<3>()),
            self.solved(trial, 9, 64, valleys_ball_half_space()),
        ])
    }

    /// Evaluates the statements between nearby points, with the constants of a ball that contains
    /// all competitors.
    pub(crate) fn on_balls(self, trial: &Trial<'_>) -> Outcome {
        all([
            self.solved(trial, 0, 128, sphere_nearby::<1>()),
            self.solved(trial, 1, 256, sphere_nearby::<2>()),
            self.solved(trial, 2, 128, sphere_nearby::<3>()),
            self.solved(trial, 3, 256, hyperbolic_nearby::<2>()),
            self.solved(trial, 4, 256, gaussian_fisher_nearby()),
        ])
    }

    /// Evaluates the statements in two systems of units.
    pub(crate) fn homogeneous(self, trial: &Trial<'_>) -> Outcome {
        all([
            self.in_units(trial, 0, shear_ball_half_plane()),
            self.in_units(trial, 1, separable_boxes::<3>()),
            self.in_units(trial, 2, points(ramp())),
            self.in_units(trial, 3, gaussian_fisher_nearby()),
        ])
    }

    fn in_units<M, const D: usize>(
        self,
        trial: &Trial<'_>,
        k: u64,
        problems: impl Strategy<Value = Known<M, D>> + 'static,
    ) -> Outcome
    where
        M: Bounded<D> + Clone + Debug + 'static,
    {
        let cases = (problems, subintervals());
        trial.homogeneous(self.seed + k, 64, cases, |subject, (known, n), units| {
            let known = units.known(known)?;
            let seen = Reconstruction::observe(subject, &known, self.rule, n)?;
            self.question.evidence(subject, &known, &seen)
        })
    }
}
