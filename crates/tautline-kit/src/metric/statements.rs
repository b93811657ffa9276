//! The statements of the paper, on random cases of one metric.

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
    Failure, Fault,
    met::{IDLE, Met},
    region::directions,
    report::{LawResult, Tried},
    sampling::{CHEAP, for_all},
};

/// What a law meets in an evidence, which is idle if it could not have contradicted the statement,
/// or what of it does not hold. Where there are companions alone, it is these that are tried.
pub(super) fn judge(evidence: &Evidence) -> Result<Met, Fault> {
    let stated = evidence.conclusions.iter().any(|claim| claim.source == Source::Stated);
    let could_fail = match stated {
        true => evidence.could_fail(),
        false => evidence.conclusions.iter().any(Inequality::could_fail),
    };
    let met = |overestimation| Ok(Met { overestimation, assumed: evidence.assumed.clone() });
    let (inequality, hypothesis) = match evidence.finding() {
        Finding::Holds if could_fail => return met(evidence.overestimation()),
        Finding::Holds => return met(IDLE),
        Finding::Inapplicable(clause) => (*clause, true),
        Finding::Violated(claim) => (*claim, false),
    };
    Err(Fault::Statement { statement: evidence.statement, hypothesis, inequality })
}

/// What a statement says of a metric and something `T` besides.
type About<'m, T, const D: usize> =
    fn(&Subject, &AnyBounded<'m, D>, &T) -> Result<Evidence, MetricError>;

/// What a statement says of two points with their distance, and of the inner points of a sequence
/// between them.
type OfKnown<'m, const D: usize> = fn(
    &Subject,
    &Known<&AnyBounded<'m, D>, D>,
    &[SVector<f64, D>],
) -> Result<Evidence, VerifyError>;

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

impl<'m, const D: usize> Case<'m, D> {
    /// Evaluates a statement about the metric at a point.
    ///
    /// None is special: the statements step to all sides, and some claims hold in the region alone.
    pub(super) fn of_points(&self, statement: About<'m, SVector<f64, D>, D>) -> LawResult {
        let effort = &self.effort;
        for_all(effort, effort.cases, CHEAP, self.region.uniform(), |x| {
            judge(&statement(&LIBRARY, &self.metric, x).map_err(VerifyError::from)?)
        })
    }

    /// Evaluates Proposition 7.5 at two points, for a unit vector and another one: both sides are
    /// of degree 2 in the vectors.
    ///
    /// The other is at a distance from 4 to `2⁻¹²`, so that each of the three terms of the bound is
    /// the largest one in some of the samples.
    pub(super) fn of_two_forms(&self) -> LawResult {
        let effort = &self.effort;
        let samples = (self.region.pairs(), directions::<D>(), directions::<D>(), -2..=12_i32);
        for_all(effort, effort.cases, CHEAP, samples, |(points, u, w, halvings)| {
            let vectors = [*u, u + w * 0.5_f64.powi(*halvings)];
            let forms = TwoForms::of(&LIBRARY, &self.metric, *points, vectors);
            judge(&statements::prop_7_5(&forms.map_err(VerifyError::from)?))
        })
    }

    /// Evaluates a statement about any point sequence, with `N` from 1 to 8: the bounds are
    /// sharpest for few subintervals.
    pub(super) fn of_point_sequences(
        &self,
        statement: About<'m, PointSequence<D>, D>,
    ) -> LawResult {
        let effort = &self.effort;
        let points = proptest::collection::vec(self.region.points(), 2..=9);
        for_all(effort, effort.cases, CHEAP, points, |points| {
            let sequence = PointSequence::new(points.clone()).map_err(VerifyError::from)?;
            judge(&statement(&LIBRARY, &self.metric, &sequence).map_err(VerifyError::from)?)
                .map_err(|fault| self.explained(fault, points))
        })
    }

    /// Evaluates a statement about two points, their distance, and the inner points of a sequence
    /// between them, with `N` from 1 to 8.
    ///
    /// The two points are those of the problems of the theorems, and besides, if the metric knows
    /// distances, random pairs. Each of both has half of the samples.
    pub(super) fn of_known(&self, statement: OfKnown<'m, D>) -> LawResult {
        self.solvable()?;
        let (ends, effort) = (&self.ends, &self.effort);
        let inner = || proptest::collection::vec(self.region.points(), 0..=7);
        let problems = effort.problems.div_ceil(Kind::ALL.len() as u32);
        let cases = effort.cases.div_ceil(2);
        let posed: RefCell<Vec<Posed<D>>> = RefCell::default();
        for_all(effort, problems, 0, Posed::problems(Kind::Points, ends), |problem| {
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
                    judge(&statement(&LIBRARY, &known, inner)?)
                })?);
        }
        let Some(distance) = &self.distance else { return Ok(tried) };
        let pairs = (ends.uniform(), ends.uniform(), inner());
        Ok(tried.and(for_all(effort, cases, CHEAP, pairs, |(a, b, inner)| {
            let Some(distance) = distance(a, b) else { return Ok(Met::nothing()) };
            let ends = Ends::points(*a, *b).map_err(VerifyError::from)?;
            judge(&statement(&LIBRARY, &self.told([*a, *b], ends, distance), inner)?)
        })?))
    }
}
