//! Proved bounds hold to the last digit: distances that are known exactly.

use tautline::{Ends, Formula, Problem, Rule, certify::Accuracy};

/// A sequence of pseudorandom numbers (Knuth's MMIX).
struct Draws(u64);

impl Draws {
    /// Returns a whole number from `-most` to `most`.
    fn whole(&mut self, most: i64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 33) as i64 % (2 * most + 1) - most
    }
}

/// Numbers are multiples of this, so that all of them, and their products, are whole numbers in
/// units: coordinates of 24 bits and entries of 26 have a sum of products of fewer than 127.
const UNIT: f64 = 1.0 / (1 << 24) as f64;

/// Returns whether `x ≤ n`, exactly.
fn at_most(x: f64, n: i128) -> bool {
    x.ceil() as i128 <= n
}

/// Returns whether `x ≥ n`, exactly.
fn at_least(x: f64, n: i128) -> bool {
    x.floor() as i128 >= n
}

/// Under a constant metric `d²` is `dᵀHd`.
fn check<const D: usize>(rule: Rule, draws: &mut Draws) {
    let most = 1 << 24;
    // Diagonally dominant, hence positive definite.
    let mut h = [[0_i64; D]; D];
    for i in 0..D {
        for j in i..D {
            h[i][j] = if i == j { (3 << 24) + draws.whole(most) } else { draws.whole(most) / 2 };
        }
    }
    let entry = |i: usize, j: usize| format!("{:?}", h[i.min(j)][i.max(j)] as f64 * UNIT);
    let row = |i: usize| (0..D).map(|j| entry(i, j)).collect::<Vec<_>>().join(", ");
    let matrix = format!("[{}]", (0..D).map(row).collect::<Vec<_>>().join("; "));
    let [a, b] = [(); 2].map(|()| std::array::from_fn::<_, D, _>(|_| draws.whole(most)));
    let mut square = 0_i128;
    for i in 0..D {
        for j in 0..D {
            let product = i128::from(b[i] - a[i]) * i128::from(b[j] - a[j]);
            square += i128::from(h[i.min(j)][i.max(j)]) * product;
        }
    }
    let n = 1 + (draws.whole(7) + 7) as usize;
    let point = |x: [i64; D]| x.map(|x| x as f64 * UNIT);
    let ends = Ends::points(point(a), point(b)).expect("finite");
    let metric = Formula::<D>::parse(&matrix, &[]).expect(&matrix);
    let line = Problem::new(metric, ends).solve(rule, n).expect("solved");
    let proved = line.prove(Accuracy::default()).expect("proved").enclosure;
    let [lower, upper] = [proved.lower, proved.upper].map(|bound| bound / UNIT / UNIT / UNIT);
    assert!(at_most(lower, square), "{matrix} {a:?} {b:?} {n}: {lower:?} above {square}");
    assert!(at_least(upper, square), "{matrix} {a:?} {b:?} {n}: {upper:?} below {square}");
    // Nothing but rounding is lost.
    assert!(proved.width() <= 1e-12 * proved.upper, "{proved:?}");
}

#[test]
fn constant_metrics_are_bounded_to_the_last_digit() {
    let mut draws = Draws(5);
    for _ in 0..100 {
        check::<1>(Rule::TRAPEZOIDAL, &mut draws);
        check::<2>(Rule::TRAPEZOIDAL, &mut draws);
        check::<3>(Rule::TRAPEZOIDAL, &mut draws);
        check::<4>(Rule::TRAPEZOIDAL, &mut draws);
        check::<2>(Rule::LEFT_ENDPOINT, &mut draws);
    }
}
