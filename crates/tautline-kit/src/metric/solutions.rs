//! The solved problems of one metric: minimisers, and the curves they are compared with.

use std::cell::{Cell, RefCell};

use nalgebra::SVector;
use tautline::{ClosedSet, LeftEndpoint, Options, PointSequence, Starts, Trapezoidal, minimise};
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
    Effort, Failure, Fault,
    met::Met,
    report::{LawResult, Tried},
    sampling::{COSTLY, for_all},
};

/// What a statement says of a minimiser.
type OfMinimisers<const D: usize> = fn(&Subject, &Reconstruction<D>) -> Evidence;

/// One minimiser of a solved problem.
pub(super) struct Minimiser<'a, const D: usize> {
    pub(super) posed: &'a Posed<D>,
    pub(super) known: &'a Known<&'a AnyBounded<'a, D>, D>,
    pub(super) seen: &'a Reconstruction<D>,
}

impl<const D: usize> Minimiser<'_, D> {
    /// Another way from the one set to the other with as many subintervals: by a third point, from
    /// the member of the first set that is nearest to it, to that of the second.
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

    /// The minimiser with each point moved a little, by less than a 64th of its mean step.
    pub(super) fn moved(&self) -> Result<PointSequence<D>, VerifyError> {
        let step = self.seen.k3 / (64.0 * self.seen.n.get() as f64 * (D as f64).sqrt());
        let points = self.seen.minimum.sequence.points().iter().zip(1_u32..);
        let moved = points.map(|(x, n)| {
            x + SVector::from_fn(|i, _| step * (2.0 * (f64::from(n) * winding(i)).fract() - 1.0))
        });
        admissible(self.sets(), moved.collect())
    }

    /// What is found if the search may begin at another sequence, too.
    pub(super) fn again(&self, other: &PointSequence<D>) -> Result<PointSequence<D>, VerifyError> {
        let options = Options { starts: Starts::Also(vec![other.clone()]), ..Options::default() };
        let Known { metric, ends, .. } = self.known;
        let n = self.seen.n.get();
        let minimum = match self.seen.rule {
            PaperRule::Trapezoidal => minimise(metric, ends, Trapezoidal, n, &options)?,
            PaperRule::LeftEndpoint => minimise(metric, ends, LeftEndpoint, n, &options)?,
        };
        Ok(minimum.sequence)
    }

    pub(super) fn sets(&self) -> [&dyn ClosedSet<D>; 2] {
        [&**self.known.ends.first(), &**self.known.ends.second()]
    }
}

/// The sequence of these points with its ends moved to the sets.
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
    /// Evaluates a statement about minimisers of a rule.
    pub(super) fn of_minimisers(&self, rule: PaperRule, statement: OfMinimisers<D>) -> LawResult {
        self.of_solutions(rule, &|minimiser| judge(&statement(&LIBRARY, minimiser.seen)))
    }

    /// Evaluates a statement about minimisers of a rule, some of whose claims are attained for
    /// every metric: equalities of constants, and what is equal at `N = 1`. A report shows the
    /// overestimation of another claim, or none.
    pub(super) fn of_constants(
        &self,
        rule: PaperRule,
        statement: OfMinimisers<D>,
        shown: Option<&'static str>,
    ) -> LawResult {
        self.of_solutions(rule, &|minimiser| {
            let evidence = statement(&LIBRARY, minimiser.seen);
            let met = judge(&evidence)?;
            let shown =
                || shown.map_or(f64::INFINITY, |claim| evidence.conclusion(claim).overestimation());
            Ok(if met.is_idle() { met } else { Met { overestimation: shown(), ..met } })
        })
    }

    /// Tries a law on the minimisers of both rules.
    pub(super) fn of_both_rules(
        &self,
        law: &dyn Fn(&Minimiser<'_, D>) -> Result<Met, Fault>,
    ) -> LawResult {
        let of = |rule| self.of_solutions(rule, law);
        Ok(of(PaperRule::Trapezoidal)?.and(of(PaperRule::LeftEndpoint)?))
    }

    /// Tries a law on minimisers of a rule, between sets of every kind and for every `N` of the
    /// effort.
    ///
    /// That the solver gets stuck is no fault of the metric; if it does for most problems, nothing
    /// was tested, and that is a fault.
    pub(super) fn of_solutions(
        &self,
        rule: PaperRule,
        law: &dyn Fn(&Minimiser<'_, D>) -> Result<Met, Fault>,
    ) -> LawResult {
        self.solvable()?;
        let cases = self.effort.problems.div_ceil(Kind::ALL.len() as u32);
        let (failed, idle) = (Cell::new(0_u64), Cell::new(0_u64));
        let last: RefCell<Option<VerifyError>> = RefCell::default();
        let mut tried = Tried::cases(0);
        for (offset, kind) in Kind::ALL.into_iter().enumerate() {
            let effort =
                Effort { seed: self.effort.seed.wrapping_add(offset as u64), ..self.effort };
            let problems = Posed::problems(kind, &self.ends);
            let one = for_all(&effort, cases, COSTLY, problems, |posed| {
                match self.solution(rule, posed) {
                    Ok(solution) => {
                        let known = &self.with_distance(posed, solution.distance)?;
                        solution.minimisers.iter().try_fold(Met::nothing(), |all, seen| {
                            let met = law(&Minimiser { posed, known, seen });
                            let points = seen.minimum.sequence.points();
                            let met = met.map_err(|fault| self.explained(fault, points))?;
                            idle.set(idle.get() + u64::from(met.is_idle()));
                            Ok(all.and(met))
                        })
                    }
                    Err(error @ VerifyError::NotConverged { .. }) => {
                        failed.set(failed.get() + 1);
                        last.replace(Some(error));
                        Ok(Met::nothing())
                    }
                    Err(error) => Err(error.into()),
                }
            })?;
            tried = tried.and(one);
        }
        let failed = failed.get();
        if let Some(error) = last.into_inner() {
            let failure = |fault| Failure { fault, sample: None, seed: self.effort.seed };
            enough(failed, tried.cases, error).map_err(failure)?;
            tried = tried.with_note(format!("{failed} problems without a minimum"));
        }
        // Not of problems, but of minimisers.
        tried.cases = (tried.cases - failed) * self.effort.subintervals.len() as u64;
        tried.idle = idle.get();
        Ok(tried)
    }

    /// The minimisers of one problem for every `N` of the effort, from memory if they are there.
    fn solution(&self, rule: PaperRule, posed: &Posed<D>) -> Solutions<D> {
        let memory = match rule {
            PaperRule::Trapezoidal => &self.solved.trapezoidal,
            PaperRule::LeftEndpoint => &self.solved.left,
        };
        memory.recall(posed, || Ok(self.solve(rule, posed)?.into()))
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
        // A grid may lead to a shorter curve than the one by which the distance was estimated.
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
    fn half_of_the_problems_have_to_be_solved() {
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
