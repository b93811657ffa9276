//! Propositions 7.6 and 7.7, on smooth curves in the region of one metric.

use std::num::NonZeroUsize;

use nalgebra::SVector;
use proptest::prelude::*;
use tautline_statements::{self as statements, LIBRARY, curves::SmoothCurve};

use super::{Case, statements::judge};
use crate::{
    Region,
    report::LawResult,
    sampling::{CHEAP, for_all},
};

/// One sample in so many of the other laws: of each the energy is integrated to rounding.
const FEWER: u32 = 4;

/// ```text
/// γ(t)  =  (1 − t)³ a + 3 (1 − t)² t p + 3 (1 − t) t² q + t³ b
/// ```
///
/// A weighted mean of the four points at every time, so that it stays in a box in which they are.
fn cubic<const D: usize>([a, p, q, b]: [SVector<f64, D>; 4]) -> SmoothCurve<D> {
    SmoothCurve::polynomial([a, (p - a) * 3.0, (a - p * 2.0 + q) * 3.0, b - a + (p - q) * 3.0])
}

/// Three curves of the region between the same points: one that goes where it likes, one half as
/// far from the straight line, and that line.
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

impl<const D: usize> Case<'_, D> {
    /// Evaluates Proposition 7.6 on smooth curves, with `N` from 1 to 8.
    pub(super) fn of_curves(&self) -> LawResult {
        self.solvable()?;
        let samples = (curves(&self.region), subintervals());
        for_all(&self.effort, self.effort.cases.div_ceil(FEWER), CHEAP, samples, |(curves, n)| {
            judge(&statements::prop_7_6(&LIBRARY, &self.metric, &curves[0], *n)?)
        })
    }

    /// Evaluates Proposition 7.7 on three smooth curves, with `N` from 1 to 8.
    pub(super) fn of_families(&self) -> LawResult {
        self.solvable()?;
        let samples = (curves(&self.region), subintervals());
        for_all(&self.effort, self.effort.cases.div_ceil(FEWER), CHEAP, samples, |(curves, n)| {
            judge(&statements::prop_7_7(&LIBRARY, &self.metric, curves, *n)?)
        })
    }
}

fn subintervals() -> impl Strategy<Value = NonZeroUsize> {
    (1..=8_usize).prop_filter_map("positive", NonZeroUsize::new)
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
