//! Points and point sequences at random.

use proptest::{prelude::*, sample::select};
use tautline::{PointSequence, SVector};

/// Values of `N` for statements "for every `N`": the smallest, which are the hardest, some that are
/// no powers of two, and one that takes several grids.
pub fn subintervals() -> impl Strategy<Value = usize> {
    select(vec![1_usize, 2, 3, 5, 8, 17, 64, 200])
}

/// A vector of the cube `[−size, size]^D`.
pub fn vector<const D: usize>(size: f64) -> impl Strategy<Value = SVector<f64, D>> {
    proptest::array::uniform::<_, D>(-size..size).prop_map(SVector::from)
}

/// Two points of the cube, at least `size/20` apart, so that their distance is more than rounding.
pub fn two_points<const D: usize>(size: f64) -> impl Strategy<Value = [SVector<f64, D>; 2]> {
    (vector(size), vector(size))
        .prop_filter("the points are apart", move |(a, b): &(SVector<f64, D>, SVector<f64, D>)| {
            (b - a).norm() >= size / 20.0
        })
        .prop_map(|(a, b)| [a, b])
}

/// A point sequence of the cube with `N` from 1 to 40, far from any minimiser. One step in three
/// rests, as in minimisers of the discrete lengths.
pub fn sequence<const D: usize>(size: f64) -> impl Strategy<Value = PointSequence<D>> {
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
