//! The statements of the paper, on random cases of one metric.

use std::cell::{Cell, RefCell};

use nalgebra::SVector;
use tautline::{Bounded, Ends, MetricError, PointSequence};

use super::{
    MetricCase,
    memory::Minimisers,
    problems::{Kind, Posed},
};
use crate::{
    Evidence, Finding, Known, Library, PaperRule, Reconstruction, VerifyError,
    kit::{
        Effort, Failure, Fault,
        report::{Tried, Verdict},
        sampling::{CHEAP, COSTLY, for_all},
    },
    statements,
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

/// What a statement says of a metric and something `T` besides.
type About<M, T> = fn(&Library, &M, &T) -> Result<Evidence, MetricError>;

/// What a statement says of two points with their distance, and of the inner points of a sequence
/// between them.
type OfKnown<M, const D: usize> =
    fn(&Library, &Known<&M, D>, &[SVector<f64, D>]) -> Result<Evidence, VerifyError>;

/// What a statement says of a minimiser.
type OfMinimisers<const D: usize> = fn(&Library, &Reconstruction<D>) -> Evidence;

/// Remark 9.2, on the minimisers of both rules.
pub(super) fn remark_9_2<M: Bounded<D>, const D: usize>(case: &MetricCase<M, D>) -> Verdict {
    let of = |rule| case.of_minimisers(rule, statements::remark_9_2);
    Ok(of(PaperRule::Trapezoidal)?.and(of(PaperRule::LeftEndpoint)?))
}

/// The point sequence from one point over others to another.
pub(super) fn joined<M, const D: usize>(
    known: &Known<M, D>,
    inner: &[SVector<f64, D>],
) -> Result<PointSequence<D>, VerifyError> {
    let [a, b] =
        [known.ends.first(), known.ends.second()].map(|set| set.project(&SVector::zeros()));
    let points = [a].into_iter().chain(inner.iter().copied()).chain([b]).collect();
    Ok(PointSequence::new(points)?)
}

impl<M: Bounded<D>, const D: usize> MetricCase<M, D> {
    /// Evaluates a statement about the metric at a point.
    pub(super) fn of_points(&self, statement: About<M, SVector<f64, D>>) -> Verdict {
        let effort = &self.effort;
        for_all(effort, effort.cases, CHEAP, self.region.points(), |x| {
            judge(&statement(&Library, &self.metric, x).map_err(VerifyError::from)?)
        })
    }

    /// Evaluates a statement about any point sequence, with `N` from 1 to 8: the bounds are
    /// sharpest for few subintervals.
    pub(super) fn of_point_sequences(&self, statement: About<M, PointSequence<D>>) -> Verdict {
        let effort = &self.effort;
        let points = proptest::collection::vec(self.region.points(), 2..=9);
        for_all(effort, effort.cases, CHEAP, points, |points| {
            let sequence = PointSequence::new(points.clone()).map_err(VerifyError::from)?;
            judge(&statement(&Library, &self.metric, &sequence).map_err(VerifyError::from)?)
        })
    }

    /// Evaluates a statement about two points, their distance, and the inner points of a sequence
    /// between them, with `N` from 1 to 8.
    ///
    /// The two points are those of the problems of the theorems, and besides, if the metric knows
    /// distances, random pairs. Each of both has half of the samples.
    pub(super) fn of_known(&self, statement: OfKnown<M, D>) -> Verdict {
        let (region, effort) = (&self.region, &self.effort);
        let inner = || proptest::collection::vec(region.points(), 0..=7);
        let problems = effort.problems.div_ceil(Kind::ALL.len() as u32);
        let cases = effort.cases.div_ceil(2);
        let posed: RefCell<Vec<Posed<D>>> = RefCell::default();
        for_all(effort, problems, 0, Posed::problems(Kind::Points, region), |problem| {
            posed.borrow_mut().push(*problem);
            Ok(f64::INFINITY)
        })?;
        let mut tried = Tried::cases(0);
        for posed in posed.into_inner() {
            let known = match self.known(&posed, &[]) {
                Ok(known) => known,
                // There are others, and the theorems say so if most are like that.
                Err(VerifyError::NotConverged { .. }) => continue,
                Err(error) => {
                    return Err(Failure { fault: error.into(), sample: None, seed: effort.seed });
                }
            };
            tried =
                tried.and(for_all(effort, cases.div_ceil(problems), CHEAP, inner(), |inner| {
                    judge(&statement(&Library, &known, inner)?)
                })?);
        }
        let Some(distance) = self.distance else { return Ok(tried) };
        let pairs = (region.points(), region.points(), inner());
        Ok(tried.and(for_all(effort, cases, CHEAP, pairs, |(a, b, inner)| {
            let Some(distance) = distance(&self.metric, a, b) else { return Ok(f64::INFINITY) };
            let ends = Ends::points(*a, *b).map_err(VerifyError::from)?;
            judge(&statement(&Library, &self.told([*a, *b], ends, distance), inner)?)
        })?))
    }

    /// Evaluates a statement about minimisers of a rule, between sets of every kind and for every
    /// `N` of the effort.
    ///
    /// That the solver gets stuck is no fault of the metric; if it does for most problems, nothing
    /// was tested, and that is a fault.
    pub(super) fn of_minimisers(&self, rule: PaperRule, statement: OfMinimisers<D>) -> Verdict {
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

    /// The minimisers of one problem for every `N` of the effort, from memory if they are there.
    fn minimisers(&self, rule: PaperRule, posed: &Posed<D>) -> Minimisers<D> {
        let memory = match rule {
            PaperRule::Trapezoidal => &self.solved.trapezoidal,
            PaperRule::LeftEndpoint => &self.solved.left,
        };
        memory.recall(posed, || Ok(self.solve(rule, posed)?.into()))
    }

    fn solve(
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
