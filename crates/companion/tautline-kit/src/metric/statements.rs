//! The statements of the paper, checked on random cases of a metric.

use std::cell::RefCell;

use nalgebra::SVector;
use tautline::{Ends, MetricError, PointSequence};
use tautline_statements::{
    self as statements, AnyBounded, Evidence, Finding, Inequality, Known, LIBRARY, Source, Subject,
    TwoForms, VerifyError,
};

use super::{
    case::Case,
    problems::{Kind, Posed},
};
use crate::{
    Effort, Fault,
    margin::{IDLE, Margin},
    region::directions,
    report::{LawResult, Tried},
};

/// Returns the margin of the evidence, or the violated claim. The margin is idle if the evidence
/// could not have contradicted the statement. If the evidence consists of companions only, these
/// are tested.
pub(super) fn judge(evidence: &Evidence) -> Result<Margin, Fault> {
    let stated = evidence.conclusions.iter().any(|claim| claim.source == Source::Stated);
    let could_fail = match stated {
        true => evidence.could_fail(),
        false => evidence.conclusions.iter().any(Inequality::could_fail),
    };
    let (inequality, hypothesis) = match evidence.finding() {
        Finding::Holds => {
            let overestimation = if could_fail { evidence.overestimation() } else { IDLE };
            return Ok(Margin { overestimation, assumed: evidence.assumed.clone() });
        }
        Finding::Inapplicable(clause) => (*clause, true),
        Finding::Violated(claim) => (*claim, false),
    };
    Err(Fault::Statement { statement: evidence.statement, hypothesis, inequality })
}

/// Combines the margins of several pieces of evidence.
pub(super) fn judge_all(evidence: impl IntoIterator<Item = Evidence>) -> Result<Margin, Fault> {
    evidence.into_iter().try_fold(Margin::idle(), |all, one| Ok(all.and(judge(&one)?)))
}

/// A statement about a metric and another argument of type `T`.
type About<'m, T, const D: usize> =
    fn(&Subject, &AnyBounded<'m, D>, &T) -> Result<Evidence, MetricError>;

/// A statement about two points with a known distance, and the inner points of a sequence between
/// them.
type OfKnown<'m, const D: usize> = fn(
    &Subject,
    &Known<&AnyBounded<'m, D>, D>,
    &[SVector<f64, D>],
) -> Result<Evidence, VerifyError>;

/// Returns the point sequence from one known point to the other through the given inner points.
pub(super) fn joined<M, const D: usize>(
    known: &Known<M, D>,
    inner: &[SVector<f64, D>],
) -> Result<PointSequence<D>, VerifyError> {
    let [a, b] =
        [known.ends.first(), known.ends.second()].map(|set| set.project(&SVector::zeros()));
    let points = [a].into_iter().chain(inner.iter().copied()).chain([b]).collect();
    Ok(PointSequence::new(points)?)
}

impl<'m, const D: usize> Case<'m, D> {
    /// Checks a statement about the metric at a point.
    ///
    /// The points are never special ones: the statements take steps in all directions, and some
    /// claims hold in the region only.
    pub(super) fn of_points(&self, statement: About<'m, SVector<f64, D>, D>) -> LawResult {
        self.effort.for_all(self.region.uniform(), |x| {
            judge(&statement(&LIBRARY, &self.metric, x).map_err(VerifyError::from)?)
        })
    }

    /// Checks Proposition 7.5 at two points, for a unit vector and another vector. Both sides are
    /// homogeneous of degree 2 in the vectors.
    ///
    /// The distance between the vectors is between `2⁻¹²` and 4, so that each of the three terms of
    /// the bound is the largest in some samples.
    pub(super) fn of_two_forms(&self) -> LawResult {
        let samples = (self.region.pairs(), directions::<D>(), directions::<D>(), -2..=12_i32);
        self.effort.for_all(samples, |(points, u, w, halvings)| {
            let vectors = [*u, u + w * 0.5_f64.powi(*halvings)];
            let forms = TwoForms::of(&LIBRARY, &self.metric, *points, vectors);
            judge(&statements::prop_7_5(&forms.map_err(VerifyError::from)?))
        })
    }

    /// Checks a statement about any point sequence, with `N` from 1 to 8; the bounds are sharpest
    /// for few subintervals.
    pub(super) fn of_point_sequences(
        &self,
        statement: About<'m, PointSequence<D>, D>,
    ) -> LawResult {
        let points = proptest::collection::vec(self.region.points(), 2..=9);
        self.effort.for_all(points, |points| {
            let sequence = PointSequence::new(points.clone()).map_err(VerifyError::from)?;
            judge(&statement(&LIBRARY, &self.metric, &sequence).map_err(VerifyError::from)?)
                .map_err(|fault| self.explained(fault, points))
        })
    }

    /// Checks a statement about two points, their distance, and the inner points of a sequence
    /// between them, with `N` from 1 to 8.
    ///
    /// Half of the samples lie between the points of the theorems' problems. The other half, if the
    /// metric knows distances, lie between random points.
    pub(super) fn of_known(&self, statement: OfKnown<'m, D>) -> LawResult {
        self.solvable()?;
        let ends = &self.ends;
        let inner = || proptest::collection::vec(self.region.points(), 0..=7);
        let problems = self.effort.problems.div_ceil(Kind::ALL.len() as u32);
        let posed: RefCell<Vec<Posed<D>>> = RefCell::default();
        let effort = Effort { problems, ..self.effort };
        effort.for_all_problems(Posed::problems(Kind::Points, ends), |problem| {
            posed.borrow_mut().push(*problem);
            Ok(f64::INFINITY)
        })?;
        let half = Effort { cases: self.effort.cases.div_ceil(2), ..self.effort };
        let few = Effort { cases: half.cases.div_ceil(problems), ..half };
        let mut tried = Tried::cases(0);
        for posed in posed.into_inner() {
            let known = match self.known(&posed, &[]) {
                Ok(known) => known,
                // If this happens for most problems, the theorems fail.
                Err(VerifyError::NotConverged { .. }) => continue,
                Err(error) => return Err(self.effort.failure(error)),
            };
            let law = |inner: &Vec<_>| judge(&statement(&LIBRARY, &known, inner)?);
            tried = tried.and(few.for_all(inner(), law)?);
        }
        let Some(distance) = &self.distance else { return Ok(tried) };
        let pairs = (ends.uniform(), ends.uniform(), inner());
        Ok(tried.and(half.for_all(pairs, |(a, b, inner)| {
            let Some(distance) = distance(a, b) else { return Ok(Margin::idle()) };
            let ends = Ends::points(*a, *b).map_err(VerifyError::from)?;
            judge(&statement(&LIBRARY, &self.exact([*a, *b], ends, distance), inner)?)
        })?))
    }
}
