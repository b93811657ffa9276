//! Minimisers on a surface are those in coordinates on it.

use tautline::{
    Ends, Metric, Options, PointSequence, Rule, SMatrix, SVector, Scalar, Starts,
    gallery::CoupledCosines, minimise,
};
use tautline_baselines::descent::{Ended, Equality};

use crate::constrained::{UnitSphere, energy_tolerance, solve};

/// The plane `x₃ = 0.3 x₁ − 0.2 x₂`, with the normal `(0.3, −0.2, −1)` times ten.
struct Plane;

impl Equality<3> for Plane {
    fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
        x[0] * 3.0 - x[1] * 2.0 - x[2] * 10.0
    }
}

/// The coupled cosines on a plane: a metric of two variables.
struct OnThePlane;

impl Metric<2> for OnThePlane {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let in_space = SVector::from([x[0], x[1], x[0] * 0.3 - x[1] * 0.2]);
        let h = CoupledCosines.gram(&in_space);
        let tangents = [[1.0, 0.0, 0.3], [0.0, 1.0, -0.2]];
        SMatrix::from_fn(|i, j| {
            let mut sum = S::constant(0.0);
            for k in 0..3 {
                for l in 0..3 {
                    sum += h[(k, l)] * (tangents[i][k] * tangents[j][l]);
                }
            }
            sum
        })
    }
}

/// In coordinates on the plane the problem has no constraint, and the structured solver finds the
/// same energy.
#[test]
fn on_a_plane_it_is_the_minimum_in_coordinates() {
    fn compare(rule: Rule) {
        let (a, b, n) = ([-1.0, 0.3], [2.0, 1.5], 32);
        let start = PointSequence::straight(a, b, n).expect("finite");
        let ends = Ends::points(a, b).expect("finite");
        let only = Options { starts: Starts::Only(vec![start]), ..Options::default() };
        let expected = minimise(&OnThePlane, &ends, rule, n, &only).expect("a metric").energy;
        let lift = |x: [f64; 2]| [x[0], x[1], 0.3 * x[0] - 0.2 * x[1]];
        let start = PointSequence::straight(lift(a), lift(b), n).expect("finite");
        // The energy in space has a lower minimum between the same points.
        let ends = Ends::points(lift(a), lift(b)).expect("finite");
        let only = Options { starts: Starts::Only(vec![start.clone()]), ..Options::default() };
        let free = minimise(&CoupledCosines, &ends, rule, n, &only).expect("a metric").energy;
        let found = solve(CoupledCosines, rule, start, &Plane).expect("a metric");
        let what = format!(
            "{rule}: residual {:e} of {:e}, violation {:e}",
            found.descended.residual, found.descended.residual_floor, found.violation
        );
        assert_eq!(found.descended.ended, Ended::Stationary, "{what}");
        let (error, tolerance) =
            (found.descended.energy / expected - 1.0, energy_tolerance(&found));
        assert!(error.abs() <= tolerance, "{rule}: {error:e} {tolerance:e}");
        assert!(free < expected * (1.0 - 1e-6), "{rule}: {free} {expected}");
        // The multipliers are the forces that hold the curve in its plane.
        assert!(found.multipliers.iter().any(|multiplier| multiplier.abs() > 1e-4));
    }
    compare(Rule::TRAPEZOIDAL);
    compare(Rule::LEFT_ENDPOINT);
}

/// The unit sphere under the coupled cosines, in stereographic coordinates
/// `x = (2y₁, 2y₂, |y|² − 1)/(1 + |y|²)`.
struct OnTheSphere;

impl OnTheSphere {
    fn lift<S: Scalar>(y: &SVector<S, 2>) -> SVector<S, 3> {
        let s = S::constant(1.0) / (y[0].sqr() + y[1].sqr() + 1.0);
        SVector::from([y[0] * s * 2.0, y[1] * s * 2.0, -s * 2.0 + 1.0])
    }
}

impl Metric<2> for OnTheSphere {
    fn gram<S: Scalar>(&self, y: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let h = CoupledCosines.gram(&Self::lift(y));
        let s = S::constant(1.0) / (y[0].sqr() + y[1].sqr() + 1.0);
        let tangents: [SVector<S, 3>; 2] = std::array::from_fn(|j| {
            SVector::from_fn(|i, _| {
                let turn = s.sqr() * y[j] * 4.0;
                let of_point = if i < 2 { -turn * y[i] } else { turn };
                if i == j { of_point + s * 2.0 } else { of_point }
            })
        });
        SMatrix::from_fn(|i, j| {
            let mut sum = S::constant(0.0);
            for k in 0..3 {
                for l in 0..3 {
                    sum += h[(k, l)] * tangents[i][k] * tangents[j][l];
                }
            }
            sum
        })
    }
}

/// Under a metric that varies, the chords in space and those in a chart have different energies, and
/// one limit. The errors of the trapezoidal rule are a series in `1/N²`, of which Richardson's
/// extrapolation takes off three terms: what is left is of the order `512⁻²·256⁻²·128⁻²·64⁻²`. It
/// doubles the errors of the energies, as `(5/3)(17/15)(65/63) < 2`.
#[test]
fn on_a_sphere_in_another_metric_the_limit_is_that_in_a_chart() {
    let (a, b) = ([0.9, 0.2], [-0.5, 0.8]);
    let along = |k: usize, n: usize| SVector::from(a).lerp(&b.into(), k as f64 / n as f64);
    let grids = [64, 128, 256, 512];
    let mut tolerance: f64 = 0.0;
    let energies = grids.map(|n| {
        let chart = PointSequence::new((0..=n).map(|k| along(k, n)).collect()).expect("finite");
        let lifted = chart.points().iter().map(OnTheSphere::lift).collect();
        let ends = Ends::points(a, b).expect("finite");
        let only = Options { starts: Starts::Only(vec![chart]), ..Options::default() };
        let found = minimise(&OnTheSphere, &ends, Rule::TRAPEZOIDAL, n, &only).expect("a metric");
        let lifted = PointSequence::new(lifted).expect("finite");
        let on_sphere =
            solve(CoupledCosines, Rule::TRAPEZOIDAL, lifted, &UnitSphere).expect("a metric");
        assert_eq!(on_sphere.descended.ended, Ended::Stationary);
        tolerance = tolerance.max(2.0 * (energy_tolerance(&on_sphere) + found.decrement));
        [found.energy, on_sphere.descended.energy]
    });
    // The energies on the finest grid differ by far more than the limits.
    let [chart, in_space] = energies[3];
    assert!((in_space / chart - 1.0).abs() > 1e-9, "{in_space} {chart}");
    let limit = |which: usize| {
        let mut table = energies.map(|energies| energies[which]).to_vec();
        let mut factor = 4.0;
        while table.len() > 1 {
            let pairs = table.windows(2);
            table = pairs.map(|e| e[1] + (e[1] - e[0]) / (factor - 1.0)).collect();
            factor *= 4.0;
        }
        table[0]
    };
    let error = limit(1) / limit(0) - 1.0;
    assert!(error.abs() <= tolerance, "{error:e} {tolerance:e}");
}
