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
        Some(_) | None => *x,
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline_chance::{Random, seed};
    use tautline_sets::{AxisBox, Ball, ClosedSet, HalfSpace, Point, Shape};

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

    /// An end stays next to the nearest point of the nearest piece, whatever the order of the pieces and
    /// wherever the set is.
    #[test]
    fn ends_are_moved_to_the_nearest_point_of_the_nearest_piece() {
        let mut random = Random(seed(2));
        for case in 0..300 {
            let mut near = |x: f64| x + random.between(-0.4, 0.4);
            // One piece in each quarter of the plane, all within 1 of their corners.
            let ball = Ball::new([near(5.0), near(5.0)], 0.5).expect("finite");
            let low = [near(-5.0), near(5.0)];
            let side = AxisBox::from_corners(low, low.map(|x| x + 0.5)).expect("corners");
            let point = Point::new([near(-5.0), near(-5.0)]).expect("finite");
            let wall = HalfSpace::at_least([1.0, -1.0], near(9.0)).expect("a normal");
            let mut pieces = vec![
                Shape::Ball(ball.clone()),
                Shape::AxisBox(side.clone()),
                Shape::Point(point.clone()),
                Shape::HalfSpace(wall.clone()),
            ];
            pieces.rotate_left(case % 4);
            let set = Shape::Union(pieces);
            let corners = [[4.0, 4.0], [-4.0, 4.0], [-4.0, -4.0], [4.0, -4.0]];
            let [one, two, three, four] = corners.map(|[a, b]| vector![near(a), near(b)]);
            for (x, nearest) in [
                (one, ball.project(&one)),
                (two, side.project(&two)),
                (three, *point.position()),
                (four, wall.project(&four)),
            ] {
                let moved = inside(&set, &x);
                assert!(set.contains(&moved), "{set:?} {x}");
                // Some roundings of coordinates up to 9.
                assert!((moved - nearest).norm() < 1e-13, "{set:?} {x}: {moved} {nearest}");
            }
        }
        // A ball of radius 0, far away.
        let ball = Shape::Ball(Ball::new([1e9, 0.1], 0.0).expect("finite"));
        assert_eq!(inside(&ball, &vector![0.0, 0.0]), vector![1e9, 0.1]);
    }
}
