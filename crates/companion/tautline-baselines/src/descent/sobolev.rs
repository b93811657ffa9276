//! Gradient descent in a Sobolev norm.

use tautline::{Batches, PointSequence, Rule, Watcher};

use crate::descent::{
    Descended, DescentError, Ended, Limits,
    laplacian::Laplacian,
    search::{Search, dot},
};

/// The lengths of steps relative to that for a constant metric: a shorter one is none, and where the
/// energy hardly bends, no trial is longer.
const SHORTEST: f64 = 1e-10;
const LONGEST: f64 = 1e3;

/// Minimises a discrete energy between the ends of `start` by gradient descent, with the gradient in
/// the norm `(∫ |δ̇|²)^{1/2}` of displacements.
///
/// The gradient is `T⁻¹ ∂E/∂x` with the matrix `T` of second differences. In that norm the condition
/// number of the Hessian does not grow with `N`, so that the number of steps does not either. The
/// length of the first trial of each step is that of Barzilai and Borwein, `δᵀTδ / δᵀ(g⁺ − g)` for the
/// step `δ` before; it is halved until the energy falls enough (Armijo).
///
/// `watcher` sees each iterate, and can end the descent.
///
/// # Errors
///
/// [`DescentError`]: the start has no metric or no finite energy.
///
/// # Source
///
/// R. J. Renka, J. W. Neuberger, Minimal surfaces and Sobolev gradients, SIAM J. Sci. Comput. 16
/// (1995); J. Barzilai, J. M. Borwein, Two-point step size gradient methods, IMA J. Numer. Anal. 8
/// (1988).
pub fn sobolev_descent<'a, const D: usize>(
    metric: &'a dyn Batches<D>,
    rule: Rule,
    start: PointSequence<D>,
    limits: &Limits,
    watcher: &'a mut Watcher<'a, D>,
) -> Result<Descended<D>, DescentError> {
    let (mut search, mut here) = Search::begin(metric, rule, start, limits, watcher)?;
    let laplacian = Laplacian::new(here.sequence.n().get());
    let mut length = None;
    for iteration in 0.. {
        if let Some(ended) = search.end_at(&here, iteration) {
            return Ok(search.descended(here, ended, iteration));
        }
        let mut direction = here.gradient().to_vec();
        laplacian.solve(&mut direction);
        direction.iter_mut().for_each(|d| *d = -*d);
        // δᵀTδ = −δᵀg for the direction δ.
        let slope = -dot(&direction, here.gradient());
        let usual = 1.0 / here.stiffness();
        let mut scale = length.take().unwrap_or(usual).min(LONGEST * usual);
        let there = loop {
            let points = here.moved(&direction, scale);
            if let Some(energy) = search.energy(&points)
                && here.falls_enough(energy, scale * slope)
                && let Ok(sequence) = PointSequence::new(points)
            {
                // A positive energy does not yet mean that there is a metric.
                let there = search.at(sequence);
                if there.model.is_metric {
                    break Some(there);
                }
            }
            scale *= 0.5;
            if !(scale >= SHORTEST * usual) {
                break None;
            }
        };
        let Some(there) = there else {
            return Ok(search.descended(here, Ended::Stalled, iteration));
        };
        let bend = dot(&direction, there.gradient()) + slope;
        // Where the energy bends down, the length is no guide to the next.
        length = Some(if bend > 0.0 { scale * slope / bend } else { 4.0 * scale });
        here = there;
    }
    unreachable!("a descent ends at its limit of steps")
}
