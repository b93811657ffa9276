//! `Shape`: a set as data, which can be written to a file and read by another program.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::closed_set::append_pieces;
#[cfg(feature = "serde")]
use crate::kind::data;
use crate::kind::{Kind, Piece, Value};
use crate::union::Pieces;
use crate::{
    AffineSubspace, AnySet, AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, Point, Segment,
    SetError, Sphere,
};

/// Defines [`Shape`] by the sets that it may be.
macro_rules! shapes {
    ($($(#[$about:meta])* $set:ident,)*) => {
        /// A set that is described by finitely many numbers: one piece, or the union of several.
        ///
        /// The dimension is known at compile time, or is a value if `D` is [`ANY`]. The numbers define the
        /// set exactly, as those of [`ClosedSet::member_near`] do.
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        pub enum Shape<const D: usize> {
            $($(#[$about])* $set($set<D>),)*
            /// The union of shapes. [`Shape::union`] checks that there are any, all in one dimension.
            Union(Vec<Shape<D>>),
        }

        impl<const D: usize> Shape<D> {
            /// Returns the set, or the members of a union.
            fn piece(&self) -> Result<&dyn Piece, &[Shape<D>]> {
                match self {
                    $(Shape::$set(set) => Ok(set),)*
                    Shape::Union(shapes) => Err(shapes),
                }
            }

            fn cast<const E: usize>(self) -> Shape<E> {
                match self {
                    $(Shape::$set(set) => Shape::$set(set.cast()),)*
                    Shape::Union(shapes) => {
                        Shape::Union(shapes.into_iter().map(Shape::cast).collect())
                    }
                }
            }
        }

        impl Kind {
            /// All kinds of sets.
            pub const ALL: &[Kind] = &[$($set::<ANY>::KIND),*];

            /// Returns the set of this kind with these values.
            ///
            /// # Errors
            ///
            /// [`SetError::Parts`] if there are not as many values as parts, or if one has another form;
            /// otherwise as the constructor of the set.
            pub fn shape(&self, values: &[Value]) -> Result<Shape<ANY>, SetError> {
                let other = SetError::Parts { what: self.name };
                match self.key {
                    $(key if key == $set::<ANY>::KIND.key => {
                        $set::of(values).ok_or(other)?.map(Shape::$set)
                    })*
                    _ => Err(other),
                }
            }
        }

        $(
            #[cfg(feature = "serde")]
            data::by_parts!($set);
        )*
    };
}

shapes! {
    /// One point.
    Point,
    /// Finitely many points.
    FiniteSet,
    /// A ball.
    Ball,
    /// A sphere.
    Sphere,
    /// A box with sides parallel to the axes.
    AxisBox,
    /// A half-space.
    HalfSpace,
    /// A segment.
    Segment,
    /// An affine subspace.
    AffineSubspace,
}

impl<const D: usize> Shape<D> {
    /// Returns the union of shapes, or the only one.
    ///
    /// # Errors
    ///
    /// [`SetError::Empty`] if there are none; [`SetError::Coordinates`] if their dimensions differ.
    pub fn union(mut shapes: Vec<Shape<D>>) -> Result<Shape<D>, SetError> {
        let dimension = shapes.first().ok_or(SetError::Empty)?.dimension();
        if let Some(other) = shapes.iter().find(|shape| shape.dimension() != dimension) {
            let found = other.dimension();
            return Err(SetError::Coordinates { what: other.name(), found, dimension });
        }
        Ok(if shapes.len() == 1 { shapes.remove(0) } else { Shape::Union(shapes) })
    }

    /// Returns the pieces, none of which is a union, in order. A finite set is one piece.
    #[must_use]
    pub fn pieces(&self) -> Vec<&Self> {
        match self {
            Shape::Union(shapes) => shapes.iter().flat_map(Shape::pieces).collect(),
            piece => vec![piece],
        }
    }

    /// Returns the pieces, with the points of a finite set one by one.
    #[must_use]
    pub fn single_pieces(&self) -> Vec<Self> {
        let single = |piece: &Self| match piece {
            Shape::FiniteSet(set) => set.points().iter().cloned().map(Shape::Point).collect(),
            piece => vec![piece.clone()],
        };
        self.pieces().into_iter().flat_map(single).collect()
    }

    /// Returns the lower and the upper corner, in `ℓ`, of a box around each bounded piece, and around each
    /// point of a finite set. Those of a ball or a sphere are rounded.
    #[must_use]
    pub fn boxes(&self) -> Vec<[Vec<f64>; 2]> {
        match self.piece() {
            Ok(piece) => piece.boxes(),
            Err(shapes) => shapes.iter().flat_map(Shape::boxes).collect(),
        }
    }

    /// Returns the kind of each piece and the values of its parts, of which [`Kind::shape`] makes the piece
    /// again.
    #[must_use]
    pub fn described(&self) -> Vec<(Kind, Vec<Value>)> {
        match self.piece() {
            Ok(piece) => vec![(piece.kind(), piece.values())],
            Err(shapes) => shapes.iter().flat_map(Shape::described).collect(),
        }
    }

    /// Returns the name of the kind of set, with its article.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.piece().map_or("a union", |piece| piece.kind().name)
    }

    /// Returns whether `x` is a member, decided in exact arithmetic; false if a coordinate is not
    /// finite. Of a slanted segment or subspace only those members are known that
    /// [`ClosedSet::member_near`] proves.
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
    pub fn contains(&self, x: &(impl AsRef<[f64]> + ?Sized)) -> bool {
        self.has(x.as_ref())
    }

    fn has(&self, x: &[f64]) -> bool {
        match self.piece() {
            Ok(piece) => piece.has(x),
            Err(shapes) => shapes.iter().any(|shape| shape.has(x)),
        }
    }

    /// Returns the same set in terms of points, balls, boxes, half-spaces and unions of them, the kinds
    /// that certificates know; `None` for a set with pieces of other kinds.
    #[must_use]
    pub fn into_elementary(self) -> Option<Self> {
        match self {
            Shape::FiniteSet(set) => {
                Some(Shape::Union(set.points().iter().cloned().map(Shape::Point).collect()))
            }
            Shape::Union(shapes) => {
                let shapes: Option<_> = shapes.into_iter().map(Shape::into_elementary).collect();
                shapes.map(Shape::Union)
            }
            Shape::Point(_) | Shape::Ball(_) | Shape::AxisBox(_) | Shape::HalfSpace(_) => {
                Some(self)
            }
            _ => None,
        }
    }

    /// Returns the same set as one whose dimension is a value.
    #[must_use]
    pub fn into_any(self) -> Shape<ANY> {
        self.cast()
    }

    /// Returns the shape of a union of sets; `None` if one of them has no shape.
    pub(crate) fn of_sets(sets: &[Arc<dyn ClosedSet<D>>]) -> Option<Self> {
        sets.iter().map(|set| ClosedSet::shape(&**set)).collect::<Option<_>>().map(Shape::Union)
    }
}

impl Shape<ANY> {
    /// Returns the same set as one of `R^E`.
    ///
    /// # Errors
    ///
    /// [`SetError::Coordinates`] if a piece lies in another dimension.
    pub fn into_dimension<const E: usize>(self) -> Result<Shape<E>, SetError> {
        match self.pieces().iter().find(|piece| piece.dimension() != E) {
            Some(other) => Err(SetError::Coordinates {
                what: other.name(),
                found: other.dimension(),
                dimension: E,
            }),
            None => Ok(self.cast()),
        }
    }
}

impl<const D: usize> AnySet for Shape<D> {
    /// Returns the dimension; that of the first member of a union, and 0 without members.
    fn dimension(&self) -> usize {
        match self.piece() {
            Ok(piece) => piece.dimension(),
            Err(shapes) => shapes.first().map_or(0, Shape::dimension),
        }
    }

    fn project(&self, x: &mut [f64]) {
        match self.piece() {
            Ok(piece) => piece.project(x),
            Err(shapes) => Pieces(|| shapes.iter()).project(x),
        }
    }

    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]) {
        match self.piece() {
            Ok(piece) => piece.projection_derivative(x, derivative),
            Err(shapes) => Pieces(|| shapes.iter()).projection_derivative(x, derivative),
        }
    }

    fn radius(&self) -> Option<f64> {
        match self.piece() {
            Ok(piece) => piece.radius(),
            Err(shapes) => Pieces(|| shapes.iter()).radius(),
        }
    }

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        match self.piece() {
            Ok(piece) => piece.enclosing_ball(),
            Err(shapes) => Pieces(|| shapes.iter()).enclosing_ball(),
        }
    }

    fn is_convex(&self) -> bool {
        match self.piece() {
            Ok(piece) => piece.is_convex(),
            Err(shapes) => Pieces(|| shapes.iter()).is_convex(),
        }
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        match self.piece() {
            Ok(piece) => piece.member_near(x),
            Err(shapes) => Pieces(|| shapes.iter()).member_near(x),
        }
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(self.clone().into_any())
    }

    fn pieces(&self) -> Vec<Arc<dyn AnySet>> {
        let piece = |shape: &Self| -> Vec<Arc<dyn AnySet>> {
            let pieces = AnySet::pieces(shape);
            if pieces.is_empty() { vec![Arc::new(shape.clone().into_any())] } else { pieces }
        };
        match self.piece() {
            Ok(piece) => piece.pieces(),
            Err(shapes) => shapes.iter().flat_map(piece).collect(),
        }
    }

    fn seeds(&self) -> Vec<Vec<f64>> {
        match self.piece() {
            Ok(piece) => piece.seeds(),
            Err(shapes) => Pieces(|| shapes.iter()).seeds(),
        }
    }
}

impl<const D: usize> ClosedSet<D> for Shape<D> {
    closed_set_in_any!(self => self.clone());

    fn pieces(&self) -> Vec<Arc<dyn ClosedSet<D>>> {
        match self {
            Shape::FiniteSet(set) => ClosedSet::pieces(set),
            Shape::Union(shapes) => {
                let mut pieces = Vec::new();
                for shape in shapes {
                    append_pieces(&(Arc::new(shape.clone()) as Arc<dyn ClosedSet<D>>), &mut pieces);
                }
                pieces
            }
            _ => Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{SVector, vector};
    use tautline_chance::{Random, cases, seed};
    use tautline_scalar::ANY;

    use super::Shape;
    use crate::{
        AffineSubspace, AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, Point, Segment, SetError,
        Sphere, Union,
        laws::Bare,
        numerics::exact::{Exact, least_product, point, square, squared_distances},
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

    /// Vectors of other lengths are refused by every kind, in a dimension that the compiler knows and in
    /// one that is a value.
    #[test]
    fn the_vectors_of_a_set_have_one_dimension() {
        fn kinds<const D: usize>(x: &[f64], y: &[f64]) -> [Result<Shape<D>, SetError>; 8] {
            [
                Point::from_slice(x).map(Shape::Point),
                FiniteSet::from_slices([x, y]).map(Shape::FiniteSet),
                Ball::from_slice(x, 1.0).map(Shape::Ball),
                Sphere::from_slice(x, 1.0).map(Shape::Sphere),
                AxisBox::from_slices(x, y).map(Shape::AxisBox),
                Segment::from_slices(x, y).map(Shape::Segment),
                HalfSpace::from_slice(x, 1.0).map(Shape::HalfSpace),
                AffineSubspace::from_slices(x, [y]).map(Shape::AffineSubspace),
            ]
        }
        let (x, y) = ([0.0, -1.0], [3.0, 4.0, 5.0]);
        let known = kinds::<2>(&x, &y[..2]);
        for (known, any) in known.iter().zip(kinds::<ANY>(&x, &y[..2])) {
            let (known, any) = (known.clone().expect("two coordinates"), any.expect("as many"));
            assert_eq!(known.clone().into_any(), any);
            assert_eq!(any.clone().into_dimension(), Ok(known));
            let what = any.name();
            let other = SetError::Coordinates { what, found: 2, dimension: 3 };
            assert_eq!(any.into_dimension::<3>(), Err(other));
        }
        for shape in kinds::<3>(&x, &x) {
            let error = shape.expect_err("two coordinates in space");
            assert!(
                matches!(error, SetError::Coordinates { found: 2, dimension: 3, .. }),
                "{error}"
            );
        }
        let pairs = kinds::<ANY>(&x, &y).into_iter().filter(Result::is_err);
        for error in pairs.clone().map(|shape| shape.expect_err("an error")) {
            assert!(
                matches!(error, SetError::Coordinates { found: 3, dimension: 2, .. }),
                "{error}"
            );
        }
        assert_eq!(pairs.count(), 4);
        for shape in kinds::<ANY>(&[], &[]) {
            assert!(matches!(shape, Err(SetError::NoCoordinates { .. })), "{shape:?}");
        }
        let [plane, space] = [&x[..], &y[..]].map(|x| Point::from_slice(x).map(Shape::Point));
        let both = vec![plane.expect("finite"), space.expect("finite")];
        assert_eq!(
            Shape::<ANY>::union(both),
            Err(SetError::Coordinates { what: "a point", found: 3, dimension: 2 })
        );
        assert_eq!(Shape::<ANY>::union(Vec::new()), Err(SetError::Empty));
    }

    /// What is no union of points, balls, boxes and half-spaces has no elementary form.
    #[test]
    fn finite_sets_are_elementary_and_spheres_are_not() {
        let points = FiniteSet::new([[0.0], [1.0]]).expect("finite");
        let spots = [0.0, 1.0].map(|x| Shape::Point(Point::new([x]).expect("finite")));
        let union = Shape::Union(spots.to_vec());
        assert_eq!(Shape::FiniteSet(points.clone()).into_elementary(), Some(union.clone()));
        let sphere = Shape::Sphere(Sphere::new([0.0], 1.0).expect("finite"));
        let mixed = Shape::Union(vec![union.clone(), sphere.clone()]);
        assert_eq!((sphere.into_elementary(), mixed.into_elementary()), (None, None));
        let nested = Shape::Union(vec![Shape::FiniteSet(points)]);
        assert_eq!(nested.into_elementary(), Some(Shape::Union(vec![union])));
    }

    #[test]
    fn each_bounded_piece_has_its_box() {
        let points = FiniteSet::new([[0.0, 1.0], [3.0, 2.0]]).expect("finite");
        let union = Shape::Union(vec![
            Shape::Sphere(Sphere::new([1.0, 2.0], 5.0).expect("a radius")),
            Shape::HalfSpace(HalfSpace::new([1.0, 0.0], 1.0).expect("a normal")),
            Shape::Segment(Segment::new([4.0, 1.0], [-1.0, 2.0]).expect("finite")),
            Shape::FiniteSet(points),
            Shape::AxisBox(AxisBox::from_corners([0.0, 0.5], [1.0, 2.0]).expect("ordered")),
        ]);
        let expected = [
            [[-4.0, -3.0], [6.0, 7.0]],
            [[-1.0, 1.0], [4.0, 2.0]],
            [[0.0, 1.0], [0.0, 1.0]],
            [[3.0, 2.0], [3.0, 2.0]],
            [[0.0, 0.5], [1.0, 2.0]],
        ];
        assert_eq!(union.boxes(), expected.map(|corners| corners.map(|x| x.to_vec())));
    }

    #[test]
    fn members_of_thin_sets_are_proved() {
        let sphere = Shape::Sphere(Sphere::new([1.0, 2.0], 5.0).expect("finite"));
        assert!(sphere.contains(&[4.0, 6.0]) && !sphere.contains(&[4.0, 6.0_f64.next_down()]));
        let points = Shape::FiniteSet(FiniteSet::new([[0.0, 1.0], [2.0, 3.0]]).expect("finite"));
        assert!(points.contains(&[2.0, 3.0]) && !points.contains(&[0.0, 3.0]));
        let segment = Shape::Segment(Segment::new([0.1, 1.0], [0.1, 2.0]).expect("finite"));
        assert!(segment.contains(&[0.1, 1.5]) && !segment.contains(&[0.1, 2.5]));
        assert!(!segment.contains(&[0.1, f64::NAN]));
        let line = AffineSubspace::new([0.1, 1.0], [[0.0, 3.0]]).expect("a direction");
        let line = Shape::AffineSubspace(line);
        assert!(line.contains(&[0.1, 9.0]) && !line.contains(&[0.2, 9.0]));
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

    /// A set of one's own is no shape, so a union with one has no data, wherever it stands in it.
    #[test]
    fn a_union_is_a_shape_only_if_each_of_its_pieces_is() {
        let spot: Arc<dyn ClosedSet<2>> = Arc::new(Point::new([9.0, 9.0]).expect("finite"));
        let ball: Arc<dyn ClosedSet<2>> = Arc::new(Ball::new([0.0, 0.0], 1.0).expect("finite"));
        let project = |_: &SVector<f64, 2>| vector![4.0, 0.0];
        let rim: Arc<dyn ClosedSet<2>> = Arc::new(Bare { project, radius: Some(5.0) });
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
