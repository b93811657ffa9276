//! `Candidate`: a local minimiser that is followed from grid to grid.

use tautline_discretizations::{ANY, PointSequence, SequenceError};
use tautline_sets::AnySet;

use crate::{
    Curvature, Level, Minimum, Other, Stop,
    newton::discrete_energy::DiscreteEnergy,
    search::{
        local_search::Found,
        prolongation::{prolong, prolong_into},
    },
};

/// If the lowest energy rises by this factor from one grid to the next, the minimisers on the
/// coarser grid leapt over ridges that the finer one resolves. They need not lead to the lowest
/// minimiser on the finer grid, so the starts are tried again.
const LEAP: f64 = 1.5;

/// The points are extrapolated from at most this many grids, none of which is coarser than
/// `COARSE`.
const EXTRAPOLATED: usize = 3;
const COARSE: usize = 32;

/// Energies that differ by a larger fraction belong to different minima.
pub(crate) const DIFFERENT: f64 = 1e-9;

/// A local minimiser, the pieces between which it runs, and its energies on coarser grids.
#[derive(Clone)]
pub(crate) struct Candidate<'a> {
    pub(crate) ends: [&'a dyn AnySet; 2],
    pub(crate) found: Found,
    /// The sequences on coarser grids that are still needed; the finest is last.
    coarser: Vec<PointSequence<ANY>>,
    pub(crate) levels: Vec<Level>,
    /// The number of Newton steps so far.
    pub(crate) iterations: usize,
}

impl<'a> Candidate<'a> {
    pub(crate) fn new(ends: [&'a dyn AnySet; 2], found: Found) -> Self {
        let (levels, iterations) = (vec![level(&found)], found.iterations);
        Self { ends, levels, coarser: Vec::new(), iterations, found }
    }

    /// Moves on to the minimiser on the next grid. Also returns a coarser sequence that is no
    /// longer needed.
    pub(crate) fn refined(mut self, found: Found) -> (Self, Option<PointSequence<ANY>>) {
        self.levels.push(level(&found));
        self.iterations += found.iterations;
        self.coarser.push(std::mem::replace(&mut self.found, found).sequence);
        if self.leapt() {
            // The coarser sequences lead to another minimiser.
            self.coarser.clear();
        }
        let unused = self.coarser.len() >= EXTRAPOLATED;
        let unused = unused.then(|| self.coarser.remove(0));
        (self, unused)
    }

    /// Returns whether the minimiser on the coarser grid leapt, so that the energy has risen by
    /// [`LEAP`] since then.
    pub(crate) fn leapt(&self) -> bool {
        matches!(self.levels[..], [.., coarse, fine] if fine.energy > LEAP * coarse.energy)
    }

    /// Returns whether the energy differs from the energy on the coarser grid by at least this
    /// fraction. For NaN it does.
    pub(crate) fn has_changed_by(&self, fraction: f64) -> bool {
        let [.., coarse, fine] = self.levels[..] else { return false };
        !((fine.energy - coarse.energy).abs() < fraction * coarse.energy)
    }

    /// Returns the local minimiser as one besides the result, if it is one.
    pub(crate) fn into_other(self) -> Option<Other<ANY>> {
        let is_minimum = !self.failed() && self.found.curvature == Curvature::PositiveDefinite;
        let Found { sequence, energy, .. } = self.found;
        is_minimum.then_some(Other { sequence, energy })
    }

    /// Returns the result of the whole solve. `iterations` counts the steps of all searches.
    pub(crate) fn into_minimum(
        self,
        iterations: usize,
        local_minima: Vec<f64>,
        others: Vec<Other<ANY>>,
    ) -> Minimum<ANY> {
        let Self { found, levels, iterations: own_iterations, .. } = self;
        Minimum {
            sequence: found.sequence,
            energy: found.energy,
            decrement: found.decrement,
            residual: found.residual,
            residual_floor: found.residual_floor,
            stop: found.stop,
            curvature: found.curvature,
            iterations,
            own_iterations,
            levels,
            local_minima,
            others,
        }
    }

    pub(crate) fn failed(&self) -> bool {
        matches!(self.found.stop, Stop::Stalled | Stop::IterationLimit)
    }

    /// Returns where to start on the next grid, which has `n` chords.
    ///
    /// Like the energies, the points have an expansion `x_N = x + a N⁻ᑫ + b N⁻²ᑫ + …`, so that a
    /// polynomial in `N⁻ᑫ` through three grids predicts the fourth. On fine grids the remaining
    /// error is of the order of rounding, and no Newton step is needed.
    pub(crate) fn start(
        &self,
        n: usize,
        energy: &DiscreteEnergy<'_>,
        memory: Vec<f64>,
    ) -> Result<PointSequence<ANY>, SequenceError> {
        let (exponent, instruction_set) = (energy.error_exponent, energy.instruction_set());
        let sequence = &self.found.sequence;
        let dimension = sequence.dimension();
        let here = sequence.n().get();
        let fine_enough = |coarser: &&PointSequence<ANY>| coarser.n().get() >= COARSE;
        let coarser: Vec<_> = self.coarser.iter().filter(fine_enough).collect();
        if coarser.is_empty() {
            let points = prolong_into(sequence, n, instruction_set, memory);
            return PointSequence::from_coordinates(dimension, points);
        }
        let power = |n: usize| (n as f64).powi(-exponent);
        // These are the weights of Lagrange interpolation in N⁻ᑫ.
        let grids: Vec<_> = coarser.iter().map(|c| c.n().get()).chain([here]).map(power).collect();
        let weight = |own: usize| {
            let others = grids.iter().enumerate().filter(|(other, _)| *other != own);
            others.map(|(_, h)| (power(n) - h) / (grids[own] - h)).product::<f64>()
        };
        let mut points = sequence.coordinates().to_vec();
        for (own, coarser) in coarser.into_iter().enumerate() {
            let weight = weight(own);
            let before = prolong(coarser, here);
            let with = points.iter_mut().zip(sequence.coordinates()).zip(&before);
            with.for_each(|((point, x), y)| *point += (y - x) * weight);
        }
        self.ends[0].project(&mut points[..dimension]);
        self.ends[1].project(&mut points[here * dimension..]);
        let sequence = PointSequence::from_coordinates(dimension, points)?;
        let points = prolong_into(&sequence, n, instruction_set, memory);
        PointSequence::from_coordinates(dimension, points)
    }
}

fn level(found: &Found) -> Level {
    Level { n: found.sequence.n().get(), energy: found.energy }
}

/// Returns the indices that sort the keys stably.
pub(crate) fn by_key(keys: &[(bool, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..keys.len()).collect();
    order.sort_by(|&a, &b| keys[a].0.cmp(&keys[b].0).then(keys[a].1.total_cmp(&keys[b].1)));
    order
}

/// Sorts by energy, and merges candidates whose energies agree to `10⁻⁹`. Of two such candidates,
/// the one with more grids to extrapolate from stays, or else the lower one. Searches that did not
/// converge come last, since their energy is not the energy of a minimiser.
///
/// Returns the candidates that were merged although they are other curves, such as mirror images.
pub(crate) fn lowest_first<'a>(candidates: &mut Vec<Candidate<'a>>) -> Vec<Candidate<'a>> {
    let keys: Vec<_> = candidates.iter().map(|c| (c.failed(), c.found.energy)).collect();
    let order = by_key(&keys);
    let mut unsorted: Vec<_> = candidates.drain(..).map(Some).collect();
    let mut ties = Vec::new();
    for mut candidate in order.into_iter().filter_map(|place| unsorted[place].take()) {
        let kept = candidates.last_mut().filter(|kept| {
            kept.failed() == candidate.failed()
                && (candidate.found.energy - kept.found.energy).abs()
                    <= DIFFERENT * kept.found.energy.abs()
        });
        let Some(kept) = kept else {
            candidates.push(candidate);
            continue;
        };
        if candidate.coarser.len() > kept.coarser.len() {
            std::mem::swap(kept, &mut candidate);
        }
        if are_apart(&candidate.found.sequence, &kept.found.sequence) {
            ties.push(candidate);
        }
    }
    ties
}

/// Two curves are different if, at some time, they are apart by this fraction of the extent of one
/// of them.
const APART: f64 = 0.02;

/// Returns whether two sequences, on whatever grids, run along different curves: at some time they
/// are apart by 2 % of the extent of the first.
#[must_use]
pub fn are_apart<const D: usize>(a: &PointSequence<D>, b: &PointSequence<D>) -> bool {
    let amax =
        |gaps: &mut dyn Iterator<Item = f64>| gaps.fold(0.0, |most: f64, x| most.max(x.abs()));
    let first = a.row(0);
    let rows = || a.coordinates().chunks_exact(first.len());
    let from_first = |x: &[f64]| amax(&mut x.iter().zip(first).map(|(x, y)| x - y));
    let extent = rows().map(from_first).fold(0.0, f64::max);
    let [n, m] = [a, b].map(|sequence| sequence.n().get());
    let off = |(i, x): (usize, &[f64])| {
        // The point of the other curve at the same time.
        let position = i as f64 / n as f64 * m as f64;
        let k = (position as usize).min(m - 1);
        let s = position - k as f64;
        let other = b.row(k).iter().zip(b.row(k + 1)).map(|(y, z)| y * (1.0 - s) + z * s);
        amax(&mut other.zip(x).map(|(y, x)| y - x))
    };
    rows().enumerate().map(off).any(|off| off > APART * extent)
}

#[cfg(test)]
mod tests;
