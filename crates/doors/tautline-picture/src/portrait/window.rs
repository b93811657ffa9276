//! Chooses the part of space that is drawn.

use tautline_scalar::ANY;
use tautline_sets::Shape;

use super::{Portrait, PortraitError};

/// White space around curves and sets, as a share of the longer side.
const MARGIN: f64 = 0.1;
/// A set is shown as a whole unless it makes the window this many times as long as the curves.
const MOST: f64 = 2.5;

/// Returns the ranges of the given coordinates that contain all curves, and all bounded sets that
/// are not much larger than the curves, and the finest level of a corridor likewise.
///
/// # Errors
///
/// If there is nothing to draw.
pub(crate) fn choose(
    portrait: &Portrait<'_>,
    coordinates: &[usize],
) -> Result<Vec<[f64; 2]>, PortraitError> {
    let curves = portrait.curve.iter().chain(portrait.others.iter().flatten());
    let at = |point: &Vec<f64>| coordinates.iter().map(|&k| [point[k]; 2]).collect();
    let mut sides: Option<Vec<[f64; 2]>> = curves.map(at).reduce(union);
    let shapes: Vec<&Shape<ANY>> = portrait.pieces().into_iter().flatten().collect();
    if sides.is_none() {
        sides = shapes.iter().filter_map(|shape| anchor(shape)).map(|p| at(&p)).reduce(union);
    }
    let core = sides.as_ref().map_or(0.0, |sides| longest(sides));
    let is_point = sides.as_ref().is_none_or(|sides| is_a_point(sides));
    for piece in shapes.iter().flat_map(|shape| extents(shape, coordinates)) {
        let larger = match &sides {
            Some(sides) => union(sides.clone(), piece),
            None => piece,
        };
        if is_point || longest(&larger) <= MOST * core {
            sides = Some(larger);
        }
    }
    let finest = portrait.corridor.and_then(|corridor| corridor.levels.last());
    let extents = finest.and_then(|cubes| cubes.extents(portrait.dimension, coordinates));
    if let (Some(whole), Some(extents)) = (&mut sides, extents) {
        let larger = union(whole.clone(), extents);
        if longest(&larger) <= MOST * core {
            *whole = larger;
        }
    }
    let mut sides = sides.ok_or(PortraitError::Nothing)?;
    if is_a_point(&sides) {
        // Without a length, the distance from the origin is the only scale that there is.
        let far = farthest(&sides);
        let half = if far > 0.0 { 0.5 * far } else { 1.0 };
        sides.iter_mut().for_each(|[from, to]| (*from, *to) = (*from - half, *to + half));
    } else {
        let margin = MARGIN * longest(&sides);
        sides.iter_mut().for_each(|[from, to]| (*from, *to) = (*from - margin, *to + margin));
    }
    Ok(sides)
}

/// Makes the shorter side of a window longer, so that it is neither flat nor tall.
pub(crate) fn rounder([x, y]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    const FLATTEST: f64 = 0.42;
    const TALLEST: f64 = 1.1;
    let length = |[from, to]: [f64; 2]| to - from;
    let stretched = |side: [f64; 2], to: f64| {
        let more = ((to - length(side)) / 2.0).max(0.0);
        [side[0] - more, side[1] + more]
    };
    [stretched(x, length(y) / TALLEST), stretched(y, FLATTEST * length(x))]
}

/// Returns the extents of the bounded pieces of a set along some coordinates, one list for each piece.
fn extents(shape: &Shape<ANY>, coordinates: &[usize]) -> Vec<Vec<[f64; 2]>> {
    let boxes = shape.boxes().into_iter();
    let sides = boxes.map(|[low, high]| coordinates.iter().map(|&k| [low[k], high[k]]).collect());
    // The extents of a large ball may overflow.
    let bounded = |piece: &Vec<[f64; 2]>| piece.iter().flatten().all(|end| end.is_finite());
    sides.filter(bounded).collect()
}

/// Returns a point of an unbounded set, or of a box, that is near the origin, for a picture without a
/// curve.
fn anchor(shape: &Shape<ANY>) -> Option<Vec<f64>> {
    match shape {
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given_slice();
            let largest = normal.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
            let scaled: Vec<f64> = normal.iter().map(|n| n / largest).collect();
            let square: f64 = scaled.iter().map(|n| n * n).sum();
            Some(scaled.iter().map(|n| n * (offset / largest) / square).collect())
        }
        Shape::AffineSubspace(subspace) => Some(subspace.base_slice().to_vec()),
        Shape::AxisBox(side) => {
            let [low, high] = side.corner_slices();
            Some(low.iter().zip(high).map(|(low, high)| 0.0_f64.clamp(*low, *high)).collect())
        }
        _ => None,
    }
}

fn union(a: Vec<[f64; 2]>, b: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    a.into_iter().zip(b).map(|(a, b)| [a[0].min(b[0]), a[1].max(b[1])]).collect()
}

fn longest(sides: &[[f64; 2]]) -> f64 {
    sides.iter().map(|[from, to]| to - from).fold(0.0, f64::max)
}

fn farthest(sides: &[[f64; 2]]) -> f64 {
    sides.iter().flatten().fold(0.0, |most, end| most.max(end.abs()))
}

/// Rounding may leave a little length where ends touch.
fn is_a_point(sides: &[[f64; 2]]) -> bool {
    longest(sides) <= 1e-10 * farthest(sides)
}

#[cfg(test)]
mod tests {
    use tautline_sets::{Ball, Shape};

    use super::{choose, rounder};
    use crate::portrait::{Portrait, PortraitError};

    #[test]
    fn small_sets_are_shown_whole_and_large_ones_are_not() {
        let gram = |_: &[f64]| None;
        let ball = |x, r| [Shape::Ball(Ball::from_slice(&[x, 0.0], r).expect("a radius"))];
        let (small, large) = (ball(0.0, 0.5), ball(103.0, 100.0));
        let curve = [vec![0.5, 0.0], vec![3.0, 0.0]];
        let portrait =
            Portrait { ends: [&small, &large], curve: &curve, ..Portrait::new(2, &gram) };
        let sides = choose(&portrait, &[0, 1]).expect("a curve");
        // From −0.5 to 3, with a tenth of 3.5 on both sides.
        let expected = [[-0.85, 3.35], [-0.85, 0.85]];
        for (side, expected) in sides.iter().flatten().zip(expected.iter().flatten()) {
            assert!((side - expected).abs() <= 1e-12, "{sides:?}");
        }
    }

    #[test]
    fn a_single_point_has_a_window_of_its_own_scale() {
        let gram = |_: &[f64]| None;
        for (at, half) in [(0.0, 1.0), (1e-9, 0.5e-9), (1e9, 0.5e9)] {
            let curve = [vec![at]];
            let portrait = Portrait { curve: &curve, ..Portrait::new(1, &gram) };
            assert_eq!(choose(&portrait, &[0]), Ok(vec![[at - half, at + half]]));
        }
        assert_eq!(choose(&Portrait::new(1, &gram), &[0]), Err(PortraitError::Nothing));
    }

    #[test]
    fn a_flat_window_becomes_taller_about_its_middle() {
        let [x, y] = rounder([[0.0, 10.0], [1.0, 1.2]]);
        assert_eq!(x, [0.0, 10.0]);
        assert!((y[0] + y[1] - 2.2).abs() <= 1e-12 && (y[1] - y[0] - 4.2).abs() <= 1e-12);
        assert_eq!(rounder([[0.0, 1.0], [0.0, 1.0]]), [[0.0, 1.0], [0.0, 1.0]]);
    }
}
