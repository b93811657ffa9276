//! The periods of the coordinates of a file.

use tautline::{Shape, translates};

use crate::{
    Diagnostic,
    file::{placed::Placed, set::Vector},
    reading::{numbers::Numbers, shape::Piece},
};

/// Evaluates the period of each coordinate.
pub(crate) fn periods(
    vector: &Vector,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Placed<Vec<f64>>, Diagnostic> {
    let values = numbers.vector(vector, dimension)?;
    if let Some(at) = values.iter().position(|&period| period < 0.0) {
        return Err(Diagnostic::new(
            format!("the period {}", values[at]),
            vector.get_ref()[at].span(),
        )
        .label("expected a positive number, or 0 for a coordinate that has no period"));
    }
    Ok(Placed::at(vector.span(), values))
}

/// Returns the pieces of the second set, each with those of its translates that come near to the first set.
pub(crate) fn with_translates(
    [from, to]: &[Vec<Piece>; 2],
    periods: &Placed<Vec<f64>>,
) -> Result<Vec<Piece>, Diagnostic> {
    let refuse = |error: tautline::SetError| Diagnostic::new(error.to_string(), periods.span());
    let from =
        Shape::union(from.iter().map(|piece| piece.shape.clone()).collect()).map_err(refuse)?;
    let mut all = Vec::new();
    for Piece { shape, places } in to {
        let found = translates(shape, &from, periods.get_ref()).map_err(refuse)?;
        all.extend(found.into_iter().map(|shape| Piece { shape, places: places.clone() }));
    }
    Ok(all)
}
