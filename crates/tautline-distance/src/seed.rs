//! Values near a set and in it, from which a distance spreads.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{flat::signed_distance, marching::metric};

/// Returns the signed Euclidean distance of `x` from a piece, negative inside, and a unit vector that
/// points away from it.
fn away<const D: usize>(piece: &Shape<D>, x: &SVector<f64, D>) -> (f64, SVector<f64, D>) {
    let from = |centre: &SVector<f64, D>, r: f64| {
        let distance = (x - centre).norm();
        // At the centre every direction points away.
        let any = || SVector::from_fn(|i, _| if i == 0 { 1.0 } else { 0.0 });
        (distance - r, (x - centre).try_normalize(0.0).unwrap_or_else(any))
    };
    match piece {
        Shape::Point(point) => from(point.position(), 0.0),
        Shape::Ball(ball) => from(ball.centre(), ball.r()),
        Shape::HalfSpace(wall) => (wall.normal().dot(x) - wall.offset(), *wall.normal()),
        Shape::AxisBox(side) => {
            let beyond = |i: usize| (side.lower()[i] - x[i]).max(x[i] - side.upper()[i]);
            let outside = SVector::<f64, D>::from_fn(|i, _| {
                x[i] - x[i].clamp(side.lower()[i], side.upper()[i])
            });
            match outside.try_normalize(0.0) {
                Some(unit) => (outside.norm(), unit),
                None => {
                    let nearest = (1..D).fold(0, |a, b| if beyond(b) > beyond(a) { b } else { a });
                    let up =
                        x[nearest] - side.upper()[nearest] >= side.lower()[nearest] - x[nearest];
                    let sign = if up { 1.0 } else { -1.0 };
                    (
                        beyond(nearest),
                        SVector::from_fn(|i, _| if i == nearest { sign } else { 0.0 }),
                    )
                }
            }
        }
        Shape::Union(_) => (f64::INFINITY, SVector::zeros()),
    }
}

/// Returns the Euclidean distance between a piece and `x`, negative inside.
pub(crate) fn distance<const D: usize>(piece: &Shape<D>, x: &SVector<f64, D>) -> f64 {
    away(piece, x).0
}

/// Returns about the distance of `x` from a set, negative inside, if `x` is in it or within `band`
/// (Euclidean). The result is `None` if it is not, or if no metric is defined near `x`; it is finite.
///
/// The distance from a piece is that under the metric at the middle of the way to it, which is an error of
/// third order in the length of the way.
pub(crate) fn seed<const D: usize>(
    formula: &Formula<D>,
    set: &Shape<D>,
    band: f64,
    x: &SVector<f64, D>,
) -> Option<f64> {
    let of_piece = |piece: &Shape<D>| {
        let (t, n) = away(piece, x);
        if !(t <= band) {
            return None;
        }
        // Far inside a set there may be no metric in the middle. There any value below 0 will do.
        let h =
            [0.5, 0.0, 1.0].into_iter().find_map(|part| metric(formula, &(x - n * (part * t))))?;
        if is_conformal(&h) {
            return Some(t * h[(0, 0)].sqrt());
        }
        // The nearest point by this metric may be far from the Euclidean one.
        let (first, y) = signed_distance(piece, &h, x)?;
        let again = metric(formula, &((x + y) * 0.5)).and_then(|h| signed_distance(piece, &h, x));
        Some(again.map_or(first, |(distance, _)| distance))
    };
    let values = set.pieces().into_iter().filter_map(of_piece);
    values.filter(|value| value.is_finite()).reduce(f64::min)
}

/// Returns whether a matrix is a multiple of the identity.
fn is_conformal<const D: usize>(h: &SMatrix<f64, D, D>) -> bool {
    *h == SMatrix::<f64, D, D>::identity() * h[(0, 0)]
}
