//! The sets of a file, with their numbers evaluated.

use std::ops::Range;

use tautline::{ANY, AxisBox, Ball, SetError, Shape, sets::kind::Value};

use crate::{
    Diagnostic,
    file::{
        placed::Placed,
        request::CertifyFile,
        set::{Corners, PieceFile, SetFile, ValueFile, Vector},
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
    match set {
        SetFile::Piece(piece) => Ok(vec![draft(piece, numbers, dimension)?.checked()?]),
        SetFile::Union(sets) if sets.get_ref().is_empty() => {
            Err(Diagnostic::new("a union of no sets", sets.span()))
        }
        SetFile::Union(sets) => {
            let all = sets.get_ref().iter().map(|set| pieces(set, numbers, dimension));
            Ok(all.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
        }
    }
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

/// Returns a piece as its numbers describe it.
pub(crate) fn draft(
    PieceFile { kind, values }: &PieceFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Draft, Diagnostic> {
    let vector = |vector: &Vector| numbers.vector(vector, dimension);
    let mut places: Vec<Range<usize>> = Vec::new();
    let mut read = Vec::new();
    for value in values {
        read.push(match value {
            ValueFile::Vector(x) => {
                places.push(x.span());
                Value::Vector(vector(x)?)
            }
            ValueFile::Vectors(rows) => {
                // A single part is blamed as a whole.
                match values.len() {
                    1 => places.push(rows.span()),
                    _ => places.extend(rows.get_ref().iter().map(Placed::span)),
                }
                Value::Vectors(rows.get_ref().iter().map(vector).collect::<Result<_, _>>()?)
            }
            ValueFile::Number(text) => {
                places.push(text.span());
                Value::Number(numbers.number(text)?)
            }
            ValueFile::Sides([Some(text), None]) => Value::AtLeast(numbers.number(text)?),
            ValueFile::Sides([None, Some(text)]) => Value::AtMost(numbers.number(text)?),
            ValueFile::Sides([Some(_), Some(other)]) => {
                return Err(Diagnostic::new(format!("{} has one side", kind.name), other.span())
                    .label("expected at_least or at_most, not both"));
            }
            ValueFile::Sides([None, None]) => {
                let place = places.last().cloned().unwrap_or_default();
                let needed = format!("{} needs at_least or at_most", kind.name);
                return Err(Diagnostic::new(needed, place).label("its side is not given"));
            }
        });
    }
    Ok(Draft { shape: kind.shape(&read), places })
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
    let provable = [Ball::<ANY>::KIND, AxisBox::<ANY>::KIND];
    match within.get_ref() {
        SetFile::Piece(piece) if provable.contains(&piece.kind) => {
            draft(piece, numbers, dimension)?.checked().map(Some)
        }
        _ => Err(Diagnostic::new("constants are proved in a ball or in a box", within.span())
            .label("expected ball or box")),
    }
}
