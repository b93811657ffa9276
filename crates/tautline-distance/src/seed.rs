//! Values near a set and in it, from which a distance spreads.

use nalgebra::SVector;
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::marching::gram;

/// Returns the signed Euclidean distance of `x` from a piece, negative inside, and the unit vector
/// that points away from it.
fn away<const D: usize>(piece: &Shape<D>, x: &SVector<f64, D>) -> (f64, SVector<f64, D>) {
    let from = |centre: &SVector<f64, D>, r: f64| {
        let distance = (x - centre).norm();
        (distance - r, (x - centre).try_normalize(0.0).unwrap_or_else(SVector::zeros))
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
/// (Euclidean); otherwise `None`.
///
/// The distance to a hyperplane with the unit normal `n` at the Euclidean distance `t` is
/// `t/(nᵀH⁻¹n)^{1/2}`, and to a point it is the length of the chord.
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
        let h = gram(formula, &(x - n * (0.5 * t)));
        let is_point = matches!(piece, Shape::Point(_))
            || matches!(piece, Shape::Ball(ball) if ball.r() == 0.0);
        if is_point {
            return Some(t * n.dot(&(h * n)).max(0.0).sqrt());
        }
        let dual = n.dot(&h.try_inverse().map_or(n, |inverse| inverse * n));
        Some(t / dual.sqrt())
    };
    set.pieces().into_iter().filter_map(of_piece).reduce(f64::min)
}
