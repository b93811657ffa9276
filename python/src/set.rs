//! `Set`: a closed set.

use pyo3::{prelude::*, types::PyType};
use tautline_problem::value::Shape;

use crate::error::ProblemError;

/// A closed set: a piece, or the union of several with `|`.
#[pyclass(frozen, from_py_object, module = "tautline")]
#[derive(Clone, Debug)]
pub(crate) struct Set {
    pub(crate) pieces: Vec<Shape>,
}

impl From<Shape> for Set {
    fn from(shape: Shape) -> Self {
        Self { pieces: vec![shape] }
    }
}

/// A piece as the name of its kind, its vectors, and its numbers.
type Piece = (String, Vec<Vec<f64>>, Vec<f64>);

/// Returns the parts of a piece, of which `whole` makes it again.
fn parts(shape: &Shape) -> Piece {
    let (kind, vectors, numbers) = match shape.clone() {
        Shape::Point(x) => ("point", vec![x], vec![]),
        Shape::Points(points) => ("points", points, vec![]),
        Shape::Ball { centre, radius } => ("ball", vec![centre], vec![radius]),
        Shape::Sphere { centre, radius } => ("sphere", vec![centre], vec![radius]),
        Shape::AxisBox { low, high } => ("box", vec![low, high], vec![]),
        Shape::HalfSpace { normal, offset } => ("half_space", vec![normal], vec![offset]),
        Shape::Segment { from, to } => ("segment", vec![from, to], vec![]),
        Shape::AffineSubspace { point, directions } => {
            ("affine_subspace", [vec![point], directions].concat(), vec![])
        }
    };
    (kind.to_owned(), vectors, numbers)
}

fn whole((kind, vectors, numbers): Piece) -> PyResult<Shape> {
    let unknown = format!("no piece of a set: {kind:?}, {vectors:?}, {numbers:?}");
    Ok(match (&kind[..], &vectors[..], &numbers[..]) {
        ("point", [x], []) => Shape::Point(x.clone()),
        ("points", _, []) => Shape::Points(vectors),
        ("ball", [centre], &[radius]) => Shape::Ball { centre: centre.clone(), radius },
        ("sphere", [centre], &[radius]) => Shape::Sphere { centre: centre.clone(), radius },
        ("box", [low, high], []) => Shape::AxisBox { low: low.clone(), high: high.clone() },
        ("half_space", [normal], &[offset]) => Shape::HalfSpace { normal: normal.clone(), offset },
        ("segment", [from, to], []) => Shape::Segment { from: from.clone(), to: to.clone() },
        ("affine_subspace", [point, directions @ ..], []) => {
            Shape::AffineSubspace { point: point.clone(), directions: directions.to_vec() }
        }
        _ => return Err(ProblemError::new_err(unknown)),
    })
}

#[pymethods]
impl Set {
    /// A set from the parts of its pieces, as another process receives them.
    #[new]
    fn new(pieces: Vec<Piece>) -> PyResult<Self> {
        Ok(Self { pieces: pieces.into_iter().map(whole).collect::<PyResult<_>>()? })
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, (Vec<Piece>,)) {
        (slf.get_type(), (slf.get().pieces.iter().map(parts).collect(),))
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
pub(crate) fn point(x: Vec<f64>) -> Set {
    Shape::Point(x).into()
}

/// Finitely many points, an array of shape (m, D).
#[pyfunction]
pub(crate) fn points(x: Vec<Vec<f64>>) -> Set {
    Shape::Points(x).into()
}

/// The ball |x - centre| <= radius.
#[pyfunction]
pub(crate) fn ball(centre: Vec<f64>, radius: f64) -> Set {
    Shape::Ball { centre, radius }.into()
}

/// The sphere |x - centre| = radius.
#[pyfunction]
pub(crate) fn sphere(centre: Vec<f64>, radius: f64) -> Set {
    Shape::Sphere { centre, radius }.into()
}

/// The box lower <= x <= upper.
#[pyfunction]
#[pyo3(name = "box")]
pub(crate) fn box_(lower: Vec<f64>, upper: Vec<f64>) -> Set {
    Shape::AxisBox { low: lower, high: upper }.into()
}

/// The half-space normal·x <= at_most, or normal·x >= at_least.
#[pyfunction]
#[pyo3(signature = (normal, *, at_most=None, at_least=None))]
pub(crate) fn half_space(
    normal: Vec<f64>,
    at_most: Option<f64>,
    at_least: Option<f64>,
) -> PyResult<Set> {
    match (at_most, at_least) {
        (Some(offset), None) => Ok(Shape::HalfSpace { normal, offset }.into()),
        (None, Some(offset)) => {
            let normal = normal.into_iter().map(|n| -n).collect();
            Ok(Shape::HalfSpace { normal, offset: -offset }.into())
        }
        _ => Err(ProblemError::new_err("a half-space has either at_most or at_least")),
    }
}

/// The segment between two points.
#[pyfunction]
pub(crate) fn segment(start: Vec<f64>, end: Vec<f64>) -> Set {
    Shape::Segment { from: start, to: end }.into()
}

/// The points point + t1 directions[0] + t2 directions[1] + … for all real t.
#[pyfunction]
pub(crate) fn affine_subspace(point: Vec<f64>, directions: Vec<Vec<f64>>) -> Set {
    Shape::AffineSubspace { point, directions }.into()
}

/// The union of sets.
#[pyfunction]
#[pyo3(signature = (*sets))]
pub(crate) fn union(sets: Vec<Set>) -> Set {
    Set { pieces: sets.into_iter().flat_map(|set| set.pieces).collect() }
}
