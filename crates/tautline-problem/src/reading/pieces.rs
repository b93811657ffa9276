//! The sets of a file, with their numbers evaluated.

use std::ops::Range;

use tautline_picture::portrait::Shape;

use crate::{
    Diagnostic,
    file::{
        placed::Placed,
        request::CertifyFile,
        set::{AffineFile, Corners, HalfSpaceFile, Round, SegmentFile, SetFile, Vector},
    },
    reading::{numbers::Numbers, shape::Piece},
};

/// Returns the pieces of a set. Unions of unions are flattened.
pub(crate) fn pieces(
    set: &SetFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Vec<Piece>, Diagnostic> {
    let vector = |vector: &Vector| numbers.vector(vector, dimension);
    let list = |vectors: &[Vector]| vectors.iter().map(vector).collect::<Result<Vec<_>, _>>();
    let (shape, places): (Shape, Vec<Range<usize>>) = match set {
        SetFile::Point(x) => (Shape::Point(vector(x)?), vec![x.span()]),
        SetFile::Points(points) => (Shape::Points(list(points.get_ref())?), vec![points.span()]),
        SetFile::Ball(Round { centre, radius }) | SetFile::Sphere(Round { centre, radius }) => {
            let places = vec![centre.span(), radius.span()];
            let (centre, radius) = (vector(centre)?, numbers.number(radius)?);
            if matches!(set, SetFile::Ball(_)) {
                (Shape::Ball { centre, radius }, places)
            } else {
                (Shape::Sphere { centre, radius }, places)
            }
        }
        SetFile::Box(corners @ Corners { lower, upper }) => {
            let places = vec![lower.span(), upper.span()];
            let [low, high] = self::corners(corners, numbers, dimension)?;
            (Shape::AxisBox { low, high }, places)
        }
        SetFile::HalfSpace(HalfSpaceFile { normal, at_least, at_most }) => {
            let places = vec![normal.span()];
            let (span, normal) = (normal.span(), vector(normal)?);
            match (at_least, at_most) {
                (Some(at_least), None) => {
                    let normal = normal.iter().map(|x| -x).collect();
                    (Shape::HalfSpace { normal, offset: -numbers.number(at_least)? }, places)
                }
                (None, Some(at_most)) => {
                    (Shape::HalfSpace { normal, offset: numbers.number(at_most)? }, places)
                }
                (Some(_), Some(other)) => {
                    return Err(Diagnostic::new("a half-space has one side", other.span())
                        .label("expected at_least or at_most, not both"));
                }
                (None, None) => {
                    return Err(Diagnostic::new("a half-space needs at_least or at_most", span)
                        .label("the side of this normal is not given"));
                }
            }
        }
        SetFile::Segment(SegmentFile { from, to }) => {
            let places = vec![from.span(), to.span()];
            (Shape::Segment { from: vector(from)?, to: vector(to)? }, places)
        }
        SetFile::Affine(AffineFile { through, directions }) => {
            let spans = directions.get_ref().iter().map(Placed::span);
            let places = std::iter::once(through.span()).chain(spans).collect();
            let (point, directions) = (vector(through)?, list(directions.get_ref())?);
            (Shape::AffineSubspace { point, directions }, places)
        }
        SetFile::Union(sets) => {
            let sets_of = |set| pieces(set, numbers, dimension);
            let all: Vec<Vec<Piece>> =
                sets.get_ref().iter().map(sets_of).collect::<Result<_, _>>()?;
            if all.is_empty() {
                return Err(Diagnostic::new("a union of no sets", sets.span()));
            }
            return Ok(all.into_iter().flatten().collect());
        }
    };
    Ok(vec![Piece { shape, places }])
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
