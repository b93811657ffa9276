//! The exact sign of a sum of products of doubles.

use std::cmp::Ordering;

/// The exponent of the last bit of a product: both factors are multiples of `2⁻¹⁰⁷⁴`.
const LAST: i32 = -2148;

/// The words of a sum. A product is below `2²⁰⁴⁸`, so that `2048 + 2148` bits hold one, and 68 words
/// hold the sum of `2¹⁵⁵` with its sign.
const WORDS: usize = 68;

/// Returns how `Σ aᵢ bᵢ` compares with 0, in exact arithmetic; `None` if a number is not finite.
///
/// The sum is an integer in units of `2⁻²¹⁴⁸`, in two's complement.
pub(crate) fn sign(products: impl IntoIterator<Item = (f64, f64)>) -> Option<Ordering> {
    let mut sum = [0_u64; WORDS];
    for (a, b) in products {
        if !(a.is_finite() && b.is_finite()) {
            return None;
        }
        let [(m, e), (n, f)] = [a, b].map(parts);
        let place = (e + f - LAST) as usize;
        let (word, shift) = (place / 64, place % 64);
        // 106 bits, shifted by up to 63, are in three words.
        let product = u128::from(m) * u128::from(n);
        let low = product << shift;
        let high = if shift == 0 { 0 } else { (product >> (128 - shift)) as u64 };
        let words = [low as u64, (low >> 64) as u64, high];
        if a.is_sign_negative() == b.is_sign_negative() {
            add(&mut sum[word..], words);
        } else {
            subtract(&mut sum[word..], words);
        }
    }
    let is_negative = sum[WORDS - 1] >> 63 == 1;
    let is_zero = sum.iter().all(|word| *word == 0);
    Some(match (is_zero, is_negative) {
        (true, _) => Ordering::Equal,
        (_, true) => Ordering::Less,
        (_, false) => Ordering::Greater,
    })
}

/// Returns `m` and `e` with `|x| = m 2ᵉ`.
fn parts(x: f64) -> (u64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) }
}

fn add(sum: &mut [u64], words: [u64; 3]) {
    let mut carry = false;
    for (i, word) in sum.iter_mut().enumerate() {
        if i >= 3 && !carry {
            return;
        }
        let (once, over) = word.overflowing_add(words.get(i).copied().unwrap_or(0));
        let (twice, again) = once.overflowing_add(u64::from(carry));
        (*word, carry) = (twice, over || again);
    }
}

fn subtract(sum: &mut [u64], words: [u64; 3]) {
    let mut borrow = false;
    for (i, word) in sum.iter_mut().enumerate() {
        if i >= 3 && !borrow {
            return;
        }
        let (once, under) = word.overflowing_sub(words.get(i).copied().unwrap_or(0));
        let (twice, again) = once.overflowing_sub(u64::from(borrow));
        (*word, borrow) = (twice, under || again);
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use tautline_chance::{Random, seed};

    use super::sign;
    use crate::numerics::exact::Exact;

    #[test]
    fn signs_by_hand() {
        let (tiny, huge) = (5e-324, f64::MAX);
        let one = 1.0_f64.next_up();
        for (products, expected) in [
            (vec![], Ordering::Equal),
            (vec![(0.0, -1.0)], Ordering::Equal),
            (vec![(2.0, 3.0), (-6.0, 1.0)], Ordering::Equal),
            (vec![(tiny, tiny)], Ordering::Greater),
            (vec![(tiny, -tiny)], Ordering::Less),
            (vec![(huge, huge), (huge, -huge), (-tiny, tiny)], Ordering::Less),
            (vec![(-huge, huge), (huge, huge), (-tiny, -tiny)], Ordering::Greater),
            (vec![(huge, huge); 9], Ordering::Greater),
            (vec![(huge, -huge); 9], Ordering::Less),
            // (1 + 2⁻⁵²)² = 1 + 2⁻⁵¹ + 2⁻¹⁰⁴, whose last term no double of this size has.
            (vec![(one, one), (-1.0, 1.0 + 2.0 * f64::EPSILON)], Ordering::Greater),
            (vec![(one, -one), (1.0, 1.0 + 2.0 * f64::EPSILON)], Ordering::Less),
        ] {
            assert_eq!(sign(products.iter().copied()), Some(expected), "{products:?}");
        }
        assert_eq!(sign([(f64::NAN, 0.0)]), None);
        assert_eq!(sign([(0.0, f64::INFINITY)]), None);
    }

    /// Sums that nearly vanish, compared with long numbers.
    #[test]
    fn signs_of_random_sums_agree_with_long_numbers() {
        let mut random = Random(seed(1));
        let mut seen = [0; 3];
        for case in 0..3000 {
            let mut number = || {
                let size = random.between(-60.0, 60.0).round();
                // Few bits, so that sums vanish now and then.
                (random.between(-4.0, 4.0).round()) * size.exp2()
            };
            let mut products: Vec<(f64, f64)> = (0..4).map(|_| (number(), number())).collect();
            if case % 2 == 0 {
                let negated: Vec<_> = products.iter().map(|(a, b)| (-b, *a)).collect();
                products.extend(negated);
                if case % 4 == 0 {
                    products.push((number() * f64::EPSILON, number()));
                }
            }
            let sum = products.iter().fold(Exact::new(0.0), |sum, (a, b)| {
                sum.plus(&Exact::new(*a).times(&Exact::new(*b)))
            });
            let zero = Exact::new(0.0);
            let expected = match (sum.at_most(&zero), zero.at_most(&sum)) {
                (true, true) => Ordering::Equal,
                (true, false) => Ordering::Less,
                _ => Ordering::Greater,
            };
            assert_eq!(sign(products.iter().copied()), Some(expected), "{products:?}");
            seen[(expected as i8 + 1) as usize] += 1;
        }
        assert!(seen.iter().all(|count| *count > 100), "{seen:?}");
    }
}
