//! `AnySetting`: constants, a distance, a dimension and `N`.

use std::num::NonZeroUsize;

use quickcheck::{Arbitrary, Gen};
use tautline::{Constants, bounds::Setting};

/// A setting of Theorem 1.1, with a number `N` of subintervals.
///
/// `c₁` from 1/8 to 8, `c₂/c₁` from 1 to 33, `L_H` and `d` from 0 to 16, `D` from 1 to 6 and `N` from
/// 1 to 256.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnySetting {
    c1: u8,
    ratio: u8,
    l_h: u8,
    distance: u8,
    dimension: u8,
    n: u8,
}

impl AnySetting {
    /// Returns the constants of the metric.
    #[must_use]
    pub fn constants(&self) -> Constants {
        let c1 = 2_f64.powi(i32::from(self.c1 % 7) - 3);
        let c2 = c1 * (1.0 + f64::from(self.ratio) / 8.0);
        Constants::new(c1, c2, f64::from(self.l_h) / 16.0).expect("in order")
    }

    /// Returns the setting.
    #[must_use]
    pub fn setting(&self) -> Setting {
        let dimension = usize::from(self.dimension % 6) + 1;
        Setting::new(self.constants(), f64::from(self.distance) / 16.0, dimension)
            .expect("a distance and a dimension")
    }

    /// Returns the number of subintervals.
    #[must_use]
    pub fn n(&self) -> NonZeroUsize {
        NonZeroUsize::MIN.saturating_add(usize::from(self.n))
    }
}

impl Arbitrary for AnySetting {
    fn arbitrary(g: &mut Gen) -> Self {
        Self::of(Arbitrary::arbitrary(g))
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let all = (self.c1, self.ratio, self.l_h, self.distance, self.dimension, self.n);
        Box::new(all.shrink().map(Self::of))
    }
}

impl AnySetting {
    fn of((c1, ratio, l_h, distance, dimension, n): (u8, u8, u8, u8, u8, u8)) -> Self {
        Self { c1, ratio, l_h, distance, dimension, n }
    }
}

#[cfg(test)]
mod tests {
    use quickcheck::{Gen, QuickCheck};
    use tautline::bounds::{Setting, c_tra_g, k1_g, k2_g, theorem_1_1_constant};

    use super::AnySetting;

    /// Every bound grows with `d`, `c₂` and `L_H` and falls with `c₁`, as [`Setting`] says; twice the
    /// distance stands for all upper bounds of it.
    #[test]
    fn bounds_are_monotone_in_the_setting() {
        fn law(any: AnySetting) -> bool {
            let (setting, n) = (any.setting(), any.n());
            let constants = setting.constants();
            let other = |c1, c2, l_h, distance| {
                let constants = tautline::Constants::new(c1, c2, l_h).expect("in order");
                Setting::new(constants, distance, setting.dimension()).expect("a distance")
            };
            let (c1, c2) = (constants.c1(), constants.c2());
            let (l_h, d) = (constants.l_h(), setting.distance());
            let larger = [
                other(0.5 * c1, c2, l_h, d),
                other(c1, 2.0 * c2, l_h, d),
                other(c1, c2, 2.0 * l_h, d),
                other(c1, c2, l_h, 2.0 * d),
            ];
            // Powers of two round nothing, and products and sums of nonnegative numbers are
            // monotone in f64.
            larger.iter().all(|&larger| {
                k1_g(setting) <= k1_g(larger)
                    && k2_g(setting) <= k2_g(larger)
                    && c_tra_g(setting, n) <= c_tra_g(larger, n)
                    && theorem_1_1_constant(setting) <= theorem_1_1_constant(larger)
            })
        }
        let source = Gen::from_size_and_seed(24, 771);
        QuickCheck::new().rng(source).tests(500).quickcheck(law as fn(AnySetting) -> bool);
    }
}
