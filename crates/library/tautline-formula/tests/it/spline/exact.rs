//! Exact derivatives of a spline at a point, from the two polynomials of which the cubic B-spline
//! consists, in 1280 bits.

use astro_float::{BigFloat, RoundingMode};
use tautline_formula::spline::Spline;
use tautline_scalar::Interval;

/// The precision, in bits. Weights are cubic in differences of a double and an integer. Products
/// of three of them are exact, unless a coordinate is smaller than `2⁻⁷⁰` and not 0.
const P: usize = 1280;
const RM: RoundingMode = RoundingMode::None;

/// Returns a double exactly, subnormal ones too.
pub(crate) fn big(x: f64) -> BigFloat {
    let up = 2.0_f64.powi(600);
    if x != 0.0 && x.abs() < 1e-290 {
        BigFloat::from_f64(x * up, P).div(&BigFloat::from_f64(up, P), P, RM)
    } else {
        BigFloat::from_f64(x, P)
    }
}

/// Returns six times the derivative of this order of `B(u − i)`, for a node `i` between `−1` and
/// `2` cells above the cell of `u`, and `t` the distance of `u` from the lower node of the cell.
fn weight(t: &BigFloat, j: usize, order: u8) -> BigFloat {
    let number = |x: f64| BigFloat::from_f64(x, P);
    let sum = |coefficients: [f64; 4], y: &BigFloat| {
        coefficients
            .iter()
            .rev()
            .fold(number(0.0), |sum, &c| sum.mul(y, P, RM).add(&number(c), P, RM))
    };
    // Six times B(x) is (2 − |x|)³ for 1 ≤ |x| ≤ 2, and 4 − 6x² + 3|x|³ for |x| ≤ 1. Derivatives are
    // those with respect to `2 − |x|` and to `|x|`, whose signs are opposite on either side.
    let outer = [[0., 0., 0., 1.], [0., 0., 3., 0.], [0., 6., 0., 0.], [6., 0., 0., 0.]];
    let inner = [[4., 0., -6., 3.], [0., -12., 9., 0.], [-12., 18., 0., 0.], [18., 0., 0., 0.]];
    let rest = number(1.0).sub(t, P, RM);
    let at = usize::from(order);
    let (value, falls) = match j {
        0 => (sum(outer[at], &rest), true),
        1 => (sum(inner[at], t), false),
        2 => (sum(inner[at], &rest), true),
        _ => (sum(outer[at], t), false),
    };
    if falls && order % 2 == 1 { value.neg() } else { value }
}

/// A derivative at a point, times `6^E`.
pub(crate) struct Exact {
    value: BigFloat,
    scale: BigFloat,
    /// The largest coefficient that meets the cell, in absolute value.
    pub(crate) largest: f64,
}

impl Exact {
    /// Returns the derivative in the cell above a node, or in that below it.
    pub(crate) fn new(spline: &Spline, u: &[f64], orders: [u8; 3], below: bool) -> Self {
        let shape = spline.shape();
        let mut terms = vec![(0, BigFloat::from_f64(1.0, P))];
        for (axis, &n) in shape.iter().enumerate() {
            let u = u[axis].clamp(-2.0, n as f64 + 1.0);
            let cell = if below { u.ceil() - 1.0 } else { u.floor() };
            let t = big(u).sub(&big(cell), P, RM);
            let mut next = Vec::new();
            for (at, product) in terms {
                for j in 0..4 {
                    let node = (cell as i64 - 1 + j as i64).clamp(0, n as i64 - 1) as usize;
                    let weight = weight(&t, j, orders[axis]);
                    next.push((at * n + node, product.mul(&weight, P, RM)));
                }
            }
            terms = next;
        }
        let mut exact =
            Self { value: big(0.0), scale: big(6.0_f64.powi(shape.len() as i32)), largest: 0.0 };
        for (at, weight) in terms {
            let c = spline.coefficients()[at];
            exact.largest = exact.largest.max(c.abs());
            exact.value = exact.value.add(&big(c).mul(&weight, P, RM), P, RM);
        }
        exact
    }

    /// Returns whether the derivative lies in the interval, up to `2⁻¹⁰⁰⁰` of the largest coefficient,
    /// for the rounding in 1280 bits.
    pub(crate) fn is_in(&self, x: Interval) -> bool {
        let half = |x: f64| big(0.5).powi(500, P, RM).mul(&big(x), P, RM);
        self.is_between(&big(x.lo()), &big(x.hi()), &half(1.0).mul(&half(self.largest), P, RM))
    }

    /// Returns whether the derivative is at most `tolerance` from `x`.
    pub(crate) fn is_near(&self, x: f64, tolerance: f64) -> bool {
        self.is_between(&big(x), &big(x), &big(tolerance))
    }

    fn is_between(&self, lo: &BigFloat, hi: &BigFloat, slack: &BigFloat) -> bool {
        let lo = lo.sub(slack, P, RM).mul(&self.scale, P, RM);
        let hi = hi.add(slack, P, RM).mul(&self.scale, P, RM);
        lo.cmp(&self.value).is_some_and(|order| order <= 0)
            && hi.cmp(&self.value).is_some_and(|order| order >= 0)
    }
}
