//! `Sweep`: assembles and eliminates in one pass over the chords, from both ends.

use nalgebra::SVector;
use tautline_discretizations::{ANY, ChordModels, PointSequence};
use tautline_sets::AnySet;

use crate::newton::{
    arithmetic::blocks::{Blocks, PivotMut, with_blocks},
    arithmetic::small::Vector,
    chain::Chain,
    discrete_energy::DiscreteEnergy,
    end_frame::EndFrame,
    factorization::Regulariser,
    magnitude::Magnitude,
    residual::Residual,
    rounding::margin,
    side::Sums,
    stationarity::Stationarity,
    twisted_factorization::{InLanes, Pairs, Pivots, TwistedFactorization},
};

/// The result of one pass over the chords, for a positive definite Hessian.
#[derive(Clone, Debug)]
pub(crate) struct Sweep {
    pub(crate) stationarity: Stationarity,
    /// The coordinates in which the blocks of the ends are eliminated.
    pub(crate) frames: [EndFrame; 2],
    /// The `τ` of the frames.
    pub(crate) tau: f64,
}

/// Where a sweep writes, if it writes at all: the factorisation, and the right hand side after
/// elimination.
pub(crate) type MemoryOfSweep<'m> = Option<(&'m mut TwistedFactorization, &'m mut Vec<f64>)>;

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
pub(crate) fn sweep(
    energy: &DiscreteEnergy<'_>,
    ends: [&dyn AnySet; 2],
    sequence: &PointSequence<ANY>,
    about: Magnitude,
    at_once: bool,
    mut memory: MemoryOfSweep<'_>,
) -> Option<Sweep> {
    let (count, d) = (sequence.n().get(), sequence.dimension());
    let n = count as f64;
    let tau = about.tau(count);
    let regulariser = Regulariser { n, weight: -margin(count) * about.mean_gram };
    let mut residual = Residual::new(d, count, about);
    let scale = residual.scale();
    let chain = Chain { energy, ends, sequence, regulariser, tau, scale };
    if let Some((_, eliminated)) = &mut memory {
        eliminated.clear();
        eliminated.resize((count + 1) * d, 0.0);
    }
    let (sums, frames) = match d {
        1 => in_lanes::<1>(&chain, memory)?,
        2 => in_lanes::<2>(&chain, memory)?,
        3 => in_lanes::<3>(&chain, memory)?,
        _ => with_blocks!(d, blocks => in_turn(blocks, &chain, at_once, memory))?,
    };
    let frames = frames.map(|frame| frame.expect("there are chords at both ends"));
    residual.inner = sums.inner;
    residual.ends = frames.each_ref().map(|frame| frame.gradient.clone());
    let mean_gram = sums.trace / (n * n * d as f64);
    let magnitude = Magnitude { energy: sums.energy.value(), mean_gram };
    let (residual, residual_floor) = residual.value(ends, sequence, magnitude);
    let (decrement, is_metric) = (0.5 * sums.square, sums.is_metric);
    let stationarity = Stationarity { magnitude, is_metric, decrement, residual, residual_floor };
    Some(Sweep { stationarity, frames, tau })
}

/// Eliminates all blocks, those of both sides in the lanes of a register.
fn in_lanes<const D: usize>(
    chain: &Chain<'_>,
    mut memory: MemoryOfSweep<'_>,
) -> Option<(Sums, [Option<EndFrame>; 2])>
where
    Pairs: InLanes<D>,
{
    let (count, half, regulariser) = (chain.sequence.n().get(), chain.half(), chain.regulariser);
    if let Some((factorization, _)) = &mut memory {
        factorization.clear_pairs::<D>(half);
    }
    let mut memory = memory.map(|(factorization, eliminated)| {
        let eliminated: &mut [SVector<f64, D>] = bytemuck::cast_slice_mut(eliminated);
        (factorization, eliminated)
    });
    let kept = memory.as_mut().map(|(pivots, eliminated)| (&mut pivots.pairs, &mut **eliminated));
    let ([mut front, back], mut frames) = chain.in_lanes(kept)?;
    if count > 2 * half {
        let mut batch = chain.batch(1);
        batch.evaluate(chain.points(half, half + 1));
        let mut ahead = front.add(&batch.singles().model(0), regulariser);
        front.is_metric &= batch.is_metric;
        ahead.row.join(&back.row);
        if half > 0 {
            front.count(chain.scale);
        } else {
            // The only chord joins both ends.
            let tau = chain.tau;
            let frame = frames[0].insert(chain.frame(0, front.row.gradient.as_slice()));
            front.enter(frame, &mut ahead, tau);
            let frame = frames[1].insert(chain.frame(1, ahead.row.gradient.as_slice()));
            ahead.enter(frame, &mut front, tau);
        }
        let (pivot, z) = front.advance(ahead)?;
        if let Some((factorization, eliminated)) = &mut memory {
            factorization.keep_middle(&pivot);
            eliminated[half] = z;
        }
    } else {
        // Both sides have now reached the same point.
        front.row.join(&back.row);
    }
    front.add_sums(&back);
    if half > 0 {
        front.count(chain.scale);
    }
    let (last, z) = front.finish()?;
    if let Some((factorization, eliminated)) = memory {
        factorization.last.copy_from_slice(last.factors.as_slice());
        eliminated[count - half] = z;
    }
    let sums = Sums {
        energy: front.energy,
        trace: front.trace,
        square: front.square,
        inner: front.inner,
        is_metric: front.is_metric,
    };
    Some((sums, frames))
}

/// Eliminates all blocks, those of one side after those of the other or `at_once`.
fn in_turn(
    blocks: impl Blocks,
    chain: &Chain<'_>,
    at_once: bool,
    mut memory: MemoryOfSweep<'_>,
) -> Option<(Sums, [Option<EndFrame>; 2])> {
    let (count, half, d) = (chain.sequence.n().get(), chain.half(), blocks.dimension());
    if let Some((factorization, _)) = &mut memory {
        factorization.clear_sides(d, half);
    }
    let kept = memory.as_mut().map(|(pivots, z)| (&mut pivots.sides, &mut z[..]));
    let [(mut front, first), (back, last)] = chain.in_turn(blocks, kept, at_once)?;
    let mut frames = [first, last];
    let mut middle = Pivots::default();
    let mut z = Vector::from_elem(0.0, d);
    if count > 2 * half {
        let mut batch = chain.batch(1);
        batch.evaluate(chain.points(half, half + 1));
        let mut models = ChordModels::default();
        batch.assemble(0, 1, &mut models);
        front.add(&models, 0, chain.regulariser);
        front.set_metric(batch.is_metric);
        front.join_ahead(&back);
        if half > 0 {
            front.count(chain.scale);
        } else {
            // The only chord joins both ends.
            front.enter(frames[0].insert(chain.frame(0, front.gradient())), chain.tau);
            front.enter_ahead(frames[1].insert(chain.frame(1, front.gradient_ahead())), chain.tau);
        }
        middle.resize(1, d * d);
        let pivot: PivotMut<'_> = middle.get_mut(0, d * d);
        if !front.advance(pivot, &mut z) {
            return None;
        }
        if let Some((factorization, eliminated)) = &mut memory {
            factorization.middle = middle;
            eliminated[half * d..][..d].copy_from_slice(&z);
        }
    } else {
        front.join(&back);
    }
    front.add_sums(&back);
    if half > 0 {
        front.count(chain.scale);
    }
    let mut factors = vec![0.0; d * d];
    if !front.finish(&mut factors, &mut z) {
        return None;
    }
    if let Some((factorization, eliminated)) = memory {
        factorization.last = factors;
        eliminated[(count - half) * d..][..d].copy_from_slice(&z);
    }
    Some((*front.sums(), frames))
}
