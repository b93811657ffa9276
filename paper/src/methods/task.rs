//! `Task`: two points under a metric, and the answer of each method.

use std::ops::ControlFlow;

use tautline::{
    Bounded, Ends, Iterate, Lattice, Minimum, Nodes, Options, PointSequence, Prepared, Problem,
    Request, Rule, SVector, Scope, Starts, TautLine,
    grid::{Eikonal, Order, graph},
    norm_squared,
};
use tautline_baselines::{
    collocation::{Collocation, collocate},
    descent::{
        Coordinates, Descended, Ended, Limits, SecondOrder, dynamic_programming, lbfgs,
        sobolev_descent,
    },
    equal_speeds::equal_speeds,
    geodesic_calculus::discrete_logarithm,
    shooting::{Integration, Shooting, shoot},
};

use super::method::{Method, Setting};
use crate::Failure;

/// Two points under a metric.
#[derive(Clone, Debug)]
pub(crate) struct Task<M, const D: usize> {
    /// The metric.
    pub(crate) metric: M,
    /// The points.
    pub(crate) ends: [SVector<f64, D>; 2],
    /// The lowest and the highest corner of the box of all lattices.
    pub(crate) corners: [SVector<f64, D>; 2],
}

/// What a method found.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Answer<const D: usize> {
    /// The distance by the method's own count, in `m`. For a point sequence it is `√E_N`.
    pub(crate) distance: f64,
    /// The number of its steps, if it counts them: those of Newton or of a descent, or the nodes of a
    /// lattice that it opened.
    pub(crate) steps: Option<usize>,
    /// The points of its curve, if it is a sequence or a path along a lattice.
    pub(crate) sequence: Option<PointSequence<D>>,
}

/// The most steps along one shot. On the problems here, geodesics that are not many times longer than
/// the distance need a few hundred.
const STEPS: usize = 500;

/// The number of cells along each axis of the lattices for classes, and how many classes are tried.
const PLANE: usize = 64;
const SPACE: usize = 16;
const CLASSES: usize = 16;

/// The number of chords into which a path along a lattice is divided.
const DIVIDED: usize = 64;

impl<M: Bounded<D> + Clone, const D: usize> Task<M, D> {
    /// Returns the answer of a method. All searches run on one thread.
    ///
    /// # Errors
    ///
    /// What the method refuses, or that its search ended before it was done.
    pub(crate) fn answer(&self, method: Method, setting: Setting) -> Result<Answer<D>, Failure> {
        let [x, y] = self.ends;
        let ends = Ends::points(x, y)?;
        let straight = |n| PointSequence::straight(x, y, n);
        match (method, setting) {
            (Method::Trapezoidal, Setting::Chords(n)) => {
                Answer::of_minimum(self.solve(Rule::TRAPEZOIDAL, n, Starts::Automatic)?.minimum())
            }
            (Method::Extrapolated, Setting::Chords(n)) => {
                let line = self.solve(Rule::TRAPEZOIDAL, n, Starts::Automatic)?;
                let none = || Failure::Unfinished("there is one grid only".to_owned());
                let estimate = line.distance_squared_estimate().ok_or_else(none)?;
                let answer = Answer::of_minimum(line.minimum())?;
                Ok(Answer { distance: estimate.value.sqrt(), ..answer })
            }
            (Method::LeftEndpoint, Setting::Chords(n)) => {
                Answer::of_minimum(self.solve(Rule::LEFT_ENDPOINT, n, Starts::Automatic)?.minimum())
            }
            (Method::FromTheLine, Setting::Chords(n)) => {
                let starts = Starts::Only(vec![straight(n)?]);
                Answer::of_minimum(self.solve(Rule::TRAPEZOIDAL, n, starts)?.minimum())
            }
            (Method::Classes, Setting::Chords(n)) => {
                let [lower, upper] = self.corners.map(|corner| corner.as_slice().to_vec());
                let cells = if D <= 2 { PLANE } else { SPACE };
                let spacing = self.spacing(cells).as_slice().to_vec();
                let nodes = Nodes { lower, upper, spacing, classes: CLASSES };
                let request = Request { lattice: Some(nodes), threads: 1, ..Request::chords(n) };
                let problem = Problem::new(self.metric.clone(), ends);
                Answer::of_minimum(problem.answer(&request)?.minimum())
            }
            (Method::DiscreteLogarithm, Setting::Chords(n)) => {
                let v = discrete_logarithm(&self.metric, &x, &y, n)?;
                let distance = norm_squared(&self.metric, &x, &v).sqrt();
                Ok(Answer { distance, steps: None, sequence: None })
            }
            (Method::EqualSpeeds, Setting::Chords(n)) => {
                // From the minimiser without constraints. From the straight line the search takes thousands
                // of steps on some problems, or does not arrive.
                let free = self.solve(Rule::LEFT_ENDPOINT, n, Starts::Only(vec![straight(n)?]))?;
                let first = free.minimum().iterations;
                let start = free.sequence().clone();
                let found = self.descend(method, start)?;
                Ok(Answer { steps: found.steps.map(|steps| first + steps), ..found })
            }
            (_, Setting::Chords(n)) => self.descend(method, straight(n)?),
            (Method::Shooting, Setting::Tolerance(tolerance)) => {
                let integration = Integration { tolerance, steps: STEPS };
                let shot =
                    shoot(&self.metric, &ends, &Shooting { integration, ..Shooting::default() })?;
                let distance = shot.geodesic.length();
                Ok(Answer { distance, steps: Some(shot.iterations), sequence: None })
            }
            (Method::Collocation, Setting::Tolerance(tolerance)) => {
                let options = Collocation { tolerance, intervals: 4, ..Collocation::default() };
                let found = collocate(&self.metric, &ends, &options)?;
                let (distance, steps) = (found.length, Some(found.iterations));
                Ok(Answer { distance, steps, sequence: None })
            }
            (Method::LatticePath, Setting::Edges { cells, reach }) => {
                let lattice = self.lattice(cells)?;
                let constants = self.metric.constants();
                let path = graph(&self.metric, &ends, &lattice, reach, Some(&constants))?;
                let sequence = Some(path.sequence(DIVIDED)?);
                Ok(Answer { distance: path.length(), steps: Some(path.opened()), sequence })
            }
            (Method::FirstOrderMarch, Setting::Cells(cells)) => {
                self.march(cells, Order::First, &ends)
            }
            (Method::SecondOrderMarch, Setting::Cells(cells)) => {
                self.march(cells, Order::Second, &ends)
            }
            _ => Err(Failure::Unfinished(format!("{setting} is not a setting of this method"))),
        }
    }

    /// Solves on one thread, like all other methods here.
    pub(crate) fn solve(
        &self,
        rule: Rule,
        n: usize,
        starts: Starts<D>,
    ) -> Result<TautLine<M, D>, Failure> {
        let [x, y] = self.ends;
        let problem = Problem::new(self.metric.clone(), Ends::points(x, y)?);
        // From these starts alone: what a lattice adds is a method of its own.
        let options = Options { starts, scope: Scope::Local, threads: 1, ..Options::default() };
        Ok(problem.solve_with(rule, n, &options)?)
    }

    /// Descends from a start.
    fn descend(&self, method: Method, start: PointSequence<D>) -> Result<Answer<D>, Failure> {
        let metric = Prepared::new(self.metric.clone());
        let limits = Limits::default();
        let unseen = &mut |_: &Iterate<'_, D>| ControlFlow::Continue(());
        let rule = Rule::TRAPEZOIDAL;
        let descended = match method {
            Method::LbfgsPoints => {
                lbfgs(&metric, rule, start, Coordinates::Points, &limits, unseen)?
            }
            Method::LbfgsSobolev => {
                lbfgs(&metric, rule, start, Coordinates::Sobolev, &limits, unseen)?
            }
            Method::SobolevGradient => sobolev_descent(&metric, rule, start, &limits, unseen)?,
            Method::DynamicProgramming => {
                dynamic_programming(&metric, rule, start, SecondOrder::Full, &limits, unseen)?
            }
            Method::GaussNewton => {
                let form = SecondOrder::GaussNewton;
                dynamic_programming(&metric, rule, start, form, &limits, unseen)?
            }
            Method::EqualSpeeds => {
                equal_speeds(&metric, Rule::LEFT_ENDPOINT, start, &limits, unseen)?.descended
            }
            _ => return Err(Failure::Unfinished(format!("{} is no descent", method.name()))),
        };
        if descended.ended != Ended::Stationary {
            let Descended { ended, residual, iterations, .. } = descended;
            let how = format!("{ended:?} after {iterations} steps, residual {residual:.1e}");
            return Err(Failure::Unfinished(how));
        }
        Ok(Answer {
            distance: descended.energy.sqrt(),
            steps: Some(descended.iterations),
            sequence: Some(descended.sequence),
        })
    }

    /// Returns the value of a march from the first point at the second one.
    fn march(&self, cells: usize, order: Order, ends: &Ends<D>) -> Result<Answer<D>, Failure> {
        let lattice = self.lattice(cells)?;
        // The geometric mean of the spacing and of a quarter of the box, see `with_band`.
        let band = (0.25 * cells as f64).sqrt();
        let equation = Eikonal::new(&self.metric, &lattice)?.with_band(band)?;
        let distances = equation.distances_from(&**ends.first(), order)?;
        let (_, distance) = distances.nearest_in(&**ends.second())?;
        Ok(Answer { distance, steps: Some(lattice.nodes()), sequence: None })
    }

    fn lattice(&self, cells: usize) -> Result<Lattice<D>, Failure> {
        let [low, high] = self.corners;
        Ok(Lattice::with_spacings(low, high, self.spacing(cells))?)
    }

    fn spacing(&self, cells: usize) -> SVector<f64, D> {
        let [low, high] = self.corners;
        (high - low) / cells as f64
    }
}

impl<const D: usize> Answer<D> {
    fn of_minimum(minimum: &Minimum<D>) -> Result<Self, Failure> {
        if !minimum.is_local_minimum() {
            let Minimum { stop, curvature, .. } = minimum;
            return Err(Failure::Unfinished(format!("{stop:?}, {curvature:?}")));
        }
        Ok(Self {
            distance: minimum.energy.sqrt(),
            steps: Some(minimum.iterations),
            sequence: Some(minimum.sequence.clone()),
        })
    }
}
