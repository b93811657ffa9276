//! Searches for known maxima.

use nalgebra::vector;
use num_traits::Zero;
use tautline_scalar::{Interval, Scalar};

use super::{Bound, Bounded, Maximum};
use crate::{
    Accuracy, Cell, Domain,
    patch::{Patch, Point},
};

fn maximise(function: &dyn Bounded, domain: &Domain, accuracy: Accuracy) -> Maximum {
    super::maximise(function, domain, accuracy, &mut |_, _, _| true)
}

/// The function `sin 3x₁ cos 2x₂ − (x₁² + x₂²)/10`, with optional defects.
#[derive(Default)]
struct Waves {
    undefined_beyond: Option<f64>,
    boasts_by: f64,
}

fn waves<S: Scalar>(x: [S; 2]) -> S {
    (x[0] * 3.0).sin() * (x[1] * 2.0).cos() - (x[0].sqr() + x[1].sqr()) * 0.1
}

impl Bounded for Waves {
    fn bound(&self, patch: &Patch) -> Bound {
        let [x, y] = [patch.sides[0], patch.sides[1]];
        let cut = usize::from(y.width() > x.width());
        let hidden = self.undefined_beyond.is_some_and(|limit| x.hi() > limit);
        let upper = if hidden { f64::NAN } else { waves([x, y]).hi() };
        Bound { upper, cut, middle: self.value(&patch.middle()) }
    }

    fn value(&self, x: &Point) -> f64 {
        waves([x.at[0], x.at[1]]) + self.boasts_by
    }

    fn is_refuted(&self, _: &Point, value: f64) -> bool {
        value.is_nan()
    }
}

fn square() -> Domain {
    Domain::cell(Cell::new([-2.0, -2.0], [2.0, 2.0]).expect("in order"))
}

/// The maximum lies at `x₂ = 0`, where `3 cos 3x = x/5`. This gives `x ≈ 0.5120`, which Newton's
/// method refines.
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
    let at = found.at.clone().expect("a point").at;
    assert!(found.reached && found.refuted.is_none());
    assert!(greatest() <= found.upper && found.upper <= greatest() * (1.0 + 2e-6), "{found:?}");
    assert!(waves([at[0], at[1]]) >= greatest() * (1.0 - 1e-6), "{at:?}");
}

#[test]
fn on_a_ball_only_its_points_count() {
    // This ball excludes the maximum at (0.512, 0).
    let ball = Domain::ball([-0.5, 0.0], 0.75).expect("a radius");
    let found = maximise(&Waves::default(), &ball, EFFORT);
    // The largest value is at the point nearest to the maximum, (0.25, 0): the function grows up to
    // there.
    let most = waves([0.25, 0.0]);
    assert!(found.reached, "{found:?}");
    assert!(most <= found.upper && found.upper <= most * (1.0 + 2e-6), "{found:?} {most}");
    let at = found.at.expect("a point").at;
    assert!((vector![at[0], at[1]] - vector![-0.5, 0.0]).norm() <= 0.75);
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

/// A dropped box may have a bound as large as the best value, even if that value is wrong. The
/// result must therefore not be smaller than the best value.
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

impl Bounded for OnTheLine {
    fn bound(&self, patch: &Patch) -> Bound {
        let middle = self.value(&patch.middle());
        Bound { upper: (self.bound)(patch.sides[0]), cut: 0, middle }
    }

    fn value(&self, x: &Point) -> f64 {
        (self.value)(x.at[0])
    }

    fn is_refuted(&self, x: &Point, value: f64) -> bool {
        (self.is_refuted)(x.at[0], value)
    }
}

fn segment(lower: f64, upper: f64) -> Domain {
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
    assert!(found.refuted.as_ref().is_some_and(|x| x.at[0] > 0.7), "{found:?}");
    assert!(found.upper == f64::INFINITY && !found.reached);
}

/// If a function has no value at the first few points, for example because of overflow, it is
/// evaluated at others.
#[test]
fn a_search_continues_until_there_is_a_value() {
    let late = |is_refuted| OnTheLine {
        bound: |x| if x.hi() > 0.25 { f64::INFINITY } else { x.hi() },
        value: |x| if x < 0.3 { x } else { f64::NAN },
        is_refuted,
    };
    let found = maximise(&late(|x, _| x > 0.9), &segment(0.0, 1.0), EFFORT);
    let refuted = found.refuted.as_ref().is_some_and(|x| x.at[0] > 0.9);
    assert!(refuted && !found.reached, "{found:?}");
    // Without a refutation the search spends the budget, and the values found still count.
    let accuracy = Accuracy { budget: 100, ..EFFORT };
    let found = maximise(&late(|_, _| false), &segment(0.0, 1.0), accuracy);
    let at = found.at.as_ref().is_some_and(|x| x.at[0] < 0.3);
    assert!(found.boxes > 90 && at, "{found:?}");
    assert!(found.upper == f64::INFINITY && !found.reached, "{found:?}");
}

/// A box between neighbouring doubles cannot be cut, but its bound still counts, both if the other
/// boxes attain their bounds and if they are cut first.
#[test]
fn a_box_that_is_too_small_to_be_cut_keeps_its_bound() {
    // The value is 0 at all points, but the bound is 3 on boxes that reach beyond 1.
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

/// Of several boxes that cannot be cut, the largest bound counts, whichever is met first, and in
/// whichever round.
#[test]
fn of_boxes_too_small_to_be_cut_the_largest_bound_counts() {
    const UNIT: f64 = f64::EPSILON;
    let of = |bound| OnTheLine { bound, value: |_| 0.0, is_refuted: |_, _| false };
    let first = of(|x| if x.lo() == 1.0 { 3.0 } else { 2.0 });
    let last = of(|x| if x.hi() == 1.0 + 8.0 * UNIT { 3.0 } else { 2.0 });
    let third =
        of(|x| if x.lo() <= 1.0 + 2.0 * UNIT && x.hi() > 1.0 + 2.0 * UNIT { 3.0 } else { 2.0 });
    // Bounds that differ from box to box. The largest is that of the last box, and of the first one.
    let rising = of(|x| 3.0 - (1.0 + 8.0 * UNIT - x.hi()) / UNIT / 8.0);
    let falling = of(|x| 3.0 - (x.lo() - 1.0) / UNIT / 8.0);
    for function in [first, last, third, rising, falling] {
        let found = maximise(&function, &segment(1.0, 1.0 + 8.0 * UNIT), EFFORT);
        assert!(found.upper == 3.0 && !found.reached && found.boxes == 15, "{found:?}");
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

/// If the budget ends a search between two rounds, the boxes that were about to be bounded keep the
/// largest bound of those they were cut from, whichever was cut last. What is told after each round is
/// the same bound.
#[test]
fn boxes_that_are_no_longer_bounded_keep_the_largest_bound() {
    for on_the_left in [true, false] {
        // The bound is 9 on the whole, then 5 on one half and 1 on the other.
        let left: fn(Interval) -> f64 = |x| {
            if x.width() > 0.75 {
                9.0
            } else if x.hi() <= 0.5 {
                5.0
            } else {
                1.0
            }
        };
        let right: fn(Interval) -> f64 = |x| {
            if x.width() > 0.75 {
                9.0
            } else if x.lo() >= 0.5 {
                5.0
            } else {
                1.0
            }
        };
        let bound = if on_the_left { left } else { right };
        let steps = OnTheLine { bound, value: |_| 0.0, is_refuted: |_, _| false };
        let three = Accuracy { budget: 3, ..EFFORT };
        let found = maximise(&steps, &segment(0.0, 1.0), three);
        assert!(found.upper == 5.0 && found.boxes == 3 && !found.reached, "{found:?}");
        let mut told = Vec::new();
        let mut watch = |boxes: usize, value: f64, bound: f64| {
            told.push((boxes, value, bound));
            told.len() < 2
        };
        let stopped = super::maximise(&steps, &segment(0.0, 1.0), EFFORT, &mut watch);
        assert_eq!(told, [(1, 0.0, 9.0), (3, 0.0, 5.0)]);
        assert!(stopped.upper == 5.0 && stopped.boxes == 3 && !stopped.reached, "{stopped:?}");
    }
}

/// The best value is the largest of all, not the last one: where bounds are exact, the search ends as
/// soon as no other box can exceed it.
#[test]
fn the_best_value_is_the_largest_and_not_the_last() {
    let falling = OnTheLine { bound: |x| -x.lo(), value: |x| -x, is_refuted: |_, _| false };
    let rising = OnTheLine { bound: |x| x.hi(), value: |x| x, is_refuted: |_, _| false };
    let accuracy = Accuracy { tolerance: 1e-3, budget: 1000 };
    for (function, cell, most) in
        [(&falling, segment(1.0, 2.0), -1.0), (&rising, segment(1.0, 2.0), 2.0)]
    {
        let found = maximise(function, &cell, accuracy);
        assert!(found.reached && found.upper >= most, "{found:?}");
        assert!(found.upper <= most + 4e-3, "{found:?}");
    }
}

/// In seven dimensions a search is asked after every four boxes. Wherever it ends, also within a round,
/// the bound holds for the boxes that it has not looked at.
#[test]
fn a_search_that_ends_within_a_round_keeps_its_bound() {
    let cell = Domain::cell(Cell::new([-2.0; 7], [2.0; 7]).expect("in order"));
    let mut within = 0;
    for end in 0..60 {
        let (mut calls, mut boxes) = (0, 0);
        let found = super::maximise(&Waves::default(), &cell, EFFORT, &mut |seen, _, upper| {
            assert!(upper >= greatest(), "{upper} after {seen} boxes");
            within += usize::from(calls > 0 && seen - boxes == super::DEAR_BATCH);
            (calls, boxes) = (calls + 1, seen);
            calls <= end
        });
        assert!(found.upper >= greatest(), "{found:?}");
        assert!(!found.reached && calls == end + 1, "{found:?}");
    }
    assert!(within > 100, "{within}");
}
