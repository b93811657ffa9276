//! L-BFGS, by the library `basin`.

use std::convert::Infallible;

use basin::{
    CostFunction, Executor, FirstOrderState, Gradient, GradientState, HagerZhang, Lbfgs, State,
    StepOutcome,
};
use nalgebra::SVector;
use tautline::{
    Batches, LinearModel, Node, PointSequence, Rule, Watcher, admissible_energy, coordinates,
};

use crate::descent::{
    Descended, DescentError, Ended, Limits,
    laplacian::Laplacian,
    search::{Here, Search},
};

/// The number of steps that L-BFGS remembers.
const MEMORY: usize = 10;

/// By this multiple of itself an energy may rise in a line search, since sums are rounded.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// After this many steps in a row without a lower energy, what is left is rounding.
const PATIENCE: usize = 3 * MEMORY;

/// The coordinates in which L-BFGS works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinates {
    /// The inner points, as most codes take them. The condition number of the Hessian grows like
    /// `N²`, and the number of steps like `N`.
    Points,
    /// `y = Lᵀx` with the factor `L` of the second differences `T = L Lᵀ`. The condition number does
    /// not grow with `N`.
    Sobolev,
}

/// Minimises a discrete energy between the ends of `start` by L-BFGS with ten remembered steps and
/// the line search of Hager and Zhang, which turns back where there is no metric.
///
/// `watcher` sees each iterate, and can end the descent.
///
/// # Errors
///
/// [`DescentError`]: the start has no metric or no finite energy.
///
/// # Source
///
/// J. Nocedal, S. J. Wright, Numerical Optimization, 2nd edition, Algorithm 7.5; W. W. Hager,
/// H. Zhang, ACM Trans. Math. Softw. 32 (2006); the library `basin`.
pub fn lbfgs<'a, const D: usize>(
    metric: &'a dyn Batches<D>,
    rule: Rule,
    start: PointSequence<D>,
    coordinates: Coordinates,
    limits: &Limits,
    watcher: &'a mut Watcher<'a, D>,
) -> Result<Descended<D>, DescentError> {
    let (mut search, mut here) = Search::begin(metric, rule, start, limits, watcher)?;
    if let Some(ended) = search.end_at(&here, 0) {
        return Ok(search.descended(here, ended, 0));
    }
    let n = here.sequence.n().get();
    let laplacian = (coordinates == Coordinates::Sobolev).then(|| Laplacian::new(n));
    let points = here.sequence.points().to_vec();
    let (laplacian, points) = (laplacian.as_ref(), &points[..]);
    let (unit, scale) = (here.energy(), (here.stiffness() / here.energy()).sqrt());
    let energy = EnergyOf { metric, nodes: rule.nodes(), points, laplacian, unit, scale };
    let begin = FirstOrderState::new(vec![0.0; (n - 1) * D]);
    let mut line_search = HagerZhang::new();
    line_search.epsilon = ROUNDING;
    let solver = Lbfgs::with_line_search(line_search).with_m_capacity(MEMORY).unbounded();
    // The limit of steps is checked here, and not by the library as well.
    let executor = Executor::new(energy, solver, begin).max_iter(u64::MAX);
    let Ok(mut stepper) = executor.into_stepper();
    let mut lowest = (here.energy(), 0);
    for iteration in 1.. {
        let Ok(outcome) = stepper.step();
        search.evaluations = 1 + stepper.state().cost_evals() as usize;
        let y = stepper.state().param();
        let stalled = matches!(outcome, StepOutcome::Stopped(_));
        let (cost, slope) = (stepper.state().cost(), stepper.state().gradient());
        if !stalled && let Some(there) = energy.here(y, cost, slope) {
            here = there;
            let ended = search.end_at(&here, iteration);
            if here.energy() < lowest.0 {
                lowest = (here.energy(), iteration);
            }
            let stalls = (iteration - lowest.1 >= PATIENCE).then_some(Ended::Stalled);
            if let Some(ended) = ended.or(stalls) {
                return Ok(search.descended(here, ended, iteration));
            }
        } else {
            return Ok(search.descended(here, Ended::Stalled, iteration - 1));
        }
    }
    unreachable!("a descent ends at its limit of steps")
}

/// The discrete energy, relative to that of the start, as a function of the coordinates `y` of a
/// displacement `x` of the inner points of the start: `y = s x` or `y = s Lᵀx`, where `s` makes the
/// Hessian about 1.
#[derive(Clone, Copy)]
struct EnergyOf<'e, const D: usize> {
    metric: &'e dyn Batches<D>,
    nodes: &'static [Node],
    points: &'e [SVector<f64, D>],
    laplacian: Option<&'e Laplacian>,
    /// The energy of the start, in `m²`.
    unit: f64,
    /// The scale `s`, in `1/ℓ`.
    scale: f64,
}

impl<const D: usize> EnergyOf<'_, D> {
    /// Returns all points at these coordinates.
    fn points_at(&self, y: &[f64]) -> Vec<SVector<f64, D>> {
        let mut moves: Vec<_> = y.chunks(D).map(SVector::<f64, D>::from_column_slice).collect();
        if let Some(laplacian) = self.laplacian {
            laplacian.backward(&mut moves);
        }
        let mut points = self.points.to_vec();
        points[1..].iter_mut().zip(moves).for_each(|(x, step)| *x += step / self.scale);
        points
    }

    /// Returns the iterate at these coordinates, with the relative energy and its gradient there.
    fn here(&self, y: &[f64], cost: f64, slope: Option<&Vec<f64>>) -> Option<Here<D>> {
        let sequence = PointSequence::new(self.points_at(y)).ok()?;
        let mut gradient: Vec<_> =
            slope?.chunks(D).map(SVector::<f64, D>::from_column_slice).collect();
        if let Some(laplacian) = self.laplacian {
            laplacian.multiply(&mut gradient);
        }
        gradient.iter_mut().for_each(|g| *g *= self.unit * self.scale);
        // The ends do not move, so that nothing depends on the gradients there.
        gradient.insert(0, SVector::zeros());
        gradient.push(SVector::zeros());
        let model = LinearModel::with_gradient(cost * self.unit, gradient);
        Some(Here { sequence, model })
    }
}

impl<const D: usize> CostFunction for EnergyOf<'_, D> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    /// Returns infinity where the metric is not positive, which makes a line search turn back.
    fn cost(&self, y: &Vec<f64>) -> Result<f64, Infallible> {
        let energy = admissible_energy(self.nodes, self.metric, coordinates(&self.points_at(y)));
        Ok(energy.map_or(f64::INFINITY, |energy| energy / self.unit))
    }
}

impl<const D: usize> Gradient for EnergyOf<'_, D> {
    type Gradient = Vec<f64>;

    fn gradient(&self, y: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        self.cost_and_gradient(y).map(|found| found.1)
    }

    fn cost_and_gradient(&self, y: &Vec<f64>) -> Result<(f64, Vec<f64>), Infallible> {
        let Ok(sequence) = PointSequence::new(self.points_at(y)) else {
            return Ok((f64::INFINITY, vec![0.0; y.len()]));
        };
        let model = LinearModel::by_batches(self.nodes, self.metric, &sequence);
        if !model.is_metric || !model.energy.is_finite() {
            return Ok((f64::INFINITY, vec![0.0; y.len()]));
        }
        let mut gradient = model.gradient::<D>()[1..sequence.n().get()].to_vec();
        if let Some(laplacian) = self.laplacian {
            laplacian.forward(&mut gradient);
        }
        let factor = 1.0 / (self.unit * self.scale);
        let gradient = gradient.iter().flat_map(|g| g.iter().map(|g| g * factor)).collect();
        Ok((model.energy / self.unit, gradient))
    }
}
