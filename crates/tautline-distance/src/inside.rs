//! Ends of a curve, moved into their sets.

use nalgebra::SVector;
use tautline_sets::{ClosedSet, Shape};

use crate::seed::distance;

/// Returns a point of the set near `x` that is a member in exact arithmetic, not only up to rounding:
/// `x` itself, or its projection, or a point a few roundings within the boundary.
pub(crate) fn inside<const D: usize>(set: &Shape<D>, x: &SVector<f64, D>) -> SVector<f64, D> {
    if set.contains(x) {
        return *x;
    }
    let nearest = set.pieces().into_iter().min_by(|a, b| distance(a, x).total_cmp(&distance(b, x)));
    match nearest {
        Some(Shape::Point(point)) => *point.position(),
        Some(Shape::AxisBox(side)) => side.project(x),
        Some(Shape::Ball(ball)) if set.contains(&ball.project(x)) => ball.project(x),
        Some(Shape::HalfSpace(wall)) if set.contains(&wall.project(x)) => wall.project(x),
        Some(Shape::Ball(ball)) => {
            let shift = 4.0 * f64::EPSILON * (ball.centre().amax() + ball.r());
            let away = ball.project(x) - ball.centre();
            // Not beyond the centre.
            let part = 1.0 - (shift / ball.r()).min(1.0);
            if ball.r() == 0.0 { *ball.centre() } else { ball.centre() + away * part }
        }
        Some(Shape::HalfSpace(wall)) => {
            let shift = 8.0 * f64::EPSILON * (x.amax() + wall.offset().abs());
            wall.project(x) - wall.normal() * shift
        }
        Some(Shape::Union(_)) | None => *x,
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline_chance::{Random, seed};
    use tautline_sets::{Ball, HalfSpace, Shape};

    use super::inside;

    /// As the checker asks.
    #[test]
    fn moved_ends_are_members() {
        let mut random = Random(seed(1));
        for _ in 0..500 {
            let mut number = |size: f64| random.between(-size, size);
            let centre = vector![number(100.0), number(1.0)];
            let ball = Shape::Ball(Ball::new(centre, number(1.0).abs()).expect("finite"));
            let normal = vector![number(1.0), number(1.0)];
            let wall = Shape::HalfSpace(HalfSpace::new(normal, number(3.0)).expect("a normal"));
            let mut x = || SVector::from([number(5.0), number(5.0)]);
            let (x, y) = (x() + centre, x());
            assert!(ball.contains(&inside(&ball, &x)), "{ball:?} {x:?}");
            assert!(wall.contains(&inside(&wall, &y)), "{wall:?} {y:?}");
            assert_eq!(inside(&ball, &centre), centre);
        }
    }

    /// The point of the boundary is not moved.
    #[test]
    fn members_stay() {
        let ball = Shape::Ball(Ball::new([0.0], 0.1).expect("finite"));
        assert_eq!(inside(&ball, &vector![0.1]), vector![0.1]);
        let wall = Shape::HalfSpace(HalfSpace::new([1.0], 0.3).expect("a normal"));
        assert_eq!(inside(&wall, &vector![0.3]), vector![0.3]);
        assert_eq!(inside(&wall, &vector![7.0]), vector![0.3]);
    }
}
