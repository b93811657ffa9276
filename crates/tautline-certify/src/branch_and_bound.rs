//! The largest value of a function on a domain, by branch and bound.

use std::{cmp::Ordering, collections::BinaryHeap};

use nalgebra::SVector;
use rayon::prelude::*;

use crate::{Accuracy, Cell, Domain};

/// A function on `R^D` that can be bounded on a box.
pub(crate) trait Bounded<const D: usize>: Sync {
    /// Returns a bound of the function on a box.
    fn bound(&self, cell: &Cell<D>) -> Bound;

    /// Returns the value at a point, up to rounding; NaN if it overflows or is undefined.
    fn value(&self, x: &SVector<f64, D>) -> f64;

    /// Returns the value of the wanted function, up to rounding: the bounded one is never smaller
    /// and may be larger.
    fn wanted(&self, x: &SVector<f64, D>) -> f64 {
        self.value(x)
    }

    /// Returns whether the value at this point makes the search pointless.
    fn is_refuted(&self, x: &SVector<f64, D>, value: f64) -> bool;
}

/// A bound of a function on a box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    /// No value exceeds it. `∞` or NaN if there is none.
    pub(crate) upper: f64,
    /// The coordinate across which the box is best cut.
    pub(crate) cut: usize,
}

/// The result of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Maximum<const D: usize> {
    /// No value on the domain exceeds it: proved.
    pub(crate) upper: f64,
    /// The point with the largest wanted value found, in `ℓ`; `None` if there was no value.
    pub(crate) at: Option<SVector<f64, D>>,
    /// The point where the function was refuted and the search ended, in `ℓ`.
    pub(crate) refuted: Option<SVector<f64, D>>,
    /// The number of boxes bounded.
    pub(crate) boxes: usize,
    /// Whether the bound is within the tolerance.
    pub(crate) reached: bool,
}

/// How many boxes are cut at once: fixed, so that threads do not change the search.
const BATCH: usize = 64;

/// A box to be cut.
struct Open<const D: usize> {
    upper: f64,
    cut: usize,
    cell: Cell<D>,
    /// Of boxes with the same bound the oldest is cut first.
    age: usize,
}

/// Returns an upper bound of the largest value on the domain.
///
/// The boxes with the largest bounds are cut first, many at a time and in parallel, until the
/// largest bound is at most the best value found at a point, up to the tolerance. The result does
/// not depend on the number of threads.
///
/// A box is dropped if its bound is at most the best value. That value is rounded and may be too
/// large: so the larger of the two is returned, which bounds the dropped boxes and the others.
pub(crate) fn maximise<const D: usize>(
    function: &dyn Bounded<D>,
    domain: &Domain<D>,
    accuracy: Accuracy,
) -> Maximum<D> {
    let mut search = Search::default();
    let mut found =
        Maximum { upper: f64::INFINITY, at: None, refuted: None, boxes: 0, reached: false };
    // The boxes to bound next, and a bound of the function on all of them.
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
    /// The largest values so far.
    best: f64,
    wanted: f64,
    at: Option<SVector<f64, D>>,
    /// A bound on the boxes that are too small to be cut.
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

    /// Keeps a box unless its bound is at most the best value. NaN is no bound.
    fn keep(&mut self, cell: Cell<D>, bound: Bound, age: usize) {
        let upper = if bound.upper.is_nan() { f64::INFINITY } else { bound.upper };
        if !(upper <= self.best) {
            self.open.push(Open { upper, cut: bound.cut, cell, age });
        }
    }

    /// Boxes with larger bounds are cut: all of them until there is a value.
    fn goal(&self, tolerance: f64) -> f64 {
        // −∞ + ∞ would be NaN, which no bound exceeds.
        if self.best == f64::NEG_INFINITY {
            return self.best;
        }
        self.best + tolerance * self.best.abs()
    }

    /// Cuts the boxes with the largest bounds, above the goal; returns their halves and the largest
    /// of these bounds.
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

    /// A bound of the function on the kept and the dropped boxes.
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

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use num_traits::Zero;
    use tautline_scalar::{Interval, Scalar};

    use super::{Bound, Bounded, maximise};
    use crate::{Accuracy, Cell, Domain};

    /// `sin 3x₁ cos 2x₂ − (x₁² + x₂²)/10`, with defects.
    #[derive(Default)]
    struct Waves {
        undefined_beyond: Option<f64>,
        boasts_by: f64,
    }

    fn waves<S: Scalar>(x: [S; 2]) -> S {
        (x[0] * 3.0).sin() * (x[1] * 2.0).cos() - (x[0].sqr() + x[1].sqr()) * 0.1
    }

    impl Bounded<2> for Waves {
        fn bound(&self, cell: &Cell<2>) -> Bound {
            let [x, y] = *cell.sides();
            let cut = usize::from(y.width() > x.width());
            let hidden = self.undefined_beyond.is_some_and(|limit| x.hi() > limit);
            Bound { upper: if hidden { f64::NAN } else { waves([x, y]).hi() }, cut }
        }

        fn value(&self, x: &SVector<f64, 2>) -> f64 {
            waves([x[0], x[1]]) + self.boasts_by
        }

        fn is_refuted(&self, _: &SVector<f64, 2>, value: f64) -> bool {
            value.is_nan()
        }
    }

    fn square() -> Domain<2> {
        Domain::cell(Cell::new([-2.0, -2.0], [2.0, 2.0]).expect("in order"))
    }

    /// At `x₂ = 0`, where `3 cos 3x = x/5`: `x ≈ 0.5120`, refined by Newton's method.
    fn greatest() -> f64 {
        let mut x = 0.512_f64;
        for _ in 0..20 {
            x -= (3.0 * (3.0 * x).cos() - 0.2 * x) / (-9.0 * (3.0 * x).sin() - 0.2);
        }
        waves([x, 0.0])
    }

    const EFFORT: Accuracy = Accuracy { tolerance: 1e-6, budget: 200_000 };

    #[test]
    fn the_maximum_is_enclosed_to_the_tolerance() {
        let found = maximise(&Waves::default(), &square(), EFFORT);
        let at = found.at.expect("a point");
        assert!(found.reached && found.refuted.is_none());
        assert!(greatest() <= found.upper && found.upper <= greatest() * (1.0 + 2e-6), "{found:?}");
        assert!(waves([at[0], at[1]]) >= greatest() * (1.0 - 1e-6), "{at}");
    }

    #[test]
    fn on_a_ball_only_its_points_count() {
        // Without the maximum, which is at (0.512, 0).
        let ball = Domain::ball([-0.5, 0.0], 0.75).expect("a radius");
        let found = maximise(&Waves::default(), &ball, EFFORT);
        // The nearest point to the maximum, (0.25, 0): the function grows up to there.
        let most = waves([0.25, 0.0]);
        assert!(found.reached, "{found:?}");
        assert!(most <= found.upper && found.upper <= most * (1.0 + 2e-6), "{found:?} {most}");
        assert!((found.at.expect("a point") - vector![-0.5, 0.0]).norm() <= 0.75);
    }

    #[test]
    fn the_result_does_not_depend_on_the_number_of_threads() {
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.expect("threads").install(|| maximise(&Waves::default(), &square(), EFFORT))
        };
        let one = run(1);
        for threads in [2, 3, 8] {
            assert_eq!(one, run(threads));
        }
    }

    /// The bounds of dropped boxes reach up to the best value, even if that is wrong: the result
    /// must not be below it.
    #[test]
    fn a_value_that_is_too_large_only_costs_sharpness() {
        let boasting = Waves { boasts_by: 0.1, ..Waves::default() };
        let found = maximise(&boasting, &square(), EFFORT);
        assert!(found.upper >= greatest(), "{found:?}");
        assert!(found.upper <= greatest() + 0.1 + 1e-5, "{found:?}");
    }

    #[test]
    fn a_box_without_a_bound_is_not_dropped() {
        let partly = Waves { undefined_beyond: Some(1.999), ..Waves::default() };
        let found = maximise(&partly, &square(), EFFORT);
        assert!(found.upper == f64::INFINITY && !found.reached, "{found:?}");
    }

    #[test]
    fn a_spent_budget_leaves_a_bound() {
        let mut last = f64::INFINITY;
        for budget in [0, 1, 2, 5, 50, 500, 5000] {
            let found = maximise(&Waves::default(), &square(), Accuracy { budget, ..EFFORT });
            assert!(found.boxes <= budget && !found.reached, "{found:?}");
            assert!(greatest() <= found.upper && found.upper <= last, "{found:?}");
            last = found.upper;
        }
        assert!(last < 1.01 * greatest(), "{last}");
    }

    /// A function on the line.
    struct OnTheLine {
        bound: fn(Interval) -> f64,
        value: fn(f64) -> f64,
        is_refuted: fn(f64, f64) -> bool,
    }

    impl Bounded<1> for OnTheLine {
        fn bound(&self, cell: &Cell<1>) -> Bound {
            Bound { upper: (self.bound)(cell.sides()[0]), cut: 0 }
        }

        fn value(&self, x: &SVector<f64, 1>) -> f64 {
            (self.value)(x[0])
        }

        fn is_refuted(&self, x: &SVector<f64, 1>, value: f64) -> bool {
            (self.is_refuted)(x[0], value)
        }
    }

    fn segment(lower: f64, upper: f64) -> Domain<1> {
        Domain::cell(Cell::new([lower], [upper]).expect("in order"))
    }

    #[test]
    fn a_point_where_the_function_is_refuted_ends_the_search() {
        let nowhere = OnTheLine {
            bound: |_| f64::NAN,
            value: |x| if x > 0.7 { f64::NAN } else { 0.0 },
            is_refuted: |_, value| value.is_nan(),
        };
        let found = maximise(&nowhere, &segment(0.0, 1.0), EFFORT);
        assert!(found.refuted.is_some_and(|x| x[0] > 0.7), "{found:?}");
        assert!(found.upper == f64::INFINITY && !found.reached);
    }

    /// A function without a value at the first few points, by overflow say, is evaluated elsewhere.
    #[test]
    fn a_search_continues_until_there_is_a_value() {
        let late = |is_refuted| OnTheLine {
            bound: |x| if x.hi() > 0.25 { f64::INFINITY } else { x.hi() },
            value: |x| if x < 0.3 { x } else { f64::NAN },
            is_refuted,
        };
        let found = maximise(&late(|x, _| x > 0.9), &segment(0.0, 1.0), EFFORT);
        assert!(found.refuted.is_some_and(|x| x[0] > 0.9) && !found.reached, "{found:?}");
        // Without a refutation the budget is spent, and the values found count.
        let accuracy = Accuracy { budget: 100, ..EFFORT };
        let found = maximise(&late(|_, _| false), &segment(0.0, 1.0), accuracy);
        assert!(found.boxes > 90 && found.at.is_some_and(|x| x[0] < 0.3), "{found:?}");
        assert!(found.upper == f64::INFINITY && !found.reached, "{found:?}");
    }

    /// A box between neighbouring doubles cannot be cut, and its bound still counts: whether the
    /// other boxes attain their bounds or are cut first.
    #[test]
    fn a_box_that_is_too_small_to_be_cut_keeps_its_bound() {
        // 0 at all points, with a bound of 3 on boxes that reach beyond 1.
        let spike = OnTheLine {
            bound: |x| if x.hi() > 1.0 { 3.0 } else { 0.0 },
            value: |_| 0.0,
            is_refuted: |_, _| false,
        };
        for lower in [1.0, 1.0 - 1e-12, 0.0] {
            let found = maximise(&spike, &segment(lower, 1.0_f64.next_up()), EFFORT);
            assert!(found.upper == 3.0 && !found.reached, "{lower}: {found:?}");
        }
    }

    #[test]
    fn a_point_is_a_domain_too() {
        let point = Domain::cell(Cell::new([0.5, 0.0], [0.5, 0.0]).expect("in order"));
        let found = maximise(&Waves::default(), &point, EFFORT);
        let value = waves([Interval::point(0.5), Interval::zero()]);
        assert!(found.reached && value.contains(found.upper), "{found:?} {value:?}");
        assert_eq!(found.boxes, 1);
    }
}
