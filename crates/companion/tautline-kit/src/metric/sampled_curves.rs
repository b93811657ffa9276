//! Propositions 7.6 and 7.7, checked on smooth curves in the region of one metric.

use std::num::NonZeroUsize;

use nalgebra::SVector;
use proptest::prelude::*;
use tautline_statements::{
    self as statements, AnyBounded, Evidence, LIBRARY, VerifyError, curves::SmoothCurve,
};

use super::{Case, statements::judge};
use crate::{Effort, Region, report::LawResult};

/// These laws draw one sample for so many of the other laws, since the energy of each curve is
/// integrated to rounding.
const FEWER: u32 = 4;

/// ```text
/// γ(t)  =  (1 − t)³ a + 3 (1 − t)² t p + 3 (1 − t) t² q + t³ b
/// ```
///
/// At every time this is a weighted mean of the four points, so the curve stays in a box around
/// them.
fn cubic<const D: usize>([a, p, q, b]: [SVector<f64, D>; 4]) -> SmoothCurve<D> {
    SmoothCurve::polynomial([a, (p - a) * 3.0, (a - p * 2.0 + q) * 3.0, b - a + (p - q) * 3.0])
}

/// Draws three curves of the region between the same points: a random cubic, a curve half as far
/// from the straight line, and the straight line itself.
fn curves<const D: usize>(
    region: &Region<D>,
) -> impl Strategy<Value = [SmoothCurve<D>; 3]> + use<D> {
    (region.uniform(), region.uniform(), region.uniform(), region.uniform()).prop_map(
        |(a, p, q, b)| {
            let line = [a + (b - a) / 3.0, b + (a - b) / 3.0];
            let half = [(p + line[0]) * 0.5, (q + line[1]) * 0.5];
            [cubic([a, p, q, b]), cubic([a, half[0], half[1], b]), SmoothCurve::straight(a, b)]
        },
    )
}

/// The claims of a statement about smooth curves with `N` subintervals.
type OfCurves<'m, const D: usize> =
    fn(&AnyBounded<'m, D>, &[SmoothCurve<D>; 3], NonZeroUsize) -> Result<Evidence, VerifyError>;

/// Checks Proposition 7.6 on smooth curves with `N` from 1 to 8.
pub(super) fn prop_7_6<const D: usize>(case: &Case<'_, D>) -> LawResult {
    of_curves(case, |metric, [curve, ..], n| statements::prop_7_6(&LIBRARY, metric, curve, n))
}

/// Checks Proposition 7.7 on three smooth curves with `N` from 1 to 8.
pub(super) fn prop_7_7<const D: usize>(case: &Case<'_, D>) -> LawResult {
    of_curves(case, |metric, curves, n| statements::prop_7_7(&LIBRARY, metric, curves, n))
}

fn of_curves<'m, const D: usize>(case: &Case<'m, D>, statement: OfCurves<'m, D>) -> LawResult {
    case.solvable()?;
    let subintervals = (1..=8_usize).prop_filter_map("positive", NonZeroUsize::new);
    let effort = Effort { cases: case.effort.cases.div_ceil(FEWER), ..case.effort };
    effort.for_all((curves(&case.region), subintervals), |(curves, n)| {
        judge(&statement(&case.metric, curves, *n)?)
    })
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline_statements::curves::Curve;

    use super::cubic;

    #[test]
    fn a_cubic_is_a_mean_of_its_points() {
        let points = [vector![1.0, 0.0], vector![-1.0, 4.0], vector![0.5, 2.0], vector![2.0, 1.0]];
        let curve = cubic(points);
        for k in 0..=16 {
            let t = f64::from(k) / 16.0;
            let s = 1.0 - t;
            let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
            let mean: SVector<f64, 2> = weights.iter().zip(points).map(|(w, x)| x * *w).sum();
            let off = (curve.motion(t).position - mean).norm();
            assert!(off <= 1e-14, "{t}: {off}");
        }
    }
}
