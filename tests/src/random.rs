//! Random cases: the runner that every property test here uses, and points.

use proptest::{
    prelude::*,
    test_runner::{Config, RngSeed, TestCaseError, TestRunner},
};
use tautline::{PointSequence, SVector};

/// What a property test says of one case.
pub(crate) type Verdict = Result<(), TestCaseError>;

/// Runs `test` on `cases` random values, always the same ones for the same `seed`.
///
/// # Panics
///
/// With the smallest value found for which the test fails, and with the seed.
#[track_caller]
pub(crate) fn for_all<S: Strategy>(
    seed: u64,
    cases: u32,
    values: S,
    test: impl Fn(S::Value) -> Verdict,
) {
    let config = Config {
        cases,
        rng_seed: RngSeed::Fixed(seed),
        // Every run draws the same cases, so that there is nothing to remember.
        failure_persistence: None,
        ..Config::default()
    };
    if let Err(failure) = TestRunner::new(config).run(&values, test) {
        panic!("seed {seed}: {failure}");
    }
}

/// `left ≤ right`, up to `slack`; NaN fails.
///
/// The message of a failure names the inequality and both its sides.
pub(crate) fn at_most(inequality: &str, left: f64, right: f64, slack: f64) -> Verdict {
    prop_assert!(
        left <= right + slack,
        "not {inequality}: {left:.17e} exceeds {right:.17e} by {:e}, with the slack {slack:e}",
        left - right
    );
    Ok(())
}

/// A vector of the cube `[−size, size]^D`.
pub(crate) fn vector<const D: usize>(size: f64) -> impl Strategy<Value = SVector<f64, D>> {
    proptest::array::uniform::<_, D>(-size..size).prop_map(SVector::from)
}

/// Two points of the cube, at least `size/20` apart, so that a distance is not the rounding of
/// its ends.
pub(crate) fn two_points<const D: usize>(size: f64) -> impl Strategy<Value = [SVector<f64, D>; 2]> {
    (vector(size), vector(size))
        .prop_filter("the points are apart", move |(a, b): &(SVector<f64, D>, SVector<f64, D>)| {
            (b - a).norm() >= size / 20.0
        })
        .prop_map(|(a, b)| [a, b])
}

/// A point sequence of the cube with `N` from 1 to 40, far from any minimiser; one in three
/// rests a while, as the minimisers of the discrete lengths do.
pub(crate) fn sequence<const D: usize>(size: f64) -> impl Strategy<Value = PointSequence<D>> {
    let points = proptest::collection::vec((vector(size), 0..3_u8), 2..41);
    points.prop_map(|drawn| {
        let mut points: Vec<SVector<f64, D>> = Vec::new();
        for (point, rests) in drawn {
            points.push(match points.last() {
                Some(&before) if rests == 0 => before,
                _ => point,
            });
        }
        PointSequence::new(points).expect("two finite points at least")
    })
}
