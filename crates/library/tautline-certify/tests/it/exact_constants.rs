//! Exactly known constants: the bounds contain them, up to the last rounding.

use tautline_certify::{Accuracy, Cell, CertifiedConstants, CertifyError, Domain};

use crate::parsed;

/// For `(100 + a · x) I` the square of `L_H = |a|` is an integer, and every other root rounds down.
/// On the unit cube `c₁` and `c₂` are integers, attained at two corners.
#[test]
fn the_slope_of_an_incline_is_enclosed_to_the_last_digit() -> Result<(), CertifyError> {
    let cube = Domain::cell(Cell::new([0.0; 3], [1.0; 3])?);
    let accuracy = Accuracy { tolerance: 1e-9, budget: 10_000 };
    for (a, b, c) in (0..64).map(|k| (k % 4, k / 4 % 4, k / 16)) {
        let incline = parsed::<3>(&format!("x1*{a} + x2*{b} - x3*{c} + 100 I"));
        let proved = CertifiedConstants::new(&incline, &cube, accuracy)?;
        let square = f64::from(a * a + b * b + c * c);
        // The difference is rounded once, which keeps its sign.
        let beyond = |x: f64| x.mul_add(x, -square);
        let l_h = proved.l_h();
        assert!(beyond(l_h.lower) <= 0.0 && beyond(l_h.upper) >= 0.0, "{square}: {l_h:?}");
        assert!(l_h.upper - l_h.lower <= 1e-12, "{l_h:?}");
        let (least, most) = (100.0 - f64::from(c), 100.0 + f64::from(a + b));
        assert!(proved.c1().contains(least) && proved.c2().contains(most), "{proved:?}");
        assert_eq!(proved.m_h().map(|m_h| m_h.upper), Some(0.0));
        let constants = proved.constants()?;
        assert!(beyond(constants.l_h()) >= 0.0 && constants.is_local() && constants.is_isotropic());
    }
    Ok(())
}

/// `[[a, b + x y], [b + x y, a]]` has the eigenvalues `a ± (b + x y)`. Its derivatives satisfy
/// `|DH|² = x² + y²`, and `D²H[v, v] = 2 v₁v₂`, which is at most 1.
#[test]
fn the_constants_of_a_twist_are_enclosed_to_the_last_digit() -> Result<(), CertifyError> {
    let cell = Domain::cell(Cell::new([0.0; 2], [1.0, 2.0])?);
    let accuracy = Accuracy { tolerance: 1e-6, budget: 100_000 };
    for (a, b) in [(8.0, 1.0), (7.0, -1.0), (1e3, 3.0), (5.5, 0.25)] {
        let twisted = parsed::<2>(&format!("off = x1*x2 + {b}; [{a}, off; off, {a}]"));
        let proved = CertifiedConstants::new(&twisted, &cell, accuracy)?;
        let off = f64::abs(b).max(b + 2.0);
        assert!(proved.c1().contains(a - off) && proved.c2().contains(a + off), "{proved:?}");
        let l_h = proved.l_h();
        assert!(l_h.upper.mul_add(l_h.upper, -5.0) >= 0.0, "{l_h:?}");
        assert!(l_h.lower.mul_add(l_h.lower, -5.0) <= 0.0, "{l_h:?}");
        assert!(proved.m_h().is_some_and(|m_h| m_h.contains(1.0)), "{:?}", proved.m_h());
    }
    Ok(())
}
