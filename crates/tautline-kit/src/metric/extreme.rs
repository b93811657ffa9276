//! The extreme values of a metric in a region: what its claimed constants are compared with.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline::{Jet1, Jet2, Metric, norm_squared};
use tautline_statements::extreme_eigenvalues;

use crate::{Claim, Region};

/// Rounds of the alternation between directions. Each is a step of a power method that never
/// descends; it need not end, since an ascent goes through it again and again.
const ROUNDS: usize = 6;

/// The first step of an ascent is the `2⁻³`-th part of the longest edge, the last the `2⁻¹⁶`-th:
/// a smooth maximum is then missed by some `(k 2⁻¹⁶)²` for a metric that does something `k`
/// times along an edge, and a lie of one millionth is seen.
const HALVINGS: std::ops::RangeInclusive<i32> = 3..=16;

/// Steps of an ascent with one step length, on the way along a ridge.
const MOVES: usize = 64;

/// A value that a metric takes at a point in a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extreme<const D: usize> {
    /// The number that a constant bounds, in its unit.
    pub(super) value: f64,
    pub(super) point: SVector<f64, D>,
    pub(super) direction: SVector<f64, D>,
}

impl Claim {
    /// Returns whether `a` is nearer to breaking the claim than `b`, or breaks it more; a NaN is
    /// not.
    pub(super) fn worse(self, a: f64, b: f64) -> bool {
        if self == Claim::C1 { a < b } else { a > b }
    }

    /// Measures a metric at `x`, in the direction that is worst as far as alternation from `w`
    /// finds.
    ///
    /// Of `L_H`, `sup |uᵀ DH(x)[w] u|` over unit `u` and `w`: for given `w` the best `u` is an
    /// eigenvector, for given `u` the best `w` is the gradient of `uᵀHu`. Of `M_H` likewise, with
    /// an eigenvector of the Hessian of `uᵀHu`. Neither step descends.
    pub(super) fn measure<const D: usize>(
        self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        w: &SVector<f64, D>,
    ) -> Extreme<D> {
        let at = |value, direction| Extreme { value, point: *x, direction };
        match self {
            Claim::C1 => {
                let ((low, direction), _) = eigenpairs(&metric.gram(x));
                at(low, direction)
            }
            Claim::C2 => {
                let (_, (high, direction)) = eigenpairs(&metric.gram(x));
                at(high, direction)
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

    /// Climbs from a value to a local extreme of the region: steps along the coordinates, and along
    /// the last move, halved where none helps.
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

/// Alternates between `w`, with the matrix `A(w)`, and the eigenvector `u` of the eigenvalue of
/// `A(w)` that is largest in size. Returns the size and `w`.
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

/// `DH(x)[w]`, in `m²/ℓ³` for a unit vector `w`.
pub(super) fn first<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let [t] = Jet1::variables(&[0.0]);
    let line = SVector::from_fn(|i, _| t * w[i] + x[i]);
    metric.gram(&line).map(|entry: Jet1<f64, 1>| entry.first(0))
}

/// `D²H(x)[w, w]`, in `m²/ℓ⁴` for a unit vector `w`.
pub(super) fn second<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let [t] = Jet2::variables(&[0.0]);
    let line = SVector::from_fn(|i, _| t * w[i] + x[i]);
    metric.gram(&line).map(|entry: Jet2<f64, 1>| entry.second(0, 0))
}

type Eigenpair<const D: usize> = (f64, SVector<f64, D>);

/// The least and the largest eigenvalue of a symmetric matrix, with unit eigenvectors; NaN if an
/// entry is not finite.
fn eigenpairs<const D: usize>(matrix: &SMatrix<f64, D, D>) -> (Eigenpair<D>, Eigenpair<D>) {
    let axis = SVector::from_fn(|i, _| if i == 0 { 1.0 } else { 0.0 });
    if !matrix.iter().all(|entry| entry.is_finite()) {
        // The iteration for eigenvalues would not end.
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

/// The size of the eigenvalue that is largest in size, with its eigenvector.
fn largest<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Eigenpair<D> {
    let ((low, at_low), (high, at_high)) = eigenpairs(matrix);
    if low.abs() > high.abs() { (low.abs(), at_low) } else { (high.abs(), at_high) }
}

/// The operator norm of a symmetric matrix; NaN if an entry is not finite.
pub(super) fn norm<const D: usize>(matrix: &SMatrix<f64, D, D>) -> f64 {
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return f64::NAN;
    }
    let (low, high) = extreme_eigenvalues(matrix);
    low.abs().max(high.abs())
}
