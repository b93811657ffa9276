//! The solved problems of a metric: the minimisers, and the curves with which they are compared.

use std::cell::{Cell, RefCell};

use nalgebra::SVector;
use tautline::{ClosedSet, Options, PointSequence, Starts, minimise};
use tautline_statements::{
    AnyBounded, Evidence, Known, LIBRARY, PaperRule, Reconstruction, Subject, VerifyError,
};

use super::{
    case::Case,
    formula::winding,
    memory::{Solution, Solutions},
    problems::{Kind, Posed},
    statements::judge,
};
use crate::{
    Effort, Fault,
    margin::Margin,
    report::{LawResult, Tried},
};

/// A statement about a minimiser.
type OfMinimisers<const D: usize> = fn(&Subject, &Reconstruction<D>) -> Evidence;

/// One minimiser of a solved problem.
pub(super) struct Minimiser<'a, const D: usize> {
    pub(super) posed: &'a Posed<D>,
    pub(super) known: &'a Known<&'a AnyBounded<'a, D>, D>,
    pub(super) seen: &'a Reconstruction<D>,
}

impl<const D: usize> Minimiser<'_, D> {
    /// Returns a detour with the same number of subintervals. It passes through a third point and
    /// joins the members of the two sets that are nearest to this point.
    pub(super) fn detour(&self) -> Result<PointSequence<D>, VerifyError> {
        let via = self.posed.further();
        let [a, b] = self.sets().map(|set| set.project(&via));
        let n = self.seen.n.get();
        let points = (0..=n).map(|k| {
            let t = 2.0 * k as f64 / n as f64;
            if t <= 1.0 { a + (via - a) * t } else { via + (b - via) * (t - 1.0) }
        });
        admissible(self.sets(), points.collect())
    }

    /// Returns the minimiser with each point moved by less than a 64th of its mean step.
    pub(super) fn moved(&self) -> Result<PointSequence<D>, VerifyError> {
        let step = self.seen.k3 / (64.0 * self.seen.n.get() as f64 * (D as f64).sqrt());
        let points = self.seen.minimum.sequence.points().iter().zip(1_u32..);
        let moved = points.map(|(x, n)| {
            x + SVector::from_fn(|i, _| step * (2.0 * (f64::from(n) * winding(i)).fract() - 1.0))
        });
        admissible(self.sets(), moved.collect())
    }

    /// Returns the result of a search that may also start from another sequence.
    pub(super) fn again(&self, other: &PointSequence<D>) -> Result<PointSequence<D>, VerifyError> {
        let options = Options { starts: Starts::Also(vec![other.clone()]), ..Options::default() };
        let Known { metric, ends, .. } = self.known;
        let n = self.seen.n.get();
        Ok(minimise(metric, ends, self.seen.rule.into(), n, &options)?.sequence)
    }

    pub(super) fn sets(&self) -> [&dyn ClosedSet<D>; 2] {
        [&**self.known.ends.first(), &**self.known.ends.second()]
    }
}

/// Returns the sequence of these points, with its ends projected to the sets.
fn admissible<const D: usize>(
    sets: [&dyn ClosedSet<D>; 2],
    mut points: Vec<SVector<f64, D>>,
) -> Result<PointSequence<D>, VerifyError> {
    if let [first, .., last] = points.as_mut_slice() {
        (*first, *last) = (sets[0].project(first), sets[1].project(last));
    }
    Ok(PointSequence::new(points)?)
}

/// Fails if more than half of the problems were not solved.
fn enough(failed: u64, tried: u64, error: VerifyError) -> Result<(), Fault> {
    if 2 * failed > tried { Err(Fault::NotSolved { failed, tried, error }) } else { Ok(()) }
}

impl<const D: usize> Case<'_, D> {
    /// Checks a statement about the minimisers for a rule.
    pub(super) fn of_minimisers(&self, rule: PaperRule, statement: OfMinimisers<D>) -> LawResult {
        self.of_solutions(rule, &|minimiser| judge(&statement(&LIBRARY, minimiser.seen)))
    }

    /// Checks a statement about the minimisers for a rule, also with a proved distance.
    pub(super) fn of_theorem(&self, rule: PaperRule, theorem: OfMinimisers<D>) -> LawResult {
        let proved = self.of_proved(rule, &|seen| vec![theorem(&LIBRARY, seen)])?;
        Ok(self.of_minimisers(rule, theorem)?.and(proved))
    }

    /// Checks a statement whose claims are attained by every metric: equalities of constants, and
    /// equalities at `N = 1`. The report shows the overestimation of the claim `shown`, or none.
    pub(super) fn of_constants(
        &self,
        rule: PaperRule,
        statement: OfMinimisers<D>,
        shown: Option<&'static str>,
    ) -> LawResult {
        self.of_solutions(rule, &|minimiser| {
            let evidence = statement(&LIBRARY, minimiser.seen);
            let mut margin = judge(&evidence)?;
            if !margin.is_idle() {
                margin.overestimation = shown
                    .map_or(f64::INFINITY, |claim| evidence.conclusion(claim).overestimation());
            }
            Ok(margin)
        })
    }

    /// Checks a law on the minimisers for both rules.
    pub(super) fn of_both_rules(
        &self,
        law: &dyn Fn(&Minimiser<'_, D>) -> Result<Margin, Fault>,
    ) -> LawResult {
        let of = |rule| self.of_solutions(rule, law);
        Ok(of(PaperRule::Trapezoidal)?.and(of(PaperRule::LeftEndpoint)?))
    }

    /// Checks a law on the minimisers for a rule, between sets of every kind and for every `N` of
    /// the effort.
    ///
    /// If the solver gets stuck, this is not a fault of the metric. If it gets stuck on most
    /// problems, nothing was tested, and this is a fault.
    pub(super) fn of_solutions(
        &self,
        rule: PaperRule,
        law: &dyn Fn(&Minimiser<'_, D>) -> Result<Margin, Fault>,
    ) -> LawResult {
        self.solvable()?;
        let problems = self.effort.problems.div_ceil(Kind::ALL.len() as u32);
        let (failed, idle) = (Cell::new(0_u64), Cell::new(0_u64));
        let last: RefCell<Option<VerifyError>> = RefCell::default();
        let mut tried = Tried::cases(0);
        for (offset, kind) in Kind::ALL.into_iter().enumerate() {
            let seed = self.effort.seed.wrapping_add(offset as u64);
            let effort = Effort { seed, problems, ..self.effort };
            let problems = Posed::problems(kind, &self.ends);
            tried = tried.and(effort.for_all_problems(problems, |posed| {
                match self.solution(rule, posed) {
                    Ok(solution) => {
                        let known = &self.with_distance(posed, solution.distance)?;
                        solution.minimisers.iter().try_fold(Margin::idle(), |all, seen| {
                            let margin = law(&Minimiser { posed, known, seen });
                            let points = seen.minimum.sequence.points();
                            let margin = margin.map_err(|fault| self.explained(fault, points))?;
                            idle.set(idle.get() + u64::from(margin.is_idle()));
                            Ok(all.and(margin))
                        })
                    }
                    Err(error @ VerifyError::NotConverged { .. }) => {
                        failed.set(failed.get() + 1);
                        last.replace(Some(error));
                        Ok(Margin::idle())
                    }
                    Err(error) => Err(error.into()),
                }
            })?);
        }
        let failed = failed.get();
        if let Some(error) = last.into_inner() {
            enough(failed, tried.cases, error).map_err(|fault| self.effort.failure(fault))?;
            tried = tried.with_note(format!("{failed} problems without a minimum"));
        }
        // The cases are minimisers, not problems.
        tried.cases = (tried.cases - failed) * self.effort.subintervals.len() as u64;
        tried.idle = idle.get();
        Ok(tried)
    }

    /// Returns the minimisers of one problem for every `N` of the effort, which are computed once.
    fn solution(&self, rule: PaperRule, posed: &Posed<D>) -> Solutions<D> {
        let memory = &self.solved.minimisers;
        memory.recall(&(rule, *posed), || Ok(self.solve(rule, posed)?.into()))
    }

    fn solve(&self, rule: PaperRule, posed: &Posed<D>) -> Result<Solution<D>, VerifyError> {
        let observe = |known: Known<&AnyBounded<'_, D>, D>| {
            let numbers = self.effort.subintervals.iter();
            let seen = numbers.map(|&n| Reconstruction::observe(&LIBRARY, &known, rule, n));
            let minimisers = seen.collect::<Result<Vec<_>, _>>()?;
            Ok(Solution { distance: [known.distance, known.distance_error], minimisers })
        };
        let solution: Solution<D> = observe(self.known(posed, &[])?)?;
        let all = &solution.minimisers;
        // A grid may lead to a shorter curve than the curve on which the estimate is based.
        if all.iter().all(|seen| seen.energy.value + seen.granted >= seen.distance_squared) {
            return Ok(solution);
        }
        observe(self.known(posed, all)?)
    }
}

#[cfg(test)]
mod tests {
    use tautline::{Curvature, Stop};
    use tautline_statements::VerifyError;

    use super::enough;
    use crate::Fault;

    #[test]
    fn half_of_the_problems_must_be_solved() {
        let error = || VerifyError::NotConverged {
            n: 8,
            stop: Stop::Converged,
            curvature: Curvature::Indefinite { negative: 1 },
        };
        assert_eq!(enough(6, 12, error()), Ok(()));
        let refused = Fault::NotSolved { failed: 7, tried: 12, error: error() };
        assert_eq!(enough(7, 12, error()), Err(refused));
    }
}
