//! `Spectral`: a function of a point that is the largest eigenvalue of symmetric matrices made from
//! the metric.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};
use num_traits::Zero;
use tautline_scalar::{Interval, Jet1, Scalar};

use super::{
    eigenvalue_bound::{Enclosed, eigen, largest_eigenvalue},
    gram::{At, Gram},
    lifted::Variable,
};
use crate::{
    branch_and_bound::{Bound, Bounded},
    patch::{Patch, Point},
};

/// The largest eigenvalue of certain symmetric matrices `S(x)`. Its maximum is a constant of a
/// metric, or the negative or the square of a constant, or an upper bound on one of these.
pub(super) trait Spectral<const D: usize>: Sync {
    /// A free parameter for each box: for any choice, the matrices bound the constant.
    type Choice;

    /// Returns the metric.
    fn gram(&self) -> Gram<'_, D>;

    /// Returns a good choice near `x`.
    fn choice(&self, x: &Point) -> Self::Choice;

    /// Returns the matrices, all of the same size.
    fn matrices<T: Variable>(&self, at: At<'_, T, D>, choice: &Self::Choice) -> Vec<DMatrix<T>>;

    /// Returns the exact quantity, up to rounding, in the unit of the eigenvalue.
    fn wanted(&self, at: At<'_, f64, D>) -> f64;

    /// Returns a proved lower bound on the exact quantity at a point of space, in the unit of the
    /// constant, or an upper bound if the constant is an infimum. It is tight up to rounding, and
    /// NaN if there is none.
    fn witness(&self, x: &SVector<f64, D>) -> f64;

    /// Returns whether `H(x)` is certainly not that of a metric, given the largest eigenvalue
    /// `value`.
    fn is_refuted(&self, x: &Point, value: f64) -> bool {
        value.is_nan() && self.gram().is_undefined(&self.in_space(x))
    }

    /// Returns the point of space with the largest quantity among those with about these coordinates
    /// of the search.
    fn in_space(&self, x: &Point) -> SVector<f64, D> {
        let points = self.gram().in_space(x);
        let [x] = points[..] else {
            let valued = points.into_iter().map(|x| (self.wanted(At::Space(&x)), x));
            let best = valued.max_by(|(a, _), (b, _)| a.total_cmp(b));
            return best.map_or_else(SVector::zeros, |(_, x)| x);
        };
        x
    }
}

/// The largest eigenvalue, as a function that can be bounded on boxes.
pub(super) struct LargestEigenvalue<'a, S, const D: usize>(pub(super) &'a S);

impl<S: Spectral<D>, const D: usize> Bounded for LargestEigenvalue<'_, S, D> {
    fn bound(&self, patch: &Patch) -> Bound {
        let (middle, sides, chart) = (patch.middle(), &patch.sides, patch.chart);
        let choice = self.0.choice(&middle);
        let centre: Vec<_> = middle.at.iter().map(|&x| Interval::point(x)).collect();
        let centres = self.0.matrices(At::Search(&centre, chart), &choice);
        // The derivatives by the variables, D at a time.
        let groups: Vec<_> = (0..sides.len().max(1))
            .step_by(D)
            .map(|first| {
                let seed = |(k, &side): (usize, &Interval)| {
                    let slope = |i: usize| if first + i == k { 1.0 } else { 0.0 };
                    Jet1::new(side, std::array::from_fn(|i| Interval::point(slope(i))))
                };
                let jets: Vec<Jet1<Interval, D>> = sides.iter().enumerate().map(seed).collect();
                self.0.matrices(At::Search(&jets, chart), &choice)
            })
            .collect();
        let offsets: Vec<_> = sides.iter().zip(&centre).map(|(&side, &x)| side - x).collect();
        let mut bound = Bound { upper: f64::NEG_INFINITY, cut: 0, middle: f64::NEG_INFINITY };
        let mut influence = vec![0.0; sides.len()];
        for (index, centre) in centres.into_iter().enumerate() {
            let slope = |k: usize| groups[k / D][index].map(|entry| entry.first(k % D));
            let slopes: Vec<_> = (0..sides.len()).map(slope).collect();
            for k in 0..sides.len() {
                let size: f64 = slopes[k].iter().map(|slope| slope.magnitude()).sum();
                influence[k] += size * patch.length(k);
            }
            let value = groups[0][index].map(|entry| entry.value());
            let (upper, middle) =
                largest_eigenvalue(&Enclosed { centre, value, slopes, offsets: offsets.clone() });
            bound.upper = largest(bound.upper, upper);
            bound.middle = largest(bound.middle, middle);
            if bound.upper.is_nan() {
                break;
            }
        }
        // If a derivative has no bound, or if all of them vanish, the longest side is cut.
        bound.cut =
            if !influence.iter().sum::<f64>().is_finite() || influence.iter().all(|i| *i == 0.0) {
                patch.longest()
            } else {
                (0..sides.len())
                    .fold(0, |most, k| if influence[k] > influence[most] { k } else { most })
            };
        bound
    }

    fn value(&self, x: &Point) -> f64 {
        let matrices = self.0.matrices(x.into(), &self.0.choice(x));
        let eigenvalues =
            matrices.iter().map(|s| eigen(s).map_or(f64::NAN, |e| e.eigenvalues.max()));
        eigenvalues.fold(f64::NEG_INFINITY, largest)
    }

    fn wanted(&self, x: &Point) -> f64 {
        self.0.wanted(x.into())
    }

    fn is_refuted(&self, x: &Point, value: f64) -> bool {
        self.0.is_refuted(x, value)
    }
}

/// Returns the larger number, or NaN if one of them is NaN.
fn largest(most: f64, x: f64) -> f64 {
    if x > most || x.is_nan() { x } else { most }
}

/// Unit vectors `u` and `v` at which a form in both is large, and its absolute value there, up to
/// rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Direction<const D: usize> {
    pub(super) norm: f64,
    pub(super) u: SVector<f64, D>,
    pub(super) v: SVector<f64, D>,
}

/// Returns `uᵀ A u`.
pub(super) fn form<T: Scalar, const D: usize>(
    entry: impl Fn(usize, usize) -> T,
    u: &SVector<f64, D>,
) -> T {
    let mut sum = T::zero();
    for i in 0..D {
        for j in 0..D {
            sum += entry(i, j) * u[i] * u[j];
        }
    }
    sum
}

/// Returns `|u|²`, enclosed.
pub(super) fn square<const D: usize>(u: &SVector<f64, D>) -> Interval {
    u.iter().fold(Interval::zero(), |sum, &u| sum + Interval::point(u).sqr())
}

/// Returns the largest absolute value of an eigenvalue of a symmetric matrix, and an eigenvector
/// for it, up to rounding; `None` if an entry is not finite.
pub(super) fn extreme<const D: usize>(
    entry: impl Fn(usize, usize) -> f64,
) -> Option<(f64, SVector<f64, D>)> {
    eigenvector(entry, |eigenvalues| eigenvalues.iamax()).map(|(value, u)| (value.abs(), u))
}

/// Returns the largest eigenvalue of a symmetric matrix and its eigenvector, up to rounding, or
/// `None` if an entry is not finite.
pub(super) fn greatest<const D: usize>(
    entry: impl Fn(usize, usize) -> f64,
) -> Option<(f64, SVector<f64, D>)> {
    eigenvector(entry, |eigenvalues| eigenvalues.imax())
}

fn eigenvector<const D: usize>(
    entry: impl Fn(usize, usize) -> f64,
    which: impl Fn(&DVector<f64>) -> usize,
) -> Option<(f64, SVector<f64, D>)> {
    let eigen = eigen(&DMatrix::from_fn(D, D, entry))?;
    let index = which(&eigen.eigenvalues);
    let vector = eigen.eigenvectors.column(index);
    Some((eigen.eigenvalues[index], SVector::from_fn(|i, _| vector[i])))
}

/// Returns an orthogonal matrix whose first column is the unit vector `u`, up to rounding. It is
/// made from the reflection that swaps `u` with ± the first axis, with the sign that avoids
/// cancellation.
pub(super) fn basis_with<const D: usize>(u: &SVector<f64, D>) -> SMatrix<f64, D, D> {
    let mut w = *u;
    let sign = if u[0] < 0.0 { -1.0 } else { 1.0 };
    w[0] += sign;
    let mut reflection = SMatrix::identity() - w * w.transpose() * (2.0 / w.norm_squared());
    // The reflection takes the first axis to −sign · u.
    for i in 0..D {
        reflection[(i, 0)] *= -sign;
    }
    reflection
}

/// Maximises a form in two unit vectors by steps that take `v` to a better pair and the next `v`.
/// The best of several starts, after a few steps, goes on until it settles.
pub(super) fn alternating<const D: usize>(
    step: impl Fn(&SVector<f64, D>) -> Option<(Direction<D>, SVector<f64, D>)>,
) -> Option<Direction<D>> {
    let mut best: Option<(Direction<D>, SVector<f64, D>)> = None;
    for start in starts() {
        let mut now = step(&start)?;
        for _ in 1..FIRST_TURNS {
            now = step(&now.1)?;
        }
        if best.is_none_or(|best| now.0.norm > best.0.norm) {
            best = Some(now);
        }
    }
    let (mut best, mut v) = best?;
    for _ in FIRST_TURNS..TURNS {
        let (found, next) = step(&v)?;
        if found.norm > best.norm {
            best = found;
        }
        if (next - v).norm_squared() < 1e-20 {
            break;
        }
        v = next;
    }
    Some(best)
}

/// Starting vectors for maximising forms: the axes, and the bisectors of any two axes.
fn starts<const D: usize>() -> impl Iterator<Item = SVector<f64, D>> {
    let axis = |i: usize| SVector::<f64, D>::from_fn(|k, _| if k == i { 1.0 } else { 0.0 });
    let bisectors = (0..D).flat_map(move |j| (0..j).flat_map(move |i| [(i, j, 1.0), (i, j, -1.0)]));
    (0..D).map(axis).chain(
        bisectors
            .map(move |(i, j, sign)| (axis(i) + axis(j) * sign) * std::f64::consts::FRAC_1_SQRT_2),
    )
}

/// The number of alternating steps from every start.
const FIRST_TURNS: usize = 3;

/// The maximal number of alternating steps from the best start.
const TURNS: usize = 40;
