//! The extreme values of a metric in a region. Its claimed constants are checked against them.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline::{Jet1, Jet2, Metric, Scalar, norm_squared};
use tautline_statements::extreme_eigenvalues;

use crate::{Claim, Region};

/// The number of rounds of the alternation between directions. Each round is a step of a power
/// method that never decreases the value. The alternation need not converge, since an ascent
/// repeats it at every step.
const ROUNDS: usize = 6;

/// The steps of an ascent are `2⁻³` to `2⁻¹⁶` of the longest edge. If a metric varies `k` times
/// along an edge, the ascent misses a smooth maximum by about `(k 2⁻¹⁶)²`, so it detects a constant
/// that is wrong by a millionth.
const HALVINGS: std::ops::RangeInclusive<i32> = 3..=16;

/// The number of steps of one length that an ascent takes along a ridge.
const MOVES: usize = 64;

/// A value that a metric takes at a point in a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extreme<const D: usize> {
    /// The value that a constant bounds, in the unit of the constant.
    pub(super) value: f64,
    pub(super) point: SVector<f64, D>,
    pub(super) direction: SVector<f64, D>,
}

impl Claim {
    /// Returns whether `a` comes closer to violating the claim than `b`, or violates it more.
    /// Returns `false` for NaN.
    pub(super) fn worse(self, a: f64, b: f64) -> bool {
        if self == Claim::C1 { a < b } else { a > b }
    }

    /// Returns the worst of several extremes, and the first one among equal extremes.
    pub(super) fn worst<const D: usize>(
        self,
        extremes: impl Iterator<Item = Extreme<D>>,
    ) -> Option<Extreme<D>> {
        extremes.reduce(|a, b| if self.worse(b.value, a.value) { b } else { a })
    }

    /// Measures a metric at `x`, in the worst direction that the alternation finds, starting from
    /// `w`.
    ///
    /// For `L_H` it maximises `|uᵀ DH(x)[w] u|` over unit vectors `u` and `w`: for given `w` the
    /// best `u` is an eigenvector, and for given `u` the best `w` is the gradient of `uᵀHu`. For
    /// `M_H` it does the same with an eigenvector of the Hessian of `uᵀHu`. Neither step decreases
    /// the value.
    pub(super) fn measure<const D: usize>(
        self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        w: &SVector<f64, D>,
    ) -> Extreme<D> {
        match self {
            Claim::C1 | Claim::C2 => {
                let (low, high) = eigenpairs(&metric.gram(x));
                let (value, direction) = if self == Claim::C1 { low } else { high };
                Extreme { value, point: *x, direction }
            }
            Claim::LH => alternate(
                x,
                w,
                |w| first(metric, x, w),
                |u| {
                    let jet = norm_squared(metric, &Jet1::variables(&(*x).into()).into(), u);
                    let gradient = SVector::<f64, D>::from(*jet.gradient());
                    gradient.try_normalize(0.0)
                },
            ),
            Claim::MH => alternate(
                x,
                w,
                |w| second(metric, x, w),
                |u| {
                    let jet = norm_squared(metric, &Jet2::variables(&(*x).into()).into(), u);
                    let hessian = SMatrix::from_fn(|k, l| jet.second(k, l));
                    Some(largest(&hessian).1)
                },
            ),
        }
    }

    /// Climbs to a local extreme in the region by steps along the coordinates and along the last
    /// move. The step is halved when none of these improves the value.
    pub(super) fn climb<const D: usize>(
        self,
        metric: &impl Metric<D>,
        region: &Region<D>,
        from: Extreme<D>,
    ) -> Extreme<D> {
        let mut best = from;
        for halving in HALVINGS {
            let step = region.size() * 0.5_f64.powi(halving);
            for _ in 0..MOVES {
                let before = best;
                for i in 0..D {
                    for sign in [1.0, -1.0] {
                        let mut x = best.point;
                        x[i] += sign * step;
                        self.improve(metric, region, &x, &mut best);
                    }
                }
                if best.point == before.point {
                    break;
                }
                let along = best.point * 2.0 - before.point;
                self.improve(metric, region, &along, &mut best);
            }
        }
        best
    }

    fn improve<const D: usize>(
        self,
        metric: &impl Metric<D>,
        region: &Region<D>,
        x: &SVector<f64, D>,
        best: &mut Extreme<D>,
    ) {
        let found = self.measure(metric, &region.clamp(x), &best.direction);
        if self.worse(found.value, best.value) {
            *best = found;
        }
    }
}

/// Alternates between `w`, with the matrix `A(w)`, and the eigenvector `u` for the eigenvalue of
/// `A(w)` that is largest in absolute value. Returns this absolute value and `w`.
fn alternate<const D: usize>(
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
    matrix: impl Fn(&SVector<f64, D>) -> SMatrix<f64, D, D>,
    best_for: impl Fn(&SVector<f64, D>) -> Option<SVector<f64, D>>,
) -> Extreme<D> {
    let (mut value, mut u) = largest(&matrix(w));
    let mut direction = *w;
    for _ in 0..ROUNDS {
        let Some(next) = best_for(&u) else { break };
        let (found, vector) = largest(&matrix(&next));
        if !(found > value) {
            break;
        }
        (value, u, direction) = (found, vector, next);
    }
    Extreme { value, point: *x, direction }
}

/// Returns `H(x + t w)`.
fn along<S: Scalar, const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
    t: S,
) -> SMatrix<S, D, D> {
    metric.gram(&SVector::from_fn(|i, _| t * w[i] + x[i]))
}

/// Returns `DH(x)[w]`, in `m²/ℓ³` for a unit vector `w`.
pub(super) fn first<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let [t] = Jet1::<f64, 1>::variables(&[0.0]);
    along(metric, x, w, t).map(|entry| entry.first(0))
}

/// Returns `D²H(x)[w, w]`, in `m²/ℓ⁴` for a unit vector `w`.
pub(super) fn second<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let [t] = Jet2::<f64, 1>::variables(&[0.0]);
    along(metric, x, w, t).map(|entry| entry.second(0, 0))
}

type Eigenpair<const D: usize> = (f64, SVector<f64, D>);

/// Returns the smallest and the largest eigenvalue of a symmetric matrix, with unit eigenvectors.
/// They are NaN if an entry is not finite.
fn eigenpairs<const D: usize>(matrix: &SMatrix<f64, D, D>) -> (Eigenpair<D>, Eigenpair<D>) {
    let axis = SVector::from_fn(|i, _| if i == 0 { 1.0 } else { 0.0 });
    if !matrix.iter().all(|entry| entry.is_finite()) {
        // On such a matrix nalgebra would iterate forever.
        return ((f64::NAN, axis), (f64::NAN, axis));
    }
    if D == 1 {
        return ((matrix[(0, 0)], axis), (matrix[(0, 0)], axis));
    }
    let eigen = DMatrix::from_fn(D, D, |i, j| matrix[(i.min(j), i.max(j))]).symmetric_eigen();
    let vector = |k: usize| SVector::from_fn(|i, _| eigen.eigenvectors[(i, k)]);
    let (low, high) = (eigen.eigenvalues.imin(), eigen.eigenvalues.imax());
    ((eigen.eigenvalues[low], vector(low)), (eigen.eigenvalues[high], vector(high)))
}

/// Returns the absolute value of the eigenvalue that is largest in absolute value, and its
/// eigenvector.
fn largest<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Eigenpair<D> {
    let ((low, at_low), (high, at_high)) = eigenpairs(matrix);
    if low.abs() > high.abs() { (low.abs(), at_low) } else { (high.abs(), at_high) }
}

/// Returns the operator norm of a symmetric matrix, or NaN if an entry is not finite.
pub(super) fn norm<const D: usize>(matrix: &SMatrix<f64, D, D>) -> f64 {
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return f64::NAN;
    }
    let (low, high) = extreme_eigenvalues(matrix);
    low.abs().max(high.abs())
}
