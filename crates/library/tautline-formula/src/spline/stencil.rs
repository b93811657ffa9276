//! `Stencil`: the differences of a few neighbouring coefficients, with a bound on their rounding.

use super::{Spline, basis, place::clamped};

/// The distance in `values` of neighbours along each axis.
const STRIDES: [usize; 3] = [16, 4, 1];

/// Up to 4 × 4 × 4 numbers.
pub(crate) struct Stencil {
    values: [f64; 64],
    /// How many there are along each axis.
    counts: [usize; 3],
    /// Bounds on the distance of each value from the exact difference.
    errors: [f64; 64],
}

impl Stencil {
    /// Returns the differences of these orders, each at most 3, from number `start` on, `counts` of
    /// them along each axis. The order and the count have a sum of at most 4.
    pub(crate) fn new(
        spline: &Spline,
        start: [isize; 3],
        counts: [usize; 3],
        orders: [usize; 3],
    ) -> Self {
        let [_, rows, row] = spline.lengths;
        let strides = [rows * row, row, 1];
        let taken: [usize; 3] = std::array::from_fn(|axis| counts[axis] + orders[axis]);
        let [x, y, z] = std::array::from_fn(|axis| {
            clamped(start[axis], taken[axis], spline.lengths[axis], strides[axis])
        });
        let mut stencil = Self { values: [0.0; 64], counts: taken, errors: [0.0; 64] };
        for i in 0..taken[0] {
            for j in 0..taken[1] {
                for k in 0..taken[2] {
                    stencil.values[16 * i + 4 * j + k] = spline.coefficients[x[i] + y[j] + z[k]];
                }
            }
        }
        for axis in 0..3 {
            for _ in 0..orders[axis] {
                stencil.difference(axis);
            }
        }
        stencil
    }

    /// Replaces the values by their differences along one axis.
    ///
    /// The error of a difference is at most the sum of the errors of both values, and its own
    /// rounding, which Knuth's TwoSum finds exactly. So differences of integers, and of other
    /// numbers with few digits, have no error at all. The sum is rounded up: its relative error is
    /// less than `3u`, and that of the product `u`; if it is subnormal, it is exact.
    fn difference(&mut self, axis: usize) {
        let stride = STRIDES[axis];
        self.counts[axis] -= 1;
        let (values, errors) = (&mut self.values, &mut self.errors);
        each(self.counts, |at| {
            let (a, b) = (values[at + stride], -values[at]);
            let s = a + b;
            let from_b = s - a;
            let from_a = s - from_b;
            let rounding = ((a - from_a) + (b - from_b)).abs();
            values[at] = s;
            errors[at] = (errors[at] + errors[at + stride] + rounding) * (1.0 + 4.0 * f64::EPSILON);
        });
    }

    /// Returns bounds on all exact differences.
    pub(crate) fn hull(&self) -> (f64, f64) {
        let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
        each(self.counts, |at| {
            let (value, error) = (self.values[at], self.errors[at]);
            lo = lo.min(if error == 0.0 { value } else { (value - error).next_down() });
            hi = hi.max(if error == 0.0 { value } else { (value + error).next_up() });
        });
        (lo, hi)
    }

    fn extremes(&self) -> (f64, f64) {
        let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
        each(self.counts, |at| {
            lo = lo.min(self.values[at]);
            hi = hi.max(self.values[at]);
        });
        (lo, hi)
    }

    /// Replaces the values along one axis by their combinations with each row of `weights`. A row
    /// has zeros where there are no values.
    fn combine(&mut self, axis: usize, weights: &[[f64; 4]]) {
        let stride = STRIDES[axis];
        self.counts[axis] = 1;
        let values = &mut self.values;
        each(self.counts, |at| {
            let x = [0, 1, 2, 3].map(|j| values[at + j * stride]);
            for (r, &row) in weights.iter().enumerate() {
                values[at + r * stride] = basis::dot(row, x);
            }
        });
        self.counts[axis] = weights.len();
    }

    /// Returns bounds on the combinations of the exact differences with the products of `weights`,
    /// one set of rows for each of the last `axes` axes. The rows are those of a blossom, of the
    /// degrees given.
    ///
    /// # Rounding
    ///
    /// Let `m` be the largest value, `u = 2⁻⁵³`, and `w` the exact weights of one axis, which are
    /// not negative and have the sum 1, after the division by `p!`. The computed weights have a
    /// relative error of `7u` (see `basis`), and a combination of four adds `4u` of the sum of the
    /// `w |x|`, which is at most `m`. In the cell below 0, `t` is rounded by `u/2`, and slopes are at
    /// most `2m`. That is `12u m` for each axis, and the division by all `p!` at the end adds `u m`.
    /// With 13 for each axis, terms of higher order and the rounding of the bound itself are covered.
    /// So is the underflow of weights, below `2⁻¹⁰⁷⁰ m`.
    ///
    /// If a product of weight and value underflows, it is wrong by at most `2⁻¹⁰⁷⁵`. At most 4
    /// products in each of at most 3 combinations enter a result, which is then divided by what
    /// later weights multiply it by: less than `2⁻¹⁰⁷⁰` together. The error of the differences
    /// passes through unchanged, as the exact weights have the sum 1.
    pub(crate) fn combinations(
        mut self,
        axes: usize,
        degrees: [usize; 3],
        weights: [&[[f64; 4]]; 3],
    ) -> (f64, f64) {
        const TINY: f64 = f64::from_bits(16);
        const UNIT: f64 = 0.5 * f64::EPSILON;
        let hull = self.hull();
        let (lo, hi) = self.extremes();
        let largest = hi.max(-lo);
        let mut error = 0.0_f64;
        each(self.counts, |at| error = error.max(self.errors[at]));
        let mut scale = 1.0;
        for axis in (3 - axes..3).rev() {
            self.combine(axis, weights[axis]);
            scale *= basis::FACTORIAL[degrees[axis]];
        }
        let relative = (13 * axes + 2) as f64 * UNIT;
        let radius = (error + relative * largest) * (1.0 + 4.0 * f64::EPSILON) + TINY;
        let (lo, hi) = self.extremes();
        // Combinations also lie in the hull of the differences, which is exact where these are.
        let lo = (lo / scale - radius).next_down().max(hull.0);
        let hi = (hi / scale + radius).next_up().min(hull.1);
        (lo, hi)
    }
}

/// Calls `visit` for the place of each of these numbers, in ascending order.
#[inline]
fn each([x, y, z]: [usize; 3], mut visit: impl FnMut(usize)) {
    for i in 0..x {
        for j in 0..y {
            for k in 0..z {
                visit(16 * i + 4 * j + k);
            }
        }
    }
}
