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

/// Statements about one computed minimiser, in any dimension.
pub(crate) trait Question: Copy {
    /// Evaluates the statements.
    fn evidence<M: Bounded<D>, const D: usize>(
        self,
        subject: &Subject,
        known: &Known<M, D>,
        seen: &Reconstruction<D>,
    ) -> Result<Vec<Evidence>, VerifyError>;
}

/// Random problems, solved by one rule.
#[derive(Clone, Copy)]
pub(crate) struct Problems<Q> {
    pub(crate) rule: PaperRule,
    pub(crate) seed: u64,
    /// Divides the numbers of cases below.
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

    /// Between two points.
    ///
    /// On the line, along the valleys and under a constant metric, all curves that do not turn back
    /// have the same length. There Theorems 1.2 and 1.4 cannot fail, so these cases are few.
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

    /// From set to set; again with few cases where the way leads along an axis.
    pub(crate) fn between_sets(self, trial: &Trial<'_>) -> Outcome {
        all([
            self.solved(trial, 0, 64, constant_ball_half_space::<2>()),
            self.solved(trial, 1, 64, constant_ball_half_space::<3>()),
            // The bounds are 0 for a constant metric: only the nearest pair will do.
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

    /// Between nearby points, with the constants of a ball that holds all competitors.
    pub(crate) fn on_balls(self, trial: &Trial<'_>) -> Outcome {
        all([
            self.solved(trial, 0, 128, sphere_nearby::<1>()),
            self.solved(trial, 1, 256, sphere_nearby::<2>()),
            self.solved(trial, 2, 128, sphere_nearby::<3>()),
            self.solved(trial, 3, 256, hyperbolic_nearby::<2>()),
            self.solved(trial, 4, 256, gaussian_fisher_nearby()),
        ])
    }

    /// In two systems of units.
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
