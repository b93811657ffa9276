//! `FineSpline`: a spline with three coefficients for each sample.

use std::{any::Any, array, sync::Arc};

use tautline_scalar::{Interval, Table};

use super::{Spline, SplineError, check};

/// The number of coefficients from one sample to the next.
const PER_SAMPLE: usize = 3;

/// The most coefficients, which take 2 GB.
const MOST: usize = 1 << 28;

/// A spline `u ↦ s(3u)` whose coordinates are in units of samples: sample `i` lies at `u = i`, and three
/// coefficients of `s` lie between a sample and the next.
///
/// A formula that calls it as a [`Table`] records a call of `s` with three times the arguments.
///
/// # Monotone interpolation
///
/// [`monotone`](Self::monotone) passes through the samples and does not leave them between: along one
/// axis, with samples `f_i`, the function is monotone from each sample to the next, so that a road that
/// is one sample wide keeps its cost, and a jump does not ring. The coefficients at `i − 1/3`, `i` and
/// `i + 1/3` are
///
/// ```text
/// f_i − s/3 + k/27,    f_i − k/54,    f_i + s/3 + k/27
/// ```
///
/// with a slope `s` and a curvature `k`. The value at the sample is `(c₋ + 4c + c₊)/6 = f_i`, its
/// derivatives are `s` and `k`. With the differences `a = f_i − f_{i−1}` and `b = f_{i+1} − f_i`, both are 0
/// where `ab ≤ 0`, in particular at the border, beyond which the nearest sample is repeated. Elsewhere
/// `s = (a + b)/2` and `k = b − a`, as far as `|s| ≤ 5m/4` and `|k| ≤ 9m/4` for `m = min(|a|, |b|)`. So the
/// coefficients increase where the samples do: between two of them the last step is at least
/// `|b| − (2/3)(5/4)|b| − (2/27)(9/4)|b| = 0`. Quadratic samples are reproduced where the
/// bounds do not act, and linear ones away from the border.
///
/// With several axes the construction goes along one axis after the other. The result depends on the
/// order of the axes, so it is the mean over all orders. Each coefficient lies between the samples at the
/// corners of its cell, and a value between those of the `4^E` samples around.
///
/// # Memory
///
/// About `3^E` times the memory of the samples on `E` axes, of at most `2²⁸` coefficients: those of an image
/// of 5,462 × 5,462 pixels, or of 215 × 215 × 215 samples in space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FineSpline {
    spline: Arc<Spline>,
}

impl FineSpline {
    /// Returns the monotone spline through the samples, which have the shape as in [`Spline::new`].
    ///
    /// All values, and all coefficients, lie between the least and the largest sample.
    ///
    /// ```
    /// use tautline_formula::spline::FineSpline;
    /// use tautline_scalar::Table;
    ///
    /// let road = FineSpline::monotone(&[5], vec![10.0, 10.0, 1.0, 10.0, 10.0])?;
    /// assert_eq!([0.0, 1.0, 2.0, 3.5].map(|u| road.value(&[u], [0; 3])), [10.0, 10.0, 1.0, 10.0]);
    /// # Ok::<(), tautline_formula::spline::SplineError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SplineError`] as in [`Spline::new`], and [`SplineError::TooFine`].
    pub fn monotone(shape: &[usize], samples: Vec<f64>) -> Result<Self, SplineError> {
        let mut splines = interpolated(shape, 1, samples, None)?;
        Ok(splines.remove(0))
    }

    /// Returns splines through the entries of symmetric matrices, monotone in each entry.
    ///
    /// `samples` has, for each place of the shape, the entries on and above the diagonal, row by row, of
    /// a matrix with `size` rows; the result has a spline for each of these entries, in this order. If
    /// all matrices are positive definite, so is the matrix of the splines everywhere: slope and curvature
    /// are 0 at a sample `A` where a coefficient `C` would not have `C − A/2` positive definite, and values
    /// are convex combinations of coefficients.
    ///
    /// # Errors
    ///
    /// [`SplineError`] as in [`Spline::new`], for as many numbers as entries at all places, and
    /// [`SplineError::TooFine`].
    pub fn monotone_matrices(
        shape: &[usize],
        size: usize,
        samples: Vec<f64>,
    ) -> Result<Vec<Self>, SplineError> {
        if size == 0 {
            return Ok(Vec::new());
        }
        let keeps = |coefficient: &[f64], sample: &[f64]| {
            let reduced = coefficient.iter().zip(sample).map(|(c, a)| c - 0.5 * a).collect();
            is_positive_definite(reduced, size)
        };
        interpolated(shape, size * (size + 1) / 2, samples, Some(&keeps))
    }

    /// Returns `u ↦ s(3u)` for a spline `s`.
    #[must_use]
    pub fn of(spline: Arc<Spline>) -> Self {
        Self { spline }
    }

    /// Returns the spline `s` of `u ↦ s(3u)`.
    #[must_use]
    pub fn spline(&self) -> &Arc<Spline> {
        &self.spline
    }

    /// Returns the number of samples along each axis.
    #[must_use]
    pub fn shape(&self) -> Vec<usize> {
        self.spline.shape().iter().map(|&length| (length - 1) / PER_SAMPLE + 1).collect()
    }
}

impl Table for FineSpline {
    fn axes(&self) -> usize {
        self.spline.axes()
    }

    fn value(&self, u: &[f64], orders: [u8; 3]) -> f64 {
        let factor = PER_SAMPLE as f64;
        let scaled: Vec<f64> = u.iter().map(|u| factor * u).collect();
        factor.powi(orders.iter().map(|&order| i32::from(order)).sum())
            * self.spline.value(&scaled, orders)
    }

    fn bounds(&self, sides: &[(f64, f64)], orders: [u8; 3]) -> Option<(f64, f64)> {
        let factor: Interval = Interval::point(PER_SAMPLE as f64);
        let scaled: Option<Vec<(f64, f64)>> = sides
            .iter()
            .map(|&(lo, hi)| {
                let side = Interval::new(lo, hi).ok()? * factor;
                Some((side.lo(), side.hi()))
            })
            .collect();
        let (lo, hi) = Table::bounds(&*self.spline, &scaled?, orders)?;
        let steps = orders.iter().map(|&order| u32::from(order)).sum::<u32>();
        let bounds = (0..steps).fold(Interval::new(lo, hi).ok()?, |bounds, _| bounds * factor);
        Some((bounds.lo(), bounds.hi()))
    }

    fn base(&self) -> Option<(Arc<dyn Table>, f64)> {
        Some((Arc::clone(&self.spline) as Arc<dyn Table>, PER_SAMPLE as f64))
    }

    fn fingerprint(&self) -> u64 {
        !self.spline.fingerprint()
    }

    fn is_same(&self, other: &dyn Table) -> bool {
        (other as &dyn Any).downcast_ref::<Self>().is_some_and(|other| self == other)
    }
}

/// Whether a coefficient, as its entries, may stand beside a sample.
type Keeps<'a> = dyn Fn(&[f64], &[f64]) -> bool + 'a;

/// Numbers on three axes, with the same number of entries at each place.
struct Grid {
    numbers: Vec<f64>,
    lengths: [usize; 3],
    entries: usize,
}

/// Returns a spline for each of the `entries` numbers at each place. All coefficients are kept if there is
/// no condition.
fn interpolated(
    shape: &[usize],
    entries: usize,
    samples: Vec<f64>,
    keeps: Option<&Keeps<'_>>,
) -> Result<Vec<FineSpline>, SplineError> {
    let columns: Vec<Vec<f64>> = (0..entries)
        .map(|entry| samples.iter().skip(entry).step_by(entries).copied().collect())
        .collect();
    columns.iter().try_for_each(|column| check(shape, column))?;
    let axes = shape.len();
    let mut lengths = [1; 3];
    lengths[3 - axes..].copy_from_slice(shape);
    let orders: &[&[usize]] = match axes {
        1 => &[&[2]],
        2 => &[&[1, 2], &[2, 1]],
        _ => &[&[0, 1, 2], &[0, 2, 1], &[1, 0, 2], &[1, 2, 0], &[2, 0, 1], &[2, 1, 0]],
    };
    let fine = lengths.map(|length| PER_SAMPLE * (length - 1) + 1);
    let count = fine.iter().try_fold(entries, |product, &n| product.checked_mul(n));
    let Some(count) = count.filter(|&count| count <= MOST) else {
        return Err(SplineError::TooFine { shape: shape.to_vec(), most: MOST });
    };
    let mut mean = vec![0.0; count];
    let share = 1.0 / orders.len() as f64;
    let given = Grid { numbers: samples, lengths, entries };
    for order in orders {
        let (&last, first) = order.split_last().unwrap_or((&2, &[]));
        let mut refined: Option<Grid> = None;
        for &axis in first {
            let from = refined.as_ref().unwrap_or(&given);
            let mut lengths = from.lengths;
            lengths[axis] = fine[axis];
            let mut numbers = vec![0.0; entries * lengths.iter().product::<usize>()];
            from.refine(axis, keeps, &mut |at, coefficient| numbers[at] = coefficient);
            refined = Some(Grid { numbers, lengths, entries });
        }
        let from = refined.as_ref().unwrap_or(&given);
        from.refine(last, keeps, &mut |at, coefficient| mean[at] += share * coefficient);
    }
    let splines = columns.iter().enumerate().map(|(entry, column)| {
        // A mean is rounded.
        let lo = column.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let numbers = mean.iter().skip(entry).step_by(entries);
        let spline = Spline::new(&fine[3 - axes..], numbers.map(|c| c.clamp(lo, hi)).collect())?;
        Ok(FineSpline { spline: Arc::new(spline) })
    });
    splines.collect()
}

impl Grid {
    /// Calls `put` with the place of each coefficient on the grid with three times as many steps along an
    /// axis, and with the coefficient.
    fn refine(&self, axis: usize, keeps: Option<&Keeps<'_>>, put: &mut impl FnMut(usize, f64)) {
        let (n, entries) = (self.lengths[axis], self.entries);
        let fine = PER_SAMPLE * (n - 1) + 1;
        let outer: usize = self.lengths[..axis].iter().product();
        let row = self.lengths[axis + 1..].iter().product::<usize>() * entries;
        let mut around: [Vec<f64>; 3] = array::from_fn(|_| vec![0.0; entries]);
        for block in 0..outer {
            let rows = &self.numbers[block * n * row..][..n * row];
            for i in 0..n {
                let at = |i: usize| &rows[i * row..][..row];
                let (before, here, after) =
                    (at(i.saturating_sub(1)), at(i), at((i + 1).min(n - 1)));
                // The first place has no coefficient before it, the last none behind.
                let steps = usize::from(i == 0)..if i + 1 == n { 2 } else { 3 };
                let start = |step: usize| (block * fine + PER_SAMPLE * i + step - 1) * row;
                for place in (0..row).step_by(entries) {
                    for entry in 0..entries {
                        let at = place + entry;
                        let three = coefficients(before[at], here[at], after[at]);
                        around.iter_mut().zip(three).for_each(|(all, c)| all[entry] = c);
                    }
                    let sample = &here[place..][..entries];
                    if keeps.is_some_and(|keeps| !around.iter().all(|c| keeps(c, sample))) {
                        around.iter_mut().for_each(|all| all.copy_from_slice(sample));
                    }
                    for step in steps.clone() {
                        let place = start(step) + place;
                        around[step]
                            .iter()
                            .enumerate()
                            .for_each(|(entry, &c)| put(place + entry, c));
                    }
                }
            }
        }
    }
}

/// Returns the coefficients a third before a sample, at it, and a third behind it.
fn coefficients(before: f64, here: f64, after: f64) -> [f64; 3] {
    let (a, b) = (here - before, after - here);
    if !(a > 0.0 && b > 0.0 || a < 0.0 && b < 0.0) {
        return [here; 3];
    }
    let least = a.abs().min(b.abs());
    let within = |x: f64, most: f64| x.clamp(-most, most);
    let slope = within(0.5 * a + 0.5 * b, 1.25 * least);
    let bend = within(b - a, 2.25 * least);
    // Rounding leaves the samples no more than the exact numbers do.
    let between = |x: f64, one: f64, other: f64| x.clamp(one.min(other), one.max(other));
    let low = between(here - slope / 3.0 + bend / 27.0, before, here);
    let high = between(here + slope / 3.0 + bend / 27.0, here, after);
    [low, between(here - bend / 54.0, low, high), high]
}

/// Returns whether a symmetric matrix is positive definite, given its entries on and above the diagonal,
/// by Cholesky's decomposition.
fn is_positive_definite(mut entries: Vec<f64>, size: usize) -> bool {
    // Row i begins behind the rows before it, which have size, size − 1, … entries.
    let at = |i: usize, j: usize| i * size - i * (i + 1) / 2 + j;
    for i in 0..size {
        let pivot = entries[at(i, i)];
        // Written so that NaN is no pivot.
        if !(pivot > 0.0) {
            return false;
        }
        for j in i + 1..size {
            let factor = entries[at(i, j)] / pivot;
            for k in j..size {
                entries[at(j, k)] -= factor * entries[at(i, k)];
            }
        }
    }
    true
}
