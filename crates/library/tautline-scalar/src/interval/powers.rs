//! Integer powers of intervals.

use num_traits::One;

use super::{
    Enclosure,
    directed::{mul_down, mul_up},
    kernel::Kernel,
};
use crate::Scalar;

impl<K: Kernel> Enclosure<K> {
    /// Returns `xⁿ`. It is `1` for `n = 0`, and undefined if `n < 0` and the interval contains
    /// zero.
    pub(super) fn power(self, n: i32) -> Self {
        if self.is_undefined() {
            return self;
        }
        // The reciprocal comes first: a power of a small number may underflow, and would then
        // contain zero.
        let x = if n < 0 { Self::one() / self } else { self };
        let n = n.unsigned_abs();
        match n {
            0 => Self::one(),
            1 => x,
            2 => x.sqr(),
            _ if x.is_undefined() => x,
            // The power increases with |x|.
            _ if n.is_multiple_of(2) => Self::enclosing(
                power_of_positive(x.mignitude(), n, mul_down),
                power_of_positive(x.magnitude(), n, mul_up),
            ),
            // The power increases with x.
            _ => {
                let lo = if x.lo() >= 0.0 {
                    power_of_positive(x.lo(), n, mul_down)
                } else {
                    -power_of_positive(-x.lo(), n, mul_up)
                };
                let hi = if x.hi() >= 0.0 {
                    power_of_positive(x.hi(), n, mul_up)
                } else {
                    -power_of_positive(-x.hi(), n, mul_down)
                };
                Self::enclosing(lo, hi)
            }
        }
    }
}

/// Returns a bound on `xⁿ` for `x ≥ 0` and `n ≥ 1`, on the side to which `mul` rounds. It is valid
/// because a product of nonnegative numbers increases with each factor.
fn power_of_positive(x: f64, mut n: u32, mul: impl Fn(f64, f64) -> f64) -> f64 {
    let mut square = x;
    let mut result: Option<f64> = None;
    loop {
        if n % 2 == 1 {
            result = Some(result.map_or(square, |r| mul(r, square)));
        }
        n /= 2;
        if n == 0 {
            return result.unwrap_or(1.0);
        }
        square = mul(square, square);
    }
}
