//! Differential dynamic programming.

use nalgebra::{SMatrix, SVector};
use tautline::{Batches, ChordModel, Node, PointSequence, Rule, Watcher};

use crate::descent::{
    Descended, DescentError, Ended, Limits,
    chord_models::chord_models,
    search::{Here, Search},
};

/// The second derivatives that dynamic programming uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SecondOrder {
    /// Those of the energy.
    Full,
    /// Those of Gauss and Newton, which need only first derivatives of `H` and are never indefinite:
    /// the energy of a chord `d` is the sum of the squares `|r|²` with `r = Rᵀd` and `H = R Rᵀ`, and
    /// second derivatives of `r` are left out. The factor `R` is the one that turns as little as it
    /// can from point to point, `∂ₖR = ½ ∂ₖH R⁻ᵀ`, which gives the same result for every `R`.
    GaussNewton,
}

/// The first shift of the control Hessian relative to the energy, the factor from one to the next,
/// and the last.
const SHIFTS: [f64; 3] = [1e-3, 8.0, 1e12];

/// The shortest step along the policy.
pub(crate) const SHORTEST: f64 = 1e-6;

/// Minimises a discrete energy between the ends of `start` by differential dynamic programming.
///
/// The points are the states, the chords `uₙ = xₙ₊₁ − xₙ` the controls, and each chord costs its
/// energy. A backward pass computes, from the last chord to the first, a quadratic model of the cost
/// to go and the affine policy that minimises it; a forward pass follows the policy. The last control
/// is whatever leads to the end, so that the end is a constraint that always holds. The Hessian of
/// the controls is shifted until it is positive definite and a step lowers the energy.
///
/// As the dynamics `xₙ₊₁ = xₙ + uₙ` are linear, the [full](SecondOrder::Full) form is Newton's method,
/// with the Riccati recursion as the elimination of the points in their order. The
/// [Gauss–Newton](SecondOrder::GaussNewton) form is known as iLQR; it converges linearly.
///
/// `watcher` sees each iterate, and can end the descent.
///
/// # Errors
///
/// [`DescentError`]: the start has no metric or no finite energy.
///
/// # Source
///
/// D. H. Jacobson, D. Q. Mayne, Differential Dynamic Programming, 1970; Y. Tassa, T. Erez,
/// E. Todorov, Synthesis and stabilization of complex behaviors through online trajectory
/// optimization, IROS 2012.
pub fn dynamic_programming<'a, const D: usize>(
    metric: &'a dyn Batches<D>,
    rule: Rule,
    start: PointSequence<D>,
    form: SecondOrder,
    limits: &Limits,
    watcher: &'a mut Watcher<'a, D>,
) -> Result<Descended<D>, DescentError> {
    let (mut search, mut here) = Search::begin(metric, rule, start, limits, watcher)?;
    let [first, factor, last] = SHIFTS;
    let mut shift = 0.0;
    for iteration in 0.. {
        if let Some(ended) = search.end_at(&here, iteration) {
            return Ok(search.descended(here, ended, iteration));
        }
        search.evaluations += 1;
        let chords = chords(search.metric, rule.nodes(), &here.sequence, form);
        // On the edge of positive definite, two programs may round to either side.
        let Some(chords) = chords else {
            return Ok(search.descended(here, Ended::Stalled, iteration));
        };
        let there = loop {
            let policy = Policy::new(&chords, shift * here.stiffness());
            let found = policy.and_then(|policy| follow(&mut search, &here, &policy));
            if found.is_some() || shift > last {
                break found;
            }
            shift = (factor * shift).max(first);
        };
        let Some(there) = there else {
            return Ok(search.descended(here, Ended::Stalled, iteration));
        };
        shift = if shift <= first { 0.0 } else { shift / factor };
        here = there;
    }
    unreachable!("a descent ends at its limit of steps")
}

/// Follows a policy, all the way or less, until the energy falls enough.
fn follow<const D: usize>(
    search: &mut Search<'_, D>,
    here: &Here<D>,
    policy: &Policy<D>,
) -> Option<Here<D>> {
    let step = policy.displacements();
    let mut scale = 1.0;
    while scale >= SHORTEST {
        let points = here.moved(&step, scale);
        // The quadratic model falls by (s − s²/2) times twice the decrease of the whole step.
        let promised = (2.0 * scale - scale * scale) * policy.decrease;
        if let Some(energy) = search.energy(&points)
            && here.falls_enough(energy, promised)
            && let Ok(sequence) = PointSequence::new(points)
        {
            // A positive energy does not yet mean that there is a metric.
            let there = search.at(sequence);
            if there.model.is_metric {
                return Some(there);
            }
        }
        scale *= 0.5;
    }
    None
}

/// The affine policy `δxₙ₊₁ = s kₙ + Kₙ δxₙ` for `n = 0, …, N − 2`.
pub(crate) struct Policy<const D: usize> {
    steps: Vec<SVector<f64, D>>,
    gains: Vec<SMatrix<f64, D, D>>,
    /// The decrease of the quadratic model, in `m²`.
    pub(crate) decrease: f64,
}

impl<const D: usize> Policy<D> {
    /// Goes backward over the chords; `None` if a control has no minimum. `shift` is added to the
    /// Hessian of each control.
    pub(crate) fn new(chords: &[ChordModel<D>], shift: f64) -> Option<Self> {
        let last = chords.last()?;
        // The model of the cost to go from a point: its gradient and Hessian.
        let (mut gradient, mut hessian) = (last.gradient[0], last.hessian[0]);
        let inner = chords.len() - 1;
        let mut steps = vec![SVector::zeros(); inner];
        let mut gains = vec![SMatrix::zeros(); inner];
        let mut decrease: f64 = 0.0;
        for (n, chord) in chords[..inner].iter().enumerate().rev() {
            let slope = chord.gradient[1] + gradient;
            let bend = chord.hessian[1] + hessian + SMatrix::identity() * shift;
            let bend = bend.cholesky()?;
            steps[n] = -bend.solve(&slope);
            gains[n] = -bend.solve(&chord.coupling.transpose());
            decrease -= 0.5 * slope.dot(&steps[n]);
            gradient = chord.gradient[0] + chord.coupling * steps[n];
            hessian = chord.hessian[0] + chord.coupling * gains[n];
        }
        decrease.is_finite().then_some(Self { steps, gains, decrease })
    }

    /// Follows the policy forward from the first point, and returns by how much each inner point
    /// moves for `s = 1`. All moves are proportional to `s`.
    pub(crate) fn displacements(&self) -> Vec<SVector<f64, D>> {
        let mut moved = SVector::zeros();
        let both = self.steps.iter().zip(&self.gains);
        both.map(|(step, gain)| {
            moved = step + gain * moved;
            moved
        })
        .collect()
    }
}

/// Returns the models of all chords.
fn chords<const D: usize>(
    metric: &dyn Batches<D>,
    nodes: &'static [Node],
    sequence: &PointSequence<D>,
    form: SecondOrder,
) -> Option<Vec<ChordModel<D>>> {
    match form {
        SecondOrder::Full => chord_models(metric, nodes, sequence),
        SecondOrder::GaussNewton => {
            // Each node is a sum of squares of its own.
            let mut sums: Vec<ChordModel<D>> = Vec::new();
            for own in nodes.chunks(1) {
                let of_node = chord_models(metric, own, sequence)?.into_iter();
                let of_node = of_node.map(|model| gauss_newton(model, own[0].fraction));
                if sums.is_empty() {
                    sums = of_node.collect();
                } else {
                    sums.iter_mut().zip(of_node).for_each(|(sum, other)| add(sum, &other));
                }
            }
            Some(sums)
        }
    }
}

fn add<const D: usize>(sum: &mut ChordModel<D>, other: &ChordModel<D>) {
    sum.energy += other.energy;
    sum.trace += other.trace;
    for end in 0..2 {
        sum.gradient[end] += other.gradient[end];
        sum.hessian[end] += other.hessian[end];
    }
    sum.coupling += other.coupling;
}

/// Replaces the second derivatives of a chord with one node at the fraction `θ` by those of Gauss
/// and Newton.
///
/// With `P` and `Q` of [`ChordModel`], the sum of all four blocks is `N w Q`, and a translation of
/// the chord changes its gradient at the far end by `N w (2Pᵀ + θ Q)`; what is left of the block
/// there is `2H`. Let `S = PᵀH⁻¹P/2`. As `2 (∂r/∂d)ᵀ(∂r/∂m) = P` and `2 (∂r/∂m)ᵀ(∂r/∂m) = S` for the
/// node `m`, the products of first derivatives are
///
/// ```text
/// near: 2H − (1−θ)(P + Pᵀ) + (1−θ)² S,   far: 2H + θ(P + Pᵀ) + θ² S,
/// near and far: −2H − θP + (1−θ)Pᵀ + θ(1−θ) S
/// ```
fn gauss_newton<const D: usize>(model: ChordModel<D>, theta: f64) -> ChordModel<D> {
    let ChordModel { hessian: [near, far], coupling, .. } = model;
    let bend = near + far + coupling + coupling.transpose();
    let turn = ((far + coupling - bend * theta) * 0.5).transpose();
    let both = turn + turn.transpose();
    let gram2 = far - both * (2.0 * theta) - bend * (theta * theta);
    // H is positive definite at the nodes of every iterate; S = Pᵀ (2H)⁻¹ P.
    let Some(factor) = gram2.cholesky() else { return model };
    let square = turn.tr_mul(&factor.solve(&turn));
    let rest = 1.0 - theta;
    ChordModel {
        hessian: [
            gram2 - both * rest + square * (rest * rest),
            gram2 + both * theta + square * (theta * theta),
        ],
        coupling: turn.transpose() * rest - gram2 - turn * theta + square * (theta * rest),
        ..model
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, vector};
    use tautline::gallery::Valleys;
    use tautline::{PointSequence, Prepared, Rule};

    use super::{SecondOrder, chords};

    /// For `H = φ² I` the residual is `r = φ(m) d`, with the derivatives `φ` in `d` and `d ∇φᵀ` in
    /// `m`. In the metric of the valleys, `φ = 2 − cos x₁`.
    #[test]
    fn gauss_newton_blocks_are_products_of_first_derivatives() {
        fn compare(rule: Rule) {
            let points = vec![vector![0.2, 0.1], vector![1.1, -0.4], vector![1.5, 0.9]];
            let sequence = PointSequence::new(points).expect("finite");
            let metric = Prepared::new(Valleys);
            let full = chords::<2>(&metric, rule.nodes(), &sequence, SecondOrder::Full);
            let full = full.expect("a metric");
            let found = chords::<2>(&metric, rule.nodes(), &sequence, SecondOrder::GaussNewton);
            let found = found.expect("a metric");
            for (k, (x, d)) in sequence.chords().enumerate() {
                let mut blocks = [SMatrix::<f64, 2, 2>::zeros(); 3];
                for node in rule.nodes() {
                    let m = x + d * node.fraction;
                    let phi = SMatrix::<f64, 2, 2>::identity() * (2.0 - m[0].cos());
                    let turn = d * vector![m[0].sin(), 0.0].transpose();
                    let near = turn * (1.0 - node.fraction) - phi;
                    let far = turn * node.fraction + phi;
                    // Two chords: the energy has the factor 2, and its second derivative another.
                    let factor = 4.0 * node.weight;
                    blocks[0] += near.tr_mul(&near) * factor;
                    blocks[1] += far.tr_mul(&far) * factor;
                    blocks[2] += near.tr_mul(&far) * factor;
                }
                let [near, far] = found[k].hessian;
                for (one, other) in [near, far, found[k].coupling].iter().zip(&blocks) {
                    // Entries of size 100 and about twenty operations.
                    assert!((one - other).amax() < 1e-12, "{one} {other}");
                }
                // The slopes are those of the energy, and the bends are not.
                assert!((found[k].gradient[0] - full[k].gradient[0]).amax() < 1e-12);
                assert!((near - full[k].hessian[0]).amax() > 0.01);
            }
        }
        compare(Rule::TRAPEZOIDAL);
        compare(Rule::LEFT_ENDPOINT);
        compare(Rule::TRUE_TRAPEZOID);
    }
}
