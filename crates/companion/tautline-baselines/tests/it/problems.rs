//! Metrics whose distance, exponential map, logarithm and parallel transport are known exactly.

use nalgebra::{SMatrix, SVector, vector};
use tautline::gallery::{Hyperbolic, Shear, Swirl};
use tautline::{Jet1, KnownDistance, Metric, Scalar};

pub(crate) type Vector = SVector<f64, 2>;

/// The exact calculus of a metric, for comparison.
pub(crate) trait Exact: KnownDistance<2> {
    /// Returns `exp_x(v)`.
    fn exact_exponential(&self, x: &Vector, v: &Vector) -> Vector;

    /// Returns the initial velocity of the geodesic from `x` to `y`.
    fn exact_logarithm(&self, x: &Vector, y: &Vector) -> Vector;

    /// Returns `u` at `x`, transported along the geodesic to `y`.
    fn exact_transport(&self, x: &Vector, y: &Vector, u: &Vector) -> Vector;
}

/// Implements [`Exact`] for the pullback of the Euclidean metric by `Φ`: with `Φ` a geodesic is a
/// straight line, and a parallel field is constant.
macro_rules! exact_by_chart {
    ($metric:ty) => {
        impl Exact for $metric {
            fn exact_exponential(&self, x: &Vector, v: &Vector) -> Vector {
                self.unflatten(&(self.flatten(x) + slope(|x| self.flatten(x), x) * v))
            }

            fn exact_logarithm(&self, x: &Vector, y: &Vector) -> Vector {
                let inverse = slope(|x| self.flatten(x), x).try_inverse().expect("a chart");
                inverse * (self.flatten(y) - self.flatten(x))
            }

            fn exact_transport(&self, x: &Vector, y: &Vector, u: &Vector) -> Vector {
                let inverse = slope(|x| self.flatten(x), y).try_inverse().expect("a chart");
                inverse * (slope(|x| self.flatten(x), x) * u)
            }
        }
    };
}
exact_by_chart!(Shear);
exact_by_chart!(Swirl);

/// Returns `DΦ(x)`.
fn slope(
    chart: impl Fn(&SVector<Jet1<f64, 2>, 2>) -> SVector<Jet1<f64, 2>, 2>,
    x: &Vector,
) -> SMatrix<f64, 2, 2> {
    let jets = chart(&SVector::from(Jet1::variables(&[x[0], x[1]])));
    SMatrix::from_fn(|i, j| jets[i].first(j))
}

/// The Möbius map `z ↦ (z + x)/(1 + x̄z)` is an isometry of the disc that takes 0 to `x`. Along a
/// ray from 0 the point of coordinate speed `w` is `tanh |w|` after the time 1, and a vector
/// shrinks as `1 − r²`.
impl Exact for Hyperbolic {
    fn exact_exponential(&self, x: &Vector, v: &Vector) -> Vector {
        let w = v / (1.0 - x.norm_squared());
        let z = w * (w.norm().tanh() / w.norm());
        divide(&(z + x), &(vector![1.0, 0.0] + times(&conjugate(x), &z)))
    }

    fn exact_logarithm(&self, x: &Vector, y: &Vector) -> Vector {
        let u = divide(&(y - x), &(vector![1.0, 0.0] - times(&conjugate(x), y)));
        u * (u.norm().atanh() / u.norm() * (1.0 - x.norm_squared()))
    }

    fn exact_transport(&self, x: &Vector, y: &Vector, u: &Vector) -> Vector {
        let z = divide(&(y - x), &(vector![1.0, 0.0] - times(&conjugate(x), y)));
        let below = vector![1.0, 0.0] + times(&conjugate(x), &z);
        divide(u, &times(&below, &below)) * (1.0 - z.norm_squared())
    }
}

fn conjugate(a: &Vector) -> Vector {
    vector![a[0], -a[1]]
}

fn times(a: &Vector, b: &Vector) -> Vector {
    vector![a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn divide(a: &Vector, b: &Vector) -> Vector {
    times(a, &conjugate(b)) / b.norm_squared()
}

pub(crate) fn shear() -> Shear {
    Shear::new(0.5, 1.0).expect("a wave number")
}

pub(crate) fn swirl() -> Swirl {
    Swirl::new(1.0, 0.8).expect("a width")
}

/// Passes each metric to `check`, with two points that are a good way apart.
macro_rules! for_each_problem {
    ($check:ident) => {
        $check("shear", &$crate::problems::shear(), [0.2, -0.5], [1.5, 1.0]);
        $check("swirl", &$crate::problems::swirl(), [-1.0, 0.3], [0.9, 0.4]);
        $check("hyperbolic", &tautline::gallery::Hyperbolic, [-0.4, 0.1], [0.3, 0.5]);
    };
}
pub(crate) use for_each_problem;

/// `H = x` on the half-line `x > 0`. Along a geodesic `√x ẋ` is constant, so that `x^{3/2}` is
/// linear in `t`: the geodesic from 1 with velocity `v < 0` reaches the edge at the time `−2/(3v)`.
pub(crate) struct HalfLine;

impl Metric<1> for HalfLine {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element(x[0])
    }
}

/// `H = 1 + x⁴` on the half-line `x ≥ 0`, and NaN elsewhere. Up to the edge it is as smooth as on
/// the line.
pub(crate) struct Cut;

impl Metric<1> for Cut {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element(x[0].sqrt().powi(8) + 1.0)
    }
}

/// `H = e^{−2x}` on the line. Along a geodesic `e^{−x}ẋ` is constant, so that the geodesic from 0
/// with velocity `v > 0` runs to infinity until the time `1/v`.
pub(crate) struct Runaway;

impl Metric<1> for Runaway {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element((x[0] * -2.0).exp())
    }
}

/// The formulas satisfy the equations that define them, so that no test rests on a wrong one.
#[test]
fn the_exact_formulas_agree_with_each_other() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (Vector::from(x), Vector::from(y));
        let v = metric.exact_logarithm(&x, &y);
        // A dozen roundings of numbers below 10.
        assert!((metric.exact_exponential(&x, &v) - y).norm() < 1e-14, "{name}");
        let square = |x: &Vector, v: &Vector| -> f64 { tautline::norm_squared(metric, x, v) };
        let d = metric.distance(&x, &y).expect("known");
        assert!((square(&x, &v).sqrt() / d - 1.0).abs() < 1e-14, "{name}");
        // Transport keeps the length, and takes the velocity to that of the way back.
        let u = vector![0.3, 0.7];
        let moved = metric.exact_transport(&x, &y, &u);
        assert!((square(&y, &moved) / square(&x, &u) - 1.0).abs() < 1e-13, "{name}");
        let there = metric.exact_transport(&x, &y, &v);
        assert!((there + metric.exact_logarithm(&y, &x)).norm() < 1e-13, "{name}");
    }
    for_each_problem!(check);
}
