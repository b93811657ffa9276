//! `Spectral`: a function of a point that is the largest eigenvalue of symmetric matrices made from
//! the metric.

use nalgebra::{DMatrix, DVector};
use num_traits::Zero;
use tautline_scalar::{Interval, Jet1, Scalar};

use super::{
    eigenvalue_bound::{Enclosed, eigen, largest_eigenvalue},
    gram::{At, Gram, points},
    lifted::Variable,
};
use crate::{
    branch_and_bound::{Bound, Bounded},
    patch::{Patch, Point},
};

/// The largest eigenvalue of certain symmetric matrices `S(x)`. Its maximum is a constant of a
/// metric, or the negative or the square of a constant, or an upper bound on one of these.
pub(super) trait Spectral: Sync {
    /// A free parameter for each box: for any choice, the matrices bound the constant.
    type Choice;

    /// Returns the metric.
    fn gram(&self) -> Gram<'_>;

    /// Returns a good choice near `x`.
    fn choice(&self, x: &Point) -> Self::Choice;

    /// Returns the matrices, all of the same size.
    fn matrices<T: Variable>(&self, at: At<'_, T>, choice: &Self::Choice) -> Vec<DMatrix<T>>;

    /// Returns the exact quantity, up to rounding, in the unit of the eigenvalue.
    fn wanted(&self, at: At<'_, f64>) -> f64;

    /// Returns a proved lower bound on the exact quantity at a point of space, in the unit of the
    /// constant, or an upper bound if the constant is an infimum. It is tight up to rounding, and
    /// NaN if there is none.
    fn witness(&self, x: &[f64]) -> f64;

    /// Returns whether `H(x)` is certainly not that of a metric, given the largest eigenvalue
    /// `value`.
    fn is_refuted(&self, x: &Point, value: f64) -> bool {
        value.is_nan() && self.gram().is_undefined(&self.in_space(x))
    }

    /// Returns the point of space with the largest quantity among those with about these coordinates
    /// of the search.
    fn in_space(&self, x: &Point) -> Vec<f64> {
        let mut points = self.gram().in_space(x);
        if points.len() == 1 {
            return points.remove(0);
        }
        let valued = points.into_iter().map(|x| (self.wanted(At::Space(&x)), x));
        let best = valued.max_by(|(a, _), (b, _)| a.total_cmp(b));
        best.map_or_else(|| vec![0.0; self.gram().dimension()], |(_, x)| x)
    }
}

/// The largest eigenvalue, as a function that can be bounded on boxes.
pub(super) struct LargestEigenvalue<'a, S>(pub(super) &'a S);

/// The enclosure of a matrix on a box, and the enclosures of its derivatives by each variable.
type Sloped = (DMatrix<Interval>, Vec<DMatrix<Interval>>);

/// The largest number of variables whose derivatives are computed together.
const TOGETHER: usize = 3;

impl<S: Spectral> LargestEigenvalue<'_, S> {
    /// Encloses the matrices on a box, with their derivatives by the variables, `K` at a time.
    fn sloped<const K: usize>(&self, patch: &Patch, choice: &S::Choice) -> Vec<Sloped> {
        let (sides, mut found) = (&patch.sides, Vec::<Sloped>::new());
        for begin in (0..sides.len().max(1)).step_by(K) {
            let seed = |(k, &side): (usize, &Interval)| {
                let slope = |i: usize| if begin + i == k { 1.0 } else { 0.0 };
                Jet1::new(side, std::array::from_fn(|i| Interval::point(slope(i))))
            };
            let jets: Vec<Jet1<Interval, K>> = sides.iter().enumerate().map(seed).collect();
            for (index, jets) in
                self.0.matrices(At::Search(&jets, patch.chart), choice).iter().enumerate()
            {
                if begin == 0 {
                    found.push((jets.map(|entry| entry.value()), Vec::new()));
                }
                let known = K.min(sides.len() - begin);
                let slopes = (0..known).map(|i| jets.map(|entry| entry.first(i)));
                found[index].1.extend(slopes);
            }
        }
        found
    }
}

impl<S: Spectral> Bounded for LargestEigenvalue<'_, S> {
    fn bound(&self, patch: &Patch) -> Bound {
        let (middle, sides, chart) = (patch.middle(), &patch.sides, patch.chart);
        let choice = self.0.choice(&middle);
        let centre = points(&middle.at);
        let centres = self.0.matrices(At::Search(&centre, chart), &choice);
        // As few groups as possible, all of nearly the same size.
        let groups = sides.len().div_ceil(TOGETHER).max(1);
        let sloped = match sides.len().div_ceil(groups) {
            0 | 1 => self.sloped::<1>(patch, &choice),
            2 => self.sloped::<2>(patch, &choice),
            _ => self.sloped::<TOGETHER>(patch, &choice),
        };
        let offsets: Vec<_> = sides.iter().zip(&centre).map(|(&side, &x)| side - x).collect();
        let mut bound = Bound { upper: f64::NEG_INFINITY, cut: 0, middle: f64::NEG_INFINITY };
        let mut influence = vec![0.0; sides.len()];
        for (centre, (value, slopes)) in centres.into_iter().zip(sloped) {
            for k in 0..sides.len() {
                let size: f64 = slopes[k].iter().map(|slope| slope.magnitude()).sum();
                influence[k] += size * patch.length(k);
            }
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
#[derive(Clone, Debug)]
pub(super) struct Direction {
    pub(super) norm: f64,
    pub(super) u: DVector<f64>,
    pub(super) v: DVector<f64>,
}

/// Returns `uᵀ A u`.
pub(super) fn form<T: Scalar>(entry: impl Fn(usize, usize) -> T, u: &DVector<f64>) -> T {
    let mut sum = T::zero();
    for i in 0..u.len() {
        for j in 0..u.len() {
            sum += entry(i, j) * u[i] * u[j];
        }
    }
    sum
}

/// Returns `|u|²`, enclosed.
pub(super) fn square(u: &DVector<f64>) -> Interval {
    u.iter().fold(Interval::zero(), |sum, &u| sum + Interval::point(u).sqr())
}

/// Returns the largest absolute value of an eigenvalue of a symmetric `d × d` matrix, and an eigenvector
/// for it, up to rounding; `None` if an entry is not finite.
pub(super) fn extreme(
    d: usize,
    entry: impl Fn(usize, usize) -> f64,
) -> Option<(f64, DVector<f64>)> {
    eigenvector(d, entry, |eigenvalues| eigenvalues.iamax()).map(|(value, u)| (value.abs(), u))
}

/// Returns the largest eigenvalue of a symmetric `d × d` matrix and its eigenvector, up to rounding, or
/// `None` if an entry is not finite.
pub(super) fn greatest(
    d: usize,
    entry: impl Fn(usize, usize) -> f64,
) -> Option<(f64, DVector<f64>)> {
    eigenvector(d, entry, |eigenvalues| eigenvalues.imax())
}

fn eigenvector(
    d: usize,
    entry: impl Fn(usize, usize) -> f64,
    which: impl Fn(&DVector<f64>) -> usize,
) -> Option<(f64, DVector<f64>)> {
    let eigen = eigen(&DMatrix::from_fn(d, d, entry))?;
    let index = which(&eigen.eigenvalues);
    Some((eigen.eigenvalues[index], eigen.eigenvectors.column(index).into_owned()))
}

/// Returns an orthogonal matrix whose first column is the unit vector `u`, up to rounding. It is
/// made from the reflection that swaps `u` with ± the first axis, with the sign that avoids
/// cancellation.
pub(super) fn basis_with(u: &DVector<f64>) -> DMatrix<f64> {
    let (mut w, d) = (u.clone(), u.len());
    let sign = if u[0] < 0.0 { -1.0 } else { 1.0 };
    w[0] += sign;
    let factor = 2.0 / w.norm_squared();
    let identity = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
    let mut reflection = DMatrix::from_fn(d, d, |i, j| identity(i, j) - w[i] * w[j] * factor);
    // The reflection takes the first axis to −sign · u.
    for i in 0..d {
        reflection[(i, 0)] *= -sign;
    }
    reflection
}

/// Returns `Qᵀ A Q`, by sums in a fixed order.
pub(super) fn congruent(q: &DMatrix<f64>, entry: impl Fn(usize, usize) -> f64) -> DMatrix<f64> {
    let d = q.nrows();
    let sum = |term: &dyn Fn(usize) -> f64| (0..d).map(term).sum::<f64>();
    let left = DMatrix::from_fn(d, d, |i, j| sum(&|k| q[(k, i)] * entry(k, j)));
    DMatrix::from_fn(d, d, |i, j| sum(&|k| left[(i, k)] * q[(k, j)]))
}

/// Maximises a form in two unit vectors of `R^d` by steps that take `v` to a better pair and the next `v`.
/// The best of several starts, after a few steps, goes on until it settles.
pub(super) fn alternating(
    d: usize,
    step: impl Fn(&DVector<f64>) -> Option<(Direction, DVector<f64>)>,
) -> Option<Direction> {
    let mut best: Option<(Direction, DVector<f64>)> = None;
    for start in starts(d) {
        let mut now = step(&start)?;
        for _ in 1..FIRST_TURNS {
            now = step(&now.1)?;
        }
        if best.as_ref().is_none_or(|best| now.0.norm > best.0.norm) {
            best = Some(now);
        }
    }
    let (mut best, mut v) = best?;
    for _ in FIRST_TURNS..TURNS {
        let (found, next) = step(&v)?;
        if found.norm > best.norm {
            best = found;
        }
        let change = (&next - v).norm_squared();
        if change < 1e-20 {
            break;
        }
        v = next;
    }
    Some(best)
}

/// Starting vectors for maximising forms: the axes, and the bisectors of any two axes.
fn starts(d: usize) -> impl Iterator<Item = DVector<f64>> {
    let axis = move |i: usize| DVector::from_fn(d, |k, _| if k == i { 1.0 } else { 0.0 });
    let bisectors = (0..d).flat_map(move |j| (0..j).flat_map(move |i| [(i, j, 1.0), (i, j, -1.0)]));
    (0..d).map(axis).chain(
        bisectors
            .map(move |(i, j, sign)| (axis(i) + axis(j) * sign) * std::f64::consts::FRAC_1_SQRT_2),
    )
}

/// The number of alternating steps from every start.
const FIRST_TURNS: usize = 3;

/// The maximal number of alternating steps from the best start.
const TURNS: usize = 40;
