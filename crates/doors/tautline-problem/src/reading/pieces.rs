//! The sets of a file, with their numbers evaluated.

use std::ops::Range;

use tautline::{
    ANY, AffineSubspace, AxisBox, Ball, FiniteSet, HalfSpace, Point, Segment, SetError, Shape,
    Sphere,
};

use crate::{
    Diagnostic,
    file::{
        placed::Placed,
        request::CertifyFile,
        set::{AffineFile, Corners, HalfSpaceFile, Round, SegmentFile, SetFile, Vector},
    },
    reading::{
        numbers::Numbers,
        shape::{Piece, refused},
    },
};

/// Returns the pieces of a set. Unions of unions are flattened.
pub(crate) fn pieces(
    set: &SetFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Vec<Piece>, Diagnostic> {
    drafts(set, numbers, dimension)?.into_iter().map(Draft::checked).collect()
}

/// A piece whose numbers may be wrong.
pub(crate) struct Draft {
    pub(crate) shape: Result<Shape<ANY>, SetError>,
    /// As in a [`Piece`].
    pub(crate) places: Vec<Range<usize>>,
}

impl Draft {
    fn checked(self) -> Result<Piece, Diagnostic> {
        let Self { shape, places } = self;
        let shape = shape.map_err(|error| refused(&error, &places))?;
        Ok(Piece { shape, places })
    }
}

/// Returns the pieces of a set as its numbers describe them.
pub(crate) fn drafts(
    set: &SetFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Vec<Draft>, Diagnostic> {
    let vector = |vector: &Vector| numbers.vector(vector, dimension);
    let list = |vectors: &[Vector]| vectors.iter().map(vector).collect::<Result<Vec<_>, _>>();
    let (shape, places): (Result<Shape<ANY>, SetError>, Vec<Range<usize>>) = match set {
        SetFile::Point(x) => (Point::from_slice(&vector(x)?).map(Shape::Point), vec![x.span()]),
        SetFile::Points(points) => {
            let set = FiniteSet::from_slices(list(points.get_ref())?).map(Shape::FiniteSet);
            (set, vec![points.span()])
        }
        SetFile::Ball(Round { centre, radius }) | SetFile::Sphere(Round { centre, radius }) => {
            let places = vec![centre.span(), radius.span()];
            let (centre, radius) = (vector(centre)?, numbers.number(radius)?);
            if matches!(set, SetFile::Ball(_)) {
                (Ball::from_slice(&centre, radius).map(Shape::Ball), places)
            } else {
                (Sphere::from_slice(&centre, radius).map(Shape::Sphere), places)
            }
        }
        SetFile::Box(corners @ Corners { lower, upper }) => {
            let places = vec![lower.span(), upper.span()];
            let [low, high] = self::corners(corners, numbers, dimension)?;
            (AxisBox::from_slices(&low, &high).map(Shape::AxisBox), places)
        }
        SetFile::HalfSpace(HalfSpaceFile { normal, at_least, at_most }) => {
            let places = vec![normal.span()];
            let (span, normal) = (normal.span(), vector(normal)?);
            let (normal, offset): (Vec<f64>, f64) = match (at_least, at_most) {
                (Some(at_least), None) => {
                    (normal.iter().map(|x| -x).collect(), -numbers.number(at_least)?)
                }
                (None, Some(at_most)) => (normal, numbers.number(at_most)?),
                (Some(_), Some(other)) => {
                    return Err(Diagnostic::new("a half-space has one side", other.span())
                        .label("expected at_least or at_most, not both"));
                }
                (None, None) => {
                    return Err(Diagnostic::new("a half-space needs at_least or at_most", span)
                        .label("the side of this normal is not given"));
                }
            };
            (HalfSpace::from_slice(&normal, offset).map(Shape::HalfSpace), places)
        }
        SetFile::Segment(SegmentFile { from, to }) => {
            let places = vec![from.span(), to.span()];
            (Segment::from_slices(&vector(from)?, &vector(to)?).map(Shape::Segment), places)
        }
        SetFile::Affine(AffineFile { through, directions }) => {
            let spans = directions.get_ref().iter().map(Placed::span);
            let places = std::iter::once(through.span()).chain(spans).collect();
            let (base, directions) = (vector(through)?, list(directions.get_ref())?);
            (AffineSubspace::from_slices(&base, directions).map(Shape::AffineSubspace), places)
        }
        SetFile::Union(sets) => {
            let drafts_of = |set| drafts(set, numbers, dimension);
            let all: Vec<Vec<Draft>> =
                sets.get_ref().iter().map(drafts_of).collect::<Result<_, _>>()?;
            if all.is_empty() {
                return Err(Diagnostic::new("a union of no sets", sets.span()));
            }
            return Ok(all.into_iter().flatten().collect());
        }
    };
    Ok(vec![Draft { shape, places }])
}

pub(crate) fn corners(
    Corners { lower, upper }: &Corners,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<[Vec<f64>; 2], Diagnostic> {
    Ok([numbers.vector(lower, dimension)?, numbers.vector(upper, dimension)?])
}

/// Returns the corners of the box in which samples are drawn.
pub(crate) fn sampled(
    region: &Corners,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<[Vec<f64>; 2], Diagnostic> {
    let [lower, upper] = corners(region, numbers, dimension)?;
    if lower.iter().zip(&upper).all(|(low, high)| high - low > 0.0 && (high - low).is_finite()) {
        return Ok([lower, upper]);
    }
    Err(Diagnostic::new("an empty region", region.upper.span())
        .label("expected larger coordinates than those of lower"))
}

/// Returns the region on which constants are proved.
pub(crate) fn region(
    certify: &CertifyFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Option<Piece>, Diagnostic> {
    let Some(within) = &certify.within else { return Ok(None) };
    match within.get_ref() {
        set @ (SetFile::Ball(_) | SetFile::Box(_)) => {
            Ok(pieces(set, numbers, dimension)?.into_iter().next())
        }
        _ => Err(Diagnostic::new("constants are proved in a ball or in a box", within.span())
            .label("expected ball or box")),
    }
}
