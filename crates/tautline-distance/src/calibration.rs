//! `Calibration`: a function that is nearly the distance from a set, near one geodesic.
//!
//! Let `c` be a geodesic of unit speed with momenta `p = H c'`. A solution `φ` of the eikonal equation
//! with `∇φ(c(s)) = p(s)` has the second derivatives `S = D²φ(c(s))` with
//!
//! ```text
//! S' = −(K_xx + K_xp S + S K_px + S K_pp S),
//! ```
//!
//! Riccati's equation. Where `p(s)·(x − c(s)) = 0`, `φ(x) = s + ½ (x − c)ᵀS (x − c)` up to the third
//! order.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;

use crate::hamiltonian::Hamiltonian;

/// One place of a geodesic, with derivatives by arc length.
#[derive(Clone, Copy, Debug)]
struct Sample<const D: usize> {
    x: SVector<f64, D>,
    p: SVector<f64, D>,
    s: SMatrix<f64, D, D>,
    slopes: (SVector<f64, D>, SVector<f64, D>, SMatrix<f64, D, D>),
}

/// A geodesic with second derivatives of a function of which it is a characteristic curve.
#[derive(Clone, Debug)]
pub(crate) struct Calibration<const D: usize> {
    /// The arc length of the first sample, and the distance between samples.
    start: f64,
    step: f64,
    samples: Vec<Sample<D>>,
}

/// The number of samples that are compared before the nearest ones are.
const STRIDE: usize = 24;

impl<const D: usize> Calibration<D> {
    /// Integrates from `x` along the momentum `p`, which is made to have length 1, with `steps` steps
    /// of arc length `step`. The first sample has arc length `start`, and its `S` is the one with the
    /// curvature `w ≥ 0` across the geodesic.
    ///
    /// Returns `None` if the metric is undefined on the way or `S` leaves every bound.
    pub(crate) fn integrate(
        formula: &Formula<D>,
        (x, p): (SVector<f64, D>, SVector<f64, D>),
        w: f64,
        start: f64,
        step: f64,
        steps: usize,
    ) -> Option<Self> {
        let at = Hamiltonian::at(formula, &x, &p)?;
        let p = p / p.dot(&at.velocity).sqrt();
        let at = Hamiltonian::at(formula, &x, &p)?;
        // Across the geodesic, H − ppᵀ measures lengths.
        let (along, force) = (p * p.transpose(), at.force);
        let s = force * p.transpose() + p * force.transpose()
            - along * force.dot(&at.velocity)
            + (at.h - along) * w;
        let bound = 1e6 * (w + s.amax() + at.h.amax() / step);
        let mut state = (x, p, s);
        let mut samples = Vec::with_capacity(steps + 1);
        for taken in 0..=steps {
            let slopes = slopes(formula, &state, true)?;
            let (x, p, s) = state;
            samples.push(Sample { x, p, s, slopes });
            if taken < steps {
                state = runge_kutta(formula, &state, slopes, step, true)?;
            }
            if !(state.2.amax() <= bound) {
                return None;
            }
        }
        Some(Self { start, step, samples })
    }

    /// Returns `S` at the sample nearest to this arc length.
    pub(crate) fn curvature(&self, s: f64) -> SMatrix<f64, D, D> {
        let at = ((s - self.start) / self.step).round().max(0.0) as usize;
        self.samples[at.min(self.samples.len() - 1)].s
    }

    /// Returns the value of the function at `x`, up to the third order in the distance from the
    /// geodesic. Beyond its ends the geodesic is continued straight.
    pub(crate) fn value(&self, x: &SVector<f64, D>) -> f64 {
        let distance = |at: usize| (self.samples[at].x - x).norm_squared();
        let nearest = |range: &mut dyn Iterator<Item = usize>| {
            range.min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
        };
        let last = self.samples.len() - 1;
        let coarse = nearest(&mut (0..=last).step_by(STRIDE));
        let near = coarse.saturating_sub(STRIDE)..=(coarse + STRIDE).min(last);
        let mut at = nearest(&mut near.into_iter()) as f64;
        for _ in 0..5 {
            let (c, p, _, dc, dp) = self.between(at);
            let away = x - c;
            let slope = dp.dot(&away) - p.dot(&dc);
            let correction = p.dot(&away) / slope;
            if !(correction.abs() <= self.step * (2 * STRIDE) as f64) {
                break;
            }
            at -= correction / self.step;
        }
        let (c, p, s, ..) = self.between(at);
        let away = x - c;
        self.start + at * self.step + p.dot(&away) + 0.5 * away.dot(&(s * away))
    }

    /// Returns `c`, `p`, `S`, `c'` and `p'` at `at` steps from the start, by cubic interpolation.
    #[allow(clippy::type_complexity)]
    fn between(
        &self,
        at: f64,
    ) -> (SVector<f64, D>, SVector<f64, D>, SMatrix<f64, D, D>, SVector<f64, D>, SVector<f64, D>)
    {
        let last = self.samples.len() - 1;
        let cell = (at.floor().max(0.0) as usize).min(last - 1);
        let t = (at - cell as f64).clamp(0.0, 1.0);
        let (a, b) = (&self.samples[cell], &self.samples[cell + 1]);
        let h = self.step;
        let (t2, t3) = (t * t, t * t * t);
        let value = [2.0 * t3 - 3.0 * t2 + 1.0, t3 - 2.0 * t2 + t, 3.0 * t2 - 2.0 * t3, t3 - t2];
        let slope =
            [(6.0 * t2 - 6.0 * t) / h, 3.0 * t2 - 4.0 * t + 1.0, (6.0 * t - 6.0 * t2) / h, 3.0 * t2 - 2.0 * t];
        // Beyond the ends of the geodesic.
        let beyond = (at - cell as f64 - t) * h;
        let x = |w: [f64; 4], k: f64| {
            a.x * w[0] + a.slopes.0 * (k * w[1]) + b.x * w[2] + b.slopes.0 * (k * w[3])
        };
        let p = |w: [f64; 4], k: f64| {
            a.p * w[0] + a.slopes.1 * (k * w[1]) + b.p * w[2] + b.slopes.1 * (k * w[3])
        };
        let s = a.s * value[0] + a.slopes.2 * (h * value[1]) + b.s * value[2] + b.slopes.2 * (h * value[3]);
        let (dx, dp) = (x(slope, 1.0), p(slope, 1.0));
        (x(value, h) + dx * beyond, p(value, h) + dp * beyond, s, dx, dp)
    }
}

type State<const D: usize> = (SVector<f64, D>, SVector<f64, D>, SMatrix<f64, D, D>);

/// Returns the right side of the equations; without `bends`, `S` stays as it is.
fn slopes<const D: usize>(
    formula: &Formula<D>,
    (x, p, s): &State<D>,
    bends: bool,
) -> Option<State<D>> {
    let at = Hamiltonian::at(formula, x, p)?;
    let mixed = at.xp * s;
    let riccati = if bends {
        -(at.xx + mixed + mixed.transpose() + s * at.pp * s)
    } else {
        SMatrix::zeros()
    };
    Some((at.velocity, at.force, riccati))
}

/// One step of the classical method of fourth order.
fn runge_kutta<const D: usize>(
    formula: &Formula<D>,
    state: &State<D>,
    first: State<D>,
    step: f64,
    bends: bool,
) -> Option<State<D>> {
    let moved = |k: &State<D>, by: f64| {
        (state.0 + k.0 * by, state.1 + k.1 * by, state.2 + k.2 * by)
    };
    let second = slopes(formula, &moved(&first, 0.5 * step), bends)?;
    let third = slopes(formula, &moved(&second, 0.5 * step), bends)?;
    let fourth = slopes(formula, &moved(&third, step), bends)?;
    let sum = (
        first.0 + (second.0 + third.0) * 2.0 + fourth.0,
        first.1 + (second.1 + third.1) * 2.0 + fourth.1,
        first.2 + (second.2 + third.2) * 2.0 + fourth.2,
    );
    Some(moved(&sum, step / 6.0))
}

/// Follows the geodesic from `x` along the momentum `p`, which is made to have length 1. Returns the
/// last place and momentum; `None` if the metric is undefined on the way.
pub(crate) fn shoot<const D: usize>(
    formula: &Formula<D>,
    (x, p): (SVector<f64, D>, SVector<f64, D>),
    step: f64,
    steps: usize,
) -> Option<(SVector<f64, D>, SVector<f64, D>)> {
    let at = Hamiltonian::at(formula, &x, &p)?;
    let mut state = (x, p / p.dot(&at.velocity).sqrt(), SMatrix::zeros());
    for _ in 0..steps {
        let first = slopes(formula, &state, false)?;
        state = runge_kutta(formula, &state, first, step, false)?;
    }
    Some((state.0, state.1))
}
