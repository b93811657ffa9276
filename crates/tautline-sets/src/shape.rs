//! `Shape`: a set as data, which can be written to a file and read by another program.

use std::{cmp::Ordering, sync::Arc};

use nalgebra::SVector;

use crate::{AxisBox, Ball, ClosedSet, HalfSpace, Point, proof};

/// A set that is described by finitely many numbers: one piece, or the union of several.
///
/// The numbers define the set exactly, as those of [`ClosedSet::member_near`] do.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shape<const D: usize> {
    /// One point.
    Point(Point<D>),
    /// A ball.
    Ball(Ball<D>),
    /// A box with sides parallel to the axes.
    AxisBox(AxisBox<D>),
    /// A half-space.
    HalfSpace(HalfSpace<D>),
    /// The union of shapes.
    Union(Vec<Shape<D>>),
}

impl<const D: usize> Shape<D> {
    /// Returns the pieces, none of which is a union, in order.
    #[must_use]
    pub fn pieces(&self) -> Vec<&Self> {
        match self {
            Shape::Union(shapes) => shapes.iter().flat_map(Shape::pieces).collect(),
            piece => vec![piece],
        }
    }

    /// Returns whether `x` is a member, decided in exact arithmetic; false if a coordinate is not
    /// finite.
    ///
    /// ```
    /// use nalgebra::vector;
    /// use tautline_sets::{Ball, Shape};
    ///
    /// let ball = Shape::Ball(Ball::new([0.0, 0.0], 1.0)?);
    /// assert!(ball.contains(&vector![0.0, -1.0]));
    /// // x₁² + x₂² = 1 + 2⁻⁸⁰, which no double of this size is.
    /// assert!(!ball.contains(&vector![1.0, 0.5_f64.powi(40)]));
    /// # Ok::<(), tautline_sets::SetError>(())
    /// ```
    #[must_use]
    pub fn contains(&self, x: &SVector<f64, D>) -> bool {
        match self {
            Shape::Point(point) => point.position() == x,
            Shape::Ball(ball) => {
                proof::compare_distance(x, ball.centre(), ball.r()).is_some_and(Ordering::is_le)
            }
            Shape::AxisBox(side) => {
                (0..D).all(|i| side.lower()[i] <= x[i] && x[i] <= side.upper()[i])
            }
            Shape::HalfSpace(wall) => {
                let (n, b) = wall.given();
                proof::compare_height(n, x, b).is_some_and(Ordering::is_le)
            }
            Shape::Union(shapes) => shapes.iter().any(|shape| shape.contains(x)),
        }
    }

    /// Returns the shape of a union of sets; `None` if one of them has no shape.
    pub(crate) fn union(sets: &[Arc<dyn ClosedSet<D>>]) -> Option<Self> {
        sets.iter().map(|set| set.shape()).collect::<Option<_>>().map(Shape::Union)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{SVector, vector};
    use tautline_chance::{Random, cases, seed};

    use super::Shape;
    use crate::{
        AxisBox, Ball, ClosedSet, HalfSpace, Point, Sphere, Union,
        exact::{Exact, least_product, square, squared_distances},
        proof::point,
    };

    /// The end of the ball `|x| ≤ 0.1` is its last point, and so is (3, 4) of the ball of radius 5.
    #[test]
    fn points_of_the_boundary_belong_to_a_set_and_their_neighbours_outside_do_not() {
        let ball = Shape::Ball(Ball::new([0.0], 0.1).expect("finite"));
        let wall = Shape::HalfSpace(HalfSpace::new([3.0], 0.3).expect("a normal"));
        let side = Shape::AxisBox(AxisBox::from_corners([-0.1], [0.1]).expect("ordered"));
        let spot = Shape::Point(Point::new([0.1]).expect("finite"));
        // 3 · 0.1 exceeds 0.3 as doubles.
        let lasts = [(&ball, 0.1), (&wall, 0.1_f64.next_down()), (&side, 0.1), (&spot, 0.1)];
        for (set, last) in lasts {
            assert!(set.contains(&vector![last]), "{set:?}");
            assert!(!set.contains(&vector![last.next_up()]), "{set:?}");
        }
        let unit = 2.0_f64.powi(-700);
        let ball = Shape::Ball(Ball::new([1.0 * unit, 2.0 * unit], 5.0 * unit).expect("finite"));
        let corner = vector![4.0 * unit, 6.0 * unit];
        assert!(ball.contains(&corner));
        assert!(!ball.contains(&vector![corner[0], corner[1].next_up()]));
        let spot = Shape::Point(Point::new([9.0, 9.0]).expect("finite"));
        let both = Shape::Union(vec![spot, ball]);
        assert!(both.contains(&corner) && both.contains(&vector![9.0, 9.0]));
        assert!(!both.contains(&vector![9.0, 6.0]));
    }

    #[test]
    fn one_coordinate_outside_is_outside() {
        let (lower, upper) = (vector![-1.0, 2.0, -0.5], vector![1.0, 2.5, 0.75]);
        let side = Shape::AxisBox(AxisBox::from_corners(lower, upper).expect("ordered"));
        let spot = Shape::Point(Point::new(lower).expect("finite"));
        for corner in [lower, upper] {
            assert!(side.contains(&corner), "{corner}");
            for i in 0..3 {
                let mut x = corner;
                x[i] = if corner == lower { x[i].next_down() } else { x[i].next_up() };
                assert!(!side.contains(&x) && !spot.contains(&x), "{x}");
            }
        }
        assert!(spot.contains(&lower) && !spot.contains(&upper));
    }

    /// A sphere is no shape, so a union with one has no data, wherever the sphere stands in it.
    #[test]
    fn a_union_is_a_shape_only_if_each_of_its_pieces_is() {
        let spot: Arc<dyn ClosedSet<2>> = Arc::new(Point::new([9.0, 9.0]).expect("finite"));
        let ball: Arc<dyn ClosedSet<2>> = Arc::new(Ball::new([0.0, 0.0], 1.0).expect("finite"));
        let rim: Arc<dyn ClosedSet<2>> = Arc::new(Sphere::new([4.0, 0.0], 1.0).expect("finite"));
        let shape = |pieces: &[&Arc<dyn ClosedSet<2>>]| {
            let pieces = pieces.iter().map(|&piece| Arc::clone(piece)).collect();
            Union::new(pieces).expect("pieces").shape()
        };
        let data = [&spot, &ball].map(|set| set.shape().expect("a shape"));
        assert_eq!(shape(&[&spot, &ball]), Some(Shape::Union(data.to_vec())));
        for pieces in [[&rim, &spot, &ball], [&spot, &rim, &ball], [&spot, &ball, &rim]] {
            assert_eq!(shape(&pieces), None, "{pieces:?}");
        }
        assert_eq!(shape(&[&rim]), None);
    }

    #[test]
    fn a_point_that_is_not_finite_belongs_to_no_set() {
        let wall = Shape::HalfSpace(HalfSpace::new([1.0], 0.0).expect("a normal"));
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!wall.contains(&vector![x]), "{x}");
        }
    }

    /// Points within a few roundings of the boundary, against long numbers.
    #[test]
    fn members_are_those_of_long_numbers() {
        let mut random = Random(seed(62));
        let mut members = 0;
        for _ in 0..cases(2000) {
            let mut vector = || SVector::<f64, 3>::from_fn(|_, _| random.between(-2.0, 2.0));
            let (c, n) = (vector(), vector());
            let (r, b) = (random.between(0.1, 2.0), random.between(-1.0, 1.0));
            let onto_ball = c + n.normalize() * r;
            let onto_wall = c - n * ((n.dot(&c) - b) / n.norm_squared());
            let ball = Shape::Ball(Ball::new(c, r).expect("finite"));
            let in_ball = squared_distances(&point(&onto_ball), &c).0.at_most(&square(r));
            assert_eq!(ball.contains(&onto_ball), in_ball, "{onto_ball} {ball:?}");
            let wall = Shape::HalfSpace(HalfSpace::new(n, b).expect("a normal"));
            let in_wall = least_product(&n, &point(&onto_wall)).at_most(&Exact::new(b));
            assert_eq!(wall.contains(&onto_wall), in_wall, "{onto_wall} {wall:?}");
            members += usize::from(in_ball) + usize::from(in_wall);
        }
        let share = members as f64 / (2.0 * f64::from(cases(2000)));
        assert!((0.3..0.7).contains(&share), "{share}");
    }
}
