//! The statements of the paper, on random cases of one metric.

use std::cell::{Cell, RefCell};

use nalgebra::SVector;
use tautline::{Bounded, PointSequence};

use super::{
    MetricCase,
    problems::{Kind, Posed},
};
use crate::{
    Evidence, Finding, Library, PaperRule, Reconstruction, VerifyError,
    kit::{
        Effort, Failure, Fault,
        report::{Tried, Verdict},
        sampling::{CHEAP, COSTLY, for_all},
    },
};

/// The slack of an evidence, or what of it does not hold.
fn judge(evidence: &Evidence) -> Result<f64, Fault> {
    let (inequality, hypothesis) = match evidence.finding() {
        Finding::Holds => return Ok(evidence.slack()),
        Finding::Inapplicable(clause) => (*clause, true),
        Finding::Violated(claim) => (*claim, false),
    };
    Err(Fault::Statement { statement: evidence.statement, hypothesis, inequality })
}

impl<M: Bounded<D>, const D: usize> MetricCase<M, D> {
    /// Evaluates a statement about the metric at a point.
    #[allow(dead_code, reason = "for the rows of statements about Christoffel symbols")]
    pub(super) fn of_points<E: Into<VerifyError>>(
        &self,
        statement: impl Fn(&Library, &M, &SVector<f64, D>) -> Result<Evidence, E>,
    ) -> Verdict {
        let effort = &self.effort;
        for_all(effort, effort.cases, CHEAP, self.region.points(), |x| {
            judge(&statement(&Library, &self.metric, x).map_err(Into::into)?)
        })
    }

    /// Evaluates a statement about any point sequence, with `N` from 1 to 16.
    pub(super) fn of_point_sequences<E: Into<VerifyError>>(
        &self,
        statement: impl Fn(&Library, &M, &PointSequence<D>) -> Result<Evidence, E>,
    ) -> Verdict {
        let effort = &self.effort;
        let points = proptest::collection::vec(self.region.points(), 2..=17);
        for_all(effort, effort.cases, CHEAP, points, |points| {
            let sequence = PointSequence::new(points.clone()).map_err(VerifyError::from)?;
            judge(&statement(&Library, &self.metric, &sequence).map_err(Into::into)?)
        })
    }

    /// Evaluates a statement about minimisers of a rule, between sets of every kind and for every
    /// `N` of the effort.
    ///
    /// That the solver gets stuck is no fault of the metric; if it does for most problems, nothing
    /// was tested, and that is a fault.
    pub(super) fn of_minimisers(
        &self,
        rule: PaperRule,
        statement: impl Fn(&Library, &Reconstruction<D>) -> Evidence,
    ) -> Verdict {
        let cases = self.effort.problems.div_ceil(Kind::ALL.len() as u32);
        let failed = Cell::new(0_u64);
        let last: RefCell<Option<VerifyError>> = RefCell::default();
        let mut tried = Tried::cases(0);
        for (offset, kind) in Kind::ALL.into_iter().enumerate() {
            let effort =
                Effort { seed: self.effort.seed.wrapping_add(offset as u64), ..self.effort };
            let problems = Posed::problems(kind, &self.region);
            let one = for_all(&effort, cases, COSTLY, problems, |posed| {
                match self.minimisers(rule, posed) {
                    Ok(all) => all.iter().try_fold(f64::INFINITY, |slack: f64, seen| {
                        Ok(slack.min(judge(&statement(&Library, seen))?))
                    }),
                    Err(error @ VerifyError::NotConverged { .. }) => {
                        failed.set(failed.get() + 1);
                        last.replace(Some(error));
                        Ok(f64::INFINITY)
                    }
                    Err(error) => Err(error.into()),
                }
            })?;
            tried = tried.and(one);
        }
        let failed = failed.get();
        if let Some(error) = last.into_inner() {
            if 2 * failed > tried.cases {
                let fault = Fault::NotSolved { failed, tried: tried.cases, error };
                return Err(Failure { fault, sample: None, seed: self.effort.seed });
            }
            tried = tried.with_note(format!("{failed} problems without a minimum"));
        }
        tried.cases = (tried.cases - failed) * self.effort.subintervals.len() as u64;
        Ok(tried)
    }

    /// The minimisers of one problem for every `N` of the effort.
    fn minimisers(
        &self,
        rule: PaperRule,
        posed: &Posed<D>,
    ) -> Result<Vec<Reconstruction<D>>, VerifyError> {
        let observe = |known| {
            let numbers = self.effort.subintervals.iter();
            numbers.map(|&n| Reconstruction::observe(&Library, &known, rule, n)).collect()
        };
        let known = self.known(posed, &[])?;
        let all: Vec<Reconstruction<D>> = observe(known)?;
        // A grid may lead to a shorter curve than the one by which the distance was estimated.
        if all.iter().all(|seen| seen.energy.value + seen.granted >= seen.distance_squared) {
            return Ok(all);
        }
        observe(self.known(posed, &all)?)
    }
}
