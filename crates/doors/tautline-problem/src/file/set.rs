//! `SetFile`: a closed set in a file.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{expression::Text, placed::Placed};

/// The coordinates of a point or a vector.
pub(crate) type Vector = Placed<Vec<Text>>;

/// A closed set: one of the keys `point`, `points`, `ball`, `sphere`, `box`, `half_space`,
/// `segment`, `affine` and `union`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum SetFile {
    /// A point: `point = [0, 0]`.
    Point(Vector),
    /// Finitely many points: `points = [[0, 0], [1, 2]]`.
    Points(Placed<Vec<Vector>>),
    /// The ball `|x − centre| ≤ radius`.
    Ball(Round),
    /// The sphere `|x − centre| = radius`.
    Sphere(Round),
    /// The box `lower ≤ x ≤ upper`, coordinate by coordinate.
    Box(Corners),
    /// The half-space `normal·x ≥ at_least`, or `normal·x ≤ at_most`.
    HalfSpace(HalfSpaceFile),
    /// The segment between two points.
    Segment(SegmentFile),
    /// The affine subspace through `through`, spanned by `directions`.
    Affine(AffineFile),
    /// The union of sets: `union = [{ point = [0, 0] }, { ball = … }]`.
    Union(Placed<Vec<SetFile>>),
}

/// A ball or a sphere.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Round {
    /// The centre.
    pub(crate) centre: Vector,
    /// The radius, at least 0.
    pub(crate) radius: Text,
}

/// A box.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Corners {
    /// The corner with the least coordinates.
    pub(crate) lower: Vector,
    /// The corner with the largest coordinates.
    pub(crate) upper: Vector,
}

/// A half-space: one of `at_least` and `at_most`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct HalfSpaceFile {
    /// A vector orthogonal to the boundary, of any length but 0.
    pub(crate) normal: Vector,
    /// The least value of `normal·x`.
    pub(crate) at_least: Option<Text>,
    /// The largest value of `normal·x`.
    pub(crate) at_most: Option<Text>,
}

/// A segment.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SegmentFile {
    /// One end.
    pub(crate) from: Vector,
    /// The other end.
    pub(crate) to: Vector,
}

/// An affine subspace.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AffineFile {
    /// A point of the subspace.
    pub(crate) through: Vector,
    /// Linearly independent directions.
    pub(crate) directions: Placed<Vec<Vector>>,
}

impl SetFile {
    /// Returns all points and vectors, in the order of their fields.
    pub(crate) fn vectors(&self) -> Vec<&Vector> {
        match self {
            SetFile::Point(x) => vec![x],
            SetFile::Points(points) => points.get_ref().iter().collect(),
            SetFile::Ball(Round { centre, .. }) | SetFile::Sphere(Round { centre, .. }) => {
                vec![centre]
            }
            SetFile::Box(Corners { lower, upper }) => vec![lower, upper],
            SetFile::HalfSpace(HalfSpaceFile { normal, .. }) => vec![normal],
            SetFile::Segment(SegmentFile { from, to }) => vec![from, to],
            SetFile::Affine(AffineFile { through, directions }) => {
                std::iter::once(through).chain(directions.get_ref()).collect()
            }
            SetFile::Union(sets) => sets.get_ref().iter().flat_map(SetFile::vectors).collect(),
        }
    }
}
