//! The largest value of a function on a domain, by branch and bound.

#[cfg(test)]
mod tests;

use std::{cmp::Ordering, collections::BinaryHeap};

use rayon::prelude::*;

use crate::{
    Accuracy,
    patch::{Patch, Point, Region},
};

/// A function that can be bounded on a box.
pub(crate) trait Bounded: Sync {
    /// Returns a bound on the function that holds on the whole box.
    fn bound(&self, patch: &Patch) -> Bound;

    /// Returns the value at a point, up to rounding, or NaN if it overflows or is undefined.
    fn value(&self, x: &Point) -> f64;

    /// Returns the value, up to rounding, of the function whose maximum is wanted. It never exceeds
    /// [`value`](Bounded::value), but may be smaller.
    fn wanted(&self, x: &Point) -> f64 {
        self.value(x)
    }

    /// Returns whether the value at this point makes the search pointless.
    fn is_refuted(&self, x: &Point, value: f64) -> bool;
}

/// A bound on a function on a box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    /// The upper bound: no value on the box exceeds it. `∞` or NaN if there is no bound.
    pub(crate) upper: f64,
    /// The side across which it is best to cut the box.
    pub(crate) cut: usize,
    /// The value at the midpoint, up to rounding; NaN as for [`Bounded::value`].
    pub(crate) middle: f64,
}

/// The result of a search.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Maximum {
    /// A proved upper bound: no value on the domain exceeds it.
    pub(crate) upper: f64,
    /// The point with the largest wanted value found; `None` if the function had no value at any
    /// point tried.
    pub(crate) at: Option<Point>,
    /// The point where the function was refuted and the search ended.
    pub(crate) refuted: Option<Point>,
    /// The number of boxes on which the function was bounded.
    pub(crate) boxes: usize,
    /// Whether the upper bound is within the tolerance of the largest value found.
    pub(crate) reached: bool,
}

/// How many boxes are cut at once. The number is fixed, so that the number of threads does not
/// change the search.
const BATCH: usize = 64;

/// How many boxes are looked at, in more than six dimensions, before the search may be ended. Each takes
/// milliseconds to seconds there.
const DEAR_BATCH: usize = 4;

/// A box to be cut.
struct Open {
    upper: f64,
    cut: usize,
    patch: Patch,
    /// Among boxes with the same bound, the oldest is cut first.
    age: usize,
}

/// Returns an upper bound on the largest value on the region.
///
/// The boxes with the largest bounds are cut first, many at a time and in parallel, until the
/// largest bound is at most the best value found at a point, up to the tolerance. The result does
/// not depend on the number of threads.
///
/// A box is dropped if its bound is at most the best value. The best value is rounded and may be
/// too large. The search therefore returns the larger of the best value and the largest remaining
/// bound, which holds on the dropped boxes as well as on the others.
///
/// After each round, and within it in many dimensions, `goes_on` is told the number of boxes and the two bounds so far, the best value
/// and the upper one. If it returns false, the search ends as if the budget was spent.
pub(crate) fn maximise(
    function: &dyn Bounded,
    region: &dyn Region,
    accuracy: Accuracy,
    goes_on: &mut dyn FnMut(usize, f64, f64) -> bool,
) -> Maximum {
    let mut search = Search::default();
    let mut found =
        Maximum { upper: f64::INFINITY, at: None, refuted: None, boxes: 0, reached: false };
    // The boxes to bound next, and an upper bound that holds on all of them.
    let (mut next, mut unseen) = (region.patches(), f64::INFINITY);
    'search: while !next.is_empty() && found.boxes + next.len() <= accuracy.budget {
        while let Some(first) = next.first() {
            let at_once = if first.middle().at.len() > 6 { DEAR_BATCH } else { next.len() };
            let later = next.split_off(at_once.min(next.len()));
            let looked_at: Vec<_> = next
                .par_drain(..)
                .filter(|patch| !region.misses(patch))
                .map(|patch| {
                    let bound = function.bound(&patch);
                    let value = region.point_in(&patch).map(|x| {
                        let value =
                            if x == patch.middle() { bound.middle } else { function.value(&x) };
                        (x, value)
                    });
                    (patch, bound, value)
                })
                .collect();
            for (patch, bound, value) in looked_at {
                found.boxes += 1;
                if let Some((x, value)) = value {
                    if function.is_refuted(&x, value) {
                        found.refuted = Some(x);
                        return found;
                    }
                    search.meet(x, value, function);
                }
                search.keep(patch, bound, found.boxes);
            }
            next = later;
            if !next.is_empty() && !goes_on(found.boxes, search.wanted, search.upper().max(unseen))
            {
                break 'search;
            }
        }
        (next, unseen) = search.cut(accuracy.tolerance);
        if !next.is_empty() && !goes_on(found.boxes, search.wanted, search.upper().max(unseen)) {
            break;
        }
    }
    found.upper = search.upper().max(if next.is_empty() { f64::NEG_INFINITY } else { unseen });
    found.reached = found.upper <= search.goal(accuracy.tolerance);
    found.at = search.at;
    found
}

/// The state of a search.
struct Search {
    open: BinaryHeap<Open>,
    /// The largest values found so far.
    best: f64,
    wanted: f64,
    at: Option<Point>,
    /// An upper bound that holds on the boxes too small to be cut.
    stuck: f64,
}

impl Default for Search {
    fn default() -> Self {
        let none = f64::NEG_INFINITY;
        Self { open: BinaryHeap::new(), best: none, wanted: none, at: None, stuck: none }
    }
}

impl Search {
    /// Records a value; ignores NaN.
    fn meet(&mut self, x: Point, value: f64, function: &dyn Bounded) {
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
    fn keep(&mut self, patch: Patch, bound: Bound, age: usize) {
        let upper = if bound.upper.is_nan() { f64::INFINITY } else { bound.upper };
        if !(upper <= self.best) {
            self.open.push(Open { upper, cut: bound.cut, patch, age });
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
    fn cut(&mut self, tolerance: f64) -> (Vec<Patch>, f64) {
        let goal = self.goal(tolerance);
        let (mut halves, mut upper) = (Vec::new(), f64::NEG_INFINITY);
        while halves.len() < 2 * BATCH && self.open.peek().is_some_and(|top| top.upper > goal) {
            let Some(top) = self.open.pop() else { break };
            match top.patch.halves(top.cut) {
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

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        self.upper.total_cmp(&other.upper).then(other.age.cmp(&self.age))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Open {}
