//! `Sweep`: assembles and eliminates in one pass over the chords, from both ends.

use nalgebra::SVector;
use tautline_discretizations::PointSequence;
use tautline_sets::ClosedSet;

use crate::newton::{
    chain::Chain, discrete_energy::DiscreteEnergy, end_frame::EndFrame, factorization::Regulariser,
    magnitude::Magnitude, residual::Residual, rounding::margin, stationarity::Stationarity,
    twisted_factorization::TwistedFactorization, two_threads::goes_in_lanes,
};

/// The result of one pass over the chords, for a positive definite Hessian.
#[derive(Clone, Debug)]
pub(crate) struct Sweep<const D: usize> {
    pub(crate) stationarity: Stationarity,
    /// The coordinates in which the blocks of the ends are eliminated.
    pub(crate) frames: [EndFrame<D>; 2],
    /// The `τ` of the frames.
    pub(crate) tau: f64,
}

/// Where a sweep writes, if it writes at all: the factorisation, and the right hand side after
/// elimination.
pub(crate) type MemoryOfSweep<'m, const D: usize> =
    Option<(&'m mut TwistedFactorization<D>, &'m mut Vec<SVector<f64, D>>)>;

/// Assembles and eliminates in one pass. The result is `None` if the Hessian, less the [`margin`],
/// is not positive definite and finite.
///
/// The pass runs from both ends towards the middle. It eliminates each block as soon as the chords
/// on both sides of its point are known, and never stores a gradient or a Hessian. A Newton step
/// needs only the pivots and the right hand side after elimination; they are written to `memory` if
/// it is given. `about` estimates the magnitude, which scales the margin and the frames of the
/// ends.
///
/// Up to three dimensions the two sides [share the lanes of a register](goes_in_lanes). From four
/// dimensions on they are eliminated one after the other, or `at_once` on two threads, and the
/// result has the same bits.
pub(crate) fn sweep<const D: usize>(
    energy: &DiscreteEnergy<'_, D>,
    ends: [&dyn ClosedSet<D>; 2],
    sequence: &PointSequence<D>,
    about: Magnitude,
    at_once: bool,
    mut memory: MemoryOfSweep<'_, D>,
) -> Option<Sweep<D>> {
    let count = sequence.n().get();
    let n = count as f64;
    let tau = about.tau(count);
    let regulariser = Regulariser { n, weight: -margin(count) * about.mean_gram };
    let mut residual = Residual::new(count, about);
    let chain = Chain { energy, ends, sequence, regulariser, tau, residual: &residual };
    let half = chain.half();
    if let Some((factorization, eliminated)) = &mut memory {
        let (pairs, on_each_side) = if const { goes_in_lanes(D) } { (half, 0) } else { (0, half) };
        factorization.clear(pairs, on_each_side);
        eliminated.clear();
        eliminated.resize(count + 1, SVector::zeros());
    }
    let kept = memory.as_mut().map(|(pivots, eliminated)| (&mut **pivots, &mut eliminated[..]));
    let [one, other] = if const { goes_in_lanes(D) } {
        chain.in_lanes(kept)?
    } else {
        chain.in_turn(kept, at_once)?
    };
    let (mut front, mut frames, back) = (one.front, [one.frame, other.frame], other.front);
    if count > 2 * half {
        let (x, d) = sequence.chord(half);
        let mut batch = chain.batch(1);
        batch.evaluate_from(0, std::iter::once((x, d)));
        let mut ahead = front.add(&batch.singles().model(0), regulariser);
        front.is_metric &= batch.is_metric;
        ahead.row.join(&back.row);
        if half > 0 {
            front.count(&residual);
        } else {
            // The only chord joins both ends.
            front.enter(frames[0].insert(chain.frame(0, &front.row.gradient)), &mut ahead, tau);
            ahead.enter(frames[1].insert(chain.frame(1, &ahead.row.gradient)), &mut front, tau);
        }
        let (pivot, z) = front.advance(ahead)?;
        if let Some((factorization, eliminated)) = &mut memory {
            factorization.middle = Some(pivot);
            eliminated[half] = z;
        }
    } else {
        // Both sides have now reached the same point.
        front.row.join(&back.row);
    }
    front.add_sums(&back);
    if half > 0 {
        front.count(&residual);
    }
    let (last, z) = front.finish()?;
    if let Some((factorization, eliminated)) = memory {
        factorization.last = Some(last);
        eliminated[count - half] = z;
    }
    let frames = frames.map(|frame| frame.expect("there are chords at both ends"));
    residual.inner = front.inner;
    residual.ends = frames.each_ref().map(|frame| frame.gradient);
    let mean_gram = front.trace / (n * n * D as f64);
    let magnitude = Magnitude { energy: front.energy.value(), mean_gram };
    let (residual, residual_floor) = residual.value(ends, sequence, magnitude);
    let (decrement, is_metric) = (0.5 * front.square, front.is_metric);
    let stationarity = Stationarity { magnitude, is_metric, decrement, residual, residual_floor };
    Some(Sweep { stationarity, frames, tau })
}
