//! `LocalSearch`: Newton's method on one grid, with [damped steps](LocalSearch::damped_step).

use tautline_discretizations::{ANY, PointSequence, QuadraticModel};
use tautline_metrics::MetricError;
use tautline_sets::AnySet;

use crate::{
    Curvature, Iterate, SolveError, Stop,
    newton::{
        discrete_energy::DiscreteEnergy,
        factorization::Factorization,
        magnitude::Magnitude,
        reduced_system::ReducedSystem,
        residual::Residual,
        rounding::{is_rounding, margin},
    },
    search::damping::Damping,
    watch::Watch,
};

/// A local search for one problem on one grid.
#[derive(Clone, Copy)]
pub(crate) struct LocalSearch<'a> {
    pub(crate) energy: &'a DiscreteEnergy<'a>,
    pub(crate) ends: [&'a dyn AnySet; 2],
    pub(crate) iterations: usize,
    pub(crate) threads: usize,
    pub(crate) watch: &'a dyn Watch,
}

/// The result of a local search.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) sequence: PointSequence<ANY>,
    pub(crate) energy: f64,
    /// The mean of `tr H / D` over the nodes, in `m²/ℓ²`.
    pub(crate) mean_gram: f64,
    pub(crate) decrement: f64,
    pub(crate) residual: f64,
    pub(crate) residual_floor: f64,
    pub(crate) stop: Stop,
    pub(crate) curvature: Curvature,
    pub(crate) iterations: usize,
    /// The relative decrement at the start.
    pub(crate) from: f64,
}

/// What to do after an iterate.
pub(crate) enum Next {
    /// Go on from points with these coordinates.
    Move(Vec<f64>),
    /// End here.
    End { stop: Stop, curvature: Curvature, decrement: f64 },
    /// End at these points, which are one small Newton step beyond a positive definite Hessian.
    EndAt { points: Vec<f64>, energy: f64, slopes: Vec<f64>, decrement: f64 },
}

impl Found {
    pub(crate) fn magnitude(&self) -> Magnitude {
        Magnitude { energy: self.energy, mean_gram: self.mean_gram }
    }
}

impl LocalSearch<'_> {
    /// Searches from `start`, a sequence with both ends in their sets.
    ///
    /// # Errors
    ///
    /// If the metric is not finite, symmetric and positive definite at a node or an end of the
    /// result, or if the watcher has ended the solve.
    pub(crate) fn run(&self, start: PointSequence<ANY>) -> Result<Found, SolveError> {
        let mut sequence = start;
        let dimension = sequence.dimension();
        let mut damping = Damping::default();
        let (mut model, mut memory) = (QuadraticModel::default(), Factorization::default());
        for iteration in 0.. {
            self.energy.expand(&sequence, &mut model);
            if !self.watch.goes_on(&|| self.iterate(iteration, &sequence, &model)) {
                return Err(SolveError::Interrupted { n: sequence.n().get() });
            }
            let next = if iteration == self.iterations {
                self.give_up(&model, &sequence)
            } else if is_rounding(&model, &sequence) {
                let curvature = Curvature::PositiveDefinite;
                Next::End { stop: Stop::EndsTouch, curvature, decrement: 0.0 }
            } else {
                self.damped_step(&model, &sequence, &mut damping, &mut memory)
            };
            let (stop, curvature, decrement, energy, slopes) = match next {
                Next::Move(points) => {
                    sequence = PointSequence::from_coordinates(dimension, points)
                        .expect("a trial is checked");
                    continue;
                }
                Next::End { stop, curvature, decrement } => {
                    (stop, curvature, decrement, model.energy, std::mem::take(&mut model.slopes))
                }
                Next::EndAt { points, energy, slopes, decrement } => {
                    sequence = PointSequence::from_coordinates(dimension, points)
                        .expect("a trial is checked");
                    let curvature = Curvature::PositiveDefinite;
                    (Stop::Converged, curvature, decrement, energy, slopes)
                }
            };
            self.check(&sequence)?;
            let mean_gram = model.mean_gram;
            let magnitude = Magnitude { energy, mean_gram };
            let mut residual = Residual::new(dimension, sequence.n().get(), magnitude);
            residual.push_all(&slopes);
            let (residual, residual_floor) = residual.value(self.ends, &sequence, magnitude);
            let decrement = magnitude.relative(decrement);
            return Ok(Found {
                sequence,
                energy,
                mean_gram,
                decrement,
                residual,
                residual_floor,
                stop,
                curvature,
                iterations: iteration + 1,
                from: f64::INFINITY,
            });
        }
        unreachable!("the loop ends at the limit of iterations")
    }

    /// Returns what the watcher sees of an iterate.
    fn iterate<'i>(
        &self,
        iteration: usize,
        sequence: &'i PointSequence<ANY>,
        model: &QuadraticModel,
    ) -> Iterate<'i, ANY> {
        let magnitude = Magnitude::of(model);
        let mut residual = Residual::new(model.dimension, sequence.n().get(), magnitude);
        residual.push_all(&model.slopes);
        let (residual, residual_floor) = residual.value(self.ends, sequence, magnitude);
        Iterate { iteration, energy: model.energy, residual, residual_floor, sequence }
    }

    /// Moves all points by `scale · step`, and projects the ends back to their sets.
    pub(crate) fn retract(
        &self,
        sequence: &PointSequence<ANY>,
        step: &[f64],
        scale: f64,
    ) -> Vec<f64> {
        let coordinates = sequence.coordinates().iter().zip(step);
        let mut points: Vec<f64> = coordinates.map(|(x, s)| x + s * scale).collect();
        self.project_ends(&mut points);
        points
    }

    /// Moves both ends to the nearest points of their sets.
    pub(crate) fn project_ends(&self, points: &mut [f64]) {
        let d = self.energy.dimension();
        let last = points.len() - d;
        self.ends[0].project(&mut points[..d]);
        self.ends[1].project(&mut points[last..]);
    }

    /// Ends a search that has used up its steps.
    fn give_up(&self, model: &QuadraticModel, sequence: &PointSequence<ANY>) -> Next {
        let system = ReducedSystem::new(model, self.ends, sequence.coordinates(), 0.0);
        let decrement = system
            .factorize()
            .map_or(f64::INFINITY, |factorization| system.newton_step(&factorization).decrement);
        let curvature = self.curvature(model, sequence);
        Next::End { stop: Stop::IterationLimit, curvature, decrement }
    }

    /// Returns the signature of the Hessian. Eigenvalues within rounding of zero count as zero.
    pub(crate) fn curvature(
        &self,
        model: &QuadraticModel,
        sequence: &PointSequence<ANY>,
    ) -> Curvature {
        let reduce = |shift| ReducedSystem::new(model, self.ends, sequence.coordinates(), shift);
        if reduce(0.0).factorize().is_some() {
            return Curvature::PositiveDefinite;
        }
        match reduce(2.0 * margin(sequence.n().get())).negative_eigenvalues() {
            0 => Curvature::Degenerate,
            negative => Curvature::Indefinite { negative },
        }
    }

    /// Checks the metric at every node. An end that is no node may have none: the cost `1/√x` is
    /// integrable from 0, and so is the speed `√x`. If a node has none, the defect of an end comes first,
    /// for there it begins.
    pub(crate) fn check(&self, sequence: &PointSequence<ANY>) -> Result<(), MetricError> {
        self.energy.check_nodes(sequence).or_else(|defect| {
            for x in [sequence.row(0), sequence.row(sequence.n().get())] {
                self.energy.check_at(x)?;
            }
            Err(defect)
        })
    }
}
