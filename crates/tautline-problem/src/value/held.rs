//! `Held`: a metric in its dimension, behind a trait that does not know it.

use core::ops::ControlFlow::{Break, Continue};
use std::{fmt::Debug, sync::Arc};

use tautline::{
    Ends, Metric, Options, PointSequence, Prepared, Problem, Rule, SolveError, Table, TautLine,
    certify::Watch, solve_all,
};

use super::{
    Found, Given, GivenError, Least, Proofs, Region, Request, Shape,
    avoiding::avoiding,
    sets::{check_coordinates, point, set},
};
use crate::{
    ConstantsAnswer, Grid, LEAST_TOLERANCE,
    constants::{ConstantsError, constants},
    known::Known,
    reading::shape::vector,
    solve::{FIRST_GRID, least_entry, refined},
};

/// What can be done with a metric without knowing its dimension.
pub(super) trait AnyDimension: Debug + Send + Sync {
    fn dimension(&self) -> usize;
    fn text(&self) -> Option<String>;
    fn tables(&self) -> &[Arc<dyn Table>];
    fn gram(&self, x: &[f64]) -> Vec<f64>;
    fn is_positive_everywhere(&self) -> bool;
    fn least_entry_along(&self, points: &[f64]) -> Result<Option<Least>, GivenError>;
    fn avoiding(&self, regions: &[Region], margin: f64) -> Result<Given, GivenError>;
    fn constants(
        &self,
        within: Option<&Shape>,
        proofs: &Proofs,
        watch: &dyn Watch,
    ) -> Result<ConstantsAnswer, GivenError>;
    fn solve(&self, ends: [&[Shape]; 2], request: &Request, goes_on: &dyn Fn() -> bool) -> Found;
    fn solve_all(&self, ends: &[[&[Shape]; 2]], request: &Request) -> Vec<Found>;
}

/// A metric in `D` dimensions.
#[derive(Debug)]
pub(super) struct Held<const D: usize>(pub(super) Arc<Prepared<Known<D>, D>>);

impl<const D: usize> Held<D> {
    fn problem(&self, pieces: [&[Shape]; 2]) -> Result<Problem<Known<D>, D>, GivenError> {
        let ends = match pieces {
            // Of two points more is proved.
            [[Shape::Point(a)], [Shape::Point(b)]] => {
                Ends::points(point::<D>(a.position_slice())?, point::<D>(b.position_slice())?)?
            }
            [from, to] => Ends::new(set("first", from)?, set("second", to)?)?,
        };
        Ok(Problem::with_prepared(Arc::clone(&self.0), ends))
    }

    fn by(problem: &Problem<Known<D>, D>, request: &Request, goes_on: &dyn Fn() -> bool) -> Found {
        let (rule, options) = (request.rule, request.options::<D>()?);
        let lattice = request.lattice.as_ref();
        let lattice = lattice
            .map(|nodes| nodes.lattice::<D>().map(|lattice| (nodes, lattice)))
            .transpose()?;
        held(match (request.grid, lattice) {
            (Grid::Chords(n), None) => problem.solve_with(rule, n, &options),
            (Grid::Chords(n), Some((nodes, lattice))) => {
                Ok(nodes.solve(problem, rule, n, &lattice, &options)?)
            }
            (Grid::Tolerance(_), Some(_)) => return Err(GivenError::LatticeAndTolerance),
            (Grid::Tolerance(tolerance), None) => {
                if !(LEAST_TOLERANCE..1.0).contains(&tolerance) {
                    return Err(GivenError::Tolerance { tolerance });
                }
                let line = problem.solve_with(rule, FIRST_GRID, &options)?;
                let go_on = || if goes_on() { Continue(()) } else { Break(()) };
                Ok(refined(problem, rule, line, tolerance, &options, &mut |_| go_on()))
            }
        })
    }

    fn all_by(
        problems: Vec<Result<Problem<Known<D>, D>, GivenError>>,
        rule: Rule,
        n: usize,
        options: &Options<D>,
    ) -> Vec<Found> {
        let posed: Vec<_> = problems.iter().filter_map(|problem| problem.as_ref().ok()).collect();
        let posed: Vec<Problem<Known<D>, D>> = posed.into_iter().cloned().collect();
        let mut solved = solve_all(&posed, rule, n, options).into_iter();
        let next = |problem: Result<_, _>| {
            problem.and_then(|_| held(solved.next().unwrap_or(Err(SolveError::NoStart))))
        };
        problems.into_iter().map(next).collect()
    }
}

fn held<const D: usize>(line: Result<TautLine<Known<D>, D>, SolveError>) -> Found {
    Ok(Arc::new(line?))
}

impl<const D: usize> AnyDimension for Held<D> {
    fn dimension(&self) -> usize {
        D
    }

    fn text(&self) -> Option<String> {
        self.0.metric().formula().ok().map(ToString::to_string)
    }

    fn tables(&self) -> &[Arc<dyn Table>] {
        self.0.metric().tables()
    }

    fn gram(&self, x: &[f64]) -> Vec<f64> {
        self.0.metric().gram(&vector::<D>(x)).as_slice().to_vec()
    }

    fn is_positive_everywhere(&self) -> bool {
        self.0.metric().is_positive_everywhere()
    }

    fn least_entry_along(&self, points: &[f64]) -> Result<Option<Least>, GivenError> {
        let points = PointSequence::new(points.chunks(D).map(vector::<D>).collect());
        Ok(least_entry(&*self.0, &points?).map(|(x, value)| (value, x.as_slice().to_vec())))
    }

    fn avoiding(&self, regions: &[Region], margin: f64) -> Result<Given, GivenError> {
        let formula = self.0.metric().formula().map_err(|_| GivenError::NoFormula)?;
        avoiding(formula, regions, margin)
    }

    fn constants(
        &self,
        within: Option<&Shape>,
        proofs: &Proofs,
        watch: &dyn Watch,
    ) -> Result<ConstantsAnswer, GivenError> {
        if let Some(shape) = within {
            check_coordinates::<D>(shape)?;
        }
        let formula = self.0.metric().formula().map_err(ConstantsError::NotRecorded)?;
        Ok(constants(formula, within, proofs.accuracy(D), watch)?)
    }

    fn solve(&self, ends: [&[Shape]; 2], request: &Request, goes_on: &dyn Fn() -> bool) -> Found {
        let problem = self.problem(ends)?;
        Self::by(&problem, request, goes_on)
    }

    fn solve_all(&self, ends: &[[&[Shape]; 2]], request: &Request) -> Vec<Found> {
        let (Grid::Chords(n), None) = (request.grid, &request.lattice) else {
            return ends.iter().map(|&ends| self.solve(ends, request, &|| true)).collect();
        };
        let options = match request.options::<D>() {
            Ok(options) => options,
            Err(error) => return vec![Err(error); ends.len()],
        };
        let problems = ends.iter().map(|&ends| self.problem(ends)).collect();
        Self::all_by(problems, request.rule, n, &options)
    }
}
