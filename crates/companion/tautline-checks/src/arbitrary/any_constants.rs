//! `AnyConstants`: random constants of a metric.

use quickcheck::{Arbitrary, Gen};
use tautline::Constants;

/// Constants that are small integers, so that sums and products of a few of them are exact.
///
/// `c₁` is from 1 to 8; `c₂ − c₁`, `L_H` and `M_H` are from 0 to 15; one case in four lacks `M_H`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnyConstants {
    c1: u8,
    above: u8,
    l_h: u8,
    m_h: u8,
}

impl AnyConstants {
    fn of((c1, above, l_h, m_h): (u8, u8, u8, u8)) -> Self {
        Self { c1, above, l_h, m_h }
    }

    /// Returns the constants.
    #[must_use]
    pub fn constants(&self) -> Constants {
        let c1 = f64::from(self.c1 % 8) + 1.0;
        let [above, l_h, m_h] = [self.above, self.l_h, self.m_h].map(|k| f64::from(k % 16));
        let constants = Constants::new(c1, c1 + above, l_h).expect("in order");
        if self.m_h < 192 { constants.with_m_h(m_h).expect("not negative") } else { constants }
    }
}

impl Arbitrary for AnyConstants {
    fn arbitrary(g: &mut Gen) -> Self {
        Self::of(Arbitrary::arbitrary(g))
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new((self.c1, self.above, self.l_h, self.m_h).shrink().map(Self::of))
    }
}

#[cfg(test)]
mod tests {
    use tautline::Constants;

    use super::{super::holds, AnyConstants};

    fn plus(a: Constants, b: Constants) -> Constants {
        a.plus(b).expect("finite")
    }

    fn times(a: Constants, b: Constants) -> Constants {
        a.conformal(b).expect("finite")
    }

    fn back(a: Constants, smin: u8, smax: u8) -> Constants {
        let smin = f64::from(smin % 4) + 1.0;
        a.pulled_back(smin, smin + f64::from(smax % 4)).expect("finite")
    }

    fn scaled(a: Constants, s: u8) -> Constants {
        a.scaled(f64::from(s) + 1.0).expect("finite")
    }

    /// Sums, products with a function, and products of spaces commute and associate.
    #[test]
    fn sums_and_products_commute_and_associate() {
        fn law(a: AnyConstants, b: AnyConstants, c: AnyConstants) -> bool {
            let [a, b, c] = [a, b, c].map(|any| any.constants());
            let beside = Constants::beside;
            [plus as fn(_, _) -> _, times, beside]
                .iter()
                .all(|of| of(a, b) == of(b, a) && of(of(a, b), c) == of(a, of(b, c)))
        }
        holds(751, 1000, law as fn(AnyConstants, AnyConstants, AnyConstants) -> bool);
    }

    /// The laws are `s (H + H′) = s H + s H′`, `Aᵀ (H + H′) A = Aᵀ H A + Aᵀ H′ A` and
    /// `φ (H + H′) = φ H + φ H′`; the first two also hold for products of spaces.
    #[test]
    fn factors_and_pullbacks_distribute() {
        fn law(a: AnyConstants, b: AnyConstants, factor: AnyConstants, s: u8, t: u8) -> bool {
            let [a, b, factor] = [a, b, factor].map(|any| any.constants());
            let beside = a.beside(b);
            scaled(plus(a, b), s) == plus(scaled(a, s), scaled(b, s))
                && back(plus(a, b), s, t) == plus(back(a, s, t), back(b, s, t))
                && times(plus(a, b), factor) == plus(times(a, factor), times(b, factor))
                && scaled(beside, s) == scaled(a, s).beside(scaled(b, s))
                && back(beside, s, t) == back(a, s, t).beside(back(b, s, t))
        }
        holds(752, 1000, law as fn(AnyConstants, AnyConstants, AnyConstants, u8, u8) -> bool);
    }

    /// The laws are `s (t H) = (s t) H`, `Bᵀ Aᵀ H A B = (A B)ᵀ H (A B)`, and `s H = φ H` with
    /// `φ = s`; moreover, `s² H` is the pullback by `s`, which also divides lengths by `s`.
    #[test]
    fn factors_and_pullbacks_compose() {
        fn law(a: AnyConstants, s: u8, t: u8) -> bool {
            let a = a.constants();
            let (x, y) = (f64::from(s % 8) + 1.0, f64::from(t % 8) + 1.0);
            let twice = a.pulled_back(x, y).and_then(|a| a.pulled_back(y, x * y));
            let isometry = a.pulled_back(x, x).expect("finite");
            let scaled = a.scaled(x * x).expect("finite");
            let factor = Constants::new(x, x, 0.0).and_then(|c| c.with_m_h(0.0)).expect("in order");
            x > y
                || twice == a.pulled_back(x * y, x * y * y)
                    && a.scaled(x).and_then(|a| a.scaled(y)) == a.scaled(x * y)
                    && a.scaled(x) == a.conformal(factor)
                    && (isometry.c1(), isometry.c2()) == (scaled.c1(), scaled.c2())
                    && isometry.l_h() == scaled.l_h() * x
                    && isometry.m_h() == scaled.m_h().map(|m_h| m_h * x * x)
        }
        holds(753, 1000, law as fn(AnyConstants, u8, u8) -> bool);
    }

    /// If the constants of the parts become weaker, the constants of the whole do not become
    /// stronger.
    #[test]
    fn every_rule_is_monotone() {
        fn weaker(a: Constants, by: u8) -> Constants {
            let by = f64::from(by % 4);
            let weaker = Constants::new(a.c1() / (1.0 + by), a.c2() + by, a.l_h() + by);
            let weaker = weaker.expect("in order");
            a.m_h().map_or(weaker, |m_h| weaker.with_m_h(m_h + by).expect("not negative"))
        }
        fn implies(a: Constants, b: Constants) -> bool {
            let m_h = a.m_h().zip(b.m_h()).is_none_or(|(a, b)| a <= b);
            a.c1() >= b.c1() && a.c2() <= b.c2() && a.l_h() <= b.l_h() && m_h
        }
        fn law(a: AnyConstants, b: AnyConstants, by: u8, s: u8, t: u8) -> bool {
            let [a, b] = [a, b].map(|any| any.constants());
            let c = weaker(a, by);
            implies(plus(a, b), plus(c, b))
                && implies(times(a, b), times(c, b))
                && implies(a.beside(b), c.beside(b))
                && implies(scaled(a, s), scaled(c, s))
                && implies(back(a, s, t), back(c, s, t))
                && implies(back(a, s, 0), back(a, s, t))
        }
        holds(754, 1000, law as fn(AnyConstants, AnyConstants, u8, u8, u8) -> bool);
    }
}
