//! Elementary functions of whole blocks of numbers.
//!
//! By `+ − × ÷` and bits alone, in the order that is written, without branches: the same bits for every
//! size of a block and every width of a register, and loops that a compiler turns into vector code. Numbers
//! out of the range of a polynomial go to the standard library, one by one.
//!
//! | function | error, in units of the last place | range |
//! | --- | --- | --- |
//! | sine, cosine | 2, of the value or of 10⁻⁸ where that is less | `|x| ≤ 10⁶` |
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

pub(crate) use arctangent::atan;
pub(crate) use circular::sin_cos;
pub(crate) use exponential::exp;
pub(crate) use hyperbolic::{cosh, tanh};
pub(crate) use logarithm::ln;

/// Added and taken off again it rounds to a whole number, ties to even; the sum has that number in its
/// last bits: `1.5 · 2⁵²`.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Whether all numbers are within a range, in one pass without branches; NaN is in none.
#[inline(always)]
fn all<const B: usize>(x: &[f64; B], is_within: impl Fn(f64) -> bool) -> bool {
    let mut out = 0_u64;
    for &x in x {
        out |= u64::from(!is_within(x));
    }
    out == 0
}

#[cfg(test)]
mod tests {
    use astro_float::{BigFloat, Consts, RoundingMode};

    const P: usize = 192;
    const RM: RoundingMode = RoundingMode::None;

    /// Numbers that fill `[lo, hi]` evenly: fractions of multiples of the golden ratio.
    pub(super) fn even(lo: f64, hi: f64) -> impl Iterator<Item = f64> {
        (1..=2000_u32).map(move |i| lo + (hi - lo) * (f64::from(i) * 0.618_033_988_749_895).fract())
    }

    /// The same with exponents that do.
    pub(super) fn geometric(lo: f64, hi: f64) -> impl Iterator<Item = f64> {
        even(lo.ln(), hi.ln()).map(f64::exp)
    }

    /// Fails unless `of(x)` is nowhere farther from the value than `ulp` units in its last place, but no
    /// less than those of `least`; and somewhere nearly half as far, so that the bound says something.
    #[track_caller]
    pub(super) fn assert_within(
        ulp: f64,
        least: f64,
        xs: impl Iterator<Item = f64>,
        of: impl Fn(f64) -> f64,
        value: impl Fn(&BigFloat, &mut Consts) -> BigFloat,
    ) {
        let mut constants = Consts::new().expect("memory");
        let mut most = 0.0_f64;
        let big = |x: f64| BigFloat::from_f64(x, P);
        for x in xs {
            let y = of(x);
            let unit = y.abs().max(least).next_up() - y.abs().max(least);
            let made = value(&big(x), &mut constants).sub(&big(y), P, RM).abs().to_string();
            let units = made.parse::<f64>().expect("a number") / unit;
            assert!(units <= ulp, "{x:e}: {y:e} is off by {units} units");
            most = most.max(units);
        }
        assert!(most > 0.4 * ulp, "the errors are far smaller: {most} units");
    }

    /// One value of a function of blocks, which is the same in a block of any size, at any place.
    pub(super) fn single(
        x: f64,
        of: impl Fn(&mut [f64; 8], &[f64; 8]),
        of_one: impl Fn(&mut [f64; 1], &[f64; 1]),
    ) -> f64 {
        let (mut block, mut one) = ([0.0; 8], [0.0]);
        of(&mut block, &[x, 0.5, -x, x, 1.0, 2.0, x, 0.25]);
        of_one(&mut one, &[x]);
        let same = [0, 3, 6].map(|place| block[place].to_bits());
        assert_eq!(same, [one[0].to_bits(); 3], "{x:e}");
        one[0]
    }
}
