//! `Chain`: the chords of a point sequence, in the order in which they are eliminated from both
//! ends.

use nalgebra::SVector;
use tautline_discretizations::{ANY, ChordBatch, ChordModels, PointSequence};
use tautline_formula::Kind;
use tautline_metrics::Pair;
use tautline_sets::AnySet;

use crate::newton::{
    arithmetic::blocks::{Blocks, PivotMut},
    discrete_energy::DiscreteEnergy,
    end_frame::EndFrame,
    factorization::Regulariser,
    front::Front,
    pairs::{Kept, Rest, eliminate},
    residual::Scale,
    side::Side,
    twisted_factorization::{InLanes, Pairs, Pivots},
    two_threads::join,
};

/// A point sequence, together with what its elimination reads.
pub(crate) struct Chain<'a> {
    pub(crate) energy: &'a DiscreteEnergy<'a>,
    pub(crate) ends: [&'a dyn AnySet; 2],
    pub(crate) sequence: &'a PointSequence<ANY>,
    pub(crate) regulariser: Regulariser,
    /// The `τ` of the frames at the ends.
    pub(crate) tau: f64,
    pub(crate) scale: Scale,
}

/// Where both sides in lanes write: the pivots, and the right hand sides after elimination.
pub(crate) type MemoryOfPairs<'m, const D: usize> =
    Option<(&'m mut Pairs, &'m mut [SVector<f64, D>])>;

/// Where one side writes.
type MemoryOfSide<'m> = Option<(&'m mut Pivots, &'m mut [f64])>;

impl Chain<'_> {
    fn n(&self) -> usize {
        self.sequence.n().get()
    }

    fn dimension(&self) -> usize {
        self.sequence.dimension()
    }

    /// Returns the number of chords on each side. If `N` is odd, one more chord is in the middle.
    pub(crate) fn half(&self) -> usize {
        self.n() / 2
    }

    /// Returns the points from one to another.
    pub(crate) fn points(&self, from: usize, to: usize) -> &[f64] {
        let d = self.dimension();
        &self.sequence.coordinates()[from * d..(to + 1) * d]
    }

    /// Returns memory for the models of blocks of `chords` chords.
    pub(crate) fn batch(&self, chords: usize) -> ChordBatch<'_> {
        self.energy.batch(Kind::Contraction, self.n() as f64, chords)
    }

    /// Returns the coordinates at an end, given the gradient there.
    pub(crate) fn frame(&self, end: usize, gradient: &[f64]) -> EndFrame {
        let x = self.sequence.row(if end == 0 { 0 } else { self.n() });
        EndFrame::new(self.ends[end], x, gradient, self.tau)
    }

    /// Eliminates both sides, a block of each at a time. Returns the fronts and the frames of the ends;
    /// `None` if the Hessian is not positive definite.
    pub(crate) fn in_lanes<const D: usize>(
        &self,
        mut memory: MemoryOfPairs<'_, D>,
    ) -> Option<([Front<D>; 2], [Option<EndFrame>; 2])>
    where
        Pairs: InLanes<D>,
    {
        let (n, half) = (self.n(), self.half());
        let mut frames = [None, None];
        let mut both = Front::<D, Pair>::new(self.regulariser);
        let mut batch = self.batch(n);
        let room = batch.capacity() / 2;
        for begin in (0..half).step_by(room) {
            let end = (begin + room).min(half);
            batch.evaluate_facing(self.points(begin, end), self.points(n - end, n - begin));
            let models = batch.pairs();
            let mut kept = memory.as_mut().map(|(pivots, eliminated)| {
                let (first, last) = eliminated.split_at_mut(half);
                let from_the_end = last.len() - end..last.len() - begin;
                Kept {
                    pivots: &mut pivots.pivots_mut()[begin..end],
                    first: &mut first[begin..end],
                    last: &mut last[from_the_end],
                }
            });
            let mut pairs = 0..end - begin;
            if begin == 0 {
                let mut ahead = both.add(&models.model(0), self.regulariser);
                let fronts = both.apart();
                let [first, last] =
                    [0, 1].map(|end| self.frame(end, fronts[end].row.gradient.as_slice()));
                both.enter([&first, &last], &mut ahead, self.tau);
                frames = [Some(first), Some(last)];
                let (pivot, z) = both.advance(ahead)?;
                if let Some(kept) = &mut kept {
                    kept.keep(0, pivot, &z);
                }
                // The points of the first pair are the ends, which are already eliminated.
                pairs.start = 1;
            }
            let rest = Rest { regulariser: self.regulariser, scale: self.scale };
            let instructions = self.energy.instruction_set();
            both = eliminate(instructions, &models, pairs, both, rest, kept)?;
        }
        both.is_metric = batch.is_metric;
        Some((both.apart(), frames))
    }

    /// Eliminates one side after the other, or both `at_once`. Returns the sides and the frames of the
    /// ends; `None` if the Hessian is not positive definite.
    pub(crate) fn in_turn<B: Blocks>(
        &self,
        blocks: B,
        memory: Option<(&mut [Pivots; 2], &mut [f64])>,
        at_once: bool,
    ) -> Option<[(Side<B>, Option<EndFrame>); 2]> {
        let (half, d) = (self.half(), self.dimension());
        let [one, other] = match memory {
            Some(([one, other], eliminated)) => {
                let (first, last) = eliminated.split_at_mut((self.n() + 1 - half) * d);
                [Some((one, &mut first[..half * d])), Some((other, last))]
            }
            None => [None, None],
        };
        join(at_once, || self.side(blocks, 0, one), || self.side(blocks, 1, other))
    }

    /// Eliminates the side that begins at one end.
    fn side<B: Blocks>(
        &self,
        blocks: B,
        end: usize,
        mut memory: MemoryOfSide<'_>,
    ) -> Option<(Side<B>, Option<EndFrame>)> {
        let (n, half, d) = (self.n(), self.half(), blocks.dimension());
        let size = d * d;
        let (mut side, mut frame) = (Side::new(blocks, self.regulariser), None);
        // What is not kept is overwritten by the next pivot.
        let (mut pivot, mut eliminated) = (Pivots::default(), vec![0.0; d]);
        if memory.is_none() {
            pivot.resize(1, size);
        }
        let mut models = ChordModels::default();
        let mut batch = self.batch(half);
        let room = batch.capacity();
        for begin in (0..half).step_by(room) {
            let stop = (begin + room).min(half);
            if end == 0 {
                batch.evaluate(self.points(begin, stop));
            } else {
                batch.evaluate_reversed(self.points(n - stop, n - begin));
            }
            batch.assemble(end, stop - begin, &mut models);
            for k in begin..stop {
                side.add(&models, k - begin, self.regulariser);
                if k == 0 {
                    let frame = frame.insert(self.frame(end, side.gradient()));
                    side.enter(frame, self.tau);
                } else {
                    side.count(self.scale);
                }
                let (pivot, z): (PivotMut<'_>, &mut [f64]) = match &mut memory {
                    Some((pivots, eliminated)) => {
                        let place = if end == 0 { k } else { half - 1 - k };
                        (pivots.get_mut(k, size), &mut eliminated[place * d..][..d])
                    }
                    None => (pivot.get_mut(0, size), &mut eliminated),
                };
                if !side.advance(pivot, z) {
                    return None;
                }
            }
        }
        side.set_metric(batch.is_metric);
        Some((side, frame))
    }
}
