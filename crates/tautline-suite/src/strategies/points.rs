//! Points and point sequences at random.

use proptest::{prelude::*, sample::select};
use tautline::{PointSequence, SVector};

/// The numbers of subintervals at which statements "for every `N`" are tried: the smallest
/// ones, which are the hardest, some that are no powers of two, and one of several grids.
pub fn subintervals() -> impl Strategy<Value = usize> {
    select(vec![1_usize, 2, 3, 5, 8, 17, 64, 200])
}

/// A vector of the cube `[−size, size]^D`.
pub fn vector<const D: usize>(size: f64) -> impl Strategy<Value = SVector<f64, D>> {
    proptest::array::uniform::<_, D>(-size..size).prop_map(SVector::from)
}

/// Two points of the cube, at least `size/20` apart, so that a distance is not the rounding of
/// its ends.
pub fn two_points<const D: usize>(size: f64) -> impl Strategy<Value = [SVector<f64, D>; 2]> {
    (vector(size), vector(size))
        .prop_filter("the points are apart", move |(a, b): &(SVector<f64, D>, SVector<f64, D>)| {
            (b - a).norm() >= size / 20.0
        })
        .prop_map(|(a, b)| [a, b])
}

/// A point sequence of the cube with `N` from 1 to 40, far from any minimiser; one in three
/// rests a while, as the minimisers of the discrete lengths do.
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
