//! `Chain`: the chords of a point sequence, in the order in which they are eliminated from both
//! ends.

use std::ops::Range;

use nalgebra::SVector;
use tautline_discretizations::{ChordBatch, PointSequence};
use tautline_formula::Kind;
use tautline_metrics::Pair;
use tautline_sets::ClosedSet;

use crate::newton::{
    discrete_energy::DiscreteEnergy,
    end_frame::EndFrame,
    factorization::{Pivot, Regulariser},
    front::Front,
    pairs::{Kept, Rest, eliminate},
    residual::Residual,
    twisted_factorization::TwistedFactorization,
    two_threads::join,
};

/// A point sequence, together with what its elimination reads.
pub(crate) struct Chain<'a, const D: usize> {
    pub(crate) energy: &'a DiscreteEnergy<'a, D>,
    pub(crate) ends: [&'a dyn ClosedSet<D>; 2],
    pub(crate) sequence: &'a PointSequence<D>,
    pub(crate) regulariser: Regulariser,
    /// The `τ` of the frames at the ends.
    pub(crate) tau: f64,
    pub(crate) residual: &'a Residual<D>,
}

/// The state of one side of an elimination.
pub(crate) struct Side<const D: usize> {
    pub(crate) front: Front<D>,
    /// The coordinates at the end of this side, once that end is eliminated.
    pub(crate) frame: Option<EndFrame<D>>,
}

/// Where both sides write: the factorisation, and the right hand sides after elimination.
pub(crate) type Memory<'m, const D: usize> =
    Option<(&'m mut TwistedFactorization<D>, &'m mut [SVector<f64, D>])>;

/// Where one side writes.
type MemoryOfSide<'m, const D: usize> = Option<(&'m mut Vec<Pivot<D>>, &'m mut [SVector<f64, D>])>;

impl<const D: usize> Chain<'_, D> {
    fn n(&self) -> usize {
        self.sequence.n().get()
    }

    /// Returns the number of chords on each side. If `N` is odd, one more chord is in the middle.
    pub(crate) fn half(&self) -> usize {
        self.n() / 2
    }

    /// Returns the indices of chords that are counted from an end.
    fn numbers(&self, end: usize, counted: Range<usize>) -> Range<usize> {
        if end == 0 { counted } else { self.n() - counted.end..self.n() - counted.start }
    }

    /// Returns memory for the models of blocks of `chords` chords.
    pub(crate) fn batch(&self, chords: usize) -> ChordBatch<'_, D> {
        self.energy.batch(Kind::Contraction, self.n() as f64, chords)
    }

    /// Returns the coordinates at an end, given the gradient there.
    pub(crate) fn frame(&self, end: usize, gradient: &SVector<f64, D>) -> EndFrame<D> {
        let x = if end == 0 { self.sequence.first() } else { self.sequence.last() };
        EndFrame::new(self.ends[end], x, gradient, self.tau)
    }

    /// Eliminates both sides, a block of each at a time. The result is `None` if the Hessian is not
    /// positive definite.
    pub(crate) fn in_lanes(&self, mut memory: Memory<'_, D>) -> Option<[Side<D>; 2]> {
        let mut frames = [None, None];
        let mut both = Front::<D, Pair>::new(self.regulariser);
        let mut batch = self.batch(self.n());
        let room = batch.capacity() / 2;
        for begin in (0..self.half()).step_by(room) {
            let end = (begin + room).min(self.half());
            let [first, last] = [0, 1].map(|side| self.numbers(side, begin..end));
            let pairs = self.sequence.chords_in(first).zip(self.sequence.chords_in(last).rev());
            batch.evaluate_facing(pairs.map(|(first, last)| [first, last]));
            let models = batch.pairs();
            let mut kept = memory.as_mut().map(|(factorization, eliminated)| {
                let (first, last) = eliminated.split_at_mut(self.half());
                let from_the_end = last.len() - end..last.len() - begin;
                Kept {
                    pivots: &mut factorization.pairs[begin..end],
                    first: &mut first[begin..end],
                    last: &mut last[from_the_end],
                }
            });
            let mut pairs = 0..end - begin;
            if begin == 0 {
                let mut ahead = both.add(&models.model(0), self.regulariser);
                let fronts = both.apart();
                let [first, last] = [0, 1].map(|end| self.frame(end, &fronts[end].row.gradient));
                both.enter([&first, &last], &mut ahead, self.tau);
                frames = [Some(first), Some(last)];
                let (pivot, z) = both.advance(ahead)?;
                if let Some(kept) = &mut kept {
                    kept.keep(0, pivot, &z);
                }
                // The points of the first pair are the ends, which are already eliminated.
                pairs.start = 1;
            }
            let rest = Rest { regulariser: self.regulariser, residual: self.residual };
            let instructions = self.energy.instruction_set();
            both = eliminate(instructions, &models, pairs, both, rest, kept)?;
        }
        both.is_metric = batch.is_metric;
        let [first, last] = frames;
        let [front, back] = both.apart();
        Some([Side { front, frame: first }, Side { front: back, frame: last }])
    }

    /// Eliminates one side after the other, or both `at_once`. The result is `None` if the Hessian
    /// is not positive definite.
    pub(crate) fn in_turn(&self, memory: Memory<'_, D>, at_once: bool) -> Option<[Side<D>; 2]> {
        let half = self.half();
        let [one, other] = match memory {
            Some((TwistedFactorization { sides: [one, other], .. }, eliminated)) => {
                let (first, last) = eliminated.split_at_mut(self.n() + 1 - half);
                [Some((one, &mut first[..half])), Some((other, last))]
            }
            None => [None, None],
        };
        join(at_once, || self.side(0, one), || self.side(1, other))
    }

    /// Eliminates the side that begins at one end.
    fn side(&self, end: usize, mut memory: MemoryOfSide<'_, D>) -> Option<Side<D>> {
        let half = self.half();
        let mut side = Side { front: Front::new(self.regulariser), frame: None };
        let Side { front, frame } = &mut side;
        let mut batch = self.batch(half);
        let room = batch.capacity();
        for begin in (0..half).step_by(room) {
            let stop = (begin + room).min(half);
            let chords = self.sequence.chords_in(self.numbers(end, begin..stop));
            if end == 0 {
                batch.evaluate_from(end, chords);
            } else {
                batch.evaluate_from(end, chords.rev());
            }
            let models = batch.singles();
            for k in begin..stop {
                let chord = models.model_from(end, k - begin);
                let mut ahead = front.add(&chord, self.regulariser);
                if k == 0 {
                    let frame = frame.insert(self.frame(end, &front.row.gradient));
                    front.enter(frame, &mut ahead, self.tau);
                } else {
                    front.count(self.residual);
                }
                let (pivot, z) = front.advance(ahead)?;
                if let Some((pivots, eliminated)) = &mut memory {
                    pivots.push(pivot);
                    eliminated[if end == 0 { k } else { half - 1 - k }] = z;
                }
            }
        }
        front.is_metric = batch.is_metric;
        Some(side)
    }
}
