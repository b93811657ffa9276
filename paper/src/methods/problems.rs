//! The three problems on which methods are timed: a sphere, a stirred space, and six waves.

use std::time::Instant;

use tautline::{
    Bounded, KnownDistance, SMatrix, SVector,
    composition::{AffinePullback, Product},
    gallery::{Ramp, Separable, SpherePatch, Swirl},
};

use super::{
    method::{Method, Setting},
    task::Task,
};
use crate::{
    Failure,
    data::{Data, Tolerance},
};

/// A problem that hides its metric and its dimension.
pub(crate) struct Problem {
    /// Its name in figures, tables and data.
    pub(crate) name: &'static str,
    /// The dimension `D`.
    pub(crate) dimension: usize,
    /// The distance, in `m`.
    pub(crate) distance: f64,
    measure: Measure,
}

type Measure = Box<dyn Fn(Method, Setting, bool) -> Measured>;

/// What was measured of one method with one setting.
struct Measured {
    /// The distance, in `m`, and the number of steps, or why there are none.
    found: Result<(f64, Option<usize>), Failure>,
    /// The time, in seconds.
    seconds: f64,
}

/// Returns an empty table for the [rows](Problem::row) of problems.
pub(crate) fn columns() -> Data {
    // Searches end at residuals of 10⁻⁶, whose squares are errors, also relative to a coarser error;
    // shots and integrals carry a few hundred roundings. What a coarse tolerance leaves depends on the
    // sizes of all steps before it, which are continuous.
    let error = Tolerance::Close { relative: 2e-2, absolute: 1e-9 };
    // A last bit decides whether one step more is taken, and quasi-Newton methods remember it.
    let steps = Tolerance::Close { relative: 0.1, absolute: 2.0 };
    Data::new(&[
        ("problem method setting", Tolerance::Exact),
        ("error", error),
        ("steps", steps),
        ("reason", Tolerance::Exact),
        ("seconds", Tolerance::Free),
    ])
}

/// A time is the least of runs that take this long together, in seconds, or of so many.
const LONG: f64 = 0.2;
const RUNS: usize = 20;

impl Problem {
    fn new<M, const D: usize>(name: &'static str, task: Task<M, D>) -> Result<Self, Failure>
    where
        M: Bounded<D> + KnownDistance<D> + Clone + 'static,
    {
        let [x, y] = &task.ends;
        let distance = task.metric.distance(x, y).ok_or(Failure::NoReference(name))?;
        let measure = move |method, setting, repeated| {
            let run = || {
                let begun = Instant::now();
                let found = task.answer(method, setting);
                (found, begun.elapsed().as_secs_f64())
            };
            let (found, mut seconds) = run();
            let (mut sum, mut runs) = (seconds, 1);
            while repeated && sum < LONG && runs < RUNS {
                let again = run().1;
                seconds = seconds.min(again);
                sum += again;
                runs += 1;
            }
            let found = found.map(|answer| (answer.distance, answer.steps));
            Measured { found, seconds }
        };
        Ok(Self { name, dimension: D, distance, measure: Box::new(measure) })
    }

    /// Lets a method solve the problem, several times if its time is to be exact, and returns a row of
    /// the [`columns`].
    pub(crate) fn row(&self, method: Method, setting: Setting, repeated: bool) -> Vec<String> {
        let Measured { found, seconds } = (self.measure)(method, setting, repeated);
        let name = [self.name, method.name()].map(str::to_owned);
        let [error, steps, reason] = match found {
            Ok((distance, steps)) => {
                let error = format!("{:.2e}", distance / self.distance - 1.0);
                [error, steps.map_or(String::new(), |steps| steps.to_string()), String::new()]
            }
            Err(failure) => [String::new(), String::new(), failure.to_string()],
        };
        let results = [setting.to_string(), error, steps, reason, format!("{seconds:.2e}")];
        name.into_iter().chain(results).collect()
    }
}

/// Returns the problems.
pub(crate) fn problems() -> Result<Vec<Problem>, Failure> {
    // Behind the sphere. The chart is the projection from the pole: the line through the origin
    // leads the long way round, 1.5 times as far, and nearly along a geodesic.
    // For these ends shooting finds it with all tolerances; for others nearby it finds the short way, or
    // winds round the sphere, where a last bit may decide how often.
    let sphere = Task {
        metric: SpherePatch::new(4.0)?,
        ends: [[1.3, 0.0].into(), [-1.22, 0.45].into()],
        corners: [[-3.6; 2].into(), [3.6; 2].into()],
    };
    // A plane stirred by more than a quarter turn, beside a ramp, in oblique coordinates.
    let stirred = Product::<_, _, 2, 1>::new(Swirl::new(2.0, 1.0)?, Ramp::new(0.6, 1.0)?);
    let oblique = SMatrix::<f64, 3, 3>::new(1.0, 0.3, 0.0, -0.2, 1.0, 0.4, 0.3, 0.0, 1.0);
    let stirred = Task {
        metric: AffinePullback::new(stirred, oblique, [0.0; 3])?,
        ends: [[-1.5, 0.2, -1.0].into(), [1.2, 0.5, 1.0].into()],
        corners: [[-3.0; 3].into(), [3.0; 3].into()],
    };
    // Waves in six oblique coordinates.
    let waves =
        Separable::<6>::new([0.7, -0.6, 0.8, 0.5, -0.7, 0.6], [2.0, 1.5, 1.0, 2.5, 1.8, 2.2])?;
    let oblique = SMatrix::<f64, 6, 6>::from_fn(|i, j| {
        if i == j { 1.0 } else { 0.3 * (i as f64 + 2.0 * j as f64).sin() }
    });
    let end = SVector::from([1.0, -0.8, 1.2, 0.7, -1.0, 0.9]);
    let waves = Task {
        metric: AffinePullback::new(waves, oblique, [0.0; 6])?,
        ends: [-end, end],
        corners: [SVector::repeat(-2.0), SVector::repeat(2.0)],
    };
    Ok(vec![
        Problem::new("behind a sphere", sphere)?,
        Problem::new("stirred space", stirred)?,
        Problem::new("six waves", waves)?,
    ])
}
