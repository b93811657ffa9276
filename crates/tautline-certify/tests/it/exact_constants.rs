//! Constants that are known exactly: not even by a rounding do the bounds leave them out.

use nalgebra::{SMatrix, SVector};
use tautline_certify::{Accuracy, Cell, CertifiedConstants, CertifyError, Domain};
use tautline_metrics::Metric;
use tautline_scalar::Scalar;

/// `(100 + a · x) I`.
struct Incline([f64; 3]);

impl Metric<3> for Incline {
    fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        let Incline(a) = self;
        SMatrix::from_diagonal_element(x[0] * a[0] + x[1] * a[1] + x[2] * a[2] + 100.0)
    }
}

/// `L_H = |a|` has an integer for its square, and every other root is rounded down to nearest. On
/// the unit cube `c₁` and `c₂` are at two corners, and integers.
#[test]
fn the_slope_of_an_incline_is_enclosed_to_the_last_digit() -> Result<(), CertifyError> {
    let cube = Domain::cell(Cell::new([0.0; 3], [1.0; 3])?);
    let accuracy = Accuracy { tolerance: 1e-9, budget: 10_000 };
    for (a, b, c) in (0..64).map(|k| (k % 4, k / 4 % 4, k / 16)) {
        let slopes = [a, b, -c].map(f64::from);
        let proved = CertifiedConstants::new(&Incline(slopes), &cube, accuracy)?;
        let square = f64::from(a * a + b * b + c * c);
        // One rounding at the end, which keeps the sign.
        let beyond = |x: f64| x.mul_add(x, -square);
        let l_h = proved.l_h();
        assert!(beyond(l_h.lower) <= 0.0 && beyond(l_h.upper) >= 0.0, "{square}: {l_h:?}");
        assert!(l_h.upper - l_h.lower <= 1e-12, "{l_h:?}");
        let (least, most) = (100.0 - f64::from(c), 100.0 + f64::from(a + b));
        assert!(proved.c1().contains(least) && proved.c2().contains(most), "{proved:?}");
        assert_eq!(proved.m_h().upper, 0.0);
        let constants = proved.constants()?;
        assert!(beyond(constants.l_h()) >= 0.0 && constants.is_local() && constants.is_isotropic());
    }
    Ok(())
}

/// `[[a, b], [b, a]]` in the plane, plus `[[0, x y], [x y, 0]]`.
struct Twisted([f64; 2]);

impl Metric<2> for Twisted {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let [a, b] = self.0;
        let off = x[0] * x[1] + b;
        SMatrix::from_fn(|i, j| if i == j { S::constant(a) } else { off })
    }
}

/// The eigenvalues are `a ± (b + x y)`; `|DH|² = x² + y²`, and `D²H[v, v] = 2 v₁v₂`, 1 at most.
#[test]
fn the_constants_of_a_twist_are_enclosed_to_the_last_digit() -> Result<(), CertifyError> {
    let cell = Domain::cell(Cell::new([0.0; 2], [1.0, 2.0])?);
    let accuracy = Accuracy { tolerance: 1e-6, budget: 100_000 };
    for (a, b) in [(8.0, 1.0), (7.0, -1.0), (1e3, 3.0), (5.5, 0.25)] {
        let proved = CertifiedConstants::new(&Twisted([a, b]), &cell, accuracy)?;
        let off = f64::abs(b).max(b + 2.0);
        assert!(proved.c1().contains(a - off) && proved.c2().contains(a + off), "{proved:?}");
        let l_h = proved.l_h();
        assert!(l_h.upper.mul_add(l_h.upper, -5.0) >= 0.0, "{l_h:?}");
        assert!(l_h.lower.mul_add(l_h.lower, -5.0) <= 0.0, "{l_h:?}");
        assert!(proved.m_h().contains(1.0), "{:?}", proved.m_h());
    }
    Ok(())
}
