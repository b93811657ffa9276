//! Why a portrait cannot be drawn.

use crate::DrawingError;

/// Why a portrait cannot be drawn. Each message names the number to change.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PortraitError {
    /// A problem has at least one dimension.
    #[error("a picture needs a dimension of at least 1, not 0")]
    NoDimension,
    /// A vector does not have a coordinate for each dimension.
    #[error("{what} has {length} coordinates, but the dimension is {dimension}")]
    Length {
        /// The vector, in words.
        what: String,
        /// Its number of coordinates.
        length: usize,
        /// The dimension.
        dimension: usize,
    },
    /// A number is not finite, or not in its range.
    #[error("{what} is {value}, which is not {want}")]
    Number {
        /// What the number is, in words.
        what: String,
        /// The number.
        value: f64,
        /// The condition that failed.
        want: &'static str,
    },
    /// The two coordinates that are drawn must exist and differ. They are counted from 0.
    #[error(
        "the coordinates {} and {} cannot be drawn: they must be two of 0 to {}",
        coordinates[0], coordinates[1], dimension - 1
    )]
    Coordinates {
        /// The coordinates as given.
        coordinates: [usize; 2],
        /// The dimension.
        dimension: usize,
    },
    /// The window has no interior, or its sides cannot be told apart in floating point.
    #[error("the window cannot be {from} to {to} along x{}: {want}", coordinate + 1)]
    Window {
        /// The coordinate, counted from 0.
        coordinate: usize,
        /// The lower end.
        from: f64,
        /// The upper end.
        to: f64,
        /// The condition that failed.
        want: &'static str,
    },
    /// There is no curve, no set and no window.
    #[error("there is neither a curve, a set nor a window that says what to draw")]
    Nothing,
    /// The Gram matrix has the wrong number of entries.
    #[error("the Gram matrix at {at:?} has {length} entries; a {dimension}×{dimension} matrix has {}", dimension * dimension)]
    Gram {
        /// Where it was evaluated.
        at: Vec<f64>,
        /// Its number of entries.
        length: usize,
        /// The dimension.
        dimension: usize,
    },
    /// The drawing itself failed.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
}
