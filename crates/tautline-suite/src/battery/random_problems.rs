//! Random problems with a known distance, and what is asked of their computed minimisers.

use std::fmt::Debug;

use proptest::prelude::*;
use tautline::Bounded;
use tautline_statements::{Evidence, Known, PaperRule, Reconstruction, Subject, VerifyError};

use super::{Outcome, Trial, check::all};
use crate::strategies::{
    constant, constant_ball_half_space, constant_finite_sets, gaussian_fisher_nearby,
    hyperbolic_nearby, points, ramp, separable, separable_box_half_space, separable_boxes, shear,
    shear_ball_half_plane, sphere_nearby, subintervals, valleys_across, valleys_along,
    valleys_ball_half_space,
};

/// What is asked of one computed minimiser, in any dimension.
pub(super) trait Question: Copy {
    /// Evaluates statements on it.
    fn evidence<M: Bounded<D>, const D: usize>(
        self,
        subject: &Subject,
        known: &Known<M, D>,
        seen: &Reconstruction<D>,
    ) -> Result<Vec<Evidence>, VerifyError>;
}

/// Problems of one family, solved by one rule.
#[derive(Clone, Copy)]
pub(super) struct Problems<Q> {
    pub(super) rule: PaperRule,
    pub(super) seed: u64,
    /// Of the cases below, one in so many is tried.
    pub(super) one_in: u32,
    pub(super) question: Q,
}

impl<Q> Problems<Q> {
    fn family<M, const D: usize>(
        self,
        trial: &Trial<'_>,
        k: u64,
        cases: u32,
        family: impl Strategy<Value = Known<M, D>>,
    ) -> Outcome
    where
        M: Bounded<D> + Clone + Debug + 'static,
        Q: Question,
    {
        let cases = cases / self.one_in;
        trial.for_all(self.seed + k, cases, (family, subintervals()), |subject, (known, n)| {
            let seen = Reconstruction::observe(subject, &known, self.rule, n)?;
            self.question.evidence(subject, &known, &seen)
        })
    }

    /// Between two points.
    ///
    /// On the line, along the valleys and under a constant metric all curves that do not turn back
    /// have the same length: there Theorems 1.2 and 1.4 cannot fail, so that these are few.
    pub(super) fn between_points(self, trial: &Trial<'_>) -> Outcome
    where
        Q: Question,
    {
        all([
            self.family(trial, 0, 64, points(constant::<2>())),
            self.family(trial, 1, 64, points(constant::<4>())),
            self.family(trial, 2, 640, points(shear())),
            self.family(trial, 3, 96, points(separable::<1>())),
            self.family(trial, 4, 448, points(separable::<2>())),
            self.family(trial, 5, 384, points(separable::<3>())),
            self.family(trial, 6, 192, points(separable::<5>())),
            self.family(trial, 7, 96, points(ramp())),
            self.family(trial, 8, 64, valleys_along()),
            self.family(trial, 9, 384, valleys_across::<2>()),
            self.family(trial, 10, 128, valleys_across::<3>()),
        ])
    }

    /// From set to set; as between points, few where the way leads along an axis.
    pub(super) fn between_sets(self, trial: &Trial<'_>) -> Outcome
    where
        Q: Question,
    {
        all([
            self.family(trial, 0, 64, constant_ball_half_space::<2>()),
            self.family(trial, 1, 64, constant_ball_half_space::<3>()),
            // The bounds are 0 for a constant metric, so that no pair but the nearest will do.
            self.family(trial, 2, 96, constant_finite_sets()),
            self.family(trial, 3, 448, shear_ball_half_plane()),
            self.family(trial, 4, 64, separable_box_half_space::<2>()),
            self.family(trial, 5, 64, separable_box_half_space::<3>()),
            self.family(trial, 6, 64, separable_boxes::<1>()),
            self.family(trial, 7, 416, separable_boxes::<2>()),
            self.family(trial, 8, 384, separable_boxes::<3>()),
            self.family(trial, 9, 64, valleys_ball_half_space()),
        ])
    }

    /// Between two points near each other, with the constants of a ball that holds all competitors.
    pub(super) fn on_balls(self, trial: &Trial<'_>) -> Outcome
    where
        Q: Question,
    {
        all([
            self.family(trial, 0, 128, sphere_nearby::<1>()),
            self.family(trial, 1, 256, sphere_nearby::<2>()),
            self.family(trial, 2, 128, sphere_nearby::<3>()),
            self.family(trial, 3, 256, hyperbolic_nearby::<2>()),
            self.family(trial, 4, 256, gaussian_fisher_nearby()),
        ])
    }

    /// In two systems of units each.
    pub(super) fn homogeneous(self, trial: &Trial<'_>) -> Outcome
    where
        Q: Question,
    {
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
        family: impl Strategy<Value = Known<M, D>>,
    ) -> Outcome
    where
        M: Bounded<D> + Clone + Debug + 'static,
        Q: Question,
    {
        let cases = (family, subintervals());
        trial.homogeneous(self.seed + k, 64, cases, |subject, (known, n), units| {
            let known = units.known(known)?;
            let seen = Reconstruction::observe(subject, &known, self.rule, n)?;
            self.question.evidence(subject, &known, &seen)
        })
    }
}
