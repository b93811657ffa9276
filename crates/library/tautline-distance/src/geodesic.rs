//! `Geodesic`: the geodesic near a polygon.

use nalgebra::SVector;
use tautline_formula::Formula;

use crate::{calibration::shoot, marching::gram};

/// The number of steps along the geodesic.
const STEPS: usize = 1000;

/// A geodesic through the middle of a polygon.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Geodesic<const D: usize> {
    middle: SVector<f64, D>,
    momentum: SVector<f64, D>,
    /// The lengths from the middle to the two ends.
    reach: [f64; 2],
}

impl<const D: usize> Geodesic<D> {
    /// Returns the geodesic near a polygon.
    pub(crate) fn near(formula: &Formula<D>, points: &[SVector<f64, D>]) -> Option<Self> {
        let (middle, momentum, reach) = middle(formula, points)?;
        Some(Self { middle, momentum, reach })
    }

    /// Returns the middle of the polygon.
    pub(crate) fn middle(&self) -> &SVector<f64, D> {
        &self.middle
    }

    /// Returns the length of the geodesic.
    pub(crate) fn length(&self) -> f64 {
        self.reach[0] + self.reach[1]
    }

    /// Returns the place and the outward momentum at this arc length behind an end.
    pub(crate) fn behind(
        &self,
        formula: &Formula<D>,
        end: usize,
        behind: f64,
    ) -> Option<(SVector<f64, D>, SVector<f64, D>)> {
        let sign = if end == 0 { -1.0 } else { 1.0 };
        let step = (self.reach[end] + behind) / STEPS as f64;
        shoot(formula, (self.middle, self.momentum * sign), step, STEPS)
    }
}

/// Returns the middle of a polygon, the momentum there, and the lengths from it to both ends.
fn middle<const D: usize>(
    formula: &Formula<D>,
    points: &[SVector<f64, D>],
) -> Option<(SVector<f64, D>, SVector<f64, D>, [f64; 2])> {
    let length = |pair: &[SVector<f64, D>]| {
        let chord = pair[1] - pair[0];
        let h = gram(formula, &((pair[0] + pair[1]) * 0.5));
        chord.dot(&(h * chord)).sqrt()
    };
    let lengths: Vec<f64> = points.windows(2).map(length).collect();
    let total: f64 = lengths.iter().sum();
    let (mut before, mut chord) = (0.0, 0);
    // A chord without length has no direction.
    let is_before = |before: f64, length: f64| length == 0.0 || before + 0.5 * length < 0.5 * total;
    while chord + 1 < lengths.len() && is_before(before, lengths[chord]) {
        before += lengths[chord];
        chord += 1;
    }
    let step = points.get(chord + 1)? - points[chord];
    let x = (points[chord] + points[chord + 1]) * 0.5;
    let p = gram(formula, &x) * step;
    let before = before + 0.5 * lengths[chord];
    Some((x, p, [before, total - before]))
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline_formula::Formula;

    use super::Geodesic;

    /// A chord without length has no direction, and is passed over.
    #[test]
    fn the_middle_of_a_polygon_may_be_a_double_point() {
        let flat = Formula::<2>::parse("1 I", &[]).expect("a formula");
        let curve: Vec<SVector<f64, 2>> =
            [-1.0, 0.0, 0.0, 1.0].map(|x| vector![x, 2.0 * x]).to_vec();
        let geodesic = Geodesic::near(&flat, &curve).expect("a geodesic");
        for (end, x) in [(0, -1.0), (1, 1.0)] {
            let (place, _) = geodesic.behind(&flat, end, 0.0).expect("defined");
            assert!((place - vector![x, 2.0 * x]).norm() < 1e-9, "{place}");
        }
        assert!((geodesic.length() - 20_f64.sqrt()).abs() < 1e-12);
    }
}
