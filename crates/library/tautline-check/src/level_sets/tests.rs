//! `f` for known bounds on gradients.

use tautline_chance::{Random, cases, seed};

use super::{BINS, Growth, LevelSets, least_sum, slope};

/// A bin, relative to the distance between the ends, with some room.
const BIN: f64 = 1.2 / BINS as f64;

fn level_sets(growths: &[(f64, f64, f64)], start: f64, end: f64) -> LevelSets {
    let growths = growths.iter().map(|&(low, high, q)| Growth { range: (low, high), q });
    LevelSets::new(growths, start, end)
}

/// Asserts that `f(1)` is at most, and nearly, this number.
fn assert_at_end(growths: &[(f64, f64, f64)], exact: f64) {
    let found = level_sets(growths, 0.0, 1.0).below(1.0);
    assert!(found <= exact && found >= exact - 4.0 * BIN, "{found} is not {exact}: {growths:?}");
}

/// A bound counts in all bins that its range meets, not in the middle one alone.
#[test]
fn a_bound_counts_on_its_whole_range() {
    assert_at_end(&[(0.0, 1.0, 4.0)], 0.5);
    assert_at_end(&[(0.25, 0.75, 4.0)], 0.75);
    assert_at_end(&[(0.2, 0.6, 4.0), (0.4, 0.7, 16.0)], 0.675);
}

#[test]
fn a_range_that_straddles_the_start_counts_from_there() {
    assert_at_end(&[(-1.0, 0.5, 4.0)], 0.75);
    assert_at_end(&[(-1.0, 1.5, 4.0)], 0.5);
    assert_at_end(&[(f64::NEG_INFINITY, f64::INFINITY, 4.0)], 0.5);
    // What lies below the start, or touches it, does not count.
    assert_at_end(&[(-1.0, 0.0, 1e9)], 1.0);
}

#[test]
fn slopes_are_at_most_one() {
    assert_at_end(&[(0.0, 1.0, 0.25)], 1.0);
    assert_at_end(&[(0.0, 1.0, 0.0)], 1.0);
    assert_at_end(&[], 1.0);
}

/// A missing bound costs its own range, and no more.
#[test]
fn where_no_bound_is_known_the_function_is_constant() {
    for unknown in [f64::INFINITY, f64::NAN] {
        assert_at_end(&[(0.0, 0.125, unknown), (0.0, 1.0, 1.0)], 0.875);
        assert_at_end(&[(0.25, 0.5, unknown), (0.75, 0.8, unknown), (0.0, 1.0, 4.0)], 0.35);
        assert_at_end(&[(f64::NEG_INFINITY, f64::INFINITY, unknown)], 0.0);
    }
}

#[test]
fn without_an_interval_of_levels_the_function_is_zero() {
    let ends = [0.0, 1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN];
    for start in ends {
        for end in ends {
            let f = level_sets(&[(-5.0, 5.0, 1.0)], start, end);
            for t in ends {
                let bound = f.below(t);
                let most = if t > start { t - start } else { 0.0 };
                assert!(bound >= 0.0 && bound <= most, "{start} {end} {t}: {bound}");
            }
            if !(end > start) {
                assert_eq!(f.below(1.0), 0.0);
            }
        }
    }
}

/// Beyond the last level nothing is extrapolated.
#[test]
fn beyond_the_last_level_the_function_is_constant() {
    let f = level_sets(&[], 0.0, 1.0);
    assert!(f.below(1.09) > 1.08);
    for t in [1.2, 100.0, f64::MAX, f64::INFINITY] {
        assert!(f.below(t) <= 1.1 + 1e-12 && f.below(t) >= 1.09);
    }
}

/// `f` rises between any two levels by at most the integral of the least slope that the bounds allow,
/// whatever the bins.
#[test]
fn the_function_rises_as_little_as_the_bounds_demand() {
    let mut random = Random(seed(21));
    for _ in 0..cases(200) {
        let growths: Vec<(f64, f64, f64)> = (0..8)
            .map(|_| {
                let low = random.between(-0.5, 1.2);
                let high = low + random.unit().powi(3);
                (low, high, 10.0_f64.powf(random.between(-2.0, 3.0)))
            })
            .collect();
        let (start, end) = (random.between(-0.2, 0.3), random.between(0.4, 1.5));
        let f = level_sets(&growths, start, end);
        let slope = |t: f64| {
            let q = growths.iter().filter(|g| g.0 < t && t < g.1).fold(1.0, |q: f64, g| q.max(g.2));
            if t < start { 0.0 } else { 1.0 / q.sqrt() }
        };
        let (mut a, mut b) = (random.between(-0.6, 1.6), random.between(-0.6, 1.6));
        (a, b) = (a.min(b), a.max(b));
        let mut breaks: Vec<f64> = growths.iter().flat_map(|g| [g.0, g.1]).collect();
        breaks.extend([a, b, start]);
        breaks.retain(|t| (a..=b).contains(t));
        breaks.sort_by(f64::total_cmp);
        let most: f64 = breaks.windows(2).map(|w| (w[1] - w[0]) * slope(0.5 * (w[0] + w[1]))).sum();
        // Values are rounded down by some 4096 roundings.
        let rise = f.below(b) - f.below(a);
        assert!(rise <= most + 1e-11, "{rise} > {most}: {growths:?} {start} {end} {a} {b}");
        assert!(f.excess_above(b) >= f.excess_above(a) - 1e-11);
        assert!(f.excess_above(b) >= b - f.below(b));
    }
}

/// With slopes of one half, `f(φ) + g(ψ)` is `1/2` wherever `φ + ψ = 1`. The sum without the excess,
/// or with the excess at the least values, would be 1.
#[test]
fn the_sum_counts_the_excess_at_the_greatest_values() {
    let half = || level_sets(&[(-1.0, 2.0, 4.0)], 0.0, 1.0);
    let (f, g) = (half(), half());
    let found = least_sum([&f, &g], [(0.0, 1.0), (0.0, 1.0)], 1.0);
    assert!(found <= 0.5, "{found}");
    // On a small simplex the sum is sharp, and better than the two functions apart.
    let found = least_sum([&f, &g], [(0.4, 0.45), (0.55, 0.6)], 1.0);
    assert!((0.45 - 1e-9..=0.5).contains(&found), "{found}");
    let whole = || level_sets(&[(-1.0, 2.0, 1.0)], 0.0, 1.0);
    let found = least_sum([&whole(), &whole()], [(0.0, 1.0), (0.0, 1.0)], 1.0);
    assert!((0.999_999..=1.0).contains(&found), "{found}");
}

/// A range without an end makes the excess unknown, which is no bound.
#[test]
fn an_unknown_sum_leaves_the_bound_of_the_two_functions_apart() {
    let f = level_sets(&[], 0.0, 1.0);
    let apart = f.below(0.25) + f.below(0.5);
    for (high, sum) in [(f64::INFINITY, 1.0), (1.0, f64::NEG_INFINITY), (1.0, f64::NAN)] {
        let found = least_sum([&f, &f], [(0.25, high), (0.5, high)], sum);
        assert!(found <= apart && found >= apart - 1e-12, "{found}");
    }
}

/// `s² q ≤ 1`, with the product exactly: `s² = t + r`, and so on.
#[test]
fn slopes_are_rounded_down() {
    for q in (2..2000).map(f64::from) {
        let s = slope(q);
        let square = s * s;
        let rest = s.mul_add(s, -square);
        assert!(q.mul_add(square, -1.0) + q * rest <= 0.0, "{q}");
        assert!(q * square > 1.0 - 1e-15, "{q}");
    }
}

/// Returns a number in units of `2⁻¹¹⁰`, exactly.
fn units(x: f64) -> i128 {
    let bits = x.abs().to_bits();
    let biased = (bits >> 52) as i32;
    let mantissa = i128::from(bits & ((1 << 52) - 1)) | if biased > 0 { 1 << 52 } else { 0 };
    let shift = biased.max(1) - 1075 + 110;
    let size = if mantissa == 0 {
        0
    } else if shift >= 0 {
        mantissa << shift
    } else {
        assert!(mantissa.trailing_zeros() as i32 >= -shift, "{x:e} is too small");
        mantissa >> -shift
    };
    if x < 0.0 { -size } else { size }
}

/// Where all slopes are 1, `f(t)` is `t − t₀`, exactly. Two kinds of bins make two pieces of `f`. Every
/// bound is on its side of the exact number, and close to it.
#[test]
fn heights_and_sums_are_rounded_to_their_sides() {
    let mut random = Random(seed(22));
    for _ in 0..cases(400) {
        let start = random.between(0.05, 0.4);
        let end = random.between(0.6, 2.0);
        let middle = random.between(start, end);
        // The bounds 0 and 1 both allow the slope 1.
        let f = level_sets(&[(middle, 9.0, 1.0)], start, end);
        let last = f.levels[f.levels.len() - 1];
        let t = random.between(start, end);
        for t in [t, end, last.next_up(), 2.5] {
            let exact = units(t.min(last)) - units(start);
            let found = f.below(t);
            assert!(units(found) <= exact && found >= t.min(last) - start - 1e-12, "{found} {t}");
            let excess = f.excess_above(t);
            assert!(units(excess) >= units(t) - units(found), "{excess} {t} {found}");
            assert!(excess <= t - found + 2e-15, "{excess} {t} {found}");
        }
        let g = level_sets(&[], 0.5 * start, end);
        let (u, v) = (random.between(start, end), random.between(start, end));
        let apart = least_sum([&f, &g], [(u, 1.0), (v, 1.0)], f64::NEG_INFINITY);
        assert!(units(apart) <= units(f.below(u)) + units(g.below(v)), "{apart}");
        assert!(apart >= f.below(u) + g.below(v) - 1e-15, "{apart}");
        // The least values are below both starts, so that only the sum counts.
        let sum = random.between(2.5, 3.0);
        let together = least_sum([&f, &g], [(0.0, u), (0.0, v)], sum);
        let exact = units(sum) - units(f.excess_above(u)) - units(g.excess_above(v));
        assert!(units(together) <= exact, "{together}");
        assert!(together >= sum - f.excess_above(u) - g.excess_above(v) - 1e-14, "{together}");
    }
}

/// With the slope `1/√q`, `q f(t)²` is at most `(t − t₀)²`: the numbers are small, so that their squares
/// are exact in 128 bits.
#[test]
fn heights_with_irrational_slopes_are_rounded_down() {
    for q in [2.0, 3.0, 5.0, 7.0, 11.0, 1.75, 2.625] {
        let f = level_sets(&[(-1.0, 9.0, q)], 0.0, 1.0);
        for k in 1..64 {
            let t = f64::from(k) / 64.0;
            let found = f.below(t);
            // q f² − t² with one rounding of q f² + …: the square is s + r.
            let square = found * found;
            let rest = found.mul_add(found, -square);
            assert!(q.mul_add(square, -(t * t)) + q * rest <= 0.0, "{q} {t} {found}");
            assert!(q * square >= t * t * (1.0 - 1e-12), "{q} {t} {found}");
        }
    }
}
