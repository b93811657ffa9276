//! The exact sign of a sum of products of doubles.

use std::cmp::Ordering;

/// The least exponent of a product of two doubles, `−2 · 1074`.
const LEAST: i32 = -2148;

/// The digits to the base `2³²` of the largest product, and one for the carry.
const DIGITS: usize = 134;

/// Returns the sign of `Σ a b`, of finite numbers, without rounding.
///
/// Every product is an integer times `2⁻²¹⁴⁸`, so the sum is added up as a long integer.
pub(crate) fn sign_of_products(products: impl IntoIterator<Item = [f64; 2]>) -> Ordering {
    // Digits may be negative or too large until all is added. 2²⁸ products would not overflow one.
    let mut digits = [0_i64; DIGITS];
    for [(a, e), (b, f)] in products.into_iter().map(|pair| pair.map(parts)) {
        let (product, place) = (i128::from(a) * i128::from(b), (e + f - LEAST) as usize);
        let (first, shift) = (place / 32, place % 32);
        for k in 0..4 {
            let digit = (product.unsigned_abs() >> (32 * k)) as u64 & u64::from(u32::MAX);
            let shifted = digit << shift;
            let sign = product.signum() as i64;
            digits[first + k] += sign * (shifted & u64::from(u32::MAX)) as i64;
            digits[first + k + 1] += sign * (shifted >> 32) as i64;
        }
    }
    let (mut carry, mut is_zero) = (0, true);
    for digit in digits {
        let sum = digit + carry;
        // The digits that are left are not negative, so that the carry has the sign.
        (carry, is_zero) = (sum >> 32, is_zero && sum & i64::from(u32::MAX) == 0);
    }
    carry.cmp(&0).then(if is_zero { Ordering::Equal } else { Ordering::Greater })
}

/// Returns integers `m` and `e` with `x = m 2ᵉ`.
fn parts(x: f64) -> (i64, i32) {
    let (exponent, fraction) =
        ((x.to_bits() >> 52 & 0x7ff) as i32, (x.to_bits() & ((1 << 52) - 1)));
    let magnitude = (if exponent == 0 { fraction } else { fraction | 1 << 52 }) as i64;
    (if x < 0.0 { -magnitude } else { magnitude }, exponent.max(1) - 1075)
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering::{Equal, Greater, Less};

    use tautline_chance::{Random, cases, seed};

    use super::{parts, sign_of_products};
    use crate::exact::Exact;

    #[test]
    fn doubles_are_integers_times_powers_of_two() {
        let numbers =
            [0.0, -0.0, 5e-324, -5e-324, f64::MIN_POSITIVE, 1.0, -0.1, f64::MAX, f64::MIN];
        for x in numbers {
            let (m, e) = parts(x);
            // Half the power twice, since the whole may underflow.
            let half = e / 2;
            assert_eq!(m as f64 * 2.0_f64.powi(half) * 2.0_f64.powi(e - half), x, "{x:e}");
        }
    }

    /// Terms that cancel down to the last bit of the least product, and up to the largest.
    #[test]
    fn cancellation_leaves_the_sign() {
        let least = f64::from_bits(1);
        for (huge, tiny) in [(f64::MAX, least), (1.0, 2.0_f64.powi(-60)), (3.0, least)] {
            for (last, sign) in [(tiny, Greater), (0.0, Equal), (-tiny, Less)] {
                let terms = [[huge, huge], [last, tiny], [-huge, huge]];
                assert_eq!(sign_of_products(terms), sign, "{huge:e} {last:e}");
            }
        }
        assert_eq!(sign_of_products([[f64::MAX, f64::MAX]; 1000]), Greater);
        assert_eq!(sign_of_products([[f64::MIN, f64::MAX]; 1000]), Less);
        assert_eq!(sign_of_products([]), Equal);
    }

    /// Sums of products whose last term takes back the rounded sum of the others, against long
    /// numbers.
    #[test]
    fn signs_are_those_of_long_numbers() {
        let mut random = Random(seed(61));
        let mut seen = [0; 3];
        for _ in 0..cases(3000) {
            let digits = [4.0, 1e6, 1e15][(random.unit() * 3.0) as usize];
            let mut number = || (random.between(-1.0, 1.0) * digits).round() / digits * 3.0;
            let mut terms: Vec<[f64; 2]> = (0..4).map(|_| [number(), number()]).collect();
            let sum: f64 = terms.iter().map(|[a, b]| a * b).sum();
            terms.push([-1.0, sum]);
            let exact = terms.iter().fold(Exact::new(0.0), |sum, &[a, b]| {
                sum.plus(&Exact::new(a).times(&Exact::new(b)))
            });
            let zero = Exact::new(0.0);
            let expected = match (exact.at_most(&zero), zero.at_most(&exact)) {
                (true, true) => Equal,
                (true, false) => Less,
                _ => Greater,
            };
            assert_eq!(sign_of_products(terms.iter().copied()), expected, "{terms:?}");
            seen[(expected as i8 + 1) as usize] += 1;
        }
        assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
    }
}
