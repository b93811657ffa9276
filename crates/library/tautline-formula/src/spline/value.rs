//! The value of one derivative at a point.

use super::{
    Spline,
    basis::{FACTORIAL, blossom, difference, dot, second_difference},
    place::{Place, clamped},
};

impl Spline {
    /// Returns the partial derivative of these orders at `u`, in grid units: `orders[0]` times
    /// along the first axis, and so on. `[0, 0, 0]` is the value.
    ///
    /// Third derivatives are constant on each cell; at a node the result is that of the cell above.
    /// Derivatives of order 4 or more are 0, as are those along an axis that the spline does not
    /// have. At infinite coordinates the result is the limit.
    ///
    /// Returns NaN if a coordinate is NaN, or if there are not as many coordinates as axes.
    ///
    /// The rounding error is at most `2ᵃ⁻⁴⁷ m`, where `a` is the sum of the orders, and `m` the largest
    /// of the `4^E` coefficients that meet the cell, in absolute value: each axis adds at most `12 u`,
    /// see the bound of enclosures in `stencil.rs`, and a difference doubles. Differences of equal
    /// coefficients are exactly 0.
    #[must_use]
    pub fn value(&self, u: &[f64], orders: [u8; 3]) -> f64 {
        if u.len() != self.axes || u.iter().any(|u| u.is_nan()) {
            return f64::NAN;
        }
        let Some(orders) = self.inner_orders(orders) else {
            return 0.0;
        };
        let first = 3 - self.axes;
        let mut at = [[0; 4]; 3];
        let mut weights = [[0.0; 4]; 3];
        let mut scale = 1.0;
        let mut stride = 1;
        for axis in (first..3).rev() {
            let n = self.lengths[axis];
            let place = Place::of(u[axis - first], n);
            let degree = 3 - orders[axis];
            at[axis] = clamped(place.cell - 1, 4, n, stride);
            weights[axis] = blossom(degree, [place.t; 3]);
            scale *= FACTORIAL[degree];
            stride *= n;
        }
        let c = &*self.coefficients;
        let row = |i: usize, j: usize| {
            let at_row = at[0][i] + at[1][j];
            derivative(at[2].map(|k| c[at_row + k]), orders[2], weights[2])
        };
        let plane = |i: usize| {
            if self.axes == 1 {
                row(i, 0)
            } else {
                derivative([0, 1, 2, 3].map(|j| row(i, j)), orders[1], weights[1])
            }
        };
        let sum = if self.axes < 3 {
            plane(0)
        } else {
            derivative([0, 1, 2, 3].map(plane), orders[0], weights[0])
        };
        sum / scale
    }
}

/// Returns the derivative of this order along one axis, from the four coefficients of a cell and
/// the weights of degree `3 − order`.
#[inline]
fn derivative(c: [f64; 4], order: usize, weights: [f64; 4]) -> f64 {
    let [v, w, x, _] = weights;
    match order {
        0 => dot(weights, c),
        1 => dot([v, w, x], difference(c)),
        2 => dot([v, w], second_difference(difference(c))),
        _ => {
            let [a, b] = second_difference(difference(c));
            b - a
        }
    }
}
