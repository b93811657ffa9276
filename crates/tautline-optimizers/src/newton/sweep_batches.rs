//! A sweep by batches.

use nalgebra::SVector;
use tautline_discretizations::{ChordBatch, ChordModel, Node, PointSequence};
use tautline_formula::Batches;
use tautline_metrics::Pair;
use tautline_sets::ClosedSet;

use crate::newton::{
    chain_of_batches::ChainOfBatches, factorization::Regulariser, magnitude::Magnitude,
    residual::Residual, rounding::margin, stationarity::Stationarity,
    sweep::{MemoryOfSweep, Sweep},
};

pub(crate) fn sweep_batches<const D: usize>(
    nodes: &'static [Node],
    metric: &dyn Batches<D>,
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
    let chain = ChainOfBatches { nodes, metric, ends, sequence, regulariser, tau, residual: &residual };
    let half = chain.half();
    if let Some((factorization, eliminated)) = &mut memory {
        let (pairs, on_each_side) =
            if const { ChordModel::<D, Pair>::PAYS } { (half, 0) } else { (0, half) };
        factorization.clear(pairs, on_each_side);
        eliminated.clear();
        eliminated.resize(count + 1, SVector::zeros());
    }
    let kept = memory.as_mut().map(|(pivots, eliminated)| (&mut **pivots, &mut eliminated[..]));
    let [one, other] = if const { ChordModel::<D, Pair>::PAYS } {
        chain.side_by_side(kept)?
    } else {
        chain.side_and_side(kept, at_once)?
    };
    let (mut front, mut frames, back) = (one.front, [one.frame, other.frame], other.front);
    if count > 2 * half {
        let (x, d) = sequence.chord(half);
        let mut batch = ChordBatch::new(metric, nodes, n);
        batch.see(0, std::iter::once((x, d)));
        let chord = batch.singles().model(0, |theta| theta);
        let mut ahead = front.add(&chord, regulariser);
        front.is_metric &= batch.is_metric;
        ahead.row.join(&back.row);
        if half > 0 {
            front.count(&residual);
        } else {
            // Both ends are at the one chord that there is.
            front.enter(frames[0].insert(chain.frame(0, &front.row.gradient)), &mut ahead, tau);
            ahead.enter(frames[1].insert(chain.frame(1, &ahead.row.gradient)), &mut front, tau);
        }
        let (pivot, z) = front.advance(ahead)?;
        if let Some((factorization, eliminated)) = &mut memory {
            factorization.middle = Some(pivot);
            eliminated[half] = z;
        }
    } else {
        // Both have come to the same point.
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
