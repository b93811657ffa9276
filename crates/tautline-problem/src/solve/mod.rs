//! Solves the problem of a file.

mod described;
mod programs;
mod refused;
mod sign;
mod tolerance;

use core::ops::ControlFlow;
use std::sync::Arc;

use tautline::{
    ANY, AnyEnds, Known, Options, PointSequence, Problem, Rule, SolveError, Starts, TautLine,
    certify::{Progress, Watch},
    distance,
};

use crate::{
    Answer, Diagnostic, Failure, Grid, OtherMinimum, Question,
    bounds::bounds,
    reading::shape::{Piece, ends},
    value::GivenError,
};

pub use self::programs::Programs;

pub(crate) use self::{
    described::{estimated, extrapolated, points, search},
    sign::least_entry,
    tolerance::{FIRST_GRID, finer_grid, refined},
};

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
        let metric = Arc::new(Known::from(self.any_formula()?));
        self.solve_by(metric, &self.options()?, solved, watch, observe)
    }

    /// Solves the problem like [`solve`](Question::solve), on one thread, with programs of its metric
    /// that other problems share. The answer is the same bit for bit.
    ///
    /// # Errors
    ///
    /// Those of [`solve`](Question::solve).
    pub fn solve_with(&self, programs: &Programs) -> Result<Answer, Failure> {
        let options = Options { threads: 1, ..self.options()? };
        let metric = Arc::clone(programs.metric());
        let go_on = &mut |_| ControlFlow::Continue(());
        self.solve_by(metric, &options, &mut |_| (), &|_: Progress| true, go_on)
    }

    fn solve_by(
        &self,
        metric: Arc<Known>,
        options: &Options<ANY>,
        solved: &mut dyn FnMut(&Answer),
        watch: &dyn Watch,
        observe: &mut dyn FnMut(distance::Progress) -> ControlFlow<()>,
    ) -> Result<Answer, Failure> {
        let line = self.line(&self.posed(metric)?, self.rule, options, solved)?;
        self.answer(&line, watch, observe, solved)
    }
}

impl Question {
    /// Poses the problem with a metric.
    pub(crate) fn posed(&self, metric: Arc<Known>) -> Result<Problem<Known, ANY>, Failure> {
        let posed = Problem::with_known(metric, self.pair()?);
        posed.map_err(|error| Failure::NotComputed(error.to_string()))
    }

    /// Returns the two sets.
    fn pair(&self) -> Result<AnyEnds, Diagnostic> {
        let metric = self.problem.metric.span();
        let Some([from, to]) = &self.ends else {
            return Err(Diagnostic::new("[from] and [to] are missing", metric)
                .help("a problem has a metric and two sets between which a curve runs"));
        };
        let shapes = |pieces: &[Piece]| pieces.iter().map(|piece| piece.shape.clone()).collect();
        ends(shapes(from), shapes(to)).map_err(|error| {
            let place = to.first().and_then(|piece| piece.places.first());
            Diagnostic::new(error.to_string(), place.cloned().unwrap_or(metric))
        })
    }

    pub(crate) fn options(&self) -> Result<Options<ANY>, Failure> {
        let start = |start: &Vec<Vec<f64>>| {
            PointSequence::from_coordinates(self.dimension, start.concat())
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

    pub(crate) fn line(
        &self,
        problem: &Problem<Known, ANY>,
        rule: Rule,
        options: &Options<ANY>,
        solved: &mut dyn FnMut(&Answer),
    ) -> Result<TautLine<Known, ANY>, Failure> {
        let failure = |error: SolveError| self.failure(problem.metric(), &error);
        let first = if let Grid::Chords(n) = self.grid { n } else { FIRST_GRID };
        if let Some(nodes) = &self.lattice {
            let wrong = |error: String| Failure::BadInput(Diagnostic::new(error, nodes.span()));
            let line = nodes.get_ref().solve(problem, rule, first, options);
            return line.map_err(|error| match error {
                GivenError::Solve(error) => failure(error),
                error => wrong(error.to_string()),
            });
        }
        let line = problem.solve_with(rule, first, options).map_err(failure)?;
        let Grid::Tolerance(tolerance) = self.grid else { return Ok(line) };
        let mut wrong = None;
        let line = refined(problem, rule, line, tolerance, options, &mut |coarser| {
            match self.on_its_own(coarser) {
                Ok(answer) => solved(&answer),
                Err(diagnostic) => wrong = Some(diagnostic),
            }
            if wrong.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        wrong.map_or(Ok(line), |diagnostic| Err(diagnostic.into()))
    }

    /// Returns the answer without other minima and without bounds.
    fn on_its_own(&self, line: &TautLine<Known, ANY>) -> Result<Answer, Diagnostic> {
        self.check_sign(line.sequence())?;
        let minimum = line.minimum();
        Ok(Answer {
            dimension: self.dimension,
            rule: self.rule.name(),
            n: minimum.sequence.n().get(),
            length: estimated(line.length()),
            energy: estimated(line.energy()),
            discrete_energy: minimum.energy,
            extrapolated: extrapolated(line),
            search: search(line),
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

    fn answer(
        &self,
        line: &TautLine<Known, ANY>,
        watch: &dyn Watch,
        observe: &mut dyn FnMut(distance::Progress) -> ControlFlow<()>,
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
            match bounds(self.proving(), line, &others, watch, observe) {
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
