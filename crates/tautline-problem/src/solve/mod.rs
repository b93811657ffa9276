//! Solves the problem of a file.

mod described;
mod programs;
mod refused;
mod sign;
mod tolerance;

use core::ops::ControlFlow;
use std::sync::Arc;

use tautline::{
    Ends, Formula, LeftEndpoint, Options, PointSequence, Prepared, Problem, Rule, SolveError,
    Starts, Stop, TautLine, Trapezoidal, TrueTrapezoid,
    certify::{Progress, Watch},
    distance,
};

use tautline_portrait::Shape;

use crate::{
    Answer, Bounds, Diagnostic, Failure, Grid, OtherMinimum, Question,
    answer::is_shorter,
    bounds::{NO_THEOREM, bounds},
    dimension::{InDimension, in_dimension},
    file::request::RuleName,
    reading::shape::{Piece, union, vector},
};

use self::tolerance::{FINEST_GRID, FIRST_GRID, PATIENCE, finer_grid};

pub use self::programs::Programs;

pub(crate) use self::described::{estimated, extrapolated, points, search};

impl Question {
    /// Solves the problem, and calls `solved` with the answer as soon as the curve and the other minima
    /// are known, before it proves any bound, which may take longer. With a tolerance it first calls
    /// `solved` with the curve of each coarser grid, without other minima.
    ///
    /// # Errors
    ///
    /// [`Failure::BadInput`] with the place in the file, also if the metric turns out not to be one
    /// along a curve; [`Failure::NotComputed`] if there is no curve.
    pub fn solve(&self, solved: &mut dyn FnMut(&Answer)) -> Result<Answer, Failure> {
        self.solve_watched(solved, &|_: Progress| true, &mut |_| ControlFlow::Continue(()))
    }

    /// Solves the problem like [`solve`](Question::solve), and tells `watch` of the progress of
    /// proofs of constants, and `observe` of every level of a certificate. If one of them ends them,
    /// the bounds are those that are proved so far.
    ///
    /// # Errors
    ///
    /// Those of [`solve`](Question::solve).
    pub fn solve_watched(
        &self,
        solved: &mut dyn FnMut(&Answer),
        watch: &dyn Watch,
        observe: &mut dyn FnMut(distance::Progress) -> ControlFlow<()>,
    ) -> Result<Answer, Failure> {
        let solve = Solve { question: self, programs: None, solved, watch, observe };
        in_dimension(self.dimension, solve).unwrap_or(Err(Failure::NotComputed(String::new())))
    }

    /// Solves the problem like [`solve`](Question::solve), on one thread, with programs of its metric
    /// that other problems share. The answer is the same bit for bit.
    ///
    /// # Errors
    ///
    /// Those of [`solve`](Question::solve).
    pub fn solve_with(&self, programs: &Programs) -> Result<Answer, Failure> {
        let solve = Solve {
            question: self,
            programs: Some(programs),
            solved: &mut |_| (),
            watch: &|_: Progress| true,
            observe: &mut |_| ControlFlow::Continue(()),
        };
        in_dimension(self.dimension, solve).unwrap_or(Err(Failure::NotComputed(String::new())))
    }
}

struct Solve<'q> {
    question: &'q Question,
    programs: Option<&'q Programs>,
    solved: &'q mut dyn FnMut(&Answer),
    watch: &'q dyn Watch,
    observe: &'q mut dyn FnMut(distance::Progress) -> ControlFlow<()>,
}

impl InDimension for Solve<'_> {
    type Output = Result<Answer, Failure>;

    fn run<const D: usize>(self) -> Self::Output {
        let Self { question, programs, solved, watch, observe } = self;
        let mut options = question.options::<D>()?;
        let prepared = match programs.and_then(Programs::prepared::<D>) {
            Some(prepared) => {
                options.threads = 1;
                prepared
            }
            None => Arc::new(Prepared::new(question.formula::<D>()?)),
        };
        let problem = Problem::with_prepared(prepared, question.pair::<D>()?);
        match question.rule {
            RuleName::Trapezoidal => {
                let line = question.line(&problem, Trapezoidal, &options, solved)?;
                question.answer(&line, |q, l, o| bounds(q.proving(), l, o, watch, observe), solved)
            }
            RuleName::LeftEndpoint => {
                let line = question.line(&problem, LeftEndpoint, &options, solved)?;
                question.answer(&line, |q, l, o| bounds(q.proving(), l, o, watch, observe), solved)
            }
            RuleName::TrueTrapezoid => {
                let line = question.line(&problem, TrueTrapezoid, &options, solved)?;
                let no_theorem = |_: &_, _: &_, _: &[_]| Err(NO_THEOREM.to_owned());
                question.answer(&line, no_theorem, solved)
            }
        }
    }
}

impl Question {
    /// Returns the two sets.
    pub(crate) fn pair<const D: usize>(&self) -> Result<Ends<D>, Diagnostic> {
        let metric = self.problem.metric.span();
        let Some([from, to]) = &self.ends else {
            return Err(Diagnostic::new("[from] and [to] are missing", metric)
                .help("a problem has a metric and two sets between which a curve runs"));
        };
        let first = |pieces: &[Piece]| match pieces {
            [piece] => match &piece.shape {
                Shape::Point(x) => Some(vector::<D>(x)),
                _ => None,
            },
            _ => None,
        };
        // Two points are recognised, since more is proved of them.
        let ends = match (first(from), first(to)) {
            (Some(a), Some(b)) => Ends::points(a, b),
            _ => Ends::new(union::<D>(from)?, union::<D>(to)?),
        };
        ends.map_err(|error| {
            let place = to.first().and_then(|piece| piece.places.first());
            Diagnostic::new(error.to_string(), place.cloned().unwrap_or(metric))
        })
    }

    pub(crate) fn options<const D: usize>(&self) -> Result<Options<D>, Failure> {
        let start = |start: &Vec<Vec<f64>>| {
            PointSequence::new(start.iter().map(|x| vector::<D>(x)).collect())
                .map_err(|error| Failure::NotComputed(error.to_string()))
        };
        let starts = self.starts.iter().map(start).collect::<Result<Vec<_>, _>>()?;
        let starts = match (starts.is_empty(), self.only_these_starts) {
            (true, false) => Starts::Automatic,
            (_, true) => Starts::Only(starts),
            (false, false) => Starts::Also(starts),
        };
        let default = Options::default();
        Ok(Options { starts, iterations: self.steps.unwrap_or(default.iterations), ..default })
    }

    pub(crate) fn line<R: Rule, const D: usize>(
        &self,
        problem: &Problem<Formula<D>, D>,
        rule: R,
        options: &Options<D>,
        solved: &mut dyn FnMut(&Answer),
    ) -> Result<TautLine<Formula<D>, R, D>, Failure> {
        let failure = |error: SolveError| self.failure(problem.metric(), &error);
        let first = if let Grid::Chords(n) = self.grid { n } else { FIRST_GRID };
        if let Some(nodes) = &self.lattice {
            let wrong = |error: String| Failure::BadInput(Diagnostic::new(error, nodes.span()));
            let lattice =
                nodes.get_ref().lattice::<D>().map_err(|error| wrong(error.to_string()))?;
            let line = problem.solve_on_lattice(rule, first, &lattice, options);
            return line.map_err(|error| match error {
                SolveError::GraphPath(error) => wrong(error.to_string()),
                error => failure(error),
            });
        }
        let mut line = problem.solve_with(rule, first, options).map_err(failure)?;
        let Grid::Tolerance(tolerance) = self.grid else { return Ok(line) };
        let converged = |line: &TautLine<_, _, D>| line.minimum().stop == Stop::Converged;
        let (mut options, mut failures, mut last_converged) = (options.clone(), 0, None);
        loop {
            // A search that fails twice on fine grids fails on finer ones.
            let n = line.sequence().n().get();
            failures = if converged(&line) { 0 } else { failures + 1 };
            if failures >= 2 && n >= PATIENCE {
                break;
            }
            let mut starts = vec![line.sequence().clone()];
            let finer = finer_grid(&line, tolerance).or_else(|| {
                // On a finer grid a minimum that is shorter should have less energy too.
                let others = line.other_minima();
                let length = line.length().value;
                let shorter =
                    others.iter().find(|other| is_shorter(other.length().value, length))?;
                starts.push(shorter.sequence().clone());
                Some(2 * n)
            });
            let finer = finer.map(|finer| finer.min(FINEST_GRID / D));
            let Some(finer) = finer.filter(|&finer| finer > n) else { break };
            solved(&self.on_its_own(&line)?);
            options.starts = also(options.starts, starts);
            // Without a finer line, the coarser one misses the tolerance, and says so.
            let Ok(finer) = problem.solve_with(rule, finer, &options) else { break };
            let coarser = std::mem::replace(&mut line, finer);
            if converged(&coarser) {
                last_converged = Some(coarser);
            }
        }
        Ok(if converged(&line) { line } else { last_converged.unwrap_or(line) })
    }

    /// Returns the answer without other minima and without bounds.
    fn on_its_own<R: Rule, const D: usize>(
        &self,
        line: &TautLine<Formula<D>, R, D>,
    ) -> Result<Answer, Diagnostic> {
        self.check_sign(line.sequence())?;
        let minimum = line.minimum();
        Ok(Answer {
            dimension: D,
            rule: self.rule.name(),
            n: minimum.sequence.n().get(),
            length: estimated(line.length()),
            energy: estimated(line.energy()),
            discrete_energy: minimum.energy,
            extrapolated: extrapolated(line),
            search: search(minimum),
            resolved: line.is_resolved(),
            within_tolerance: match self.grid {
                Grid::Tolerance(tolerance) => Some(finer_grid(line, tolerance).is_none()),
                Grid::Chords(_) => None,
            },
            bounds: None,
            no_bounds: self.bound.then(|| "not finished".to_owned()),
            curve: points(&minimum.sequence),
            other_minima: Vec::new(),
        })
    }

    fn answer<R: Rule, const D: usize>(
        &self,
        line: &TautLine<Formula<D>, R, D>,
        bounds: impl FnOnce(
            &Self,
            &TautLine<Formula<D>, R, D>,
            &[TautLine<Formula<D>, R, D>],
        ) -> Result<Bounds, String>,
        solved: &mut dyn FnMut(&Answer),
    ) -> Result<Answer, Failure> {
        let mut answer = self.on_its_own(line)?;
        let others = line.other_minima();
        let minima = others.iter().map(|other| OtherMinimum {
            length: estimated(other.length()),
            curve: points(other.sequence()),
        });
        answer.other_minima = minima.collect();
        if answer.other_minima.iter().any(|other| other.is_shorter_than(&answer)) {
            answer.is_not_resolved();
        }
        solved(&answer);
        if self.bound {
            match bounds(self, line, &others) {
                Ok(bounds) => {
                    if bounds.exceed(&answer.length) {
                        answer.is_not_resolved();
                    }
                    (answer.bounds, answer.no_bounds) = (Some(bounds), None);
                }
                Err(reason) => answer.no_bounds = Some(reason),
            }
        }
        Ok(answer)
    }
}

/// Returns starts with further ones. What was found on a coarse grid is then not lost on a finer one,
/// which has other coarse grids of its own.
fn also<const D: usize>(starts: Starts<D>, found: Vec<PointSequence<D>>) -> Starts<D> {
    let only = matches!(starts, Starts::Only(_));
    let mut given = match starts {
        Starts::Also(given) | Starts::Only(given) => given,
        _ => Vec::new(),
    };
    given.extend(found);
    if only { Starts::Only(given) } else { Starts::Also(given) }
}
