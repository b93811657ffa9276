//! The trust region method of argmin with Steihaug's conjugate gradients, in the comparison with
//! other programs. It is the only one of argmin's methods that needs no dense matrix and converges.
//!
//! `cargo xtask peers` runs this program once for each problem and `N`. Tautline supplies the
//! metrics and their derivatives.

mod discrete_energy;
#[path = "../../../crates/library/tautline/examples/peers/measurement.rs"]
mod measurement;
#[path = "../../../crates/library/tautline/examples/peers/problems.rs"]
mod problems;

use std::{env, path::PathBuf};

use argmin::{
    core::{
        Error, Executor, IterState, KV, Problem, Solver, State, TerminationReason,
        TerminationStatus,
    },
    solver::trustregion::{Steihaug, TrustRegion},
};
use discrete_energy::{ChordHessians, DiscreteEnergy};
use measurement::{cpu_time, report, time};
use problems::{Peer, pose};
use tautline::{Ends, Metric, PointSequence};

/// The largest number of steps of the trust region method. A search that converges takes fewer than
/// 30.
const ITERATIONS: u64 = 100;

type Subproblem = Steihaug<Vec<f64>, f64>;
type Iterate<const D: usize> = IterState<Vec<f64>, Vec<f64>, (), ChordHessians<D>, (), f64>;

/// The trust region method of argmin. It is stopped when the gradient is small, which argmin does
/// not do by itself.
#[derive(Clone)]
struct Stopping {
    inner: TrustRegion<Subproblem, f64>,
    tolerance: f64,
}

impl<M: Metric<D>, const D: usize> Solver<DiscreteEnergy<M, D>, Iterate<D>> for Stopping {
    fn name(&self) -> &str {
        "Trust region"
    }

    fn init(
        &mut self,
        problem: &mut Problem<DiscreteEnergy<M, D>>,
        state: Iterate<D>,
    ) -> Result<(Iterate<D>, Option<KV>), Error> {
        self.inner.init(problem, state)
    }

    fn next_iter(
        &mut self,
        problem: &mut Problem<DiscreteEnergy<M, D>>,
        state: Iterate<D>,
    ) -> Result<(Iterate<D>, Option<KV>), Error> {
        self.inner.next_iter(problem, state)
    }

    fn terminate(&mut self, state: &Iterate<D>) -> TerminationStatus {
        let largest = |g: &Vec<f64>| g.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        if state.get_gradient().is_some_and(|g| largest(g) <= self.tolerance) {
            return TerminationStatus::Terminated(TerminationReason::SolverConverged);
        }
        TerminationStatus::NotTerminated
    }
}

/// argmin with a tolerance for the gradient.
struct Argmin {
    tolerance: f64,
    points: PathBuf,
}

impl Peer for Argmin {
    fn solve<M: Metric<D>, const D: usize>(
        self,
        metric: M,
        ends: Ends<D>,
        start: PointSequence<D>,
    ) -> Result<(), Box<dyn std::error::Error>> {
        if !ends.are_points() {
            println!("unavailable=not applicable: joins points, not sets");
            return Ok(());
        }
        let inner: Vec<f64> =
            start.points()[1..start.n().get()].iter().flatten().copied().collect();
        println!("version=argmin 0.11.0\nset_up={}", cpu_time());
        let timed = time(|| {
            let problem = DiscreteEnergy { metric: &metric, start: start.clone() };
            // Steihaug's residual is the Euclidean norm of the gradient of the model.
            let steihaug = Steihaug::new().with_epsilon(self.tolerance)?;
            let solver = Stopping { inner: TrustRegion::new(steihaug), tolerance: self.tolerance };
            Executor::new(problem, solver)
                .configure(|state| state.param(inner.clone()).max_iters(ITERATIONS))
                .timer(false)
                .run()
        });
        let state = timed.result.as_ref().map_err(ToString::to_string)?.state();
        // The last iterate is used, not the best: rounded energies cannot distinguish it from
        // earlier ones.
        let last = state.get_param().ok_or("no iterate")?;
        let sequence = DiscreteEnergy { metric: &metric, start }.sequence(last)?;
        let stop = state.get_termination_status().to_string();
        report(&timed, state.get_iter(), &stop, sequence.points(), &self.points)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [problem, n, tolerance, points] = arguments.as_slice() else {
        return Err("usage: argmin-peer PROBLEM N TOLERANCE FILE".into());
    };
    let peer = Argmin { tolerance: tolerance.parse()?, points: points.into() };
    pose(problem, n.parse()?, peer)
}
