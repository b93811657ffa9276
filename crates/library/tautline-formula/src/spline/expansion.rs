//! `Expansion`: value, gradient and Hessian at a point, in one pass over its coefficients.

use super::{
    Spline,
    basis::{cubic, difference, dot, linear, quadratic, second_difference},
    place::{Place, clamped},
};

/// The value of a spline at a point, with all derivatives of first and second order, in grid units;
/// or bounds on each of them.
///
/// Entries of axes that the spline does not have are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expansion<T = f64> {
    /// The value.
    pub value: T,
    /// The gradient: the derivative along each axis.
    pub gradient: [T; 3],
    /// The Hessian, which is symmetric.
    pub hessian: [[T; 3]; 3],
}

/// The weights of the cubic, of its first and of its second derivative.
#[derive(Clone, Copy)]
struct Weights([f64; 4], [f64; 3], [f64; 2]);

impl Weights {
    #[inline]
    fn at(t: f64) -> Self {
        let first = linear(t);
        let second = quadratic(first, t);
        Self(cubic(second, t).map(|w| w / 6.0), second.map(|w| 0.5 * w), first)
    }

    /// Returns the value and both derivatives along one axis.
    #[inline]
    fn line(self, c: [f64; 4]) -> [f64; 3] {
        let d = difference(c);
        [dot(self.0, c), dot(self.1, d), dot(self.2, second_difference(d))]
    }

    /// Returns the value and the first derivative along one axis.
    #[inline]
    fn slope(self, c: [f64; 4]) -> [f64; 2] {
        [dot(self.0, c), dot(self.1, difference(c))]
    }
}

impl Expansion {
    const ZERO: Self = Self { value: 0.0, gradient: [0.0; 3], hessian: [[0.0; 3]; 3] };
    const NAN: Self =
        Self { value: f64::NAN, gradient: [f64::NAN; 3], hessian: [[f64::NAN; 3]; 3] };
}

/// The columns of four rows.
#[inline]
fn columns<const N: usize>(rows: [[f64; N]; 4]) -> [[f64; 4]; N] {
    std::array::from_fn(|k| rows.map(|row| row[k]))
}

/// Returns `[f, f₁, f₂, f₁₁, f₁₂, f₂₂]` on two axes.
#[inline]
fn plane(weights: [Weights; 2], rows: [[f64; 4]; 4]) -> [f64; 6] {
    let [f, g, h] = columns(rows.map(|row| weights[1].line(row)));
    let [value, first, first_first] = weights[0].line(f);
    let [second, first_second] = weights[0].slope(g);
    [value, first, second, first_first, first_second, dot(weights[0].0, h)]
}

impl Spline {
    /// Returns the value, the gradient and the Hessian at `u`. This is faster than a call of
    /// [`value`](Self::value) for each of them, and agrees with it to rounding.
    ///
    /// All are NaN if a coordinate is NaN, or if there are not as many coordinates as axes. At
    /// infinite coordinates the results are the limits.
    #[must_use]
    pub fn expansion(&self, u: &[f64]) -> Expansion {
        match *u {
            [x] if self.axes == 1 && !x.is_nan() => {
                let ([at], [weights]) = self.places([x]);
                let [value, first, second] = weights.line(at.map(|k| self.coefficients[k]));
                let mut all = Expansion { value, ..Expansion::ZERO };
                (all.gradient[0], all.hessian[0][0]) = (first, second);
                all
            }
            [x, y] if self.axes == 2 && !x.is_nan() && !y.is_nan() => {
                let ([rows, at], weights) = self.places([x, y]);
                let [value, f1, f2, f11, f12, f22] = plane(weights, self.rows(0, rows, at));
                Expansion {
                    value,
                    gradient: [f1, f2, 0.0],
                    hessian: [[f11, f12, 0.0], [f12, f22, 0.0], [0.0; 3]],
                }
            }
            [x, y, z] if self.axes == 3 && !x.is_nan() && !y.is_nan() && !z.is_nan() => {
                let ([planes, rows, at], weights) = self.places([x, y, z]);
                let [w1, w2, w3] = weights;
                let planes = planes.map(|i| plane([w2, w3], self.rows(i, rows, at)));
                let [f, g2, g3, h22, h23, h33] = columns(planes);
                let [value, f1, f11] = w1.line(f);
                let ([f2, f12], [f3, f13]) = (w1.slope(g2), w1.slope(g3));
                let [f22, f23, f33] = [h22, h23, h33].map(|h| dot(w1.0, h));
                Expansion {
                    value,
                    gradient: [f1, f2, f3],
                    hessian: [[f11, f12, f13], [f12, f22, f23], [f13, f23, f33]],
                }
            }
            _ => Expansion::NAN,
        }
    }

    /// Returns the positions and weights of the coefficients along each of the `E` axes.
    #[inline]
    fn places<const E: usize>(&self, u: [f64; E]) -> ([[usize; 4]; E], [Weights; E]) {
        let mut at = [[0; 4]; E];
        let mut weights = [Weights::at(0.0); E];
        let mut stride = 1;
        for axis in (0..E).rev() {
            let n = self.lengths[3 - E + axis];
            let place = Place::of(u[axis], n);
            at[axis] = clamped(place.cell - 1, 4, n, stride);
            weights[axis] = Weights::at(place.t);
            stride *= n;
        }
        (at, weights)
    }

    #[inline]
    fn rows(&self, start: usize, rows: [usize; 4], at: [usize; 4]) -> [[f64; 4]; 4] {
        rows.map(|row| at.map(|k| self.coefficients[start + row + k]))
    }
}
