//! `Pencil`: two calibrations along one geodesic, from its two ends.

use nalgebra::SVector;
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    calibration::{Calibration, shoot},
    hamiltonian::eigenvalues,
    marching::gram,
};

/// The number of steps along the geodesic.
const STEPS: usize = 2000;

/// How far before a point the rays of its calibration meet, and how far it is continued behind the
/// point, relative to the length of the geodesic.
const FOCUS: f64 = 0.25;
const OVERHANG: f64 = 0.1;

/// Two calibrations along one geodesic: approximations of the distances from the two sets.
#[derive(Clone, Debug)]
pub(crate) struct Pencil<const D: usize> {
    pub(crate) from: [Calibration<D>; 2],
    /// The length of the geodesic.
    pub(crate) length: f64,
}

/// The curvature that the level set of a calibration may have at a point `x` of a set.
enum Bend {
    /// Any: the set is a point.
    Free,
    /// At most this, in the Euclidean sense.
    AtMost(f64),
}

fn bend<const D: usize>(set: &Shape<D>, x: &SVector<f64, D>) -> Bend {
    match set {
        Shape::Point(_) => Bend::Free,
        Shape::Ball(ball) if ball.r() == 0.0 => Bend::Free,
        Shape::Ball(ball) => Bend::AtMost(1.0 / ball.r()),
        Shape::HalfSpace(_) | Shape::AxisBox(_) => Bend::AtMost(0.0),
        Shape::Union(_) => set
            .pieces()
            .into_iter()
            .min_by(|a, b| gap(a, x).total_cmp(&gap(b, x)))
            .map_or(Bend::AtMost(0.0), |piece| bend(piece, x)),
    }
}

/// Returns the Euclidean distance between a piece and `x`, roughly.
fn gap<const D: usize>(piece: &Shape<D>, x: &SVector<f64, D>) -> f64 {
    crate::seed::distance(piece, x)
}

/// A geodesic through the middle of a polygon.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Geodesic<const D: usize> {
    middle: SVector<f64, D>,
    momentum: SVector<f64, D>,
    /// The lengths from the middle to the two ends.
    reach: [f64; 2],
}

impl<const D: usize> Geodesic<D> {
    /// Returns the geodesic near a polygon of the given length.
    pub(crate) fn near(
        formula: &Formula<D>,
        points: &[SVector<f64, D>],
        length: f64,
    ) -> Option<Self> {
        let (middle, momentum, before) = middle(formula, points)?;
        Some(Self { middle, momentum, reach: [before, length - before] })
    }

    /// Returns the length of the geodesic.
    fn length(&self) -> f64 {
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

impl<const D: usize> Pencil<D> {
    /// Returns the calibrations along a geodesic from set to set. Returns `None` if there are none, for
    /// example because an end is conjugate to the other.
    pub(crate) fn along(
        formula: &Formula<D>,
        sets: &[Shape<D>; 2],
        geodesic: &Geodesic<D>,
    ) -> Option<Self> {
        let mut overhang = OVERHANG * geodesic.length();
        for _ in 0..8 {
            let found = Self::with(formula, sets, geodesic, overhang);
            if let Some(pencil) = found.filter(Self::is_convex) {
                return Some(pencil);
            }
            overhang *= 0.5;
        }
        None
    }

    fn with(
        formula: &Formula<D>,
        sets: &[Shape<D>; 2],
        geodesic: &Geodesic<D>,
        overhang: f64,
    ) -> Option<Self> {
        let length = geodesic.length();
        let from = [0, 1].map(|side| {
            let (end, _) = geodesic.behind(formula, side, 0.0)?;
            let bend = bend(&sets[side], &end);
            let behind = if matches!(bend, Bend::Free) { overhang } else { 0.0 };
            let (x, p) = geodesic.behind(formula, side, behind)?;
            let w = match bend {
                Bend::Free => 1.0 / (FOCUS * length),
                Bend::AtMost(curvature) => {
                    let across = eigenvalues(&gram(formula, &x)).into_iter().fold(0.0, f64::max);
                    0.9 * curvature * p.norm() / across - 0.02 / length
                }
            };
            let step = (length + behind + overhang) / STEPS as f64;
            Calibration::integrate(formula, (x, -p), w, -behind, step, STEPS)
        });
        let [Some(first), Some(second)] = from else { return None };
        Some(Self { from: [first, second], length })
    }

    /// Returns whether the sum of both functions has a strict minimum across the geodesic.
    fn is_convex(&self) -> bool {
        (0..=20).all(|k| {
            let s = self.length * f64::from(k) / 20.0;
            let sum = self.from[0].curvature(s) + self.from[1].curvature(self.length - s);
            let mut eigenvalues = eigenvalues(&sum);
            eigenvalues.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
            // Along the geodesic the sum does not change.
            eigenvalues.iter().skip(1).all(|&eigenvalue| eigenvalue > 0.0)
        })
    }
}

/// Returns the middle of a polygon, the momentum there, and the length up to it.
fn middle<const D: usize>(
    formula: &Formula<D>,
    points: &[SVector<f64, D>],
) -> Option<(SVector<f64, D>, SVector<f64, D>, f64)> {
    let length = |pair: &[SVector<f64, D>]| {
        let chord = pair[1] - pair[0];
        let h = gram(formula, &((pair[0] + pair[1]) * 0.5));
        chord.dot(&(h * chord)).sqrt()
    };
    let lengths: Vec<f64> = points.windows(2).map(length).collect();
    let total: f64 = lengths.iter().sum();
    let (mut before, mut chord) = (0.0, 0);
    while chord + 1 < lengths.len() && before + 0.5 * lengths[chord] < 0.5 * total {
        before += lengths[chord];
        chord += 1;
    }
    let step = points.get(chord + 1)? - points[chord];
    let x = (points[chord] + points[chord + 1]) * 0.5;
    let p = gram(formula, &x) * step;
    Some((x, p, before + 0.5 * lengths[chord]))
}
