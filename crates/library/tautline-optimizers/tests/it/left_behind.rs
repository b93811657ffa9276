//! Tests a minimiser that is not followed beyond small grids, and turns out to be the lowest one.

use std::{f64::consts::PI, ops::ControlFlow};

use nalgebra::{SMatrix, SVector, vector};
use tautline_discretizations::Rule;
use tautline_formula::Prepared;
use tautline_metrics::{Metric, Scalar};
use tautline_optimizers::{Iterate, Options, SolveError, Workspace, minimise, minimise_watched};
use tautline_sets::{Ends, FiniteSet};

use crate::setup::{between, point};

/// Ripples along the first axis. Every grid up to 512 chords, in steps of powers of two, sees only
/// their floor, where `H = 1`. A grid of 4096 chords sees all of them.
struct Ripples;

impl Metric<2> for Ripples {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let ripples = 2.0 - (x[0] * (1024.0 * PI)).cos();
        SMatrix::from_diagonal(&vector![ripples, S::one()])
    }
}

/// The way along the second axis, of energy 2.1², is left behind at 512 chords, and is the lower one.
fn along_either_axis() -> Ends<2> {
    let to = FiniteSet::new([[2.0, 0.0], [0.0, 2.1]]).expect("points");
    between(point([0.0, 0.0]), to)
}

#[test]
fn a_minimiser_left_behind_is_followed_if_it_is_lower_on_the_finest_grid() {
    let ends = along_either_axis();
    let solve = |n| minimise(&Ripples, &ends, Rule::TRAPEZOIDAL, n, &Options::default());
    let [coarse, fine] = [512, 4096].map(|n| solve(n).expect("a metric"));
    assert_eq!(coarse.sequence.last(), &vector![2.0, 0.0]);
    assert!((coarse.energy - 4.0).abs() < 1e-9, "{}", coarse.energy);
    assert_eq!(fine.sequence.last(), &vector![0.0, 2.1]);
    assert!((fine.energy - 4.41).abs() < 1e-9 && fine.is_local_minimum(), "{}", fine.energy);
    // The way that was followed at first is still known, on the finest grid.
    let first = fine.others.iter().find(|other| other.sequence.n().get() == 4096).expect("known");
    assert_eq!(first.sequence.last(), &vector![2.0, 0.0]);
    // The ripples at its nodes are 2 ± √½, one as often as the other: 4 times the squared mean of their
    // roots is 7.7 for equal chords, and chords that adapt have less.
    assert!(first.energy > 6.0, "{}", first.energy);
}

/// The last iterate is on the way that was left behind.
#[test]
fn a_watcher_ends_the_solve_also_where_a_minimiser_left_behind_is_followed() {
    let (metric, ends) = (Prepared::new(Ripples), along_either_axis());
    let run = |last: usize| {
        let mut seen = 0;
        let mut end = None;
        let mut watch = |iterate: &Iterate<'_, 2>| {
            (seen, end) = (seen + 1, Some(*iterate.sequence.last()));
            if seen == last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let (memory, options) = (&mut Workspace::default(), Options::default());
        let rule = Rule::TRAPEZOIDAL;
        let found = minimise_watched(memory, &metric, &ends, rule, 4096, &options, &mut watch);
        (found.map(|_| ()), seen, end)
    };
    let (found, seen, end) = run(usize::MAX);
    assert_eq!((found, end), (Ok(()), Some(vector![0.0, 2.1])));
    assert_eq!(run(seen).0, Err(SolveError::Interrupted { n: 4096 }));
}
