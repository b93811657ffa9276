//! The largest value of a function on a domain, by branch and bound.

#[cfg(test)]
mod tests;

use std::{cmp::Ordering, collections::BinaryHeap};

use nalgebra::SVector;
use rayon::prelude::*;

use crate::{Accuracy, Cell, Domain};

/// A function on `R^D` that can be bounded on a box.
pub(crate) trait Bounded<const D: usize>: Sync {
    /// Returns a bound on the function that holds on the whole box.
    fn bound(&self, cell: &Cell<D>) -> Bound;

    /// Returns the value at a point, up to rounding, or NaN if it overflows or is undefined.
    fn value(&self, x: &SVector<f64, D>) -> f64;

    /// Returns the value, up to rounding, of the function whose maximum is wanted. It never exceeds
    /// [`value`](Bounded::value), but may be smaller.
    fn wanted(&self, x: &SVector<f64, D>) -> f64 {
        self.value(x)
    }

    /// Returns whether the value at this point makes the search pointless.
    fn is_refuted(&self, x: &SVector<f64, D>, value: f64) -> bool;
}

/// A bound on a function on a box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    /// The upper bound: no value on the box exceeds it. `∞` or NaN if there is no bound.
    pub(crate) upper: f64,
    /// The coordinate across which it is best to cut the box.
    pub(crate) cut: usize,
}

/// The result of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Maximum<const D: usize> {
    /// A proved upper bound: no value on the domain exceeds it.
    pub(crate) upper: f64,
    /// The point with the largest wanted value found, in `ℓ`; `None` if the function had no value
    /// at any point tried.
    pub(crate) at: Option<SVector<f64, D>>,
    /// The point where the function was refuted and the search ended, in `ℓ`.
    pub(crate) refuted: Option<SVector<f64, D>>,
    /// The number of boxes on which the function was bounded.
    pub(crate) boxes: usize,
    /// Whether the upper bound is within the tolerance of the largest value found.
    pub(crate) reached: bool,
}

/// How many boxes are cut at once. The number is fixed, so that the number of threads does not
/// change the search.
const BATCH: usize = 64;

/// A box to be cut.
struct Open<const D: usize> {
    upper: f64,
    cut: usize,
    cell: Cell<D>,
    /// Among boxes with the same bound, the oldest is cut first.
    age: usize,
}

/// Returns an upper bound on the largest value on the domain.
///
/// The boxes with the largest bounds are cut first, many at a time and in parallel, until the
/// largest bound is at most the best value found at a point, up to the tolerance. The result does
/// not depend on the number of threads.
///
/// A box is dropped if its bound is at most the best value. The best value is rounded and may be
/// too large. The search therefore returns the larger of the best value and the largest remaining
/// bound, which holds on the dropped boxes as well as on the others.
pub(crate) fn maximise<const D: usize>(
    function: &dyn Bounded<D>,
    domain: &Domain<D>,
    accuracy: Accuracy,
) -> Maximum<D> {
    let mut search = Search::default();
    let mut found =
        Maximum { upper: f64::INFINITY, at: None, refuted: None, boxes: 0, reached: false };
    // The boxes to bound next, and an upper bound that holds on all of them.
    let (mut next, mut unseen) = (vec![*domain.bounding_cell()], f64::INFINITY);
    while !next.is_empty() && found.boxes + next.len() <= accuracy.budget {
        let looked_at: Vec<_> = next
            .par_drain(..)
            .filter(|cell| !domain.misses(cell))
            .map(|cell| {
                let point = domain.point_in(&cell);
                (cell, function.bound(&cell), point.map(|x| (x, function.value(&x))))
            })
            .collect();
        for (cell, bound, value) in looked_at {
            found.boxes += 1;
            if let Some((x, value)) = value {
                if function.is_refuted(&x, value) {
                    found.refuted = Some(x);
                    return found;
                }
                search.meet(x, value, function);
            }
            search.keep(cell, bound, found.boxes);
        }
        (next, unseen) = search.cut(accuracy.tolerance);
    }
    found.at = search.at;
    found.upper = search.upper().max(if next.is_empty() { f64::NEG_INFINITY } else { unseen });
    found.reached = found.upper <= search.goal(accuracy.tolerance);
    found
}

/// The state of a search.
struct Search<const D: usize> {
    open: BinaryHeap<Open<D>>,
    /// The largest values found so far.
    best: f64,
    wanted: f64,
    at: Option<SVector<f64, D>>,
    /// An upper bound that holds on the boxes too small to be cut.
    stuck: f64,
}

impl<const D: usize> Default for Search<D> {
    fn default() -> Self {
        let none = f64::NEG_INFINITY;
        Self { open: BinaryHeap::new(), best: none, wanted: none, at: None, stuck: none }
    }
}

impl<const D: usize> Search<D> {
    /// Records a value; ignores NaN.
    fn meet(&mut self, x: SVector<f64, D>, value: f64, function: &dyn Bounded<D>) {
        self.best = self.best.max(value);
        if value > self.wanted {
            let wanted = function.wanted(&x);
            if wanted > self.wanted {
                (self.wanted, self.at) = (wanted, Some(x));
            }
        }
    }

    /// Keeps a box unless its bound is at most the best value. NaN counts as no bound, so the box
    /// stays.
    fn keep(&mut self, cell: Cell<D>, bound: Bound, age: usize) {
        let upper = if bound.upper.is_nan() { f64::INFINITY } else { bound.upper };
        if !(upper <= self.best) {
            self.open.push(Open { upper, cut: bound.cut, cell, age });
        }
    }

    /// Boxes whose bounds exceed the goal are cut. Until there is a value, these are all boxes.
    fn goal(&self, tolerance: f64) -> f64 {
        // −∞ + ∞ would be NaN, which no bound exceeds.
        if self.best == f64::NEG_INFINITY {
            return self.best;
        }
        self.best + tolerance * self.best.abs()
    }

    /// Cuts the boxes with the largest bounds, as long as these exceed the goal. Returns the halves
    /// and the largest of these bounds.
    fn cut(&mut self, tolerance: f64) -> (Vec<Cell<D>>, f64) {
        let goal = self.goal(tolerance);
        let (mut halves, mut upper) = (Vec::new(), f64::NEG_INFINITY);
        while halves.len() < 2 * BATCH && self.open.peek().is_some_and(|top| top.upper > goal) {
            let Some(top) = self.open.pop() else { break };
            match top.cell.halves(top.cut) {
                Some(two) => {
                    halves.extend(two);
                    upper = upper.max(top.upper);
                }
                None => self.stuck = self.stuck.max(top.upper),
            }
        }
        (halves, upper)
    }

    /// An upper bound on the function on the kept and the dropped boxes.
    fn upper(&self) -> f64 {
        let open = self.open.peek().map_or(f64::NEG_INFINITY, |top| top.upper);
        open.max(self.stuck).max(self.best)
    }
}

impl<const D: usize> Ord for Open<D> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.upper.total_cmp(&other.upper).then(other.age.cmp(&self.age))
    }
}

impl<const D: usize> PartialOrd for Open<D> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const D: usize> PartialEq for Open<D> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<const D: usize> Eq for Open<D> {}
