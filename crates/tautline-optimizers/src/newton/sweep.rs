//! `Sweep`: a look at a point sequence, by elimination from both of its ends.

use nalgebra::SVector;
use tautline_discretizations::{ChordModel, PointSequence, Rule};
use tautline_metrics::{Lanes, Metric, Pair};
use tautline_sets::ClosedSet;

use crate::newton::{
    end_frame::EndFrame, factorization::Regulariser, front::Front, magnitude::Magnitude,
    residual::Residual, rounding::margin, stationarity::Stationarity,
    twisted_factorization::TwistedFactorization,
};

/// What one pass over the chords finds out where the Hessian is positive definite.
#[derive(Clone, Debug)]
pub(crate) struct Sweep<const D: usize> {
    pub(crate) stationarity: Stationarity,
    /// The coordinates of the ends in which their blocks are eliminated.
    pub(crate) frames: [EndFrame<D>; 2],
    /// That of the frames.
    pub(crate) tau: f64,
}

/// Sums up and eliminates in one pass; `None` if the Hessian, less the [`margin`], is not positive
/// definite or not finite.
///
/// From both ends towards the middle, two chords at a time; from four dimensions on, where that does
/// not pay, from the first chord to the last. Each block is eliminated as soon as the
/// chords on both sides of its point are known, so that neither gradient nor Hessian is ever stored.
/// The pivots and the right hand side after elimination, which is all that a Newton step needs, are
/// written to `memory`, if there is some. `about` is what is known of the magnitude beforehand: it
/// scales the margin and what is taken for a chord at the ends.
pub(crate) fn sweep<R: Rule, const D: usize>(
    rule: R,
    metric: &impl Metric<D>,
    ends: [&dyn ClosedSet<D>; 2],
    sequence: &PointSequence<D>,
    about: Magnitude,
    // Not a generic parameter: a formula is inlined here once for each kind of number, and would not
    // be twice.
    mut memory: Option<(&mut TwistedFactorization<D>, &mut Vec<SVector<f64, D>>)>,
) -> Option<Sweep<D>> {
    let count = sequence.n().get();
    let n = count as f64;
    let regulariser = Regulariser { n, weight: -margin(count) * about.mean_gram };
    let tau = about.tau(count);
    let frame = |end: usize, gradient: &SVector<f64, D>| {
        let x = if end == 0 { sequence.first() } else { sequence.last() };
        EndFrame::new(ends[end], x, gradient, tau)
    };
    let pairs = if const { ChordModel::<D, Pair>::PAYS } { count / 2 } else { 0 };
    if let Some((factorization, eliminated)) = &mut memory {
        factorization.clear(pairs, count - 2 * pairs);
        eliminated.clear();
        eliminated.resize(count + 1, SVector::zeros());
    }
    let mut residual = Residual::new(count, about);
    let mut frames = [None, None];
    let [mut front, mut back] = [Front::new(regulariser); 2];
    // Said twice, so that nothing is compiled where it does not pay.
    if const { ChordModel::<D, Pair>::PAYS } && pairs > 0 {
        let mut both = Front::<D, Pair>::new(regulariser);
        for k in 0..pairs {
            let chords = [sequence.chord(k), sequence.chord(count - 1 - k)];
            let chord = ChordModel::facing(rule, metric, chords, n);
            let mut ahead = both.add(&chord, regulariser);
            if k == 0 {
                let gradients = both.apart().map(|front| front.row.gradient);
                let [first, last] = [0, 1].map(|end| frame(end, &gradients[end]));
                both.enter([&first, &last], &mut ahead, tau);
                (residual.ends, frames) = (gradients, [Some(first), Some(last)]);
            } else {
                residual.push(&both.row.gradient);
            }
            let (pivot, z) = both.advance(ahead)?;
            if let Some((factorization, eliminated)) = &mut memory {
                factorization.pairs.push(pivot);
                eliminated[k] = z.map(|z| z.lane(0));
                eliminated[count - k] = z.map(|z| z.lane(1));
            }
        }
        [front, back] = both.apart();
    }
    for k in pairs..count - pairs {
        let (x, d) = sequence.chord(k);
        let mut ahead = front.add(&ChordModel::new(rule, metric, x, &d, n), regulariser);
        if k + 1 == count - pairs {
            ahead.row.join(&back.row);
        }
        if k == 0 {
            residual.ends[0] = front.row.gradient;
            front.enter(frames[0].insert(frame(0, &front.row.gradient)), &mut ahead, tau);
        } else {
            residual.push(&front.row.gradient);
        }
        if k + 1 == count {
            residual.ends[1] = ahead.row.gradient;
            ahead.enter(frames[1].insert(frame(1, &ahead.row.gradient)), &mut front, tau);
        }
        let (pivot, z) = front.advance(ahead)?;
        if let Some((factorization, eliminated)) = &mut memory {
            factorization.middle.push(pivot);
            eliminated[k] = z;
        }
    }
    if 2 * pairs == count {
        // Both have come to the same point.
        front.row.join(&back.row);
    }
    front.add_sums(&back);
    if pairs > 0 {
        residual.push(&front.row.gradient);
    }
    let (last, z) = front.finish()?;
    if let Some((factorization, eliminated)) = memory {
        factorization.last = Some(last);
        eliminated[count - pairs] = z;
    }
    let mean_gram = front.trace / (n * n * D as f64);
    let magnitude = Magnitude { energy: front.energy.value(), mean_gram };
    let (residual, residual_floor) = residual.value(ends, sequence, magnitude);
    let (decrement, is_metric) = (0.5 * front.square, front.is_metric);
    let stationarity = Stationarity { magnitude, is_metric, decrement, residual, residual_floor };
    let frames = frames.map(|frame| frame.expect("there are chords at both ends"));
    Some(Sweep { stationarity, frames, tau })
}
