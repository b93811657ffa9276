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

use crate::{hamiltonian::Hamiltonian, marching::gram};

/// One place of a geodesic, with derivatives by arc length.
#[derive(Clone, Copy, Debug)]
struct Sample<const D: usize> {
    x: SVector<f64, D>,
    p: SVector<f64, D>,
    s: SMatrix<f64, D, D>,
    /// The metric.
    h: SMatrix<f64, D, D>,
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

/// How far a foot may be from where it is sought, relative to the number of samples.
const MOST_OF_ALL: f64 = 0.25;

impl<const D: usize> Calibration<D> {
    /// Integrates from `x` along the momentum `p`, which is made to have length 1, with `steps` steps
    /// of arc length `step`. The first sample has arc length `start`. On vectors across the geodesic,
    /// its `S` is the form that `across` returns, given `H` and the momentum.
    ///
    /// Returns `None` if the metric is undefined on the way or `S` leaves every bound.
    pub(crate) fn integrate(
        formula: &Formula<D>,
        (x, p): (SVector<f64, D>, SVector<f64, D>),
        across: impl Fn(&SMatrix<f64, D, D>, &SVector<f64, D>) -> SMatrix<f64, D, D>,
        start: f64,
        step: f64,
        steps: usize,
    ) -> Option<Self> {
        let at = Hamiltonian::at(formula, &x, &p)?;
        let p = p / p.dot(&at.velocity).sqrt();
        let at = Hamiltonian::at(formula, &x, &p)?;
        let (velocity, force) = (at.velocity, at.force);
        let projector = SMatrix::<f64, D, D>::identity() - velocity * p.transpose();
        let s = force * p.transpose() + p * force.transpose()
            - p * p.transpose() * force.dot(&velocity)
            + projector.transpose() * across(&at.h, &p) * projector;
        let bound = 1e6 * (s.amax() + at.h.amax() / step);
        let mut state = (x, p, s);
        let mut samples = Vec::with_capacity(steps + 1);
        for taken in 0..=steps {
            let slopes = slopes(formula, &state, true)?;
            let (x, p, s) = state;
            samples.push(Sample { x, p, s, h: gram(formula, &x), slopes });
            if taken < steps {
                state = runge_kutta(formula, &state, slopes, step, true)?;
            }
            // The largest of some entries would not be NaN if one of them is.
            if !state.2.iter().all(|entry| entry.abs() <= bound) {
                return None;
            }
        }
        Some(Self { start, step, samples })
    }

    /// Returns the place at a sample.
    pub(crate) fn place(&self, sample: usize) -> &SVector<f64, D> {
        &self.samples[sample].x
    }

    /// Returns the velocity at a sample.
    pub(crate) fn velocity(&self, sample: usize) -> &SVector<f64, D> {
        &self.samples[sample].slopes.0
    }

    /// Returns the point at so many steps from the start.
    pub(crate) fn point(&self, at: f64) -> SVector<f64, D> {
        self.line(at)[0]
    }

    /// Returns `S` at the sample nearest to this arc length.
    pub(crate) fn curvature(&self, s: f64) -> SMatrix<f64, D, D> {
        let at = ((s - self.start) / self.step).round().max(0.0) as usize;
        self.samples[at.min(self.samples.len() - 1)].s
    }

    /// Returns where on the geodesic `p(s)·(x − c(s)) = 0`, in steps from the start, near the sample
    /// that is nearest to `x` by the metric there, which is the foot up to the second order.
    pub(crate) fn foot(&self, x: &SVector<f64, D>) -> f64 {
        let distance = |at: usize| {
            let sample = &self.samples[at];
            let away = sample.x - x;
            away.dot(&(sample.h * away))
        };
        let nearest = |range: &mut dyn Iterator<Item = usize>| {
            range.min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
        };
        let last = self.samples.len() - 1;
        let coarse = nearest(&mut (0..=last).step_by(STRIDE));
        let near = coarse.saturating_sub(STRIDE)..=(coarse + STRIDE).min(last);
        self.foot_near(x, nearest(&mut near.into_iter()) as f64)
    }

    /// Returns the same, near `at` steps from the start.
    pub(crate) fn foot_near(&self, x: &SVector<f64, D>, mut at: f64) -> f64 {
        let most = MOST_OF_ALL * self.samples.len() as f64;
        for _ in 0..6 {
            let [c, p, dc, dp] = self.line(at);
            let away = x - c;
            let slope = dp.dot(&away) - p.dot(&dc);
            let correction = p.dot(&away) / slope / self.step;
            if !(correction.abs() <= most) {
                break;
            }
            at -= correction;
            if correction.abs() < 1e-7 {
                break;
            }
        }
        at
    }

    /// Returns the value of the function at `x`, up to the third order in the distance from the
    /// geodesic, given the [`foot`](Calibration::foot). Beyond its ends the geodesic is continued
    /// straight.
    pub(crate) fn value(&self, x: &SVector<f64, D>, foot: f64) -> f64 {
        let [c, p, ..] = self.line(foot);
        let away = x - c;
        let (cell, t) = self.cell(foot);
        let [a, b] = [&self.samples[cell], &self.samples[cell + 1]];
        let form = |s: &SMatrix<f64, D, D>| away.dot(&(s * away));
        let [w, v, ..] = hermite(t);
        let bend = form(&a.s) * w[0]
            + form(&b.s) * w[1]
            + (form(&a.slopes.2) * v[0] + form(&b.slopes.2) * v[1]) * self.step;
        self.start + foot * self.step + p.dot(&away) + 0.5 * bend
    }

    /// Returns the step that contains `at`, and the part of it before `at`.
    fn cell(&self, at: f64) -> (usize, f64) {
        let cell = (at.floor().max(0.0) as usize).min(self.samples.len() - 2);
        (cell, (at - cell as f64).clamp(0.0, 1.0))
    }

    /// Returns `c`, `p`, `c'` and `p'` at `at` steps from the start, by cubic interpolation.
    fn line(&self, at: f64) -> [SVector<f64, D>; 4] {
        let (cell, t) = self.cell(at);
        let [a, b] = [&self.samples[cell], &self.samples[cell + 1]];
        let h = self.step;
        let [w, v, dw, dv] = hermite(t);
        let x = a.x * w[0] + b.x * w[1] + (a.slopes.0 * v[0] + b.slopes.0 * v[1]) * h;
        let p = a.p * w[0] + b.p * w[1] + (a.slopes.1 * v[0] + b.slopes.1 * v[1]) * h;
        let dx = (a.x * dw[0] + b.x * dw[1]) / h + a.slopes.0 * dv[0] + b.slopes.0 * dv[1];
        let dp = (a.p * dw[0] + b.p * dw[1]) / h + a.slopes.1 * dv[0] + b.slopes.1 * dv[1];
        // Beyond the ends of the geodesic.
        let beyond = (at - cell as f64 - t) * h;
        [x + dx * beyond, p + dp * beyond, dx, dp]
    }
}

/// Returns the weights of cubic interpolation at a part `t` of a step: of values, of slopes times the
/// step, and their derivatives.
fn hermite(t: f64) -> [[f64; 2]; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        [2.0 * t3 - 3.0 * t2 + 1.0, 3.0 * t2 - 2.0 * t3],
        [t3 - 2.0 * t2 + t, t3 - t2],
        [6.0 * t2 - 6.0 * t, 6.0 * t - 6.0 * t2],
        [3.0 * t2 - 4.0 * t + 1.0, 3.0 * t2 - 2.0 * t],
    ]
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
    let riccati =
        if bends { -(at.xx + mixed + mixed.transpose() + s * at.pp * s) } else { SMatrix::zeros() };
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
    let moved =
        |k: &State<D>, by: f64| (state.0 + k.0 * by, state.1 + k.1 * by, state.2 + k.2 * by);
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

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline_formula::Formula;
    use tautline_metrics::{KnownDistance, gallery::Sphere};

    use super::{Calibration, shoot};

    /// Rays that meet at a point of the sphere give the distance from it, up to the third order in
    /// the distance from the geodesic.
    #[test]
    fn a_calibration_is_a_distance_up_to_the_third_order() {
        let sphere = Formula::<2>::parse("4/sqr(1 + x1^2 + x2^2) I", &[]).expect("a formula");
        let (focus, p): (SVector<f64, 2>, _) = (vector![-0.6, 0.1], vector![1.0, 0.4]);
        let near = 0.01;
        let (x, p) = shoot(&sphere, (focus, p), near / 20.0, 20).expect("defined");
        let rays = Calibration::integrate(&sphere, (x, p), |h, _| h / near, near, 1e-3, 1500);
        let rays = rays.expect("no conjugate point");
        let error = |away: f64| {
            let on = rays.place(1000);
            let x = on + vector![-0.3, 1.0] * away;
            let exact = Sphere.distance(&focus, &x).expect("known");
            (rays.value(&x, rays.foot(&x)) - exact).abs()
        };
        let (far, close) = (error(0.04), error(0.01));
        assert!(far < 1e-4 && close < far / 30.0, "{far:e} {close:e}");
        // On the geodesic itself, only the start is approximate.
        assert!(error(0.0) < 1e-7, "{:e}", error(0.0));
    }

    /// Rays of the plane that meet at the arc length −1/4 have fronts of the radius `s + 1/4`, wherever the
    /// samples begin.
    #[test]
    fn curvatures_are_those_at_an_arc_length_from_the_set() {
        let flat = Formula::<2>::parse("1 I", &[]).expect("a formula");
        for near in [0.0625, 0.25, 0.5] {
            let start = (vector![near, 0.0], vector![1.0, 0.0]);
            let rays = Calibration::integrate(
                &flat,
                start,
                |h, _| h / near,
                near - 0.25,
                1.0 / 1024.0,
                1200,
            );
            let rays = rays.expect("defined");
            for s in [0.25, 0.375, 0.75] {
                let curvature = rays.curvature(s)[(1, 1)];
                // A step of the method of fourth order is 1/64 of the first radius, or less.
                assert!((curvature * (s + 0.25) - 1.0).abs() < 1e-6, "{near} {s}: {curvature}");
            }
        }
    }

    /// Under an anisotropic metric the foot is far from the nearest point of the geodesic.
    #[test]
    fn a_foot_far_from_the_nearest_point_is_found() {
        let flat = Formula::<2>::parse("[1, 3; 3, 10]", &[]).expect("a formula");
        let start = (vector![0.0, 0.0], vector![1.0, 3.0]);
        let straight = |h: &nalgebra::SMatrix<f64, 2, 2>, _: &SVector<f64, 2>| h * 0.0;
        let ray = Calibration::integrate(&flat, start, straight, 0.0, 1e-3, 1000);
        let ray = ray.expect("defined");
        // The geodesic is x₂ = 0, and p = (1, 3).
        for (x, foot) in [(vector![0.2, 0.1], 500.0), (vector![-0.1, 0.3], 800.0)] {
            assert!((ray.foot(&x) - foot).abs() < 1e-6, "{} at {x}", ray.foot(&x));
        }
    }

    /// Riccati's equation has no bounded solution past a point conjugate to the start.
    #[test]
    fn a_conjugate_point_ends_a_calibration() {
        let sphere = Formula::<2>::parse("4/sqr(1 + x1^2 + x2^2) I", &[]).expect("a formula");
        let start = (vector![0.0, 0.0], vector![1.0, 0.0]);
        // Rays that converge meet before the antipode, which is at infinity.
        let converging = |h: &nalgebra::SMatrix<f64, 2, 2>, _: &SVector<f64, 2>| h * -2.0;
        assert!(Calibration::integrate(&sphere, start, converging, 0.0, 1e-3, 1500).is_none());
        assert!(Calibration::integrate(&sphere, start, converging, 0.0, 1e-3, 300).is_some());
    }
}
