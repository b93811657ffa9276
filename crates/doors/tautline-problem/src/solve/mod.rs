//! Solves the problem of a file.

mod programs;
mod refused;
mod sign;

use core::ops::ControlFlow;
use std::sync::Arc;

use tautline::{
    ANY, AnyEnds, AnySet, Known, Problem,
    certify::{Progress, Watch},
    check_periods, distance,
};
use tautline_any::{Answer, Grid, Line, Request, RequestError, ends};

use crate::{Diagnostic, Failure, Question, reading::shape::Piece};

pub use self::programs::Programs;

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
        self.solve_by(metric, &self.request(), solved, watch, observe)
    }

    /// Solves the problem like [`solve`](Question::solve), on one thread, with programs of its metric
    /// that other problems share. The answer is the same bit for bit.
    ///
    /// # Errors
    ///
    /// Those of [`solve`](Question::solve).
    pub fn solve_with(&self, programs: &Programs) -> Result<Answer, Failure> {
        let request = Request { threads: 1, ..self.request() };
        let metric = Arc::clone(programs.metric());
        let go_on = &mut |_| ControlFlow::Continue(());
        self.solve_by(metric, &request, &mut |_| (), &|_: Progress| true, go_on)
    }

    fn solve_by(
        &self,
        metric: Arc<Known>,
        request: &Request,
        solved: &mut dyn FnMut(&Answer),
        watch: &dyn Watch,
        observe: &mut dyn FnMut(distance::Progress) -> ControlFlow<()>,
    ) -> Result<Answer, Failure> {
        let line = self.line(metric, request, solved)?;
        let answer = self.on_its_own(&line);
        let proving = self.bound.then(|| self.proving());
        let mut answer = answer.complete(&line, proving, watch, observe, solved);
        if let (Some(periods), Some(bounds)) = (&self.periods, &mut answer.bounds) {
            bounds.to_near_translates(reach(periods.get_ref()));
        }
        Ok(answer)
    }
}

/// Returns a lower bound on the distance, in `ℓ`, of the first set from the translates of the second one that
/// are not tried: that of [`translates`](tautline::translates), and 0 for more periods than it is about.
fn reach(periods: &[f64]) -> f64 {
    let periods: Vec<f64> = periods.iter().copied().filter(|&period| period > 0.0).collect();
    if periods.len() > 3 { 0.0 } else { periods.into_iter().fold(f64::INFINITY, f64::min) }
}

impl Question {
    /// Poses the problem with a metric.
    pub(crate) fn posed(&self, metric: Arc<Known>) -> Result<Problem<Known, ANY>, Failure> {
        self.check_periods(&metric)?;
        let posed = Problem::with_known(metric, self.pair()?);
        posed.map_err(|error| Failure::NotComputed(error.to_string()))
    }

    /// Refuses a period that the metric does not have.
    fn check_periods(&self, metric: &Known) -> Result<(), Diagnostic> {
        let (Some(periods), Some([from, to])) = (&self.periods, &self.ends) else { return Ok(()) };
        let mut ends = [(); 2].map(|()| vec![0.0; self.dimension]);
        for (x, pieces) in ends.iter_mut().zip([from, to]) {
            if let Some(piece) = pieces.first() {
                piece.shape.project(x);
            }
        }
        check_periods(metric, periods.get_ref(), [&ends[0], &ends[1]])
            .map_err(|error| Diagnostic::new(error.to_string(), periods.span()))
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

    /// Returns the line of the problem with a metric. With a tolerance, `solved` is told of each coarser
    /// grid.
    ///
    /// A search may step over a pole of a cost to where the cost is negative, for its square is a metric
    /// there too. A second search then refuses such steps.
    pub(crate) fn line(
        &self,
        metric: Arc<Known>,
        request: &Request,
        solved: &mut dyn FnMut(&Answer),
    ) -> Result<Line, Failure> {
        let negative = match self.line_by(Arc::clone(&metric), request, solved)? {
            Ok(line) => return Ok(line),
            Err(negative) => negative,
        };
        let positive = self.where_positive(&metric)?.map(Arc::new);
        match positive.map(|positive| self.line_by(positive, request, solved)) {
            Some(Ok(Ok(line))) => Ok(line),
            _ => Err(negative.into()),
        }
    }

    /// Returns the line that a search finds, or where a cost or a speed is negative on it.
    fn line_by(
        &self,
        metric: Arc<Known>,
        request: &Request,
        solved: &mut dyn FnMut(&Answer),
    ) -> Result<Result<Line, Diagnostic>, Failure> {
        let problem = self.posed(metric)?;
        let mut wrong = Ok(());
        let line = problem.answer_watched(request, &mut |coarser| {
            wrong = self.check_sign(coarser.sequence());
            if wrong.is_err() {
                return ControlFlow::Break(());
            }
            solved(&self.on_its_own(coarser));
            ControlFlow::Continue(())
        });
        let line = line.map_err(|error| match (error, &self.lattice) {
            (RequestError::Solve(error), _) => self.failure(problem.metric(), &error),
            (RequestError::Start(error), _) => Failure::NotComputed(error.to_string()),
            (error, Some(nodes)) => {
                Failure::BadInput(Diagnostic::new(error.to_string(), nodes.span()))
            }
            (error, None) => Failure::NotComputed(error.to_string()),
        })?;
        Ok(wrong.and_then(|()| self.check_sign(line.sequence())).map(|()| line))
    }

    /// Returns the answer without other minima and without bounds.
    fn on_its_own(&self, line: &Line) -> Answer {
        let tolerance = match self.grid {
            Grid::Tolerance(tolerance) => Some(tolerance),
            Grid::Chords(_) => None,
        };
        let no_bounds = self.bound.then(|| "not finished".to_owned());
        Answer { no_bounds, ..Answer::of(line, tolerance) }
    }
}
