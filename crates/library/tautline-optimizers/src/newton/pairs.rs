//! The inner loop of an elimination from both ends, over pairs of chords with one from each side.

use std::ops::Range;

use nalgebra::SVector;
use tautline_discretizations::Contractions;
use tautline_formula::InstructionSet;
use tautline_metrics::{Lanes, Pair};

use crate::newton::{
    factorization::{Pivot, Regulariser},
    front::Front,
    residual::Scale,
};

/// What an elimination needs in addition to the pairs of chords.
#[derive(Clone, Copy)]
pub(crate) struct Rest {
    pub(crate) regulariser: Regulariser,
    pub(crate) scale: Scale,
}

/// Memory for the pivots of some pairs and for the right hand sides after elimination. The right
/// hand sides of the last side are stored from back to front.
pub(crate) struct Kept<'m, const D: usize> {
    pub(crate) pivots: &'m mut [Pivot<D, Pair>],
    pub(crate) first: &'m mut [SVector<f64, D>],
    pub(crate) last: &'m mut [SVector<f64, D>],
}

impl<const D: usize> Kept<'_, D> {
    #[inline(always)]
    pub(crate) fn keep(&mut self, k: usize, pivot: Pivot<D, Pair>, z: &SVector<Pair, D>) {
        self.pivots[k] = pivot;
        self.first[k] = z.map(|z| z.lane(0));
        let from_the_end = self.last.len() - 1 - k;
        self.last[from_the_end] = z.map(|z| z.lane(1));
    }
}

/// Eliminates the inner points of `pairs`, where `front` is at the first of them, and returns the
/// front behind the last. The result is `None` if the Hessian is not positive definite.
pub(crate) fn eliminate<const D: usize>(
    instruction_set: InstructionSet,
    models: &Contractions<'_, Pair, D>,
    pairs: Range<usize>,
    front: Front<D, Pair>,
    rest: Rest,
    kept: Option<Kept<'_, D>>,
) -> Option<Front<D, Pair>> {
    let keeps = kept.is_some();
    let kept = kept.unwrap_or(Kept { pivots: &mut [], first: &mut [], last: &mut [] });
    let run = match (instruction_set, models.is_midpoint(), keeps) {
        (InstructionSet::Baseline, false, false) => baseline::<false, false, D>,
        (InstructionSet::Baseline, false, true) => baseline::<false, true, D>,
        (InstructionSet::Baseline, true, false) => baseline::<true, false, D>,
        (InstructionSet::Baseline, true, true) => baseline::<true, true, D>,
        (InstructionSet::Widest, false, false) => widest::<false, false, D>,
        (InstructionSet::Widest, false, true) => widest::<false, true, D>,
        (InstructionSet::Widest, true, false) => widest::<true, false, D>,
        (InstructionSet::Widest, true, true) => widest::<true, true, D>,
    };
    run(models, pairs, front, rest, kept)
}

#[inline(never)]
fn baseline<const MIDPOINT: bool, const KEEPS: bool, const D: usize>(
    models: &Contractions<'_, Pair, D>,
    pairs: Range<usize>,
    front: Front<D, Pair>,
    rest: Rest,
    kept: Kept<'_, D>,
) -> Option<Front<D, Pair>> {
    inline::<MIDPOINT, KEEPS, D>(models, pairs, front, rest, kept)
}

/// AVX instructions write to a third register, so operands need no copies.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn widest<const MIDPOINT: bool, const KEEPS: bool, const D: usize>(
    models: &Contractions<'_, Pair, D>,
    pairs: Range<usize>,
    front: Front<D, Pair>,
    rest: Rest,
    kept: Kept<'_, D>,
) -> Option<Front<D, Pair>> {
    inline::<MIDPOINT, KEEPS, D>(models, pairs, front, rest, kept)
}

/// The loop does nothing else and calls nothing, so that the front stays in registers.
#[inline(always)]
fn inline<const MIDPOINT: bool, const KEEPS: bool, const D: usize>(
    models: &Contractions<'_, Pair, D>,
    pairs: Range<usize>,
    mut front: Front<D, Pair>,
    rest: Rest,
    mut kept: Kept<'_, D>,
) -> Option<Front<D, Pair>> {
    let Rest { regulariser, scale } = rest;
    let models = models.first(pairs.end);
    for k in pairs {
        let model = if MIDPOINT { models.model_at_midpoint(k) } else { models.model(k) };
        let ahead = front.add(&model, regulariser);
        front.count(scale);
        let (pivot, z) = front.advance(ahead)?;
        if KEEPS {
            kept.keep(k, pivot, &z);
        }
    }
    Some(front)
}
