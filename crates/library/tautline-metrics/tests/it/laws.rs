//! Constants hold at random points, for random parameters, and for pairs of points close together.

use nalgebra::SVector;
use proptest::{array::uniform, prelude::*};
use tautline_metrics::Bounded;

use crate::measure::{extremes, first, norm, runner, second};

/// Draws points of `[−1, 1]^D`.
pub(crate) fn cube<const D: usize>() -> impl Strategy<Value = SVector<f64, D>> {
    uniform(-1.0..1.0_f64).prop_map(SVector::from)
}

/// Makes one test per line: the constants of `$build(parameters)` hold in dimension `$D`.
macro_rules! constants_hold {
    ($($test:ident, $D:literal, seed $seed:literal: $parameters:expr, $build:expr;)*) => {$(
        #[test]
        fn $test() {
            crate::laws::hold::<$D, _, _>($seed, $parameters, $build);
        }
    )*};
}
pub(crate) use constants_hold;

/// Checks every constant of `build(parameters)` in the cube about the origin whose half-width
/// `build` also returns.
pub(crate) fn hold<const D: usize, P: std::fmt::Debug, M: Bounded<D>>(
    seed: u64,
    parameters: impl Strategy<Value = P>,
    build: impl Fn(P) -> (M, f64),
) {
    let cases = (parameters, cube::<D>(), cube::<D>(), cube::<D>(), 0..7_i32);
    let outcome = runner(seed).run(&cases, |(parameters, x, y, w, decades)| {
        let (g, reach) = build(parameters);
        let (x, y) = (x * reach, y * reach);
        hold_at(&g, &x, &w)?;
        lipschitz(&g, &x, &y)?;
        lipschitz(&g, &x, &(x + w * reach * 0.1_f64.powi(decades)))
    });
    if let Err(error) = outcome {
        panic!("{error}");
    }
}

fn hold_at<const D: usize>(
    g: &impl Bounded<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> Result<(), TestCaseError> {
    let constants = g.constants();
    let h = g.gram(x);
    prop_assert_eq!(h, h.transpose());
    let (low, high) = extremes(&h);
    // An entry has about ten roundings of terms of size c₂, and an eigenvalue D times as many.
    let rounding = 1e-14 * constants.c2() * D as f64;
    prop_assert!(constants.c1() <= low + rounding, "c1 {} > {low}", constants.c1());
    prop_assert!(high <= constants.c2() + rounding, "c2 {} < {high}", constants.c2());
    // The terms of the derivatives are of the size of the constants.
    let slope = norm(&first(g, x, w));
    let bound = constants.l_h() * w.norm();
    prop_assert!(slope <= bound * (1.0 + 1e-12), "L_H |w| {bound} < {slope}");
    let curvature = norm(&second(g, x, w));
    let bound = constants.m_h().expect("every metric here has one") * w.norm_squared();
    prop_assert!(curvature <= bound * (1.0 + 1e-12), "M_H |w|^2 {bound} < {curvature}");
    Ok(())
}

fn lipschitz<const D: usize>(
    g: &impl Bounded<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
) -> Result<(), TestCaseError> {
    let constants = g.constants();
    let difference = norm(&(g.gram(x) - g.gram::<f64>(y)));
    let bound = constants.l_h() * (x - y).norm();
    // As above, this covers the roundings of H(x) and H(y).
    let rounding = 2e-14 * constants.c2() * D as f64;
    prop_assert!(difference <= bound + rounding, "L_H |x - y| {bound} < {difference}");
    Ok(())
}
