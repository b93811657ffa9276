//! Random points and point sequences.

use proptest::{prelude::*, sample::select};
use tautline::{PointSequence, SVector};

/// Draws values of `N` for statements "for every `N`": the smallest ones, which are the hardest,
/// some that are not powers of two, and one for which the solver needs several grids.
pub fn subintervals() -> impl Strategy<Value = usize> {
    select(vec![1_usize, 2, 3, 5, 8, 17, 64, 200])
}

/// Draws a vector in the cube `[−size, size]^D`.
pub fn vector<const D: usize>(size: f64) -> impl Strategy<Value = SVector<f64, D>> {
    proptest::array::uniform::<_, D>(-size..size).prop_map(SVector::from)
}

/// Draws two points of the cube that are at least `size/20` apart, so that their distance is far
/// above rounding.
pub fn two_points<const D: usize>(size: f64) -> impl Strategy<Value = [SVector<f64, D>; 2]> {
    (vector(size), vector(size))
        .prop_filter("the points are apart", move |(a, b): &(SVector<f64, D>, SVector<f64, D>)| {
            (b - a).norm() >= size / 20.0
        })
        .prop_map(|(a, b)| [a, b])
}

/// Draws a point sequence in the cube with `N` from 1 to 40, far from any minimiser. One step in
/// three has length 0, as in minimisers of the discrete lengths.
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
