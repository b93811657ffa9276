//! `AnySetting`: random constants with a distance, a dimension and `N`.

use std::num::NonZeroUsize;

use quickcheck::{Arbitrary, Gen};
use tautline::{Constants, bounds::Setting};

/// A setting of Theorem 1.1, with a number `N` of subintervals.
///
/// `c₁` is from 1/8 to 8, `c₂/c₁` from 1 to 33, `L_H` and `d` from 0 to 16, `D` from 1 to 6, and
/// `N` from 1 to 256.
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
    /// Returns the setting given by six integers, in the order of the fields.
    #[must_use]
    pub fn of((c1, ratio, l_h, distance, dimension, n): (u8, u8, u8, u8, u8, u8)) -> Self {
        Self { c1, ratio, l_h, distance, dimension, n }
    }

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

#[cfg(test)]
mod tests {
    use tautline::bounds::{Setting, c_tra_g, c_tra_sharp_g, k1_g, k2_g, theorem_1_1_constant};
    use tautline_statements::Units;

    use super::{super::holds, AnySetting};

    /// Every bound increases with `d`, `c₂` and `L_H` and decreases with `c₁`, as the documentation
    /// of [`Setting`] says. Twice the distance represents any upper bound on it.
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
            // Multiplying by powers of two does not round, and products and sums of nonnegative
            // numbers are monotone in f64.
            larger.iter().all(|&larger| {
                k1_g(setting) <= k1_g(larger)
                    && k2_g(setting) <= k2_g(larger)
                    && c_tra_g(setting, n) <= c_tra_g(larger, n)
                    && theorem_1_1_constant(setting) <= theorem_1_1_constant(larger)
            })
        }
        holds(771, 500, law as fn(AnySetting) -> bool);
    }

    /// `K_{1,g}` and `K_{2,g}` scale as `ℓ`, the others as `m²`.
    #[test]
    fn bounds_scale_by_their_units() {
        fn law(any: AnySetting, ell: i8, m: i8) -> bool {
            let units =
                Units { ell: 2_f64.powi(i32::from(ell % 8)), m: 2_f64.powi(i32::from(m % 8)) };
            let (setting, n) = (any.setting(), any.n());
            let constants = units.constants(setting.constants()).expect("in range");
            let there = Setting::new(constants, setting.distance() * units.m, setting.dimension());
            let there = there.expect("a distance");
            let energy = units.m * units.m;
            // Scaling the units does not round, but long products multiply their factors in the
            // order of size, which gives two dozen different roundings.
            let scales = |there: f64, expected: f64| (there - expected).abs() <= 1e-14 * expected;
            scales(k1_g(there), units.ell * k1_g(setting))
                && scales(k2_g(there), units.ell * k2_g(setting))
                && scales(c_tra_g(there, n), energy * c_tra_g(setting, n))
                && scales(theorem_1_1_constant(there), energy * theorem_1_1_constant(setting))
        }
        holds(772, 500, law as fn(AnySetting, i8, i8) -> bool);
    }

    /// The test compares with `C_tra♯ = d² (δ + 3D²δ² + 6κD²δ + 9κD⁴δ²)`, where
    /// `δ = L_H d/c₁^{3/2}` and `κ = c₂/c₁`.
    #[test]
    fn c_tra_sharp_depends_on_two_pure_numbers() {
        fn law(any: AnySetting) -> bool {
            let setting = any.setting();
            let constants = setting.constants();
            let d2 = setting.distance().powi(2);
            let delta = constants.l_h() * setting.distance() / constants.c1().powf(1.5);
            let kappa = constants.c2() / constants.c1();
            let square = (setting.dimension() as f64).powi(2);
            let bend = square * delta;
            let expected =
                d2 * (delta + 3.0 * bend * delta + 6.0 * kappa * bend + 9.0 * kappa * bend * bend);
            // Both sides are sums of nonnegative terms with two dozen roundings each.
            (c_tra_sharp_g(setting) - expected).abs() <= 1e-14 * expected
        }
        holds(773, 500, law as fn(AnySetting) -> bool);
    }
}
