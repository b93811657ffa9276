//! Enclosures of derivatives over boxes, and ranges over all of space.

use tautline_scalar::{Enclosure, Kernel};

use super::{Expansion, Spline, basis::blossom, stencil::Stencil};

/// An enclosure over at most so many cells takes each of them apart; over more it takes the range
/// of the coefficients.
const CELLS: usize = 16;

/// The part of a box along one axis.
struct Side {
    /// The ends, at most one cell beyond the cells in which the spline is not constant.
    lo: f64,
    hi: f64,
    /// The cells from the first to the last.
    first: isize,
    last: isize,
}

impl Side {
    /// Returns the part `[lo, hi]` of an axis of `n` coefficients, for a derivative of this order.
    ///
    /// Up to the second order derivatives are continuous, so a cell that only touches the interval
    /// adds nothing. Third derivatives jump at nodes, and there both one-sided values count.
    fn new((lo, hi): (f64, f64), n: usize, order: usize) -> Self {
        // Beyond −1 and n the spline is constant, so one cell there stands for all.
        let end = n as f64 + 1.0;
        let (lo, hi) = (lo.clamp(-2.0, end), hi.clamp(-2.0, end));
        let (first, last) = if order < 3 {
            let first = lo.floor();
            (first, first.max(hi.ceil() - 1.0))
        } else {
            (lo.ceil() - 1.0, hi.floor())
        };
        Self { lo, hi, first: first as isize, last: last as isize }
    }

    fn cells(&self) -> usize {
        self.last.abs_diff(self.first) + 1
    }

    /// Returns the weights of the Bernstein coefficients on the part of a cell that belongs to the
    /// interval, and how many there are. A single point has one, its value.
    fn bernstein(&self, cell: isize, degree: usize) -> ([[f64; 4]; 4], usize) {
        let (a, b) = (distance(cell, self.lo), distance(cell, self.hi));
        let count = if a == b { 1 } else { degree + 1 };
        let point = |j: usize, q: usize| if q < j { b } else { a };
        let row = |j| blossom(degree, [point(j, 0), point(j, 1), point(j, 2)]);
        let mut rows = [[0.0; 4]; 4];
        for (j, rows) in rows.iter_mut().enumerate().take(count) {
            *rows = row(j);
        }
        (rows, count)
    }
}

/// Returns the number in `[0, 1]` that is nearest to `u − cell`, up to rounding by `2⁻⁵⁴`.
///
/// It is exact in the cell of `u ≥ 0` and beyond, see [`Place`](super::place::Place), and 0 or 1 if
/// `u` is not in the cell, since rounding keeps the order. Only in the cell below 0 it is rounded.
fn distance(cell: isize, u: f64) -> f64 {
    (u - cell as f64).clamp(0.0, 1.0)
}

impl Spline {
    /// Returns bounds on the partial derivative of these orders over a box, in grid units.
    ///
    /// Sides may be unbounded. Orders are those of [`value`](Self::value). Third derivatives are
    /// bounded with both values that they have at a node, so that a mean value form may use them.
    ///
    /// The result is undefined if a side is, or if there are not as many sides as axes. Otherwise
    /// it is finite.
    ///
    /// # Slack
    ///
    /// Over a box of at most 16 cells the result is the range of the Bernstein coefficients on the
    /// part of each cell. If the box shrinks, it exceeds the true range by a multiple of the square
    /// of the width. At a point it is wide by at most `2⁻⁴⁶` of the largest difference of these orders
    /// that meets the cell, and twice the rounding of these differences.
    ///
    /// Over more cells the result is the range of the coefficients that meet them, or of their
    /// differences. A search of a pyramid finds it, without a look at most of them.
    #[must_use]
    pub fn enclosure<K: Kernel>(&self, u: &[Enclosure<K>], orders: [u8; 3]) -> Enclosure<K> {
        if u.len() != self.axes || u.iter().any(|side| side.is_undefined()) {
            return Enclosure::UNDEFINED;
        }
        let mut sides = [(0.0, 0.0); 3];
        sides.iter_mut().zip(u).for_each(|(side, u)| *side = (u.lo(), u.hi()));
        enclosing(self.bounds_over(&sides[..u.len()], orders))
    }

    /// Returns bounds over a box, given the ends of its sides, as many as there are axes and none NaN.
    pub(crate) fn bounds_over(&self, ends: &[(f64, f64)], orders: [u8; 3]) -> (f64, f64) {
        let Some(orders) = self.inner_orders(orders) else {
            return (0.0, 0.0);
        };
        let first = 3 - self.axes;
        let sides: [Side; 3] = std::array::from_fn(|axis| {
            let side = ends.get(axis.wrapping_sub(first)).copied().unwrap_or((0.0, 0.0));
            Side::new(side, self.lengths[axis], orders[axis])
        });
        let cells =
            sides.iter().fold(1_usize, |product, side| product.saturating_mul(side.cells()));
        if cells <= CELLS {
            self.over_cells(&sides, orders)
        } else {
            let from =
                std::array::from_fn(|axis| if axis < first { 0 } else { sides[axis].first - 1 });
            let to = std::array::from_fn(|axis| {
                if axis < first { 0 } else { sides[axis].last + 2 - orders[axis] as isize }
            });
            self.pyramid(orders).range(self, from, to)
        }
    }

    /// Returns bounds on the value, the gradient and the Hessian over a box: for each of them the
    /// result of [`enclosure`](Self::enclosure).
    #[must_use]
    pub fn enclosures<K: Kernel>(&self, u: &[Enclosure<K>]) -> Expansion<Enclosure<K>> {
        let of = |axes: &[usize]| {
            let mut orders = [0; 3];
            axes.iter().for_each(|&axis| orders[axis] += 1);
            self.enclosure(u, orders)
        };
        let mut hessian = [[Enclosure::UNDEFINED; 3]; 3];
        for i in 0..3 {
            for j in i..3 {
                hessian[i][j] = of(&[i, j]);
                hessian[j][i] = hessian[i][j];
            }
        }
        Expansion { value: of(&[]), gradient: [0, 1, 2].map(|i| of(&[i])), hessian }
    }

    /// Returns bounds on the partial derivative of these orders over all of space: the range of the
    /// coefficients, or of their differences.
    ///
    /// The spline smooths its coefficients, so the result is wider than the true range: with `E` axes
    /// a single coefficient 1 among zeros has the range `[0, 1]`, but the largest value is `(2/3)ᴱ`.
    #[must_use]
    pub fn range<K: Kernel>(&self, orders: [u8; 3]) -> Enclosure<K> {
        enclosing(self.inner_orders(orders).map_or((0.0, 0.0), |orders| self.pyramid(orders).all()))
    }

    /// Returns bounds over the parts of a few cells.
    fn over_cells(&self, sides: &[Side; 3], orders: [usize; 3]) -> (f64, f64) {
        let first = 3 - self.axes;
        let degrees = orders.map(|order| 3 - order);
        // An axis that the spline does not have is one cell with one coefficient.
        let counts = std::array::from_fn(|axis| if axis < first { 1 } else { degrees[axis] + 1 });
        let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
        for x in sides[0].first..=sides[0].last {
            let along_x = sides[0].bernstein(x, degrees[0]);
            for y in sides[1].first..=sides[1].last {
                let along_y = sides[1].bernstein(y, degrees[1]);
                for z in sides[2].first..=sides[2].last {
                    let along_z = sides[2].bernstein(z, degrees[2]);
                    let start = [x, y, z].map(|cell| cell - 1);
                    let stencil = Stencil::new(self, start, counts, orders);
                    let weights = [&along_x, &along_y, &along_z].map(|(rows, n)| &rows[..*n]);
                    let cell = stencil.combinations(self.axes, degrees, weights);
                    lo = lo.min(cell.0);
                    hi = hi.max(cell.1);
                }
            }
        }
        (lo, hi)
    }
}

/// Returns `[lo, hi]`. These are numbers in order, but if they were not, there would be no bound.
fn enclosing<K: Kernel>((lo, hi): (f64, f64)) -> Enclosure<K> {
    Enclosure::new(lo, hi).unwrap_or(Enclosure::REALS)
}
