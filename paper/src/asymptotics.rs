//! Leading constants of the errors, predicted and measured.
//!
//! The prediction is computed from a geodesic. The measurement subtracts `d²` from minimal
//! energies. The two share no formula.

use std::{
    f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI},
    sync::Arc,
};

use tautline::{
    Ball, Ends, HalfSpace, KnownDistance, Metric, Problem, Rule, SMatrix, SVector, TautLine,
    composition::Product,
    gallery::{
        Constant, Corrugated, CoupledCosines, GaussianFisherPatch, HyperbolicPatch, Lens, Ramp,
        RotatingAnisotropy, Separable, Shear, SineProjections, SpherePatch, Swirl, TwoLinkArm,
        Valleys,
    },
    leading_constants,
};

use crate::{Failure, case::Reference};

/// The number of chords of the finest measurement. The next order is about `(10/N)²` times the
/// first, and the rounding error is `N² ε d²`. Both are below `10⁻⁴`.
pub const N: usize = 2048;

/// The numbers of chords of the geodesics from which the prediction is computed. Their error is of
/// second order, so two grids give the prediction to fourth order. If `d²` is not known, it is
/// extrapolated from the coarser grids of the last solve.
const READ: [usize; 2] = [2048, 4096];

/// A prediction below this fraction of the largest of the six counts as 0, which it is by symmetry
/// or in one dimension. If a sum cancels, two grids leave at most `(4π/4096)⁴` times its terms. The
/// measured value is then compared with `d²`. No other prediction here is below `10⁻³` times the
/// largest.
const ZERO: f64 = 1e-8;

/// A smooth problem whose minimiser is unique, as far as is known.
pub struct Smooth {
    /// Its name in the data files.
    pub name: &'static str,
    limits: Computed<(), Limits>,
    energies: Computed<usize, [f64; 3]>,
}

/// A computation on a problem that hides its metric and its dimension.
type Computed<A, B> = Box<dyn Fn(A) -> Result<B, Failure> + Send + Sync>;

/// The six constants, in `m²`, predicted and measured.
pub struct Limits {
    predicted: [f64; 6],
    /// The measured constants: of `E_tra,N`, of `E_l,N`, and of `E(γᵖˡ)` and `L(γᵖˡ)²` for one rule
    /// after the other.
    pub measured: [f64; 6],
    /// The square of the distance.
    pub d_squared: f64,
    /// The source of `d²`.
    pub reference: Reference,
}

impl Limits {
    /// Returns the predictions. Those that are 0 up to rounding are replaced by 0.
    pub fn predictions(&self) -> [f64; 6] {
        let largest = self.predicted.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        self.predicted.map(|value| if value.abs() <= ZERO * largest { 0.0 } else { value })
    }
}

impl Smooth {
    fn new<M, const D: usize>(
        name: &'static str,
        metric: M,
        ends: Ends<D>,
        distance: Option<f64>,
    ) -> Self
    where
        M: Metric<D> + Send + 'static,
    {
        let problem = Arc::new(Problem::new(metric, ends));
        let shared = Arc::clone(&problem);
        Self {
            name,
            limits: Box::new(move |()| limits(name, &problem, distance)),
            energies: Box::new(move |n| {
                let line = shared.solve(Rule::TRAPEZOIDAL, n)?;
                let left = shared.solve(Rule::LEFT_ENDPOINT, n)?.discrete_energy();
                Ok([line.discrete_energy(), left, line.energy().value])
            }),
        }
    }

    /// Returns the constants.
    pub fn limits(&self) -> Result<Limits, Failure> {
        (self.limits)(())
    }

    /// Returns `E_tra,N`, `E_l,N` and `E(γᵖˡ)` of the trapezoidal rule for `N = n`, in `m²`.
    pub fn energies(&self, n: usize) -> Result<[f64; 3], Failure> {
        (self.energies)(n)
    }

    /// Returns the problem between two points whose distance the metric knows.
    fn known<M, const D: usize>(
        name: &'static str,
        metric: M,
        [a, b]: [[f64; D]; 2],
    ) -> Result<Self, Failure>
    where
        M: KnownDistance<D> + Send + 'static,
    {
        let distance = metric.distance(&SVector::from(a), &SVector::from(b));
        let distance = Some(distance.ok_or(Failure::NoReference(name))?);
        Ok(Self::new(name, metric, Ends::points(a, b)?, distance))
    }
}

fn limits<M: Metric<D>, const D: usize>(
    name: &'static str,
    problem: &Problem<M, D>,
    distance: Option<f64>,
) -> Result<Limits, Failure> {
    let [coarse, fine] = READ.map(|n| problem.solve(Rule::TRAPEZOIDAL, n));
    let (coarse, fine) = (coarse?, fine?);
    let read = |line: &TautLine<M, D>| {
        let predicted = leading_constants(problem.metric(), problem.ends(), line.minimum())?;
        Ok::<[f64; 6], Failure>([
            predicted.trapezoidal,
            predicted.left,
            predicted.energy_trapezoidal,
            predicted.length_trapezoidal,
            predicted.energy_left,
            predicted.length_left,
        ])
    };
    let (coarse, finer) = (read(&coarse)?, read(&fine)?);
    let predicted = std::array::from_fn(|i| (4.0 * finer[i] - coarse[i]) / 3.0);
    let (d_squared, reference) = match (distance, fine.distance_squared_estimate()) {
        (Some(d), _) => (d * d, Reference::Exact),
        (None, Some(estimate)) => (estimate.value, Reference::Extrapolated),
        (None, None) => return Err(Failure::NoReference(name)),
    };
    let trapezoidal = scaled_errors(problem, Rule::TRAPEZOIDAL, N, d_squared)?;
    let coarse = scaled_errors(problem, Rule::LEFT_ENDPOINT, N / 2, d_squared)?;
    let left = scaled_errors(problem, Rule::LEFT_ENDPOINT, N, d_squared)?;
    // The next term of the left rule has one more power of 1/N, which the two grids eliminate.
    let left: [f64; 3] = std::array::from_fn(|i| 2.0 * left[i] - coarse[i]);
    Ok(Limits {
        predicted,
        measured: [trapezoidal[0], left[0], trapezoidal[1], trapezoidal[2], left[1], left[2]],
        d_squared,
        reference,
    })
}

/// Returns `N^q (E_N − d²)` with the order `q` of the rule, `N² (E(γᵖˡ) − d²)` and
/// `N² (L(γᵖˡ)² − d²)`, in `m²`.
fn scaled_errors<M: Metric<D>, const D: usize>(
    problem: &Problem<M, D>,
    rule: Rule,
    n: usize,
    d_squared: f64,
) -> Result<[f64; 3], Failure> {
    let line = problem.solve(rule, n)?;
    let count = n as f64;
    Ok([
        count.powi(rule.error_exponent()) * (line.discrete_energy() - d_squared),
        count.powi(2) * (line.energy().value - d_squared),
        count.powi(2) * (line.length().value.powi(2) - d_squared),
    ])
}

/// Returns the problems of the table.
pub fn smooth_problems() -> Result<Vec<Smooth>, Failure> {
    let line = Constant::new(SMatrix::from_diagonal_element(2.0))?;
    let corrugated = Product::<_, _, 1, 1>::new(Corrugated::new(FRAC_1_SQRT_2, 1.0)?, line);
    Ok(vec![
        Smooth::known("valleys_points", Valleys, [[0.0, 0.0], [4.0 * PI, 0.0]])?,
        Smooth::known("valleys_oblique", Valleys, [[0.0, 0.0], [2.0, 1.5]])?,
        Smooth::known("shear_points", Shear::new(0.5, 1.0)?, [[0.0, 0.0], [2.0, 3.0]])?,
        Smooth::known("corrugated", corrugated, [[0.2 - FRAC_PI_2, 0.0], [2.5 - FRAC_PI_2, 1.0]])?,
        Smooth::known(
            "separable_points",
            Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5])?,
            [[0.0, 0.0, 0.0], [2.0, 1.0, -1.5]],
        )?,
        Smooth::known("ramp", Ramp::new(0.5, 1.0)?, [[-1.0], [2.0]])?,
        Smooth::known("swirl", Swirl::new(1.0, 1.0)?, [[-1.5, 0.2], [1.0, 0.8]])?,
        Smooth::known("sphere_patch", SpherePatch::new(2.0)?, [[0.5, 0.0], [0.2, 1.0]])?,
        Smooth::known("hyperbolic_patch", HyperbolicPatch::new(0.8)?, [[0.6, 0.1], [-0.2, 0.5]])?,
        Smooth::known("gaussian_fisher", GaussianFisherPatch::new(2.0)?, [[0.0, 0.0], [1.5, 0.5]])?,
        Smooth::new(
            "lens",
            Lens::new(1.0, 1.0)?,
            Ends::points([-1.5, 0.4, 0.0], [1.0, 0.5, 0.8])?,
            None,
        ),
        Smooth::new(
            "rotating_anisotropy",
            RotatingAnisotropy::new([1.0, 2.0], [0.7, 0.3])?,
            Ends::points([0.0, 0.0], [1.5, 1.0])?,
            None,
        ),
        Smooth::new(
            "two_link_arm",
            TwoLinkArm::new(3.0, 1.0, 1.0)?,
            Ends::points([0.0, 0.5], [1.0, 2.0])?,
            None,
        ),
        Smooth::new(
            "coupled_cosines",
            CoupledCosines,
            Ends::points([0.0, 0.0, 0.0], [1.0, -0.5, 1.5])?,
            None,
        ),
        Smooth::new(
            "sine_projections",
            SineProjections::benchmark(),
            Ends::points([0.0; 8], [1.0, 0.5, -0.5, 0.8, -1.0, 0.3, 0.6, -0.2])?,
            None,
        ),
        Smooth::new(
            "rotating_anisotropy_ball",
            RotatingAnisotropy::new([1.0, 2.0], [0.7, 0.3])?,
            Ends::new(Ball::new([0.0, 0.0], 0.5)?, HalfSpace::at_least([1.0, 1.0], 2.0)?)?,
            None,
        ),
        Smooth::new(
            "lens_balls",
            Lens::new(1.0, 1.0)?,
            Ends::new(Ball::new([-1.5, 0.4], 0.5)?, Ball::new([1.5, 0.9], 0.25)?)?,
            None,
        ),
    ])
}
