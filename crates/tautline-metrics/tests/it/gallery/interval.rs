//! Interval arithmetic, as far as needed to prove an inequality on a box by bisection.
//!
//! Ends are rounded to nearest, not outward: a result may be off by some twenty roundings of
//! numbers below 1000, which is below 1e-11. [`below`] asks for a margin of 1e-9.

use std::{
    f64::consts::{FRAC_PI_2, PI},
    ops::{Add, Mul, Sub},
};

/// The numbers from `low` to `high`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Interval {
    pub(crate) fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    pub(crate) fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    pub(crate) fn sqr(self) -> Self {
        let (a, b) = (self.low * self.low, self.high * self.high);
        let low = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { a.min(b) };
        Self::new(low, a.max(b))
    }

    pub(crate) fn exp(self) -> Self {
        Self::new(self.low.exp(), self.high.exp())
    }

    pub(crate) fn cos(self) -> Self {
        let (a, b) = (self.low.cos(), self.high.cos());
        // Extreme at the multiples of π inside.
        let inside: Vec<i64> =
            ((self.low / PI).ceil() as i64..=(self.high / PI).floor() as i64).collect();
        let some = |parity: i64| inside.iter().any(|n| n.rem_euclid(2) == parity);
        Self::new(if some(1) { -1.0 } else { a.min(b) }, if some(0) { 1.0 } else { a.max(b) })
    }

    pub(crate) fn sin(self) -> Self {
        Self::new(self.low - FRAC_PI_2, self.high - FRAC_PI_2).cos()
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.low - other.high, self.high - other.low)
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let products = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        let low = products.into_iter().fold(f64::INFINITY, f64::min);
        Self::new(low, products.into_iter().fold(f64::NEG_INFINITY, f64::max))
    }
}

impl Add<f64> for Interval {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        Self::new(self.low + other, self.high + other)
    }
}

impl Mul<f64> for Interval {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        self * Self::point(other)
    }
}

/// Whether `f ≤ bound` on the whole box: bisects its longest side until the interval of `f` on
/// each part is below the bound. `false` if a part of side 1e-3 is not.
pub(crate) fn below<const K: usize>(
    whole: [Interval; K],
    bound: f64,
    f: impl Fn([Interval; K]) -> Interval,
) -> bool {
    let mut parts = vec![whole];
    while let Some(part) = parts.pop() {
        if f(part).high <= bound - 1e-9 {
            continue;
        }
        let side = |i: usize| part[i].high - part[i].low;
        let longest = (0..K).fold(0, |best, i| if side(i) > side(best) { i } else { best });
        if side(longest) < 1e-3 {
            return false;
        }
        let Interval { low, high } = part[longest];
        let middle = 0.5 * (low + high);
        for half in [Interval::new(low, middle), Interval::new(middle, high)] {
            let mut halved = part;
            halved[longest] = half;
            parts.push(halved);
        }
    }
    true
}

#[test]
fn intervals_contain_their_functions() {
    for (low, high) in [(-0.3, 0.4), (0.1, 3.3), (-4.0, -3.0), (1.0, 1.5), (3.0, 9.9)] {
        let i = Interval::new(low, high);
        for step in 0..=100 {
            let x = (low + (high - low) * f64::from(step) / 100.0).min(high);
            let holds = |i: Interval, y: f64| assert!(i.low <= y && y <= i.high, "{i:?} {y}");
            holds(i.sqr(), x * x);
            holds(i.cos(), x.cos());
            // The shift by π/2 is rounded.
            assert!(i.sin().low <= x.sin() + 1e-15 && x.sin() <= i.sin().high + 1e-15);
            holds(i.exp() * i - i.sqr() + 1.0, x.exp() * x - x * x + 1.0);
        }
    }
    assert!(Interval::new(-0.3, 0.4).sqr().low == 0.0);
    assert!(
        Interval::new(0.1, 3.3).cos().low == -1.0 && Interval::new(-4.0, 1.0).cos().high == 1.0
    );
}

/// `x (1 − x) ≤ 1/4`, and no less.
#[test]
fn bisection_proves_what_is_true() {
    let f = |[x]: [Interval; 1]| x * (Interval::point(1.0) - x);
    assert!(below([Interval::new(0.0, 1.0)], 0.26, f));
    assert!(!below([Interval::new(0.0, 1.0)], 0.249, f));
}
