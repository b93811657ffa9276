//! `GlobalSearch`: all ways to find starts, and the minima to which they lead.

use tautline::{
    GraphPathError, Lattice, LatticeGraph, Metric, Options, Plain, PointSequence, Problem,
    Punctures, Rule, Scope, SolveError, Starts, TautLine, are_apart, class_paths,
    grid::{EikonalError, pass_paths},
};

use crate::{
    Flattened, LocalMinimum, Minima, MinimaError, Origin, Refused, continuation::is_minimum,
    flattened::level, follow,
};

/// Where a search for all minima looks.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct GlobalSearch<const D: usize> {
    /// The box in which paths are sought, with nodes closer than the details of the metric. Without it
    /// there are neither classes nor passes.
    pub lattice: Option<Lattice<D>>,
    /// The points that the classes pass on one side or the other. Without them the search takes the
    /// [prominent](Punctures::prominent) peaks of the metric.
    pub punctures: Option<Punctures>,
    /// The most homotopy classes, the most passes and the most branches of continuation that are tried.
    pub most: usize,
    /// How many times as long as the shortest path a path may be.
    pub slack: f64,
    /// The number of steps in which the metric is raised from a flat one; 0 for no continuation.
    pub steps: usize,
}

impl<const D: usize> Default for GlobalSearch<D> {
    /// Returns a search without a lattice, of up to 32 classes and passes with paths up to twice as long
    /// as the shortest, and eight steps of continuation.
    fn default() -> Self {
        Self { lattice: None, punctures: None, most: 32, slack: 2.0, steps: 8 }
    }
}

impl<const D: usize> GlobalSearch<D> {
    /// Returns the default search in the box of this lattice.
    #[must_use]
    pub fn within(lattice: Lattice<D>) -> Self {
        Self { lattice: Some(lattice), ..Self::default() }
    }

    /// Searches for all local minima of the energy with `n` chords.
    ///
    /// The starts are those of [`Problem::solve`] and its [other minima](TautLine::other_minima); the
    /// shortest lattice path of each homotopy class ([`class_paths`]); curves through the passes between
    /// two distance fields ([`pass_paths`]); and the minima that continuation finds while the metric
    /// rises from a flat one ([`Flattened`], [`follow`]). Each start leads to at most one local minimum. Of minima
    /// along the same curve, up to 2 % of its extent, the lowest is kept.
    ///
    /// What cannot be done is no error: it is listed among the [refused](Minima::refused). Nothing proves
    /// that all minima are found; a [certificate](Minima::ranked) proves which of them is the shortest of
    /// all curves, up to a gap.
    ///
    /// ```
    /// use tautline::{Ends, Lattice, Problem, Rule, gallery::{Obstacle, SoftObstacles}};
    /// use tautline_minima::GlobalSearch;
    ///
    /// // Two hills: above, between and below.
    /// let hill = |y: f64| Obstacle { centre: [0.0, y].into(), height: 20.0, width: 0.3 };
    /// let hills = SoftObstacles::new(vec![hill(0.7), hill(-0.6)])?;
    /// let problem = Problem::new(hills, Ends::points([-2.0, 0.0], [2.0, 0.1])?);
    /// let lattice = Lattice::new([-2.2, -2.0], [2.2, 2.0], 0.1)?;
    /// let found = GlobalSearch::within(lattice).search(&problem, Rule::TRAPEZOIDAL, 64)?;
    /// assert_eq!(found.minima().len(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`MinimaError::Lattice`] unless `slack` is at least 1, or if a node of the lattice overflows, and
    /// [`MinimaError::NoMinimum`].
    pub fn search<M: Metric<D>>(
        &self,
        problem: &Problem<M, D>,
        rule: Rule,
        n: usize,
    ) -> Result<Minima<M, D>, MinimaError> {
        if !(self.slack >= 1.0) {
            return Err(GraphPathError::Slack { slack: self.slack }.into());
        }
        let mut collected = Collected { problem, rule, n, minima: Vec::new(), starts: 0 };
        let mut refused = Vec::new();
        let local = Options { scope: Scope::Local, ..Options::default() };
        let automatic = problem.solve_with(rule, n, &local);
        let source = automatic.as_ref().err().cloned();
        if source.as_ref().is_some_and(SolveError::is_due_to_n) {
            return Err(MinimaError::NoMinimum { starts: 1, source });
        }
        let level = automatic.as_ref().ok().and_then(level);
        collected.starts += 1;
        if let Ok(line) = automatic {
            let others = line.other_minima();
            collected.keep(line, &Origin::Automatic);
            for other in others {
                collected.solve(Some(other.sequence().clone()), &Origin::Automatic);
            }
        }
        let punctures = self.punctures(problem.metric())?;
        if let Some(lattice) = &self.lattice {
            if let Err(error) = self.by_classes(&mut collected, lattice, &punctures) {
                refused.push(Refused::Classes(error));
            }
            if let Err(error) = self.by_passes(&mut collected, lattice) {
                refused.push(Refused::Passes(error));
            }
        }
        if self.steps > 0 {
            let level = level.ok_or_else(|| source.clone().unwrap_or(SolveError::NoStart));
            let followed = level.and_then(|level| self.by_continuation(&mut collected, level));
            if let Err(error) = followed {
                refused.push(Refused::Continuation(error));
            }
        }
        let Collected { mut minima, starts, .. } = collected;
        if minima.is_empty() {
            return Err(MinimaError::NoMinimum { starts, source });
        }
        minima.sort_by(|a, b| a.line.discrete_energy().total_cmp(&b.line.discrete_energy()));
        for minimum in &mut minima {
            minimum.word = punctures.word_between(problem.ends(), minimum.line.sequence().points());
        }
        Ok(Minima { minima, punctures, starts, refused })
    }

    fn punctures<M: Metric<D>>(&self, metric: &M) -> Result<Punctures, GraphPathError> {
        match (&self.punctures, &self.lattice) {
            (Some(punctures), _) => Ok(punctures.clone()),
            (None, Some(lattice)) => Punctures::prominent(&Plain::new(metric), lattice),
            (None, None) => Punctures::new(Vec::new()),
        }
    }

    fn by_classes<M: Metric<D>>(
        &self,
        collected: &mut Collected<'_, M, D>,
        lattice: &Lattice<D>,
        punctures: &Punctures,
    ) -> Result<(), GraphPathError> {
        let metric = Plain::new(collected.problem.metric());
        let graph = LatticeGraph::usual(&metric, lattice.clone());
        let ends = collected.problem.ends();
        for path in class_paths(&graph, ends, punctures, self.most, self.slack)? {
            collected
                .solve(path.path().sequence(collected.n).ok(), &Origin::Class(path.word().clone()));
        }
        Ok(())
    }

    fn by_passes<M: Metric<D>>(
        &self,
        collected: &mut Collected<'_, M, D>,
        lattice: &Lattice<D>,
    ) -> Result<(), EikonalError> {
        let problem = collected.problem;
        for path in pass_paths(problem.metric(), problem.ends(), lattice, self.most, self.slack)? {
            collected.solve(path.sequence(collected.n).ok(), &Origin::Pass(*path.pass()));
        }
        Ok(())
    }

    fn by_continuation<M: Metric<D>>(
        &self,
        collected: &mut Collected<'_, M, D>,
        level: f64,
    ) -> Result<(), SolveError> {
        let Collected { problem, rule, n, .. } = *collected;
        let metric = problem.metric();
        let shares: Vec<f64> =
            (0..=self.steps).map(|step| step as f64 / self.steps as f64).collect();
        let family = |share| Flattened { metric, level, share };
        let branches = follow(family, &shares, problem.ends(), rule, n, self.most)?;
        for branch in branches {
            let start = branch.line.sequence().clone();
            collected.solve(Some(start), &Origin::Continuation { since: branch.since });
        }
        Ok(())
    }
}

/// The minima so far.
struct Collected<'p, M: Metric<D>, const D: usize> {
    problem: &'p Problem<M, D>,
    rule: Rule,
    n: usize,
    minima: Vec<LocalMinimum<M, D>>,
    starts: usize,
}

impl<M: Metric<D>, const D: usize> Collected<'_, M, D> {
    /// Searches from a start, if there is one.
    fn solve(&mut self, start: Option<PointSequence<D>>, origin: &Origin<D>) {
        self.starts += 1;
        let Some(start) = start else { return };
        let starts = Starts::OnTheGrid(vec![start]);
        let options = Options { starts, ..Options::default() };
        if let Ok(line) = self.problem.solve_with(self.rule, self.n, &options) {
            self.keep(line, origin);
        }
    }

    /// Keeps a line that is a minimum and no other one, or a lower one.
    fn keep(&mut self, line: TautLine<M, D>, origin: &Origin<D>) {
        if !is_minimum(line.minimum()) {
            return;
        }
        let is_same =
            |known: &&mut LocalMinimum<M, D>| !are_apart(line.sequence(), known.line.sequence());
        match self.minima.iter_mut().find(is_same) {
            Some(known) => {
                known.hits += 1;
                if line.discrete_energy() < known.line.discrete_energy() {
                    known.line = line;
                }
            }
            None => self.minima.push(LocalMinimum {
                line,
                word: Default::default(),
                origin: origin.clone(),
                hits: 1,
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use tautline::{Ends, Metric, Options, PointSequence, Problem, Rule, Scalar, Starts};

    use super::Collected;
    use crate::Origin;

    /// Two valleys, along `y = ±w` with `w = 10⁻²`, of which the lower one is a little deeper.
    #[derive(Debug)]
    struct Valleys;

    impl Metric<2> for Valleys {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let ridge = ((x[1] * 100.0).sqr() - 1.0).sqr();
            SMatrix::from_diagonal_element(ridge + x[1] + 1.0)
        }
    }

    /// The valleys are 1 % of the length of a curve apart, so that they count as one: its minimum is the
    /// deeper one, in either order.
    #[test]
    fn of_two_minima_along_one_curve_the_lower_is_kept() {
        let ends = Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite");
        let problem = Problem::new(Valleys, ends);
        let along = |y: f64| {
            let points = (0..=16).map(|k| {
                let y = if k == 0 || k == 16 { 0.0 } else { y };
                SVector::from([f64::from(k) / 8.0 - 1.0, y])
            });
            let start = PointSequence::new(points.collect()).expect("finite");
            let options = Options { starts: Starts::OnTheGrid(vec![start]), ..Options::default() };
            problem.solve_with(Rule::TRAPEZOIDAL, 16, &options).expect("solved")
        };
        let energies = [0.01, -0.01].map(|y| along(y).discrete_energy());
        assert!(energies[1] < energies[0], "{energies:?}");
        for order in [[0.01, -0.01], [-0.01, 0.01]] {
            let problem = &problem;
            let (rule, n) = (Rule::TRAPEZOIDAL, 16);
            let mut collected = Collected { problem, rule, n, minima: Vec::new(), starts: 0 };
            for y in order {
                collected.keep(along(y), &Origin::Automatic);
            }
            let [only] = &collected.minima[..] else { panic!("{}", collected.minima.len()) };
            assert_eq!((only.line.discrete_energy(), only.hits), (energies[1], 2));
        }
    }

    /// A search that is stopped before it converges leads to no minimum.
    #[test]
    fn what_is_no_minimum_is_not_kept() {
        let ends = Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite");
        let problem = Problem::new(Valleys, ends);
        let options = Options { iterations: 1, ..Options::default() };
        let line = problem.solve_with(Rule::TRAPEZOIDAL, 16, &options).expect("solved");
        assert!(!line.minimum().is_local_minimum());
        let (problem, rule) = (&problem, Rule::TRAPEZOIDAL);
        let mut collected = Collected { problem, rule, n: 16, minima: Vec::new(), starts: 0 };
        collected.keep(line, &Origin::Automatic);
        assert!(collected.minima.is_empty());
    }
}
