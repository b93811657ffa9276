//! The order of candidates, and their extrapolation to the next grid.

use tautline_discretizations::{PointSequence, Rule};
use tautline_formula::Prepared;
use tautline_metrics::gallery::Valleys;
use tautline_sets::{AnySet, Ball, InAny, Point};

use super::{Candidate, are_apart, lowest_first};
use crate::{
    Curvature, Stop,
    newton::discrete_energy::DiscreteEnergy,
    search::local_search::{Found, LocalSearch},
    watch::Unwatched,
};

/// Returns the distance between the start with 3200 chords and the minimiser, after a search on
/// these grids.
fn distance(rule: Rule, grids: &[usize]) -> f64 {
    let ends = [[0.0, 0.0], [2.0, 1.5]].map(|x| Point::new(x).expect("finite"));
    let ends = ends.each_ref().map(|set| InAny(set));
    let ends: [&dyn AnySet; 2] = [&ends[0], &ends[1]];
    let batches = Prepared::<_, 2>::new(&Valleys);
    let search = LocalSearch {
        energy: &DiscreteEnergy::new(rule, &batches),
        ends,
        iterations: 50,
        threads: 1,
        watch: &Unwatched,
    };
    let solve = |n| {
        let line = PointSequence::<2>::straight([0.0, 0.0], [2.0, 1.5], n).expect("finite");
        search.run(line.into_any()).expect("a metric")
    };
    let candidate = Candidate::new(ends, solve(grids[0]));
    let candidate = grids[1..].iter().fold(candidate, |c, &n| c.refined(solve(n)).0);
    let start = candidate.start(3200, search.energy, Vec::new()).expect("finite");
    let fine = solve(3200).sequence;
    let pairs = start.coordinates().iter().zip(fine.coordinates());
    pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// The leading error is of order 2 for one rule and 1 for the other, and the next error is of
/// twice that order. Each additional grid divides the remainder by about the number of chords
/// of the coarsest grid, or by its square. With a wrong power or a wrong sign the error would
/// not decrease.
#[test]
fn the_points_are_extrapolated_to_the_next_grid() {
    let one_by_one = [[800].as_slice(), &[200, 800], &[100, 200, 800], &[100, 100, 200, 800]];
    for [one, two, three, again] in [
        one_by_one.map(|grids| distance(Rule::TRAPEZOIDAL, grids)),
        one_by_one.map(|grids| distance(Rule::LEFT_ENDPOINT, grids)),
    ] {
        assert!(two < 0.1 * one, "{two:e} {one:e}");
        assert!(three < 0.1 * two, "{three:e} {two:e}");
        // Only three grids are kept.
        assert_eq!(again, three);
    }
}

/// Extrapolation moves the ends off a curved boundary; both are projected back.
#[test]
fn the_ends_of_an_extrapolated_start_lie_in_their_sets() {
    let [a, b] = [[0.0, 0.3], [3.0, 1.5]].map(|x| Ball::new(x, 0.5).expect("a radius"));
    let (a, b) = (InAny(&a), InAny(&b));
    let ends: [&dyn AnySet; 2] = [&a, &b];
    let batches = Prepared::<_, 2>::new(&Valleys);
    let energy = &DiscreteEnergy::new(Rule::LEFT_ENDPOINT, &batches);
    let search = LocalSearch { energy, ends, iterations: 50, threads: 1, watch: &Unwatched };
    let solve = |n| {
        let line = PointSequence::<2>::straight([0.3, 0.3], [2.7, 1.5], n).expect("finite");
        search.run(line.into_any()).expect("a metric")
    };
    let candidate = Candidate::new(ends, solve(32)).refined(solve(64)).0;
    let start = candidate.start(256, energy, Vec::new()).expect("finite");
    for (set, x) in ends.into_iter().zip([start.row(0), start.row(256)]) {
        let mut nearest = x.to_vec();
        set.project(&mut nearest);
        assert!(gap(&nearest, x) < 1e-15, "{x:?}");
    }
    // Extrapolation has moved the end by far more.
    assert!(gap(start.row(256), candidate.found.sequence.row(64)) > 1e-6);
}

/// Returns the largest difference of two coordinates.
fn gap(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// Returns a made-up result with this energy.
fn found(n: usize, energy: f64) -> Found {
    let line = PointSequence::straight([0.0, 0.0], [1.0, 0.0], n).expect("finite");
    Found {
        sequence: line.into_any(),
        energy,
        mean_gram: 1.0,
        decrement: 0.0,
        residual: 0.0,
        residual_floor: 0.0,
        stop: Stop::Converged,
        curvature: Curvature::PositiveDefinite,
        iterations: 1,
        from: 0.0,
    }
}

#[test]
fn grids_before_a_leap_are_not_extrapolated_from() {
    let point = Point::new([0.0, 0.0]).expect("finite");
    let point = InAny(&point);
    let coarse = || Candidate::new([&point, &point], found(32, 1.0)).refined(found(64, 1.1)).0;
    assert_eq!(coarse().coarser.len(), 1);
    let (steady, _) = coarse().refined(found(128, 1.1));
    assert_eq!((steady.leapt(), steady.coarser.len()), (false, 2));
    let (leapt, _) = coarse().refined(found(128, 2.0));
    assert_eq!((leapt.leapt(), leapt.coarser.len()), (true, 0));
    // Only one step from grid to grid counts: over several steps, the energy may rise further.
    let rising = [1.4, 1.8, 2.2].map(|energy| (128, energy));
    let risen = rising.into_iter().fold(coarse(), |c, (n, e)| c.refined(found(n, e)).0);
    assert!(!risen.leapt() && risen.refined(found(256, 3.4)).0.leapt());
}

/// The energy of a failed search means nothing. The search comes last, however low its energy
/// is, and is never merged with one that converged.
#[test]
fn a_failed_search_comes_last_and_replaces_none() {
    let point = Point::new([0.0, 0.0]).expect("finite");
    let point = InAny(&point);
    for stop in [Stop::Stalled, Stop::IterationLimit] {
        let new =
            |energy, stop| Candidate::new([&point, &point], Found { stop, ..found(64, energy) });
        let (good, touch) = (new(2.0, Stop::Converged), new(3.0, Stop::EndsTouch));
        let mut candidates = vec![new(1.0, stop), touch, new(2.0, stop), good];
        lowest_first(&mut candidates);
        let order: Vec<_> = candidates.iter().map(|c| (c.found.energy, c.failed())).collect();
        assert_eq!(order, [(2.0, false), (3.0, false), (1.0, true), (2.0, true)]);
        let mut alike = vec![new(2.0, stop), new(2.0, Stop::Converged)];
        lowest_first(&mut alike);
        assert_eq!(alike.iter().map(Candidate::failed).collect::<Vec<_>>(), [false, true]);
    }
}

#[test]
fn a_change_is_relative_to_the_coarser_grid_and_in_either_direction() {
    let point = Point::new([0.0, 0.0]).expect("finite");
    let point = InAny(&point);
    let one = || Candidate::new([&point, &point], found(32, 8.0));
    assert!(!one().has_changed_by(0.0));
    let changed = |energy, by| one().refined(found(64, energy)).0.has_changed_by(by);
    // The energy changes by exactly 1/8.
    for energy in [7.0, 9.0] {
        assert!(changed(energy, 0.125) && !changed(energy, 0.1250001), "{energy}");
    }
    assert!(changed(f64::NAN, 1.0));
}

#[test]
fn of_two_equal_candidates_the_one_from_more_grids_is_kept() {
    let point = Point::new([0.0, 0.0]).expect("finite");
    let point = InAny(&point);
    let new = |energy| Candidate::new([&point, &point], found(64, energy));
    let followed = || Candidate::new([&point, &point], found(32, 1.0)).refined(found(64, 1.0)).0;
    let lower = 1.0 - 1e-10;
    for mut candidates in [vec![new(lower), followed()], vec![followed(), new(lower)]] {
        lowest_first(&mut candidates);
        let [Candidate { levels, .. }] = &candidates[..] else { panic!("not merged") };
        assert_eq!(levels.len(), 2);
    }
    let mut different = vec![followed(), new(1.0 - 1e-8)];
    lowest_first(&mut different);
    assert_eq!(different.iter().map(|c| c.levels.len()).collect::<Vec<_>>(), [1, 2]);
}

/// Curves are compared on the scale of their own size, not of the distance of their ends: a curve that comes
/// back to where it begins runs along another one that is off by a hundredth of its size, and apart from one
/// that is off by three hundredths. So does a curve whose ends are near to each other.
#[test]
fn curves_are_apart_on_the_scale_of_their_size() {
    for gap in [0.0, 0.01, 6.0] {
        let bent = |height: f64| {
            let points = [[0.0, 0.0], [0.0, height], [gap, height], [gap, 0.0]];
            PointSequence::new(points.map(Into::into).to_vec()).expect("finite")
        };
        let (curve, size) = (bent(10.0), 10.0);
        assert!(!are_apart(&curve, &curve), "{gap}");
        for sign in [1.0, -1.0] {
            assert!(!are_apart(&curve, &bent(size * (1.0 + 0.01 * sign))), "{gap}");
            assert!(are_apart(&curve, &bent(size * (1.0 + 0.03 * sign))), "{gap}");
        }
    }
}
