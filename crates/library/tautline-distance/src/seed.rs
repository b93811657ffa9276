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
        // A union is no piece, and the checker refuses other sets.
        _ => (f64::INFINITY, SVector::zeros()),
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

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline_formula::Formula;
    use tautline_sets::{AxisBox, Ball, HalfSpace, Point, Shape};

    use super::{away, distance, seed};

    fn formula(text: &str) -> Formula<2> {
        Formula::parse(text, &[]).expect("a formula")
    }

    fn ball(x: [f64; 2], r: f64) -> Shape<2> {
        Shape::Ball(Ball::new(x, r).expect("a radius"))
    }

    /// The box from (0, 0) to (4, 2).
    fn side() -> Shape<2> {
        Shape::AxisBox(AxisBox::from_corners([0.0, 0.0], [4.0, 2.0]).expect("corners"))
    }

    fn wall() -> Shape<2> {
        Shape::HalfSpace(HalfSpace::at_least([3.0, 4.0], 10.0).expect("a normal"))
    }

    /// Negative inside, to the nearest side.
    #[test]
    fn euclidean_distances_are_signed_and_point_away() {
        let point = Shape::Point(Point::new([1.0, 2.0]).expect("finite"));
        for (piece, x, exact, unit) in [
            (point, [4.0, 6.0], 5.0, [0.6, 0.8]),
            (ball([1.0, 2.0], 2.0), [4.0, 6.0], 3.0, [0.6, 0.8]),
            (ball([1.0, 2.0], 2.0), [1.0, 1.5], -1.5, [0.0, -1.0]),
            (ball([1.0, 2.0], 2.0), [1.0, 2.0], -2.0, [1.0, 0.0]),
            (side(), [7.0, 6.0], 5.0, [0.6, 0.8]),
            (side(), [-3.0, 1.0], 3.0, [-1.0, 0.0]),
            (side(), [1.0, -2.0], 2.0, [0.0, -1.0]),
            (side(), [2.0, 1.5], -0.5, [0.0, 1.0]),
            (side(), [2.0, 0.25], -0.25, [0.0, -1.0]),
            (side(), [0.5, 1.0], -0.5, [-1.0, 0.0]),
            (side(), [3.75, 1.0], -0.25, [1.0, 0.0]),
            (wall(), [0.0, 0.0], 2.0, [-0.6, -0.8]),
            (wall(), [6.0, 8.0], -8.0, [-0.6, -0.8]),
        ] {
            let x: SVector<f64, 2> = x.into();
            let (found, direction) = away(&piece, &x);
            assert!((found - exact).abs() < 1e-14, "{piece:?} {x}: {found}");
            assert!((direction - SVector::from(unit)).norm() < 1e-14, "{piece:?} {x}: {direction}");
            assert_eq!(distance(&piece, &x), found);
        }
    }

    /// Under `4 I` all distances are doubled. Under a diagonal metric the nearest point of a half-space is
    /// another one: `t/(nᵀh⁻¹n)^{1/2}`.
    #[test]
    fn seeds_are_the_distances_under_a_constant_metric() {
        let twice = formula("4 I");
        for (piece, x) in [
            (ball([1.0, 2.0], 2.0), [4.0, 6.0]),
            (ball([1.0, 2.0], 2.0), [1.0, 1.5]),
            (side(), [2.0, 0.25]),
            (side(), [7.0, 6.0]),
            (wall(), [6.0, 8.0]),
        ] {
            let x = x.into();
            let exact = 2.0 * distance(&piece, &x);
            let found = seed(&twice, &piece, 10.0, &x).expect("near");
            assert!((found - exact).abs() < 1e-13, "{piece:?} {x}: {found} {exact}");
        }
        let diagonal = formula("[9, 0; 0, 16]");
        let found = seed(&diagonal, &wall(), 10.0, &vector![0.0, 0.0]).expect("near");
        // nᵀh⁻¹n = 0.36/9 + 0.64/16 = 0.08.
        assert!((found - 2.0 / 0.08_f64.sqrt()).abs() < 1e-12, "{found}");
    }

    /// Of a union the nearest piece counts, whichever comes first; beyond the band there is no seed.
    #[test]
    fn the_nearest_piece_within_the_band_counts() {
        let flat = formula("1 I");
        let pieces = [ball([0.0, 0.0], 1.0), ball([6.0, 0.0], 2.0)];
        let x = vector![3.0, 0.0];
        for order in [[0, 1], [1, 0]] {
            let union = Shape::Union(order.map(|n: usize| pieces[n].clone()).to_vec());
            let at = |band: f64| seed(&flat, &union, band, &x);
            assert_eq!(
                [at(5.0), at(1.5), at(1.0), at(0.5)],
                [Some(1.0), Some(1.0), Some(1.0), None]
            );
            // Inside one of them.
            assert_eq!(seed(&flat, &union, 0.5, &vector![5.0, 0.0]), Some(-1.0));
        }
    }

    /// Where the middle of the way has no metric, that at one of its ends serves, and without any there is
    /// no seed.
    #[test]
    fn a_seed_needs_a_metric_somewhere_on_its_way() {
        // Undefined for x₁ < 1.
        let half = formula("(4 + 0*ln(x1 - 1)) I");
        let piece = ball([0.0, 0.0], 0.5);
        assert_eq!(seed(&half, &piece, 5.0, &vector![1.25, 0.0]), Some(1.5));
        assert_eq!(seed(&half, &piece, 5.0, &vector![0.75, 0.0]), None);
        assert_eq!(seed(&formula("(4 + 0/x1) I"), &piece, 5.0, &vector![0.0, 0.0]), Some(-1.0));
    }

    /// By the metric in the middle of the way, the error is of third order: `∫ (1 + x) dx` from 1 to
    /// `1 + t` is `t (2 + t/2)`, exactly.
    #[test]
    fn the_metric_in_the_middle_of_the_way_counts() {
        let slope = formula("cost(1 + x1)");
        let piece = ball([0.0, 0.0], 1.0);
        for t in [0.5, 0.125, -0.25] {
            let found = seed(&slope, &piece, 1.0, &vector![1.0 + t, 0.0]).expect("near");
            assert!((found - t * (2.0 + 0.5 * t)).abs() < 1e-14, "{t}: {found}");
        }
    }
}
