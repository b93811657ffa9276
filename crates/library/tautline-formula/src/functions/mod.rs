//! Elementary functions of whole blocks of numbers.
//!
//! They use only `+ − × ÷` and bit operations, in the written order and without branches. Every
//! block size and register width therefore gives the same bits, and the compiler vectorises the
//! loops. Numbers outside the range of a polynomial are passed to the standard library, one by one.
//!
//! | function | error, in units of the last place | range |
//! | --- | --- | --- |
//! | sine, cosine | 2, of the value or of 10⁻⁸ if that is larger | `|x| ≤ 10⁶` |
//! | exponential | 1 | `−708 ≤ x ≤ 709` |
//! | logarithm | 1 | normal numbers |
//! | hyperbolic tangent | 2 | all |
//! | hyperbolic cosine | 2 | `|x| ≤ 700` |
//! | arctangent | 1 | all |

mod arctangent;
mod circular;
mod exponential;
mod hyperbolic;
mod logarithm;
#[cfg(test)]
mod tests;

pub(crate) use arctangent::atan;
pub(crate) use circular::sin_cos;
pub(crate) use exponential::exp;
pub(crate) use hyperbolic::{cosh, tanh};
pub(crate) use logarithm::ln;

/// `1.5 · 2⁵²`. Adding and subtracting it rounds to an integer, ties to even. The last bits of the
/// sum are that integer.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Returns whether all numbers are in a range, without branches. NaN is in no range.
#[inline(always)]
fn all<const B: usize>(x: &[f64; B], is_within: impl Fn(f64) -> bool) -> bool {
    let mut out = 0_u64;
    for &x in x {
        out |= u64::from(!is_within(x));
    }
    out == 0
}
