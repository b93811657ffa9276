//! `Set`: a closed set.

use pyo3::{prelude::*, types::PyType};
use tautline::{
    AffineSubspace, AxisBox, Ball, FiniteSet, HalfSpace, Point, Segment, SetError, Sphere,
};
use tautline_any::Shape;

use crate::error::ProblemError;

/// A closed set: a piece, or the union of several with `|`.
#[pyclass(frozen, from_py_object, module = "tautline")]
#[derive(Clone, Debug)]
pub(crate) struct Set {
    pub(crate) pieces: Vec<Shape>,
}

impl Set {
    /// Returns the set of one piece.
    fn of(shape: Result<Shape, SetError>) -> PyResult<Self> {
        let shape = shape.map_err(|error| ProblemError::new_err(error.to_string()))?;
        Ok(Self { pieces: vec![shape] })
    }
}

/// A piece as the name of its kind, its vectors, and its numbers.
type Piece = (String, Vec<Vec<f64>>, Vec<f64>);

/// Returns the parts of a piece, of which `whole` makes it again.
fn parts(shape: &Shape) -> Vec<Piece> {
    let list = |vectors: &[&[f64]]| vectors.iter().map(|x| x.to_vec()).collect();
    let (kind, vectors, numbers): (&str, Vec<Vec<f64>>, Vec<f64>) = match shape {
        Shape::Point(point) => ("point", list(&[point.position_slice()]), vec![]),
        Shape::FiniteSet(set) => {
            let points = set.points().iter().map(|point| point.position_slice().to_vec());
            ("points", points.collect(), vec![])
        }
        Shape::Ball(ball) => ("ball", list(&[ball.centre_slice()]), vec![ball.r()]),
        Shape::Sphere(sphere) => ("sphere", list(&[sphere.centre_slice()]), vec![sphere.r()]),
        Shape::AxisBox(side) => ("box", list(&side.corner_slices()), vec![]),
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given_slice();
            ("half_space", list(&[normal]), vec![offset])
        }
        Shape::Segment(segment) => ("segment", list(&segment.end_slices()), vec![]),
        Shape::AffineSubspace(subspace) => {
            let directions = subspace.given_slices().iter().map(|v| v.to_vec());
            let vectors = std::iter::once(subspace.base_slice().to_vec()).chain(directions);
            ("affine_subspace", vectors.collect(), vec![])
        }
        Shape::Union(shapes) => return shapes.iter().flat_map(parts).collect(),
    };
    vec![(kind.to_owned(), vectors, numbers)]
}

fn whole((kind, vectors, numbers): Piece) -> PyResult<Shape> {
    let shape = match (&kind[..], &vectors[..], &numbers[..]) {
        ("point", [x], []) => Point::from_slice(x).map(Shape::Point),
        ("points", points, []) => FiniteSet::from_slices(points).map(Shape::FiniteSet),
        ("ball", [centre], &[radius]) => Ball::from_slice(centre, radius).map(Shape::Ball),
        ("sphere", [centre], &[radius]) => Sphere::from_slice(centre, radius).map(Shape::Sphere),
        ("box", [low, high], []) => AxisBox::from_slices(low, high).map(Shape::AxisBox),
        ("half_space", [normal], &[offset]) => {
            HalfSpace::from_slice(normal, offset).map(Shape::HalfSpace)
        }
        ("segment", [start, end], []) => Segment::from_slices(start, end).map(Shape::Segment),
        ("affine_subspace", [point, directions @ ..], []) => {
            AffineSubspace::from_slices(point, directions).map(Shape::AffineSubspace)
        }
        _ => {
            let unknown = format!("no piece of a set: {kind:?}, {vectors:?}, {numbers:?}");
            return Err(ProblemError::new_err(unknown));
        }
    };
    shape.map_err(|error| ProblemError::new_err(error.to_string()))
}

#[pymethods]
impl Set {
    /// A set from the parts of its pieces, as another process receives them.
    #[new]
    fn new(pieces: Vec<Piece>) -> PyResult<Self> {
        Ok(Self { pieces: pieces.into_iter().map(whole).collect::<PyResult<_>>()? })
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, (Vec<Piece>,)) {
        (slf.get_type(), (slf.get().pieces.iter().flat_map(parts).collect(),))
    }

    fn __or__(&self, other: &Self) -> Self {
        Self { pieces: [&self.pieces[..], &other.pieces].concat() }
    }

    fn __repr__(&self) -> String {
        let names: Vec<&str> = self.pieces.iter().map(Shape::name).collect();
        format!("<tautline.Set: {}>", names.join(" and "))
    }
}

/// The set of one point.
#[pyfunction]
pub(crate) fn point(x: Vec<f64>) -> PyResult<Set> {
    Set::of(Point::from_slice(&x).map(Shape::Point))
}

/// Finitely many points, an array of shape (m, D).
#[pyfunction]
pub(crate) fn points(x: Vec<Vec<f64>>) -> PyResult<Set> {
    Set::of(FiniteSet::from_slices(x).map(Shape::FiniteSet))
}

/// The ball |x - centre| <= radius.
#[pyfunction]
pub(crate) fn ball(centre: Vec<f64>, radius: f64) -> PyResult<Set> {
    Set::of(Ball::from_slice(&centre, radius).map(Shape::Ball))
}

/// The sphere |x - centre| = radius.
#[pyfunction]
pub(crate) fn sphere(centre: Vec<f64>, radius: f64) -> PyResult<Set> {
    Set::of(Sphere::from_slice(&centre, radius).map(Shape::Sphere))
}

/// The box lower <= x <= upper.
#[pyfunction]
#[pyo3(name = "box")]
pub(crate) fn box_(lower: Vec<f64>, upper: Vec<f64>) -> PyResult<Set> {
    Set::of(AxisBox::from_slices(&lower, &upper).map(Shape::AxisBox))
}

/// The half-space normal·x <= at_most, or normal·x >= at_least.
#[pyfunction]
#[pyo3(signature = (normal, *, at_most=None, at_least=None))]
pub(crate) fn half_space(
    normal: Vec<f64>,
    at_most: Option<f64>,
    at_least: Option<f64>,
) -> PyResult<Set> {
    let (normal, offset): (Vec<f64>, f64) = match (at_most, at_least) {
        (Some(offset), None) => (normal, offset),
        (None, Some(offset)) => (normal.into_iter().map(|n| -n).collect(), -offset),
        _ => return Err(ProblemError::new_err("a half-space has either at_most or at_least")),
    };
    Set::of(HalfSpace::from_slice(&normal, offset).map(Shape::HalfSpace))
}

/// The segment between two points.
#[pyfunction]
pub(crate) fn segment(start: Vec<f64>, end: Vec<f64>) -> PyResult<Set> {
    Set::of(Segment::from_slices(&start, &end).map(Shape::Segment))
}

/// The points point + t1 directions[0] + t2 directions[1] + … for all real t.
#[pyfunction]
pub(crate) fn affine_subspace(point: Vec<f64>, directions: Vec<Vec<f64>>) -> PyResult<Set> {
    Set::of(AffineSubspace::from_slices(&point, directions).map(Shape::AffineSubspace))
}

/// The union of sets.
#[pyfunction]
#[pyo3(signature = (*sets))]
pub(crate) fn union(sets: Vec<Set>) -> Set {
    Set { pieces: sets.into_iter().flat_map(|set| set.pieces).collect() }
}
