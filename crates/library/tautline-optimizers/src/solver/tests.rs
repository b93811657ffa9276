//! What a solver keeps of its searches.

use nalgebra::vector;
use tautline_discretizations::{PointSequence, Rule};
use tautline_formula::Prepared;
use tautline_metrics::gallery::Separable;
use tautline_sets::{AnySet, InAny, Point};

use super::{Candidate, Found, Options, Search};
use crate::{Stop, Workspace, newton::discrete_energy::DiscreteEnergy, watch::Unwatched};

/// The minimiser with nine chords leaps over both ridges of this metric. From there, Newton's
/// method without damping fails on the next grid, but its steps still count.
#[test]
fn failed_undamped_steps_are_counted() {
    let ridges = Separable::new(vector![0.788, 0.0, 0.0], vector![1.663, 1.0, 1.0]);
    let ridges = ridges.expect("below one");
    let line = [[-2.866, 0.0, 0.0], [3.0, 0.0, 0.0]];
    let [a, b] = line.map(|x| Point::new(x).expect("finite"));
    let (a, b) = (InAny(&a), InAny(&b));
    let ends: [&dyn AnySet; 2] = [&a, &b];
    let (workspace, options) = (&mut Workspace::default(), &Options::default());
    let batches = Prepared::new(&ridges);
    let energy = &DiscreteEnergy::new(Rule::TRAPEZOIDAL, &batches);
    let mut search = Search {
        workspace,
        energy,
        options,
        n: 129,
        watch: &Unwatched,
        iterations: 0,
        ties: Vec::new(),
        refused: None,
    };
    let local = search.between(ends);
    let coarse = || {
        let line = PointSequence::straight(line[0], line[1], 9).expect("finite");
        Candidate::new(ends, local.run(line.into_any()).expect("a metric"))
    };
    let start = || coarse().start(129, energy, Vec::new()).expect("finite");
    let mut in_vain = 0;
    let undamped = local.refine(start(), &coarse().found, search.workspace, &mut in_vain);
    assert!(undamped.is_none() && in_vain > 0);
    let damped = local.run(start()).expect("a metric").iterations;
    let candidate = search.follow(coarse(), 129).expect("a metric");
    assert_eq!(candidate.found.iterations, in_vain + damped);
    assert_eq!(search.iterations, in_vain + damped);
}

/// A lower energy of a search that failed means nothing.
#[test]
fn what_was_left_behind_is_followed_if_nothing_better_counts() {
    let plane = Separable::new(vector![0.5, 0.0], vector![1.0, 1.0]).expect("below one");
    let line = [[-1.0, 0.0], [2.0, 1.0]];
    let [a, b] = line.map(|x| Point::new(x).expect("finite"));
    let (a, b) = (InAny(&a), InAny(&b));
    let ends: [&dyn AnySet; 2] = [&a, &b];
    let (workspace, options) = (&mut Workspace::default(), &Options::default());
    let batches = Prepared::new(&plane);
    let energy = &DiscreteEnergy::new(Rule::TRAPEZOIDAL, &batches);
    let mut search = Search {
        workspace,
        energy,
        options,
        n: 128,
        watch: &Unwatched,
        iterations: 0,
        ties: Vec::new(),
        refused: None,
    };
    let local = search.between(ends);
    let solved = |n| {
        let line = PointSequence::straight(line[0], line[1], n).expect("finite");
        local.run(line.into_any()).expect("a metric")
    };
    let good = || Candidate::new(ends, solved(32));
    let failed = || {
        let found = Found { stop: Stop::Stalled, energy: 1.0, ..solved(128) };
        Candidate::new(ends, found)
    };
    let mut candidates = vec![failed()];
    assert!(search.catch_up(&mut candidates, vec![good()]).is_empty());
    let [first, second] = &candidates[..] else { panic!("two candidates") };
    assert!(!first.failed() && first.found.sequence.n().get() == 128 && second.failed());
    // No candidate is left.
    let mut candidates = Vec::new();
    assert!(search.catch_up(&mut candidates, vec![good()]).is_empty());
    assert!(matches!(&candidates[..], [one] if one.found.sequence.n().get() == 128));
    // The same minimiser, on the finest grid: what is left behind is no lower.
    let mut candidates = vec![Candidate::new(ends, solved(128))];
    assert_eq!(search.catch_up(&mut candidates, vec![good()]).len(), 1);
    assert_eq!(candidates.len(), 1);
    // A search that failed is not followed, and one that fails on the finest grid stays a
    // minimum on its own.
    let mut candidates = Vec::new();
    assert_eq!(search.catch_up(&mut candidates, vec![failed()]).len(), 1);
    assert!(candidates.is_empty() && search.ties.is_empty());
    let none = &Options { iterations: 0, ..Options::default() };
    // Below `FINE` chords a search is damped, and limited by its options.
    (search.options, search.n) = (none, 60);
    assert!(search.catch_up(&mut candidates, vec![good()]).is_empty());
    assert_eq!(search.ties.len(), 1);
}
